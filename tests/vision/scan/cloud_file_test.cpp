// Tests of cloud files: every format gives the same cloud, units and origins, what is written is
// read.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/cloud_file.h"

#include <clocale>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/vision/scan/cloud_samples.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool {
namespace {

using test::write_sample;

void expect_sample(const CloudFile& file, const test::CloudSample& sample) {
  const auto points = test::sample_points();
  const auto normals = test::sample_normals();
  ASSERT_EQ(file.cloud.size(), points.size()) << sample.name;
  ASSERT_TRUE(file.cloud.is_consistent()) << sample.name;
  EXPECT_EQ(file.finite, 3U) << sample.name;
  EXPECT_EQ(file.cloud.width, sample.width) << sample.name;
  EXPECT_EQ(file.cloud.height, sample.height) << sample.name;
  EXPECT_EQ(file.cloud.has_normals(), sample.has_normals) << sample.name;
  EXPECT_EQ(file.sha256, sha256_hex(sample.bytes)) << sample.name;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 2) {
      EXPECT_TRUE(file.cloud.points[i].array().isNaN().all()) << sample.name;
    } else {
      EXPECT_EQ(file.cloud.points[i], points[i]) << sample.name << " point " << i;
    }
    if (sample.has_normals) {
      EXPECT_LT((file.cloud.normals[i] - normals[i]).norm(), 1e-6)
          << sample.name << " normal " << i;
    }
  }
}

TEST(CloudFile, IsTheSameCloudInEveryFormat) {
  const test::TemporaryFolder folder;
  for (const test::CloudSample& sample : test::cloud_samples()) {
    const auto path = write_sample(folder.path(), sample.ending, sample.bytes);
    EXPECT_TRUE(is_cloud_file(path));
    const auto file = read_cloud(path, LengthUnit::kMetre);
    ASSERT_TRUE(file) << sample.name << ": " << file.error().message;
    expect_sample(*file, sample);
    EXPECT_FALSE(file->unit_inferred);
  }
}

TEST(CloudFile, KnowsItsOwnEndings) {
  for (const char* name : {"a.ply", "b.PCD", "c.xyz", "d.txt", "e.obj", "x.y/f.Ply"})
    EXPECT_TRUE(is_cloud_file(name)) << name;
  for (const char* name : {"a.glb", "ply", "a.ply.gz", "", "a.", "b.stl"})
    EXPECT_FALSE(is_cloud_file(name)) << name;
}

TEST(CloudFile, SaysWhatItLeavesOut) {
  const test::TemporaryFolder folder;
  struct Row {
    const char* sample;
    const char* text;
  };
  for (const Row& row :
       {Row{"XYZ commas and normals", "line 2 is taken for a heading"},
        Row{"XYZ semicolons and colours", "line 1 is taken for a heading"},
        Row{"XYZ semicolons and colours", "no unit normals"}, Row{"OBJ", "faces are left out"}}) {
    bool found = false;
    for (const test::CloudSample& sample : test::cloud_samples()) {
      if (sample.name != row.sample) continue;
      const auto file =
          read_cloud(write_sample(folder.path(), sample.ending, sample.bytes), LengthUnit::kMetre);
      ASSERT_TRUE(file);
      for (const std::string& warning : file->warnings)
        found = found || warning.find(row.text) != std::string::npos;
    }
    EXPECT_TRUE(found) << row.sample << ": " << row.text;
  }
}

TEST(CloudFile, ReadsNumbersWhateverTheLocale) {
  const test::TemporaryFolder folder;
  const auto path = write_sample(folder.path(), ".xyz", "0.5 1.5 2.5\n1 1 1\n");
  const char* const set =
      std::setlocale(LC_ALL, "de_DE.UTF-8");  // a decimal comma, where it is installed
  const auto file = read_cloud(path, LengthUnit::kMetre);
  std::setlocale(LC_ALL, "C");
  ASSERT_TRUE(file) << (set != nullptr ? set : "locale not installed");
  EXPECT_EQ(file->cloud.points[0], Eigen::Vector3f(0.5F, 1.5F, 2.5F));
}

TEST(CloudFile, ScalesByTheUnitThatIsGiven) {
  const test::TemporaryFolder folder;
  const auto path = write_sample(folder.path(), ".xyz", "0 0 0 0 0 1\n1000 0 -500 0 1 0\n");
  struct Row {
    LengthUnit unit;
    float x;
  };
  for (const Row& row : {Row{LengthUnit::kMetre, 1000}, Row{LengthUnit::kMillimetre, 1},
                         Row{LengthUnit::kInch, 25.4F}}) {
    const auto file = read_cloud(path, row.unit);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->unit, row.unit);
    EXPECT_FALSE(file->unit_inferred);
    const Eigen::Vector3d second = file->cloud.origin + file->cloud.points[1].cast<double>();
    EXPECT_NEAR(second.x(), row.x, 1e-5);
    EXPECT_EQ(file->cloud.normals[1], Eigen::Vector3f(0, 1, 0)) << "a direction has no unit";
  }
}

TEST(CloudFile, InfersTheUnitFromTheSizeOrAsks) {
  struct Row {
    double across;
    const char* unit;  // empty: refused
  };
  const test::TemporaryFolder folder;
  for (const Row& row : {Row{0.01, ""}, Row{0.03, "m"}, Row{3, "m"}, Row{55, "m"}, Row{149, "m"},
                         Row{151, ""}, Row{299, ""}, Row{301, "mm"}, Row{1500, "mm"},
                         Row{59000, "mm"}, Row{61000, ""}, Row{0, ""}}) {
    // Off the origin: the size counts, not the place.
    const std::string text = "5000 0 0\n" + std::to_string(5000 + row.across) + " 0 0\n5000 0 0\n";
    const auto file = read_cloud(write_sample(folder.path(), ".xyz", text), std::nullopt);
    ASSERT_EQ(file.has_value(), row.unit[0] != '\0') << row.across;
    if (!file) {
      EXPECT_NE(file.error().message.find("its unit cannot be told"), std::string::npos);
      EXPECT_NE(file.error().message.find("--scan-unit"), std::string::npos);
      continue;
    }
    EXPECT_EQ(name(file->unit), row.unit) << row.across;
    EXPECT_TRUE(file->unit_inferred);
    ASSERT_EQ(file->warnings.size(), 1U);
    EXPECT_NE(file->warnings[0].find("its unit is not given"), std::string::npos);
  }
}

TEST(CloudFile, IsNotFooledByStrayReadings) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += std::to_string(i * 0.001) + " 0 0\n";
  text += "1e7 0 0\n-4000 1 1\n";
  const test::TemporaryFolder folder;
  const auto file = read_cloud(write_sample(folder.path(), ".xyz", text), std::nullopt);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->unit, LengthUnit::kMetre);
}

TEST(CloudFile, WarnsOfAGivenUnitThatMakesNoSense) {
  const test::TemporaryFolder folder;
  const auto path = write_sample(folder.path(), ".xyz", "0 0 0\n3000 0 0\n");
  const auto file = read_cloud(path, LengthUnit::kMetre);
  ASSERT_TRUE(file);
  bool said = false;
  for (const std::string& warning : file->warnings)
    said = said || warning.find("3000 m across if it is in metres") != std::string::npos;
  EXPECT_TRUE(said);
}

TEST(CloudFile, KeepsTenthsOfAMillimetreAtPlantCoordinates) {
  const test::TemporaryFolder folder;
  // Survey coordinates (m): a float's step is 0.5 m there.
  const auto path =
      write_sample(folder.path(), ".xyz",
                   "4512345.1234 612345.6789 12.0001\n4512346.1235 612345.6780 12.0002\n");
  const auto file = read_cloud(path, LengthUnit::kMetre);
  ASSERT_TRUE(file);
  const Eigen::Vector3d exact(4512345.1234, 612345.6789, 12.0001);
  EXPECT_LT((file->cloud.origin + file->cloud.points[0].cast<double>() - exact).norm(), 1e-6);
  EXPECT_LT(file->cloud.points[0].norm(), 2.0F);
  EXPECT_EQ(file->cloud.origin, Eigen::Vector3d(4512346, 612346, 12)) << "whole metres";
}

TEST(CloudFile, KeepsItsOwnOriginWhereAFloatIsFineEnough) {
  const test::TemporaryFolder folder;
  const auto near =
      read_cloud(write_sample(folder.path(), ".xyz", "255 0 0\n250 0 0\n"), LengthUnit::kMetre);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->cloud.origin, Eigen::Vector3d(0, 0, 0));
  const auto far =
      read_cloud(write_sample(folder.path(), ".xyz", "257 0 0\n250 0 0\n"), LengthUnit::kMetre);
  ASSERT_TRUE(far);
  EXPECT_NE(far->cloud.origin, Eigen::Vector3d(0, 0, 0));
  const auto wide =
      read_cloud(write_sample(folder.path(), ".xyz", "-300 0 0\n400 0 0\n"), LengthUnit::kMetre);
  ASSERT_TRUE(wide);
  ASSERT_EQ(wide->warnings.size(), 1U);
  EXPECT_NE(wide->warnings[0].find("rounded by more than 10 micrometres"), std::string::npos);
}

TEST(CloudFile, TakesWhatIsNotFiniteForNoMeasurement) {
  const test::TemporaryFolder folder;
  const auto file =
      read_cloud(write_sample(folder.path(), ".xyz",
                              "0 0 0\n1 inf 0\n1 -nan 1\n1e400 0 0\n1e60 0 0\n1 1e-400 1\n"),
                 LengthUnit::kMetre);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->cloud.size(), 6U);
  EXPECT_EQ(file->finite, 2U);
  for (const std::size_t i : {1U, 2U, 3U, 4U})
    EXPECT_TRUE(file->cloud.points[i].array().isNaN().all()) << i;
}

TEST(WritePly, IsReadBackWithItsColumnsInPlace) {
  const test::TemporaryFolder folder;
  PointCloud cloud;
  cloud.points = test::sample_points();
  cloud.origin = {100, -20, 3};
  PlyColumn object{.name = "object", .type = PlyColumn::Type::kUchar, .uchars = {0, 1, 2, 255}};
  PlyColumn part{.name = "part", .type = PlyColumn::Type::kInt, .ints = {-1, 0, 7, 1 << 30}};
  PlyColumn nx{.name = "nx", .floats = {1, 0, 0, 0}}, ny{.name = "ny", .floats = {0, 1, 0, 0}},
      nz{.name = "nz", .floats = {0, 0, NAN, -1}};
  const auto path = folder.path() / "points.ply";
  ASSERT_TRUE(write_ply(path, cloud, {object, nx, part, ny, nz}));

  const auto file = read_cloud(path, LengthUnit::kMetre);
  ASSERT_TRUE(file);
  ASSERT_EQ(file->cloud.size(), 4U);
  EXPECT_EQ(file->finite, 3U);
  EXPECT_EQ(file->cloud.points[0], Eigen::Vector3f(100.5F, -21.25F, 5.0F));
  EXPECT_TRUE(file->cloud.points[2].array().isNaN().all());
  EXPECT_EQ(file->cloud.normals[3], Eigen::Vector3f(0, 0, -1));
  EXPECT_EQ(file->cloud.normals[2], Eigen::Vector3f(0, 0, 0));

  const auto bytes = read_file(path);
  ASSERT_TRUE(bytes);
  const std::size_t body = bytes->find("end_header\n") + 11;
  EXPECT_EQ(bytes->size() - body, 4U * (12 + 1 + 4 + 4 + 4 + 4)) << "no padding";
  EXPECT_EQ(static_cast<unsigned char>((*bytes)[body + 12]), 0U);
  EXPECT_EQ(static_cast<unsigned char>((*bytes)[body + 3 * 29 + 12]), 255U);
}

TEST(WritePly, SaysWhereItCannotWrite) {
  const test::TemporaryFolder folder;
  const Status written = write_ply(folder.path() / "none" / "points.ply", PointCloud{});
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace spool
