// The isometric as a drawing: labels that lie on none of each other, all there, the same each time.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/isometric.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "tests/vision/guide/random_spool.h"
#include "tests/vision/piping/pcf_samples.h"
#include "vision/design/pipework_design.h"
#include "vision/guide/isometric_layout.h"
#include "vision/piping/pcf_reader.h"

namespace spool::test {
namespace {

DesignModel design_from(const std::string& text) {
  const auto pipework = piping::read_pcf(text, "test.pcf");
  EXPECT_TRUE(pipework);
  DesignModel design;
  design.path = "test.pcf";
  EXPECT_TRUE(design_of(*pipework, design));
  return design;
}

guide::Isometric drawn(const std::string& text) {
  const auto made = guide::draw_isometric(design_from(text), {});
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return *made;
}

TEST(Isometric, LabelsOfFortyPartsLieOnNoneOfEachOther) {
  for (unsigned seed = 1; seed <= 25; ++seed) {
    const guide::Isometric made = drawn(random_spool_pcf({.seed = seed}));
    EXPECT_EQ(made.labels_without_place, 0) << "seed " << seed;
    for (std::size_t a = 0; a < made.labels.size(); ++a) {
      for (std::size_t b = a + 1; b < made.labels.size(); ++b) {
        const auto common = made.labels[a].placed.box.intersection(made.labels[b].placed.box);
        EXPECT_TRUE(common.isEmpty()) << "seed " << seed << ": " << made.labels[a].label.text
                                      << " on " << made.labels[b].label.text;
      }
    }
  }
}

TEST(Isometric, LabelsStayOnThePaperAndOffTheirPipes) {
  int on_paper = 0, all = 0;
  double covered = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const DesignModel design = design_from(random_spool_pcf({.seed = seed}));
    const guide::IsometricOptions options;
    const auto made = guide::draw_isometric(design, options);
    ASSERT_TRUE(made);
    for (const auto& label : made->labels) {
      ++all;
      if (options.area.contains(label.placed.box)) ++on_paper;
      for (const auto& stroke : made->drawing.strokes) {
        if (stroke.width_mm < 0.6 || stroke.points.size() != 2) continue;  // 0.7: pipes
        covered += guide::length_within({stroke.points[0], stroke.points[1]}, label.placed.box);
      }
    }
  }
  EXPECT_EQ(on_paper, all);
  // Of some 130 labels a drawing hardly one lies on a pipe: under a millimetre of pipe a label.
  EXPECT_LT(covered, 0.2 * all);
}

TEST(Isometric, NamesEveryWeldWithItsMarkAndEveryPart) {
  const guide::Isometric made = drawn(spool_pcf());
  std::multiset<std::string> texts;
  for (const auto& each : made.drawing.texts) texts.insert(each.utf8);
  for (const char* text :
       {"W-101", "FW-7 FW", "pipe-1", "pipe-4", "elbow-2", "tee-1", "reducer-1", "valve-1",
        "olet-1", "cap-1", "86", "89", "276", "N 198", "UP 198", "E 1000  N 2000  EL +500"})
    EXPECT_EQ(texts.count(text), 1U) << text;
  EXPECT_EQ(texts.count("500"), 2U);
}

TEST(Isometric, IsTheSameEachTime) {
  const guide::Isometric one = drawn(random_spool_pcf({.seed = 7}));
  const guide::Isometric other = drawn(random_spool_pcf({.seed = 7}));
  ASSERT_EQ(one.labels.size(), other.labels.size());
  for (std::size_t k = 0; k < one.labels.size(); ++k)
    EXPECT_EQ(one.labels[k].placed.box.min(), other.labels[k].placed.box.min());
}

TEST(Isometric, DrawsOnePart) {
  const guide::Isometric made =
      drawn(pcf("PIPE\n    END-POINT 0 0 0 4\n    END-POINT 600 0 0 4\n"));
  bool has_length = false;
  for (const auto& each : made.labels) has_length = has_length || each.label.text == "600";
  EXPECT_TRUE(has_length);
}

TEST(Isometric, AxesAreAtThirtyDegreesAndUpIsUp) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    const auto axes = guide::isometric_axes(quarter);
    EXPECT_LT((axes.col(2) - Eigen::Vector2d(0, -1)).norm(), 1e-12);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(std::abs(axes(1, k)), 0.5, 1e-12);  // sin 30
    const Eigen::Vector3d eye = guide::towards_eye(quarter);
    EXPECT_GT(eye.z(), 0.5);
    EXPECT_LT((axes * eye).norm(), 1e-12);
  }
  // With north to the upper right, east is to the lower right: nothing is mirrored.
  EXPECT_GT(guide::isometric_axes(0)(0, 0), 0);
  EXPECT_GT(guide::isometric_axes(0)(1, 0), 0);
  EXPECT_LT(guide::isometric_axes(0)(1, 1), 0);
}

TEST(Isometric, LengthsAreCompressedAndTheOrderKept) {
  const DesignModel design = design_from(random_spool_pcf({.seed = 4}));
  const auto line = guide::centre_line(design, {});
  ASSERT_TRUE(line);
  const auto layout =
      guide::lay_out(design, *line, guide::Box2(Eigen::Vector2d(0, 0), Eigen::Vector2d(250, 250)));
  for (const auto& run : line->runs) {
    if (run.is_skew) continue;
    const Eigen::Vector3d way = layout.drawn[static_cast<std::size_t>(run.nodes.back())] -
                                layout.drawn[static_cast<std::size_t>(run.nodes.front())];
    EXPECT_GT(way.dot(run.direction), 0);
    // Level stays level, in line stays in line.
    EXPECT_LT((way - run.direction * way.dot(run.direction)).norm(), 1e-3 * way.norm() + 1e-6);
  }
}

}  // namespace
}  // namespace spool::test
