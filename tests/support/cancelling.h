// Ends a computation from another thread while it runs, and says how soon it obeyed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "vision/core/cancel.h"

namespace spool::test {

// What Watch promises, s. A sanitizer makes everything take several times as long, and the thread
// sanitizer's loops are serial.
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
inline constexpr double kObeyed_s = 1.0;
#else
inline constexpr double kObeyed_s = 0.1;
#endif

// Seconds here are processor time of the calling thread, so that a busy machine changes nothing.
[[nodiscard]] double seconds_of(const std::function<void()>& work);

// Runs `work` on this thread, tells it to stop when it has taken `after_s`, and gives the seconds
// that it went on from then; nothing where it had ended before.
[[nodiscard]] std::optional<double> seconds_until_obeyed(
    double after_s, const std::function<void(const Watch&)>& work);

}  // namespace spool::test
