// Fuzzes the model library's reader: the first byte chooses whether the rest is a file or a content
// under a heading and a digest that fit it, without which nothing would get past the digest.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "vision/core/file_digest.h"
#include "vision/find/pair_library_file.h"

namespace {

// The file's layout a second time: its name, version 1, the digest of what follows.
std::string under_a_heading(std::string_view content) {
  std::string file("SPOOLPRS\1\0\0\0", 12);
  file += spool::sha256_hex(content);
  file += content;
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(data + 1), size - 1);
  const auto library = spool::read_pair_library_bytes(
      data[0] % 2 == 0 ? std::string(rest) : under_a_heading(rest), "library.pairs");
  if (!library) {
    if (library.error().message.empty()) std::abort();
    return 0;
  }
  // Read: then every index holds and every number is finite.
  const std::size_t cells = spool::FeatureCells(library->options.cell_rad).count();
  for (const spool::PairModel& model : library->models) {
    for (const Eigen::Vector3f& point : model.points.points)
      if (!point.allFinite()) std::abort();
    std::size_t pairs = 0;
    for (std::size_t cell = 0; cell < cells; ++cell)
      for (const spool::OrientedPair& pair : model.in_cell(cell)) {
        if (pair.first >= model.points.size() || pair.second >= model.points.size()) std::abort();
        ++pairs;
      }
    if (pairs != model.pairs.size()) std::abort();
  }
  return 0;
}
