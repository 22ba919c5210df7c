// A job's evidence on the screen: checks become captures, and what could not be waits to be again.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "app/application/application.h"
#include "app/application/result_lines.h"
#include "app/application/status_mark.h"
#include "app/common/length_text.h"
#include "vision/core/file_io.h"

namespace spool {

// Once a run, where nobody said it when the program was started.
void Application::ask_for_name() {
  if (screen_ != ui::Screen::kTyping) start_typing(std::nullopt);
}

// Written beside the screen, on the journal's thread; the check is kept until the answer is here.
void Application::capture(const CheckEvidencePtr& check) {
  const std::string& who = in_.job->operator_name();
  if (who.empty()) {
    uncaptured_.push_back(check);
    return;
  }
  ++captures_open_;
  jobs_.run([this, check, who] {
    const Status written = write_check(*check);
    static_cast<void>(captured_.push(
        {check, written
                    ? in_.job->journal().capture({check->folder, check->frame, check->part, who})
                    : Result<Captured>(written.error())}));
  });
}

void Application::capture_again() {
  if (!in_.job || uncaptured_.empty()) return;
  if (in_.job->operator_name().empty()) {
    ask_for_name();
    return;
  }
  for (const CheckEvidencePtr& check : std::exchange(uncaptured_, {})) capture(check);
}

void Application::take_captures() {
  while (std::optional<CaptureAnswer> answer = captured_.try_pop()) {
    --captures_open_;
    if (!answer->captured) {
      capture_error_ = answer->captured.error();
      uncaptured_.push_back(answer->check);
      continue;
    }
    const std::int64_t number = answer->captured->number;
    const std::string part = answer->captured->check.part, status = answer->captured->check.status;
    if (answer->check->asked == checks_asked_)
      in_.job->take_check(*std::move(answer->captured));
    else
      in_.job->take(std::move(answer->captured->journal));  // a newer look decides
    const std::string why = in_.job->why_not_accept();
    notice(fmt::format("{}: {}. Capture {}. {}", part, ui::word(mark_of_status(status)), number,
                       why.empty() ? "Accept it, or bump it and check again."
                                   : "Bump it or look again, then check."));
  }
}

// Why a check is not in the evidence yet and what to do; empty: all are.
std::string Application::uncaptured_in_words() const {
  if (uncaptured_.empty()) return {};
  const std::string what = uncaptured_.size() == 1
                               ? "Check not captured"
                               : fmt::format("{} checks are not captured", uncaptured_.size());
  if (in_.job->operator_name().empty()) return what + ": say who checked, press Capture.";
  if (!capture_error_ || capture_error_->code != ErrorCode::kIo)
    return fmt::format("{}: {}", what, capture_error_ ? capture_error_->message : "");
  return fmt::format("{}: {}, press Capture.", what, disk_in_words());
}

// Why a folder of the job cannot be written, as far as that can be told, and what to do.
std::string Application::disk_in_words() const {
  constexpr double kMega = 1e6, kFull_mb = 64;
  std::error_code code;
  const auto space = std::filesystem::space(in_.job->job().folder(), code);
  const double free_mb = static_cast<double>(space.available) / kMega;
  if (!code && free_mb < kFull_mb)
    return fmt::format("the disk is full ({:.0f} MB free). Free space", free_mb);
  return "the disk cannot be written. See to the job's folder";
}

void Application::handle_evidence(const ui::Command& command) {
  if (!in_.job) return;
  switch (command.action) {
    case ui::Action::kCaptureAgain:
      capture_again();
      break;
    case ui::Action::kEvidence:
      desk_.back_to = screen_;
      desk_.first = 0;
      desk_.opened = 0;
      menu_open_ = false;
      screen_ = ui::Screen::kEvidence;
      break;
    case ui::Action::kOpenCapture:
      open_capture(command.value);
      break;
    case ui::Action::kTurnPage:
      if (screen_ == ui::Screen::kNcr)
        desk_.form.turn(command.value);
      else
        desk_.first += command.value * ui::sheet_rows(layout_, theme_.dp, ui::kRowDp);
      break;
    case ui::Action::kNcr:
      open_form();
      break;
    case ui::Action::kTypeField:
      start_typing(command.value);
      break;
    case ui::Action::kChooseField:
      desk_.form.choose(command.value, command.part);
      keep_draft();
      break;
    case ui::Action::kWriteNcr:
      write_form();
      break;
    case ui::Action::kLeave:
      leave_evidence();
      break;
    case ui::Action::kKey:
      desk_.typing.type(static_cast<char32_t>(command.value));
      break;
    case ui::Action::kKeyRole:
      end_typing(desk_.typing.press(static_cast<ui::KeyRole>(command.value)));
      break;
    default:
      break;
  }
}

void Application::leave_evidence() {
  if (screen_ == ui::Screen::kNcr) {
    screen_ = ui::Screen::kEvidence;
  } else if (desk_.opened != 0) {
    desk_.opened = 0;
    desk_.picture = {};
  } else {
    screen_ = desk_.back_to;
  }
}

namespace {

const job::CheckRecord* check_of(const JournalView& journal, const job::CaptureRow& row) {
  const auto at = std::ranges::find(journal.records, row.check_id, &job::CheckRecord::id);
  return at == journal.records.end() ? nullptr : &*at;
}

const job::CaptureRow* capture_of(const JournalView& journal, std::int64_t number) {
  const auto at = std::ranges::find(journal.captures, number, &job::CaptureRow::number);
  return at == journal.captures.end() ? nullptr : &*at;
}

ui::CaptureLine line_of(const JournalView& journal, const job::CaptureRow& row) {
  ui::CaptureLine line;
  line.number = static_cast<int>(row.number);
  const job::CheckRecord* check = check_of(journal, row);
  if (check == nullptr) return line;
  line.title = fmt::format("{} · step {} · {}", row.number, check->step, check->part);
  if (!check->joint.empty()) line.title += " · " + check->joint;
  line.status = mark_of_status(check->status);
  constexpr std::size_t kDate = 10, kTime = 11, kMinutes = 5;
  const std::string at = job::utc_text(row.wall_s);
  const std::string time = at.size() < kTime + kMinutes
                               ? at
                               : at.substr(0, kDate) + " " + at.substr(kTime, kMinutes) + " UTC";
  line.detail = fmt::format("{} · {} · {}", time, check->operator_name,
                            row.signer.empty() ? "not signed" : "signed");
  return line;
}

std::string amount(const job::CheckNumber& number, double value, LengthStyle style,
                   bool with_sign) {
  return with_minus(quantity_text(value, number.unit == "rad", style, with_sign));
}

// What is out first, then what cannot be told, then by how far it is off against its limit.
std::vector<ui::CaptureNumber> numbers_of(const job::CheckRecord& check, LengthStyle style) {
  constexpr double kCoverage = 2;  // times the standard uncertainty
  std::vector<const job::CheckNumber*> numbers;
  for (const job::CheckNumber& each : check.numbers) numbers.push_back(&each);
  const auto rank = [](const job::CheckNumber& number) {
    const ui::StatusMark mark = mark_of_status(number.status);
    return mark == ui::StatusMark::kNotOk        ? 0
           : mark == ui::StatusMark::kSuspicious ? 1
           : mark == ui::StatusMark::kOk         ? 2
                                                 : 3;
  };
  const auto share = [](const job::CheckNumber& number) {
    return number.deviation && number.tolerance.value_or(0) > 0
               ? std::abs(*number.deviation) / *number.tolerance
               : 0.0;
  };
  std::ranges::stable_sort(numbers, [&](const job::CheckNumber* a, const job::CheckNumber* b) {
    return rank(*a) != rank(*b) ? rank(*a) < rank(*b) : share(*a) > share(*b);
  });
  std::vector<ui::CaptureNumber> out;
  for (const job::CheckNumber* number : numbers) {
    ui::CaptureNumber line{mark_of_status(number->status),
                           dimension_title(number->kind, number->name), ""};
    line.text = number->deviation ? amount(*number, *number->deviation, style, true)
                                  : std::string(ui::word(line.status));
    if (number->deviation && number->u)
      line.text += " ± " + amount(*number, kCoverage * *number->u, style, false);
    if (number->tolerance)
      line.text += " (limit ± " + amount(*number, *number->tolerance, style, false) + ")";
    out.push_back(std::move(line));
  }
  if (out.empty())
    out.push_back({ui::StatusMark::kNotMeasured, "see the picture and the report",
                   "No dimension of it was measured"});
  return out;
}

}  // namespace

void Application::open_capture(std::int64_t number) {
  const job::CaptureRow* row = capture_of(in_.job->view(), number);
  const job::CheckRecord* check = row != nullptr ? check_of(in_.job->view(), *row) : nullptr;
  if (check == nullptr) return;
  desk_.opened = number;
  desk_.picture = {};
  desk_.picture_words = check->picture.empty() ? "There is no picture." : "";
  if (check->picture.empty()) return;
  ++desk_open_;
  jobs_.run([this, number, path = in_.job->job().folder() / "evidence" / check->picture] {
    constexpr std::uint64_t kMostBytes = std::uint64_t{64} << 20U;
    const Result<std::string> png = read_file(path, kMostBytes);
    Result<render::Image> image =
        png ? render::decode_png(*png) : Result<render::Image>(png.error());
    static_cast<void>(desk_answers_.push(CapturePicture{number, std::move(image)}));
  });
}

void Application::take_desk() {
  while (std::optional<DeskAnswer> answer = desk_answers_.try_pop()) {
    --desk_open_;
    if (auto* shown = std::get_if<CapturePicture>(&*answer)) {
      if (shown->number != desk_.opened) continue;  // another was opened meanwhile
      Result<render::ImageTexture> texture =
          shown->image ? render::ImageTexture::create(*shown->image)
                       : Result<render::ImageTexture>(shown->image.error());
      if (texture)
        desk_.picture = std::move(*texture);
      else
        desk_.picture_words = texture.error().message;
    } else if (auto* opened = std::get_if<OpenedForm>(&*answer)) {
      take_form(std::move(*opened));
    } else if (const auto* written = std::get_if<WrittenForm>(&*answer)) {
      take_written(*written);
    } else if (const auto* saved = std::get_if<SavedDraft>(&*answer); !saved->status) {
      desk_.said = "The draft is kept until the program ends only: " + disk_in_words() + ".";
      desk_.said_warns = true;
    }
  }
}

void Application::fill_evidence(ui::ScreenState& out) const {
  if (!in_.job) return;
  out.has_evidence = true;
  out.can_capture_again = !uncaptured_.empty();
  if (out.can_capture_again && screen_ == ui::Screen::kWork) {
    out.hint = uncaptured_in_words();
    out.hint_is_warning = true;
    out.notice.clear();  // what just happened is less than what waits
  }
  if (screen_ == ui::Screen::kNcr) fill_form(out);
  if (screen_ == ui::Screen::kTyping) {
    out.typing = desk_.typing.state();
    out.hint = out.typing.label;
  }
  if (screen_ != ui::Screen::kEvidence) return;
  const JournalView& journal = in_.job->view();
  ui::EvidenceState& evidence = out.evidence;
  const int count = static_cast<int>(journal.captures.size());
  const int rows = ui::sheet_rows(layout_, theme_.dp, ui::kRowDp);
  const int first = std::clamp(desk_.first, 0, std::max(0, count - 1));
  const int end = std::min(count, first + rows);
  for (int i = first; i < end; ++i)
    evidence.lines.push_back(
        line_of(journal, journal.captures[static_cast<std::size_t>(count - 1 - i)]));
  evidence.page = fmt::format("{} to {} of {}, newest first", first + 1, end, count);
  evidence.can_go_newer = first > 0;
  evidence.can_go_older = end < count;
  out.hint = count == 0 ? "No captures yet: every Check makes one."
                        : "Tap a capture for its picture and numbers.";
  const job::CaptureRow* opened = capture_of(journal, desk_.opened);
  const job::CheckRecord* check = opened != nullptr ? check_of(journal, *opened) : nullptr;
  if (check == nullptr) return;
  evidence.opened = {line_of(journal, *opened)};
  evidence.numbers = numbers_of(*check, in_.lengths);
  evidence.picture = desk_.picture.id();
  evidence.picture_width = desk_.picture.width();
  evidence.picture_height = desk_.picture.height();
  evidence.picture_words = desk_.picture_words;
  out.hint = "NCR fills the form from this capture.";
}

}  // namespace spool
