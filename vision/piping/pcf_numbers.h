// Numbers as Piping Component Files write them: points, bores in inch fractions, angles.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace spool::piping {

// A finite number; a decimal comma counts as a point. Nothing for anything else.
[[nodiscard]] std::optional<double> number_of(std::string_view word);

// A bore in its file's unit: "4", "1.5", "1-1/2", "3/4", "4\"", "100mm". Nothing below or at zero.
[[nodiscard]] std::optional<double> bore_of(std::string_view word);

// The words of END-POINT and the like, in the file's units.
struct RawPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::optional<double> bore;
  std::string end;      // capitals; "" where it has none
  std::string trouble;  // what could not be read of bore or end; "" where nothing
};

// "x y z [bore] [end]", separated by blanks, commas or semicolons. Nothing where the first three
// are no numbers.
[[nodiscard]] std::optional<RawPoint> point_of(std::string_view value);

// An angle in degrees nearest to `drawn` (degrees): as written, or a hundredth of it.
[[nodiscard]] double angle_nearest(double written, double drawn);

// A direction by name (UP, DOWN, N, EAST, SW ...) or as three numbers; unit, x = east, y = north,
// z = up. Nothing where it says none.
[[nodiscard]] std::optional<Eigen::Vector3d> direction_of(std::string_view value);

}  // namespace spool::piping
