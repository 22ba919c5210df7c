// A depth camera looked at a flat floor or wall: its noise, its warp, and which tolerances it
// serves.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/sensor_check.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "vision/core/median.h"
#include "vision/fit/plane.h"
#include "vision/scan/reading_noise.h"

namespace spool {
namespace {

constexpr std::size_t kMostSearched = 6000;  // readings that the plane is looked for in
constexpr double kStep_m = 0.25;             // of range, that noise is gathered by
constexpr double kLeastShare = 0.6;          // of the readings on the plane

Error not_flat(const std::string& what) {
  return {ErrorCode::kBadInput, what +
                                    "; point the sensor squarely at a bare floor or wall that "
                                    "fills the picture, from 0.7 to 1.5 m"};
}

double at_share(const Eigen::Vector3d& plane, double x, double y) {
  return plane[0] + plane[1] * x + plane[2] * y;
}

// The least that is asked of u for half of a tolerance to be left for ok: 1.645 u within T / 2
// (JCGM 106, one-sided 95 %). Ends are raised faces of NPS 4 (ASME B16.5: 157 mm, bore 102 mm).
std::vector<ServedTolerance> served(const SensorCheckResult& result, const Camera& camera,
                                    const NoiseModel& noise) {
  constexpr double kFace_m2 = std::numbers::pi / 4 * (0.157 * 0.157 - 0.102 * 0.102);
  std::vector<ServedTolerance> all;
  for (const double tolerance_m : {0.003, 0.005, 0.006}) {
    ServedTolerance one{tolerance_m, {}};
    for (const double range_m : {0.5, 0.75, 1.0, 1.5, 2.0, 3.0}) {
      const double pixels = kFace_m2 * camera.fx * camera.fy / (range_m * range_m);
      const double worth = std::max(1.0, pixels / correlated_readings(camera, 1));
      const double random_m = result.noise_ratio * noise.axial_m(range_m) / std::sqrt(worth);
      const double warp_m = result.calibration.warp_u_m * range_m / result.range_m / std::sqrt(3.0);
      const double most_m = tolerance_m / 2 / 1.645;
      const double left2 = most_m * most_m - 2 * (random_m * random_m + warp_m * warp_m);
      const double scale_u = std::max(1e-6, result.calibration.scale_u);
      one.at.push_back({range_m, left2 > 0 ? std::sqrt(left2) / scale_u : 0});
    }
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

SensorCheck::SensorCheck(const Camera& camera, const NoiseModel& noise)
    : camera_(camera),
      noise_(noise),
      covariance_(Eigen::MatrixXd::Zero(DepthWarp::kTerms, DepthWarp::kTerms)) {
  const std::size_t cells = FlatCells{}.cells.size();
  off_.resize(cells);
  u2_.resize(cells);
  z_.resize(cells);
  cell_frames_.resize(cells);
  cell_readings_.resize(cells);
}

Status SensorCheck::add(const PointCloud& organised) {
  assert(organised.width == camera_.width && organised.height == camera_.height &&
         "a frame of this camera");
  std::vector<Eigen::Vector3f> measured, some;
  for (const Eigen::Vector3f& p : organised.points)
    if (p.allFinite() && p.z() > 0) measured.push_back(p);
  if (measured.size() < organised.size() / 4)
    return not_flat("less than a quarter of the picture was measured");
  const std::size_t step = std::max<std::size_t>(1, measured.size() / kMostSearched);
  for (std::size_t i = 0; i < measured.size(); i += step) some.push_back(measured[i]);
  const PlaneFit plane = fit_plane_robustly(some);
  if (!plane.is_determined) return not_flat("no plane holds most of the picture");

  constexpr double kBent_m = 0.03;  // a picture may be bent by as much
  const double to_plane = plane.normal().dot(plane.centre());
  std::vector<FlatReading> readings;
  std::vector<float> depths;
  for (std::size_t i = 0; i < organised.size(); ++i) {
    const Eigen::Vector3f& point = organised.points[i];
    if (!point.allFinite() || !(point.z() > 0)) continue;
    const double z = static_cast<double>(point.z());
    const double facing = (point.cast<double>() / z).dot(plane.normal());
    const double plane_z = to_plane / facing;
    if (!(plane_z > 0) || std::abs(z - plane_z) > kBent_m + 4 * noise_.axial_m(z)) continue;
    const auto column = static_cast<double>(i % static_cast<std::size_t>(organised.width));
    const auto row = static_cast<double>(i / static_cast<std::size_t>(organised.width));
    readings.push_back(
        {picture_share(column, organised.width), picture_share(row, organised.height), z, plane_z});
    depths.push_back(point.z());
  }
  if (static_cast<double>(readings.size()) < kLeastShare * static_cast<double>(measured.size()))
    return not_flat("no plane holds most of the picture");
  const std::size_t least = organised.size() / (4 * off_.size());
  const FlatCells cells = gather_cells(readings, noise_, correlated_readings(camera_, 1),
                                       std::max<std::size_t>(2, least));
  const auto fit = fit_flat_warp(std::span(&cells, 1), DepthWarp::kTerms);
  if (!fit) return not_flat("what is flat covers too little of the picture");

  DepthWarp warp;
  std::ranges::copy(fit->share, warp.share.begin());
  for (std::size_t k = 0; k < share_.size(); ++k) share_[k] += warp.share[k];
  covariance_ += fit->covariance;
  for (std::size_t i = 0; i < cells.cells.size(); ++i) {
    const FlatCells::Cell& cell = cells.cells[i];
    if (cell.readings == 0) continue;
    const double x = FlatCells::x_of(static_cast<int>(i) % FlatCells::kColumns);
    const double y = FlatCells::y_of(static_cast<int>(i) / FlatCells::kColumns);
    off_[i] += cell.off - at_share(fit->planes.front(), x, y);
    u2_[i] += cell.u * cell.u;
    z_[i] += cell.z_m;
    ++cell_frames_[i];
    cell_readings_[i] += cell.readings;
  }
  for (const FlatReading& reading : readings) {
    const double smooth =
        at_share(fit->planes.front(), reading.x, reading.y) + warp.at(reading.x, reading.y);
    const double off_m = (reading.z_m / reading.plane_z_m - 1 - smooth) * reading.z_m;
    const double model_m = noise_.axial_m(reading.z_m);
    NoiseSum& sum = noise_sums_[static_cast<int>(reading.z_m / kStep_m)];
    sum.squares += off_m * off_m;
    sum.model += model_m * model_m;
    sum.z += reading.z_m;
    ++sum.readings;
  }
  ranges_.push_back(static_cast<double>(median(depths)));
  ++frames_;
  return {};
}

SensorCheckResult SensorCheck::finish(double scale_u) const {
  assert(frames_ > 0 && "something was looked at");
  const auto frames = static_cast<double>(frames_);
  SensorCheckResult result;
  result.frames = frames_;
  std::vector<double> ranges = ranges_;
  result.range_m = median(ranges);
  DepthWarp& warp = result.calibration.warp;
  for (std::size_t k = 0; k < share_.size(); ++k) warp.share[k] = share_[k] / frames;
  double left2 = 0, count = 0;
  for (std::size_t i = 0; i < off_.size(); ++i) {
    if (cell_frames_[i] == 0) continue;
    const auto looks = static_cast<double>(cell_frames_[i]);
    result.map.cells[i] = {off_[i] / looks, std::sqrt(u2_[i] / looks), z_[i] / looks,
                           cell_readings_[i]};
    const double x = FlatCells::x_of(static_cast<int>(i) % FlatCells::kColumns);
    const double y = FlatCells::y_of(static_cast<int>(i) / FlatCells::kColumns);
    left2 += std::pow(off_[i] / looks - warp.at(x, y), 2);
    count += 1;
  }
  result.left_m = result.range_m * std::sqrt(left2 / count);
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const DepthWarp::Terms term = DepthWarp::terms(x, y);
      const Eigen::Map<const Eigen::VectorXd> t(term.data(), DepthWarp::kTerms);
      result.corner_u_m =
          std::max(result.corner_u_m, result.range_m * std::sqrt(t.dot(covariance_ * t) / frames));
      result.corner_m = std::max(result.corner_m, result.range_m * std::abs(warp.at(x, y)));
    }
  result.calibration.scale_u = scale_u;
  result.calibration.warp_u_m = std::hypot(result.corner_u_m, result.left_m);
  double squares = 0, model = 0;
  for (const auto& [step, sum] : noise_sums_) {
    const auto readings = static_cast<double>(sum.readings);
    result.noise.push_back({sum.z / readings, std::sqrt(sum.squares / readings),
                            std::sqrt(sum.model / readings), sum.readings});
    squares += sum.squares;
    model += sum.model;
  }
  result.noise_ratio = std::sqrt(squares / model);
  result.serves = served(result, camera_, noise_);
  return result;
}

}  // namespace spool
