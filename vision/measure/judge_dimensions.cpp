// What the dimensions and sizes that were measured say of the parts.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/judge_dimensions.h"

#include <algorithm>
#include <cmath>

#include "vision/measure/conformance.h"
#include "vision/measure/dimension_text.h"
#include "vision/measure/part_shapes.h"

namespace spool {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool lies_in(int part, const Dimension& dimension) {
  return std::ranges::find(dimension.parts, part) != dimension.parts.end();
}

void judge_part(const DesignModel& design, const std::vector<Dimension>& dimensions,
                PartFinding& finding, std::vector<Finding>& findings) {
  const std::string& name = design.parts[at(finding.part)].name;
  for (const SizeCheck& check : finding.size_checks) {
    if (check.status != Verdict::kNotOk) continue;
    finding.status = Verdict::kNotOk;
    finding.reason = name + " is of another size: " + check.reason;
    findings.push_back({"wrong_size", name, finding.reason, "cylinder fitted to its points"});
  }
  for (const Dimension& dimension : dimensions) {
    if (dimension.answers != finding.part || dimension.status != Verdict::kNotOk) continue;
    const std::string text = told_by(dimension);
    findings.push_back(
        {dimension.is_one_holed ? "one_holed" : "misplaced", name, text, dimension.rule});
    if (finding.status != Verdict::kNotOk) finding.reason = text;
    finding.status = Verdict::kNotOk;
  }
  const bool is_open = finding.status == Verdict::kSuspicious;  // seen, and nothing said yet
  if (!is_open) return;
  std::size_t count = 0;
  Verdict worst = Verdict::kOk;
  std::string reason;
  const auto take = [&](Verdict status, const std::string& why) {
    ++count;
    if (status == Verdict::kOk || worse(worst, status) == worst) return;
    worst = status;
    reason = why;
  };
  for (const Dimension& dimension : dimensions) {
    if (!lies_in(finding.part, dimension)) continue;
    const bool is_anothers = dimension.status == Verdict::kNotOk;
    take(is_anothers ? Verdict::kSuspicious : dimension.status, told_by(dimension));
  }
  if (count == 0) return;
  for (const SizeCheck& check : finding.size_checks) take(check.status, check.reason);
  finding.status = worst;
  finding.reason = worst == Verdict::kOk
                       ? "All that the drawing says of it was measured and is within tolerance."
                       : reason;
}

}  // namespace

void check_sizes(const DesignModel& design, const PartFeatures& features,
                 const std::string& nothing_ok, std::vector<PartFinding>& parts) {
  for (const PartFeature& feature : features.features) {
    if (feature.kind != FeatureKind::kAxis || !(feature.radius_m > 0)) continue;
    const auto shape = pipe_shape(design, feature.part);
    if (!shape) continue;
    SizeCheck check{.quantity = "outside_diameter",
                    .nominal_m = 2 * shape->radius_m,
                    .measured_m = 2 * feature.radius_m,
                    .u_m = 2 * feature.radius_u_m};
    const double tolerance = size_tolerance_m(shape->radius_m);
    check.status = decide(conformance_of(check.measured_m - check.nominal_m, check.u_m, tolerance));
    if (check.status == Verdict::kOk && !nothing_ok.empty()) {
      check.status = Verdict::kSuspicious;
      check.reason = nothing_ok;
    } else if (check.status != Verdict::kOk) {
      check.reason = "its outside diameter was measured as " +
                     std::to_string(std::lround(1000 * check.measured_m)) + " mm ± " +
                     std::to_string(std::lround(2000 * check.u_m)) + " mm, the drawing's is " +
                     std::to_string(std::lround(1000 * check.nominal_m)) + " mm.";
    }
    parts[at(feature.part)].size_checks.push_back(std::move(check));
  }
}

void judge_dimensions(const DesignModel& design, const std::vector<Dimension>& dimensions,
                      std::vector<PartFinding>& parts, std::vector<Finding>& findings) {
  for (PartFinding& part : parts) judge_part(design, dimensions, part, findings);
}

}  // namespace spool
