// Lays out a spool part by part, as a fitter reads an isometric: pipe, elbow, tee, back to its
// branch.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "tools/campaign/assembly.h"

namespace spool::campaign {

// Each call adds a part to the open port and moves on to its far port. Rolls (rad) are about the
// direction of travel, right-handed, against the part before.
class SpoolRouter {
 public:
  SpoolRouter(std::string name, double nps);

  void start_with_flange();
  int pipe(double length_m);
  int elbow(double angle_deg, double roll_rad);
  int tee(double branch_nps, double roll_rad);  // travels on along the run
  int reducer(double nps2);
  int flange(double roll_rad = 0);  // nothing follows it
  int cap();
  void branch(int tee);  // goes on from the tee's branch

  // Where the next part would join, and the size there.
  [[nodiscard]] int part() const { return part_; }
  [[nodiscard]] int port() const { return port_; }
  [[nodiscard]] double nps() const { return nps_; }
  [[nodiscard]] const Assembly& assembly() const { return assembly_; }

 private:
  int add(PartSpec spec, int own_port, double roll_rad);

  Assembly assembly_;
  double nps_;
  int part_ = -1, port_ = 0;
  std::array<int, 8> count_ = {};
};

}  // namespace spool::campaign
