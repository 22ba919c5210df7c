// The results of a check in words and numbers ready to be shown.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/result_lines.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "app/evidence/joints_report.h"
#include "app/evidence/part_pose_report.h"
#include "vision/measure/conformance.h"
#include "vision/measure/dimension_text.h"
#include "vision/measure/joint_verdict.h"

namespace spool {

namespace {

using evidence::ResultKind;
using evidence::ResultRow;
using ui::ResultDetail;

constexpr const char* kByHand =
    "Check it by hand; what cannot be put right goes into a non-conformance report.";

// "F2/face" as it is said: "F2 face".
std::string said(std::string text) {
  std::ranges::replace(text, '/', ' ');
  std::ranges::replace(text, '_', ' ');
  return text;
}

bool is_length(const std::string& kind) { return kind.find("_to_") != std::string::npos; }

std::string name_of(const Dimension& dimension) {
  return dimension_title(dimension.kind, dimension.name);
}

// Which way it is off; empty where the sign has no such word or the doubt is larger.
std::string way_of(const Dimension& dimension) {
  if (!dimension.is_measured || std::abs(dimension.deviation) <= 2 * dimension.u.total()) return "";
  const bool more = dimension.deviation > 0;
  if (is_length(dimension.kind)) return more ? "too long" : "too short";
  if (dimension.kind == "angle") return more ? "too wide" : "too narrow";
  return "";
}

// "turn E2 …" of the joint to blame, where the dimension goes across it or the joint is it.
std::vector<std::string> bump_texts(const DesignModel& design, const ChainResult& chain,
                                    LengthStyle style) {
  std::vector<std::string> texts;
  for (const Bump& bump : chain.bumps) texts.push_back(evidence::bump_text(design, bump, style));
  return texts;
}

std::vector<std::string> to_do(const DesignModel& design, const Inspection& inspection,
                               const Dimension& dimension, LengthStyle style) {
  switch (dimension.status) {
    case Verdict::kOk:
      return {"Nothing: it is proved within its limit."};
    case Verdict::kNotMeasured:
      return {dimension.reason};
    case Verdict::kSuspicious:
      // Else the reason says what keeps it from being ok.
      if (dimension.tolerance > 0 && dimension.probability < kProvedRight)
        return {advice_on(dimension)};
      return {dimension.reason};
    case Verdict::kNotOk:
      break;
  }
  for (const JointError& joint : inspection.chain.joints)
    if (joint.is_to_blame && goes_across(dimension, joint))
      if (auto bumps = bump_texts(design, inspection.chain, style); !bumps.empty()) return bumps;
  return {kByHand};
}

ResultDetail detail_of(const DesignModel& design, const Inspection& inspection,
                       const Dimension& dimension, LengthStyle style) {
  const auto text = [&](double value, bool with_sign = false) {
    return with_minus(quantity_text(value, dimension.is_angle, style, with_sign));
  };
  ResultDetail out;
  out.name = name_of(dimension);
  out.to_do = to_do(design, inspection, dimension, style);
  out.facts.emplace_back("Drawing", text(dimension.nominal));
  const std::string limit = dimension.tolerance > 0 ? "± " + text(dimension.tolerance) : "";
  if (dimension.is_measured) {
    const bool is_signed = dimension.kind != "face_alignment";
    const std::string u = "± " + text(2 * dimension.u.total());
    out.number = text(dimension.deviation, is_signed);
    out.doubt = u + (limit.empty() ? "" : ", limit " + limit);
    if (const std::string way = way_of(dimension); !way.empty()) out.doubt += ", " + way;
    out.facts.emplace_back("Measured", text(dimension.measured));
    out.facts.emplace_back("Off by", out.number + " " + u + " (k = 2)");
  }
  out.facts.emplace_back("Limit", limit.empty() ? "none" : limit);
  out.facts.emplace_back("Rule", dimension.rule);
  if (dimension.is_measured && dimension.tolerance > 0)
    out.facts.emplace_back("Within the limit", chance_text(dimension.probability));
  // A measurement far coarser than the limit makes every probability small and proves nothing.
  if (dimension.status == Verdict::kSuspicious && dimension.tolerance > 0 &&
      dimension.probability <= kProvedWrong)
    out.words = "Measured too coarsely to prove it out.";
  if (dimension.is_one_holed) out.words = "Half a pitch off: its holes look one-holed.";
  return out;
}

ResultDetail detail_of(const DesignModel& design, const Inspection& inspection,
                       const JointError& joint, Verdict status, LengthStyle style) {
  ResultDetail out;
  out.name = "Joint " + joint.weld + ", " + said(joint.near_port) + " to " + said(joint.far_port);
  out.words = evidence::joint_text(joint, style);
  if (!joint.is_measured) {
    out.words.clear();
    out.to_do = {joint.reason + "."};
    return out;
  }
  // Of a length of three components along its own way, to first order.
  const auto doubt_along = [&](int first) {
    const Eigen::Vector3d error = joint.error.segment<3>(first);
    const Eigen::Matrix3d covariance = joint.covariance.block<3, 3>(first, first);
    // Of none, the largest there could be.
    if (!(error.norm() > 0)) return std::sqrt(covariance.trace());
    const Eigen::Vector3d way = error.normalized();
    return std::sqrt(way.dot(covariance * way));
  };
  const auto angle = [&](double rad) { return quantity_text(rad, true, style); };
  out.number = length_text(joint.error.head<3>().norm(), style);
  const std::string u = "± " + length_text(2 * doubt_along(0), style);
  const std::string turn = angle(joint.error.tail<3>().norm()) + " ± " + angle(2 * doubt_along(3));
  out.doubt = u + ", and " + turn;
  out.facts.emplace_back("Aside", out.number + " " + u + " (k = 2)");
  out.facts.emplace_back("Turned or tilted", turn + " (k = 2)");
  out.facts.emplace_back("Against its limits",
                         fmt::format("{:.0f} %", 100 * joint.against_tolerance));
  for (const UnobservedMotion& motion : joint.unobserved)
    out.facts.emplace_back("Not observed", motion.text);
  if (joint.is_to_blame) out.to_do = bump_texts(design, inspection.chain, style);
  if (!out.to_do.empty()) return out;
  const auto blamed = std::ranges::find_if(inspection.chain.joints, &JointError::is_to_blame);
  if (status == Verdict::kOk)
    out.to_do = {"Nothing: what goes across it is proved within its limits."};
  else if (!joint.is_significant)
    out.to_do = {
        "Leave it: what it is off by may be chance. Scan it from nearer and from more sides."};
  else if (blamed != inspection.chain.joints.end() && &*blamed != &joint)
    out.to_do = {"Put joint " + blamed->weld + " right first, then check again."};
  else
    out.to_do = {kByHand};
  return out;
}

ResultDetail detail_of(const FitUp& fit_up, LengthStyle style) {
  ResultDetail out;
  out.name = "Fit-up " + fit_up.weld + ", " + fit_up.a + " to " + fit_up.b;
  if (fit_up.is_measured) {
    out.number = length_text(fit_up.hi_lo_m, style);
    out.doubt = "± " + length_text(2 * fit_up.u_m, style) + " hi-lo";
    out.facts.emplace_back("Hi-lo",
                           out.number + " ± " + length_text(2 * fit_up.u_m, style) + " (k = 2)");
    out.facts.emplace_back("Axes aside", length_text(fit_up.offset_m, style));
    out.facts.emplace_back("Step of radius",
                           with_minus(signed_length_text(fit_up.radius_step_m, style)));
    out.to_do = {"Hold it against what the weld procedure allows."};
  } else {
    out.to_do = {fit_up.reason};
  }
  if (!fit_up.root_gap.empty()) out.to_do.push_back(fit_up.root_gap);
  return out;
}

// What to do about a finding, by its kind.
std::string to_do(std::string_view kind) {
  if (kind == "missing") return "Fit it, or scan its place from where nothing hides it.";
  if (kind == "unexpected") return "Take it off, or ask whether the drawing is the newest.";
  if (kind == "wrong_size")
    return "Check size and cut length against the drawing before it is welded.";
  if (kind == "one_holed") return "Turn the flange by half a pitch of its holes.";
  if (kind == "scale") return "Calibrate the sensor, or check it against a length that is known.";
  if (kind == "symmetry") return "Align again, by three picked points.";
  return "Put it where the drawing has it, then check again.";
}

ResultDetail detail_of(const Finding& finding) {
  ResultDetail out;
  out.name = (finding.part.empty() ? "" : finding.part + ": ") + said(finding.kind);
  out.words = finding.text;
  out.to_do = {to_do(finding.kind)};
  if (!finding.evidence.empty()) out.facts.emplace_back("Seen by", finding.evidence);
  return out;
}

// Why a part has its status. What a dimension told is said as that dimension is, in `style`.
std::string reason_of(const DesignModel& design, const Inspection& inspection,
                      const PartFinding& part, LengthStyle style) {
  const auto telling = std::ranges::find(inspection.dimensions, part.reason, told_by);
  if (part.reason.empty() || telling == inspection.dimensions.end()) return part.reason;
  const ResultDetail detail = detail_of(design, inspection, *telling, style);
  const std::string number =
      detail.number.empty() ? telling->reason : detail.number + " " + detail.doubt + ".";
  return detail.name + ": " + number;
}

ResultDetail detail_of(const DesignModel& design, const Inspection& inspection,
                       const PartFinding& part, LengthStyle style) {
  ResultDetail out;
  const Part& of = design.parts[static_cast<std::size_t>(part.part)];
  out.name = of.name + ", " + std::string(name(of.kind));
  out.words = reason_of(design, inspection, part, style) + evidence::pose_words(part.pose, style);
  for (const SizeCheck& check : part.size_checks)
    out.facts.emplace_back(
        check.quantity == "outside_diameter" ? "Outside diameter" : said(check.quantity),
        length_text(check.measured_m, style) + " ± " + length_text(2 * check.u_m, style) +
            ", drawing " + length_text(check.nominal_m, style));
  out.facts.emplace_back("Surface seen", percent_text(part.deviation.coverage));
  if (part.deviation.points > 0)
    out.facts.emplace_back(
        "Surface, on the whole",
        with_minus(signed_length_text(part.deviation.mean_m, style)) + ", no verdict");
  if (part.status == Verdict::kOk)
    out.to_do = {"Nothing: all that was to be measured is within its limits."};
  if (part.status == Verdict::kNotOk) out.to_do = {kByHand};
  return out;
}

ResultDetail detail_of(const DesignModel& design, const Inspection& inspection,
                       const ResultRow& row, LengthStyle style) {
  switch (row.kind) {
    case ResultKind::kFinding:
      return detail_of(inspection.findings[row.index]);
    case ResultKind::kDimension:
      return detail_of(design, inspection, inspection.dimensions[row.index], style);
    case ResultKind::kJoint:
      return detail_of(design, inspection, inspection.chain.joints[row.index], row.status, style);
    case ResultKind::kFitUp:
      return detail_of(inspection.chain.fit_ups[row.index], style);
    case ResultKind::kPart:
      break;
  }
  return detail_of(design, inspection, inspection.parts[row.index], style);
}

}  // namespace

ui::StatusMark mark_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kOk:
      return ui::StatusMark::kOk;
    case Verdict::kSuspicious:
      return ui::StatusMark::kSuspicious;
    case Verdict::kNotOk:
      return ui::StatusMark::kNotOk;
    case Verdict::kNotMeasured:
      break;
  }
  return ui::StatusMark::kNotMeasured;
}

ResultDetail result_detail(const DesignModel& design, const Inspection& inspection,
                           const ResultRow& row, LengthStyle style) {
  ResultDetail out = detail_of(design, inspection, row, style);
  out.status = mark_of(row.status);
  return out;
}

ui::ResultLine result_line(const DesignModel& design, const Inspection& inspection,
                           const ResultRow& row, LengthStyle style) {
  const ResultDetail detail = result_detail(design, inspection, row, style);
  ui::ResultLine line{detail.status, detail.name, detail.number};
  if (!detail.doubt.empty()) line.number += " " + detail.doubt;
  if (line.number.empty()) line.number = detail.words;
  if (line.number.empty() && !detail.to_do.empty()) line.number = detail.to_do.front();
  return line;
}

std::string dimension_title(const std::string& kind, const std::string& name) {
  if (is_length(kind)) return said(name);
  if (kind == "face_alignment") return "Alignment of face, " + said(name);
  if (kind == "rotation") return "Rotation of holes, " + said(name);
  if (kind == "offset") return "Offset, " + said(name);
  if (kind == "angle") return "Angle, " + said(name);
  return said(kind) + ", " + said(name);
}

std::string with_minus(std::string text) {
  if (text.starts_with("-") && text.size() > 1) text.replace(0, 1, "−");
  return text;
}

std::string chance_text(double probability) {
  if (probability >= kProvedRight) return "more than 19 in 20";
  if (probability <= kProvedWrong) return "less than 1 in 20";
  return fmt::format("about {} in 10", std::clamp<long>(std::lround(10 * probability), 1, 9));
}

std::string age_text(double seconds) {
  if (seconds < 2) return "just now";
  if (seconds < 60) return fmt::format("{:.0f} s ago", std::floor(seconds));
  if (seconds < 3600) return fmt::format("{:.0f} min ago", std::floor(seconds / 60));
  return fmt::format("{:.0f} h ago", std::floor(seconds / 3600));
}

}  // namespace spool
