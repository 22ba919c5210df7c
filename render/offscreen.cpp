// The target that every picture is drawn to first: colour and depth, window or not.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/offscreen.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "render/gl_status.h"

namespace spool::render {
namespace {

TextureHandle make_storage(GLenum format, int width, int height) {
  TextureHandle texture = make_texture();
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

bool is_complete(const FramebufferHandle& framebuffer, GLuint colour, GLuint depth) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

Result<Offscreen> Offscreen::create(int width, int height) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  largest = std::min(largest, 16384);
  if (width < 1 || height < 1 || width > largest || height > largest) {
    return Error{ErrorCode::kBadInput,
                 "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " px cannot be drawn; ask for 1 to " + std::to_string(largest) + " px a side"};
  }
  Offscreen target;
  target.width_ = width;
  target.height_ = height;
  target.colour_ = make_storage(GL_RGBA8, width, height);
  target.depth_ = make_storage(GL_DEPTH_COMPONENT24, width, height);
  target.framebuffer_ = make_framebuffer();
  target.colour_framebuffer_ = make_framebuffer();
  const bool complete = is_complete(target.colour_framebuffer_, target.colour_.id(), 0) &&
                        is_complete(target.framebuffer_, target.colour_.id(), target.depth_.id());
  const Status status = gl_status("making a picture of " + std::to_string(width) + " x " +
                                  std::to_string(height) + " px");
  if (!status) return status.error();
  if (!complete) {
    return Error{ErrorCode::kNoDevice,
                 "the graphics driver refuses a drawing target of RGBA8 with 24-bit depth; update "
                 "the driver"};
  }
  return target;
}

void Offscreen::bind() const {
  assert(framebuffer_ && "bind() of a target that was created");
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glViewport(0, 0, width_, height_);
}

void Offscreen::bind_colour() const {
  assert(colour_framebuffer_ && "bind_colour() of a target that was created");
  glBindFramebuffer(GL_FRAMEBUFFER, colour_framebuffer_.id());
  glViewport(0, 0, width_, height_);
}

Image Offscreen::read() const {
  assert(framebuffer_ && "read() of a target that was created");
  const auto row = static_cast<std::size_t>(width_) * 4;
  Image image{width_, height_, {}};
  image.rgba.resize(row * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  // GL's row 0 is the bottom one, a picture's is the top one.
  for (std::size_t top = 0, bottom = static_cast<std::size_t>(height_) - 1; top < bottom;
       ++top, --bottom) {
    std::swap_ranges(image.rgba.begin() + static_cast<std::ptrdiff_t>(top * row),
                     image.rgba.begin() + static_cast<std::ptrdiff_t>((top + 1) * row),
                     image.rgba.begin() + static_cast<std::ptrdiff_t>(bottom * row));
  }
  return image;
}

void Offscreen::copy_to(const Offscreen& other, int x, int y) const {
  assert(framebuffer_ && other.framebuffer_ && this != &other && "two targets that were created");
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, other.framebuffer_.id());
  glDisable(GL_SCISSOR_TEST);  // a blit is scissored too
  const int bottom = other.height_ - y - height_;
  glBlitFramebuffer(0, 0, width_, height_, x, bottom, x + width_, bottom + height_,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Offscreen::show(int width, int height) const {
  assert(framebuffer_ && "show() of a target that was created");
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glDisable(GL_SCISSOR_TEST);  // a blit is scissored too
  const bool same = width == width_ && height == height_;
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                    same ? GL_NEAREST : GL_LINEAR);
}

}  // namespace spool::render
