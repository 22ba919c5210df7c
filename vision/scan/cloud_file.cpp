// Clouds from files: finds the format's reader, then the unit, metres and the origin.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/cloud_file.h"

#include <array>
#include <cctype>
#include <charconv>
#include <limits>

#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"
#include "vision/scan/cloud_reader.h"
#include "vision/scan/cloud_units.h"

namespace spool {
namespace {

// A new format is a line here and a file with its reader.
struct Format {
  std::string_view ending;
  CloudReader read;
};
constexpr std::array<Format, 5> kFormats = {{{".ply", &read_ply},
                                             {".pcd", &read_pcd},
                                             {".xyz", &read_xyz},
                                             {".txt", &read_xyz},
                                             {".obj", &read_obj_points}}};

const Format* format_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const Format& format : kFormats)
    if (ending == format.ending) return &format;
  return nullptr;
}

std::string_view spoken(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kMetre:
      return "metres";
    case LengthUnit::kMillimetre:
      return "millimetres";
    case LengthUnit::kInch:
      return "inches";
  }
  return "metres";
}

Error unknown_ending(const std::filesystem::path& path) {
  return {ErrorCode::kBadInput, path.string() +
                                    ": is no cloud file that is known; give a .ply, .pcd, "
                                    ".xyz, .txt or .obj"};
}

// About three digits, without the locale.
std::string short_number(double value) {
  std::array<char, 32> text{};
  const bool is_plain = value >= 1 && value < 1e9;
  const int decimals = value < 10 ? 2 : value < 100 ? 1 : 0;
  const auto result = is_plain ? std::to_chars(text.data(), text.data() + text.size(), value,
                                               std::chars_format::fixed, decimals)
                               : std::to_chars(text.data(), text.data() + text.size(), value,
                                               std::chars_format::general, 3);
  return {text.data(), result.ptr};
}

// The unit, given or inferred; what was inferred is said.
Result<LengthUnit> decide_unit(CloudFile& file, const RawCloud& raw, const std::string& name,
                               std::optional<LengthUnit> given) {
  const double extent = robust_box(raw.points).diagonal().norm();
  const std::string flags = " (--scan-unit or --design-unit m, mm or in)";
  if (given) {
    const double extent_m = extent * metres(*given);
    if (raw.points.size() > 1 && (extent_m < 0.005 || extent_m > 1000))
      file.warnings.push_back(name + ": is " + short_number(extent_m) + " m across if it is in " +
                              std::string(spoken(*given)) + "; check the unit" + flags);
    return *given;
  }
  const auto unit = unit_for_extent(extent);
  if (!unit)
    return Error{ErrorCode::kBadInput, name + ": its unit cannot be told from its size (" +
                                           short_number(extent) + " across); say which it is" +
                                           flags};
  file.unit_inferred = true;
  file.warnings.push_back(name + ": its unit is not given; " + short_number(extent) +
                          " across, it is taken for " + std::string(spoken(*unit)) +
                          " and nothing is ok until that is confirmed" + flags);
  return *unit;
}

void set_normals(PointCloud& cloud, std::vector<Eigen::Vector3f> normals) {
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const float length = normals[i].norm();
    const bool is_direction = length > 1e-6F && length < std::numeric_limits<float>::infinity() &&
                              cloud.points[i].allFinite();
    normals[i] = is_direction ? Eigen::Vector3f(normals[i] / length) : Eigen::Vector3f::Zero();
  }
  cloud.normals = std::move(normals);
}

}  // namespace

bool is_cloud_file(const std::filesystem::path& path) { return format_of(path) != nullptr; }

Result<CloudFile> read_cloud(const std::filesystem::path& path, std::optional<LengthUnit> unit) {
  if (format_of(path) == nullptr) return unknown_ending(path);  // before a large file is read
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  return read_cloud_bytes(*bytes, path, unit);
}

Result<CloudFile> read_cloud_bytes(std::string_view bytes, const std::filesystem::path& path,
                                   std::optional<LengthUnit> unit) {
  const std::string name = path.string();
  const Format* const format = format_of(path);
  if (format == nullptr) return unknown_ending(path);
  if (bytes.empty()) return Error{ErrorCode::kBadInput, name + ": is empty; export it again"};
  auto raw = format->read(bytes, name);
  if (!raw) return raw.error();
  if (raw->points.size() > std::numeric_limits<std::uint32_t>::max())
    return Error{ErrorCode::kBadInput, name + ": has more than 4294967295 points; thin it first"};

  CloudFile file;
  file.warnings = std::move(raw->warnings);
  for (const Eigen::Vector3d& point : raw->points) file.finite += point.allFinite() ? 1U : 0U;
  if (file.finite == 0)
    return Error{ErrorCode::kBadInput,
                 name +
                     ": holds no point with three finite coordinates; scan or "
                     "export it again"};
  const auto decided = decide_unit(file, *raw, name, unit);
  if (!decided) return decided.error();
  file.unit = *decided;
  file.sha256 = sha256_hex(bytes);
  set_points(file.cloud, raw->points, file.unit);
  file.cloud.width = raw->width;
  file.cloud.height = raw->height;
  set_normals(file.cloud, std::move(raw->normals));

  std::size_t finite = 0, far = 0;
  for (const Eigen::Vector3f& point : file.cloud.points) {
    if (!point.allFinite()) continue;
    ++finite;
    far += point.cwiseAbs().maxCoeff() >= kFloatReach ? 1U : 0U;
  }
  if (finite < file.finite)
    file.warnings.push_back(name + ": " + std::to_string(file.finite - finite) +
                            " points are too far off for any scan and are left out");
  file.finite = finite;
  if (finite == 0)
    return Error{ErrorCode::kBadInput,
                 name + ": its coordinates are beyond any scan; check its unit"};
  if (far > 0)
    file.warnings.push_back(name + ": " + std::to_string(far) + " points lie over " +
                            short_number(kFloatReach) +
                            " m from the middle and are rounded by more than "
                            "10 micrometres");
  return file;
}

}  // namespace spool
