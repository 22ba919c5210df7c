// Pictures compared with those kept in tests/goldens.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/render/golden.h"

#include <cstdlib>
#include <optional>
#include <string_view>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "render/egl_context.h"
#include "tests/support/shared_data.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

std::optional<render::ImageLimits> limits_of(const std::filesystem::path& folder,
                                             const std::string& name) {
  const auto text = read_file(folder / "goldens.json");
  if (!text) return std::nullopt;
  const auto all = nlohmann::json::parse(*text, nullptr, false);
  if (!all.is_object() || !all.contains(name)) return std::nullopt;
  const auto& one = all[name];
  render::ImageLimits limits;
  limits.max_abs_diff = one.value("max_abs_diff", limits.max_abs_diff);
  limits.max_fraction = one.value("max_fraction", limits.max_fraction);
  limits.max_mean = one.value("max_mean", limits.max_mean);
  const render::ImageLimits usual;
  const bool looser = limits.max_abs_diff > usual.max_abs_diff ||
                      limits.max_fraction > usual.max_fraction || limits.max_mean > usual.max_mean;
  if (looser && one.value("reason", "").empty()) return std::nullopt;
  return limits;
}

}  // namespace

GoldenResult check_golden(const std::filesystem::path& folder, const std::filesystem::path& report,
                          const std::string& name, const render::Image& actual, bool update) {
  const auto limits = limits_of(folder, name);
  if (!limits) {
    return {false,
            name + " is not in goldens.json, or its limits are looser than usual without a reason"};
  }
  const auto path = folder / (name + ".png");
  if (update) {
    const Status written = render::write_png(path, actual);
    return {written.has_value(), written ? "" : written.error().message};
  }
  const auto keep = [&](const char* what, const render::Image& image) {
    return make_folder(report) && render::write_png(report / (name + "-" + what + ".png"), image);
  };
  const auto expected = render::read_png(path);
  if (!expected) {
    return {false, expected.error().message +
                       (keep("actual", actual) ? "; see " : "; not written to ") + report.string()};
  }
  const auto comparison = render::compare_images(actual, *expected, *limits);
  if (comparison.passed) return {true, comparison.summary()};
  bool kept = keep("actual", actual) && keep("expected", *expected);
  if (comparison.same_size) kept = keep("difference", comparison.difference) && kept;
  return {false, name + ": " + comparison.summary() + (kept ? "\nsee " : "\nnot written to ") +
                     report.string()};
}

void expect_golden(const std::string& name, const render::Image& actual) {
  const char* set = std::getenv("SPOOL_UPDATE_GOLDENS");
  const bool update = set != nullptr && std::string_view(set) == "1";
  const auto report = program("").parent_path().parent_path() / "goldens";
  const GoldenResult result =
      check_golden(source_dir() / "tests" / "goldens", report, name, actual, update);
  EXPECT_TRUE(result.passed) << result.text << "\ndrawn by " << render::gl_description();
}

}  // namespace spool::test
