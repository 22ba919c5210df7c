// How far planes in a depth image are bent: the sensor's warp, as far as what is flat tells it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/flat_warp.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "vision/core/median.h"

namespace spool {
namespace {

struct Row {
  std::size_t plane = 0;
  double x = 0, y = 0, off = 0, u = 0;
};

std::vector<Row> rows_of(std::span<const FlatCells> planes) {
  std::vector<Row> rows;
  for (std::size_t p = 0; p < planes.size(); ++p)
    for (int row = 0; row < FlatCells::kRows; ++row)
      for (int column = 0; column < FlatCells::kColumns; ++column) {
        const auto& cell =
            planes[p].cells[static_cast<std::size_t>(row * FlatCells::kColumns + column)];
        if (cell.readings > 0)
          rows.push_back({p, FlatCells::x_of(column), FlatCells::y_of(row), cell.off, cell.u});
      }
  return rows;
}

Eigen::VectorXd equation(const Row& row, std::size_t planes, int terms) {
  const auto first = static_cast<Eigen::Index>(3 * planes);
  Eigen::VectorXd of = Eigen::VectorXd::Zero(first + terms);
  of.segment<3>(static_cast<Eigen::Index>(3 * row.plane)) << 1, row.x, row.y;
  const DepthWarp::Terms term = DepthWarp::terms(row.x, row.y);
  for (int k = 0; k < terms; ++k) of[first + k] = term[static_cast<std::size_t>(k)];
  return of;
}

}  // namespace

FlatCells gather_cells(std::span<const FlatReading> readings, const NoiseModel& noise,
                       double correlated, std::size_t least) {
  struct Sum {
    double off = 0, z = 0;
    std::vector<double> all;
  };
  FlatCells gathered;
  std::vector<Sum> sums(gathered.cells.size());
  const auto place = [](double share, int count) {
    return std::clamp(static_cast<int>((share + 1) / 2 * count), 0, count - 1);
  };
  for (const FlatReading& reading : readings) {
    const int column = place(reading.x, FlatCells::kColumns);
    const int row = place(reading.y, FlatCells::kRows);
    Sum& sum = sums[static_cast<std::size_t>(row * FlatCells::kColumns + column)];
    sum.all.push_back(reading.z_m / reading.plane_z_m - 1);
    sum.z += reading.z_m;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const std::size_t count = sums[i].all.size();
    if (count < least || count == 0) continue;
    FlatCells::Cell& cell = gathered.cells[i];
    cell.readings = count;
    cell.z_m = sums[i].z / static_cast<double>(count);
    for (const double off : sums[i].all) cell.off += off / static_cast<double>(count);
    const double worth = std::max(1.0, static_cast<double>(count) / correlated);
    cell.u = noise.axial_m(cell.z_m) / cell.z_m / std::sqrt(worth);
  }
  return gathered;
}

std::optional<FlatWarpFit> fit_flat_warp(std::span<const FlatCells> planes, int terms) {
  std::vector<Row> rows = rows_of(planes);
  const auto unknowns = static_cast<Eigen::Index>(3 * planes.size()) + terms;
  FlatWarpFit fit;
  constexpr int kRounds = 4;
  constexpr double kBeside = 4;  // standard deviations
  for (int round = 0; round < kRounds; ++round) {
    if (static_cast<Eigen::Index>(rows.size()) < 2 * unknowns) return std::nullopt;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns, unknowns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    for (const Row& row : rows) {
      const Eigen::VectorXd of = equation(row, planes.size(), terms);
      normal += of * of.transpose() / (row.u * row.u);
      right += of * (row.off / (row.u * row.u));
    }
    const Eigen::LDLT<Eigen::MatrixXd> solver(normal);
    constexpr double kHeld = 1e-7;  // of the normal equations' condition: less is not held
    if (solver.info() != Eigen::Success || !(solver.rcond() > kHeld)) return std::nullopt;
    const Eigen::VectorXd found = solver.solve(right);
    std::vector<double> left;
    fit.chi_square = 0;
    for (const Row& row : rows) {
      left.push_back((row.off - equation(row, planes.size(), terms).dot(found)) / row.u);
      fit.chi_square += left.back() * left.back();
    }
    fit.freedom = static_cast<int>(rows.size()) - static_cast<int>(unknowns);
    const double birge = std::max(1.0, fit.chi_square / fit.freedom);
    fit.share.assign(found.data() + found.size() - terms, found.data() + found.size());
    fit.covariance =
        birge *
        solver.solve(Eigen::MatrixXd::Identity(unknowns, unknowns)).bottomRightCorner(terms, terms);
    fit.planes.clear();
    for (std::size_t p = 0; p < planes.size(); ++p)
      fit.planes.push_back(found.segment<3>(static_cast<Eigen::Index>(3 * p)));
    std::vector<double> sizes;
    for (const double each : left) sizes.push_back(std::abs(each));
    const double spread = std::max(1.0, 1.4826 * median(sizes));
    std::vector<Row> kept;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (std::abs(left[i]) < kBeside * spread) kept.push_back(rows[i]);
    if (kept.size() == rows.size()) break;
    rows = std::move(kept);
  }
  return fit;
}

}  // namespace spool
