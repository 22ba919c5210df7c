// A job's journal as charts: tries and minutes by joint, and what each try measured.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/isometric/page_canvas.h"
#include "app/isometric/page_parts.h"
#include "app/job/job.h"
#include "app/job/job_progress.h"

namespace spool::isometric {

// One check of a joint.
struct Try {
  job::Outcome outcome = job::Outcome::kRedo;
  job::Phase phase = job::Phase::kAfterTack;
  bool by_override = false;
  // Of JointChart::number, over its tolerance; nothing where it was not measured.
  std::optional<double> deviation;
  double u = 0;  // expanded, k = 2
};

struct JointChart {
  std::string joint, part;    // "W5+W6", the part that the step adds
  job::JointHistory history;  // checks == 0: none yet
  std::vector<Try> tries;
  std::string number;  // the one that was furthest out in any try; "" none has a tolerance
};

struct JobCharts {
  TitleBlock title;
  std::vector<JointChart> joints;  // in the order of assembly, then those of another order
};

// A step's joint as the journal names it, and the part that the step adds.
struct StepName {
  std::string joint, part;
};
// Steps without a joint have no chart. Pure; any thread.
[[nodiscard]] std::vector<JointChart> joint_charts(const std::vector<StepName>& steps,
                                                   const std::vector<job::CheckRecord>& records);

// kBadInput: the journal is damaged and would be drawn as one with less in it.
[[nodiscard]] Result<JobCharts> charts_of(const job::Job& job);

// Tries and minutes, then what each try measured; as many pages as there are joints for. `charts`
// has to outlive them.
[[nodiscard]] Pages chart_pages(const JobCharts& charts);

}  // namespace spool::isometric
