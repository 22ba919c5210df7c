// Progress on stderr: a bar on a terminal, lines otherwise, nothing for what ends within a second.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/common/progress.h"

#include <algorithm>
#include <cstdio>

#include <unistd.h>

namespace spool {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds kBarInterval{200};  // five redraws a second
constexpr seconds kLineInterval{5};        // a log file should stay readable
constexpr int kBarCells = 24;

}  // namespace

Progress::Progress()
    : start_(std::chrono::steady_clock::now()),
      last_(start_),
      terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (terminal_ && shown_)
    std::fputs("\r\033[K", stderr);  // the bar goes, what was said before stays
}

void Progress::report(std::string_view stage, double fraction) {
  const auto now = std::chrono::steady_clock::now();
  if (now - start_ < seconds{1}) return;
  const bool new_stage = stage != stage_;
  const auto interval = terminal_ ? std::chrono::duration_cast<milliseconds>(kBarInterval)
                                  : std::chrono::duration_cast<milliseconds>(kLineInterval);
  if (shown_ && now - last_ < interval && !(new_stage && !terminal_)) return;
  stage_ = stage;
  last_ = now;
  shown_ = true;
  const double share = std::clamp(fraction, 0.0, 1.0);
  const int percent = static_cast<int>(100 * share);
  if (!terminal_) {
    std::fprintf(stderr, "%s: %d %%\n", stage_.c_str(), percent);
    return;
  }
  const int cells = static_cast<int>(kBarCells * share);
  const std::string bar(static_cast<std::size_t>(cells), '#');
  std::fprintf(stderr, "\r[%-*s] %3d %% %s\033[K", kBarCells, bar.c_str(), percent, stage_.c_str());
  std::fflush(stderr);
}

}  // namespace spool
