// Writes the first inputs of pair_library_fuzz into a folder: small good libraries, whole and as
// content alone.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>
#include <string>

#include "vision/core/file_io.h"
#include "vision/find/pair_library_file.h"

namespace {

// Of few and wide cells, so that a file is small.
spool::PairLibrary library(std::size_t models) {
  spool::PairLibrary library{.options = {.cell_rad = 1.5}};
  for (std::size_t i = 0; i < models; ++i) {
    spool::PairModel model{
        .key = "design", .diameter_m = 1, .distance_m = 0.75, .tolerance_m = 0.01, .leaf_m = 0.04};
    model.points.points = {{0, 0, 0}, {0.75F, 0, 0}, {0, 0.75F, 0}};
    model.points.normals = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    model.pairs = {{0, 1}, {1, 0}, {0, 2}};
    const std::size_t cells = spool::FeatureCells(library.options.cell_rad).count();
    model.cell_first.assign(cells + 1, 3);
    model.cell_first[0] = 0;
    library.models.push_back(std::move(model));
  }
  return library;
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("usage: pair_library_seeds FOLDER\n", stderr);
    return 64;
  }
  constexpr std::size_t kHeading = 8 + 4 + 64;  // name, version, digest
  const std::filesystem::path folder = words[1];
  std::filesystem::create_directories(folder);
  for (std::size_t models = 0; models < 3; ++models) {
    const auto path = folder / ("whole_" + std::to_string(models));
    if (!spool::write_pair_library(path, library(models))) return 74;
    const auto bytes = spool::read_file(path);
    if (!bytes || !spool::read_pair_library_bytes(*bytes, path.string())) return 70;
    if (!spool::write_file_whole(path, '\0' + *bytes) ||
        !spool::write_file_whole(folder / ("content_" + std::to_string(models)),
                                 '\1' + bytes->substr(kHeading)))
      return 74;
  }
  return 0;
}
