// A design mesh made ready for drawing: normals that break at creases, edges worth a line.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/mesh_geometry.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <unordered_map>

#include <Eigen/Geometry>

namespace spool::render {
namespace {

// Facets of a curved surface meet at less than this (16 a turn: 22.5 degrees), edges of the part at
// more.
constexpr float kCreaseCosine = 0.766F;  // cos 40 degrees
constexpr float kFlatCosine =
    0.99996F;  // cos 0.5 degrees: such an edge is never seen as an outline
// Beyond this many triangles at one vertex (the centre of a fan) averaging costs the square of
// their number.
constexpr std::size_t kManyAtVertex = 256;

struct Face {
  std::array<std::uint32_t, 3> corner{};  // welded
  Eigen::Vector3f normal;                 // unit
  std::int32_t part = -1;
};

struct CellHash {
  std::size_t operator()(const std::array<std::int64_t, 3>& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29U;
    }
    return static_cast<std::size_t>(hash);
  }
};

// For each vertex the first one at its place.
std::vector<std::uint32_t> weld(const std::vector<Eigen::Vector3f>& vertices) {
  std::unordered_map<std::array<std::int64_t, 3>, std::uint32_t, CellHash> first;
  first.reserve(vertices.size());
  std::vector<std::uint32_t> welded(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    std::array<std::int64_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double micrometres = 1e6 * vertices[i][static_cast<Eigen::Index>(axis)];
      cell[axis] = std::abs(micrometres) < 9e18 ? std::llround(micrometres) : 0;
    }
    welded[i] = first.try_emplace(cell, static_cast<std::uint32_t>(i)).first->second;
  }
  return welded;
}

std::vector<Face> make_faces(const TriangleMesh& mesh, std::span<const std::int32_t> triangle_part,
                             const std::vector<std::uint32_t>& welded) {
  std::vector<Face> faces;
  faces.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    assert(std::ranges::all_of(triangle, [&](auto v) { return v < mesh.vertices.size(); }) &&
           "every index is one of a vertex");
    Face face;
    for (std::size_t c = 0; c < 3; ++c) face.corner[c] = welded[triangle[c]];
    const auto& p = mesh.vertices;
    const Eigen::Vector3d a = p[face.corner[0]].cast<double>();
    const Eigen::Vector3d normal =
        (p[face.corner[1]].cast<double>() - a).cross(p[face.corner[2]].cast<double>() - a);
    const double twice_area = normal.norm();
    if (!(twice_area > 0) || !std::isfinite(twice_area)) continue;
    face.normal = (normal / twice_area).cast<float>();
    face.part = triangle_part.empty() ? -1 : triangle_part[t];
    faces.push_back(face);
  }
  return faces;
}

// The angle (rad) of a face at one of its corners: weights its normal there, so that the result
// does not depend on how a flat area is cut into triangles.
float corner_angle(const std::vector<Eigen::Vector3f>& p, const Face& face, std::size_t c) {
  const Eigen::Vector3f a = p[face.corner[(c + 1) % 3]] - p[face.corner[c]];
  const Eigen::Vector3f b = p[face.corner[(c + 2) % 3]] - p[face.corner[c]];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

void build_triangles(const TriangleMesh& mesh, const std::vector<Face>& faces, MeshGeometry& out) {
  // Which faces meet at each vertex: one array, cut by the offsets.
  std::vector<std::uint32_t> offset(mesh.vertices.size() + 1, 0);
  for (const Face& face : faces) {
    for (const std::uint32_t v : face.corner) ++offset[v + 1];
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) offset[v + 1] += offset[v];
  std::vector<std::uint32_t> at_vertex(faces.size() * 3);
  std::vector<std::uint32_t> next(offset.begin(), offset.end() - 1);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      at_vertex[next[faces[f].corner[c]]++] = static_cast<std::uint32_t>(3 * f + c);
    }
  }

  out.indices.resize(faces.size() * 3);
  std::vector<std::uint32_t> made;  // at this vertex
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    made.clear();
    const std::span<const std::uint32_t> corners(at_vertex.data() + offset[v],
                                                 offset[v + 1] - offset[v]);
    for (const std::uint32_t corner : corners) {
      const Face& face = faces[corner / 3];
      Eigen::Vector3f normal = face.normal;
      if (corners.size() <= kManyAtVertex) {
        normal.setZero();
        for (const std::uint32_t other : corners) {
          const Face& neighbour = faces[other / 3];
          if (neighbour.part != face.part || neighbour.normal.dot(face.normal) < kCreaseCosine)
            continue;
          normal += corner_angle(mesh.vertices, neighbour, other % 3) * neighbour.normal;
        }
        const float length = normal.norm();
        normal = length > 0 ? Eigen::Vector3f(normal / length) : face.normal;
      }
      const auto part = static_cast<float>(face.part);
      const auto same = std::ranges::find_if(made, [&](std::uint32_t i) {
        return out.vertices[i].part == part && out.vertices[i].normal.dot(normal) > 0.9999F;
      });
      if (same != made.end()) {
        out.indices[corner] = *same;
        continue;
      }
      out.indices[corner] = static_cast<std::uint32_t>(out.vertices.size());
      made.push_back(out.indices[corner]);
      out.vertices.push_back({mesh.vertices[v], normal, part});
    }
  }
}

// One side of a triangle, its ends in order.
struct Side {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t face = 0;
  bool rising = false;  // the triangle runs from low to high
};

// By the divergence theorem: a closed part wound inwards has a negative volume.
bool has_positive_volumes(const TriangleMesh& mesh, const std::vector<Face>& faces) {
  std::unordered_map<std::int32_t, double> volume;
  const Eigen::Vector3d origin = mesh.vertices.front().cast<double>();
  for (const Face& face : faces) {
    const auto at = [&](std::size_t c) -> Eigen::Vector3d {
      return mesh.vertices[face.corner[c]].cast<double>() - origin;
    };
    volume[face.part] += at(0).dot(at(1).cross(at(2)));
  }
  return std::ranges::all_of(volume, [](const auto& one) { return one.second > 0; });
}

void build_edges(const TriangleMesh& mesh, const std::vector<Face>& faces, MeshGeometry& out) {
  std::vector<Side> sides;
  sides.reserve(faces.size() * 3);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = faces[f].corner[c];
      const std::uint32_t b = faces[f].corner[(c + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(f), a < b});
    }
  }
  std::ranges::sort(sides, [](const Side& a, const Side& b) {
    return std::array{a.low, a.high, a.face} < std::array{b.low, b.high, b.face};
  });
  bool is_closed = !sides.empty();
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    const Side& first = sides[begin];
    for (end = begin;
         end < sides.size() && sides[end].low == first.low && sides[end].high == first.high;) {
      ++end;
    }
    const auto rising = std::count_if(sides.begin() + static_cast<std::ptrdiff_t>(begin),
                                      sides.begin() + static_cast<std::ptrdiff_t>(end),
                                      [](const Side& side) { return side.rising; });
    is_closed = is_closed && 2 * static_cast<std::size_t>(rising) == end - begin;
    const Face& face_a = faces[first.face];
    MeshEdge edge{mesh.vertices[first.low],
                  mesh.vertices[first.high],
                  face_a.normal,
                  face_a.normal,
                  face_a.part,
                  face_a.part};
    if (end - begin != 2) {
      edge.other_part = faces[sides[end - 1].face].part;
      out.creases.push_back(edge);
      continue;
    }
    const Side& second = sides[begin + 1];
    const Face& face_b = faces[second.face];
    edge.other_part = face_b.part;
    // Neighbours wound alike run along their edge in opposite directions; if not, one is inside
    // out.
    edge.normal_b = first.rising != second.rising ? face_b.normal : Eigen::Vector3f(-face_b.normal);
    const float cosine = edge.normal_a.dot(edge.normal_b);
    if (cosine < kCreaseCosine || face_a.part != face_b.part) {
      out.creases.push_back(edge);
    } else if (cosine < kFlatCosine) {
      out.smooth.push_back(edge);
    }
  }
  out.is_solid = is_closed && has_positive_volumes(mesh, faces);
}

}  // namespace

MeshGeometry prepare_mesh(const TriangleMesh& mesh, std::span<const std::int32_t> triangle_part) {
  assert((triangle_part.empty() || triangle_part.size() == mesh.triangles.size()) &&
         "a part for every triangle or none");
  const std::vector<Face> faces = make_faces(mesh, triangle_part, weld(mesh.vertices));
  MeshGeometry out;
  build_triangles(mesh, faces, out);
  build_edges(mesh, faces, out);
  return out;
}

void append_outline(std::span<const MeshEdge> smooth, const Eigen::Vector3f& eye,
                    std::vector<MeshEdge>& outline) {
  for (const MeshEdge& edge : smooth) {
    const Eigen::Vector3f to_eye = eye - edge.from;
    if ((edge.normal_a.dot(to_eye) > 0) != (edge.normal_b.dot(to_eye) > 0)) outline.push_back(edge);
  }
}

}  // namespace spool::render
