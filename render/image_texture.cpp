// A picture on the graphics card, for panels to show.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/image_texture.h"

#include "render/gl_status.h"

namespace spool::render {

Result<ImageTexture> ImageTexture::create(const Image& image) {
  if (image.width <= 0 || image.height <= 0)
    return Error{ErrorCode::kBadInput, "the picture has no pixels"};
  ImageTexture out;
  out.width_ = image.width;
  out.height_ = image.height;
  out.texture_ = make_texture();
  glBindTexture(GL_TEXTURE_2D, out.texture_.id());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, image.width, image.height);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                  image.rgba.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  if (const Status done = gl_status("taking a picture to the graphics driver"); !done)
    return done.error();
  return out;
}

}  // namespace spool::render
