// A design from any file it may be in: the table of readers by the file's ending.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/design_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"
#include "vision/design/readers.h"

namespace spool {
namespace {

struct Reader {
  std::string_view ending;  // lower case
  Result<DesignModel> (*read)(const DesignFile&);
};

// A new format is one file and one line here.
constexpr std::array<Reader, 9> kReaders{{
    {".glb", &read_gltf_design},
    {".gltf", &read_gltf_design},
    {".pcf", &read_pcf_design},
    {".stl", &read_mesh_design},
    {".obj", &read_mesh_design},
    {".ply", &read_ply_design},
    {".pcd", &read_cloud_design},
    {".xyz", &read_cloud_design},
    {".txt", &read_cloud_design},
}};

constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1}
                                        << 30;  // far over any spool, within memory

std::string known_endings() {
  std::string text;
  for (const Reader& reader : kReaders) text.append(" ").append(reader.ending);
  return text;
}

// A damaged file can earn a warning for every node: nobody reads more than a screenful.
void shorten(std::vector<std::string>& warnings) {
  constexpr std::size_t kMost = 50;
  if (warnings.size() <= kMost) return;
  const std::size_t more = warnings.size() - kMost;
  warnings.resize(kMost);
  warnings.push_back("and " + std::to_string(more) + " more warnings of this file");
}

}  // namespace

Result<DesignModel> read_design(const std::filesystem::path& path, std::optional<LengthUnit> unit) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  const auto* reader = std::find_if(kReaders.begin(), kReaders.end(),
                                    [&](const Reader& each) { return each.ending == ending; });
  if (reader == kReaders.end()) {
    return Error{
        ErrorCode::kBadInput,
        path.string() + " is not a design that can be read: give one of" + known_endings()};
  }
  Result<std::string> bytes = read_file(path, kMaxFileBytes);
  if (!bytes) return bytes.error();
  if (bytes->empty()) {
    return Error{ErrorCode::kBadInput, path.string() + " is empty; export the design again"};
  }
  const DesignFile file{path, std::move(*bytes), unit};
  try {
    Result<DesignModel> design = reader->read(file);
    if (design) {
      design->sha256 = sha256_hex(file.bytes);
      shorten(design->warnings);
    }
    return design;
  } catch (const std::exception& failure) {  // of the libraries; ours throw nothing
    return Error{ErrorCode::kBadInput,
                 path.string() + " cannot be read as a design: " + failure.what()};
  }
}

}  // namespace spool
