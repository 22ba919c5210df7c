// Claims about every screen as it is drawn, on tablets of 7 to 13 inch: what fingers and eyes need.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <imgui.h>

#include <gtest/gtest.h>

#include "app/ui/panels.h"
#include "render/embedded_files.h"

namespace spool::ui {
namespace {

struct Tablet {
  std::string name;
  int width, height;
  double dots_per_inch;
};

const std::vector<Tablet>& tablets() {
  static const std::vector<Tablet> table{
      {"7 inch", 1280, 800, 216},
      {"7 inch, upright", 800, 1280, 216},
      {"10 inch", 1920, 1200, 224},
      {"10 inch, upright", 1200, 1920, 224},
      {"13 inch", 2560, 1600, 227},
      {"13 inch, upright", 1600, 2560, 227},
      {"panel of 7 inch", 800, 480, 133},
      {"10 inch, coarse", 1280, 800, 150},
      {"10 inch, coarse, upright", 800, 1280, 150},
  };
  return table;
}

// Words as long as they come.
ScreenState common(Screen screen) {
  ScreenState state;
  state.screen = screen;
  state.title = "1501-ISO-60085-SP-04";
  state.step = "step 4 of 11";
  state.source = "PS1080 2bc5/0601";
  state.unit = "ft-in";
  state.tracking = TrackingMark::kGood;
  state.hint =
      "Elbow_2 onto pipe_3, W4, fab weld, cut 260.0 mm. Look where it matters, then press Check.";
  state.view_word = "drawing";
  return state;
}

ScreenState align() {
  ScreenState state = common(Screen::kAlign);
  for (int i = 0; i < 3; ++i) state.chips.push_back({i < 2, i == 2, i < 2 ? "11/16\"" : ""});
  state.proposed = "Not to be seen there? Press Other point, or tap another one of the drawing.";
  state.can_skip = state.can_undo = state.can_find = true;
  return state;
}

ScreenState align_done() {
  ScreenState state = align();
  state.can_finish = state.can_go_back = state.menu_open = true;
  state.box_word = "drop it";
  return state;
}

ScreenState choose() {
  ScreenState state = common(Screen::kChoose);
  state.choice = "1 of 2";
  state.choice_evidence = "87 % of what should be seen is seen, 2.1 mm off it.";
  state.detached = true;
  return state;
}

ScreenState work() {
  ScreenState state = common(Screen::kWork);
  state.aligned = state.measured = state.can_accept = true;
  state.accept_word = "Can't tell";
  for (int i = 0; i < 11; ++i)
    state.parts.push_back({i, "elbow_90_long_" + std::to_string(i),
                           i < 9 ? StatusMark::kSuspicious : StatusMark::kNotMeasured,
                           "+1' 2 3/16\"", "± 1 3/16\"", "outside", "72 %"});
  return state;
}

ScreenState work_list_and_menu() {
  ScreenState state = work();
  state.list_open = state.menu_open = state.has_results = state.can_replay = true;
  state.frozen = true;
  return state;
}

ScreenState work_turned_with_menu() {
  ScreenState state = work();
  state.menu_open = state.has_results = state.detached = state.sight_shown = true;
  return state;
}

ScreenState lost() {
  ScreenState state = common(Screen::kWork);
  state.aligned = state.still_shown = state.can_find = state.hint_is_warning = true;
  state.tracking = TrackingMark::kLost;
  state.hint = "Lost: hold still and look where it was last seen.";
  return state;
}

ResultDetail detail(const std::string& number) {
  ResultDetail out;
  out.status = StatusMark::kNotOk;
  out.name = "Alignment of face, pipe_of_the_branch axis to flange_weld_neck_2 face";
  out.number = number;
  out.doubt = "± 1 3/16\", limit ± 1/8\", too long";
  out.to_do = {
      "Turn elbow_2 1.2° clockwise seen from pipe_2 = 7.3 mm at flange_b/face, towards +y of the "
      "drawing.",
      "Move elbow_2 3.0 mm towards -x of the drawing."};
  out.facts = {{"Drawing", "1' 2 3/16\""},
               {"Off by", "+3/16\" ± 1/16\" (k = 2)"},
               {"Rule", "PFI ES-3 3.1, level across two holes"},
               {"Within the limit", "less than 1 in 20"}};
  out.words = "Half a pitch off: its holes look one-holed.";
  return out;
}

ScreenState work_checked() {
  ScreenState state = work();
  state.has_results = state.readout_shown = true;
  state.readout = detail("−1' 2 3/16\"");
  state.readout_of = "Checked 12 s ago · all 44 results, the worst: Out";
  return state;
}

ScreenState results_list() {
  ScreenState state = common(Screen::kResults);
  state.has_results = true;
  state.tracking = TrackingMark::kFrozen;
  state.results.overall = StatusMark::kNotOk;
  state.results.of = "Checked 12 s ago";
  state.results.reason =
      "Of 20 dimensions 4 are proved within tolerance and 1 out of it, 3 cannot be told, 12 were "
      "not measured; 9 of 11 parts were seen well enough to compare, in one frame of the sequence.";
  for (int i = 0; i < 44; ++i)
    state.results.lines.push_back({static_cast<StatusMark>(i % 4), detail("").name,
                                   "−1' 2 3/16\" ± 1 3/16\", limit ± 1/8\", too long"});
  state.results.view_turned = true;
  return state;
}

ScreenState results_detail() {
  ScreenState state = results_list();
  state.results.open = 3;
  state.results.detail = detail("−1' 2 3/16\"");
  return state;
}

struct Case {
  std::string name;
  ScreenState (*state)();
  bool has_number;  // one that decides
};

const std::vector<Case>& cases() {
  static const std::vector<Case> table{
      {"align", align, false},
      {"align, done", align_done, false},
      {"choose", choose, false},
      {"work", work, true},
      {"work, list and menu", work_list_and_menu, true},
      {"work, turned, menu", work_turned_with_menu, true},
      {"work, checked", work_checked, true},
      {"lost", lost, false},
      {"results", results_list, false},
      {"numbers", results_detail, true},
  };
  return table;
}

// A character as it was drawn.
struct DrawnGlyph {
  double size_px = 0;  // of its type
  ImVec2 low, high;    // px
  ImVec4 clip;         // px, what is shown of it
};

// Characters are found in the draw lists by the place in the font's texture that they are copied
// from; how large they are drawn against their glyph's box tells the size of their type.
std::vector<DrawnGlyph> drawn_glyphs(const ImDrawData& data) {
  struct Source {
    const ImFont* font;
    const ImFontGlyph* glyph;
  };
  std::map<std::tuple<float, float, float, float>, Source> sources;
  for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
    for (const ImFontGlyph& glyph : font->Glyphs)
      if (glyph.Visible) sources[{glyph.U0, glyph.V0, glyph.U1, glyph.V1}] = {font, &glyph};
  std::vector<DrawnGlyph> out;
  for (int l = 0; l < data.CmdListsCount; ++l) {
    const ImDrawList& list = *data.CmdLists[l];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
      for (unsigned i = 0; i + 5 < command.ElemCount; i += 3) {
        const unsigned first = index[i] + command.VtxOffset;
        if (index[i + 2] != index[i] + 2 || index[i + 3] != index[i] ||
            index[i + 5] != index[i] + 3)
          continue;
        const ImDrawVert &a = list.VtxBuffer[static_cast<int>(first)],
                         &c = list.VtxBuffer[static_cast<int>(first) + 2];
        const auto source = sources.find({a.uv.x, a.uv.y, c.uv.x, c.uv.y});
        if (source == sources.end()) continue;
        const auto& [font, glyph] = source->second;
        const double scale = double{c.pos.y - a.pos.y} / double{glyph->Y1 - glyph->Y0};
        out.push_back({scale * double{font->FontSize}, a.pos, c.pos, command.ClipRect});
      }
    }
  }
  return out;
}

class DrawnScreens : public testing::Test {
 protected:
  void TearDown() override { ImGui::DestroyContext(); }

  // The second frame of a screen: panels know by then how much they hold.
  void draw(const Tablet& tablet, const ScreenState& state) {
    if (ImGui::GetCurrentContext() != nullptr) ImGui::DestroyContext();
    ImGui::CreateContext();
    dp_ = pixels_per_dp(tablet.dots_per_inch);
    const Result<Theme> theme = load_theme(render::embedded_file("font.otf").value_or(""), dp_);
    ASSERT_TRUE(theme.has_value());
    const Layout layout = lay_out(tablet.width, tablet.height, dp_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(tablet.width), static_cast<float>(tablet.height)};
    for (int i = 0; i < 2; ++i) {
      io.DeltaTime = 1.0F / 30;
      ImGui::NewFrame();
      static_cast<void>(draw_screen(state, *theme, layout, targets_));
      ImGui::Render();
    }
    glyphs_ = drawn_glyphs(*ImGui::GetDrawData());
  }

  // Calls `check` for every screen on every tablet.
  template <class Check>
  void on_all(const Check& check) {
    for (const Tablet& tablet : tablets())
      for (const Case& each : cases()) {
        SCOPED_TRACE(tablet.name + ": " + each.name);
        ASSERT_NO_FATAL_FAILURE(draw(tablet, each.state()));
        check(tablet, each);
      }
  }

  double dp_ = 1;
  TargetList targets_;
  std::vector<DrawnGlyph> glyphs_;
};

TEST_F(DrawnScreens, HaveTargetsOfTwelveMillimetresApartAndOnTheScreen) {
  on_all([&](const Tablet& tablet, const Case& /*each*/) {
    const std::vector<Target>& all = targets_.targets;
    ASSERT_GE(all.size(), 2U);
    for (std::size_t i = 0; i < all.size(); ++i) {
      SCOPED_TRACE(all[i].name);
      const Rect& a = all[i].rect;
      EXPECT_GE(std::min(a.width, a.height) / tablet.dots_per_inch * 25.4, 12.0);
      EXPECT_GE(a.x, -0.01);
      EXPECT_GE(a.y, -0.01);
      EXPECT_LE(a.x + a.width, tablet.width + 0.01);
      EXPECT_LE(a.y + a.height, tablet.height + 0.01);
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        const Rect& b = all[j].rect;
        EXPECT_FALSE(a.x < b.x + b.width - 0.01 && b.x < a.x + a.width - 0.01 &&
                     a.y < b.y + b.height - 0.01 && b.y < a.y + a.height - 0.01)
            << "lies over " << all[j].name;
      }
    }
  });
}

TEST_F(DrawnScreens, SayNothingInTypeUnderFourteen) {
  on_all([&](const Tablet& /*tablet*/, const Case& each) {
    ASSERT_GT(glyphs_.size(), 40U) << "the characters are not found";
    double least = 1e9, most = 0;
    for (const DrawnGlyph& glyph : glyphs_) {
      least = std::min(least, glyph.size_px);
      most = std::max(most, glyph.size_px);
    }
    EXPECT_GE(least, kSmallSp * dp_ - 0.51) << "type is set in whole pixels";
    EXPECT_GE(most, each.has_number ? 28 * dp_ - 0.51 : 0.0);
  });
}

// What does not fit ends in "…"; only what is scrolled may be cut, at top and bottom.
TEST_F(DrawnScreens, CutNoCharacterOffAtTheSide) {
  on_all([&](const Tablet& tablet, const Case& /*each*/) {
    int cut = 0;
    for (const DrawnGlyph& glyph : glyphs_) {
      const bool is_out_of_sight = glyph.high.y < glyph.clip.y || glyph.low.y > glyph.clip.w;
      if (is_out_of_sight) continue;
      const float left = std::max(glyph.clip.x, 0.0F) - 1;
      const float right = std::min(glyph.clip.z, static_cast<float>(tablet.width)) + 1;
      cut += glyph.low.x < left || glyph.high.x > right ? 1 : 0;
    }
    EXPECT_EQ(cut, 0);
  });
}

}  // namespace
}  // namespace spool::ui
