// The bracket of the simulated scene as files.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/e2e/bracket_files.h"

#include <sstream>

#include "app/sensor/depth_folder.h"
#include "tests/app/runner/simulated_scene.h"
#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"

namespace spool::test {

BracketFiles write_bracket(const std::filesystem::path& folder, int frames) {
  BracketFiles files{folder / "bracket.obj", folder / "recording", nullptr};
  const DesignModel model = bracket_design();
  std::ostringstream obj;
  for (const Eigen::Vector3f& v : model.mesh.vertices) {
    obj << "v " << v.x() << " " << v.y() << " " << v.z() << "\n";
  }
  for (const Part& part : model.parts) {
    obj << "o " << part.name << "\n";
    for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
      const Triangle& triangle = model.mesh.triangles[part.first_triangle + t];
      obj << "f " << triangle[0] + 1 << " " << triangle[1] + 1 << " " << triangle[2] + 1 << "\n";
    }
  }
  if (!write_file_whole(files.design, obj.str())) return files;
  auto writer = sensor::DepthFolderWriter::create(files.recording, small_camera());
  if (!writer) return files;
  for (int i = 0; i < frames; ++i) {
    if (!writer->write(*render_frame(*prepared_bracket(), T_design_camera(), i))) return files;
  }
  auto read = read_design(files.design, LengthUnit::kMetre);
  if (!read) return files;
  auto prepared = PreparedDesign::prepare(std::move(*read));
  if (prepared) files.prepared = *prepared;
  return files;
}

}  // namespace spool::test
