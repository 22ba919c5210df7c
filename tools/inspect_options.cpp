// The command line of spoolsight-inspect and what follows from it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect_options.h"

#include <algorithm>
#include <sstream>

#include "app/common/cli.h"
#include "app/common/json_file.h"
#include "app/common/rule_file.h"

namespace spool::tools {
namespace {

Error usage(std::string sentence) { return {ErrorCode::kUsage, std::move(sentence)}; }

}  // namespace

std::string method_text(const InspectOptions& options) {
  if (!options.align.empty()) return options.align;
  if (!options.pose.empty()) return "pose";
  return options.pairs.empty() ? "find" : "three-point";
}

namespace {

// What is wrong with a method's name; empty where nothing is (as CLI11 asks its validators).
std::string wrong_method(const std::string& text) {
  return parse_align_method(text) ? ""
                                  : text +
                                        " is no method; use find, three-point, pose or "
                                        "principal-axes";
}

}  // namespace

void add_inspect_options(CLI::App& app, InspectOptions& options) {
  app.add_option(
         "--design", options.designs,
         "Design: .glb .gltf .pcf .stl .obj .ply .pcd .xyz .txt; given several times, the one "
         "that lies there is found")
      ->type_name("FILE");
  app.add_option("--scan", options.scan,
                 "Scan: a cloud (.ply .pcd .xyz .txt .obj), a depth folder or an .oni recording")
      ->type_name("PATH");
  app.add_option("--frame", options.frame,
                 "Frame of a recording to use, counted from 0; the first if not given")
      ->check(non_negative_number())
      ->type_name("N");
  app.add_option("--align", options.align,
                 "find, three-point, pose or principal-axes; by default pose if --pose is given, "
                 "three-point if --pairs is, else find")
      ->check(CLI::Validator(wrong_method, ""))
      ->type_name("METHOD");
  app.add_option(
         "--pairs", options.pairs,
         "Picked pairs: {\"pairs\": [{\"design\": [x,y,z], \"scan\": [x,y,z]}, ...]} in metres")
      ->type_name("FILE");
  app.add_option("--pose", options.pose,
                 "Pose taken as given: {\"T_design_scan\": [16 numbers, row-major]} in metres")
      ->type_name("FILE");
  app.add_option(
         "--datum", options.datum,
         "Flange that positions are relative to, the one of several that is known best; the "
         "design's own if not given")
      ->type_name("PART[,PART]");
  app.add_option(
         "--standard", options.standard,
         "Tolerances that dimensions are judged by: pfi-es3, iso-13920-BF (or other classes, A "
         "to D and E to H) or a shop's own JSON")
      ->capture_default_str()
      ->type_name("NAME|FILE");
  app.add_option("--design-unit", options.design_unit, "Unit of the design's file: m, mm or in")
      ->check(CLI::IsMember({"m", "mm", "in"}))
      ->type_name("UNIT");
  app.add_option("--scan-unit", options.scan_unit, "Unit of a cloud file: m, mm or in")
      ->check(CLI::IsMember({"m", "mm", "in"}))
      ->type_name("UNIT");
  app.add_option("--units", options.units, "Units on the page for people: mm or ft-in")
      ->check(CLI::IsMember({"mm", "ft-in"}))
      ->capture_default_str()
      ->type_name("UNITS");
  app.add_option("--calibration", options.calibration, "Calibration of the depth camera")
      ->type_name("FILE");
  app.add_option("--sensor-check", options.sensor_check,
                 "In place of design and scan: a depth folder, .oni recording or device that looks "
                 "at a bare floor or wall; writes sensor.json, which --calibration takes")
      ->type_name("PATH");
  app.add_option("--seed", options.seed, "Seed of the design's sampling")
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--out", options.out,
                 "Folder for report.json, report.html, points.ply, overlay_*.png")
      ->type_name("DIR");
  app.footer(
      "Exit code: 0 all ok, 1 something not ok, 2 something suspicious or not measured, 3 not "
      "found or "
      "ambiguous;\n64 usage, 65 bad input, 69 no device, 70 internal, 74 read or write failed.");
}

Status check_given(const InspectOptions& options) {
  // In CLI11's own words, for what it would ask for were there no other commands.
  if (options.designs.empty()) return usage("--design is required");
  if (options.scan.empty()) return usage("--scan is required");
  if (options.out.empty()) return usage("--out is required");
  return {};
}

Status check(const InspectOptions& options) {
  if (!options.sensor_check.empty()) {
    if (!options.designs.empty() || !options.scan.empty())
      return usage("--sensor-check looks at a bare wall; give it without --design and --scan");
    if (options.out.empty()) return usage("--out is required");
    return {};
  }
  if (options.designs.size() > 1 && method_text(options) != "find")
    return usage(
        "--design is given " + std::to_string(options.designs.size()) +
        " times; which of several lies there only --align find says, else give one design");
  if (!options.pairs.empty() && !options.pose.empty())
    return usage("--pairs and --pose contradict each other; give one of them");
  const std::string method = method_text(options);
  if (method == "pose" && options.pose.empty()) return usage("--align pose needs --pose FILE");
  if (method == "three-point" && options.pairs.empty())
    return usage("--align three-point needs --pairs FILE");
  if (method != "pose" && !options.pose.empty())
    return usage("--pose is for --align pose, not for --align " + method);
  if (method != "three-point" && !options.pairs.empty())
    return usage("--pairs is for --align three-point, not for --align " + method);
  return {};
}

Result<InspectorOptions> inspector_options(const InspectOptions& options) {
  InspectorOptions inspector;
  inspector.align = parse_align_method(method_text(options)).value();
  inspector.seed = options.seed;
  auto rules = rules_of(options.standard);
  if (!rules) return rules.error();
  inspector.rules = std::move(*rules);
  if (!options.pairs.empty()) {
    auto pairs = read_pairs(options.pairs);
    if (!pairs) return pairs.error();
    inspector.pairs = std::move(*pairs);
  }
  if (!options.pose.empty()) {
    const auto pose = read_pose(options.pose);
    if (!pose) return pose.error();
    inspector.T_design_scan = *pose;
    inspector.posed_by = parse_align_method(options.posed_by);
  }
  return inspector;
}

Result<std::vector<std::string>> datum_parts(const std::string& flag, const DesignModel& model) {
  std::vector<std::string> names;
  if (flag.empty()) {
    for (const int part : model.datums)
      names.push_back(model.parts.at(static_cast<std::size_t>(part)).name);
    return names;
  }
  std::istringstream list(flag);
  for (std::string name; std::getline(list, name, ',');) {
    const auto is_it = [&](const Part& part) { return part.name == name; };
    if (std::none_of(model.parts.begin(), model.parts.end(), is_it)) {
      std::string known;
      for (const auto& part : model.parts) known += (known.empty() ? "" : ", ") + part.name;
      return usage("--datum " + name + ": is no part of " + model.path + "; its parts are " +
                   known);
    }
    names.push_back(name);
  }
  return names;
}

}  // namespace spool::tools
