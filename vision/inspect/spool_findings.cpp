// What is wrong with the spool as a whole: parts elsewhere, of the wrong length, missing.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/spool_findings.h"

#include <cmath>
#include <numbers>

namespace spool {
namespace {

// Missing is said where a part shows (next to) nothing and what it is joined to shows well.
constexpr double kNothing = 0.03;
constexpr double kWell = 0.35;

std::string joint_name(const DesignModel& design, int joint) {
  const Joint& it = design.joints[static_cast<std::size_t>(joint)];
  const std::string parts = design.parts[static_cast<std::size_t>(it.part_a)].name + " and " +
                            design.parts[static_cast<std::size_t>(it.part_b)].name;
  return it.weld.empty() ? "the joint of " + parts : it.weld + " between " + parts;
}

std::string rounded(double value) { return std::to_string(std::lround(value)); }

std::string what_is_wrong(const DesignModel& design, const Piece& piece) {
  const std::string& name = design.parts[static_cast<std::size_t>(piece.part)].name;
  const std::string at = joint_name(design, piece.joint);
  switch (piece.fault) {
    case PieceFault::kTurned:
      return name + " is turned by " + rounded(piece.amount * 180 / std::numbers::pi) +
             " degrees at " + at + ".";
    case PieceFault::kTooLong:
      return name + " ends " + rounded(1000 * piece.amount) + " mm too far out at " + at + ".";
    case PieceFault::kTooShort:
      return name + " ends " + rounded(-1000 * piece.amount) + " mm short at " + at + ".";
    case PieceFault::kExchanged:
      return name + " is joined where another part belongs, and not at " + at + ".";
  }
  return name + " is elsewhere.";
}

// The parts that a part is joined to show well, and there are some.
bool is_seen_all_round(const DesignModel& design, int part, const std::vector<PartFinding>& parts) {
  bool has_neighbour = false;
  for (const Joint& joint : design.joints) {
    if (joint.part_a != part && joint.part_b != part) continue;
    const int other = joint.part_a == part ? joint.part_b : joint.part_a;
    has_neighbour = true;
    if (parts[static_cast<std::size_t>(other)].deviation.coverage < kWell) return false;
  }
  return has_neighbour;
}

}  // namespace

std::vector<Finding> spool_findings(const DesignModel& design, const std::vector<Piece>& pieces,
                                    const std::vector<PartFinding>& parts) {
  std::vector<Finding> findings;
  std::vector<std::uint8_t> is_elsewhere(design.parts.size(), 0);
  for (const Piece& piece : pieces) {
    for (const int part : piece.parts) is_elsewhere[static_cast<std::size_t>(part)] = 1;
    const bool is_length =
        piece.fault == PieceFault::kTooLong || piece.fault == PieceFault::kTooShort;
    findings.push_back({is_length ? "wrong_size" : "misplaced",
                        design.parts[static_cast<std::size_t>(piece.part)].name,
                        what_is_wrong(design, piece),
                        std::to_string(piece.points.size()) +
                            " scan points lie on the design moved so, and not where it has them"});
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (is_elsewhere[p] != 0 || parts[p].deviation.coverage > kNothing ||
        !is_seen_all_round(design, static_cast<int>(p), parts))
      continue;
    findings.push_back({"missing", design.parts[p].name,
                        design.parts[p].name +
                            " does not show although what it is joined to does: it is missing, or "
                            "something hides it.",
                        std::to_string(parts[p].deviation.points) + " scan points lie on it"});
  }
  return findings;
}

void judge_pieces(const DesignModel& design, const std::vector<Piece>& pieces,
                  std::vector<PartFinding>& parts) {
  for (const Piece& piece : pieces) {
    const std::string text = what_is_wrong(design, piece);
    for (const int part : piece.parts) {
      PartFinding& finding = parts[static_cast<std::size_t>(part)];
      if (part == piece.part || finding.status == Verdict::kNotOk) continue;
      finding.status = Verdict::kSuspicious;
      finding.reason = "It is not where the design has it: " + text;
    }
    PartFinding& named = parts[static_cast<std::size_t>(piece.part)];
    named.status = Verdict::kNotOk;
    named.reason = text;
  }
}

}  // namespace spool
