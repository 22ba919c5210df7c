// The design's distances for the graphics card: made beside the start, handed to the picture when
// they are there.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "app/application/application.h"
#include "render/egl_context.h"
#include "vision/design/distance_field.h"
#include "vision/live/frame_processor.h"

namespace spool {

// Of a bare cloud, whose inside nobody knows, points are coloured by what vision measured. So they
// are where the processor draws: it would only do the same twice.
void Application::start_distances() {
  if (in_.design->model.is_cloud()) return;
  if (!in_.has_graphics_card.value_or(!render::draws_in_software())) return;
  jobs_.run([this, design = in_.design, stop = stop_distances_.get_token()] {
    // As far out as vision takes a point for the object's.
    const DistanceFieldOptions options{
        .band_m = static_cast<float>(FrameProcessorOptions{}.max_deviation_m)};
    auto made =
        make_distance_field(*design->surface, design->exterior.bounds(), options, Watch{stop, {}});
    if (made) static_cast<void>(distances_.push(std::move(*made)));
  });
}

// Where the driver has no room for them, points stay coloured by what vision measured.
void Application::take_distances() {
  const std::optional<DistanceVolume> made = distances_.try_pop();
  if (!made) return;
  if (const Status status = picture_->set_distances(*made, in_.camera); !status)
    notice(status.error().message);
}

}  // namespace spool
