// A job as text for people: its steps, what was accepted, tries, time and shrinkage.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/job/job.h"

namespace spool::tools {

[[nodiscard]] std::string job_text(const job::Job& job);

}  // namespace spool::tools
