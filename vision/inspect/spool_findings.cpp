// What is wrong with the spool as a whole: parts elsewhere, of the wrong length, missing.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/spool_findings.h"

#include <cmath>
#include <numbers>

namespace spool {
namespace {

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

std::string what_sticks_out(const DesignModel& design, const Unexpected& it) {
  return "Something that the design does not have sticks out of " +
         design.parts[static_cast<std::size_t>(it.part)].name + " by " +
         rounded(1000 * it.reach_m) + " mm.";
}

std::string what_is_missing(const DesignModel& design, const MissingPart& it) {
  return design.parts[static_cast<std::size_t>(it.part)].name +
         (it.is_seen_through
              ? " is missing: the camera saw what lies behind its place."
              : " does not show although what it is joined to does: it is missing, or something "
                "hides it.");
}

}  // namespace

std::vector<Finding> spool_findings(const DesignModel& design, const std::vector<Piece>& pieces,
                                    const std::vector<Unexpected>& unexpected,
                                    const std::vector<MissingPart>& missing,
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
  for (const Unexpected& it : unexpected)
    findings.push_back({"unexpected", design.parts[static_cast<std::size_t>(it.part)].name,
                        what_sticks_out(design, it),
                        std::to_string(it.points.size()) +
                            " scan points are joined to it, and to nothing that stands"});
  for (const MissingPart& it : missing) {
    const auto p = static_cast<std::size_t>(it.part);
    if (is_elsewhere[p] != 0) continue;
    findings.push_back({"missing", design.parts[p].name, what_is_missing(design, it),
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

void judge_missing(const DesignModel& design, const std::vector<MissingPart>& missing,
                   std::vector<PartFinding>& parts) {
  for (const MissingPart& it : missing) {
    PartFinding& finding = parts[static_cast<std::size_t>(it.part)];
    if (finding.status != Verdict::kNotMeasured) continue;
    if (it.is_seen_through) finding.status = Verdict::kSuspicious;
    finding.reason = what_is_missing(design, it);
  }
}

void judge_unexpected(const DesignModel& design, const std::vector<Unexpected>& unexpected,
                      std::vector<PartFinding>& parts) {
  for (const Unexpected& it : unexpected) {
    PartFinding& finding = parts[static_cast<std::size_t>(it.part)];
    if (finding.status == Verdict::kNotOk) continue;
    finding.status = Verdict::kSuspicious;
    finding.reason = what_sticks_out(design, it);
  }
}

}  // namespace spool
