// Which of several designs lies in the scan, and what the scan says of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect_designs.h"

#include <chrono>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "vision/design/design_reader.h"

namespace spool::tools {
namespace {

// A scan of less than this share of the design's size cannot be of it, and one of so many times its
// size is no shop: metres and millimetres were taken for each other.
constexpr double kLeastOfDesign = 0.1, kMostOfDesign = 200;
// Another design that explains this share of the best's points may be the one.
constexpr double kNearly = 0.9;

double explained(const InspectedDesign& design) {
  return design.inspection.alignment.found ? static_cast<double>(design.inspection.declutter.object)
                                           : -1.0;
}

std::vector<int> parts_named(const std::vector<std::string>& names, const DesignModel& model) {
  std::vector<int> parts;
  for (const std::string& name : names)
    for (std::size_t p = 0; p < model.parts.size(); ++p)
      if (model.parts[p].name == name) parts.push_back(static_cast<int>(p));
  return parts;
}

// Of a design that was not found: where the sizes are a unit apart, that is the likely reason.
void hint_at_units(const PointCloud& scan, InspectedDesign& one) {
  if (one.inspection.alignment.found) return;
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : scan.points)
    if (point.allFinite()) box.extend(point);
  if (box.isEmpty()) return;
  const auto scan_m = static_cast<double>(box.diagonal().norm());
  const double design_m = one.design->model.bounds().diagonal().norm();
  if (scan_m > kLeastOfDesign * design_m && scan_m < kMostOfDesign * design_m) return;
  one.warnings.push_back(fmt::format(
      "The scan is {:.3g} m across and the design {:.3g} m; check --scan-unit and --design-unit.",
      scan_m, design_m));
}

Result<InspectedDesign> inspect_one(const std::string& path, const InspectOptions& options,
                                    InspectorOptions settings, const PointCloud& scan,
                                    const NoiseModel& noise, bool scan_unit_inferred,
                                    const Watch& watch) {
  const auto start = std::chrono::steady_clock::now();
  auto model = read_design(path, parse_length_unit(options.design_unit));
  if (!model) return model.error();
  // The datum is asked for before the work starts; of several designs, one without it is not meant.
  if (!options.datum.empty()) {
    const auto names = datum_parts(options.datum, *model);
    if (!names && options.designs.size() == 1) return names.error();
    if (names) model->datums = parts_named(*names, *model);
  }
  auto design = PreparedDesign::prepare(std::move(*model), options.seed,
                                        settings.align == AlignMethod::kFind);
  if (!design) return design.error();
  InspectedDesign one{.design = *design};
  one.read_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  settings.units_confirmed = !one.design->model.unit_inferred && !scan_unit_inferred;
  auto inspection = Inspector(one.design).process(scan, noise, settings, watch);
  if (!inspection) return inspection.error();
  one.inspection = std::move(*inspection);
  hint_at_units(scan, one);
  return one;
}

}  // namespace

Result<InspectedDesign> inspect_designs(const InspectOptions& options,
                                        const InspectorOptions& settings, const PointCloud& scan,
                                        const NoiseModel& noise, bool scan_unit_inferred,
                                        const Watch& watch) {
  std::optional<InspectedDesign> best;
  double read_s = 0, second = -1;
  std::string second_path;
  for (const std::string& path : options.designs) {
    auto one = inspect_one(path, options, settings, scan, noise, scan_unit_inferred, watch);
    if (!one) return one.error();
    read_s += one->read_s;
    if (best && explained(*one) <= explained(*best)) {
      if (explained(*one) > second) {
        second = explained(*one);
        second_path = path;
      }
      continue;
    }
    if (best && explained(*best) > second) {
      second = explained(*best);
      second_path = best->design->model.path;
    }
    best = std::move(*one);
  }
  best->read_s = read_s;
  if (options.designs.size() > 1 && explained(*best) > 0)
    best->warnings.push_back("Of " + std::to_string(options.designs.size()) + " designs, " +
                             best->design->model.path + " lies in the scan.");
  if (second > kNearly * explained(*best) && second > 0)
    best->warnings.push_back(second_path +
                             " explains the scan nearly as well; look at the overlay before using "
                             "the numbers.");
  return std::move(*best);
}

}  // namespace spool::tools
