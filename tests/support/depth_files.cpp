// The files of a depth folder: text, and PNG by libpng.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/depth_files.h"

#include <csetjmp>
#include <cstdio>
#include <vector>

#include <png.h>

#include <gtest/gtest.h>

#include "tests/support/write_file.h"

namespace spool::test {

namespace {

void on_write(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

// libpng leaves by longjmp: no destructors in here.
bool write_png(png_structp png, png_infop info, std::string* to, png_uint_32 width,
               png_uint_32 height, int bits, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, to, on_write, nullptr);
  png_set_IHDR(png, info, width, height, bits, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_write_image(png, rows);
  png_write_end(png, info);
  return true;
}

}  // namespace

std::string CameraText::json() const {
  const auto member = [](const char* key, const std::string& value) {
    return value.empty() ? std::string() : ", \"" + std::string(key) + "\": " + value;
  };
  return R"({"width": )" + width + member("height", height) + member("fx", fx) + member("fy", fy) +
         member("cx", cx) + member("cy", cy) + member("depth_unit_m", depth_unit_m) + more + "}";
}

std::string grey_png(std::span<const std::uint16_t> values, int width, int height, int bits) {
  const auto columns = static_cast<std::size_t>(width), lines = static_cast<std::size_t>(height);
  EXPECT_EQ(values.size(), columns * lines) << "a value for every pixel";
  std::vector<png_byte> bytes;  // the format's own order: the high byte first
  for (const std::uint16_t value : values) {
    if (bits == 16) bytes.push_back(static_cast<png_byte>(value >> 8));
    bytes.push_back(static_cast<png_byte>(value & 0xFF));
  }
  std::vector<png_bytep> rows;
  for (std::size_t v = 0; v < lines; ++v) rows.push_back(bytes.data() + v * (bytes.size() / lines));
  std::string png_file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  EXPECT_TRUE(write_png(png, info, &png_file, static_cast<png_uint_32>(width),
                        static_cast<png_uint_32>(height), bits, rows.data()));
  png_destroy_write_struct(&png, &info);
  return png_file;
}

void write_blank_recording(const std::filesystem::path& folder, const CameraText& camera,
                           int frames, int width, int height) {
  std::filesystem::create_directories(folder / "depth");
  write_file(folder / "camera.json", camera.json());
  const std::vector<std::uint16_t> nothing(
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  const std::string png = grey_png(nothing, width, height);
  for (int i = 0; i < frames; ++i) {
    char name[16];
    std::snprintf(name, sizeof name, "%06d.png", i);
    write_file(folder / "depth" / name, png);
  }
}

}  // namespace spool::test
