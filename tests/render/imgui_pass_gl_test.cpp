// Dear ImGui's lists through our own pass.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <functional>

#include <imgui.h>

#include <GLES3/gl3.h>

#include "render/embedded_files.h"
#include "render/gl_state.h"
#include "render/imgui_pass.h"
#include "tests/render/gl_test.h"
#include "tests/render/golden.h"

namespace spool::render {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

class ImguiPassGl : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    context_ = ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {kWidth, kHeight};
    io.DeltaTime = 1.0F / 60;
    auto target = Offscreen::create(kWidth, kHeight);
    ASSERT_TRUE(target);
    target_ = std::move(*target);
  }
  void TearDown() override {
    pass_ = {};
    target_ = {};
    if (context_ != nullptr) ImGui::DestroyContext(context_);
    GlTest::TearDown();
  }
  void make_pass() {
    auto pass = ImguiPass::create();
    ASSERT_TRUE(pass) << pass.error().message;
    pass_ = std::move(*pass);
  }
  // One frame of `panels` over grey, as a picture.
  Image draw(const std::function<void()>& panels) {
    ImGui::NewFrame();
    panels();
    ImGui::Render();
    target_.bind();
    set_draw_state({.depth_write = true});
    glClearColor(0.5F, 0.5F, 0.5F, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Status status = pass_.draw(target_, *ImGui::GetDrawData());
    EXPECT_TRUE(status) << status.error().message;
    return target_.read();
  }

  ImGuiContext* context_ = nullptr;
  ImguiPass pass_;
  Offscreen target_;
};

TEST_F(ImguiPassGl, FillsExactlyTheRectangleItIsTold) {
  make_pass();
  const Image image = draw([] {
    ImGui::GetForegroundDrawList()->AddRectFilled({40, 30}, {80, 50}, IM_COL32(200, 100, 50, 255));
  });
  int filled = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) filled += image.pixel(x, y)[0] == 200 ? 1 : 0;
  }
  EXPECT_EQ(filled, 40 * 20);
  EXPECT_EQ(image.pixel(40, 30)[1], 100);
  EXPECT_EQ(image.pixel(79, 49)[1], 100);
  EXPECT_EQ(image.pixel(80, 49)[1], 128);
}

TEST_F(ImguiPassGl, BlendsAndLeavesThePictureOpaque) {
  make_pass();
  const Image image = draw([] {
    ImGui::GetForegroundDrawList()->AddRectFilled({0, 0}, {320, 240}, IM_COL32(255, 0, 0, 128));
  });
  EXPECT_NEAR(image.pixel(100, 100)[0], 128 + (255 - 128) * 128 / 255, 2);
  EXPECT_NEAR(image.pixel(100, 100)[1], 128 - 128 * 128 / 255, 2);
  EXPECT_EQ(image.pixel(100, 100)[3], 255);
}

TEST_F(ImguiPassGl, ClipsToTheListsRectangleFromTheTop) {
  make_pass();
  const Image image = draw([] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.PushClipRect({0, 0}, {320, 20});
    list.AddRectFilled({0, 0}, {320, 240}, IM_COL32(0, 255, 0, 255));
    list.PopClipRect();
  });
  EXPECT_EQ(image.pixel(160, 10)[1], 255);
  EXPECT_EQ(image.pixel(160, 30)[1], 128);
  EXPECT_EQ(image.pixel(160, 230)[1], 128);
}

TEST_F(ImguiPassGl, DigitsOfEveryFontAreEquallyWide) {
  const auto file = embedded_file("font.otf");
  ASSERT_TRUE(file);
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  ImFont* font = ImGui::GetIO().Fonts->AddFontFromMemoryTTF(
      const_cast<char*>(file->data()), static_cast<int>(file->size()), 28, &config);
  ASSERT_NE(font, nullptr);
  make_pass();
  const float width = font->GetCharAdvance('0');
  for (ImWchar digit = '0'; digit <= '9'; ++digit) {
    EXPECT_EQ(font->GetCharAdvance(digit), width);       // where text is measured
    EXPECT_EQ(font->FindGlyph(digit)->AdvanceX, width);  // and where it is drawn
  }
}

TEST_F(ImguiPassGl, LongListsKeepTheirShapeBeyondSixteenBitIndices) {
  make_pass();
  const Image image = draw([] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    for (int i = 0; i < 20000; ++i) list.AddRectFilled({0, 0}, {4, 4}, IM_COL32(255, 255, 0, 255));
    list.AddRectFilled({300, 200}, {310, 210}, IM_COL32(0, 0, 255, 255));
  });
  EXPECT_EQ(image.pixel(305, 205)[2], 255);
  EXPECT_EQ(image.pixel(305, 205)[0], 0);
}

TEST_F(ImguiPassGl, DrawsNothingForAWindowOfNoSize) {
  make_pass();
  ImGui::NewFrame();
  ImGui::Render();
  ImDrawData data = *ImGui::GetDrawData();
  data.DisplaySize = {0, 0};
  EXPECT_TRUE(pass_.draw(target_, data));
}

TEST_F(ImguiPassGl, GoldenPanel) {
  make_pass();
  const Image image = draw([] {
    ImGui::SetNextWindowPos({20, 20});
    ImGui::SetNextWindowSize({200, 120});
    ImGui::Begin("Panel", nullptr, ImGuiWindowFlags_NoSavedSettings);
    // No text: type has pictures of its own.
    ImGui::ColorButton("##a", {0.17F, 0.72F, 0.54F, 1}, 0, {60, 30});
    float share = 0.4F;
    ImGui::SliderFloat("##b", &share, 0, 1, "");
    ImGui::End();
  });
  EXPECT_EQ(image.pixel(300, 200)[0], 128);  // outside the panel: untouched
  test::expect_golden("imgui_panel", image);
}

}  // namespace
}  // namespace spool::render
