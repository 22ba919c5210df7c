// The lists of a cut sheet: pipes to saw, material, welds.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/spool_lists.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vision/piping/catalogue.h"

namespace spool::guide {
namespace {

std::string size_of(double nps) { return nps > 0 ? piping::nps_text(nps) : std::string(); }

std::string sizes_of(const Part& part) {
  if (part.nps2 <= 0 || part.nps2 == part.nps) return size_of(part.nps);
  return size_of(part.nps) + " x " + size_of(part.nps2);
}

std::string text_of(const Part& part) {
  std::string text(name(part.kind));
  if (part.kind == PartKind::kElbow && part.ports.size() == 2) {
    const double cosine = -part.ports[0].direction.dot(part.ports[1].direction);
    const double turn = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    text += " " + std::to_string(std::lround(turn)) + "\u00b0";
  }
  if (!part.rating.empty()) text += " class " + part.rating;
  return text;
}

}  // namespace

std::vector<CutRow> cut_rows(const DesignModel& design, const GapPolicy& policy) {
  std::vector<CutRow> rows;
  const std::vector<std::vector<JointEnd>> ends = joint_ends(design);
  for (int p = 0; p < static_cast<int>(design.parts.size()); ++p) {
    const auto cut = cut_length(design, ends, p, policy);
    if (!cut) continue;
    const Part& part = design.parts[static_cast<std::size_t>(p)];
    rows.push_back({part.name, size_of(part.nps), part.schedule, part.heat, cut->cut_m(),
                    cut->centre_to_centre_m(), cut->ends[0].take_off_m + cut->ends[1].take_off_m,
                    cut->ends[0].gap_m + cut->ends[1].gap_m});
  }
  return rows;
}

std::vector<MaterialRow> material_rows(const DesignModel& design, const GapPolicy& policy) {
  std::vector<MaterialRow> rows;
  const std::vector<std::vector<JointEnd>> ends = joint_ends(design);
  for (int p = 0; p < static_cast<int>(design.parts.size()); ++p) {
    const Part& part = design.parts[static_cast<std::size_t>(p)];
    const std::string text = text_of(part), nps = sizes_of(part);
    auto row = std::find_if(rows.begin(), rows.end(), [&](const MaterialRow& each) {
      return each.text == text && each.nps == nps && each.schedule == part.schedule;
    });
    if (row == rows.end()) row = rows.insert(row, {text, nps, part.schedule, 0, 0});
    ++row->pieces;
    if (const auto cut = cut_length(design, ends, p, policy)) row->length_m += cut->cut_m();
  }
  return rows;
}

std::vector<WeldRow> weld_rows(const DesignModel& design, const RollPlan& plan) {
  std::vector<WeldRow> rows;
  const auto part_at = [&](int part) -> const Part& {
    return design.parts[static_cast<std::size_t>(part)];
  };
  for (int j = 0; j < static_cast<int>(design.joints.size()); ++j) {
    const Joint& joint = design.joints[static_cast<std::size_t>(j)];
    const auto turn = std::find_if(plan.order.begin(), plan.order.end(),
                                   [&](const RollWeld& each) { return each.joint == j; });
    if (turn == plan.order.end()) continue;
    const Part &a = part_at(joint.part_a), &b = part_at(joint.part_b);
    const double port_nps = b.ports[static_cast<std::size_t>(joint.port_b)].nps;
    rows.push_back({joint.weld, joint.type, size_of(port_nps > 0 ? port_nps : b.nps),
                    a.schedule.empty() ? b.schedule : a.schedule, a.name + ", " + b.name, a.heat,
                    b.heat, turn->can_roll, turn->why_not,
                    static_cast<int>(turn - plan.order.begin()) + 1});
  }
  return rows;
}

}  // namespace spool::guide
