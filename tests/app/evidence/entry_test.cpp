// entry.json and the lists of files in it, of strangers.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/entry.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"

namespace spool::test {
namespace {

using evidence::parse_entry;

std::string entry_with(const std::string& key, const nlohmann::json& value) {
  nlohmann::json entry = {{"schema", "spoolsight-evidence/1"},
                          {"number", 1},
                          {"time_s", 1.0},
                          {"design", {{"file", "design.glb"}, {"sha256", "00"}}},
                          {"options", nlohmann::json::object()},
                          {"files", nlohmann::json::array()}};
  entry[key] = value;
  return entry.dump();
}

nlohmann::json file(const nlohmann::json& name) {
  return {{{"file", name}, {"bytes", 1}, {"sha256", "00"}, {"modified_s", 1.0}}};
}

TEST(EntryOfAStranger, IsReadWhereItIsOne) {
  const auto entry = parse_entry(entry_with("files", file("scan/000000.png")), "entry.json");
  ASSERT_TRUE(entry) << entry.error().message;
  EXPECT_EQ(entry->files[0].file, "scan/000000.png");
}

TEST(EntryOfAStranger, WithNamesThatLeadOutIsRefused) {
  for (const char* name : {"", "..", "../x", "a/../x", "/etc/passwd", "a//b", "a/", "./a", "."})
    expect_refused(parse_entry(entry_with("files", file(name)), "entry.json"), ErrorCode::kBadInput,
                   "entry.json", "not in its folder");
  expect_refused(parse_entry(entry_with("files", file(std::string("a\0b", 3))), "entry.json"),
                 ErrorCode::kBadInput, "entry.json", "not in its folder");
  expect_refused(parse_entry(entry_with("files", file(std::string(5000, 'a'))), "entry.json"),
                 ErrorCode::kBadInput, "entry.json", "not in its folder");
  expect_refused(parse_entry(entry_with("design", {{"file", "../d.glb"}}), "entry.json"),
                 ErrorCode::kBadInput, "entry.json", "design");
}

TEST(EntryOfAStranger, OfAnotherShapeIsRefused) {
  const nlohmann::json wrong[] = {nullptr, 7, "x", {{"a", 1}}, {1, 2}, -1.5};
  for (const char* key : {"schema", "time_s", "design", "options", "files"}) {
    for (const auto& value : wrong) {
      if (key == std::string("time_s") && value.is_number()) continue;
      EXPECT_FALSE(parse_entry(entry_with(key, value), "entry.json")) << key << " " << value;
    }
  }
  nlohmann::json deep = 1;
  std::string text(100000, '[');
  EXPECT_FALSE(parse_entry(text, "entry.json"));
  auto twice = file("a");
  twice.push_back(twice[0]);
  expect_refused(parse_entry(entry_with("files", twice), "entry.json"), ErrorCode::kBadInput,
                 "entry.json", "twice");
}

}  // namespace
}  // namespace spool::test
