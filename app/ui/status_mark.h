// A status as the screen shows it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spool::ui {

// A status has its own outline and word; colour comes third.
enum class StatusMark { kOk, kSuspicious, kNotOk, kNotMeasured };

}  // namespace spool::ui
