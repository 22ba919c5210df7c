// What the charts of a job show, read off its journal.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/job_charts.h"

#include <algorithm>
#include <cmath>

namespace spool::isometric {
namespace {

// Deviation and tolerance of a number in one check; nothing where one of them is missing.
std::optional<double> over_tolerance(const job::CheckNumber& number) {
  if (!number.deviation || !number.tolerance || !(*number.tolerance > 0)) return std::nullopt;
  return *number.deviation / *number.tolerance;
}

std::string furthest_out(const std::vector<const job::CheckRecord*>& checks) {
  std::string name;
  double most = -1;
  for (const job::CheckRecord* check : checks)
    for (const job::CheckNumber& each : check->numbers) {
      const auto share = over_tolerance(each);
      if (!share || !(std::abs(*share) > most)) continue;
      most = std::abs(*share);
      name = each.name;
    }
  return name;
}

JointChart chart_of(const StepName& step, const std::vector<job::CheckRecord>& records,
                    const std::vector<job::JointHistory>& histories) {
  JointChart chart;
  chart.joint = step.joint;
  chart.part = step.part;
  for (const job::JointHistory& each : histories)
    if (each.joint == step.joint) chart.history = each;
  const auto checks = job::joint_checks(step.joint, records);
  chart.number = furthest_out(checks);
  for (const job::CheckRecord* check : checks) {
    Try made{check->outcome, check->phase, !check->override_reason.empty(), std::nullopt, 0};
    for (const job::CheckNumber& each : check->numbers) {
      if (each.name != chart.number) continue;
      made.deviation = over_tolerance(each);
      if (made.deviation) made.u = 2 * each.u.value_or(0) / *each.tolerance;
    }
    chart.tries.push_back(made);
  }
  return chart;
}

}  // namespace

std::vector<JointChart> joint_charts(const std::vector<StepName>& steps,
                                     const std::vector<job::CheckRecord>& records) {
  const std::vector<job::JointHistory> histories = job::joint_histories(records);
  std::vector<StepName> all = steps;
  for (const job::JointHistory& each : histories) {
    // Made when the order was another one: what it took is part of the record.
    const bool is_known = std::any_of(
        steps.begin(), steps.end(), [&](const StepName& step) { return step.joint == each.joint; });
    if (!is_known) all.push_back({each.joint, each.part});
  }
  std::vector<JointChart> charts;
  for (const StepName& step : all)
    if (!step.joint.empty()) charts.push_back(chart_of(step, records, histories));
  return charts;
}

Result<JobCharts> charts_of(const job::Job& job) {
  if (!job.damage().empty())
    return Error{ErrorCode::kBadInput, job.folder().string() + ": the journal is damaged (" +
                                           job.damage() + "); salvage it first"};
  std::vector<StepName> steps;
  for (int s = 0; s < static_cast<int>(job.steps().size()); ++s)
    steps.push_back({job.joint_text(s), job.file().order[static_cast<std::size_t>(s)]});
  JobCharts charts;
  charts.joints = joint_charts(steps, job.records());
  const DesignModel& design = job.design();
  charts.title = {.line = design.line,
                  .revision = design.revision,
                  .spool = job.file().spool.empty() ? design.spool : job.file().spool,
                  .date = "",
                  .content = "",
                  .lengths = "shares of the tolerance",
                  .source = job.file().design,
                  .source_sha256 = job.file().design_sha256};
  // The day of the last check: no clock is read, so that equal journals are equal pages.
  if (!job.records().empty())
    charts.title.date = job::utc_text(job.records().back().at.wall_s).substr(0, 10);
  return charts;
}

}  // namespace spool::isometric
