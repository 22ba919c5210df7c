// Which parts of a design lie in one line.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/straight_runs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

namespace spool {
namespace {

constexpr double kParallel = 0.9986;  // cosine of three degrees
constexpr double kInLine = 0.01;      // of the design's size

struct Line {
  Eigen::Vector3d point, direction;  // m, design frame; unit
};

Line line_of(const DesignModel& design, int part, int port) {
  const Part& of = design.parts[static_cast<std::size_t>(part)];
  const Port& at = of.ports[static_cast<std::size_t>(port)];
  return {of.T_design_part * at.position, (of.T_design_part.linear() * at.direction).normalized()};
}

}  // namespace

StraightRuns straight_runs(const DesignModel& design) {
  std::vector<Line> lines;
  std::vector<std::vector<int>> ports_on(design.parts.size());  // of each part, by line
  const double in_line = kInLine * design.bounds().diagonal().norm();
  const auto add = [&](int part, int port) {
    const Line axis = line_of(design, part, port);
    const auto known = std::find_if(lines.begin(), lines.end(), [&](const Line& line) {
      return std::abs(axis.direction.dot(line.direction)) > kParallel &&
             (axis.point - line.point).cross(line.direction).norm() < in_line;
    });
    const auto line = static_cast<std::size_t>(known - lines.begin());
    if (line == lines.size()) lines.push_back(axis);
    auto& on = ports_on[static_cast<std::size_t>(part)];
    on.resize(std::max(on.size(), line + 1), 0);
    ++on[line];
  };
  for (const Joint& joint : design.joints) {
    add(joint.part_a, joint.port_a);
    add(joint.part_b, joint.port_b);
  }
  StraightRuns runs;
  runs.of_part.assign(design.parts.size(), -1);
  runs.at.resize(design.parts.size());
  std::vector<int> run_of_line(lines.size(), -1);
  for (std::size_t p = 0; p < design.parts.size(); ++p) {
    const std::vector<int>& on = ports_on[p];
    if (on.empty()) {
      runs.of_part[p] = runs.count++;
      runs.lines.emplace_back();
      continue;
    }
    const auto most = std::max_element(on.begin(), on.end());
    if (std::count(on.begin(), on.end(), *most) > 1) continue;  // an elbow
    const auto line = static_cast<std::size_t>(most - on.begin());
    int& run = run_of_line[line];
    if (run < 0) {
      run = runs.count++;
      runs.lines.push_back({lines[line].point.cast<float>(), lines[line].direction.cast<float>()});
    }
    runs.of_part[p] = run;
  }
  for (std::size_t p = 0; p < design.parts.size(); ++p)
    for (std::size_t line = 0; line < ports_on[p].size(); ++line)
      if (ports_on[p][line] > 0 && run_of_line[line] >= 0) runs.at[p].push_back(run_of_line[line]);
  return runs;
}

}  // namespace spool
