// A design of two boxes and a scan of it, made by hand: enough to run the programs without any
// data beside.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace spool::test {

// An L of two bars, 0.5 and 0.3 m long, 0.1 m thick, scanned from all sides with 1 mm of noise and
// moved by a known pose, among a floor's points.
struct SmallScene {
  // design.obj, scan.ply (metres, ascii), pose.json (true) and pairs.json (each off by 5 mm).
  void write(const std::filesystem::path& folder) const;
  double noise_m = 0.001;
};

}  // namespace spool::test
