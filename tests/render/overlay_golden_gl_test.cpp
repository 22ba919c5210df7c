// Pictures of the overlay against those kept, each with numbers asserted beside it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "render/deviation_colour.h"
#include "render/overlay.h"
#include "tests/render/gl_test.h"
#include "tests/render/golden.h"
#include "tests/render/scene.h"

namespace spool::render {
namespace {

class OverlayGolden : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    auto renderer = OverlayRenderer::create();
    ASSERT_TRUE(renderer) << renderer.error().message;
    renderer_.emplace(std::move(*renderer));
    resize(320, 240);
  }
  void TearDown() override {
    renderer_.reset();
    target_ = {};
    GlTest::TearDown();
  }
  void resize(int width, int height) {
    auto target = Offscreen::create(width, height);
    ASSERT_TRUE(target) << target.error().message;
    target_ = std::move(*target);
    view_ = test::spool_view(width, height);
  }
  void set_design() { renderer_->set_design(scene_.mesh, scene_.part); }
  // An as-built spool: pipe 4 mm thin at its end, flange cocked by 6 mm across, a sound elbow, a
  // floor.
  test::Measured as_built() const {
    return test::measure(
        scene_, view_,
        [](test::Part part, const Eigen::Vector3d& p) {
          if (part == test::kFlange) return 0.002 + 0.035 * p.y();
          return part == test::kPipe ? -0.004 * (1 - p.x() / 0.30) : 0.0;
        },
        -0.12);
  }
  void set_measured(const test::Measured& m) {
    renderer_->set_points(m.points, m.deviation, m.classes);
  }
  Image draw(const OverlayStyle& style) {
    const Status status = renderer_->draw(target_, view_, style);
    EXPECT_TRUE(status) << status.error().message;
    return target_.read();
  }
  // The colour at the projection of a point of the design.
  [[nodiscard]] Eigen::Vector3f colour(const Image& image, const Eigen::Vector3d& p, int dx = 0,
                                       int dy = 0) const {
    const Projected at = project(view_, p);
    const std::uint8_t* rgba = image.pixel(static_cast<int>(std::lround(at.x)) + dx,
                                           static_cast<int>(std::lround(at.y)) + dy);
    return Eigen::Vector3f(rgba[0], rgba[1], rgba[2]) / 255;
  }
  static bool corner_is_background(const Image& image) {
    const std::uint8_t* p = image.pixel(2, 2);
    return p[0] < 50 && p[1] < 55 && p[2] < 62 && p[2] > p[0];
  }

  test::Scene scene_ = test::make_spool();
  std::optional<OverlayRenderer> renderer_;
  Offscreen target_;
  View view_;
};

TEST_F(OverlayGolden, CloudOnly) {
  set_measured(as_built());
  const Image image = draw({.show_design = false, .show_legend = false});
  const Eigen::Vector3f pipe_end = colour(image, {0.02, -0.057, 0.01});
  EXPECT_GT(pipe_end.z(), pipe_end.x() + 0.1F);  // thin: blue
  const Eigen::Vector3f elbow = colour(image, {0.42, -0.057, 0.10});
  EXPECT_NEAR(elbow.z(), elbow.x(), 0.02F);  // sound: grey
  test::expect_golden("cloud", image);
}

TEST_F(OverlayGolden, MeshOnly) {
  set_design();
  const Image image = draw({.show_legend = false});
  EXPECT_TRUE(corner_is_background(image));
  EXPECT_GT(colour(image, {0.15, -0.057, 0.0}).norm(),
            0.35F);  // the pipe's body, over a dark ground
  test::expect_golden("mesh", image);
}

TEST_F(OverlayGolden, LitPart) {
  set_design();
  const Image image = draw({.show_legend = false, .lit_parts = {test::kFlange, -1}});
  const Eigen::Vector3f lit = colour(image, {0.4524, -0.1145, 0.265});
  EXPECT_GT(lit.z(), lit.x() + 0.1F);
  test::expect_golden("lit_part", image);
}

// Marks along the pipe: known, partly, not seen, and one on its far side.
TEST_F(OverlayGolden, PatchesByTheirShape) {
  using Sight = PatchMark::Sight;
  set_design();
  const Image bare = draw({.show_legend = false});
  const std::array<Eigen::Vector3d, 3> middles{
      {{0.06, -0.057, 0.0}, {0.14, -0.057, 0.0}, {0.22, -0.057, 0.0}}};
  const std::array<Sight, 3> sights{Sight::kKnown, Sight::kPartly, Sight::kNotSeen};
  const Eigen::Vector3f front = -Eigen::Vector3f::UnitY();
  std::vector<PatchMark> marks;
  for (std::size_t i = 0; i < 3; ++i)
    marks.push_back({middles[i].cast<float>(), front, 0.03F, sights[i]});
  marks.push_back({{0.14F, 0.057F, 0.0F}, -front, 0.03F, Sight::kKnown});
  renderer_->set_patches(marks);
  const Image image = draw({.show_patches = true, .show_legend = false});
  EXPECT_GT(colour(image, middles[0]).minCoeff(), 0.8F) << "a full disc";
  EXPECT_EQ(colour(image, middles[1]), colour(bare, middles[1])) << "a ring is empty";
  EXPECT_EQ(colour(image, middles[2]), colour(bare, middles[2]));
  // How much each covers, at one place, tells them apart without their colours.
  std::array<int, 3> covered{};
  const Projected at = project(view_, middles[1]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<PatchMark, 1> mark{{{middles[1].cast<float>(), front, 0.03F, sights[i]}}};
    renderer_->set_patches(mark);
    const Image one = draw({.show_patches = true, .show_legend = false});
    for (int y = 0; y < one.height; ++y)
      for (int x = 0; x < one.width; ++x)
        covered[i] +=
            std::hypot(x - at.x, y - at.y) < 20 && one.pixel(x, y)[0] > bare.pixel(x, y)[0] + 40
                ? 1
                : 0;
  }
  EXPECT_GT(covered[0], covered[1] * 5 / 4);
  EXPECT_GT(covered[1], covered[2] * 5 / 4);
  EXPECT_GT(covered[2], 10);
}

// A hand's worth of points before the pipe, and a wall far behind the flange.
TEST_F(OverlayGolden, MeshBehindCloud) {
  set_design();
  test::Measured m;
  const Pose T_design_camera = view_.T_camera_design.inverse();
  const auto square = [&](const Eigen::Vector3d& middle, double nearer_m, int half_px) {
    const Projected at = project(view_, middle);
    for (int dv = -half_px; dv <= half_px; ++dv) {
      for (int du = -half_px; du <= half_px; ++du) {
        m.points.push_back((T_design_camera *
                            view_.camera.back_project(at.x + du, at.y + dv, at.depth_m - nearer_m))
                               .cast<float>());
        m.deviation.push_back(std::numeric_limits<float>::quiet_NaN());
        m.classes.push_back(0);
      }
    }
  };
  square({0.15, 0, 0}, 0.15, 22);
  square(test::kFlangeFace, -0.3, 30);
  set_measured(m);
  const Image image = draw({.shade_cloud = false, .show_legend = false});
  const Eigen::Vector3f hand = colour(image, {0.15, 0, 0}, 5, 9);
  EXPECT_LT((hand - clutter_colour()).cwiseAbs().maxCoeff(),
            0.02F);  // body hidden (no line passes here)
  const Eigen::Vector3f wall = colour(image, {0.4524, -0.06, 0.265}, 0, 6);
  EXPECT_GT((wall - clutter_colour()).cwiseAbs().maxCoeff(), 0.05F);  // seen through the glass
  test::expect_golden("mesh_behind_cloud", image);
}

TEST_F(OverlayGolden, Full) {
  set_design();
  test::Measured m = as_built();
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    if (m.classes[i] == 1 && (m.points[i] - Eigen::Vector3f(0.42F, -0.05F, 0.08F)).norm() < 0.02F)
      m.classes[i] = 2;
  }
  set_measured(m);
  const Image image = draw({.show_legend = false, .lit_parts = {test::kFlange, -1}});
  const Eigen::Vector3f pipe_end = colour(image, {0.03, -0.05, 0.02});
  EXPECT_GT(pipe_end.z(), pipe_end.x() + 0.1F);
  test::expect_golden("full", image);
}

// The one picture with text here; the font is the one that is built in.
TEST_F(OverlayGolden, LegendAndMarkers) {
  resize(400, 480);
  set_measured(as_built());
  const std::vector<Marker> markers{{test::kPipeTop.cast<float>(), Marker::Kind::kProposed, "1"},
                                    {test::kFlangeFace.cast<float>(), Marker::Kind::kPicked, "2"},
                                    {{0.42F, -0.05F, 0.08F}, Marker::Kind::kScan, "3"}};
  renderer_->set_markers(markers);
  const Image image = draw({.show_cloud = true, .show_design = false});
  const Image without = draw({.show_cloud = true, .show_design = false, .show_legend = false});
  int changed = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 200; x < image.width; ++x)
      changed += image.pixel(x, y)[0] != without.pixel(x, y)[0] ? 1 : 0;
  }
  EXPECT_EQ(changed, 0);  // the legend keeps to its side
  test::expect_golden("legend", image);
}

TEST_F(OverlayGolden, LegendInInches) {
  resize(400, 480);
  const Image image = draw({.units = LengthDisplay::kFeetInch});
  test::expect_golden("legend_inch", image);
}

}  // namespace
}  // namespace spool::render
