// A depth camera looked at a flat floor or wall: its noise, its warp, and which tolerances it
// serves.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "vision/core/camera.h"
#include "vision/core/point_cloud.h"
#include "vision/core/result.h"
#include "vision/measure/flat_warp.h"
#include "vision/scan/noise_model.h"

namespace spool {

// Random error of a reading beside what the noise model says.
struct NoiseAtRange {
  double range_m = 0, measured_m = 0, model_m = 0;
  std::size_t readings = 0;
};

// Up to which length a tolerance can be proved from a range; 0: no length.
struct ServedLength {
  double range_m = 0, longest_m = 0;
};
struct ServedTolerance {
  double tolerance_m = 0;  // 3, 5 and 6 mm: PFI ES-3 2.2, NPS to 10, 12 to 24, over 24 to 36
  std::vector<ServedLength> at;
};

struct SensorCheckResult {
  Calibration calibration;              // scale_u as it was handed in: a flat wall does not tell it
  FlatCells map;                        // share of depth, place and tilt of the plane taken off
  double corner_m = 0, corner_u_m = 0;  // the largest bend of the four corners, at range_m
  double left_m = 0;                    // root mean square of what the polynomial leaves
  double range_m = 0;                   // median
  std::vector<NoiseAtRange> noise;
  double noise_ratio = 1;  // measured over model, all readings
  std::vector<ServedTolerance> serves;
  std::size_t frames = 0;
};

// Gathers frames of one check; one thread.
class SensorCheck {
 public:
  // The camera's own warp is not looked at: frames are handed in without it.
  SensorCheck(const Camera& camera, const NoiseModel& noise);

  // An organised cloud (m, camera frame). kBadInput where no plane holds most of the readings or
  // it covers too little of the picture, with what to do.
  [[nodiscard]] Status add(const PointCloud& organised);

  // After one frame or more. `scale_u` is what is known of the scale already. The uncertainty of
  // the warp does not fall with the number of frames: what a parked camera gets wrong it repeats.
  [[nodiscard]] SensorCheckResult finish(double scale_u) const;

 private:
  struct NoiseSum {
    double squares = 0, model = 0, z = 0;
    std::size_t readings = 0;
  };
  Camera camera_;
  NoiseModel noise_;
  std::size_t frames_ = 0;
  DepthWarp::Terms share_ = {};       // sums over frames
  Eigen::MatrixXd covariance_;        // sum over frames
  std::vector<double> off_, u2_, z_;  // of cells, sums over frames
  std::vector<std::size_t> cell_frames_, cell_readings_;
  std::map<int, NoiseSum> noise_sums_;  // by range in steps of 0.25 m
  std::vector<double> ranges_;          // one a frame
};

}  // namespace spool
