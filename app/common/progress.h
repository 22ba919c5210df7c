// Progress on stderr: a bar on a terminal, lines otherwise, nothing for what ends within a second.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace spool {

class Progress {
 public:
  Progress();
  ~Progress();
  // Any number of calls; printing is limited to a few a second. One thread.
  void report(std::string_view stage, double fraction);

 private:
  std::chrono::steady_clock::time_point start_, last_;
  std::string stage_;
  bool terminal_ = false;
  bool shown_ = false;
};

}  // namespace spool
