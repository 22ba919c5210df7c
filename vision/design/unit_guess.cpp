// Which unit a file without one is in, judged by the size of what it holds.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/unit_guess.h"

#include <array>
#include <cstdio>
#include <vector>

namespace spool {
namespace {
constexpr double kShortest = 0.015;  // m, the longest side of the smallest part that is fitted
constexpr double kLongest = 15.0;    // m, of the largest spool that leaves a shop on a lorry
}  // namespace

Result<LengthUnit> guess_unit(const std::filesystem::path& path,
                              const Eigen::AlignedBox3d& bounds) {
  const double longest = bounds.sizes().maxCoeff();
  const auto plausible = [longest](LengthUnit unit) {
    return longest * metres(unit) > kShortest && longest * metres(unit) <= kLongest;
  };
  if (plausible(LengthUnit::kMillimetre)) return LengthUnit::kMillimetre;
  if (plausible(LengthUnit::kMetre) && !plausible(LengthUnit::kInch)) return LengthUnit::kMetre;
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.4g", longest);
  return Error{ErrorCode::kBadInput,
               path.string() + " does not say its unit and its longest side of " + number.data() +
                   " does not tell it; give --design-unit m, mm or in"};
}

std::string size_text(const Eigen::AlignedBox3d& bounds, LengthUnit unit) {
  const Eigen::Vector3d sizes = bounds.sizes();
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "%.5g x %.5g x %.5g ", sizes.x(), sizes.y(), sizes.z());
  return text.data() + std::string(name(unit));
}

}  // namespace spool
