// A pose from picked pairs: Horn's orientation by the SVD, and every reason to refuse.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/three_point.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/SVD>

namespace spool {
namespace {

struct Fit {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  std::vector<double> residual_m;
  double rms_m = 0;
  double worst_m = 0;
  std::size_t worst = 0;
};

Eigen::Matrix3Xd side(std::span<const PointPair> pairs, bool design) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = design ? pairs[i].design : pairs[i].scan;
  return points;
}

// Least squares over rotations (Horn 1987, Umeyama 1991 eq. 40-43 with c = 1), or over reflections.
Fit fit_rigid(const Eigen::Matrix3Xd& design, const Eigen::Matrix3Xd& scan, bool reflection) {
  Fit fit;
  const Eigen::Vector3d design_mean = design.rowwise().mean();
  const Eigen::Vector3d scan_mean = scan.rowwise().mean();
  const Eigen::Matrix3d cross =
      (design.colwise() - design_mean) * (scan.colwise() - scan_mean).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double handed = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  const Eigen::Vector3d signs(1, 1, (handed < 0) != reflection ? -1 : 1);
  fit.linear = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  fit.translation = design_mean - fit.linear * scan_mean;
  const Eigen::Matrix3Xd off = ((fit.linear * scan).colwise() + fit.translation) - design;
  for (Eigen::Index i = 0; i < off.cols(); ++i) fit.residual_m.push_back(off.col(i).norm());
  fit.rms_m = std::sqrt(off.squaredNorm() / static_cast<double>(off.cols()));
  const auto worst = std::max_element(fit.residual_m.begin(), fit.residual_m.end());
  fit.worst = static_cast<std::size_t>(worst - fit.residual_m.begin());
  fit.worst_m = *worst;
  return fit;
}

// Root mean squares of the points along their three principal directions, largest first (m).
Eigen::Vector3d spreads(const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d mean = points.rowwise().mean();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(points.colwise() - mean);
  Eigen::Vector3d s = Eigen::Vector3d::Zero();
  const Eigen::Index n = std::min<Eigen::Index>(3, svd.singularValues().size());
  s.head(n) = svd.singularValues().head(n);
  return s / std::sqrt(static_cast<double>(points.cols()));
}

std::string mm(double metres) { return std::to_string(std::lround(metres * 1000)) + " mm"; }
std::string number(std::size_t i) { return std::to_string(i + 1); }

std::string coincident_reason(const Eigen::Matrix3Xd& points, const char* where,
                              double separation) {
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    for (Eigen::Index j = i + 1; j < points.cols(); ++j) {
      const double apart = (points.col(i) - points.col(j)).norm();
      if (apart < separation)
        return "Picks " + number(static_cast<std::size_t>(i)) + " and " +
               number(static_cast<std::size_t>(j)) + " on the " + where + " are at one place (" +
               mm(apart) + " apart); pick places at least " + mm(separation) + " from each other.";
    }
  return {};
}

// The exchange of picks that would make them fit, in words; empty where none does.
std::string exchange_reason(const Eigen::Matrix3Xd& design, const Eigen::Matrix3Xd& scan,
                            const Fit& given, double limit) {
  const Eigen::Index n = scan.cols();
  Fit best = given;
  std::string reason;
  const auto attempt = [&](const Eigen::Matrix3Xd& reordered, const std::string& words) {
    Fit fit = fit_rigid(design, reordered, false);
    if (fit.rms_m < best.rms_m) {
      best = std::move(fit);
      reason = words;
    }
  };
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = i + 1; j < n; ++j) {
      Eigen::Matrix3Xd swapped = scan;
      swapped.col(i).swap(swapped.col(j));
      attempt(swapped,
              "Picks " + number(static_cast<std::size_t>(i)) + " and " +
                  number(static_cast<std::size_t>(j)) +
                  " look exchanged between the design and the scan; pick them again in the "
                  "same order.");
    }
  if (n == 3) {
    for (const int turn : {1, 2}) {
      Eigen::Matrix3Xd turned(3, 3);
      for (Eigen::Index i = 0; i < 3; ++i) turned.col(i) = scan.col((i + turn) % 3);
      attempt(
          turned,
          "Picks 1, 2 and 3 look shifted round between the design and the scan; pick them again "
          "in the same order.");
    }
  }
  // Far better: a quarter of the misfit, and one that would be accepted.
  if (best.rms_m < 0.25 * given.rms_m && best.worst_m < limit) return reason;
  return {};
}

}  // namespace

std::optional<Error> validate(const PairsOptions& options) {
  if (!(options.max_residual_m > 0) || !(options.min_separation_m > 0) ||
      !(options.min_spread_ratio > 0 && options.min_spread_ratio < 1))
    return Error{
        ErrorCode::kUsage,
        "The limits for picked pairs must be above zero, the spread ratio also below one."};
  return std::nullopt;
}

PairsAlignment align_pairs(std::span<const PointPair> pairs, const PairsOptions& options) {
  assert(!validate(options) && "options as validate() accepts them");
  PairsAlignment result;
  const auto refuse = [&](PairsStatus status, std::string reason) {
    result.status = status;
    result.reason = std::move(reason);
    return result;
  };
  if (pairs.size() < 3)
    return refuse(PairsStatus::kTooFew, "Three pairs are needed to place the design and there " +
                                            std::string(pairs.size() == 1 ? "is " : "are ") +
                                            std::to_string(pairs.size()) + "; pick more.");
  const Eigen::Matrix3Xd design = side(pairs, true);
  const Eigen::Matrix3Xd scan = side(pairs, false);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (!pairs[i].design.allFinite() || !pairs[i].scan.allFinite())
      return refuse(PairsStatus::kInconsistent,
                    "Pair " + number(i) + " has a coordinate that is not a number; pick it again.");
  for (const bool on_design : {true, false}) {
    const std::string reason = coincident_reason(
        on_design ? design : scan, on_design ? "design" : "scan", options.min_separation_m);
    if (!reason.empty()) return refuse(PairsStatus::kCoincident, reason);
  }
  const Eigen::Vector3d design_spread = spreads(design);
  const Eigen::Vector3d scan_spread = spreads(scan);
  for (const bool on_design : {true, false}) {
    const Eigen::Vector3d& spread = on_design ? design_spread : scan_spread;
    if (spread[1] < options.min_spread_ratio * spread[0])
      return refuse(
          PairsStatus::kCollinear,
          "The picks on the " + std::string(on_design ? "design" : "scan") +
              " lie nearly on one line (" + mm(spread[1]) +
              " off it), so the turn about that line is open; pick one well away from it.");
  }

  const Fit fit = fit_rigid(design, scan, false);
  result.T_design_scan.linear() = fit.linear;
  result.T_design_scan.translation() = fit.translation;
  result.rms_m = fit.rms_m;
  result.residual_m = fit.residual_m;

  // Worse than honest taps explain: half the limit, or a fifth of the picks' spread on small
  // objects.
  const bool bad = fit.worst_m > std::min(0.5 * options.max_residual_m, 0.2 * design_spread[0]);
  if (bad) {
    const std::string exchanged = exchange_reason(design, scan, fit, options.max_residual_m);
    if (!exchanged.empty()) return refuse(PairsStatus::kMirrored, exchanged);
    const bool solid = design_spread[2] > options.min_spread_ratio * design_spread[0] &&
                       scan_spread[2] > options.min_spread_ratio * scan_spread[0];
    if (solid && fit_rigid(design, scan, true).rms_m < 0.25 * fit.rms_m)
      return refuse(PairsStatus::kMirrored,
                    "The picks on the scan are the mirror image of those on the design (pair " +
                        number(fit.worst) + " is off by " + mm(fit.worst_m) +
                        "); this may be the opposite hand of the spool, else pick again.");
  }
  if (fit.worst_m > options.max_residual_m)
    return refuse(PairsStatus::kInconsistent, "The pairs do not fit each other: pair " +
                                                  number(fit.worst) + " is off by " +
                                                  mm(fit.worst_m) + " (allowed " +
                                                  mm(options.max_residual_m) + "); pick it again.");
  result.status = PairsStatus::kOk;
  return result;
}

double predicted_error(std::span<const PointPair> pairs, double pick_error,
                       const Eigen::Vector3d& design_point) {
  assert(pairs.size() >= 3 && "pairs that align_pairs() accepted");
  const auto jacobian = [](const Eigen::Vector3d& d) {
    Eigen::Matrix<double, 3, 6> j;
    j << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
    j.rightCols<3>() << 0, d.z(), -d.y(), -d.z(), 0, d.x(), d.y(), -d.x(), 0;  // -[d]x
    return j;
  };
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const PointPair& pair : pairs) mean += pair.design / static_cast<double>(pairs.size());
  Matrix6d information = Matrix6d::Zero();
  for (const PointPair& pair : pairs) {
    const auto j = jacobian(pair.design - mean);
    information += j.transpose() * j;
  }
  const auto j = jacobian(design_point - mean);
  const Eigen::Matrix3d covariance =
      j * information.ldlt().solve(Matrix6d::Identity()) * j.transpose();
  return pick_error * std::sqrt(covariance.trace());
}

}  // namespace spool
