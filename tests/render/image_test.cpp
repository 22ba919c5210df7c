// PNG there and back, and what is refused.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/image.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "vision/core/file_io.h"

namespace spool::render {
namespace {

Image noise(int width, int height) {
  std::mt19937 random(1);
  Image image{width, height, {}};
  image.rgba.resize(4 * static_cast<std::size_t>(width * height));
  for (auto& byte : image.rgba) byte = static_cast<std::uint8_t>(random());
  return image;
}

TEST(Png, ReturnsEveryByteItWasGiven) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {320, 240}}) {
    const Image image = noise(width, height);
    const auto bytes = encode_png(image);
    ASSERT_TRUE(bytes);
    const auto again = decode_png(*bytes);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->width, width);
    EXPECT_EQ(again->height, height);
    EXPECT_EQ(again->rgba, image.rgba);
  }
}

TEST(Png, EncodesTheSameBytesEveryTime) {
  EXPECT_EQ(*encode_png(noise(20, 20)), *encode_png(noise(20, 20)));
}

TEST(Png, RefusesEveryTruncation) {
  const auto bytes = encode_png(noise(16, 16));
  ASSERT_TRUE(bytes);
  for (std::size_t length = 0; length < bytes->size(); ++length) {
    const auto image = decode_png(std::string_view(*bytes).substr(0, length));
    ASSERT_FALSE(image) << length << " of " << bytes->size() << " bytes";
    EXPECT_EQ(image.error().code, ErrorCode::kBadInput);
  }
}

TEST(Png, SurvivesFlippedBytes) {
  const auto bytes = encode_png(noise(16, 16));
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    std::string damaged = *bytes;
    damaged[random() % damaged.size()] = static_cast<char>(random());
    (void)decode_png(damaged);  // no crash; the sanitizers watch
  }
}

// CRC-32 as PNG specification, annex D, bit by bit.
std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

// A well-formed header that announces 16384 x 16384 px (a gigabyte) in a file of a hundred bytes.
TEST(Png, RefusesAHugePictureInATinyFileBeforeTakingMemory) {
  std::string bomb = *encode_png(noise(1, 1));
  bomb.replace(16, 8, std::string_view("\0\0\x40\0\0\0\x40\0", 8));
  const std::uint32_t crc = crc32(std::string_view(bomb).substr(12, 17));
  for (std::size_t i = 0; i < 4; ++i) bomb[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
  const auto image = decode_png(bomb);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::kBadInput);
  EXPECT_NE(image.error().message.find("cut short"), std::string::npos) << image.error().message;
}

TEST(Png, NamesTheFileThatIsNoPicture) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "notes.png";
  ASSERT_TRUE(write_file_whole(path, "not a picture"));
  const auto image = read_png(path);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::kBadInput);
  EXPECT_NE(image.error().message.find("notes.png"), std::string::npos) << image.error().message;
  EXPECT_NE(image.error().message.find("give a whole PNG"), std::string::npos);
}

TEST(Png, WritesAndReadsAFileAndSaysWhereItCannot) {
  const test::TemporaryFolder folder;
  const Image image = noise(5, 4);
  ASSERT_TRUE(write_png(folder.path() / "a.png", image));
  const auto again = read_png(folder.path() / "a.png");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->rgba, image.rgba);
  const Status status = write_png(folder.path() / "absent" / "a.png", image);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kIo);
  EXPECT_FALSE(read_png(folder.path() / "b.png"));
}

}  // namespace
}  // namespace spool::render
