// Writes the first inputs of gltf_fuzz into a folder: small good files of each format.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>

#include "tests/vision/design/gltf_text.h"

int main(int argc, char** argv) {
  if (argc != 2) return 64;
  namespace test = spool::test;
  std::filesystem::create_directories(argv[1]);
  test::Pieces pieces;
  pieces.nodes = R"([{"children": [1, 2]}, {"mesh": 0, "name": "a", "scale": [1, -1, 2], "extras": {
      "spoolsight": {"kind": "flange", "nps": 4, "schedule": 40,
        "ports": [{"name": "in", "position": [0, 0, 0], "direction": [0, 0, 1], "end": "FL"}],
        "holes": {"count": 8, "bolt_circle_m": 0.19, "clocking_rad": 0.4}}}},
      {"mesh": 0, "rotation": [0, 0, 0.7, 0.7], "translation": [1, 2, 3]}])";
  const auto seed = [&](const char* name, char format, const std::string& bytes) {
    test::write(argv[1], name, format + bytes);
  };
  seed("binary", 0, pieces.glb());
  pieces.buffers =
      R"([{"byteLength": 72, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAACAAEAAAABAAMAAAADAAIAAQACAAMA"}])";
  seed("text", 1, pieces.json());
  seed(
      "solid", 2,
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid a\n");
  seed("object", 3, "o a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n");
  seed("polygon", 4,
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
       "float z\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
       "3 0 1 2\n");
  return 0;
}
