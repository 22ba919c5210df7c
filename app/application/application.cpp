// The application's loop body: states and input in, one picture out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/application.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/application/picking.h"
#include "app/sensor/frame_ring.h"
#include "render/embedded_files.h"

namespace spool {

namespace {
constexpr double kNeutralLeast = 0.0005;  // m
constexpr float kFrameSeconds = 1.0F / 30.0F;
constexpr double kDesignFovDeg = 35.0;
constexpr double kDesignMargin = 0.05;  // of its size: marks at its edge stay in the picture
constexpr std::size_t kLandmarks = 12;  // three, and some to take instead
constexpr double kLegendRoomDp = 360;
constexpr double kLeastPointPx = 2.0;
constexpr double kMostPointPx = 12.0;
}  // namespace

Application::Application(ApplicationInputs inputs)
    : in_(std::move(inputs)),
      imgui_(ImGui::CreateContext(), [](ImGuiContext* context) { ImGui::DestroyContext(context); }),
      poses_(in_.design->model.origin),
      landmarks_(propose_landmarks(in_.design->model, *in_.design->surface, kLandmarks)),
      picks_(landmarks_.landmarks,
             [this](std::span<const PointPair> pairs) { return landmark_evidence(pairs); }),
      box_(in_.camera),
      gestures_(tap_slop_px(in_.dots_per_inch)),
      finder_(in_.design, in_.camera, in_.noise) {}

Application::~Application() {
  finder_.cancel();
  stop_distances_.request_stop();
  jobs_.wait();
  saving_.wait();
  feed_.reset();
  desk_.picture = {};
  picture_.reset();
}

Result<std::unique_ptr<Application>> Application::create(ApplicationInputs inputs) {
  std::unique_ptr<Application> app(new Application(std::move(inputs)));
  const ApplicationInputs& in = app->in_;
  const double dp = ui::pixels_per_dp(in.dots_per_inch);
  Result<ui::Theme> theme = ui::load_theme(render::embedded_file("font.otf").value_or(""), dp);
  if (!theme) return theme.error();
  app->theme_ = *theme;
  Result<Picture> picture = Picture::create(*in.design, in.width, in.height, dp);
  if (!picture) return picture.error();
  app->picture_ = std::make_unique<Picture>(std::move(*picture));
  if (const Status status = app->resize(in.width, in.height); !status) return status.error();
  Result<std::unique_ptr<Feed>> feed = in.open_feed();
  if (!feed) return feed.error();
  app->feed_ = std::move(*feed);
  if (!in.source_remark.empty()) app->notice(in.source_remark);
  app->start_distances();
  app->show_step();
  if (app->in_.job) app->picks_.clear();  // what is proposed is on the table
  return app;
}

Status Application::resize(int width, int height) {
  const render::Offscreen& now = picture_->target();
  if (layout_.work_view.width == width && layout_.work_view.height == height &&
      now.width() == width && now.height() == height) {
    return {};
  }
  in_.width = width;
  in_.height = height;
  layout_ = ui::lay_out(width, height, theme_.dp);
  design_eye_ = scan_eye_ = work_eye_ = ViewControl();
  detached_ = false;
  still_of_ = nullptr;  // drawn anew where it stands now
  picture_->drop_still();
  return picture_->resize(width, height);
}

void Application::take_notes() {
  while (const std::optional<SensorNote> note = feed_->note()) {
    switch (note->kind) {
      case SensorNote::Kind::kUnplugged:
        unplugged_ = true;
        replugged_ = false;
        lose_sensor();
        break;
      case SensorNote::Kind::kReplugged:
        replugged_ = true;
        break;
      case SensorNote::Kind::kTrouble:
        trouble_ = *note;
        if (!has_pictures()) lose_sensor();
        break;
      case SensorNote::Kind::kEnded:
        ended_ = true;
        break;
      case SensorNote::Kind::kFailed:
        ended_ = true;
        failure_ = note->error;
        lose_sensor();
        break;
    }
  }
}

std::optional<double> Application::advance() {
  VisionStatePtr next = feed_->poll();
  // Until the first picture since then, what is known is of before the plug was pulled.
  if (next && replugged_) unplugged_ = replugged_ = false;
  poses_.add(feed_->take_track());
  // Those of the frames that may be saved are needed all the same.
  if (!in_.keep_poses) poses_.keep_newest(sensor::FrameRingOptions{}.frames);
  take_notes();
  if (!next) return std::nullopt;
  const double before = state_ ? state_->frame->seconds : next->frame->seconds;
  const bool answered = awaiting_alignment_ && next->alignment >= alignments_asked_;
  state_ = std::move(next);
  if (!state_->is_out) seen_ = state_;
  bool was_moved = state_->was_moved;
  if (answered) {
    awaiting_alignment_ = false;
    aligned_ = state_->quality != TrackQuality::kUnaligned;
    if (aligned_) {
      was_moved = screen_ == ui::Screen::kWork;  // nobody asked for it but the spool
      leave_align();
    } else if (asked_by_ == AlignMethod::kFind) {
      refuse_found();
    }
  }
  if (state_->is_tracked()) last_tracked_ = state_;
  if (was_moved) notice("The spool was moved: aligned again where it lies now.");
  look_for_moved_spool();
  return std::max(0.0, state_->frame->seconds - before);
}

// Fingers that come down on a panel belong to it until they lift; all others make gestures.
void Application::route(const std::vector<ui::TouchEvent>& events) {
  std::vector<ui::TouchEvent> free;
  for (const ui::TouchEvent& event : events) {
    const bool ends = event.phase == ui::TouchPhase::kUp || event.phase == ui::TouchPhase::kCancel;
    if (event.phase == ui::TouchPhase::kDown && targets_.is_covered(event.x, event.y)) {
      panel_fingers_.insert(event.id);
    }
    const bool scrolls =
        event.phase == ui::TouchPhase::kWheel && targets_.is_covered(event.x, event.y);
    if (!panel_fingers_.contains(event.id) && !scrolls) free.push_back(event);
    if (ends) panel_fingers_.erase(event.id);
  }
  for (const ui::Gesture& gesture : gestures_.feed(free)) handle(gesture);
}

Status Application::frame(double now_s, const std::vector<ui::TouchEvent>& events,
                          const std::vector<ui::KeyPress>& keys) {
  now_s_ = now_s;
  if (in_.wait_for_jobs) {
    jobs_.wait();
    saving_.wait();
  }
  take_distances();
  take_checks();
  watch_results();
  take_captures();
  take_accepted();
  take_desk();
  take_saved();
  take_find();
  while (const std::optional<Error> error = write_errors_.try_pop()) fail(*error);
  for (const ui::TouchEvent& event : events) input_.push(event);
  const std::vector<ui::TouchEvent> batch = input_.take_frame();
  ui::follow(pointer_, batch);
  route(batch);

  for (const ui::KeyPress& key : keys)
    if (screen_ == ui::Screen::kTyping) end_typing(desk_.typing.press(key));

  ImGui::SetCurrentContext(imgui_.get());
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(in_.width), static_cast<float>(in_.height)};
  io.DeltaTime = kFrameSeconds;
  io.MousePos = pointer_.known
                    ? ImVec2(static_cast<float>(pointer_.x), static_cast<float>(pointer_.y))
                    : ImVec2(-FLT_MAX, -FLT_MAX);
  io.MouseDown[0] = pointer_.pressed;
  for (const ui::TouchEvent& event : batch) {
    if (event.phase == ui::TouchPhase::kWheel) io.MouseWheel += static_cast<float>(event.steps);
  }
  follow_readings();
  ImGui::NewFrame();
  const std::vector<ui::Command> commands =
      ui::draw_screen(screen_state(), theme_, layout_, targets_);
  ImGui::Render();

  if (Status status = update_still(); !status) return status;
  if (const VisionStatePtr& state = shown()) picture_->set_state(*state);
  if (Status status = picture_->draw(scenes(), *ImGui::GetDrawData()); !status) return status;
  if (pending_screen_) {
    const std::string file = std::move(*pending_screen_);
    pending_screen_.reset();
    save_screen(file);
  }
  for (const ui::Command& command : commands) handle(command);
  return {};
}

// While the spool is lost the last good view stands by as a small still, seen as the camera saw it.
Status Application::update_still() {
  const VisionStatePtr wanted = shows_still() ? last_tracked_ : nullptr;
  if (wanted == still_of_) return {};
  still_of_ = wanted;
  if (!wanted) {
    picture_->drop_still();
    return {};
  }
  ScenePicture scene;
  scene.rect = layout_.still;
  scene.view = camera_view(wanted.get(), static_cast<int>(layout_.still.width),
                           static_cast<int>(layout_.still.height));
  set_look(scene, *wanted);
  return picture_->keep_still(*wanted, scene);
}

// How a state's points are drawn. A point covers what its pixels see: in the camera's own picture
// the cloud has no gaps, and from nearer by the spacing at the middle of what was measured.
void Application::set_look(ScenePicture& scene, const VisionState& state) const {
  const double pixel = picture_->stride_px(state) / in_.camera.fx;  // as a slope
  scene.point_px = std::clamp(scene.view.camera.fx * pixel + 0.5, kLeastPointPx, kMostPointPx);
  // To a tenth of a millimetre, as the legend writes it.
  scene.neutral_m = std::max(kNeutralLeast, 1e-4 * std::round(1e4 * state.point_noise_m));
  if (state.scan.empty()) return;
  scene.point_spacing_m = pixel * static_cast<double>(state.scan.points[state.scan.size() / 2].z());
}

// Numbers of a live picture stand still until they changed; of one that is held they are its own.
void Application::follow_readings() {
  const VisionStatePtr& now = shown();
  if (!now || now == steady_of_) return;
  const bool afresh = !is_live() || !steady_of_ || steady_of_->alignment != now->alignment;
  steady_.follow(now->coverage.parts, afresh);
  steady_of_ = now;
}

// The pictures of the present screen; eyes that nobody moved yet are put where they belong.
std::vector<ScenePicture> Application::scenes() {
  const VisionStatePtr& state = shown();
  const auto whole = [](const ui::Rect& rect) {
    return std::pair(static_cast<int>(rect.width), static_cast<int>(rect.height));
  };
  std::vector<ScenePicture> out;
  if (screen_ == ui::Screen::kEvidence || screen_ == ui::Screen::kNcr ||
      screen_ == ui::Screen::kTyping)
    return out;  // words on a bare ground
  if (screen_ == ui::Screen::kAlign) {
    Eigen::AlignedBox3d bounds = in_.design->model.bounds();
    const Eigen::Vector3d margin =
        Eigen::Vector3d::Constant(kDesignMargin * bounds.diagonal().norm());
    bounds = Eigen::AlignedBox3d(bounds.min() - margin, bounds.max() + margin);
    const auto [width, height] = whole(layout_.design_view);
    if (!design_eye_.is_started()) {
      // As near to upright as the look allows: the axis of the design least along it points up.
      Eigen::Index up = 0;
      landmarks_.look.cwiseAbs().minCoeff(&up);
      const render::View view = render::view_of(bounds, landmarks_.look, Eigen::Vector3d::Unit(up),
                                                width, height, kDesignFovDeg);
      design_eye_.start(view, (view.T_camera_design * bounds.center()).z());
    }
    ScenePicture design;
    design.rect = layout_.design_view;
    design.view = design_eye_.view();
    design.show_cloud = false;
    design.markers = design_markers();
    if (const auto lit = picks_.lit()) design.lit_parts = {lit->part, -1};
    out.push_back(std::move(design));

    const auto [scan_width, scan_height] = whole(layout_.scan_view);
    if (!scan_eye_.is_started()) {
      render::View view;
      view.camera = render::camera_in_picture(in_.camera, scan_width, scan_height);
      scan_eye_.start(view, 1.0);
    }
    ScenePicture scan;
    scan.rect = layout_.scan_view;
    scan.view = scan_eye_.view();
    scan.of_scan = true;
    scan.show_cloud = state != nullptr;
    scan.markers = scan_markers();
    if (state) set_look(scan, *state);
    out.push_back(std::move(scan));
    return out;
  }
  const bool on_results = screen_ == ui::Screen::kResults;
  ScenePicture work;
  work.rect = on_results ? layout_.results_view : layout_.work_view;
  work.view = on_results ? results_view() : camera_view(state.get(), in_.width, in_.height);
  if (!shows_pose()) {  // no overlay at a pose that is not believed
    work.of_scan = true;
    work.show_cloud = state != nullptr;
    work.view.T_camera_design = Pose::Identity();
    if (state) set_look(work, *state);
    out.push_back(std::move(work));
    return out;
  }
  if (detached_ && !on_results) work.view = work_eye_.view();
  set_look(work, *state);
  work.show_cloud = on_results || view_mode_ == ViewMode::kBoth || view_mode_ == ViewMode::kScan;
  work.show_design = on_results || view_mode_ != ViewMode::kScan;
  work.show_patches = !on_results && view_mode_ == ViewMode::kSeen;
  if (const auto& target = state->coverage.advice.target; target && !on_results)
    work.markers.push_back({*target, render::Marker::Kind::kProposed, "next"});
  if (ghost_marker_ && !on_results) work.markers.push_back(*ghost_marker_);
  // Beside the rows only where there is room for it as well.
  work.show_legend = !on_results || (layout_.results_view.width >= kLegendRoomDp * theme_.dp &&
                                     layout_.results_view.height >= kLegendRoomDp * theme_.dp);
  if (in_.lengths == LengthStyle::kFeetInch) work.units = render::LengthDisplay::kFeetInch;
  work.lit_parts = lit_parts();
  work.legend_top_px = on_results ? 0 : layout_.strip.height;
  work.legend_bottom_px = on_results ? in_.height : layout_.legend_bottom;
  out.push_back(std::move(work));
  return out;
}

bool Application::is_idle() const {
  return input_.empty() && checks_open_ == 0 && saves_open_ == 0 && !pending_screen_ &&
         !awaiting_alignment_ && !find_.is_running() && captures_open_ == 0 && accepts_open_ == 0 &&
         desk_open_ == 0;
}

void Application::give_up_picks() {
  stop_find();  // nobody will choose
  if (!held_ || awaiting_alignment_) return;
  picks_.clear();
  release_picture();
}

}  // namespace spool
