// The units of a Piping Component File, and bores read as nominal pipe sizes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/pcf_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "vision/piping/catalogue.h"
#include "vision/piping/pcf_text.h"

namespace spool::piping {
namespace {

constexpr double kInch = 0.0254;
constexpr double kLargestListed = 24;  // NPS of the catalogue

constexpr std::array<std::pair<std::string_view, double>, 13> kCoordinateUnits{{
    {"MM", 0.001},
    {"INCH", kInch},
    {"MM-HUNDREDTH", 0.00001},
    {"M", 1.0},
    {"INCH-SIXTEENTH", kInch / 16},
    {"FEET", 0.3048},
    {"MILLIMETRE", 0.001},
    {"MILLIMETER", 0.001},
    {"INCHES", kInch},
    {"IN", kInch},
    {"METRE", 1.0},
    {"METER", 1.0},
    {"FT", 0.3048},
}};

std::optional<double> nps_of_dn(double dn) {
  for (const PipeSize& size : pipe_sizes()) {
    if (std::abs(size.dn - dn) < 0.01) return size.nps;
  }
  // From DN 650 on a size is 25 mm an inch (ASME B36.10M).
  if (dn > 625 && dn < 3000 && std::abs(dn / 50 - std::round(dn / 50)) < 1e-6) return dn / 25;
  return std::nullopt;
}

std::optional<double> listed_nps(double inches) {
  for (const PipeSize& size : pipe_sizes()) {
    if (std::abs(size.nps - inches) < 0.006) return size.nps;
  }
  if (inches > kLargestListed && inches < 120 &&
      std::abs(inches / 2 - std::round(inches / 2)) < 1e-6)
    return inches;
  return std::nullopt;
}

Bore of_nps(double nps, std::string note) {
  const Result<PipeSize> size = pipe_size(nps);
  // B36.10M: from NPS 14 on the outside diameter is the nominal size.
  return {nps, size ? size->outside_diameter : nps * kInch, std::move(note)};
}

Bore read_inches(double inches, const std::string& written) {
  if (inches <= kLargestListed) {
    if (const auto nps = listed_nps(inches)) return of_nps(*nps, "");
  }
  if (const auto nps = nps_of_outside_diameter(inches * kInch))
    return of_nps(*nps, "bore " + written + " is the outside diameter of NPS " + nps_text(*nps) +
                            " in inches");
  if (inches > kLargestListed) {
    if (const auto nps = nps_of_dn(inches))
      return of_nps(*nps, "bore " + written + " is no NPS but DN " + written + ", which is NPS " +
                              nps_text(*nps) + "; the file mixes units");
  }
  if (const auto nps = listed_nps(inches)) return of_nps(*nps, "");
  return {0, inches * kInch,
          "bore " + written +
              " is no nominal size in inches; it is taken as an "
              "outside diameter"};
}

Bore read_millimetres(double mm, const std::string& written) {
  if (const auto nps = nps_of_dn(mm)) return of_nps(*nps, "");
  if (const auto nps = nps_of_outside_diameter(mm / 1000))
    return of_nps(*nps, "bore " + written + " is the outside diameter of NPS " + nps_text(*nps));
  if (const auto nps = listed_nps(mm / 25.4); nps && *nps <= kLargestListed)
    return of_nps(*nps, "bore " + written + " is NPS " + nps_text(*nps) + " turned into mm");
  if (const auto nps = listed_nps(mm); nps && mm <= kLargestListed)
    return of_nps(
        *nps, "bore " + written + " is no DN but NPS " + nps_text(*nps) + "; the file mixes units");
  return {0, mm / 1000,
          "bore " + written +
              " is no nominal size in mm; it is taken as an outside "
              "diameter"};
}

std::string short_text(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

bool all_are(std::span<const double> bores, std::optional<double> (*size)(double)) {
  return std::all_of(bores.begin(), bores.end(),
                     [&](double bore) { return size(bore).has_value(); });
}

}  // namespace

std::string_view name(BoreUnit unit) {
  if (unit == BoreUnit::kInchSixteenth) return "sixteenths of an inch";
  return unit == BoreUnit::kInch ? "inch" : "mm";
}

std::optional<BoreUnit> bore_unit_of(std::string_view word) {
  const std::string unit = to_capitals(word);
  if (unit == "INCH" || unit == "INCHES" || unit == "IN" || unit == "NPS") return BoreUnit::kInch;
  if (unit == "MM" || unit == "MILLIMETRE" || unit == "MILLIMETER" || unit == "DN")
    return BoreUnit::kMillimetre;
  if (unit == "INCH-SIXTEENTH") return BoreUnit::kInchSixteenth;
  return std::nullopt;
}

std::optional<double> coordinate_unit_of(std::string_view word) {
  const std::string unit = to_capitals(word);
  for (const auto& [spelled, metres] : kCoordinateUnits) {
    if (spelled == unit) return metres;
  }
  return std::nullopt;
}

std::string_view coordinate_unit_name(double metres) {
  for (const auto& [spelled, each] : kCoordinateUnits) {
    if (each == metres) return spelled;
  }
  return "?";
}

Bore read_bore(double written, BoreUnit unit) {
  const std::string text = short_text(written);
  if (unit == BoreUnit::kMillimetre) return read_millimetres(written, text);
  return read_inches(unit == BoreUnit::kInch ? written : written / 16, text);
}

std::optional<BoreUnit> settle_bore_unit(std::optional<BoreUnit> declared,
                                         std::span<const double> bores) {
  if (bores.empty() || declared == BoreUnit::kInchSixteenth) return declared;
  const double largest = *std::max_element(bores.begin(), bores.end());
  const bool fits_inch = all_are(bores, &listed_nps) && largest <= kLargestListed;
  const bool fits_mm = all_are(bores, &nps_of_dn);
  // DN 8 and 10 are NPS as well, so both may fit: then what is declared holds.
  if (fits_inch != fits_mm) return fits_inch ? BoreUnit::kInch : BoreUnit::kMillimetre;
  if (declared || !fits_inch) return declared;
  return std::nullopt;
}

std::optional<double> guess_coordinate_unit(std::span<const KnownLength> lengths) {
  constexpr double kSame = 1.33;
  std::optional<double> best;
  std::size_t most = lengths.size() / 2;  // a majority has to agree
  for (const double unit : {0.001, kInch, 1.0, 0.00001}) {
    const auto agree = static_cast<std::size_t>(
        std::count_if(lengths.begin(), lengths.end(), [&](const KnownLength& each) {
          const double ratio = each.drawn * unit / each.meant;
          return ratio < kSame && ratio > 1 / kSame;
        }));
    if (agree > most) {
      most = agree;
      best = unit;
    }
  }
  return best;
}

}  // namespace spool::piping
