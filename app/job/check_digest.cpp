// SHA-256 over checks as the journal has them: what a capture says that all before it were.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/check_digest.h"

#include <iterator>

#include <fmt/format.h>

#include "vision/core/file_digest.h"

namespace spool::job {
namespace {

class Text {
 public:
  void add(std::string_view text) {
    fmt::format_to(std::back_inserter(bytes_), "{}:{},", text.size(), text);
  }
  void add(std::int64_t number) { add(std::to_string(number)); }
  void add(double number) { add(fmt::format("{}", number)); }
  void add(const std::optional<double>& number) {
    if (number)
      add(*number);
    else
      add("NULL");
  }
  template <std::size_t N>
  void add(const std::optional<std::array<double, N>>& numbers) {
    add(static_cast<std::int64_t>(numbers ? N : 0));
    if (!numbers) return;
    for (const double number : *numbers) add(number);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

void add(const CheckRecord& record, Text& text) {
  text.add(record.id);
  text.add(static_cast<std::int64_t>(record.step));
  text.add(record.part);
  text.add(record.joint);
  text.add(name(record.phase));
  text.add(name(record.outcome));
  text.add(record.status);
  text.add(record.remark);
  text.add(record.operator_name);
  text.add(record.override_reason);
  text.add(record.picture);
  text.add(record.report_sha256);
  text.add(record.at.wall_s);
  text.add(record.at.boot_s);
  text.add(record.at.boot);
  text.add(record.T_design_part);
  text.add(record.covariance);
  text.add(static_cast<std::int64_t>(record.numbers.size()));
  for (const CheckNumber& number : record.numbers) {
    text.add(number.name);
    text.add(number.kind);
    text.add(number.unit);
    text.add(number.nominal);
    text.add(number.measured);
    text.add(number.deviation);
    text.add(number.u);
    text.add(number.tolerance);
    text.add(number.status);
  }
}

}  // namespace

std::string checks_sha256(std::span<const CheckRecord> records) {
  Text text;
  for (const CheckRecord& record : records) add(record, text);
  return sha256_hex(text.bytes());
}

}  // namespace spool::job
