// The vision thread.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/runner/vision_runner.h"

#include <chrono>
#include <utility>

namespace spool {

namespace {
constexpr std::chrono::milliseconds kFrameWait{
    20};  // how long a command may have to wait for its turn
}  // namespace

VisionStatePtr obey(FrameProcessor& processor, const VisionCommand& command) {
  switch (command.kind) {
    case VisionCommand::Kind::kAlign:
      return processor.align(*command.held, command.T_design_camera);
    case VisionCommand::Kind::kForget:
      processor.forget();
      break;
  }
  return nullptr;
}

TrackRow track_row(const VisionState& state) {
  return {state.frame->index, state.frame->seconds, state.quality, state.T_design_camera};
}

VisionRunner::VisionRunner(FrameProcessor processor, const VisionPorts& ports)
    : processor_(std::move(processor)),
      ports_(ports),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

VisionRunner::~VisionRunner() = default;

void VisionRunner::command(VisionCommand command) {
  static_cast<void>(commands_.push(std::move(command)));  // never closed while the runner lives
}

void VisionRunner::publish(VisionStatePtr state) {
  static_cast<void>(ports_.track.push(track_row(*state)));
  ports_.states.put(std::move(state));
}

void VisionRunner::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    while (std::optional<VisionCommand> command = commands_.try_pop()) {
      if (VisionStatePtr state = obey(processor_, *command)) publish(std::move(state));
    }
    std::optional<FramePtr> frame = ports_.frames.take(kFrameWait);
    if (!frame) continue;
    Result<VisionStatePtr> state = processor_.process(std::move(*frame));
    if (state) {
      publish(std::move(*state));
    } else {
      static_cast<void>(ports_.notes.push({SensorNote::Kind::kFailed, state.error()}));
    }
  }
}

}  // namespace spool
