// Damaged, hostile and cut-short cloud files: each is refused with its sentence, none crashes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/vision/scan/cloud_samples.h"
#include "vision/scan/cloud_file.h"
#include "vision/scan/lzf.h"

namespace spool {
namespace {

struct Refusal {
  const char* name;
  const char* ending;
  std::string bytes;
  const char* text;  // in the message
};

std::string ply(const std::string& header, const std::string& body = "0 0 0\n1 1 1\n") {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

std::string pcd(const std::string& fields, const std::string& size, const std::string& data,
                const std::string& body = "0 0 0\n1 1 1\n") {
  return "VERSION 0.7\n" + fields + size + "DATA " + data + "\n" + body;
}

const std::string kPcdXyz = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
const std::string kTwo = "WIDTH 2\nHEIGHT 1\nPOINTS 2\n";

std::vector<Refusal> refusals() {
  return {
      {"empty", ".ply", "", "is empty"},
      {"another kind", ".ply", "solid x\n", "is not a PLY file"},
      {"no format", ".ply", "ply\nelement vertex 1\n" + kXyz + "end_header\n0 0 0\n",
       "no format line"},
      {"unknown format", ".ply", "ply\nformat binary_middle_endian 1.0\nend_header\n",
       "header line 2"},
      {"another version", ".ply", "ply\nformat ascii 2.0\nend_header\n", "header line 2"},
      {"negative count", ".ply", ply("element vertex -5\n" + kXyz), "header line 3"},
      {"count beyond 64 bits", ".ply", ply("element vertex 99999999999999999999\n" + kXyz),
       "header line 3"},
      {"unknown type", ".ply", ply("element vertex 2\nproperty quad x\n"), "header line 4"},
      {"property before element", ".ply", ply(kXyz), "header line 3"},
      {"list of float length", ".ply", ply("element vertex 2\nproperty list float int x\n"),
       "header line 4"},
      {"no vertices", ".ply", ply("element face 0\nproperty list uchar int i\n"),
       "no element \"vertex\""},
      {"no z", ".ply", ply("element vertex 2\nproperty float x\nproperty float y\n"),
       "no x, y and z"},
      {"x is a list", ".ply",
       ply("element vertex 2\nproperty list uchar int x\nproperty float y\nproperty float z\n"),
       "no x, y and z"},
      {"no point", ".ply", ply("element vertex 0\n" + kXyz), "no point with three finite"},
      {"all NaN", ".ply", ply("element vertex 2\n" + kXyz, "nan 0 0\n0 inf 0\n"),
       "no point with three finite"},
      {"ascii text for number", ".ply", ply("element vertex 2\n" + kXyz, "0 0 0\n1 one 1\n"),
       "text where a number"},
      {"ascii 1e18 points", ".ply", ply("element vertex 1000000000000000000\n" + kXyz),
       "is cut short"},
      {"binary 1e18 points", ".ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 1000000000000000000\n" + kXyz +
           "end_header\n123456789012",
       "is cut short"},
      {"bytes of points overflow", ".ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 1537228672809129302\n" + kXyz +
           "end_header\n123456789012",
       "is cut short"},
      {"1e18 elements before", ".ply",
       ply("element edge 1000000000000000000\nproperty int a\nelement vertex 1\n" + kXyz),
       "is cut short"},
      {"1e18 lists before", ".ply",
       "ply\nformat binary_big_endian 1.0\nelement edge 1000000000000000000\nproperty list uchar "
       "int a\nelement vertex 1\n" +
           kXyz + "end_header\n" + std::string(100, '\0'),
       "is cut short"},
      {"list of negative length", ".ply",
       ply("element edge 1\nproperty list int int a\nelement vertex 1\n" + kXyz, "-1\n0 0 0\n"),
       "impossible length"},
      {"list of endless length", ".ply",
       "ply\nformat binary_little_endian 1.0\nelement edge 1\nproperty list uint int a\nelement "
       "vertex 1\n" +
           kXyz + "end_header\n\xff\xff\xff\xff 123456789012",
       "is cut short"},
      {"another kind", ".pcd", "solid x\n", "is not a PCD file"},
      {"no data line", ".pcd", "VERSION 0.7\nFIELDS x y z\n", "no DATA line"},
      {"data of no kind", ".pcd", pcd(kPcdXyz, kTwo, "packed"), "kind of DATA"},
      {"no fields", ".pcd", pcd("", kTwo, "ascii"), "no FIELDS"},
      {"too few sizes", ".pcd", pcd("FIELDS x y z\nSIZE 4 4\nTYPE F F F\n", kTwo, "ascii"),
       "not one SIZE"},
      {"too many counts", ".pcd",
       pcd("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1 1\n", kTwo, "ascii"), "not one SIZE"},
      {"size of no type", ".pcd", pcd("FIELDS x y z\nSIZE 4 4 2\nTYPE F F F\n", kTwo, "ascii"),
       "field \"z\""},
      {"negative count", ".pcd",
       pcd("FIELDS x y z _\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 -1\n", kTwo, "binary"),
       "field \"_\""},
      {"endless count", ".pcd",
       pcd("FIELDS x y z _\nSIZE 4 4 4 8\nTYPE F F F U\nCOUNT 1 1 1 2305843009213693952\n", kTwo,
           "binary"),
       "field \"_\""},
      {"sum of counts", ".pcd",
       pcd("FIELDS x y z a b\nSIZE 4 4 4 8 8\nTYPE F F F U U\nCOUNT 1 1 1 5000 5000\n", kTwo,
           "binary"),
       "larger than the whole file"},
      {"x of three numbers", ".pcd",
       pcd("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 3 1 1\n", kTwo, "ascii"), "no x, y and z"},
      {"negative width", ".pcd", pcd(kPcdXyz, "WIDTH -2\nHEIGHT 1\nPOINTS 2\n", "ascii"),
       "no count"},
      {"width times height overflows", ".pcd",
       pcd(kPcdXyz, "WIDTH 4294967296\nHEIGHT 4294967296\n", "ascii"), "impossible"},
      {"points are not width times height", ".pcd",
       pcd(kPcdXyz, "WIDTH 3\nHEIGHT 1\nPOINTS 2\n", "ascii"), "are not its WIDTH"},
      {"no points", ".pcd", pcd(kPcdXyz, "WIDTH 0\nHEIGHT 1\nPOINTS 0\n", "ascii"),
       "no point with three finite"},
      {"ascii 1e18 points", ".pcd", pcd(kPcdXyz, "WIDTH 1000000000000000000\nHEIGHT 1\n", "ascii"),
       "is cut short"},
      {"binary 1e18 points", ".pcd",
       pcd(kPcdXyz, "WIDTH 1000000000000000000\nHEIGHT 1\n", "binary"), "is cut short"},
      {"ascii line too short", ".pcd", pcd(kPcdXyz, kTwo, "ascii", "0 0 0\n1 1\n"),
       "line 11 has 2 numbers"},
      {"ascii text for number", ".pcd", pcd(kPcdXyz, kTwo, "ascii", "0 0 0\n1 x 1\n"),
       "line 11 has text"},
      {"compressed without lengths", ".pcd", pcd(kPcdXyz, kTwo, "binary_compressed", "1234567"),
       "is cut short"},
      {"compressed beyond the file", ".pcd", test::compressed_pcd("abc", 4, 24, "2"),
       "is cut short"},
      {"compressed of two sizes", ".pcd", test::compressed_pcd("abc", 3, 25, "2"),
       "says two sizes"},
      {"compressed 1e18 points", ".pcd", test::compressed_pcd("abc", 3, 24, "1000000000000000000"),
       "says two sizes"},
      {"compressed nonsense", ".pcd", test::compressed_pcd("\xff\xff\xff", 3, 24, "2"),
       "cannot be unpacked"},
      {"compressed into 4 GiB", ".pcd",
       test::compressed_pcd(std::string(3000, '\xe0'), 3000, 4294967292U, "357913941"),
       "packed more tightly"},
      {"endless header line", ".pcd", "FIELDS " + std::string(100000, 'x') + "\n", "endless line"},
      {"two columns", ".xyz", "1 2\n3 4\n", "fewer than three columns"},
      {"columns that change", ".xyz", "1 2 3\n4 5 6 7\n",
       "line 2 has 4 columns where the first has 3"},
      {"text below", ".txt", "1 2 3\nx y z\n", "line 2 has text"},
      {"decimal commas", ".txt", "1,5 2,5 3,5\n", "line 1 is parted by blanks and signs"},
      {"decimal commas, semicolons", ".txt", "1,5;2,5;3,5\n",
       "line 1 is parted by blanks and signs"},
      {"a missing number", ".txt", "1,,2\n", "line 1 has text"},
      {"bytes that are no text", ".xyz", std::string("\x00\x01\xff\xfe\n\x00\x01 2 3\n", 13),
       "line 2"},
      {"comments only", ".xyz", "# nothing\n\n// here\n", "no point with three finite"},
      {"two numbers", ".obj", "v 1 2\n", "line 1 is a vertex without three numbers"},
      {"no vertex", ".obj", "o part\nvn 0 0 1\n", "no point with three finite"},
      {"not a cloud", ".glb", "glTF", "is no cloud file"},
  };
}

TEST(CloudRefusal, SaysWhatIsWrongInOneSentenceThatNamesTheFile) {
  for (const Refusal& refusal : refusals()) {
    const std::string path = std::string("cloud") + refusal.ending;
    SCOPED_TRACE(path + ": " + refusal.name);
    const auto file = read_cloud_bytes(refusal.bytes, path, LengthUnit::kMetre);
    test::expect_refused(file, ErrorCode::kBadInput, path + ": ", refusal.text);
    if (file) continue;
    EXPECT_TRUE(file.error().message.starts_with(path)) << file.error().message;
    EXPECT_NE(file.error().message.find(';'), std::string::npos) << "says what to do";
  }
}

TEST(CloudRefusal, NamesAMissingFile) {
  const auto file = read_cloud("/nowhere/scan.ply", LengthUnit::kMetre);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kBadInput);
  EXPECT_TRUE(file.error().message.starts_with("/nowhere/scan.ply"));
}

// Every sample cut at every length: refused, or (text may end anywhere) read as no more than it
// was.
TEST(CloudRefusal, TakesNoCutFileForAWholeOne) {
  for (const test::CloudSample& sample : test::cloud_samples()) {
    for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
      const auto file = read_cloud_bytes(std::string_view(sample.bytes).substr(0, length),
                                         "cloud" + sample.ending, LengthUnit::kMetre);
      if (!file) continue;
      ASSERT_LE(file->cloud.size(), 4U) << sample.name << " cut at " << length;
      const bool counts_points =
          sample.ending != ".xyz" && sample.ending != ".txt" && sample.ending != ".obj";
      if (counts_points) {
        ASSERT_EQ(file->cloud.size(), 4U) << sample.name << " cut at " << length;
      }
    }
  }
}

// Every sample with every byte changed in a few ways: whatever comes of it, it is no crash.
TEST(CloudRefusal, SurvivesEveryChangedByte) {
  for (const test::CloudSample& sample : test::cloud_samples())
    for (std::size_t at = 0; at < sample.bytes.size(); ++at)
      for (const char other : {'\0', '\xff', '9', '-'}) {
        std::string bytes = sample.bytes;
        bytes[at] = other;
        const auto file = read_cloud_bytes(bytes, "cloud" + sample.ending, std::nullopt);
        if (file) {
          ASSERT_TRUE(file->cloud.is_consistent()) << sample.name << " at " << at;
        }
      }
}

TEST(Lzf, UnpacksItsDefinitionByHand) {
  // "abc", then 3 from 3 back, then 9 + 1 from 1 back.
  const std::string packed(
      "\x02"
      "abc"
      "\x20\x02"
      "\xe0\x01\x00",
      9);
  EXPECT_EQ(unpack_lzf(packed, 16), "abcabccccccccccc");
}

TEST(Lzf, UnpacksWhatIsPacked) {
  std::string bytes;
  for (int i = 0; i < 5000; ++i) bytes += static_cast<char>(i % 700 < 400 ? 'x' : i * 31);
  EXPECT_EQ(unpack_lzf(test::pack_lzf(bytes), bytes.size()), bytes);
  EXPECT_EQ(unpack_lzf("", 0), "");
}

TEST(Lzf, RefusesDamage) {
  struct Row {
    const char* name;
    std::string packed;
    std::size_t length;
  };
  for (const Row& row : {Row{"back before the start",
                             std::string("\x00"
                                         "a"
                                         "\x20\x01",
                                         4),
                             4},
                         Row{"literal beyond the end",
                             std::string("\x05"
                                         "ab",
                                         3),
                             6},
                         Row{"too long",
                             std::string("\x01"
                                         "ab",
                                         3),
                             1},
                         Row{"too short",
                             std::string("\x01"
                                         "ab",
                                         3),
                             3},
                         Row{"repeat too long",
                             std::string("\x00"
                                         "a"
                                         "\xe0\xff\x00",
                                         5),
                             100},
                         Row{"no offset",
                             std::string("\x00"
                                         "a"
                                         "\x20",
                                         3),
                             4},
                         Row{"no length",
                             std::string("\x00"
                                         "a"
                                         "\xe0",
                                         3),
                             4},
                         Row{"length beyond any packing",
                             std::string("\x00"
                                         "a",
                                         2),
                             1000000000}})
    EXPECT_FALSE(unpack_lzf(row.packed, row.length)) << row.name;
}

}  // namespace
}  // namespace spool
