// Points of an OBJ file: its v lines; everything else is left out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "vision/scan/cloud_reader.h"
#include "vision/scan/text_scanner.h"

namespace spool {

Result<RawCloud> read_obj_points(std::string_view bytes, const std::string& name) {
  RawCloud cloud;
  LineScanner lines(bytes);
  bool has_faces = false;
  while (const auto line = lines.next()) {
    std::string_view rest = *line;
    const std::string_view key = next_word(rest);
    has_faces = has_faces || key == "f";
    if (key != "v") continue;
    std::array<double, 3> values{};
    for (double& value : values) {
      const auto number = parse_number(next_word(rest));
      if (!number)
        return Error{ErrorCode::kBadInput,
                     name + ": line " + std::to_string(lines.line_number()) +
                         " is a vertex without three numbers; export it again"};
      value = *number;
    }
    cloud.points.emplace_back(values[0], values[1], values[2]);
  }
  if (has_faces)
    cloud.warnings.push_back(name + ": its faces are left out; a scan is its vertices");
  return cloud;
}

}  // namespace spool
