// Pictures to and from PNG, by libpng's memory-safe interface.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/image.h"

#include <cassert>
#include <cstring>
#include <new>

#include <png.h>

#include "vision/core/file_io.h"

namespace spool::render {
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t{1} << 30;  // bytes
constexpr std::uint32_t kLargestSide = 16384;                   // px

// True where the chunks follow one another to IEND inside `bytes`: the reader below stops at the
// last row and would not notice a file cut after it. PNG specification, 5.3.
bool has_whole_chunks(std::string_view bytes) {
  std::size_t at = 8;  // signature
  while (bytes.size() >= at + 12) {
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length = length << 8U | static_cast<unsigned char>(bytes[at + i]);
    }
    if (length > bytes.size() - at - 12) return false;
    if (bytes.substr(at + 4, 4) == "IEND") return true;
    at += 12 + static_cast<std::size_t>(length);
  }
  return false;
}

Error bad(const std::string& why) {
  return {ErrorCode::kBadInput,
          "not a readable PNG picture (" + why + "); give a whole PNG of at most 16384 px a side"};
}

// Frees what libpng holds whichever way the function is left.
struct PngImage {
  png_image value{};
  PngImage() { value.version = PNG_IMAGE_VERSION; }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { png_image_free(&value); }
};

}  // namespace

Result<std::string> encode_png(const Image& image) {
  assert(image.width > 0 && image.height > 0 &&
         image.rgba.size() ==
             4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) &&
         "a whole image");
  PngImage png;
  png.value.width = static_cast<png_uint_32>(image.width);
  png.value.height = static_cast<png_uint_32>(image.height);
  png.value.format = PNG_FORMAT_RGBA;
  const auto failed = [&png] {
    return Error{ErrorCode::kInternal,
                 "libpng could not encode the picture: " + std::string(png.value.message)};
  };
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.value);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png.value, bytes.data(), &size, 0, image.rgba.data(), 0,
                                nullptr) == 0) {
    return failed();
  }
  bytes.resize(size);
  return bytes;
}

Result<Image> decode_png(std::string_view bytes) {
  PngImage png;
  if (png_image_begin_read_from_memory(&png.value, bytes.data(), bytes.size()) == 0) {
    return bad(png.value.message);
  }
  const std::uint64_t pixels = std::uint64_t{png.value.width} * png.value.height;
  if (png.value.width > kLargestSide || png.value.height > kLargestSide) {
    return bad(std::to_string(png.value.width) + " x " + std::to_string(png.value.height) + " px");
  }
  // Deflate expands at most 1032 times and a pixel takes at least one bit: a small file that
  // announces a huge picture is refused before memory is taken for it.
  if (pixels / 8 / 1032 > bytes.size() || !has_whole_chunks(bytes)) return bad("it is cut short");
  png.value.format = PNG_FORMAT_RGBA;
  png.value.flags |=
      PNG_IMAGE_FLAG_16BIT_sRGB;  // 16-bit values are scaled, not taken as linear light
  Image image{static_cast<int>(png.value.width), static_cast<int>(png.value.height), {}};
  image.rgba.resize(static_cast<std::size_t>(pixels) * 4);
  if (png_image_finish_read(&png.value, nullptr, image.rgba.data(), 0, nullptr) == 0) {
    return bad(png.value.message);
  }
  return image;
}

Status write_png(const std::filesystem::path& path, const Image& image) {
  const auto bytes = encode_png(image);
  if (!bytes) return bytes.error();
  return write_file_whole(path, *bytes);
}

Result<Image> read_png(const std::filesystem::path& path) {
  const auto bytes = read_file(path, kLargestFile);
  if (!bytes) return bytes.error();
  auto image = decode_png(*bytes);
  if (!image) return Error{image.error().code, path.string() + ": " + image.error().message};
  return image;
}

}  // namespace spool::render
