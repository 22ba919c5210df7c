// spoolsight: the design over the live depth cloud, in a window or headless.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "app/application/application.h"
#include "app/application/tap_script.h"
#include "app/common/cli.h"
#include "app/window.h"
#include "render/egl_context.h"
#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"

namespace spool {
namespace {

constexpr double kFrameSeconds = 1.0 / 30.0;
constexpr double kWindowWait = 0.008;  // s: how long a finger may wait to be seen

std::atomic<bool> asked_to_end{false};  // set by signals
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

struct Flags {
  std::string design, job, operator_name, source, script, track, design_unit, size = "1280x800";
  std::string units = "mm";
  std::string out = "out";
  double dots_per_inch = 0;  // 0: the monitor's own, 160 headless
  bool headless = false, print_targets = false;
};

struct Size {
  int width = 0, height = 0;
};

Result<Size> parse_size(const std::string& text) {
  Size size;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) != 2 ||
      size.width < 320 || size.height < 320 || size.width > 8192 || size.height > 8192) {
    return Error{ErrorCode::kUsage,
                 "--size " + text + ": give WIDTHxHEIGHT in px, 320x320 to 8192x8192"};
  }
  return size;
}

Result<ApplicationInputs> prepare(const Flags& flags) {
  std::optional<LengthUnit> unit;
  if (!flags.design_unit.empty()) {
    unit = parse_length_unit(flags.design_unit);
    if (!unit)
      return Error{ErrorCode::kUsage, "--design-unit " + flags.design_unit + ": give m, mm or in"};
  }
  std::unique_ptr<JobSession> job;
  if (!flags.job.empty()) {
    Result<JobSession> opened = JobSession::open(flags.job, flags.operator_name);
    if (!opened) return opened.error();
    job = std::make_unique<JobSession>(std::move(*opened));
  }
  Result<DesignModel> model =
      job ? Result<DesignModel>(job->job().design()) : read_design(flags.design, unit);
  if (!model) return model.error();
  for (const std::string& warning : model->warnings) spdlog::warn("{}", warning);
  Result<std::shared_ptr<const PreparedDesign>> design = PreparedDesign::prepare(std::move(*model));
  if (!design) return design.error();

  ApplicationInputs in;
  in.design = *design;
  in.job = std::move(job);
  in.source_text = flags.source;
  in.out = flags.out;
  if (flags.units == "ft-in") in.lengths = LengthStyle::kFeetInch;
  in.keep_poses = !flags.track.empty();
  const Result<Size> size = parse_size(flags.size);
  if (!size) return size.error();
  in.width = size->width;
  in.height = size->height;
  const sensor::SourceOptions options{.speed = flags.headless ? 0.0 : 1.0};
  // The first source tells what it is; a replay opens another.
  Result<std::unique_ptr<sensor::DepthSource>> first = sensor::open_source(flags.source, options);
  if (!first) return first.error();
  in.camera = (*first)->camera();
  in.source_description = (*first)->description();
  in.source_remark = (*first)->remark();
  if (!in.source_remark.empty()) spdlog::info("{}", in.source_remark);
  in.is_recording = (*first)->is_recording();
  in.wait_for_jobs = flags.headless && in.is_recording;
  const bool lock_step = in.wait_for_jobs;
  auto opened = std::make_shared<std::unique_ptr<sensor::DepthSource>>(std::move(*first));
  in.open_feed = [=, design = in.design, camera = in.camera, noise = in.noise,
                  text = flags.source]() -> Result<std::unique_ptr<Feed>> {
    std::unique_ptr<sensor::DepthSource> source = std::move(*opened);
    if (!source) {
      auto again = sensor::open_source(text, options);
      if (!again) return again.error();
      source = std::move(*again);
    }
    FrameProcessor processor(design, camera, noise);
    return lock_step ? make_lock_step_feed(std::move(source), std::move(processor))
                     : make_live_feed(std::move(source), std::move(processor));
  };
  return in;
}

void print_targets(const Flags& flags, Application& app) {
  if (!flags.print_targets) return;
  if (const std::string line = app.changed_targets(); !line.empty()) {
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
  }
}

// What is left to do when nobody looks any more.
Result<int> end(const Flags& flags, Application& app) {
  const Status finished = app.finish();
  if (!flags.track.empty()) {
    if (const Status written = app.poses().write(flags.track); !written) return written.error();
  }
  if (!finished) return finished.error();
  spdlog::info("pictures and evidence are in {}", flags.out);
  if (app.failure()) return *app.failure();
  return 0;
}

Result<int> run_headless(const Flags& flags, TapScript script) {
  Result<render::EglContext> context = render::EglContext::surfaceless();
  if (!context) return context.error();
  Result<ApplicationInputs> inputs = prepare(flags);
  if (!inputs) return inputs.error();
  if (flags.dots_per_inch > 0) inputs->dots_per_inch = flags.dots_per_inch;
  const int width = inputs->width, height = inputs->height;
  const bool recording = inputs->is_recording;
  const bool scripted = !flags.script.empty();
  Result<std::unique_ptr<Application>> app = Application::create(std::move(*inputs));
  if (!app) return app.error();

  const auto start = std::chrono::steady_clock::now();
  double now = 0;
  while (!asked_to_end) {
    const std::optional<double> passed = (*app)->advance();
    if (recording) {
      // A recording's own time while it runs, the screen's while it waits.
      now += passed.value_or(kFrameSeconds);
    } else {
      now = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    if (const Status drawn = (*app)->frame(now, script.until(now, width, height)); !drawn) {
      return drawn.error();
    }
    print_targets(flags, **app);
    if ((*app)->failure()) break;
    if (script.is_finished() && (*app)->is_idle()) {
      if (recording) (*app)->give_up_picks();
      if (recording ? (*app)->source_has_ended() : scripted) break;
    }
    if (!recording) std::this_thread::sleep_for(std::chrono::duration<double>(0.5 * kFrameSeconds));
  }
  return end(flags, **app);
}

Result<int> run_window(const Flags& flags, TapScript script) {
  const Result<Size> size = parse_size(flags.size);
  if (!size) return size.error();
  Result<Window> window = Window::open("SpoolSight", size->width, size->height);
  if (!window) return window.error();
  Result<ApplicationInputs> inputs = prepare(flags);
  if (!inputs) return inputs.error();
  inputs->width = window->width();
  inputs->height = window->height();
  const double measured = window->dots_per_inch();
  if (measured > 0) inputs->dots_per_inch = measured;
  if (flags.dots_per_inch > 0) inputs->dots_per_inch = flags.dots_per_inch;
  Result<std::unique_ptr<Application>> app = Application::create(std::move(*inputs));
  if (!app) return app.error();

  const auto start = std::chrono::steady_clock::now();
  while (!asked_to_end && !window->should_close()) {
    std::vector<ui::TouchEvent> events = window->events(kWindowWait);
    const int width = window->width(), height = window->height();
    if (width <= 0 || height <= 0) continue;  // put away
    if (const Status resized = (*app)->resize(width, height); !resized) return resized.error();
    static_cast<void>((*app)->advance());
    const double now =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (const ui::TouchEvent& event : script.until(now, width, height)) events.push_back(event);
    if (const Status drawn = (*app)->frame(now, events, window->keys()); !drawn)
      return drawn.error();
    (*app)->picture().target().show(width, height);
    window->swap();
    print_targets(flags, **app);
  }
  return end(flags, **app);
}

Result<int> run(const Flags& flags) {
  std::signal(SIGTERM, [](int) { asked_to_end = true; });
  std::signal(SIGINT, [](int) { asked_to_end = true; });
  TapScript script;
  if (!flags.script.empty()) {
    Result<TapScript> read = TapScript::read(flags.script);
    if (!read) return read.error();
    script = std::move(*read);
  }
  return flags.headless ? run_headless(flags, std::move(script))
                        : run_window(flags, std::move(script));
}

}  // namespace
}  // namespace spool

int main(int argc, char** argv) {
  spool::Flags flags;
  CLI::App app(
      "Shows the design of a pipe spool over what a depth camera sees, coloured by deviation.");
  spool::add_common_options(app, "spoolsight");
  CLI::Option* design =
      app.add_option("--design", flags.design, "Design: .glb .gltf .pcf .stl .obj .ply .pcd .xyz");
  CLI::Option* job =
      app.add_option("--job", flags.job,
                     "JOB.spooljob: works on its steps, every check into its journal and evidence "
                     "(spoolsight-job makes one)")
          ->excludes(design);
  app.add_option("--operator", flags.operator_name,
                 "Who works, for journal and evidence; else the screen asks at the first check")
      ->needs(job);
  CLI::Option_group* what = app.add_option_group("what is built");
  what->add_options(design, job);
  what->require_option(1);
  app.add_option("--source", flags.source,
                 "openni[:URI] | FILE.oni | DEPTH_FOLDER | simulated[:SCENE.json]")
      ->required();
  app.add_option("--design-unit", flags.design_unit,
                 "m, mm or in, where the design's file does not say");
  app.add_option("--units", flags.units,
                 "Lengths on the screen and in the reports of checks: mm or ft-in")
      ->check(CLI::IsMember({"mm", "ft-in"}))
      ->capture_default_str();
  app.add_option("--out", flags.out, "Folder for pictures and evidence")->capture_default_str();
  app.add_option("--dpi", flags.dots_per_inch, "Dots an inch of the screen, where it does not say")
      ->check(spool::positive_number())
      ->check(CLI::Range(40.0, 1200.0));
  app.add_option("--size", flags.size, "Window or picture, WIDTHxHEIGHT in px")
      ->capture_default_str();
  app.add_flag("--headless", flags.headless,
               "Draw without a display; a recording is played frame by frame");
  app.add_option(
      "--script", flags.script,
      "TAPS.json: fingers on the glass, by time, as fractions of the window; a tap where "
      "--print-targets has Find looks for the spool");
  app.add_option("--track", flags.track, "poses.csv: where the camera was in every frame");
  app.add_flag("--print-targets", flags.print_targets,
               "Print what can be tapped and where, one line of JSON whenever it changes");
  return spool::run_program(app, argc, argv, [&] { return spool::run(flags); });
}
