// Iterative closest point: gates that close level by level, steps in the held motions only.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/icp.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "vision/align/icp_matcher.h"

namespace spool {
namespace {

constexpr double kMostMargin = 0.001;        // m
constexpr std::size_t kCoarsePoints = 8000;  // while the gate is open, as many say as much as all

// The standard deviation (m) of the residuals that belong to the surface: 1.4826 times the median
// of their sizes, after what lies evenly over the gate is taken off. How much that is, the outer
// half of the gate says. A third of the gate where nothing stands out in its middle.
double residual_scale(std::span<const Correspondence> matches, double gate) {
  constexpr std::size_t kBins = 128;
  std::array<double, kBins> bins{};
  for (const Correspondence& m : matches) {
    if (m.weight <= 0) continue;
    const double share = std::abs(double{m.residual}) / gate;
    bins[std::min(kBins - 1, static_cast<std::size_t>(share * kBins))] += 1;
  }
  const auto middle = bins.begin() + kBins / 2;
  const double inner = std::accumulate(bins.begin(), middle, 0.0);
  const double outer = std::accumulate(middle, bins.end(), 0.0);
  const double own = inner - outer;
  if (own < 0.1 * inner + 6) return gate / 3;
  double sum = 0;
  for (std::size_t i = 0; i < kBins / 2; ++i) {
    const double more = bins[i] - 2 * outer / kBins;
    if (sum + more >= own / 2) {
      const double within = more > 0 ? (own / 2 - sum) / more : 0.0;
      return 1.4826 * gate * (static_cast<double>(i) + within) / kBins;
    }
    sum += more;
  }
  return gate / 3;
}

void trim(std::vector<Correspondence>& matches, double fraction) {
  if (fraction <= 0) return;
  std::vector<float> sizes;
  for (const Correspondence& m : matches)
    if (m.weight > 0) sizes.push_back(std::abs(m.residual));
  const auto drop = static_cast<std::size_t>(fraction * static_cast<double>(sizes.size()));
  if (drop == 0) return;
  const auto first = sizes.end() - static_cast<std::ptrdiff_t>(drop);
  std::nth_element(sizes.begin(), first, sizes.end());
  for (Correspondence& m : matches)
    if (std::abs(m.residual) >= *first) m.weight = 0;
}

// Tukey's biweight: weight (1 - (r/c)^2)^2, nothing beyond c.
void weigh(std::vector<Correspondence>& matches, double width) {
  const auto c2 = static_cast<float>(width * width);
  for (Correspondence& m : matches) {
    if (m.weight <= 0) continue;
    const float q = m.residual * m.residual / c2;
    m.weight = q < 1 ? (1 - q) * (1 - q) : 0.0F;
  }
}

// The variance that belongs to unit weight in the information: Huber's sandwich E[psi^2] /
// E[psi']^2 for the biweight, times the mean weight that the information already holds.
double residual_variance(std::span<const Correspondence> matches, double width) {
  double n = 0, psi2 = 0, slope = 0, weight = 0;
  for (const Correspondence& m : matches) {
    if (m.weight <= 0) continue;
    const double r = m.residual;
    const double q = r * r / (width * width);
    n += 1;
    weight += m.weight;
    psi2 += r * r * double{m.weight} * double{m.weight};
    slope += (1 - q) * (1 - 5 * q);
  }
  if (n <= 6) return width * width;
  // A slope near zero: residuals spread evenly over the gate, so nothing but the gate bounds them.
  slope = std::max(slope / n, 0.05);
  return std::max(1e-14, psi2 / (n - 6) / (slope * slope) * (weight / n));
}

// Root mean square displacement (m) that the step gives the correspondences.
double displacement(const NormalEquations& equations, const Vector6d& step) {
  return std::sqrt(std::max(0.0, step.dot(equations.mass * step)));
}

// Mean squared displacement (m^2) of a box's points by a small motion told at its middle.
Matrix6d mass_of(const Eigen::AlignedBox3d& box) {
  Matrix6d mass = Matrix6d::Identity();
  const Eigen::Vector3d half2 = (0.5 * box.sizes()).cwiseAbs2();
  mass.bottomRightCorner<3, 3>() =
      ((Eigen::Vector3d::Constant(half2.sum()) - half2) / 3).asDiagonal();
  return mass;
}

// The step and what has to be done with it so that along the weak motions the design as a whole
// stays as near the guess as the held ones let it. By the matched points alone the guess would not
// be kept: of a pipe seen from one side they stay where they are if it is shifted and rolled.
Vector6d keeping_guess(const Vector6d& step, const Pose& T_guess, const Pose& T,
                       const NormalEquations& equations, const HeldMotions& motions,
                       const Eigen::AlignedBox3d& bounds) {
  Eigen::MatrixXd weak(6, 6);
  Eigen::Index count = 0;
  for (int i = 0; i < 6; ++i)
    if (motions.weak[static_cast<std::size_t>(i)]) weak.col(count++) = motions.directions.col(i);
  if (count == 0) return step;
  weak.conservativeResize(Eigen::NoChange, count);
  const Pose since = moved_about(equations.centre, step, T) * T_guess.inverse();
  Vector6d moved;
  moved << since * equations.centre - equations.centre, rotation_vector(since.linear());
  const Matrix6d at_middle = motion_told_at(bounds.center() - equations.centre);
  const Matrix6d mass = at_middle.transpose() * mass_of(bounds) * at_middle;
  const Eigen::MatrixXd told = weak.transpose() * mass;
  return step - weak * (told * weak).ldlt().solve(told * moved);
}

// How far (m) the next step may move the points, of which the last one moved them by `last_step_m`.
// More than a millimetre is not worth remembering for: too much surface lies round a point.
double margin_for(double last_step_m) {
  if (last_step_m > 2 * kMostMargin) return 0;
  return std::clamp(last_step_m, 0.2 * kMostMargin, kMostMargin);
}

void summarise(const NormalEquations& equations, const HeldMotions& motions,
               const std::vector<Correspondence>& matches, double gate, IcpResult& result) {
  double sum = 0;
  for (const Correspondence& m : matches) {
    if (m.weight <= 0) continue;
    result.correspondences += 1;
    sum += double{m.residual} * double{m.residual};
  }
  if (result.correspondences == 0) return;
  result.rms_m = std::sqrt(sum / static_cast<double>(result.correspondences));
  const double variance = residual_variance(matches, gate);
  result.information = information_at_origin(equations);
  result.covariance = motion_covariance(equations, motions, variance);
  result.weak_directions = describe_weak(equations, motions, variance);
}

}  // namespace

std::optional<Error> validate(const IcpOptions& options) {
  const bool good = options.max_iterations >= 0 && options.start_distance_m > 0 &&
                    options.noise_m > 0 && options.max_normal_angle_rad > 0 &&
                    options.trim_fraction >= 0 && options.trim_fraction < 1 &&
                    options.stop_translation_m > 0 && options.stop_rotation_rad > 0;
  if (good) return std::nullopt;
  return Error{
      ErrorCode::kUsage,
      "The refinement needs distances, noise and stops above zero and a trimmed share from 0 "
      "to below 1."};
}

IcpResult refine_icp(const CloudView& scan, const DesignSurface& surface, const Pose& T_guess,
                     const IcpOptions& options, const Watch& watch) {
  assert(!validate(options) && "options as validate() accepts them");
  IcpResult result;
  result.T_design_scan = T_guess;
  Pose& T = result.T_design_scan;
  const double least_gate = 3 * options.noise_m;
  bool last = options.max_iterations == 0 || options.start_distance_m <= least_gate;
  double gate = last ? least_gate : options.start_distance_m;
  // Twice the gate: until the pose has moved by a gate, nothing further can come into it.
  double reach = 2 * gate;
  Pose T_near = T;
  Indices near = near_points(scan, surface, T, static_cast<float>(reach), watch);

  const Eigen::AlignedBox3d& bounds = surface.bounds();
  Matcher matcher(scan, surface, options);
  const auto choose = [&](bool all) {
    matcher.choose(all ? near : strewn(near, kCoarsePoints), !all);
  };
  choose(last);
  std::vector<Correspondence> matches;
  NormalEquations equations;
  HeldMotions motions;
  int at_level = 0;
  double margin = last ? kMostMargin : 0;
  while (!watch.cancelled()) {
    matcher.match(T, gate, margin, watch, matches);
    if (watch.cancelled()) break;
    const double settled_gate =
        last ? gate : std::max(least_gate, 3 * residual_scale(matches, gate));
    trim(matches, options.trim_fraction);
    weigh(matches, gate);
    equations = build_normal_equations(matches);
    motions = held_motions(equations, matches);
    if (result.iterations >= options.max_iterations || equations.weight < 6) break;
    const Vector6d step =
        keeping_guess(solve_held(equations, motions), T_guess, T, equations, motions, bounds);
    T = moved_about(equations.centre, step, T);
    margin = margin_for(displacement(equations, step));
    ++result.iterations;
    ++at_level;
    watch.report("align", static_cast<double>(result.iterations) / options.max_iterations);

    if (last && step.head<3>().norm() < options.stop_translation_m &&
        step.tail<3>().norm() < options.stop_rotation_rad) {
      result.converged = true;
      break;
    }
    // Settled at this gate: close it to where the residuals' own scale wants it, in bounded steps.
    if (!last && (displacement(equations, step) < 0.05 * gate || at_level >= 8)) {
      last = settled_gate > 0.7 * gate;
      gate = std::max(least_gate,
                      last ? std::min(gate, settled_gate) : std::max(settled_gate, 0.5 * gate));
      last = last || gate <= least_gate;
      at_level = 0;
      if (last) choose(true);
    }
    const Pose since = T * T_near.inverse();
    const double moved_m =
        (since * equations.centre - equations.centre).norm() +
        pose_size(since).rotation_rad * std::sqrt(equations.mass.bottomRightCorner<3, 3>().trace());
    if (moved_m > reach - gate) {
      reach = last ? 4 * gate : 2 * gate;
      T_near = T;
      near = near_points(scan, surface, T, static_cast<float>(reach), watch);
      choose(last);
    }
  }
  if (!last && !watch.cancelled()) {
    // Out of iterations with the gate open: the figures still have to be those of the last gate.
    gate = std::max(least_gate, std::min(gate, 3 * residual_scale(matches, gate)));
    choose(true);
    matcher.match(T, gate, 0, watch, matches);
    weigh(matches, gate);
    equations = build_normal_equations(matches);
    motions = held_motions(equations, matches);
  }
  summarise(equations, motions, matches, gate, result);
  std::size_t finite = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) finite += scan.points[i].allFinite() ? 1U : 0U;
  result.overlap =
      finite == 0 ? 0 : static_cast<double>(result.correspondences) / static_cast<double>(finite);
  return result;
}

}  // namespace spool
