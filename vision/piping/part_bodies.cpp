// Bodies of components by kind: tubes, bends, reducers, caps, branches, rods.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/part_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "vision/piping/branch_solid.h"
#include "vision/piping/catalogue.h"
#include "vision/piping/flange_solid.h"
#include "vision/piping/joint_graph.h"
#include "vision/piping/size_checks.h"

namespace spool::piping {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kNoLength = 1e-5;  // m
constexpr double kSlipClearance =
    0.0016;  // m over the pipe's diameter, of slip-on and socket bores
constexpr double kDegree = std::numbers::pi / 180;

double outer_radius(const PipePoint& point) { return point.outside_diameter / 2; }

// Wall by schedule; a twelfth of the diameter where the catalogue does not hold it.
double inner_radius(const Component& component, const PipePoint& point) {
  const Result<double> wall = wall_thickness(point.nps, component.schedule);
  const double thickness = wall ? *wall : point.outside_diameter / 12;
  return std::max(outer_radius(point) - thickness, 0.1 * outer_radius(point));
}

Station station(const Isometry3d& frame, double outer, double inner) {
  return {frame, outer, inner};
}

Isometry3d at_z(double z) {
  Isometry3d frame = Isometry3d::Identity();
  frame.translation().z() = z;
  return frame;
}

bool has_two_ends(const Component& component) {
  return component.ends.size() == 2 && component.ends[0].outside_diameter > 0 &&
         component.ends[1].outside_diameter > 0;
}

// S-shaped from 0 to 1 over the middle half, as reducers are drawn in.
double blend(double share) {
  const double middle = std::clamp((share - 0.25) / 0.5, 0.0, 1.0);
  return (1 - std::cos(std::numbers::pi * middle)) / 2;
}

// Where a bend's stations lie: the straight piece, the arc of radius R by `angle`, the other
// straight piece. Inlet at the origin heading +z, turning towards +x.
std::vector<Isometry3d> bend_frames(double leg1, double leg2, double angle, double radius,
                                    double outside) {
  const double tangent = radius * std::tan(angle / 2);
  std::vector<Isometry3d> frames;
  const auto add = [&](double turn, const Vector3d& place) {
    Isometry3d frame = Isometry3d::Identity();
    frame.linear() = Eigen::AngleAxisd(turn, Vector3d::UnitY()).toRotationMatrix();
    frame.translation() = place;
    frames.push_back(frame);
  };
  const double start = leg1 - tangent;
  if (start > kNoLength) add(0, Vector3d::Zero());
  const double step = 2 * std::acos(1 - kChordError / (radius + outside));
  const int steps = std::max(4, static_cast<int>(std::ceil(angle / step)));
  for (int i = 0; i <= steps; ++i) {
    const double t = angle * i / steps;
    add(t, {radius * (1 - std::cos(t)), 0, std::max(start, 0.0) + radius * std::sin(t)});
  }
  const double rest = leg2 - tangent;
  const Isometry3d last = frames.back();
  if (rest > kNoLength) add(angle, last * Vector3d(0, 0, rest));
  return frames;
}

}  // namespace

Isometry3d frame_at(const Vector3d& origin, const Vector3d& z,
                    const std::optional<Vector3d>& x_hint) {
  Vector3d x = x_hint.value_or(Vector3d::UnitZ());
  x -= x.dot(z) * z;
  // A hint is meant also where it is nearly the axis, as of a bend by one degree; up is not.
  if (x.norm() < (x_hint ? 1e-6 : 0.03)) {
    x = Vector3d::UnitY() - z.y() * z;
    if (x.norm() < 0.03) x = Vector3d::UnitZ() - z.z() * z;
  }
  x.normalize();
  Isometry3d frame = Isometry3d::Identity();
  frame.linear().col(0) = x;
  frame.linear().col(1) = z.cross(x);
  frame.linear().col(2) = z;
  frame.translation() = origin;
  return frame;
}

bool make_straight(const Component& component, PartShape& shape) {
  if (!has_two_ends(component)) return false;
  const Vector3d along = component.ends[1].position - component.ends[0].position;
  if (along.norm() < kNoLength) return false;
  shape.T_file_part = frame_at(component.ends[0].position, along.normalized());
  add_tube(shape.solid, std::array{station(at_z(0), outer_radius(component.ends[0]),
                                           inner_radius(component, component.ends[0])),
                                   station(at_z(along.norm()), outer_radius(component.ends[1]),
                                           inner_radius(component, component.ends[1]))});
  return true;
}

bool make_elbow(const Component& component, PartShape& shape) {
  if (!has_two_ends(component) || !component.centre) return false;
  const double angle = bend_angle(component);
  const Vector3d in = component.centre->position - component.ends[0].position;
  const Vector3d out = component.ends[1].position - component.centre->position;
  if (in.norm() < kNoLength || out.norm() < kNoLength) return false;
  if (angle < 0.2 * kDegree || angle > 175 * kDegree) return false;
  // The arc that closes the take-off, unless a smaller radius with straight tangents is given.
  const double closing = std::min(in.norm(), out.norm()) / std::tan(angle / 2);
  const double radius =
      component.bend_radius > 0 ? std::min(component.bend_radius, closing) : closing;
  const double widest = std::max(outer_radius(component.ends[0]), outer_radius(component.ends[1]));
  if (radius < 1.02 * widest) return false;  // would cut into itself: a mitre
  shape.T_file_part =
      frame_at(component.ends[0].position, in.normalized(), Vector3d(out.normalized()));
  const auto frames = bend_frames(in.norm(), out.norm(), angle, radius, widest);
  std::vector<Station> stations;
  const auto steps = static_cast<double>(frames.size() - 1);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double share = static_cast<double>(i) / steps;
    const auto between = [&](double a, double b) { return a + share * (b - a); };
    stations.push_back(station(
        frames[i], between(outer_radius(component.ends[0]), outer_radius(component.ends[1])),
        between(inner_radius(component, component.ends[0]),
                inner_radius(component, component.ends[1]))));
  }
  add_tube(shape.solid, stations);
  return true;
}

bool make_reducer(const Component& component, PartShape& shape) {
  if (!has_two_ends(component) || component.directions.size() < 2) return false;
  const Vector3d along = component.ends[1].position - component.ends[0].position;
  const Vector3d axis = component.directions[1];
  const double length = along.dot(axis);
  if (length < kNoLength) return false;
  const Vector3d aside = along - length * axis;
  shape.T_file_part = frame_at(component.ends[0].position, axis);
  const Vector3d shift = shape.T_file_part.linear().transpose() * aside;
  std::vector<Station> stations;
  constexpr int kSteps = 16;
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const double drawn_in = blend(share);
    const auto between = [&](double a, double b) { return a + drawn_in * (b - a); };
    Isometry3d frame = at_z(share * length);
    frame.translation() += drawn_in * shift;
    stations.push_back(
        station(frame, between(outer_radius(component.ends[0]), outer_radius(component.ends[1])),
                between(inner_radius(component, component.ends[0]),
                        inner_radius(component, component.ends[1]))));
  }
  add_tube(shape.solid, stations);
  return true;
}

bool make_cap(const Component& component, int weld_port, PartShape& shape) {
  const auto port = static_cast<std::size_t>(weld_port);
  if (port >= component.ends.size() || component.directions[port].norm() < 0.5) return false;
  const PipePoint& weld = component.ends[port];
  const double radius = outer_radius(weld);
  const double inner = inner_radius(component, weld);
  if (!(radius > 0)) return false;
  double length = radius;
  if (const Result<FittingSize> size = fitting_size(weld.nps)) length = size->cap;
  if (component.ends.size() == 2)
    length = (component.ends[0].position - component.ends[1].position).norm();
  const double wall = radius - inner;
  if (length < wall + kNoLength) return false;
  shape.T_file_part = frame_at(weld.position, -component.directions[port]);
  // A 2:1 ellipsoid on a skirt (B16.9, 2.1: semi-ellipsoidal heads); the wall is the same all over.
  const double depth = std::min(radius / 2, length);
  const double skirt = length - depth;
  const double inner_depth = depth - wall;
  if (inner_depth < kNoLength) return false;
  std::vector<Eigen::Vector2d> chain;
  constexpr int kSteps = 24;
  for (int i = 0; i <= kSteps; ++i) {  // the inside, from the pole to the rim
    const double t = std::numbers::pi / 2 * (kSteps - i) / kSteps;
    chain.emplace_back(i == 0 ? 0.0 : inner * std::cos(t), skirt + inner_depth * std::sin(t));
  }
  if (skirt > kNoLength) chain.emplace_back(inner, 0);
  if (skirt > kNoLength) chain.emplace_back(radius, 0);
  for (int i = 0; i <= kSteps; ++i) {
    const double t = std::numbers::pi / 2 * i / kSteps;
    chain.emplace_back(i == kSteps ? 0.0 : radius * std::cos(t), skirt + depth * std::sin(t));
  }
  add_revolved(shape.solid, chain);
  return true;
}

bool make_gasket(const Component& component, PartShape& shape) {
  if (!has_two_ends(component)) return false;
  const Vector3d along = component.ends[1].position - component.ends[0].position;
  if (along.norm() < kNoLength) return false;
  const double inner = outer_radius(component.ends[0]);
  const Result<FlangeSize> size = flange_size(component.ends[0].nps, 150);
  const double outer = size ? size->raised_face / 2 : 1.4 * inner;
  shape.T_file_part = frame_at(component.ends[0].position, along.normalized());
  add_tube(shape.solid,
           std::array{station(at_z(0), outer, inner), station(at_z(along.norm()), outer, inner)});
  return true;
}

bool make_flange(const Component& component, PartShape& shape) {
  const auto face = static_cast<std::size_t>(std::max(component.face, 0));
  if (face >= component.ends.size() || component.directions[face].norm() < 0.5) return false;
  const PipePoint& neck = component.ends[component.ends.size() - 1 - face];
  const double nps = std::max(component.ends[face].nps, neck.nps);
  const Result<FlangeSize> size = flange_size(nps, std::atoi(component.rating.c_str()));
  if (!size) return false;
  const double drawn = (component.ends[face].position - neck.position).norm();
  const double pipe = neck.outside_diameter;
  FlangeBody body;
  if (component.kind == ComponentKind::kBlind) {
    body.length = size->thickness;
  } else if (component.form == FlangeForm::kWeldNeck) {
    body.length = drawn > size->thickness ? drawn : size->weld_neck;
    body.hub_end = std::min(pipe, 0.98 * size->hub);
    body.bore = 2 * std::min(inner_radius(component, neck), 0.45 * body.hub_end);
  } else {
    body.length = size->slip_on;
    body.hub_end = size->hub;
    body.bore = pipe + (component.form == FlangeForm::kLoose ? 2 : 1) * kSlipClearance;
    body.has_raised_face = component.form != FlangeForm::kLoose;
  }
  if (component.form == FlangeForm::kSocketWeld && component.kind == ComponentKind::kFlange) {
    body.counterbore = body.bore;
    body.counterbore_depth = 2 * body.length / 3;  // B16.5, table 8: 0.63 to 0.74 of the length
    body.bore = 2 * inner_radius(component, neck);
  }
  if (body.bore >= size->raised_face || body.bore >= size->hub) return false;
  shape.T_file_part = frame_at(component.ends[face].position, component.directions[face]);
  add_flange(shape.solid, *size, body);
  shape.holes = PartHoles{size->holes, size->bolt_circle, std::numbers::pi / size->holes};
  return true;
}

bool make_stub_end(const Component& component, PartShape& shape) {
  if (!has_two_ends(component) || component.face < 0) return false;
  const auto face = static_cast<std::size_t>(component.face);
  const PipePoint& weld = component.ends[1 - face];
  const double length = (weld.position - component.ends[face].position).norm();
  const double outer = outer_radius(weld);
  const double inner = inner_radius(component, weld);
  const double lap = outer - inner;  // the lap is as thick as the wall (B16.9)
  const Result<FlangeSize> size = flange_size(weld.nps, 150);
  if (!size || length < 2 * lap || component.directions[face].norm() < 0.5) return false;
  shape.T_file_part = frame_at(weld.position, component.directions[face]);
  const double collar = size->raised_face / 2;
  add_tube(
      shape.solid,
      std::array{station(at_z(0), outer, inner), station(at_z(length - lap), outer, inner),
                 station(at_z(length - lap), collar, inner), station(at_z(length), collar, inner)});
  return true;
}

bool make_branched(const Component& component, PartShape& shape) {
  if (!has_two_ends(component) || !component.centre || component.branches.empty() ||
      component.branches.size() > 2)
    return false;
  const Vector3d centre = component.centre->position;
  const Vector3d z = component.directions[1];
  if (z.norm() < 0.5 || component.directions[0].dot(z) > -std::cos(kDegree)) return false;
  const PipePoint& end = component.ends[0];
  if (std::abs(end.outside_diameter - component.ends[1].outside_diameter) > 1e-4) return false;
  const Vector3d x = component.directions[2];
  if (x.norm() < 0.5) return false;
  const Isometry3d frame = frame_at(centre, z, x);
  std::vector<Outlet> outlets;
  const double run_inner = inner_radius(component, end);
  for (std::size_t b = 0; b < component.branches.size(); ++b) {
    const PipePoint& branch = component.branches[b];
    const Vector3d local = frame.linear().transpose() * component.directions[2 + b];
    // Both branches lie in one plane with the run, on its two sides.
    if (std::abs(local.y()) > std::sin(kDegree) || (local.x() > 0) != (b == 0)) return false;
    outlets.push_back({std::min(outer_radius(branch), outer_radius(end)),
                       std::min(inner_radius(component, branch), run_inner),
                       (branch.position - centre).norm(),
                       std::acos(std::clamp(local.z(), -1.0, 1.0)), b == 1});
  }
  const double down = (component.ends[0].position - centre).norm();
  const double up = (component.ends[1].position - centre).norm();
  shape.T_file_part = frame;
  return add_branched_run(shape.solid, {outer_radius(end), run_inner, down, up}, outlets);
}

bool make_olet(const Component& component, double run_diameter, const Vector3d& run_axis,
               PartShape& shape) {
  if (!component.centre || component.branches.empty()) return false;
  const PipePoint& branch = component.branches[0];
  const Vector3d out = branch.position - component.centre->position;
  const double run = run_diameter / 2;
  if (!(run > 0) || out.norm() < run + kNoLength || !(outer_radius(branch) > 0)) return false;
  const Vector3d d = out.normalized();
  shape.T_file_part = frame_at(component.centre->position, run_axis, d);
  const std::string end = end_type(component, static_cast<int>(component.ends.size()));
  const double thick = end == "SW" || end == "SC" ? 1.3 : 1.0;  // B16.11: a socket round the pipe
  const Outlet outlet{thick * outer_radius(branch), inner_radius(component, branch), out.norm(),
                      std::acos(std::clamp(d.dot(run_axis), -1.0, 1.0)), false};
  // An olet has a foot; a pipe set on its run has none.
  const bool has_foot = component.keyword == "OLET" || component.keyword == "ELBOLET";
  const double foot =
      std::clamp(1.4 * outlet.outer, outlet.outer, std::max(0.95 * run, outlet.outer));
  const double base = has_foot ? foot : outlet.outer;
  return add_saddle_branch(shape.solid, run, base, outlet);
}

bool make_rods(const Component& component, PartShape& shape) {
  const int count = port_count(component);
  if (count == 0) return false;
  Vector3d middle = Vector3d::Zero();
  for (int p = 0; p < count; ++p) middle += port_of(component, p).position / count;
  if (component.centre) middle = component.centre->position;
  const bool is_straight = count == 2 && has_two_ends(component) &&
                           (!component.centre || component.directions[0].dot(
                                                     component.directions[1]) < -std::cos(kDegree));
  if (is_straight) {
    const Vector3d along = component.ends[1].position - component.ends[0].position;
    const double length = along.norm();
    if (length < kNoLength) return false;
    shape.T_file_part = frame_at(component.ends[0].position, along / length);
    double radius[2];
    double disc[2];
    for (std::size_t p = 0; p < 2; ++p) {
      const Result<FlangeSize> size =
          flange_size(component.ends[p].nps, std::max(std::atoi(component.rating.c_str()), 150));
      const bool is_flanged = end_type(component, static_cast<int>(p)) == "FL" && size;
      radius[p] = is_flanged ? size->outside_diameter / 2 : outer_radius(component.ends[p]);
      disc[p] = is_flanged ? std::min(size->thickness, length / 4) : length / 4;
    }
    const double body = std::min(outer_radius(component.ends[0]), outer_radius(component.ends[1]));
    add_revolved(shape.solid, std::array<Eigen::Vector2d, 8>{Eigen::Vector2d{0, 0},
                                                             {radius[0], 0},
                                                             {radius[0], disc[0]},
                                                             {body, disc[0]},
                                                             {body, length - disc[1]},
                                                             {radius[1], length - disc[1]},
                                                             {radius[1], length},
                                                             {0, length}});
    return true;
  }
  shape.T_file_part = frame_at(middle, Vector3d::UnitZ());
  for (int p = 0; p < count; ++p) {
    const PipePoint& port = port_of(component, p);
    const Vector3d to = shape.T_file_part.inverse() * port.position;
    if (to.norm() < kNoLength || !(port.outside_diameter > 0)) continue;
    const Isometry3d from = frame_at(Vector3d::Zero(), to.normalized());
    Isometry3d end = from;
    end.translation() = to;
    add_tube(shape.solid,
             std::array{station(from, outer_radius(port), 0), station(end, outer_radius(port), 0)});
  }
  return !shape.solid.triangles.empty();
}

}  // namespace spool::piping
