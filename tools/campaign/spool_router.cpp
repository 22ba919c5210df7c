// Lays out a spool part by part, as a fitter reads an isometric: pipe, elbow, tee, back to its
// branch.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/spool_router.h"

#include <numbers>
#include <utility>

namespace spool::campaign {
SpoolRouter::SpoolRouter(std::string name, double nps)
    : assembly_{std::move(name), {}}, nps_(nps) {}

int SpoolRouter::add(PartSpec spec, int own_port, double roll_rad) {
  const int number = ++count_[static_cast<std::size_t>(spec.kind)];
  spec.name = word(spec.kind) + std::string("_") + std::to_string(number);
  spec.nps = nps_;
  part_ = part_ < 0 ? assembly_.place(spec, Pose::Identity())
                    : assembly_.join(spec, part_, port_, own_port, roll_rad);
  port_ = 1;
  return part_;
}

void SpoolRouter::start_with_flange() { add({.kind = PartKind::kFlange}, 0, 0); }

int SpoolRouter::pipe(double length_m) {
  return add({.kind = PartKind::kPipe, .length_m = length_m}, 0, 0);
}

int SpoolRouter::elbow(double angle_deg, double roll_rad) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return add({.kind = PartKind::kElbow, .angle_rad = angle}, 0, roll_rad);
}

int SpoolRouter::tee(double branch_nps, double roll_rad) {
  return add({.kind = PartKind::kTee, .nps2 = branch_nps}, 0, roll_rad);
}

int SpoolRouter::reducer(double nps2) {
  const int part = add({.kind = PartKind::kReducer, .nps2 = nps2}, 0, 0);
  nps_ = nps2;
  return part;
}

int SpoolRouter::flange(double roll_rad) { return add({.kind = PartKind::kFlange}, 1, roll_rad); }

int SpoolRouter::cap() { return add({.kind = PartKind::kCap}, 0, 0); }

void SpoolRouter::branch(int tee) {
  part_ = tee;
  port_ = 2;
  nps_ = assembly_.members[static_cast<std::size_t>(tee)].spec.nps2;
}

}  // namespace spool::campaign
