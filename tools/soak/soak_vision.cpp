// A soak of vision alone.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <optional>
#include <vector>

#include <unistd.h>

#include "app/sensor/depth_source.h"
#include "tools/soak/long_recording.h"
#include "tools/soak/soak.h"
#include "tools/soak/soak_log.h"
#include "vision/design/design_reader.h"
#include "vision/live/find_in_picture.h"
#include "vision/live/frame_processor.h"

namespace spool::soak {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLines = 12;            // of the table, in the whole run
constexpr int kPicturesToFind = 90;   // three seconds; then it is not there
constexpr double kSampleEvery = 1.0;  // s

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Frame times (s). Room for all is made, and used, beforehand: what it holds does not grow.
class FrameTimes {
 public:
  explicit FrameTimes(double planned_s) {
    constexpr double kMostFps = 120;
    all_.assign(static_cast<std::size_t>(kMostFps * planned_s) + 1, 1.0F);
    all_.clear();
  }
  void add(double seconds) { all_.push_back(static_cast<float>(seconds)); }
  [[nodiscard]] std::size_t count() const { return all_.size(); }
  // p50, p99 and most of those from the `from`-th on, ms.
  [[nodiscard]] std::string text(std::size_t from) const {
    std::vector<float> some(all_.begin() + static_cast<std::ptrdiff_t>(from), all_.end());
    if (some.empty()) return "none";
    std::sort(some.begin(), some.end());
    const auto at = [&](double share) {
      const auto rank = static_cast<std::size_t>(share * static_cast<double>(some.size()));
      return 1e3 * double{some[std::min(rank, some.size() - 1)]};
    };
    char text[64];
    std::snprintf(text, sizeof text, "%6.2f / %6.2f / %7.2f", at(0.5), at(0.99), at(1));
    return text;
  }

 private:
  std::vector<float> all_;
};

class VisionSoak {
 public:
  VisionSoak(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
             const SoakRequest& request)
      : design_(std::move(design)),
        camera_(camera),
        vision_(design_, camera, noise_),
        planned_s_(60 * request.minutes),
        memory_(planned_s_),
        times_(planned_s_) {}

  // False once enough was played.
  Result<bool> take(std::shared_ptr<const DepthFrame> frame) {
    const double seconds = frame->seconds;
    if (!first_s_) first_s_ = seconds;
    const auto before = Clock::now();
    auto state = vision_.process(std::move(frame));
    times_.add(seconds_since(before));
    if (!state) return state.error();
    const double played = seconds - *first_s_;
    note(**state, played);
    if (!is_aligned_)
      if (const Status found = find(**state); !found) return found.error();
    shown_ = *std::move(state);  // as the screen holds it while the next one is made
    return played < planned_s_;
  }

  [[nodiscard]] int finish() const {
    std::printf("\nplayed %.1f min, %zu frames of %dx%d in %.1f min\n", played_s_ / 60,
                times_.count(), camera_.width, camera_.height, seconds_since(start_) / 60);
    std::printf("frame ms p50 / p99 / most: %s\n", times_.text(0).c_str());
    std::printf("good %zu, poor %zu, lost %zu\n", count("good"), count("poor"), count("lost"));
    return print_verdict(memory_);
  }

 private:
  [[nodiscard]] std::size_t count(const char* quality) const {
    const auto found = qualities_.find(quality);
    return found == qualities_.end() ? 0 : found->second;
  }

  Status find(const VisionState& state) {
    const FindAnswer answer = find_in_picture(design_, *design_->finder, state, camera_, noise_);
    if (!answer.poses.empty()) {
      const Pose& T = answer.poses.front()->T_design_camera;
      is_aligned_ = vision_.align(state, T)->is_tracked();
    }
    if (is_aligned_ || times_.count() < kPicturesToFind) return {};
    return Error{ErrorCode::kBadInput,
                 "the design is not found in the first pictures: " + answer.reason};
  }

  void note(const VisionState& state, double played_s) {
    played_s_ = played_s;
    // The first frames have no pose yet.
    if (is_aligned_) ++qualities_[std::string(name(state.quality))];
    if (played_s >= sample_at_s_) {
      sample_at_s_ = played_s + std::min(kSampleEvery, planned_s_ / 100);
      if (const auto resident = resident_memory(::getpid())) memory_.add(played_s, *resident);
    }
    if (played_s < line_at_s_) return;
    if (told_ == 0)
      std::printf(
          "| play-back min | frames | frame ms p50 / p99 / most | resident MiB | map cells "
          "| good / poor / lost |\n|---|---|---|---|---|---|\n");
    line_at_s_ = played_s + planned_s_ / kLines;
    std::printf("| %6.2f | %7zu | %s | %7.1f | %7zu | %zu / %zu / %zu |\n", played_s / 60,
                times_.count(), times_.text(told_).c_str(), memory_.samples().back().mib,
                state.map_cells, count("good"), count("poor"), count("lost"));
    std::fflush(stdout);
    told_ = times_.count();
  }

  std::shared_ptr<const PreparedDesign> design_;
  Camera camera_;
  NoiseModel noise_;
  FrameProcessor vision_;
  double planned_s_;
  MemoryLog memory_;
  FrameTimes times_;
  VisionStatePtr shown_;
  bool is_aligned_ = false;
  std::map<std::string, std::size_t> qualities_;  // frames that ended so, since it was found
  std::optional<double> first_s_;
  double played_s_ = 0, sample_at_s_ = 0, line_at_s_ = 0;
  std::size_t told_ = 0;  // frames in the lines so far
  Clock::time_point start_ = Clock::now();
};

}  // namespace

Result<int> soak_vision(const SoakRequest& request) {
  std::optional<LongRecording> recording;
  std::string source_text = request.source;
  if (sensor::is_recording_path(request.source)) {
    auto made = LongRecording::make(request.source, 60 * request.minutes);
    if (!made) return made.error();
    recording.emplace(*std::move(made));
    source_text = recording->folder().string();
  }
  auto source = sensor::open_source(source_text, {.speed = request.real_time ? 1.0 : 0.0});
  if (!source) return source.error();
  auto model = read_design(request.design);
  if (!model) return model.error();
  const auto design = PreparedDesign::prepare(*std::move(model), 1, true);
  if (!design) return design.error();
  VisionSoak soak(*design, (*source)->camera(), request);
  for (bool goes_on = true; goes_on && !*request.stop;) {
    const auto output = (*source)->next(std::chrono::milliseconds(100));
    if (!output) return output.error();
    if (output->event == sensor::SourceEvent::kEnd) break;
    if (output->event != sensor::SourceEvent::kFrame) continue;
    const Result<bool> taken = soak.take(output->frame);
    if (!taken) return taken.error();
    goes_on = *taken;
  }
  return soak.finish();
}

}  // namespace spool::soak
