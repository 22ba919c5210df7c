// One small cloud in every format that is read, built byte by byte.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/scan/cloud_samples.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "tests/support/write_file.h"

namespace spool::test {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// Bytes of numbers in either order.
struct Bytes {
  std::string bytes;
  bool big = false;

  template <class T>
  Bytes& put(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
    return *this;
  }
};

std::string ply_binary(bool big) {
  Bytes body;
  body.big = big;
  for (const Eigen::Vector3f& p : sample_points()) body.put(p.x()).put(p.y()).put(p.z());
  return std::string("ply\nformat binary_") + (big ? "big" : "little") +
         "_endian 1.0\ncomment made by a test\nelement vertex 4\nproperty float x\nproperty float "
         "y\n"
         "property float32 z\nend_header\n" +
         body.bytes;
}

// Everything in an unusual order: lists before the vertices and among them, doubles, colours,
// normals first.
std::string ply_mixed(bool big) {
  Bytes body;
  body.big = big;
  for (const int length : {0, 3, 1}) {
    body.put(static_cast<std::uint8_t>(length));
    for (int i = 0; i < length; ++i) body.put(static_cast<std::int32_t>(i));
    body.put(1.5F);
  }
  const auto normals = sample_normals();
  const auto points = sample_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    body.put(normals[i].x()).put(normals[i].y()).put(normals[i].z());
    body.put(std::uint8_t{255}).put(double{points[i].z()});
    body.put(static_cast<std::uint16_t>(i));  // a list of i shorts
    for (std::size_t k = 0; k < i; ++k) body.put(std::int16_t{-1});
    body.put(double{points[i].x()}).put(double{points[i].y()}).put(std::int16_t{-7});
  }
  return std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
         "_endian 1.0\r\nobj_info x\r\nelement face 3\r\nproperty list uchar int vertex_indices\r\n"
         "property float area\r\nelement vertex 4\r\nproperty float nx\r\nproperty float ny\r\n"
         "property float nz\r\nproperty uchar red\r\nproperty double z\r\n"
         "property list ushort short tracks\r\nproperty float64 x\r\nproperty double y\r\n"
         "property int16 label\r\nelement nothing 1000000000000\r\nend_header\r\n" +
         body.bytes;
}

std::string pcd_header(const std::string& fields, const std::string& data) {
  return "# .PCD v.7 - a comment\nVERSION .7\n" + fields +
         "WIDTH 2\nHEIGHT 2\nVIEWPOINT 0 0 0 0 1 0 0\nPOINTS 4\nDATA " + data + "\n";
}

std::string pcd_binary() {
  Bytes body;
  for (const Eigen::Vector3f& p : sample_points()) {
    body.put(std::uint8_t{1}).put(std::uint8_t{2}).put(std::uint8_t{3});  // padding
    body.put(double{p.z()}).put(p.x()).put(std::int64_t{-1}).put(p.y());
  }
  return pcd_header("FIELDS _ z x big y\nSIZE 1 8 4 8 4\nTYPE U F F I F\nCOUNT 3 1 1 1 1\n",
                    "binary") +
         body.bytes;
}

std::string pcd_compressed_with_normals() {
  Bytes body;  // field after field
  const auto points = sample_points(), normals = sample_normals();
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (const Eigen::Vector3f& p : points) body.put(p[axis]);
  for (int i = 0; i < 8; ++i) body.put(std::uint8_t{0});  // padding of two bytes a point
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (const Eigen::Vector3f& n : normals) body.put(n[axis]);
  const std::string packed = pack_lzf(body.bytes);
  Bytes lengths;
  lengths.put(static_cast<std::uint32_t>(packed.size()))
      .put(static_cast<std::uint32_t>(body.bytes.size()));
  return pcd_header(
             "FIELDS x y z _ normal_x normal_y normal_z\nSIZE 4 4 4 1 4 4 4\nTYPE F F F U F F F\n"
             "COUNT 1 1 1 2 1 1 1\n",
             "binary_compressed") +
         lengths.bytes + packed;
}

}  // namespace

std::vector<Eigen::Vector3f> sample_points() {
  return {{0.5F, -1.25F, 2.0F},
          {1.0F, 2.0F, -3.0F},
          {kNone, kNone, kNone},
          {0.125F, 0.0F, 0.0009765625F}};
}

std::vector<Eigen::Vector3f> sample_normals() {
  return {{0, 0, 1}, {0, -1, 0}, {0, 0, 0}, {0.6F, 0, 0.8F}};
}

std::string pack_lzf(const std::string& bytes) {
  std::string packed;
  std::size_t at = 0;
  while (at < bytes.size()) {
    std::size_t repeat = 0;  // how often the byte before goes on
    while (at > 0 && at + repeat < bytes.size() && repeat < 264 &&
           bytes[at + repeat] == bytes[at - 1])
      ++repeat;
    if (repeat >= 3) {
      const std::size_t length = repeat - 2;
      packed += static_cast<char>(std::min<std::size_t>(length, 7) << 5U);
      if (length >= 7) packed += static_cast<char>(length - 7);
      packed += '\0';  // one byte back
      at += repeat;
    } else {
      const std::size_t run = std::min<std::size_t>(2, bytes.size() - at);
      packed += static_cast<char>(run - 1);
      packed.append(bytes, at, run);
      at += run;
    }
  }
  return packed;
}

std::string compressed_pcd(const std::string& packed, std::uint32_t packed_size,
                           std::uint32_t unpacked_size, const std::string& points) {
  Bytes lengths;
  lengths.put(packed_size).put(unpacked_size);
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + points +
         "\nHEIGHT 1\nPOINTS " + points + "\nDATA binary_compressed\n" + lengths.bytes + packed;
}

std::vector<CloudSample> cloud_samples() {
  return {
      {"PLY little", ".ply", ply_binary(false)},
      {"PLY big", ".PLY", ply_binary(true)},
      {"PLY little, mixed", ".ply", ply_mixed(false), true},
      {"PLY big, mixed", ".ply", ply_mixed(true), true},
      {"PLY ascii", ".ply",
       "ply\nformat ascii 1.0\nelement edge 2\nproperty list uchar int ends\nproperty int kind\n"
       "element vertex 4\nproperty uchar red\nproperty float x\nproperty float y\nproperty float "
       "z\n"
       "property list uchar int seen_by\nproperty float nx\nproperty float ny\nproperty float nz\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
       "2 0 1 7\n0 9\n"
       "10 0.5 -1.25 2e0 0 0 0 1\n255 +1 2.0 -3 2 8 9 0 -1 0\n0 nan nan nan 1 4 0 0 0\n"
       "0 0.125 0 0.0009765625 0 0.6 0 0.8\n3 0 1 2\n",
       true},
      {"PCD ascii", ".pcd",
       pcd_header("FIELDS x y z _\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 4\n", "ascii") +
           "0.5 -1.25 2 0 0 128 63\n1 2 -3 0 0 128 63\nnan nan nan 0 0 0 0\n"
           "0.125 0 0.0009765625 0 0 128 63\n",
       false, 2, 2},
      {"PCD binary", ".pcd", pcd_binary(), false, 2, 2},
      {"PCD compressed", ".Pcd", pcd_compressed_with_normals(), true, 2, 2},
      {"XYZ blanks", ".xyz",
       "# a comment\n\n0.5 -1.25\t2\r\n  1 2 -3  \nNaN NaN NaN\n0.125 0 0.0009765625"},
      {"XYZ commas and normals", ".txt",
       "// a comment\nX,Y,Z,Nx,Ny,Nz\n0.5,-1.25,2,0,0,1\n1, 2, -3, 0, -1, 0\nnan,nan,nan,0,0,0\n"
       "0.125,0,0.0009765625,0.6,0,0.8\n",
       true},
      {"XYZ semicolons and colours", ".xyz",
       "4\n0.5;-1.25;2;255;0;0\n1;2;-3;0;0;0\nnan;nan;nan;0;0;0\n0.125;0;0.0009765625;9;9;9\n"},
      {"OBJ", ".obj",
       "# a comment\nmtllib x.mtl\no part\nv 0.5 -1.25 2\nvn 0 0 1\nv 1 2 -3 1.0\nv nan nan nan\n"
       "v 0.125 0 0.0009765625 0.5 0.5 0.5\nvt 0 0\nf 1 2 4\n"},
  };
}

std::filesystem::path write_sample(const std::filesystem::path& folder, const std::string& ending,
                                   const std::string& bytes) {
  return write_file(folder / ("cloud" + ending), bytes);
}

}  // namespace spool::test
