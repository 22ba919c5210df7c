// Points that the graphics card places and colours, beside those that the processor does.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <random>
#include <string>

#include "render/deviation_colour.h"
#include "render/distance_textures.h"
#include "render/gl_state.h"
#include "render/gl_status.h"
#include "render/image_compare.h"
#include "render/overlay.h"
#include "tests/render/gl_test.h"
#include "tests/render/scene.h"
#include "tests/support/shared_data.h"
#include "vision/core/file_io.h"
#include "vision/design/design_surface.h"
#include "vision/design/distance_field.h"

namespace spool::render {
namespace {

constexpr float kBand = 0.03F;
constexpr double kFacingBeyond = 0.004;
constexpr double kFacingCosine = 0.17;

DesignModel spool_design() {
  const test::Scene scene = test::make_spool();
  DesignModel design;
  design.mesh = scene.mesh;
  design.triangle_part = scene.part;
  design.parts.resize(3);
  return design;
}

// The spool of the pictures with its surface and its volume, made once.
struct Spool {
  DesignModel design = spool_design();
  DesignSurface surface = std::move(*DesignSurface::build(design));
  DistanceVolume volume = *make_distance_field(surface, design.bounds(), {.band_m = kBand});
};
const Spool& spool() {
  static const Spool made;
  return made;
}

class DepthCloud : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    auto renderer = OverlayRenderer::create();
    ASSERT_TRUE(renderer) << renderer.error().message;
    renderer_.emplace(std::move(*renderer));
    auto target = Offscreen::create(320, 240);
    ASSERT_TRUE(target) << target.error().message;
    target_ = std::move(*target);
    view_ = test::spool_view(320, 240);
    camera_ = view_.camera;
    camera_.depth_unit_m = 0.0001;
  }
  void TearDown() override {
    renderer_.reset();
    target_ = {};
    GlTest::TearDown();
  }

  // The depth image of an as-built spool over a floor that comes close under it.
  [[nodiscard]] std::vector<std::uint16_t> depth_image() const {
    const test::Measured measured = test::measure(
        test::make_spool(), view_,
        [](test::Part part, const Eigen::Vector3d& p) {
          return part == test::kFlange ? 0.002 + 0.035 * p.y() : -0.012 * p.x();
        },
        -0.062);
    std::vector<std::uint16_t> depth(320 * 240, 0);
    for (const Eigen::Vector3f& point : measured.points) {
      const Projected at = project(view_, point.cast<double>());
      const auto u = std::lround(at.x), v = std::lround(at.y);
      if (u < 0 || v < 0 || u >= 320 || v >= 240) continue;
      depth[static_cast<std::size_t>(v * 320 + u)] =
          static_cast<std::uint16_t>(std::lround(at.depth_m / camera_.depth_unit_m));
    }
    return depth;
  }
  [[nodiscard]] DepthPoints points_of(const std::vector<std::uint16_t>& depth) const {
    return {.depth = depth,
            .camera = camera_,
            .T_design_camera = view_.T_camera_design.inverse(),
            .facing_beyond_m = kFacingBeyond,
            .facing_cosine = kFacingCosine};
  }
  // The same by the processor: exact distances, and what is turned away is clutter.
  [[nodiscard]] test::Measured measured_exactly(const std::vector<std::uint16_t>& depth) const {
    test::Measured out;
    const Pose T_design_camera = view_.T_camera_design.inverse();
    for (int v = 0; v < 240; ++v)
      for (int u = 0; u < 320; ++u) {
        const std::uint16_t count = depth[static_cast<std::size_t>(v * 320 + u)];
        if (count == 0) continue;
        const Eigen::Vector3f p =
            (T_design_camera * camera_.back_project(u, v, count * camera_.depth_unit_m))
                .cast<float>();
        const auto nearest = spool().surface.closest(p, kBand);
        bool is_object = nearest.has_value();
        if (is_object && std::abs(nearest->distance) > kFacingBeyond) {
          const Eigen::Vector3f to_eye =
              T_design_camera.translation().cast<float>() - nearest->point;
          is_object = nearest->normal.dot(to_eye) >= kFacingCosine * to_eye.norm();
        }
        out.points.push_back(p);
        out.classes.push_back(is_object ? 1 : 0);
        out.deviation.push_back(is_object ? nearest->distance
                                          : std::numeric_limits<float>::quiet_NaN());
      }
    return out;
  }
  [[nodiscard]] Image draw(const OverlayStyle& style) {
    const Status status = renderer_->draw(target_, view_, style);
    EXPECT_TRUE(status) << status.error().message;
    return target_.read();
  }
  static OverlayStyle plain() {
    return {.shade_cloud = false, .show_design = false, .show_legend = false};
  }

  std::optional<OverlayRenderer> renderer_;
  Offscreen target_;
  View view_;
  Camera camera_;
};

TEST_F(DepthCloud, LooksUpWhatTheProcessorLooksUp) {
  const auto include = read_file(test::source_dir() / "shaders/distance_volume.glsl");
  ASSERT_TRUE(include);
  const std::string fragment =
      "#version 300 es\nprecision highp float;\nprecision highp int;\n" + *include + R"(
uniform highp sampler2D u_points;
out uvec4 o_bits;
void main() {
  VolumeCell cell = volume_cell(texelFetch(u_points, ivec2(gl_FragCoord.xy), 0).xyz);
  float distance_m;
  bool is_known = volume_distance(cell, distance_m);
  vec3 outward = is_known ? volume_outward(cell) : vec3(0.0);
  o_bits = uvec4(floatBitsToUint(distance_m), is_known ? 1u : 0u, floatBitsToUint(outward.x),
                 floatBitsToUint(outward.y));
})";
  const std::string vertex = R"(#version 300 es
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
})";
  auto linked = link_program({"test.vert", vertex}, {"test.frag", fragment});
  ASSERT_TRUE(linked) << linked.error().message;
  const ShaderProgram program(std::move(*linked));

  constexpr int kSide = 256;
  const Eigen::AlignedBox3d bounds = spool().design.bounds();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.1, 1.1);
  std::vector<Eigen::Vector4f> places(kSide * kSide);
  for (Eigen::Vector4f& place : places)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      place[axis] = static_cast<float>(bounds.min()[axis] + bounds.sizes()[axis] * uniform(random));
  const auto texture = [&](GLint internal, GLenum format, GLenum type, const void* data) {
    TextureHandle made = make_texture();
    glBindTexture(GL_TEXTURE_2D, made.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, kSide, kSide, 0, format, type, data);
    return made;
  };
  const TextureHandle answers = texture(GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
  const FramebufferHandle framebuffer = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, answers.id(), 0);
  ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  glViewport(0, 0, kSide, kSide);
  set_draw_state({});

  DistanceTextures textures;
  ASSERT_TRUE(textures.set(spool().volume));
  const TextureHandle points = texture(GL_RGBA32F, GL_RGBA, GL_FLOAT, places.data());
  program.use();
  program.set("u_points", 0);
  textures.bind(program, 1);
  glBindTexture(GL_TEXTURE_2D, points.id());
  const VertexArrayHandle no_attributes = make_vertex_array();
  glBindVertexArray(no_attributes.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<std::array<std::uint32_t, 4>> bits(kSide * kSide);
  glReadPixels(0, 0, kSide, kSide, GL_RGBA_INTEGER, GL_UNSIGNED_INT, bits.data());
  ASSERT_TRUE(gl_status("the test's look-ups"));

  int known = 0, turned = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto expected = spool().volume.at(places[i].head<3>());
    const auto distance = std::bit_cast<float>(bits[i][0]);
    const bool is_known = bits[i][1] != 0;
    if (expected && std::abs(expected->distance_m) > kBand - 5e-5F) continue;  // the band's edge
    if (!expected && std::abs(std::abs(distance) - kBand) < 5e-5F) continue;
    ASSERT_EQ(is_known, expected.has_value()) << places[i].transpose() << " " << distance;
    if (!expected) continue;
    ++known;
    // Filters weigh in steps of 1/256 of a cell of up to 16 mm.
    EXPECT_NEAR(distance, expected->distance_m, 5e-5F) << places[i].transpose();
    const Eigen::Vector2f outward(std::bit_cast<float>(bits[i][2]),
                                  std::bit_cast<float>(bits[i][3]));
    if ((outward - expected->outward.head<2>()).norm() > 0.05F) ++turned;
  }
  EXPECT_GT(known, 5000);
  EXPECT_LT(turned, known / 200);  // where two pieces are equally near either may count
}

TEST_F(DepthCloud, DrawsThePictureThatExactDistancesGive) {
  ASSERT_TRUE(renderer_->set_distances(spool().volume));
  const std::vector<std::uint16_t> depth = depth_image();
  const test::Measured exact = measured_exactly(depth);
  renderer_->set_points(exact.points, exact.deviation, exact.classes);
  const Image by_processor = draw(plain());
  renderer_->set_depth(points_of(depth), true);
  const Image by_card = draw(plain());
  // Colours are off by up to 3 of 255 for 0.1 mm, and more where a point's class or nearest edge is
  // in doubt: a few pixels.
  const auto compared = compare_images(by_card, by_processor,
                                       {.max_abs_diff = 5, .max_fraction = 0.005, .max_mean = 0.3});
  EXPECT_TRUE(compared.passed) << compared.summary();
  // What there is to see: blue pipe, red and blue flange, floor.
  renderer_->set_points({}, {}, {});
  EXPECT_GT(compare_images(by_card, draw(plain()), {}).fraction_beyond, 0.3);
}

TEST_F(DepthCloud, DrawsTheSameFromAnotherPlace) {
  ASSERT_TRUE(renderer_->set_distances(spool().volume));
  const std::vector<std::uint16_t> depth = depth_image();
  const test::Measured exact = measured_exactly(depth);
  const DepthPoints points = points_of(depth);
  view_.T_camera_design = view_.T_camera_design * Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ());
  OverlayStyle style = plain();
  style.point_spacing_m = 0.003;
  renderer_->set_points(exact.points, exact.deviation, exact.classes);
  const Image by_processor = draw(style);
  renderer_->set_depth(points, true);
  const auto compared = compare_images(draw(style), by_processor,
                                       {.max_abs_diff = 5, .max_fraction = 0.005, .max_mean = 0.3});
  EXPECT_TRUE(compared.passed) << compared.summary();
}

TEST_F(DepthCloud, DrawsNothingWhereNothingWasMeasuredAndNoClutterThatIsNotWanted) {
  ASSERT_TRUE(renderer_->set_distances(spool().volume));
  const Image nothing = draw({.show_cloud = false, .show_design = false, .show_legend = false});
  std::vector<std::uint16_t> depth(320 * 240, 0);
  renderer_->set_depth(points_of(depth), true);
  EXPECT_EQ(draw(plain()).rgba, nothing.rgba);
  depth[120 * 320 + 160] = 3000;  // 0.3 m before the camera: far from the spool
  renderer_->set_depth(points_of(depth), true);
  const Image with = draw(plain());
  const std::uint8_t* pixel = with.pixel(160, 120);
  EXPECT_LT((Eigen::Vector3f(pixel[0], pixel[1], pixel[2]) / 255 - clutter_colour())
                .cwiseAbs()
                .maxCoeff(),
            1.5F / 255);
  OverlayStyle style = plain();
  style.show_clutter = false;
  EXPECT_EQ(draw(style).rgba, nothing.rgba);
}

TEST_F(DepthCloud, TakesAnImageOfAnotherSizeAndGoesBackToPoints) {
  ASSERT_TRUE(renderer_->set_distances(spool().volume));
  const std::vector<std::uint16_t> depth = depth_image();
  renderer_->set_depth(points_of(depth), true);
  const Image first = draw(plain());
  const std::vector<std::uint16_t> small(81, 0);  // odd, so that rows are not aligned
  DepthPoints other = points_of(small);
  other.camera.width = other.camera.height = 9;
  renderer_->set_depth(other, false);
  static_cast<void>(draw(plain()));
  renderer_->set_depth(points_of(depth), true);
  EXPECT_EQ(draw(plain()).rgba, first.rgba);
  renderer_->set_points({}, {}, {});
  EXPECT_EQ(draw(plain()).rgba,
            draw({.show_cloud = false, .show_design = false, .show_legend = false}).rgba);
}

}  // namespace
}  // namespace spool::render
