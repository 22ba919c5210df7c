// How far planes in a depth image are bent: the sensor's warp, as far as what is flat tells it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/depth_warp.h"
#include "vision/scan/noise_model.h"

namespace spool {

// A reading on a plane, and where in the picture (-1 to 1 between its sides).
struct FlatReading {
  double x = 0, y = 0;
  double z_m = 0;
  double plane_z_m = 0;  // where the pixel's ray meets the plane
};

// The picture's cells that readings are gathered in: random noise is averaged, the bend is not.
struct FlatCells {
  static constexpr int kColumns = 20, kRows = 15;
  struct Cell {
    double off = 0, u = 0;  // mean of z / plane - 1, and its standard uncertainty
    double z_m = 0;
    std::size_t readings = 0;  // 0: too few
  };
  std::vector<Cell> cells = std::vector<Cell>(std::size_t{kColumns} * kRows);  // rows from the top
  [[nodiscard]] static double x_of(int column) { return (2 * column + 1.0) / kColumns - 1; }
  [[nodiscard]] static double y_of(int row) { return (2 * row + 1.0) / kRows - 1; }
};

// `correlated`: readings that are worth one. Cells under `least` readings are left empty.
[[nodiscard]] FlatCells gather_cells(std::span<const FlatReading> readings, const NoiseModel& noise,
                                     double correlated, std::size_t least);

struct FlatWarpFit {
  std::vector<double> share;   // the first terms of DepthWarp, as many as were asked for
  Eigen::MatrixXd covariance;  // of them
  // Of each plane what its place and tilt were corrected by: share of depth = p . (1, x, y).
  std::vector<Eigen::Vector3d> planes;
  double chi_square = 0;  // of the cells about the fit; above its freedom the covariance has grown
  int freedom = 0;
};

// Weighted least squares over the cells of all `planes` together: each its own constant and linear
// terms, which are scale and tilt, and one polynomial of `terms` terms (3: squares; 7: cubes too;
// 12: all of DepthWarp). Cells off by more than four standard deviations (something lies on the
// plane) are dropped and the fit repeated. Nothing where cells cover too little of the picture to
// hold them.
[[nodiscard]] std::optional<FlatWarpFit> fit_flat_warp(std::span<const FlatCells> planes,
                                                       int terms);

}  // namespace spool
