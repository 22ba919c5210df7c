// spoolsight-record: any source to an .oni file or a depth folder.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <csignal>
#include <iostream>
#include <stop_token>
#include <string>

#include "app/common/cli.h"
#include "app/common/progress.h"
#include "app/sensor/depth_source.h"
#include "app/sensor/recorder.h"

namespace spool {
namespace {

std::atomic<bool> interrupted{
    false};  // set by the signal handler: Ctrl-C ends a recording properly

struct Arguments {
  std::string source, out;
  double speed = 0;
  std::int64_t first_frame = 0;
  sensor::RecordOptions limits;
};

Result<int> record(const Arguments& arguments) {
  auto source = sensor::open_source(
      arguments.source, {.speed = arguments.speed, .first_frame = arguments.first_frame});
  if (!source) return source.error();
  std::signal(SIGINT, [](int) { interrupted = true; });
  std::signal(SIGTERM, [](int) { interrupted = true; });
  Progress progress;
  std::stop_source stop;
  Watch watch;
  watch.stop = stop.get_token();
  watch.progress = [&](std::string_view stage, double fraction) {
    progress.report(stage, fraction);
    if (interrupted) stop.request_stop();
  };
  const auto recorded = sensor::record(**source, arguments.out, arguments.limits, watch);
  if (!recorded) return recorded.error();
  std::cout << arguments.out << ": " << recorded->frames << " frames, " << recorded->seconds
            << " s, from " << (*source)->description() << "\n";
  return 0;
}

}  // namespace
}  // namespace spool

int main(int argc, char** argv) {
  CLI::App app("Records a camera, a recording or the simulator; Ctrl-C ends the recording.");
  spool::add_common_options(app, "spoolsight-record");
  spool::Arguments arguments;
  app.add_option("source", arguments.source,
                 "openni[:URI], FILE.oni, a depth folder or simulated[:SCENE.json]")
      ->required();
  app.add_option("--out", arguments.out, "FILE.oni, or a new folder for a depth folder")
      ->required();
  app.add_option("--frames", arguments.limits.frames, "End after so many frames")
      ->check(spool::positive_number());
  app.add_option("--seconds", arguments.limits.seconds, "End after so many seconds")
      ->check(spool::positive_number());
  app.add_option("--first-frame", arguments.first_frame, "Of a recording: skip the frames before")
      ->check(spool::non_negative_number());
  app.add_option("--speed", arguments.speed,
                 "Of a recording: 1 is real time, 2 twice as fast, 0 as fast as it is read")
      ->check(spool::non_negative_number());
  return spool::run_program(app, argc, argv, [&] { return spool::record(arguments); });
}
