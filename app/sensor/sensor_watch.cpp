// Whether a camera still tells what is before it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/sensor_watch.h"

#include <algorithm>
#include <cstddef>

namespace spool::sensor {

namespace {
constexpr double kPatience = 1.0;       // s: a person notices a picture that stands
constexpr double kStartPatience = 5.0;  // s: a camera that was just opened warms up
constexpr std::size_t kOneIn = 100;     // fewer pixels with depth than that: nothing is seen

bool shows_nothing(const DepthFrame& frame) {
  const auto measured = static_cast<std::size_t>(std::count_if(
      frame.depth.begin(), frame.depth.end(), [](std::uint16_t count) { return count != 0; }));
  return measured * kOneIn < frame.depth.size();
}

std::string mode_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

std::string words_of(SensorTrouble trouble, const std::string& wrong_mode) {
  switch (trouble) {
    case SensorTrouble::kSilent:
      return "No picture comes from the sensor: check its cable, the work goes on by itself.";
    case SensorTrouble::kStuck:
      return "The sensor repeats one picture: unplug it and plug it in again.";
    case SensorTrouble::kCovered:
      return "The sensor sees nothing: uncover its lens, or step back.";
    case SensorTrouble::kWrongMode:
      return "The sensor gives " + wrong_mode + ": unplug it and plug it in again.";
    case SensorTrouble::kNone:
      break;
  }
  return {};
}
}  // namespace

SensorWatch::SensorWatch(const Camera& camera, double now_s) : camera_(camera) { begin(now_s); }

void SensorWatch::begin(double now_s) {
  silent_from_s_ = now_s;
  patience_s_ = kStartPatience;
  last_.reset();
  same_from_s_.reset();
  covered_from_s_.reset();
  wrong_mode_.clear();
}

bool SensorWatch::see(const SourceOutput& output, double now_s) {
  is_news_ = false;
  switch (output.event) {
    case SourceEvent::kFrame:
      look_at(output.frame, now_s);
      break;
    case SourceEvent::kWrongMode:
      wrong_mode_ = output.text;
      silent_from_s_ = now_s;
      break;
    case SourceEvent::kUnplugged:
    case SourceEvent::kReplugged:
      is_plugged_ = output.event == SourceEvent::kReplugged;
      begin(now_s);
      break;
    case SourceEvent::kTimeout:
    case SourceEvent::kEnd:
      break;
  }
  const SensorTrouble found = judge(now_s);
  std::string words = words_of(found, wrong_mode_);
  if (found == trouble_ && words == words_) return false;
  trouble_ = found;
  words_ = std::move(words);
  return true;
}

void SensorWatch::look_at(const std::shared_ptr<const DepthFrame>& frame, double now_s) {
  silent_from_s_ = now_s;
  patience_s_ = kPatience;
  if (!frame->is_consistent() || frame->width != camera_.width || frame->height != camera_.height) {
    wrong_mode_ = mode_text(frame->width, frame->height) + " pictures and not " +
                  mode_text(camera_.width, camera_.height);
    return;
  }
  wrong_mode_.clear();
  const bool repeats = last_ && last_->depth == frame->depth;
  has_differed_ = has_differed_ || (last_ && !repeats);
  is_news_ = !repeats || !has_differed_;
  last_ = frame;
  if (!repeats)
    same_from_s_.reset();
  else if (!same_from_s_)
    same_from_s_ = now_s;
  if (!shows_nothing(*frame))
    covered_from_s_.reset();
  else if (!covered_from_s_)
    covered_from_s_ = now_s;
  // A covered lens repeats its empty picture, and that is to be said as it is: nothing is seen.
  is_news_ = is_news_ || covered_from_s_.has_value();
}

SensorTrouble SensorWatch::judge(double now_s) const {
  const auto lasts = [&](const std::optional<double>& since) {
    return since && now_s - *since >= kPatience;
  };
  if (!wrong_mode_.empty()) return SensorTrouble::kWrongMode;
  if (!is_plugged_) return SensorTrouble::kNone;
  if (now_s - silent_from_s_ >= patience_s_) return SensorTrouble::kSilent;
  if (lasts(covered_from_s_)) return SensorTrouble::kCovered;
  if (has_differed_ && lasts(same_from_s_) && !covered_from_s_) return SensorTrouble::kStuck;
  return SensorTrouble::kNone;
}

}  // namespace spool::sensor
