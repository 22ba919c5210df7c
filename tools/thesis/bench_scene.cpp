// One of our scenes as the thesis's tables need it: a design to find, a cloud, and the truth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/thesis/bench_scene.h"

#include <cassert>
#include <utility>

#include "tools/campaign/ray_world.h"

namespace spool::thesis {

BenchScene make_bench_scene(const campaign::SceneRequest& request) {
  campaign::Scene scene = campaign::make_scene(request);
  BenchScene bench;
  bench.design.path = scene.design.name;
  bench.design.mesh = scene.mesh();
  bench.design.triangle_part.assign(bench.design.mesh.triangles.size(), 0);
  Part whole;
  whole.name = scene.design.name;
  whole.triangle_count = static_cast<std::uint32_t>(bench.design.mesh.triangles.size());
  bench.design.parts.push_back(whole);
  bench.cloud = std::move(scene.cloud);
  bench.cloud.normals.clear();  // a merged laser scan knows no viewpoint
  for (const std::uint8_t instance : scene.instances)
    bench.is_object.push_back(instance != campaign::kNoInstance ? 1 : 0);
  bench.object_points = scene.object_points;
  bench.clutter_ratio = scene.clutter_ratio;
  bench.completeness = scene.completeness;
  assert(!scene.symmetries.empty() && "the identity at least");
  for (const campaign::Instance& object : scene.objects)
    for (const Pose& T_design_design : scene.symmetries)
      bench.true_T_design_scan.push_back(T_design_design * object.T_scan_design.inverse());
  return bench;
}

Result<PairLibrary> Models::library_of(const DesignModel& design) {
  const std::string key = pair_model_key(design, known_.options);
  if (known_.find(key) == nullptr) {
    auto model = build_pair_model(design, known_.options);
    if (!model) return model.error();
    known_.models.push_back(std::move(*model));
  }
  PairLibrary one{.options = known_.options};
  one.models.push_back(*known_.find(key));
  return one;
}

}  // namespace spool::thesis
