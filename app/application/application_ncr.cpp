// The form of a non-conformance report on the screen, and what is typed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "app/application/application.h"
#include "app/evidence/capture.h"
#include "app/ncr/fill_form.h"
#include "app/ncr/ncr_writer.h"

namespace spool {

namespace {

// The document as the command line makes it: of the job and of the capture's own report.
Result<ncr::NcrDocument> document_of(const job::Job& job, std::int64_t capture,
                                     const ncr::OperatorInput& input) {
  auto evidence = ncr::read_evidence(job.folder() / "evidence" / evidence::entry_name(capture),
                                     job.file().design_sha256);
  if (!evidence) return evidence.error();
  return ncr::fill_form(job, job.folder(), *std::move(evidence), input);
}

}  // namespace

// The form of the capture that is open: as it was left in this run, or in the job, else new.
void Application::open_form() {
  if (desk_.opened == 0) return;
  ++desk_open_;
  desk_.said.clear();
  const ncr::OperatorInput input{
      in_.job->operator_name(), {}, job::utc_text(job::now().wall_s), in_.lengths};
  jobs_.run([this, number = desk_.opened, input] {
    const job::Job& job = in_.job->job();
    const Result<ncr::NcrDocument> document = document_of(job, number, input);
    OpenedForm opened{number, Error{}, ncr::read_draft(job.folder(), number)};
    if (document)
      opened.form = document->form;
    else
      opened.form = document.error();
    static_cast<void>(desk_answers_.push(std::move(opened)));
  });
}

void Application::take_form(OpenedForm opened) {
  if (!opened.form) {
    desk_.picture_words = opened.form.error().message;
    desk_.picture = {};
    return;
  }
  if (screen_ != ui::Screen::kEvidence || opened.number != desk_.opened) return;
  ncr::NcrDraft draft = std::move(opened.draft);
  if (const auto here = desk_.drafts.find(opened.number); here != desk_.drafts.end())
    draft = here->second;  // newer than the disk's, or the same
  if (draft.shop.empty()) draft.shop = desk_.shop;
  desk_.form.open(*std::move(opened.form), std::move(draft));
  screen_ = ui::Screen::kNcr;
}

void Application::start_typing(std::optional<int> field) {
  desk_.typing_back = screen_;
  desk_.typed_field = field;
  desk_.typing.start(field ? desk_.form.ask(*field)
                           : TypingAsk{.label = "Your name",
                                       .help = "who checked, for the evidence; asked once",
                                       .text = "",
                                       .most_bytes = evidence::kMaxNameBytes});
  screen_ = ui::Screen::kTyping;
}

void Application::end_typing(TypingSession::End end) {
  if (end == TypingSession::End::kNone) return;
  screen_ = desk_.typing_back;
  if (end == TypingSession::End::kCancelled) return;
  const std::string text = desk_.typing.text();
  if (!desk_.typed_field) {
    in_.job->set_operator_name(text);
    if (!text.empty()) capture_again();
    return;
  }
  if (*desk_.typed_field == NcrSession::kShopField) {
    if (!text.empty() && !ncr::number_prefix(in_.job->job().folder(), text)) {
      desk_.said = "The shop is part of the number: A-Z, a-z, 0-9 and . _ - only.";
      desk_.said_warns = true;
      return;
    }
    desk_.shop = text;
  }
  desk_.form.set(*desk_.typed_field, text);
  keep_draft();
}

// Here at once, and in the job beside the screen: a program that ends takes nothing along.
void Application::keep_draft() {
  desk_.said.clear();
  const ncr::NcrDraft& draft = desk_.form.draft();
  desk_.drafts[draft.capture] = draft;
  ++desk_open_;
  jobs_.run([this, draft] {
    static_cast<void>(
        desk_answers_.push(SavedDraft{ncr::write_draft(in_.job->job().folder(), draft)}));
  });
}

void Application::write_form() {
  if (!desk_.form.is_open() || desk_.is_writing) return;
  const ncr::NcrDraft& draft = desk_.form.draft();
  const Result<std::string> prefix = ncr::number_prefix(in_.job->job().folder(), draft.shop);
  if (!prefix) {
    desk_.said = draft.shop.empty() ? "Say the shop first, on page 1: it is part of the number."
                                    : prefix.error().message;
    desk_.said_warns = true;
    return;
  }
  desk_.is_writing = true;
  ++desk_open_;
  const ncr::OperatorInput input{in_.job->operator_name(), draft.fields,
                                 job::utc_text(job::now().wall_s), in_.lengths};
  jobs_.run([this, input, prefix = *prefix, number = draft.capture] {
    const job::Job& job = in_.job->job();
    const Result<ncr::NcrDocument> document = document_of(job, number, input);
    Result<ncr::Issued> issued = document ? ncr::write_ncr(*document, job.folder(), prefix)
                                          : Result<ncr::Issued>(document.error());
    if (issued) ncr::remove_draft(job.folder(), number);
    static_cast<void>(desk_answers_.push(WrittenForm{number, std::move(issued)}));
  });
}

void Application::take_written(const WrittenForm& written) {
  desk_.is_writing = false;
  desk_.said_warns = !written.issued;
  if (!written.issued) {
    const Error& error = written.issued.error();
    desk_.said = fmt::format("Not written, what you filled in is kept: {}{}",
                             error.code == ErrorCode::kIo ? disk_in_words() : error.message,
                             error.code == ErrorCode::kIo ? ", then press Write again." : "");
    return;
  }
  desk_.drafts.erase(written.number);
  if (desk_.form.draft().capture == written.number) desk_.form.close();
  desk_.said = fmt::format("{} is written: PDF, HTML, JSON and BCF are in {}.",
                           written.issued->number, written.issued->folder.string());
}

void Application::fill_form(ui::ScreenState& out) const {
  ui::FormState& form = out.form;
  desk_.form.fill(ui::sheet_rows(layout_, theme_.dp, ui::kFormRowDp), form);
  form.can_write = desk_.form.is_open();
  form.is_writing = desk_.is_writing;
  form.foot = desk_.said;
  form.foot_warns = desk_.said_warns;
  if (!desk_.form.is_open()) form.title = "Written";
  out.hint = !form.foot.empty() ? form.foot : "Tap a field to fill it in; Write makes the report.";
  if (form.foot.empty()) form.foot = out.hint;
}

}  // namespace spool
