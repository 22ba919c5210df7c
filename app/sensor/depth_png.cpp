// Depth images as 16-bit grey PNG, by libpng.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/depth_png.h"

#include <bit>
#include <cassert>
#include <csetjmp>
#include <cstddef>
#include <cstring>

#include <png.h>

namespace spool::sensor {
namespace {

// What libpng's callbacks see.
struct Stream {
  std::string_view input;
  std::string output;
  std::string error = "unknown error";
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  static_cast<Stream*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}  // a bad text chunk does not spoil the depth

void on_read(png_structp png, png_bytep data, std::size_t size) {
  auto* stream = static_cast<Stream*>(png_get_io_ptr(png));
  if (stream->input.size() < size) png_error(png, "the file is cut short");
  std::memcpy(data, stream->input.data(), size);
  stream->input.remove_prefix(size);
}

void on_write(png_structp png, png_bytep data, std::size_t size) {
  static_cast<Stream*>(png_get_io_ptr(png))
      ->output.append(reinterpret_cast<const char*>(data), size);
}

void on_flush(png_structp) {}

// libpng leaves by longjmp, so everything with a destructor lives in the callers of these two.
bool read_rows(png_structp png, png_infop info, Stream* stream, png_uint_32 width,
               png_uint_32 height, std::uint16_t* depth, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_read_fn(png, stream, on_read);
  png_read_info(png, info);
  if (png_get_color_type(png, info) != PNG_COLOR_TYPE_GRAY || png_get_bit_depth(png, info) != 16)
    png_error(png, "it is not 16-bit grey");
  if (png_get_image_width(png, info) != width || png_get_image_height(png, info) != height)
    png_error(png, "its size is not the camera's");
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  for (png_uint_32 v = 0; v < height; ++v)
    rows[v] = reinterpret_cast<png_bytep>(depth + std::size_t{v} * width);
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

bool write_rows(png_structp png, png_infop info, Stream* stream, png_uint_32 width,
                png_uint_32 height, const std::uint16_t* depth) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, stream, on_write, on_flush);
  png_set_compression_level(png, 1);
  png_set_filter(png, 0, PNG_FILTER_SUB);
  png_set_IHDR(png, info, width, height, 16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
  for (png_uint_32 v = 0; v < height; ++v)
    png_write_row(png, reinterpret_cast<png_const_bytep>(depth + std::size_t{v} * width));
  png_write_end(png, info);
  return true;
}

}  // namespace

Result<std::vector<std::uint16_t>> decode_depth_png(std::string_view bytes, int width, int height,
                                                    const std::string& name) {
  const auto bad = [&](const std::string& why) {
    return Error{ErrorCode::kBadInput, name + ": is not a depth image of " + std::to_string(width) +
                                           " x " + std::to_string(height) + " pixels (" + why +
                                           "); record it again or correct camera.json"};
  };
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  // Deflate never packs better than 1032 to 1: a small file cannot make us reserve a huge image.
  if (bytes.size() < pixels * 2 / 1032) return bad("the file is cut short");
  Stream stream;
  stream.input = bytes;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &stream, on_error, on_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info == nullptr) {
    png_destroy_read_struct(&png, nullptr, nullptr);
    return Error{ErrorCode::kInternal, name + ": the PNG reader could not start"};
  }
  std::vector<std::uint16_t> depth(pixels);
  std::vector<png_bytep> rows(static_cast<std::size_t>(height));
  const bool good = read_rows(png, info, &stream, static_cast<png_uint_32>(width),
                              static_cast<png_uint_32>(height), depth.data(), rows.data());
  png_destroy_read_struct(&png, &info, nullptr);
  if (!good) return bad(stream.error);
  return depth;
}

Result<std::string> encode_depth_png(std::span<const std::uint16_t> depth, int width, int height) {
  assert(depth.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) &&
         "a count for every pixel");
  Stream stream;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &stream, on_error, on_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  const bool good =
      info != nullptr && write_rows(png, info, &stream, static_cast<png_uint_32>(width),
                                    static_cast<png_uint_32>(height), depth.data());
  png_destroy_write_struct(&png, &info);
  if (!good)
    return Error{ErrorCode::kInternal, "a depth image could not be packed (" + stream.error + ")"};
  return std::move(stream.output);
}

}  // namespace spool::sensor
