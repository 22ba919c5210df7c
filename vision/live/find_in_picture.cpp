// Where the design is in one picture of the camera.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/find_in_picture.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "vision/inspect/scan_alignment.h"
#include "vision/live/frame_processor.h"
#include "vision/scan/back_projection.h"

namespace spool {

namespace {
// A pose that shows less than this of what the best one shows is no rival: as in the finder.
constexpr double kRival = 0.8;

// One of what symmetry, or the fit, makes equal.
bool is_known(const FinderModel& finder, const std::vector<VisionStatePtr>& poses, const Pose& T) {
  return std::any_of(poses.begin(), poses.end(), [&](const VisionStatePtr& known) {
    const Pose& T_known = known->T_design_camera;
    return finder.are_symmetric(T_known, T) ||
           displacement_m(finder, T_known.cast<float>(), T.cast<float>()) < finder.same_m();
  });
}
}  // namespace

FindAnswer find_in_picture(const std::shared_ptr<const PreparedDesign>& design,
                           const FinderModel& finder, const VisionState& picture,
                           const Camera& camera, const NoiseModel& noise, const Watch& watch) {
  FindAnswer answer;
  // Every pixel, not the thinned picture: of a spool that is small or far off, each counts.
  const Result<PointCloud> pixels = back_project(*picture.frame, camera);
  if (!pixels) {
    answer.reason = pixels.error().message;
    return answer;
  }
  const PointCloud scan = measured_points(*pixels);
  const AlignRequest request{AlignMethod::kFind, {}, std::nullopt, &finder, 1, true};
  const Placement placement =
      place_scan(request, design->model, scan, typical_noise_m(scan, noise), watch);
  answer.reason = placement.reason;
  if (!placement.found) return answer;
  watch.report("fit", 0);
  std::vector<Pose> found{placement.T_design_scan};
  if (!placement.is_symmetric)
    found.insert(found.end(), placement.alternatives.begin(), placement.alternatives.end());
  FrameProcessor fitting(design, camera, noise);
  double best = 0;
  for (const Pose& T : found) {
    if (watch.cancelled()) return {};
    VisionStatePtr fitted = fitting.align(picture, T);
    if (!fitted->is_tracked() || is_known(finder, answer.poses, fitted->T_design_camera)) continue;
    best = std::max(best, fitted->agreement);
    answer.poses.push_back(std::move(fitted));
  }
  std::erase_if(answer.poses,
                [&](const VisionStatePtr& fitted) { return fitted->agreement < kRival * best; });
  if (answer.poses.empty())
    answer.reason =
        "Something like the design was found, but the picture shows through where its steel should "
        "be; look at the spool from another side, or pick three points.";
  return answer;
}

}  // namespace spool
