// The sample that the program comes with.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/e2e/sample_files.h"

#include <chrono>
#include <fstream>

#include <nlohmann/json.hpp>

#include "app/sensor/depth_source.h"
#include "tests/support/shared_data.h"
#include "vision/design/design_reader.h"

namespace spool::test {

SampleFiles read_sample() {
  const std::filesystem::path folder = source_dir() / "assets" / "sample";
  SampleFiles out{folder / "spool.glb", folder / "recording", folder / "taps.json", {}, {}, {}, {}};
  nlohmann::json truth;
  std::ifstream(out.recording / "truth.json") >> truth;
  const auto pose = [](const nlohmann::json& numbers) {
    return pose_from_row_major(numbers.get<std::vector<double>>()).value_or(Pose::Identity());
  };
  const Pose T_design_map = pose(truth["T_map_design"]).inverse();
  for (const nlohmann::json& frame : truth["frames"]) {
    out.T_design_camera.push_back(T_design_map * pose(frame["T_map_camera"]));
  }
  auto source = sensor::open_source(out.recording.string());
  if (!source) return out;
  out.camera = (*source)->camera();
  while (out.frames.size() < out.T_design_camera.size()) {
    auto next = (*source)->next(std::chrono::milliseconds(1000));
    if (!next || !next->frame) return out;
    out.frames.push_back(next->frame);
  }
  auto model = read_design(out.design);
  if (!model) return out;
  auto prepared = PreparedDesign::prepare(std::move(*model));
  if (prepared) out.prepared = *prepared;
  return out;
}

}  // namespace spool::test
