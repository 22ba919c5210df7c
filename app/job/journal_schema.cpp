// Rows of journal.db and records, one into the other.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/journal_schema.h"

#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace spool::job {
namespace {

// Shortest text that reads back as the same double, separated by blanks.
template <std::size_t N>
void bind_list(Statement& insert, int at, const std::optional<std::array<double, N>>& numbers) {
  if (numbers)
    insert.bind(at, fmt::format("{}", fmt::join(*numbers, " ")));
  else
    insert.bind(at, std::optional<double>());
}

template <std::size_t N>
std::optional<std::array<double, N>> list_of(const std::string& text) {
  std::array<double, N> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (double& number : numbers) {
    while (at != end && *at == ' ') ++at;
    const auto [next, code] = std::from_chars(at, end, number);
    if (code != std::errc()) return std::nullopt;
    at = next;
  }
  return numbers;
}

}  // namespace

void bind_check(Statement& insert, const CheckRecord& record) {
  if (record.id > 0)
    insert.bind(1, record.id);
  else
    insert.bind(1, std::optional<double>());
  insert.bind(2, std::int64_t{record.step});
  insert.bind(3, record.part);
  insert.bind(4, record.joint);
  insert.bind(5, std::string(name(record.phase)));
  insert.bind(6, std::string(name(record.outcome)));
  insert.bind(7, record.status);
  insert.bind(8, record.remark);
  insert.bind(9, record.operator_name);
  insert.bind(10, record.override_reason);
  insert.bind(11, record.picture);
  insert.bind(12, record.report_sha256);
  insert.bind(13, std::optional(record.at.wall_s));
  insert.bind(14, std::optional(record.at.boot_s));
  insert.bind(15, record.at.boot);
  bind_list(insert, 16, record.T_design_part);
  bind_list(insert, 17, record.covariance);
}

void bind_number(Statement& insert, std::int64_t check, std::int64_t position,
                 const CheckNumber& number) {
  insert.bind(1, check);
  insert.bind(2, position);
  insert.bind(3, number.name);
  insert.bind(4, number.kind);
  insert.bind(5, number.unit);
  insert.bind(6, number.nominal);
  insert.bind(7, number.measured);
  insert.bind(8, number.deviation);
  insert.bind(9, number.u);
  insert.bind(10, number.tolerance);
  insert.bind(11, number.status);
}

std::optional<CheckRecord> check_of(const Statement& row) {
  const auto phase = parse_phase(row.text(4));
  const auto outcome = parse_outcome(row.text(5));
  if (!phase || !outcome) return std::nullopt;
  CheckRecord record;
  record.id = row.integer(0);
  record.step = static_cast<int>(row.integer(1));
  record.part = row.text(2);
  record.joint = row.text(3);
  record.phase = *phase;
  record.outcome = *outcome;
  record.status = row.text(6);
  record.remark = row.text(7);
  record.operator_name = row.text(8);
  record.override_reason = row.text(9);
  record.picture = row.text(10);
  record.report_sha256 = row.text(11);
  record.at = {row.number(12).value_or(0), row.number(13).value_or(0), row.text(14)};
  if (!row.is_null(15)) {
    record.T_design_part = list_of<16>(row.text(15));
    if (!record.T_design_part) return std::nullopt;
  }
  if (!row.is_null(16)) {
    record.covariance = list_of<36>(row.text(16));
    if (!record.covariance) return std::nullopt;
  }
  return record;
}

void bind_capture(Statement& insert, const CaptureRow& capture) {
  insert.bind(1, capture.number);
  insert.bind(2, capture.check_id);
  insert.bind(3, capture.entry_sha256);
  insert.bind(4, capture.signer);
  insert.bind(5, std::optional(capture.wall_s));
}

CaptureRow capture_of(const Statement& row) {
  return {row.integer(0), row.integer(1), row.text(2), row.text(3), row.number(4).value_or(0)};
}

CheckNumber number_of(const Statement& row) {
  return {row.text(2),   row.text(3),   row.text(4),   row.number(5), row.number(6),
          row.number(7), row.number(8), row.number(9), row.text(10)};
}

}  // namespace spool::job
