// Whether a camera still tells what is before it: silence, repeats, a covered lens, another mode.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/sensor/depth_source.h"

namespace spool::sensor {

// What is wrong with a camera that is plugged in. An unplugged one has events of its own.
enum class SensorTrouble {
  kNone,
  kSilent,    // no picture comes
  kStuck,     // the same picture comes again and again
  kCovered,   // pictures of nothing
  kWrongMode  // pictures of another size or depth unit than it was opened with
};

// Of cameras only: a recording waits, ends and repeats as it likes. One thread at a time; what time
// it is is said by the caller, in seconds on a clock that never goes back.
//
// Two pictures of a structured-light sensor never agree to the last bit, for its noise; those of a
// simulated scene without noise do while the camera stands. So a camera counts as stuck only after
// it has given two pictures that differ.
class SensorWatch {
 public:
  SensorWatch(const Camera& camera, double now_s);

  // Takes what next() gave. True where trouble() is another than before.
  bool see(const SourceOutput& output, double now_s);

  // The frame that was just seen tells something: of the right mode, and not the one before again.
  [[nodiscard]] bool is_news() const { return is_news_; }
  [[nodiscard]] SensorTrouble trouble() const { return trouble_; }
  // What is wrong and what to do, one sentence for a screen; empty where nothing is.
  [[nodiscard]] const std::string& words() const { return words_; }

 private:
  void begin(double now_s);
  void look_at(const std::shared_ptr<const DepthFrame>& frame, double now_s);
  [[nodiscard]] SensorTrouble judge(double now_s) const;

  Camera camera_;
  std::shared_ptr<const DepthFrame> last_;  // of the right mode
  bool has_differed_ = false;               // two of its pictures did
  bool is_plugged_ = true;
  bool is_news_ = false;
  std::string wrong_mode_;                // how the newest picture is other than it should be
  double silent_from_s_ = 0;              // no frame since
  double patience_s_ = 0;                 // how long that is no trouble
  std::optional<double> same_from_s_;     // the picture repeats since
  std::optional<double> covered_from_s_;  // it shows nothing since
  SensorTrouble trouble_ = SensorTrouble::kNone;
  std::string words_;
};

}  // namespace spool::sensor
