// How a flange's bolt holes are turned against the drawing, seen from the datum.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace spool {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
// Cosine of an axis to a leg. Beyond 80 degrees a roll about the leg turns the flange by less than
// a sixth of it.
constexpr double kAcross = 0.17;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool holds(const std::vector<int>& parts, int part) {
  return std::ranges::find(parts, part) != parts.end();
}

// Whether a leg between, but the flange's own, runs as the flange's axis does.
bool may_be_rolled(const Drawing& drawing, const std::vector<int>& between, int part,
                   const Eigen::Vector3d& axis) {
  return std::ranges::any_of(drawing.legs, [&](const DrawingLeg& leg) {
    return !holds(leg.parts, part) && std::abs(leg.direction.dot(axis)) > kAcross &&
           std::ranges::any_of(leg.pipes, [&](int pipe) { return holds(between, pipe); });
  });
}

}  // namespace

HolesRotation rotation_of_holes(const DesignModel& design, const Drawing& drawing,
                                const PartFeatures& features, const DatumFrame& datum,
                                const FeatureState& measured, std::span<const JointBranch> tree,
                                int index) {
  const Part& part = design.parts[at(index)];
  const int datum_part = datum.node >= 0 ? drawing.nodes[at(datum.node)].part : -1;
  const int feature = features.holes_of(index);
  HolesRotation result;
  result.parts = {index};
  result.nominal_rad = part.holes->clocking_rad;
  result.from = part.name + "/axis";
  if (feature < 0) {
    result.why_not = features.why_no_holes.empty() || features.why_no_holes[at(index)].empty()
                         ? "nobody looked for its bolt holes"
                         : features.why_no_holes[at(index)];
    return result;
  }
  if (datum.node < 0) {
    result.why_not = "there is no datum to measure it from";
    return result;
  }
  const bool is_its_own = index == datum_part;
  result.is_datum = is_its_own && datum.clocked_by < 0;
  if (result.is_datum) return result;
  if (!datum.is_clocked()) {
    result.why_not = "nothing that was measured holds the turn about the datum's axis";
    return result;
  }
  const bool by_holes = datum.holes >= 0 && !is_its_own;
  result.from = by_holes ? design.parts[at(datum_part)].name + "/holes"
                         : name_of(drawing.nodes[at(datum.clocked_by)], design);
  // Of 4 holes seen from 8 holes nobody knows whether they stand off by a pitch of the 8.
  const int count = by_holes && datum.clocked_by < 0
                        ? std::lcm(part.holes->count, design.parts[at(datum_part)].holes->count)
                        : part.holes->count;
  const FeatureState nominal = [&] {
    FeatureState state;
    for (const PartFeature& each : features.features) state.push_back(each.T_design_nominal);
    return state;
  }();
  const auto turn =
      turn_of_holes(feature, is_its_own ? datum.T_design_by_node : datum.T_design_datum, nominal);
  const double raw = turn(measured);
  const double least = std::remainder(raw, kTurn / count);
  result.is_one_holed = count == part.holes->count && is_one_holed(least, count);
  const double drawn = result.nominal_rad;
  result.at = [turn, raw, least, drawn](const FeatureState& state) {
    return drawn + least + std::remainder(turn(state) - raw, kTurn);
  };
  result.answers = index;
  if (is_its_own || result.is_one_holed) return result;
  const auto between = parts_between(tree, datum_part, index);
  if (may_be_rolled(drawing, between, index, part.T_design_part.linear().col(2))) {
    result.answers = -1;
    result.parts = between;
  }
  return result;
}

}  // namespace spool
