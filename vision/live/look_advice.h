// What the fitter may do so that more of the spool is known: closer, slower, the other side.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "vision/core/camera.h"
#include "vision/design/design_model.h"
#include "vision/design/design_surface.h"
#include "vision/live/coverage_state.h"
#include "vision/live/next_view.h"
#include "vision/live/patch_readings.h"

namespace spool {

// Why a patch that faces the camera, in its picture, does not become known.
enum class LookTrouble { kNone, kHidden, kTooNear, kTooBright, kTooFast, kTooFar, kTooStill };
inline constexpr std::size_t kLookTroubles = 7;

// Counts, over the patches in sight that are not known yet, why; says the trouble that more than a
// third of them have, and keeps to it until fewer have, both beyond chance. Where what is in sight
// is known, where to look next. One thread.
class LookAdviser {
 public:
  LookAdviser(const DesignModel& design, const DesignSurface& surface, const Camera& camera,
              const NoiseModel& noise);

  void clear();
  // `readings` hold the frame already. `next`: from where to look next.
  [[nodiscard]] LookAdvice advise(const VisionState& state, const PatchReadings& readings,
                                  const std::optional<NextLook>& next);

  [[nodiscard]] LookTrouble trouble() const { return said_; }

 private:
  [[nodiscard]] std::optional<LookTrouble> trouble_of(const VisionState& state,
                                                      const PatchReadings& readings,
                                                      std::size_t patch,
                                                      const Pose& T_camera_design) const;
  void count(const VisionState& state, const PatchReadings& readings);
  [[nodiscard]] std::string words_for(const NextLook& next, const Pose& T_design_camera);

  const DesignModel& design_;
  const DesignSurface& surface_;
  Camera camera_;
  NoiseModel noise_;
  std::array<double, kLookTroubles> counts_{};  // of late, patches not known
  double in_sight_ = 0;                         // of late, known or not
  double frames_ = 0;                           // of late
  double last_s_ = 0;
  LookTrouble said_ = LookTrouble::kNone;
  bool says_next_ = false;
  std::size_t way_ = 0;  // that was said last
};

}  // namespace spool
