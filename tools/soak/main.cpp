// spoolsight-soak: plays a recording for an hour and says what became of memory and frame times.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <csignal>

#include "app/common/cli.h"
#include "app/sensor/depth_source.h"
#include "tools/soak/soak.h"

namespace {

std::atomic<bool> asked_to_end{false};  // set by signals
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

spool::Result<int> soak(const spool::soak::SoakRequest& request, bool whole_program) {
  std::signal(SIGTERM, [](int) { asked_to_end = true; });
  std::signal(SIGINT, [](int) { asked_to_end = true; });
  return whole_program ? spool::soak::soak_program(request) : spool::soak::soak_vision(request);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Plays a recording there and back for a long time; prints memory and frame times, and exits "
      "with 1 where memory grew or passed its budget.");
  spool::add_common_options(app, "spoolsight-soak");
  spool::soak::SoakRequest request;
  request.stop = &asked_to_end;
  app.add_option("design", request.design, "The design that the recording shows")->required();
  app.add_option("source", request.source,
                 "A depth folder (spoolsight-record makes one of an .oni file), or "
                 "simulated[:SCENE.json]")
      ->required();
  app.add_option("--minutes", request.minutes, "Of play-back")
      ->check(spool::positive_number())
      ->check(CLI::Range(0.01, 10'000.0))
      ->capture_default_str();
  const auto* real_time = app.add_flag("--real-time", request.real_time,
                                       "At the recording's own speed, not as fast as it goes");
  app.add_option("--program-script", request.script,
                 "Drive the program spoolsight itself, headless with its screens, by these taps "
                 "(TAPS.json)")
      ->excludes(const_cast<CLI::Option*>(real_time));
  return spool::run_program(app, argc, argv,
                            [&] { return soak(request, !request.script.empty()); });
}
