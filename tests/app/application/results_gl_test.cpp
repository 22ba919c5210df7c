// The results of a check on the screen: the readout, the list, the numbers of one, and back.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "render/image.h"
#include "tests/app/application/bench.h"

namespace spool {
namespace {

class Results : public test::Bench {
 protected:
  void check() {
    pick_three();
    press("Done");
    ASSERT_EQ(screen_["screen"], "work") << screen_.dump();
    ASSERT_FALSE(offers("Results")) << "nothing was checked";
    press("Check");
    for (int i = 0; i < 10 && !screen_.contains("readout"); ++i) step();
    ASSERT_TRUE(screen_.contains("readout")) << screen_.dump();
  }

  // What a part covers of the picture beside the rows, px: its corners' box.
  [[nodiscard]] Eigen::AlignedBox2d box_of(std::size_t part) const {
    const Part& of = design_->model.parts[part];
    Eigen::AlignedBox2d box;
    for (std::uint32_t t = 0; t < of.triangle_count; ++t)
      for (const std::uint32_t v : design_->model.mesh.triangles[of.first_triangle + t])
        if (const auto spot = test::spot_in(screen_["results"]["view"],
                                            design_->model.mesh.vertices[v].cast<double>()))
          box.extend(Eigen::Vector2d(spot->x, spot->y));
    return box;
  }
  [[nodiscard]] test::Spot middle_of(std::size_t part) const {
    const Eigen::Vector2d middle = box_of(part).center();
    return {middle.x(), middle.y()};
  }
  [[nodiscard]] render::Image picture() const { return app_->picture().target().read(); }
  // How many pixels of the steel differ within a box, and beside it.
  [[nodiscard]] std::pair<int, int> changed(const render::Image& before,
                                            const Eigen::AlignedBox2d& box) const {
    const render::Image now = picture();
    const auto rect = screen_["results"]["view"].at("rect").get<std::vector<double>>();
    std::pair<int, int> count;
    for (int y = static_cast<int>(rect[1]); y < rect[1] + rect[3]; ++y)
      for (int x = 0; x < rect[2]; ++x) {
        const std::uint8_t *a = before.pixel(x, y), *b = now.pixel(x, y);
        if (std::equal(a, a + 3, b)) continue;
        ++(box.exteriorDistance(Eigen::Vector2d(x, y)) <= 6 ? count.first : count.second);
      }
    return count;
  }
};

TEST_F(Results, OpenFromTheCardListEverythingAndLightWhatIsOpened) {
  start(test::standing_still(60), 1280, 800);
  ASSERT_NO_FATAL_FAILURE(check());
  press("Results");
  ASSERT_EQ(screen_["screen"], "results");
  ASSERT_EQ(screen_["results"]["rows"], 3) << "a bracket has no dimensions: its three parts";
  EXPECT_EQ(screen_["results"]["open"], -1);
  EXPECT_FALSE(screen_["results"].contains("lit"));
  const render::Image list = picture();
  press("Row 1");
  EXPECT_EQ(screen_["results"]["open"], 1);
  ASSERT_EQ(screen_["results"]["lit"].size(), 1U);
  EXPECT_EQ(screen_["results"]["lit"][0], "arm");
  const auto [of_arm, beside] = changed(list, box_of(1));
  EXPECT_GT(of_arm, 100) << "lit in the picture";
  EXPECT_EQ(beside, 0) << "and no other";
  press("Back");
  EXPECT_EQ(screen_["results"]["open"], -1);
  EXPECT_EQ(changed(list, box_of(1)), std::pair(0, 0));
  press("Back");
  EXPECT_EQ(screen_["screen"], "work");
  EXPECT_TRUE(offers("Check"));
}

TEST_F(Results, OpenThePartThatIsTappedAndGoBackWhereOneCameFrom) {
  start(test::standing_still(60), 1280, 800);
  ASSERT_NO_FATAL_FAILURE(check());
  press("Results");
  tap_at(middle_of(2));
  ASSERT_EQ(screen_["results"]["open"], 2);
  EXPECT_EQ(screen_["results"]["lit"][0], "post");
  press("Back");
  EXPECT_EQ(screen_["results"]["open"], -1) << "to the list";
  press("Back");
  ASSERT_EQ(screen_["screen"], "work");
  // On the Work screen the picture is another size: look for the part's place there.
  for (int y = 100; y < 600 && screen_["screen"] == "work"; y += 40)
    for (int x = 300; x < 1000 && screen_["screen"] == "work"; x += 40)
      tap_at({static_cast<double>(x), static_cast<double>(y)});
  ASSERT_EQ(screen_["screen"], "results");
  EXPECT_GE(screen_["results"]["open"], 0);
  press("Back");
  EXPECT_EQ(screen_["screen"], "work") << "there was no list";
}

TEST_F(Results, AreOfOneStateWhileTheCameraGoesOn) {
  std::vector<test::Step> steps;
  for (int i = 0; i < 70; ++i) {
    const Pose T = test::T_design_camera(0, 0.003 * std::max(0, i - 30));
    steps.push_back(test::frame_step(test::render_frame(*design_, T, i)));
  }
  start(std::move(steps));
  ASSERT_NO_FATAL_FAILURE(check());
  press("Results");
  const auto view = screen_["results"]["view"];
  const auto steel = [&] {
    render::Image image = app_->picture().target().read();
    const auto rect = view.at("rect").get<std::vector<double>>();
    std::vector<std::uint8_t> out;
    for (int y = static_cast<int>(rect[1]); y < rect[1] + rect[3]; ++y)
      for (int x = 0; x < rect[2]; ++x)
        out.insert(out.end(), image.pixel(x, y), image.pixel(x, y) + 3);
    return out;
  };
  const auto first = steel();
  play_to_the_end();
  EXPECT_EQ(screen_["results"]["view"], view);
  EXPECT_TRUE(steel() == first) << "to the last pixel";
  EXPECT_EQ(screen_["tracking"], "good") << "it was followed all the time";
  press("Back");
  EXPECT_EQ(screen_["screen"], "work");
}

TEST_F(Results, LeaveTheCardWhenTheSteelWasMovedAndStayInTheMenu) {
  DesignModel moved = test::bracket_design();  // its post is built 15 mm aside
  const Part& post = moved.parts[2];
  std::set<std::uint32_t> of_post;
  for (std::uint32_t t = 0; t < post.triangle_count; ++t)
    for (const std::uint32_t v : moved.mesh.triangles[post.first_triangle + t]) of_post.insert(v);
  for (const std::uint32_t v : of_post) moved.mesh.vertices[v].z() += 0.015F;
  const auto built = PreparedDesign::prepare(std::move(moved));
  ASSERT_TRUE(built.has_value());
  std::vector<test::Step> steps = test::standing_still(30);
  for (int i = 30; i < 120; ++i)
    steps.push_back(test::frame_step(test::render_frame(**built, test::T_design_camera(), i)));
  start(std::move(steps));
  ASSERT_NO_FATAL_FAILURE(check());
  for (int i = 0; i < 120 && screen_.contains("readout"); ++i) step();
  EXPECT_FALSE(screen_.contains("readout")) << "the picture is not what was checked any more";
  EXPECT_NE(std::string(screen_["hint"]).find("press Check again"), std::string::npos)
      << screen_["hint"];
  EXPECT_FALSE(offers("Results"));
  press("More");
  press("Results");
  EXPECT_EQ(screen_["screen"], "results");
}

// A finger that drags the list opens nothing; the rows go with it.
TEST_F(Results, ScrollWithTheFinger) {
  start(test::standing_still(40), 480, 330);  // so low that three rows do not fit
  ASSERT_NO_FATAL_FAILURE(check());
  press("Results");
  ASSERT_FALSE(offers("Row 2"));
  const auto from = test::target(screen_, "Row 0");
  ASSERT_TRUE(from.has_value()) << screen_.dump();
  step({{0, ui::TouchPhase::kDown, from->x, from->y, 0, 0}});
  for (int i = 1; i <= 10; ++i)
    step({{0, ui::TouchPhase::kMove, from->x, from->y - 18.0 * i, 0, 0}});
  step({{0, ui::TouchPhase::kUp, from->x, from->y - 180, 0, 0}});
  step();
  EXPECT_EQ(screen_["results"]["open"], -1) << "a drag is no tap";
  EXPECT_TRUE(offers("Row 2")) << screen_.dump();
  EXPECT_FALSE(offers("Row 0"));
}

}  // namespace
}  // namespace spool
