// What may be said of parts and of the whole: never more than the evidence carries.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/judge.h"

#include <cmath>

namespace spool {
namespace {

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

bool is_seen(const PartDeviation& deviation, const JudgeOptions& options) {
  return deviation.coverage >= options.min_coverage && deviation.points >= options.min_points;
}

// What was found, first of all; a guessed unit has its own place in the report.
std::string what_was_found(const std::vector<Finding>& findings) {
  std::string text;
  std::size_t more = 0;
  for (const Finding& finding : findings) {
    if (finding.kind == "scale") continue;
    if (text.empty())
      text = finding.text;
    else
      ++more;
  }
  if (more > 0)
    text += " (and " + std::to_string(more) + (more == 1 ? " more finding)" : " more findings)");
  return text.empty() ? text : text + " ";
}

// "3 of 9 dimensions are within tolerance, 1 is not ok, ..."
std::string dimensions_text(const std::vector<Dimension>& dimensions) {
  std::size_t ok = 0, wrong = 0, open = 0, unseen = 0;
  for (const Dimension& dimension : dimensions) {
    ok += dimension.status == Verdict::kOk ? 1U : 0U;
    wrong += dimension.status == Verdict::kNotOk ? 1U : 0U;
    open += dimension.status == Verdict::kSuspicious ? 1U : 0U;
    unseen += dimension.status == Verdict::kNotMeasured ? 1U : 0U;
  }
  if (dimensions.size() == unseen)
    return "No dimension of the drawing was measured, so no tolerance is judged";
  return "Of " + std::to_string(dimensions.size()) + " dimensions " + std::to_string(ok) +
         " are proved within tolerance and " + std::to_string(wrong) + " out of it, " +
         std::to_string(open) + " cannot be told, " + std::to_string(unseen) + " were not measured";
}

PartFinding judge_part(const PartDeviation& deviation, const JudgeOptions& options) {
  PartFinding finding;
  finding.deviation = deviation;
  if (deviation.points == 0) {
    finding.reason =
        "No scan point lies on this part: it was not seen, or it is not there. Scan it "
        "from where it shows.";
  } else if (!is_seen(deviation, options)) {
    finding.reason = "Only " + percent(deviation.coverage) + " of its surface was seen (" +
                     std::to_string(deviation.points) + " points); scan it from more sides.";
  } else {
    finding.status = Verdict::kSuspicious;
    finding.reason =
        "Seen (" + percent(deviation.coverage) +
        " of its surface), but no dimension of the drawing was measured at it; measure it "
        "by hand.";
  }
  return finding;
}

}  // namespace

std::vector<PartFinding> judge_parts(const DesignModel& design,
                                     const std::vector<PartDeviation>& deviations,
                                     const Alignment& alignment, const JudgeOptions& options) {
  std::vector<PartFinding> findings;
  for (std::size_t p = 0; p < design.parts.size(); ++p) {
    PartFinding finding;
    if (!alignment.found)
      finding.reason = "The design was not placed on the scan, so nothing is known of this part.";
    else
      finding = judge_part(p < deviations.size() ? deviations[p] : PartDeviation{}, options);
    finding.part = static_cast<int>(p);
    findings.push_back(std::move(finding));
  }
  return findings;
}

std::vector<Finding> collect_findings(const Alignment& alignment, const JudgeOptions& options) {
  std::vector<Finding> findings;
  if (!options.units_confirmed)
    findings.push_back({"scale", "",
                        "The unit of a file was guessed from its size; nothing is ok until it is "
                        "confirmed by giving the unit.",
                        "no unit was given"});
  if (alignment.found && alignment.ambiguous)
    findings.push_back(
        {"symmetry", "",
         std::to_string(alignment.alternatives.size()) +
             (alignment.alternatives.size() == 1 ? " more pose explains" : " more poses explain") +
             " the scan as well; pick three pairs to say which is meant.",
         "mean distances of the poses differ by less than a tenth"});
  return findings;
}

void judge_whole(Inspection& inspection, const JudgeOptions& options) {
  if (!inspection.alignment.found) {
    inspection.status = Verdict::kNotMeasured;
    inspection.status_reason = inspection.alignment.reason;
    return;
  }
  Verdict status = inspection.parts.empty() ? Verdict::kNotMeasured : Verdict::kOk;
  std::size_t seen = 0;
  for (const PartFinding& part : inspection.parts) {
    status = worse(status, part.status);
    seen += is_seen(part.deviation, options) ? 1U : 0U;
  }
  for (const Dimension& dimension : inspection.dimensions) status = worse(status, dimension.status);
  if (!options.units_confirmed || inspection.alignment.ambiguous)
    status = worse(status, Verdict::kSuspicious);
  inspection.status = status;
  inspection.status_reason = what_was_found(inspection.findings) +
                             dimensions_text(inspection.dimensions) + "; " + std::to_string(seen) +
                             " of " + std::to_string(inspection.parts.size()) +
                             " parts were seen well enough to compare" +
                             (options.single_frame ? ", in one frame of the sequence." : ".");
}

}  // namespace spool
