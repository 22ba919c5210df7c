// How long a design's pipe is sawn: from centre to centre less take-offs and root gaps.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/cut_length.h"

#include <algorithm>
#include <cmath>

namespace spool::guide {
namespace {

constexpr double kDrawnGap = 0.0005;  // m: ports this near are one place, drawn without a gap

// The two ends of a pipe: ports in line that lie furthest apart (olets on its side are ports too).
std::optional<std::array<int, 2>> pipe_ends(const Part& pipe) {
  std::optional<std::array<int, 2>> best;
  double furthest = 0;
  for (int p = 0; p < static_cast<int>(pipe.ports.size()); ++p) {
    const int q = opposite_port(pipe, p);
    if (q <= p) continue;
    const double length = (pipe.ports[static_cast<std::size_t>(q)].position -
                           pipe.ports[static_cast<std::size_t>(p)].position)
                              .norm();
    if (length <= furthest) continue;
    furthest = length;
    best = {p, q};
  }
  return best;
}

bool is_butt(EndType end) { return end == EndType::kButtWeld || end == EndType::kPlain; }

}  // namespace

std::string_view name(GapRule rule) {
  switch (rule) {
    case GapRule::kNone:
      return "none";
    case GapRule::kSubtract:
      return "subtract";
    case GapRule::kModelHasGaps:
      return "model-has-gaps";
  }
  return "none";
}

std::optional<GapRule> parse_gap_rule(std::string_view text) {
  for (const GapRule rule : {GapRule::kNone, GapRule::kSubtract, GapRule::kModelHasGaps}) {
    if (text == name(rule)) return rule;
  }
  return std::nullopt;
}

double take_off_m(const Part& part, int port) {
  if (part.kind == PartKind::kPipe) return 0;
  const Port& own = part.ports.at(static_cast<std::size_t>(port));
  double through = 0;
  for (const Port& other : part.ports) {
    const double cosine = own.direction.dot(other.direction);
    const Eigen::Vector3d between = other.position - own.position;
    if (std::abs(cosine) > 0.99) {
      through = std::max(through, std::abs(between.dot(own.direction)));
      continue;
    }
    // Where this port's axis passes nearest to the other's: a fitting's centre. Both axes are
    // lines from the port inward; the foot on ours solves the two normal equations.
    const Eigen::Vector3d inward = -own.direction, other_inward = -other.direction;
    const double s =
        (between.dot(inward) - cosine * between.dot(other_inward)) / (1 - cosine * cosine);
    return std::abs(s);
  }
  return through;
}

std::optional<CutLength> cut_length(const DesignModel& design,
                                    const std::vector<std::vector<JointEnd>>& ends, int part,
                                    const GapPolicy& policy) {
  const Part& pipe = design.parts.at(static_cast<std::size_t>(part));
  if (pipe.kind != PartKind::kPipe) return std::nullopt;
  const auto ports = pipe_ends(pipe);
  if (!ports) return std::nullopt;
  CutLength cut;
  cut.drawn_m =
      (place_of(pipe, (*ports)[0]).position - place_of(pipe, (*ports)[1]).position).norm();
  for (std::size_t e = 0; e < 2; ++e) {
    const int port = (*ports)[e];
    const auto joint = at_port(ends.at(static_cast<std::size_t>(part)), port);
    if (!joint) continue;
    const Part& other = design.parts[static_cast<std::size_t>(joint->neighbour)];
    const Port& other_port = other.ports[static_cast<std::size_t>(joint->neighbour_port)];
    cut.ends[e].neighbour = joint->neighbour;
    cut.ends[e].take_off_m = take_off_m(other, joint->neighbour_port);
    const double drawn_gap =
        (place_of(pipe, port).position - place_of(other, joint->neighbour_port).position).norm();
    const bool takes_gap = policy.rule == GapRule::kSubtract && drawn_gap <= kDrawnGap &&
                           is_butt(pipe.ports[static_cast<std::size_t>(port)].end) &&
                           is_butt(other_port.end);
    if (takes_gap)
      cut.ends[e].gap_m = other.kind == PartKind::kPipe ? policy.root_gap_m / 2 : policy.root_gap_m;
  }
  return cut;
}

}  // namespace spool::guide
