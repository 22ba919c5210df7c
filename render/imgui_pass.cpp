// Pass: Dear ImGui's draw lists. The one file of render/ that knows ImGui; no ImGui back end is
// used.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/imgui_pass.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <imgui.h>

#include "render/gl_state.h"
#include "render/gl_status.h"

namespace spool::render {
namespace {

// Gives the digits of a built font the advance of the widest, each in the middle of it.
void make_digits_tabular(ImFont& font) {
  float widest = 0;
  const auto is_digit = [](const ImFontGlyph& g) {
    return g.Codepoint >= '0' && g.Codepoint <= '9';
  };
  for (const ImFontGlyph& glyph : font.Glyphs) {
    if (is_digit(glyph)) widest = std::max(widest, glyph.AdvanceX);
  }
  for (ImFontGlyph& glyph : font.Glyphs) {
    if (!is_digit(glyph)) continue;
    const float aside = 0.5F * (widest - glyph.AdvanceX);
    glyph.X0 += aside;
    glyph.X1 += aside;
    glyph.AdvanceX = widest;
    font.IndexAdvanceX[static_cast<int>(glyph.Codepoint)] = widest;
  }
}

// The vertex layout from `offset` bytes on: GLES 3.0 has no base vertex for long lists.
void point_attributes(std::size_t offset) {
  const auto attribute = [offset](GLuint at, GLint size, GLenum type, GLboolean normalised,
                                  std::size_t member) {
    glEnableVertexAttribArray(at);
    glVertexAttribPointer(at, size, type, normalised, sizeof(ImDrawVert),
                          reinterpret_cast<const void*>(offset + member));
  };
  attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
  attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
}

}  // namespace

Result<ImguiPass> ImguiPass::create() {
  assert(ImGui::GetCurrentContext() != nullptr && "an ImGui context is current");
  auto program = ShaderProgram::create("imgui");
  if (!program) return program.error();
  ImguiPass pass;
  pass.program_ = std::move(*program);
  pass.vertices_ = make_buffer();
  pass.indices_ = make_buffer();
  pass.attributes_ = make_vertex_array();
  const Status fonts = pass.upload_fonts();
  if (!fonts) return fonts.error();
  ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  ImGui::GetIO().BackendRendererName = "SpoolSight GLES 3.0";
  return pass;
}

Status ImguiPass::upload_fonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  unsigned char* rgba = nullptr;
  int width = 0;
  int height = 0;
  atlas.GetTexDataAsRGBA32(&rgba, &width, &height);
  for (ImFont* font : atlas.Fonts) make_digits_tabular(*font);
  fonts_ = make_texture();
  glBindTexture(GL_TEXTURE_2D, fonts_.id());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width, height);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  atlas.SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(fonts_.id())));
  atlas.ClearTexData();
  return gl_status("taking the fonts to the graphics driver");
}

void ImguiPass::set_state(const Offscreen& target, const ImDrawData& data) const {
  target.bind();
  set_draw_state({.blend = Blend::kOver});
  glEnable(GL_SCISSOR_TEST);
  program_.use();
  program_.set("u_origin", Eigen::Vector2f(data.DisplayPos.x, data.DisplayPos.y));
  program_.set("u_size", Eigen::Vector2f(data.DisplaySize.x, data.DisplaySize.y));
  program_.set("u_texture", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindSampler(0, 0);
  glBindVertexArray(attributes_.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
}

Status ImguiPass::draw(const Offscreen& target, const ImDrawData& data) const {
  if (data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0)
    return {};  // a window made small as nothing
  set_state(target, data);
  const ImVec2 origin = data.DisplayPos;
  const ImVec2 scale = data.FramebufferScale;
  constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  for (int n = 0; n < data.CmdListsCount; ++n) {
    const ImDrawList& list = *data.CmdLists[n];
    glBufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
                 GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                 GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback != nullptr) {
        if (command.UserCallback != ImDrawCallback_ResetRenderState)
          command.UserCallback(&list, &command);
        set_state(target, data);
        continue;
      }
      const float left = (command.ClipRect.x - origin.x) * scale.x;
      const float top = (command.ClipRect.y - origin.y) * scale.y;
      const float right = (command.ClipRect.z - origin.x) * scale.x;
      const float bottom = (command.ClipRect.w - origin.y) * scale.y;
      if (right <= left || bottom <= top) continue;
      glScissor(static_cast<GLint>(left),
                static_cast<GLint>(static_cast<float>(target.height()) - bottom),
                static_cast<GLsizei>(right - left), static_cast<GLsizei>(bottom - top));
      point_attributes(command.VtxOffset * sizeof(ImDrawVert));
      glBindTexture(GL_TEXTURE_2D,
                    static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                     reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)));
    }
  }
  glDisable(GL_SCISSOR_TEST);
  return gl_status("drawing the panels");
}

}  // namespace spool::render
