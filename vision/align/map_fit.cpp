// Fits a frame to the scan map from a guess, and says by the statistics of the fit what it is
// worth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/map_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

namespace spool {
namespace {

constexpr int kFineWidth = 160, kCoarseWidth = 40;  // px across the picture

// From a bad guess coarsely, then the fine view with all samples. Gates in m.
struct Round {
  bool coarse;
  int times;
  MatchReach reach;
};
constexpr std::array<Round, 3> kFar = {
    {{true, 4, {3, 0.12F, 6}}, {true, 4, {2, 0.06F, 6}}, {false, 3, {2, 0.03F, 3}}}};
constexpr std::array<Round, 2> kNear = {{{false, 3, {2, 0.02F, 3}}, {false, 2, {1, 0.01F, 1}}}};
constexpr Round kLast = {false, 3, {1, 0.0F, 1}};

void run(const Round& round, const FrameSamples& frame, const MapViews& views, Pose& T) {
  const MapView& view = round.coarse ? views.coarse : views.fine;
  for (int i = 0; i < round.times; ++i) {
    const auto matches = match_to_view(frame, view, T, round.reach);
    const NormalEquations equations = build_normal_equations(matches);
    if (equations.weight <= 0) return;
    const Vector6d step = solve_held(equations, held_motions(equations, matches));
    T = moved_about(view.T_map_view().translation() + equations.centre, step, T);
    const double moved = std::sqrt(std::max(0.0, step.dot(equations.mass * step)));
    if (moved < 2e-5) return;  // m: a hundredth of the noise
  }
}

// What the fit is worth: who agrees with it, and of which motions. `held` columns are motions about
// `centre` (m, about the view's eye) that the matches hold.
void judge(const FrameSamples& frame, const MapView& view, const Eigen::MatrixXd& held,
           const Eigen::Vector3d& centre, MapFit& fit) {
  Vouching vouching = vouch_for(frame, view, fit.T_map_camera);
  fit.agrees = vouching.agrees;
  fit.contradicts = vouching.contradicts;
  fit.in_front = vouching.in_front;
  fit.shares = std::move(vouching.shares);
  // A wrong pose has surfaces behind the expected ones as often as before them; a hand or a hook is
  // before them only. So what is in front counts for no more than what is behind.
  const double front = (1.0 + static_cast<double>(vouching.contradicts)) /
                       (1.0 + static_cast<double>(vouching.in_front));
  for (std::size_t i = 0; i < vouching.matches.size(); ++i)
    if (vouching.says[i] == Vouch::kInFront)
      vouching.matches[i].weight = static_cast<float>(std::min(1.0, front));
  const NormalEquations all = build_normal_equations(vouching.matches);
  fit.share = fit.share_low = fit.share_high = 0;
  if (all.weight < 12 || fit.agrees < 6 || held.cols() == 0) return;
  // The information of those that agree, about the same centre. Of how much of any motion's
  // information that is, the generalised eigenvalues say; the least is what counts: a floor that
  // fits says nothing of a slide along it.
  Matrix6d agreed = Matrix6d::Zero();
  double squared = 0;
  for (std::size_t i = 0; i < vouching.matches.size(); ++i) {
    if (vouching.says[i] != Vouch::kAgrees) continue;
    const Correspondence& m = vouching.matches[i];
    const Eigen::Vector3d n = m.normal.cast<double>();
    Vector6d row;
    row << n, (m.point.cast<double>() - all.centre).cross(n);
    agreed.selfadjointView<Eigen::Lower>().rankUpdate(row);
    squared += double{m.residual} * double{m.residual} / double{frame.samples[i].variance};
  }
  agreed.triangularView<Eigen::StrictlyUpper>() = agreed.transpose();
  fit.spread = std::sqrt(squared / static_cast<double>(fit.agrees));
  // What the matches do not hold is stated elsewhere, and few that contradict would decide on it.
  Eigen::MatrixXd motions = held;
  for (Eigen::Index i = 0; i < held.cols(); ++i)
    motions.col(i).head(3) +=
        Eigen::Vector3d(held.col(i).tail(3)).cross(Eigen::Vector3d(all.centre - centre));
  Eigen::MatrixXd whole = motions.transpose() * all.information * motions;
  whole.diagonal().array() += 1e-9 * whole.diagonal().maxCoeff();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      motions.transpose() * agreed * motions, whole);
  const Vector6d least = motions * solver.eigenvectors().col(0);
  fit.share = std::clamp(solver.eigenvalues()[0], 0.0, 1.0);
  // Points head on that see that motion, as many as are independent of each other.
  const double points = least.dot(all.information * least) /
                        std::max(1e-12, least.dot(all.mass * least)) / frame.correlated;
  // Wilson's interval at 95 %, one-sided each.
  constexpr double kZ = 1.645;
  const double n = std::max(1.0, points);
  const double middle = (fit.share + kZ * kZ / (2 * n)) / (1 + kZ * kZ / n);
  const double half =
      kZ / (1 + kZ * kZ / n) * std::sqrt(fit.share * (1 - fit.share) / n + kZ * kZ / (4 * n * n));
  fit.share_low = middle - half;
  fit.share_high = middle + half;
}

}  // namespace

MapViews MapViews::from(const ScanMap& map, const Camera& camera, const Pose& T_map_view,
                        const std::vector<bool>& of) {
  return {MapView(map, with_margin(camera, kFineWidth), T_map_view, of),
          MapView(map, with_margin(camera, kCoarseWidth), T_map_view, of)};
}

double guess_cost(const FrameSamples& frame, const MapView& view, const Pose& T_map_camera) {
  constexpr double kMost = 9;
  const auto matches = match_to_view(frame, view, T_map_camera, {2, 0.02F, 10});
  double sum = 0;
  for (const Correspondence& m : matches)
    sum += m.weight <= 0
               ? kMost
               : std::min(kMost, double{m.residual} * double{m.residual} / frame.variance);
  return matches.empty() ? kMost : sum / static_cast<double>(matches.size());
}

MapFit fit_to_map(const FrameSamples& frame, const MapViews& views, const Pose& T_map_guess,
                  bool is_near) {
  MapFit fit;
  fit.T_map_camera = T_map_guess;
  if (!is_near)
    for (const Round& round : kFar) run(round, frame, views, fit.T_map_camera);
  for (const Round& round : kNear) run(round, frame, views, fit.T_map_camera);
  run(kLast, frame, views, fit.T_map_camera);

  const auto matches = match_to_view(frame, views.fine, fit.T_map_camera, kLast.reach);
  const NormalEquations equations = build_normal_equations(matches);
  fit.covariance = Matrix6d::Identity() * 100;
  if (equations.weight > 0) {
    const HeldMotions motions = held_motions(equations, matches);
    Eigen::MatrixXd held(6, 6);
    Eigen::Index count = 0;
    for (int i = 0; i < 6; ++i)
      if (!motions.weak[static_cast<std::size_t>(i)]) held.col(count++) = motions.directions.col(i);
    judge(frame, views.fine, held.leftCols(count), equations.centre, fit);
    // Unit weight is the samples' variance, of which a window's worth share one error.
    const double variance =
        frame.variance * frame.correlated * std::max(1.0, fit.spread * fit.spread);
    fit.covariance = motion_covariance(equations, motions, variance);
    fit.weak_directions = describe_weak(equations, motions, variance);
  }
  return fit;
}

}  // namespace spool
