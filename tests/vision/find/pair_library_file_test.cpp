// Tests of the library's file: what was written is read, what is damaged is refused and made again.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pair_library_file.h"

#include <fstream>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/vision/align/synthetic_spool.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool {
namespace {

using test::design_of;
using test::TemporaryFolder;

const PairLibraryOptions kSmall = {.model_samples = 1500};

PairLibrary small_library() {
  PairLibrary library{.options = kSmall};
  library.models.push_back(build_pair_model(design_of(test::tee_spool()), kSmall).value());
  return library;
}

void expect_same(const PairModel& a, const PairModel& b) {
  EXPECT_EQ(a.key, b.key);
  EXPECT_EQ(a.diameter_m, b.diameter_m);
  EXPECT_EQ(a.distance_m, b.distance_m);
  EXPECT_EQ(a.tolerance_m, b.tolerance_m);
  EXPECT_EQ(a.leaf_m, b.leaf_m);
  EXPECT_EQ(a.points.points, b.points.points);
  EXPECT_EQ(a.points.normals, b.points.normals);
  EXPECT_EQ(a.cell_first, b.cell_first);
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  for (std::size_t i = 0; i < a.pairs.size(); ++i)
    ASSERT_TRUE(a.pairs[i].first == b.pairs[i].first && a.pairs[i].second == b.pairs[i].second);
}

TEST(PairLibraryFile, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "library.pairs";
  const PairLibrary library = small_library();
  ASSERT_TRUE(write_pair_library(path, library));
  const auto read = read_pair_library(path);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->options, library.options);
  ASSERT_EQ(read->models.size(), 1U);
  expect_same(read->models[0], library.models[0]);
}

TEST(PairLibraryFile, DamageOfAnyKindIsRefusedWithASentence) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "library.pairs";
  ASSERT_TRUE(write_pair_library(path, small_library()));
  const std::string whole = read_file(path).value();
  struct Damage {
    const char* name;
    std::string bytes, said;
  };
  std::string turned = whole, versioned = whole, longer = whole + "x";
  turned[whole.size() / 2] = static_cast<char>(turned[whole.size() / 2] ^ 1);
  versioned[8] = 7;
  const std::vector<Damage> damages = {
      {"empty", "", "is not a model library"},
      {"something else", "solid cube", "is not a model library"},
      {"cut in the heading", whole.substr(0, 20), "cut short"},
      {"cut in the middle", whole.substr(0, whole.size() / 2), "cut short or damaged"},
      {"a byte less", whole.substr(0, whole.size() - 1), "cut short or damaged"},
      {"a byte more", longer, "cut short or damaged"},
      {"a bit turned", turned, "cut short or damaged"},
      {"another version", versioned, "version 7, not of this program's 1"},
  };
  for (const Damage& damage : damages) {
    ASSERT_TRUE(write_file_whole(path, damage.bytes));
    const auto read = read_pair_library(path);
    ASSERT_FALSE(read) << damage.name;
    EXPECT_EQ(read.error().code, ErrorCode::kBadInput);
    EXPECT_NE(read.error().message.find(damage.said), std::string::npos) << read.error().message;
    EXPECT_NE(read.error().message.find(path.string()), std::string::npos);
    EXPECT_NE(read.error().message.find("delete it"), std::string::npos);
  }
  EXPECT_FALSE(read_pair_library(folder.path() / "none.pairs"));
}

// Content of our own making under a digest that fits it.
TEST(PairLibraryFile, ContentThatContradictsItselfIsRefusedThoughItsDigestFits) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "library.pairs";
  const PairLibrary good = small_library();
  const auto refused = [&](PairLibrary library) {
    EXPECT_TRUE(write_pair_library(path, library));
    return !read_pair_library(path);
  };
  EXPECT_FALSE(refused(good));
  PairLibrary bad = good;
  bad.models[0].pairs[0].second = static_cast<std::uint32_t>(bad.models[0].points.size());
  EXPECT_TRUE(refused(bad)) << "a pair of a point that is not there";
  bad = good;
  bad.models[0].cell_first[1] = bad.models[0].cell_first.back() + 1;
  EXPECT_TRUE(refused(bad)) << "a cell beyond the pairs";
  bad = good;
  bad.models[0].cell_first.pop_back();
  EXPECT_TRUE(refused(bad)) << "a cell too few";
  bad = good;
  bad.models[0].points.points[0].x() = NAN;
  EXPECT_TRUE(refused(bad)) << "a point nowhere";
  bad = good;
  bad.models[0].points.normals.pop_back();
  EXPECT_TRUE(refused(bad)) << "a normal too few";
  bad = good;
  bad.models[0].distance_m = -1;
  EXPECT_TRUE(refused(bad)) << "a negative distance";
  bad = good;
  bad.options.cell_rad = 1e-9;
  EXPECT_TRUE(refused(bad)) << "options that would fill the memory";

  // A count of points larger than the file: the first count of the model, behind 40 bytes of
  // options, the number of models, the key and four lengths.
  std::string bytes = read_file(path).value();
  ASSERT_TRUE(write_pair_library(path, good));
  bytes = read_file(path).value();
  const std::size_t count = 76 + 40 + 8 + 8 + 64 + 32;
  bytes[count + 7] = '\x7f';
  bytes.replace(12, 64, sha256_hex(std::string_view(bytes).substr(76)));
  ASSERT_TRUE(write_file_whole(path, bytes));
  const auto read = read_pair_library(path);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("contradicts itself"), std::string::npos)
      << read.error().message;
}

TEST(PairLibraryFile, OpeningBuildsOnceReusesAfterwardsAndKeepsOtherDesigns) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "library.pairs";
  const DesignModel tee = design_of(test::tee_spool());
  const DesignModel rod = design_of({{}, {{0.1, 0, 0.9}, Eigen::Vector3d::UnitX(), 0.05, 0.6}});
  const std::vector<const DesignModel*> first = {&tee}, both = {&rod, &tee}, second = {&rod};
  const auto a = open_pair_library(path, first, kSmall);
  ASSERT_TRUE(a) << a.error().message;
  EXPECT_EQ(a->built, 1U);
  EXPECT_FALSE(a->not_read.empty());
  EXPECT_TRUE(a->not_written.empty()) << a->not_written;
  const auto b = open_pair_library(path, both, kSmall);
  ASSERT_TRUE(b);
  EXPECT_EQ(b->built, 1U);
  EXPECT_EQ(b->reused, 1U);
  EXPECT_TRUE(b->not_read.empty()) << b->not_read;
  ASSERT_EQ(b->library.models.size(), 2U);
  expect_same(b->library.models[1], a->library.models[0]);
  const auto c = open_pair_library(path, second, kSmall);
  ASSERT_TRUE(c);
  EXPECT_EQ(c->built, 0U);
  expect_same(c->library.models.at(0), b->library.models[0]);
  EXPECT_EQ(read_pair_library(path)->models.size(), 2U) << "the tee is still in the file";

  PairLibraryOptions other = kSmall;
  other.seed = 2;
  const auto d = open_pair_library(path, first, other);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->built, 1U);
  EXPECT_NE(d->not_read.find("other options"), std::string::npos);

  ASSERT_TRUE(write_file_whole(path, "SPOOLPRS"));
  const auto e = open_pair_library(path, first, kSmall);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->built, 1U);
  EXPECT_NE(e->not_read.find("cut short"), std::string::npos);
  expect_same(e->library.models[0], a->library.models[0]);
  EXPECT_TRUE(read_pair_library(path)) << "and is whole again";
}

TEST(PairLibraryFile, AFolderThatCannotBeWrittenIsSaidAndTheModelUsed) {
  const DesignModel tee = design_of(test::tee_spool());
  const std::vector<const DesignModel*> designs = {&tee};
  const auto opened = open_pair_library("/nowhere/library.pairs", designs, kSmall);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->library.models.size(), 1U);
  EXPECT_NE(opened->not_written.find("/nowhere/library.pairs"), std::string::npos);
}

}  // namespace
}  // namespace spool
