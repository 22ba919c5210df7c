// The datum: where the features put its place, its axis and the turn about it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/datum_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace spool {
namespace {

using Eigen::Vector3d;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// How well (m^2) a face with its leg's axis is known; infinity where it is not.
double doubt(int node, const Drawing& drawing, const PartFeatures& features,
             const FeatureGeometry& geometry) {
  const FeaturePoint point = geometry.point(node, drawing.nodes[at(node)].legs.front());
  if (!point.at) return std::numeric_limits<double>::infinity();
  const Propagated known =
      propagate([&](const FeatureState& state) -> Eigen::VectorXd { return point.at(state); },
                features, geometry.measured());
  return known.fit.trace();
}

// The measured face or centre that lies furthest off the datum's axis; -1: none does.
int furthest_off(int datum, const Drawing& drawing, const FeatureGeometry& geometry,
                 PointFunction& point) {
  const DrawingNode& from = drawing.nodes[at(datum)];
  const Vector3d axis = drawing.legs[at(from.legs.front())].direction;
  int best = -1;
  double most = 0.05;  // m; nearer to the axis nothing holds the turn
  for (std::size_t n = 0; n < drawing.nodes.size(); ++n) {
    const Vector3d off = drawing.nodes[n].point - from.point;
    const double aside = (off - off.dot(axis) * axis).norm();
    if (aside <= most) continue;
    for (const int leg : drawing.nodes[n].legs) {
      FeaturePoint there = geometry.point(static_cast<int>(n), leg);
      if (!there.at) continue;
      best = static_cast<int>(n);
      most = aside;
      point = std::move(there.at);
      break;
    }
  }
  return best;
}

}  // namespace

bool is_one_holed(double turn_rad, int count) {
  const double pitch = 2 * std::numbers::pi / count;
  return std::abs(std::remainder(turn_rad, pitch)) > (0.5 - kOneHoledWithin) * pitch;
}

DatumFrame datum_frame(const DesignModel& design, const Drawing& drawing,
                       const PartFeatures& features, const FeatureGeometry& geometry) {
  DatumFrame datum;
  const bool is_named = !design.datums.empty();
  double least = std::numeric_limits<double>::infinity();
  bool is_face_named = false;
  for (std::size_t n = 0; n < drawing.nodes.size(); ++n) {
    const DrawingNode& node = drawing.nodes[n];
    if (node.kind != NodeKind::kFace || node.legs.empty()) continue;
    if (is_named && std::ranges::find(design.datums, node.part) == design.datums.end()) continue;
    is_face_named = true;
    const double here = doubt(static_cast<int>(n), drawing, features, geometry);
    if (here >= least) continue;
    least = here;
    datum.node = static_cast<int>(n);
  }
  if (datum.node < 0) {
    datum.text = !is_face_named ? (is_named ? "The named datum is no flange with a face."
                                            : "The design has no flange to be the datum.")
                                : "The datum was not measured: its face or the pipe on it was "
                                  "not seen.";
    return datum;
  }
  const DrawingNode& node = drawing.nodes[at(datum.node)];
  const int leg = node.legs.front();
  const PointFunction place = geometry.point(datum.node, leg).at;
  const PointFunction axis = geometry.outward(datum.node, leg).at;
  PointFunction turn;
  datum.clocked_by = furthest_off(datum.node, drawing, geometry, turn);
  const Vector3d any = drawing.legs[at(leg)].direction.unitOrthogonal();
  const FrameFunction by_node = [place, axis, turn, any](const FeatureState& state) {
    Pose T = Pose::Identity();
    T.translation() = place(state);
    const Vector3d z = axis(state);
    const Vector3d aside = turn ? Vector3d(turn(state) - T.translation()) : any;
    const Vector3d x = (aside - aside.dot(z) * z).normalized();
    T.linear().col(0) = x;
    T.linear().col(1) = z.cross(x);
    T.linear().col(2) = z;
    return T;
  };
  if (turn) datum.T_design_by_node = by_node;
  datum.T_design_datum = by_node;
  datum.text = name_of(node, design) + " and the axis of the pipe on it";
  const std::string by =
      turn ? ", turned about it by " + name_of(drawing.nodes[at(datum.clocked_by)], design) : "";
  const int holes = features.holes_of(node.part);
  if (holes < 0) {
    datum.text += by;
    return datum;
  }
  const Part& part = design.parts[at(node.part)];
  const int count = part.holes->count;
  const auto off = turn_of_holes(holes, by_node, geometry.nominal());
  if (turn && is_one_holed(off(geometry.measured()), count)) {
    // Whether by half a pitch forth or back nobody knows.
    datum.text += by + ", as its bolt holes stand half a pitch off";
    return datum;
  }
  datum.holes = holes;
  datum.text += ", turned about it by its bolt holes";
  const double pitch = 2 * std::numbers::pi / count;
  const bool is_along = drawing.legs[at(leg)].from == datum.node;  // z is the leg's way
  const Vector3d z = is_along ? drawing.legs[at(leg)].direction : -drawing.legs[at(leg)].direction;
  // Turns are told about the part's own z.
  const double sense = part.T_design_part.linear().col(2).dot(z) < 0 ? -1 : 1;
  const bool is_known = static_cast<bool>(turn);
  datum.T_design_datum = [by_node, off, pitch, sense, is_known](const FeatureState& state) {
    // Which of the holes is the first the node tells; without one it does not matter.
    const double turned = is_known ? std::remainder(off(state), pitch) : off(state);
    return Pose(by_node(state) * Eigen::AngleAxisd(sense * turned, Vector3d::UnitZ()));
  };
  return datum;
}

}  // namespace spool
