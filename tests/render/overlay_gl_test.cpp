// What the overlay shows, asserted in numbers: the pictures' numbers stand beside their goldens
// too.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "render/deviation_colour.h"
#include "render/overlay.h"
#include "tests/render/gl_test.h"
#include "tests/render/scene.h"

namespace spool::render {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
const float kUnknown = std::numeric_limits<float>::quiet_NaN();

Eigen::Vector3f colour_at(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return Eigen::Vector3f(p[0], p[1], p[2]) / 255;
}

int different_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      count += colour_at(a, x, y) != colour_at(b, x, y) ? 1 : 0;
    }
  }
  return count;
}

class Overlay : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    auto renderer = OverlayRenderer::create();
    ASSERT_TRUE(renderer) << renderer.error().message;
    renderer_.emplace(std::move(*renderer));
    auto target = Offscreen::create(kWidth, kHeight);
    ASSERT_TRUE(target) << target.error().message;
    target_ = std::move(*target);
    view_ = test::spool_view(kWidth, kHeight);
  }
  void TearDown() override {
    renderer_.reset();
    target_ = {};
    GlTest::TearDown();
  }

  Image draw(const OverlayStyle& style) {
    const Status status = renderer_->draw(target_, view_, style);
    EXPECT_TRUE(status) << status.error().message;
    return target_.read();
  }
  void set_measured(const test::Measured& m) {
    renderer_->set_points(m.points, m.deviation, m.classes);
  }
  // One point (class 1) or several, of a deviation.
  void set_point(const Eigen::Vector3f& p, float deviation, std::uint8_t point_class = 1) {
    renderer_->set_points(std::vector{p}, std::vector{deviation}, std::vector{point_class});
  }
  static OverlayStyle plain() {
    return {.shade_cloud = false, .show_design = false, .show_legend = false};
  }

  std::optional<OverlayRenderer> renderer_;
  Offscreen target_;
  View view_;
};

TEST_F(Overlay, DrawsOnlyTheBackgroundForAnEmptyState) {
  const Image empty = draw({});
  const Image background = draw({.show_cloud = false, .show_design = false, .show_legend = false});
  // The legend says what colours would mean; there is nothing else.
  EXPECT_EQ(different_pixels(draw({.show_legend = false}), background), 0);
  EXPECT_GT(different_pixels(empty, background), 0);
}

TEST_F(Overlay, EveryPixelIsOpaque) {
  const test::Scene scene = test::make_spool();
  renderer_->set_design(scene.mesh, scene.part);
  set_measured(test::measure(scene, view_, [](auto, const auto&) { return 0.002; }));
  const Image image = draw({});
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);
}

TEST_F(Overlay, APointIsDrawnAtItsProjectionInItsColour) {
  for (const Eigen::Vector3d& p : {test::kPipeTop, test::kFlangeFace}) {
    set_point(p.cast<float>(), 0.004F);
    const Image image = draw(plain());
    const Projected at = project(view_, p);
    const int x = static_cast<int>(std::lround(at.x));
    const int y = static_cast<int>(std::lround(at.y));
    const Eigen::Vector3f expected = deviation_colour(0.004, 0.001, 0.010);
    // 8-bit rounding and one step of the interpolator.
    EXPECT_LT((colour_at(image, x, y) - expected).cwiseAbs().maxCoeff(), 1.5F / 255);
    const OverlayStyle nothing{.show_cloud = false, .show_design = false, .show_legend = false};
    EXPECT_EQ(different_pixels(image, draw(nothing)), 9);  // a square of 3 px, the rest untouched
    int sum_x = 0;
    int sum_y = 0;
    const Image without = draw(nothing);
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        if (colour_at(image, u, v) == colour_at(without, u, v)) continue;
        sum_x += u;
        sum_y += v;
      }
    }
    EXPECT_NEAR(sum_x / 9.0, at.x, 0.51);  // its middle is within rounding of the projection
    EXPECT_NEAR(sum_y / 9.0, at.y, 0.51);
  }
}

TEST_F(Overlay, FiveMillimetresOutIsRedAndInIsBlue) {
  const Projected at = project(view_, test::kPipeTop);
  const auto colour = [&](float deviation) {
    set_point(test::kPipeTop.cast<float>(), deviation);
    return colour_at(draw(plain()), static_cast<int>(std::lround(at.x)),
                     static_cast<int>(std::lround(at.y)));
  };
  const Eigen::Vector3f out = colour(0.005F);
  const Eigen::Vector3f in = colour(-0.005F);
  EXPECT_GT(out.x(), out.z() + 0.3F);
  EXPECT_GT(in.z(), in.x() + 0.3F);
  const Eigen::Vector3f neutral = colour(0.0005F);
  EXPECT_NEAR(neutral.x(), neutral.z(), 1.0F / 255);
  EXPECT_EQ(colour(1.0F), colour(0.010F));  // beyond the range: the last colour
}

TEST_F(Overlay, ClutterUnknownAndContradictingPointsLookDifferent) {
  const Projected at = project(view_, test::kPipeTop);
  const auto picture = [&](float deviation, std::uint8_t point_class) {
    set_point(test::kPipeTop.cast<float>(), deviation, point_class);
    return draw(plain());
  };
  const auto middle = [&](const Image& image) {
    return colour_at(image, static_cast<int>(std::lround(at.x)),
                     static_cast<int>(std::lround(at.y)));
  };
  const auto is = [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return (a - b).cwiseAbs().maxCoeff() < 1.5F / 255;
  };
  EXPECT_TRUE(is(middle(picture(kUnknown, 0)), clutter_colour()));
  EXPECT_TRUE(
      is(middle(picture(0.005F, 0)), clutter_colour()));  // clutter has no deviation to show
  EXPECT_TRUE(is(middle(picture(kUnknown, 1)), unknown_colour()));
  // Told apart by size and pattern, not only by colour.
  const Image none = draw({.show_cloud = false, .show_design = false, .show_legend = false});
  EXPECT_GT(different_pixels(picture(0.005F, 2), none),
            different_pixels(picture(0.005F, 1), none) + 4);
}

TEST_F(Overlay, PointsThatAreNotFiniteAreNotDrawn) {
  const float infinite = std::numeric_limits<float>::infinity();
  const std::vector<Eigen::Vector3f> points{{kUnknown, 0, 0}, {0, infinite, 0}, {0, 0, -infinite}};
  const std::vector<float> deviation{0.001F, 0.001F, 0.001F};
  const std::vector<std::uint8_t> classes{0, 1, 2};
  renderer_->set_points(points, deviation, classes);
  EXPECT_EQ(
      different_pixels(draw(plain()),
                       draw({.show_cloud = false, .show_design = false, .show_legend = false})),
      0);
}

TEST_F(Overlay, ClutterCanBeLeftOut) {
  set_point(test::kPipeTop.cast<float>(), kUnknown, 0);
  OverlayStyle style = plain();
  const Image with = draw(style);
  style.show_clutter = false;
  EXPECT_EQ(different_pixels(with, draw(style)), 9);
}

TEST_F(Overlay, ADefectOfThreeMillimetresChangesThePicture) {
  const test::Scene scene = test::make_spool();
  renderer_->set_design(scene.mesh, scene.part);
  set_measured(test::measure(scene, view_, [](auto, const auto&) { return 0.0; }));
  const Image good = draw({});
  set_measured(test::measure(scene, view_, [](test::Part part, const auto&) {
    return part == test::kFlange ? 0.003 : 0.0;
  }));
  const Image bad = draw({});
  // The flange takes a good part of the picture: a tenth of it has to change.
  EXPECT_GT(different_pixels(good, bad), kWidth * kHeight / 40);
}

// A wall of points before, just behind and far behind the pipe: what the design's body does there.
TEST_F(Overlay, TheDesignIsHiddenByPointsBeforeItAndSeenBeforePointsBehindIt) {
  const test::Scene scene = test::make_spool();
  renderer_->set_design(scene.mesh, scene.part);
  const Projected at = project(view_, test::kPipeTop);
  const auto u = std::lround(at.x);
  const auto v = std::lround(at.y) + 6;  // on the pipe's flank, off every line
  const Eigen::Vector3d eye_ray =
      view_.camera.back_project(static_cast<double>(u), static_cast<double>(v), 1.0);
  const auto measured = test::measure(scene, view_, [](auto, const auto&) { return 0.0; });
  double depth = 0;  // of the pipe at that pixel
  for (const Eigen::Vector3f& p : measured.points) {
    const Projected q = project(view_, p.cast<double>());
    if (std::lround(q.x) == u && std::lround(q.y) == v) depth = q.depth_m;
  }
  ASSERT_GT(depth, 0);
  OverlayStyle style{.shade_cloud = false, .show_legend = false};
  const auto middle = [&](double z) {
    set_point((view_.T_camera_design.inverse() * Eigen::Vector3d(z * eye_ray)).cast<float>(),
              0.005F);
    return colour_at(draw(style), static_cast<int>(u), static_cast<int>(v));
  };
  const Eigen::Vector3f pure = deviation_colour(0.005, 0.001, 0.010);
  const auto off = [&](const Eigen::Vector3f& c) { return (c - pure).cwiseAbs().maxCoeff(); };
  EXPECT_LT(off(middle(depth - 0.05)), 2.0F / 255);  // a hand before the pipe
  EXPECT_LT(off(middle(depth + 0.004)),
            2.0F / 255);  // the pipe itself, 4 mm inside: measured steel wins
  const Eigen::Vector3f behind = middle(depth + 0.05);
  EXPECT_GT(off(behind), 0.05F);  // the wall behind is seen through the glass, tinted
  EXPECT_GT(behind.x(), behind.z() + 0.1F);
}

TEST_F(Overlay, TheLitPartIsBrighterAndBlueAndShowsThroughPoints) {
  const test::Scene scene = test::make_spool();
  renderer_->set_design(scene.mesh, scene.part);
  OverlayStyle style{.show_legend = false};
  const auto blueness = [&](const OverlayStyle& s) {
    const Image image = draw(s);
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i + 2] - image.rgba[i];
    return sum / (kWidth * kHeight);
  };
  const double plain_blue = blueness(style);
  style.lit_parts = {test::kElbow, -1};
  const double lit_blue = blueness(style);
  EXPECT_GT(lit_blue, plain_blue + 3);
  style.lit_parts = {-1, test::kElbow};
  EXPECT_EQ(blueness(style), lit_blue) << "either place";
  style.lit_parts = {test::kElbow, test::kFlange};
  EXPECT_GT(blueness(style), lit_blue + 1) << "both sides of a joint";
  style.lit_parts = {99, -1};  // no such part
  EXPECT_NEAR(blueness(style), plain_blue, 1e-9);
  set_measured(test::measure(scene, view_, [](auto, const auto&) { return 0.0; }));
  style.lit_parts = {-1, -1};
  const Image unlit = draw(style);
  style.lit_parts = {test::kElbow, -1};
  EXPECT_GT(different_pixels(unlit, draw(style)), 200);  // its outline, through its own points
}

// Walls of points square to the view and turned away: form shows, and a facing surface keeps its
// colour.
TEST_F(Overlay, ShadingDarkensSlopesAndLeavesFacingSurfaces) {
  const auto light = [&](double slope) {
    test::Measured m;
    for (int v = 60; v < 180; ++v) {
      for (int u = 80; u < 240; ++u) {
        const Eigen::Vector3d ray = view_.camera.back_project(u, v, 1.0);
        const double z = 1.0 / (1.0 - slope * ray.x());  // the plane z = 1 + slope x
        m.points.push_back(
            (view_.T_camera_design.inverse() * Eigen::Vector3d(z * ray)).cast<float>());
        m.deviation.push_back(0);
        m.classes.push_back(1);
      }
    }
    set_measured(m);
    const float shaded =
        colour_at(draw({.show_design = false, .show_legend = false}), 160, 120).x();
    return shaded / colour_at(draw(plain()), 160, 120).x();
  };
  EXPECT_NEAR(light(0), 1.0F, 0.02F);
  EXPECT_NEAR(light(1.7), 0.81F,
              0.06F);  // 60 degrees: 2^-(0.18 * 1.7); depth steps of whole pixels
  EXPECT_LT(light(4), light(1.7));
}

TEST_F(Overlay, NearPointsGrowToCloseTheSurface) {
  set_point(test::kPipeTop.cast<float>(), 0.004F);
  OverlayStyle style = plain();
  const Image nothing = draw({.show_cloud = false, .show_design = false, .show_legend = false});
  const Projected at = project(view_, test::kPipeTop);
  style.point_spacing_m = 7 * at.depth_m / view_.camera.fx;  // 7 px there
  // A disc of 7 px: pi / 4 * 49 = 38.5, its rim rounded to whole pixels.
  EXPECT_NEAR(different_pixels(draw(style), nothing), 38.5, 4);
}

TEST_F(Overlay, AsksForNoLargerPointsThanTheDriverDraws) {
  set_point(test::kPipeTop.cast<float>(), 0.004F, 2);
  OverlayStyle style = plain();
  style.point_size_px = 1e6F;
  draw(style);  // no GL error; the fixture looks
}

TEST_F(Overlay, DrawsTheSameTwice) {
  const test::Scene scene = test::make_spool();
  renderer_->set_design(scene.mesh, scene.part);
  set_measured(test::measure(scene, view_, [](auto, const auto&) { return 0.002; }));
  const Image first = draw({.lit_parts = {1, -1}});
  EXPECT_EQ(first.rgba, draw({.lit_parts = {1, -1}}).rgba);
}

TEST_F(Overlay, AMarkerIsDrawnAtItsPoint) {
  const Image before = draw(plain());
  const std::vector<Marker> markers{{test::kPipeTop.cast<float>(), Marker::Kind::kPicked, "1"}};
  renderer_->set_markers(markers);
  const Image after = draw(plain());
  const Projected at = project(view_, test::kPipeTop);
  const int x = static_cast<int>(std::lround(at.x));
  const int y = static_cast<int>(std::lround(at.y));
  EXPECT_NE(colour_at(before, x, y), colour_at(after, x, y));
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      if (std::hypot(u - at.x, v - at.y) < 45) continue;
      ASSERT_EQ(colour_at(before, u, v), colour_at(after, u, v)) << u << ", " << v;
    }
  }
  renderer_->set_markers({});
  EXPECT_EQ(draw(plain()).rgba, before.rgba);
}

TEST_F(Overlay, ReplacesAndEmptiesWhatItWasGiven) {
  const Image nothing = draw({.show_legend = false});
  const test::Scene scene = test::make_spool();
  renderer_->set_design(scene.mesh, scene.part);
  set_measured(test::measure(scene, view_, [](auto, const auto&) { return 0.0; }));
  EXPECT_GT(different_pixels(draw({.show_legend = false}), nothing), 1000);
  renderer_->set_design({}, {});
  renderer_->set_points({}, {}, {});
  EXPECT_EQ(draw({.show_legend = false}).rgba, nothing.rgba);
}

}  // namespace
}  // namespace spool::render
