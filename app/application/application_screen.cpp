// What the screen says: words, numbers and marks of the state that is shown.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/application/application.h"
#include "app/application/result_lines.h"

namespace spool {

namespace {
// Less of a part seen than this share says nothing of the part.
constexpr double kSeenShare = 0.05;
constexpr std::size_t kChips = 3;

ui::TrackingMark mark_of(TrackQuality quality) {
  switch (quality) {
    case TrackQuality::kGood:
      return ui::TrackingMark::kGood;
    case TrackQuality::kPoor:
      return ui::TrackingMark::kPoor;
    case TrackQuality::kPaused:
      return ui::TrackingMark::kPaused;
    case TrackQuality::kLost:
      return ui::TrackingMark::kLost;
    case TrackQuality::kUnaligned:
      break;
  }
  return ui::TrackingMark::kNone;
}

// What the strip says in the place of the camera's name.
const char* word(sensor::SensorTrouble trouble) {
  switch (trouble) {
    case sensor::SensorTrouble::kSilent:
      return "no picture";
    case sensor::SensorTrouble::kStuck:
      return "sensor stuck";
    case sensor::SensorTrouble::kCovered:
      return "lens covered";
    case sensor::SensorTrouble::kWrongMode:
      return "wrong mode";
    case sensor::SensorTrouble::kNone:
      break;
  }
  return "";
}

const char* name(ui::Screen screen) {
  switch (screen) {
    case ui::Screen::kAlign:
      return "align";
    case ui::Screen::kChoose:
      return "choose";
    case ui::Screen::kResults:
      return "results";
    case ui::Screen::kEvidence:
      return "evidence";
    case ui::Screen::kNcr:
      return "ncr";
    case ui::Screen::kTyping:
      return "typing";
    case ui::Screen::kWork:
      break;
  }
  return "work";
}

nlohmann::json to_json(const ui::Rect& rect) { return {rect.x, rect.y, rect.width, rect.height}; }

nlohmann::json to_json(const render::View& view) {
  const auto pose = row_major(view.T_camera_design);
  return {{"fx", view.camera.fx},
          {"fy", view.camera.fy},
          {"cx", view.camera.cx},
          {"cy", view.camera.cy},
          {"T_view_world", pose}};
}
}  // namespace

// From where the camera saw the design; of a state without a pose its own frame.
render::View Application::camera_view(const VisionState* state, int width, int height) const {
  render::View view;
  view.camera = render::camera_in_picture(in_.camera, width, height);
  if (state != nullptr && state->is_tracked()) {
    view.T_camera_design = state->T_design_camera.inverse();
  }
  return view;
}

// The camera gives pictures of what is before it.
bool Application::has_pictures() const {
  switch (trouble_.trouble) {
    case sensor::SensorTrouble::kSilent:
    case sensor::SensorTrouble::kStuck:
    case sensor::SensorTrouble::kWrongMode:
      return false;
    case sensor::SensorTrouble::kNone:
    case sensor::SensorTrouble::kCovered:
      break;
  }
  return !unplugged_ && !failure_;
}

// The overlay belongs to a live picture, or to one that is held on purpose: without pictures nobody
// knows where camera and steel are by now.
bool Application::shows_pose() const {
  const VisionStatePtr& state = shown();
  return state && state->is_tracked() && (!is_live() || has_pictures());
}

bool Application::shows_still() const {
  const VisionStatePtr& state = shown();
  return screen_ == ui::Screen::kWork && state && !shows_pose() &&
         state->quality != TrackQuality::kUnaligned && last_tracked_ && layout_.still.height >= 1;
}

std::vector<render::Marker> Application::design_markers() const {
  std::vector<render::Marker> out;
  for (const PointPair& pair : picks_.pairs()) {
    out.push_back(
        {pair.design.cast<float>(), render::Marker::Kind::kPicked, std::to_string(out.size() + 1)});
  }
  if (const auto lit = picks_.lit(); lit && picks_.pairs().size() < kChips) {
    out.push_back({lit->position.cast<float>(), render::Marker::Kind::kProposed,
                   std::to_string(out.size() + 1)});
  }
  return out;
}

std::vector<render::Marker> Application::scan_markers() const {
  std::vector<render::Marker> out;
  for (const PointPair& pair : picks_.pairs()) {
    out.push_back(
        {pair.scan.cast<float>(), render::Marker::Kind::kScan, std::to_string(out.size() + 1)});
  }
  if (const auto corner = box_.first())
    out.push_back({*corner, render::Marker::Kind::kProposed, "corner"});
  return out;
}

ui::ScreenState Application::screen_state() const {
  ui::ScreenState out;
  const DesignModel& design = in_.design->model;
  out.screen = screen_;
  out.title =
      !design.spool.empty() ? design.spool : std::filesystem::path(design.path).stem().string();
  // A path's last part says enough on a strip.
  out.source = trouble_.trouble != sensor::SensorTrouble::kNone ? word(trouble_.trouble)
               : unplugged_
                   ? "sensor unplugged"
                   : in_.source_description.substr(in_.source_description.find_last_of('/') + 1);
  out.unit = in_.lengths == LengthStyle::kFeetInch ? "ft-in" : "mm";
  out.source_is_well = !unplugged_ && !failure_ && trouble_.words.empty();
  out.can_replay = in_.is_recording && ended_ && !held_;
  if (now_s_ < notice_until_s_) out.notice = notice_;
  if (state_)
    out.tracking = frozen_                                   ? ui::TrackingMark::kFrozen
                   : has_pictures() || !state_->is_tracked() ? mark_of(state_->quality)
                                                             : ui::TrackingMark::kLost;
  out.menu_open = menu_open_;
  fill_job(out);
  switch (screen_) {
    case ui::Screen::kAlign:
      fill_align(out);
      break;
    case ui::Screen::kChoose:
      fill_choose(out);
      break;
    case ui::Screen::kWork:
      fill_work(out);
      fill_results(out);
      break;
    case ui::Screen::kResults:
      fill_results(out);
      break;
    case ui::Screen::kEvidence:
    case ui::Screen::kNcr:
    case ui::Screen::kTyping:
      break;  // fill_evidence()
  }
  fill_evidence(out);
  // What is wrong with the sensor comes before everything else.
  if (failure_) {
    out.hint = failure_->message;
    out.hint_is_warning = true;
  } else if (!trouble_.words.empty()) {
    out.hint = trouble_.words;
    out.hint_is_warning = true;
  } else if (unplugged_) {
    out.hint = "The sensor is unplugged: plug it in again, the work goes on by itself.";
    out.hint_is_warning = true;
  } else if (state_ && state_->is_out && is_live()) {
    out.hint = state_->hint;
    out.hint_is_warning = true;
  } else if (!state_) {
    out.hint = "Waiting for the first picture of the sensor.";
  }
  return out;
}

void Application::fill_align(ui::ScreenState& out) const {
  const std::vector<PointPair>& pairs = picks_.pairs();
  const PairsAlignment& result = picks_.result();
  for (std::size_t i = 0; i < std::max(kChips, pairs.size()); ++i) {
    ui::PairChip chip;
    chip.set = i < pairs.size();
    chip.current = i == pairs.size();
    if (chip.set && i < result.residual_m.size())
      chip.residual = length_text(result.residual_m[i], in_.lengths);
    out.chips.push_back(chip);
  }
  const bool search_speaks = fill_find(out);
  const bool box_speaks = fill_box(out);
  out.can_skip = picks_.can_skip() && !awaiting_alignment_ && !out.finding;
  out.can_undo = picks_.can_undo() && !awaiting_alignment_;
  out.can_finish =
      result.status == PairsStatus::kOk && pairs.size() >= kChips && !awaiting_alignment_;
  out.can_go_back = aligned_ && !awaiting_alignment_;
  const auto lit = picks_.lit();
  if (awaiting_alignment_) {
    out.hint = "Fitting the drawing to the steel.";
  } else if (box_speaks) {
    // Said by fill_box().
  } else if (search_speaks) {
    // Said by fill_find().
  } else if (pairs.size() >= kChips && result.status != PairsStatus::kOk) {
    out.hint = result.reason;
    out.hint_is_warning = true;
    out.proposed = "Undo, then pick again.";
  } else if (out.can_finish) {
    const bool refused =
        state_ && !state_->hint.empty() && state_->quality == TrackQuality::kUnaligned;
    out.hint = refused ? state_->hint : "Three points fit: press Done, or Undo to pick again.";
    out.hint_is_warning = refused;
  } else if (picks_.is_refused()) {
    const auto other = picks_.lit_after_skip();
    out.hint = other && lit
                   ? "No depth there: tap beside it, or press Other point for " + other->text + "."
                   : "No depth there: tap beside it, or tap another point of the drawing.";
    out.hint_is_warning = true;
  } else if (lit) {
    out.hint =
        fmt::format("{}oint {}: find {} and tap it in the camera picture.",
                    pairs.empty() && out.can_find ? "Press Find, or pick three points. P" : "P",
                    pairs.size() + 1, lit->text);
    out.proposed = "Not to be seen there? Press Other point, or tap another one of the drawing.";
  } else {
    out.hint = "Tap a point of the drawing, then the same point in the camera picture.";
  }
  if (!out.notice.empty() && !out.hint_is_warning) out.proposed = out.notice;
}

namespace {

// Of each part's surface, the share that any frame showed. Without patches: what is known of it.
std::vector<double> seen_shares(const CoverageState& coverage) {
  std::vector<double> seen(coverage.parts.size(), 0), all(coverage.parts.size(), 0);
  if (coverage.patches == nullptr) {
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = coverage.parts[i].coverage;
    return seen;
  }
  const std::vector<SurfacePatch>& patches = coverage.patches->all();
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const auto part = static_cast<std::size_t>(patches[k].part);
    all[part] += double{patches[k].area_m2};
    if (coverage.sight[k] != PatchSight::kNotSeen) seen[part] += double{patches[k].area_m2};
  }
  for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = all[i] > 0 ? seen[i] / all[i] : 0;
  return seen;
}

}  // namespace

void Application::fill_work(ui::ScreenState& out) const {
  static constexpr const char* kViewWords[] = {"both", "scan", "drawing", "seen"};
  const VisionStatePtr& state = shown();
  out.aligned = aligned_;
  out.can_find = can_find();
  out.measured = shows_pose();
  out.frozen = frozen_ != nullptr;
  out.still_shown = shows_still();
  out.detached = detached_ && out.measured;
  out.view_word = kViewWords[static_cast<int>(view_mode_)];
  out.sight_shown = out.measured && view_mode_ == ViewMode::kSeen;
  out.list_open = list_open_;
  out.lit_part = lit_part_;
  out.checking = checks_open_ > 0;
  if (last_check_) std::tie(out.overall, out.overall_reason) = *last_check_;
  if (state) {
    out.hint = state->hint;
    out.hint_is_warning = !state->hint.empty();
    out.point_noise = length_text(state->point_noise_m, in_.lengths);
  }
  if (frozen_) {
    out.hint = "Frozen: look as long as you like; Live goes on from where the camera is.";
    out.hint_is_warning = false;
  }
  if (out.hint.empty() && results_ && picture_changed_ && out.measured)
    out.hint = "It is not as it was checked any more: press Check again.";
  if (out.hint.empty() && state) out.hint = state->coverage.advice.text;
  if (out.hint.empty())
    out.hint = out.step_part.empty() ? "Look where it matters, then press Check."
                                     : out.step_part + ". Press Check when it sits.";
  if (!out.measured) return;
  const std::vector<Part>& parts = in_.design->model.parts;
  const std::vector<double> shares = seen_shares(state->coverage);
  const std::vector<PartReading>& readings = steady_.held();
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (in_.job && !on_table_[i]) continue;
    const PartReading& part = readings[i];
    const bool seen = part.is_seen && shares[i] >= kSeenShare;
    ui::PartLine line;
    line.part = static_cast<int>(i);
    line.name = parts[i].name;
    line.status = seen ? ui::StatusMark::kSuspicious : ui::StatusMark::kNotMeasured;
    line.number = with_minus(signed_length_text(part.mean_m, in_.lengths));
    line.doubt = "± " + length_text(part.u_m, in_.lengths);
    line.side = part.mean_m < 0 ? "inside" : "outside";
    line.seen = fmt::format("{:.0f} %", 100 * shares[i]);
    out.parts.push_back(std::move(line));
  }
  const int first = in_.job ? in_.job->part() : -1;  // what the present step is about
  std::stable_sort(out.parts.begin(), out.parts.end(),
                   [first, &readings](const ui::PartLine& a, const ui::PartLine& b) {
                     if ((a.part == first) != (b.part == first)) return a.part == first;
                     const bool a_seen = a.status != ui::StatusMark::kNotMeasured;
                     const bool b_seen = b.status != ui::StatusMark::kNotMeasured;
                     if (a_seen != b_seen) return a_seen;
                     return std::abs(readings[static_cast<std::size_t>(a.part)].mean_m) >
                            std::abs(readings[static_cast<std::size_t>(b.part)].mean_m);
                   });
}

std::string Application::changed_targets() {
  nlohmann::json json;
  json["screen"] = name(screen_);
  json["width"] = in_.width;
  json["height"] = in_.height;
  json["tracking"] = !state_          ? "none"
                     : has_pictures() ? name(state_->quality)
                                      : name(TrackQuality::kLost);
  if (const std::string box = box_in_words(); !box.empty()) json["box"] = box;
  if (in_.job) json["step"] = in_.job->step_words();
  if (frozen_) json["frozen_frame"] = frozen_->frame->index;
  json["picks"] = picks_.pairs().size();
  if (still_of_) {
    json["still"] = {{"frame", still_of_->frame->index}, {"rect", to_json(layout_.still)}};
  }
  json["find"] = {{"phase", name(find_.phase())},
                  {"percent", 10 * std::lround(10 * find_.progress().share)}};
  if (find_.shown()) {
    json["find"]["choice"] = find_.choice();
    json["find"]["choices"] = find_.choices();
  }
  const ui::ScreenState said = screen_state();
  json["hint"] = said.hint;
  if (said.readout_shown) {
    json["readout"] = {{"status", ui::word(said.readout.status)},
                       {"name", said.readout.name},
                       {"number", said.readout.number}};
  }
  if (screen_ == ui::Screen::kResults) {
    json["results"] = {{"open", open_row_}, {"rows", results_ ? results_->rows.size() : 0}};
    for (const int part : lit_parts())
      if (part >= 0)
        json["results"]["lit"].push_back(
            in_.design->model.parts[static_cast<std::size_t>(part)].name);
    json["results"]["view"] = to_json(results_view());
    json["results"]["view"]["rect"] = to_json(layout_.results_view);
  }
  json["targets"] = nlohmann::json::object();
  for (const ui::Target& target : targets_.targets)
    json["targets"][target.name] = to_json(target.rect);
  if (screen_ == ui::Screen::kAlign) {
    json["design_view"] = to_json(design_eye_.view());
    json["design_view"]["rect"] = to_json(layout_.design_view);
    json["scan_view"] = to_json(scan_eye_.view());
    json["scan_view"]["rect"] = to_json(layout_.scan_view);
    if (held_) json["held_frame"] = held_->frame->index;
    if (const auto lit = picks_.lit()) {
      const Eigen::Vector3d p = lit->position + in_.design->model.origin;
      json["lit"] = {{"text", lit->text}, {"position_m", {p.x(), p.y(), p.z()}}};
    }
  }
  std::string text = json.dump();
  if (text == last_targets_) return {};
  last_targets_ = text;
  return text;
}

}  // namespace spool
