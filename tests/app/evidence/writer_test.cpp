// An inspection's folder: complete, or as it was before.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/writer.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/app/evidence/sample_record.h"
#include "tests/support/points_ply.h"
#include "tests/support/temporary_folder.h"
#include "vision/core/file_io.h"

namespace spool::evidence {
namespace {

namespace fs = std::filesystem;

OverlayPicture picture(int number) {
  OverlayPicture one{"overlay_" + std::to_string(number) + ".png", "seen from +x", {}};
  one.image.width = 2;
  one.image.height = 2;
  one.image.rgba.assign(16, 200);
  return one;
}

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    files.insert(entry.path().filename().string());
  return files;
}

TEST(WriteInspection, WritesAllFilesAndNothingElse) {
  const test::TemporaryFolder folder;
  const fs::path out = folder.path() / "a" / "b";  // made where it is not there
  ASSERT_TRUE(write_inspection(out, test::sample_record(), {picture(1), picture(2)}));
  EXPECT_EQ(files_in(out), (std::set<std::string>{"overlay_1.png", "overlay_2.png", "points.ply",
                                                  "report.html", "report.json"}));
}

TEST(WriteInspection, LeavesNoPictureOfAnEarlierInspection) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(
      write_inspection(folder.path(), test::sample_record(), {picture(1), picture(2), picture(3)}));
  std::ofstream(folder.path() / "notes.txt") << "kept";
  std::ofstream(folder.path() / "overlay_mine.png") << "kept";
  ASSERT_TRUE(write_inspection(folder.path(), test::sample_record(), {picture(1)}));
  EXPECT_EQ(files_in(folder.path()),
            (std::set<std::string>{"notes.txt", "overlay_1.png", "overlay_mine.png", "points.ply",
                                   "report.html", "report.json"}));
}

TEST(WriteInspection, ReplacesNothingWhereOneFileCannotBeReplaced) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_inspection(folder.path(), test::sample_record(), {picture(1), picture(2)}));
  fs::remove(folder.path() / "points.ply");
  fs::create_directory(folder.path() / "points.ply");
  const auto before = read_file(folder.path() / "report.html");
  auto record = test::sample_record();
  record.standard = "another";
  const auto status = write_inspection(folder.path(), record, {picture(1)});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kIo);
  EXPECT_EQ(status.error().message.find((folder.path() / "points.ply").string()), 0U);
  EXPECT_EQ(*read_file(folder.path() / "report.html"), *before);
  EXPECT_EQ(files_in(folder.path()),
            (std::set<std::string>{"overlay_1.png", "overlay_2.png", "points.ply", "report.html",
                                   "report.json"}));
}

TEST(WriteInspection, RefusesAFileInTheFoldersPlace) {
  const test::TemporaryFolder folder;
  const fs::path out = folder.path() / "taken";
  std::ofstream(out) << "a file";
  const auto status = write_inspection(out, test::sample_record(), {});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kIo);
  EXPECT_EQ(status.error().message.find(out.string()), 0U) << status.error().message;
}

TEST(WriteInspection, KeepsTheEarlierReportWhereAFileCannotBeWritten) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_inspection(folder.path(), test::sample_record(), {picture(1)}));
  const auto before = read_file(folder.path() / "report.json");
  auto unwritable = picture(1);
  unwritable.file = "no/such/folder/overlay_1.png";
  auto record = test::sample_record();
  record.standard = "another";
  const auto status = write_inspection(folder.path(), record, {unwritable});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kIo);
  EXPECT_NE(status.error().message.find((folder.path() / "no/such/folder/overlay_1.png").string()),
            std::string::npos)
      << status.error().message;
  EXPECT_EQ(*read_file(folder.path() / "report.json"), *before);
  EXPECT_EQ(files_in(folder.path()),
            (std::set<std::string>{"overlay_1.png", "points.ply", "report.html", "report.json"}));
}

TEST(WriteInspection, RemovesWhatAKilledRunLeft) {
  const test::TemporaryFolder folder;
  const pid_t child = ::fork();  // a process number that is surely no more once it was waited for
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  const fs::path left = folder.path() / (".part-" + std::to_string(child));
  const fs::path busy = folder.path() / (".part-" + std::to_string(::getppid()));
  fs::create_directory(left);
  std::ofstream(left / "points.ply") << "half";
  fs::create_directory(busy);
  ASSERT_TRUE(write_inspection(folder.path(), test::sample_record(), {}));
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(busy));  // another run that is still at work
}

TEST(PointsPly, HoldsEveryPointInOrderInTheFilesOwnFrame) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_inspection(folder.path(), test::sample_record(), {}));
  const auto read = test::read_points_ply(folder.path() / "points.ply");
  ASSERT_TRUE(read);
  const auto& rows = *read;
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_NEAR(rows[0].position[0], 100.1,
              1e-5);  // the design's origin is added; float at 100 m: 8e-6 m
  EXPECT_EQ(rows[0].object, 1);
  EXPECT_EQ(rows[0].part, 0);
  EXPECT_FLOAT_EQ(rows[0].deviation, 0.002F);
  EXPECT_TRUE(std::isnan(rows[2].position[0]) && std::isnan(rows[2].position[1]) &&
              std::isnan(rows[2].position[2]));
  EXPECT_EQ(rows[3].object, 0);
  EXPECT_EQ(rows[3].part, -1);
  EXPECT_TRUE(std::isnan(rows[3].deviation));
  EXPECT_EQ(rows[4].object, 2);
  EXPECT_EQ(rows[4].part, 1);
  EXPECT_FLOAT_EQ(rows[4].deviation, 0.02F);
}

TEST(PointsPly, CallsEverythingClutterWhereNothingWasFound) {
  const test::TemporaryFolder folder;
  auto record = test::sample_record();
  record.inspection.alignment.found = false;
  record.inspection.deviations = {};
  record.inspection.declutter = {};
  ASSERT_TRUE(write_inspection(folder.path(), record, {}));
  const auto rows = test::read_points_ply(folder.path() / "points.ply");
  ASSERT_TRUE(rows);
  for (const auto& row : *rows) {
    EXPECT_EQ(row.object, 0);
    EXPECT_EQ(row.part, -1);
    EXPECT_TRUE(std::isnan(row.deviation));
  }
}

}  // namespace
}  // namespace spool::evidence
