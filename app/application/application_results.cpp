// The results of the last check: kept as one of one state, shown as a list, as numbers, on the
// card.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/application/application.h"
#include "app/application/result_lines.h"

namespace spool {

// Everything that is said of one check belongs to its record, and its picture to its state.
void Application::keep_results(VisionStatePtr state,
                               std::shared_ptr<const evidence::InspectionRecord> record,
                               int step_part) {
  const DesignModel& design = in_.design->model;
  const Inspection& inspection = record->inspection;
  Results kept{
      std::move(state), std::move(record), evidence::result_rows(design, inspection), {}, {}};
  for (const evidence::ResultRow& row : kept.rows)
    kept.lines.push_back(result_line(design, inspection, row, in_.lengths));
  if (const auto row = evidence::deciding_row(kept.rows, inspection, step_part))
    kept.readout = result_detail(design, inspection, kept.rows[*row], in_.lengths);
  results_ = std::move(kept);
  picture_changed_ = false;
  list_open_ = false;
  if (screen_ == ui::Screen::kResults) open_results(-1, false);
}

// `row` -1: the list. `alone`: without the list, on the part that was tapped.
void Application::open_results(int row, bool alone) {
  if (!results_) return;
  if (screen_ != ui::Screen::kResults) results_eye_ = ViewControl();
  screen_ = ui::Screen::kResults;
  menu_open_ = false;
  open_row_ = row < static_cast<int>(results_->rows.size()) ? row : -1;
  row_alone_ = alone && open_row_ >= 0;
}

void Application::leave_results() {
  if (open_row_ >= 0 && !row_alone_) {
    open_row_ = -1;
    return;
  }
  screen_ = ui::Screen::kWork;
  open_row_ = -1;
}

// The worst row of a part that was tapped in the picture.
bool Application::open_results_of(int part) {
  if (!results_) return false;
  const auto row = evidence::worst_row_of(results_->rows, part);
  if (!row) return false;
  const bool alone = screen_ != ui::Screen::kResults || row_alone_;
  open_results(static_cast<int>(*row), alone);
  return true;
}

// What the check said is of the picture until the steel, the drawing or the step is another.
void Application::watch_results() {
  if (!results_ || picture_changed_ || !seen_ || !seen_->is_tracked()) return;
  picture_changed_ = seen_->alignment != results_->state->alignment ||
                     has_moved(results_->state->coverage.parts, seen_->coverage.parts);
}

void Application::drop_results() {
  results_.reset();
  if (screen_ == ui::Screen::kResults) screen_ = ui::Screen::kWork;
  open_row_ = -1;
}

bool Application::shows_readout() const {
  if (!results_ || !shows_pose()) return false;
  return shown() == results_->state || (!frozen_ && !picture_changed_);
}

std::string Application::age_of_results() const {
  if (shown() == results_->state && frozen_) return "Check of the frozen picture";
  const double seconds = state_ ? state_->frame->seconds - results_->state->frame->seconds : 0;
  return "Checked " + age_text(seconds);
}

void Application::fill_results(ui::ScreenState& out) const {
  out.has_results = results_.has_value();
  if (!results_) return;
  const Inspection& inspection = results_->record->inspection;
  ui::ResultsState& to = out.results;
  to.overall = mark_of(inspection.status);
  to.reason = inspection.status_reason;
  to.of = age_of_results();
  if (screen_ != ui::Screen::kResults) {
    out.readout_shown = shows_readout();
    out.readout = results_->readout;
    out.readout_of = fmt::format("{} · all {} results, the worst: {}", to.of, results_->rows.size(),
                                 ui::word(to.overall));
    return;
  }
  out.tracking = ui::TrackingMark::kFrozen;
  out.hint = "The picture is that of the check; Back goes on from where the camera is.";
  to.view_turned = results_eye_.is_started();
  to.open = open_row_;
  to.opened_alone = row_alone_;
  if (open_row_ < 0)
    to.lines = results_->lines;
  else
    to.detail = result_detail(in_.design->model, inspection,
                              results_->rows[static_cast<std::size_t>(open_row_)], in_.lengths);
}

// The whole of the checked picture beside the rows, or what the fitter turned it to.
render::View Application::results_view() const {
  if (results_eye_.is_started()) return results_eye_.view();
  return camera_view(results_ ? results_->state.get() : nullptr,
                     static_cast<int>(layout_.results_view.width),
                     static_cast<int>(layout_.results_view.height));
}

// The part or parts that the open row is of; of the list none.
std::array<int, 2> Application::lit_parts() const {
  if (screen_ != ui::Screen::kResults) return {lit_part_, -1};
  if (!results_ || open_row_ < 0) return {-1, -1};
  return results_->rows[static_cast<std::size_t>(open_row_)].parts;
}

}  // namespace spool
