// The numbers behind glTF accessors: every range, stride, type and index checked (glTF 2.0, 3.6.2).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include <tiny_gltf.h>

namespace spool {
namespace {

// More elements than any design has; keeps an accessor without bytes from claiming all memory.
constexpr std::size_t kMaxElements = 60'000'000;

// Elements of one component type lying at even steps in a buffer.
struct Elements {
  const unsigned char* data = nullptr;
  std::size_t step = 0;  // bytes from one to the next
  std::size_t count = 0;
  int component_type = 0;
};

Error bad(const std::string& what) { return {ErrorCode::kBadInput, what}; }

std::size_t component_bytes(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

// Elements of `width` components in a buffer view, which lies in its buffer (load_gltf saw to
// that).
Result<Elements> elements(const tinygltf::Model& model, const std::string& name, int view_index,
                          std::size_t offset, int component_type, std::size_t width,
                          std::size_t count, bool may_stride) {
  if (view_index < 0 || static_cast<std::size_t>(view_index) >= model.bufferViews.size()) {
    return bad(name + " names a buffer view that is not there");
  }
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_index)];
  const std::size_t bytes = component_bytes(component_type);
  const std::size_t element_bytes = bytes * width;
  const std::size_t step = may_stride && view.byteStride != 0 ? view.byteStride : element_bytes;
  if (step < element_bytes || step > 252 + element_bytes) {
    return bad(name + " has a stride that does not fit its elements");
  }
  if ((view.byteOffset + offset) % bytes != 0 || step % bytes != 0) {
    return bad(name + " is not aligned to its component type");
  }
  // Divided, not multiplied: no product of a hostile count may overflow.
  if (offset > view.byteLength || view.byteLength - offset < element_bytes ||
      (view.byteLength - offset - element_bytes) / step < count - 1) {
    return bad(name + " reaches past the end of its buffer view");
  }
  const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  return Elements{data.data() + view.byteOffset + offset, step, count, component_type};
}

template <class T>
T load(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof(T));
  return value;
}

// One component as a number; normalised integers as glTF 2.0, 3.6.2.2.
double component(const Elements& from, std::size_t index, std::size_t k, bool normalised) {
  const unsigned char* at =
      from.data + index * from.step + k * component_bytes(from.component_type);
  const auto scaled = [normalised](double value, double full) {
    return normalised ? std::max(value / full, -1.0) : value;
  };
  switch (from.component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return scaled(load<std::int8_t>(at), 127);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return scaled(load<std::uint8_t>(at), 255);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return scaled(load<std::int16_t>(at), 32767);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return scaled(load<std::uint16_t>(at), 65535);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load<std::uint32_t>(at);
    default:
      return static_cast<double>(load<float>(at));
  }
}

bool is_index_type(int component_type) {
  return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

Result<const tinygltf::Accessor*> accessor_at(const tinygltf::Model& model, int index, int type) {
  const std::string name = "accessor " + std::to_string(index);
  if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size()) {
    return bad(name + " is not there");
  }
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  if (accessor.type != type) return bad(name + " has the wrong type for its use");
  if (component_bytes(accessor.componentType) == 0)
    return bad(name + " has an unknown component type");
  if (accessor.count == 0 || accessor.count > kMaxElements) {
    return bad(name + " has a count that cannot be");
  }
  return &accessor;
}

// Overwrites the elements that a sparse accessor lists.
template <class T, class Read>
Status apply_sparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                    const std::string& name, std::size_t width, std::vector<T>& out,
                    const Read& read) {
  if (!accessor.sparse.isSparse) return {};
  const auto& sparse = accessor.sparse;
  if (sparse.count <= 0 || static_cast<std::size_t>(sparse.count) > accessor.count ||
      sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
      !is_index_type(sparse.indices.componentType)) {
    return bad(name + " has a sparse part that cannot be");
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  const Result<Elements> places =
      elements(model, name + " (sparse indices)", sparse.indices.bufferView,
               static_cast<std::size_t>(sparse.indices.byteOffset), sparse.indices.componentType, 1,
               count, false);
  if (!places) return places.error();
  const Result<Elements> values =
      elements(model, name + " (sparse values)", sparse.values.bufferView,
               static_cast<std::size_t>(sparse.values.byteOffset), accessor.componentType, width,
               count, false);
  if (!values) return values.error();
  double last = -1;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = component(*places, i, 0, false);
    if (!(place > last) || place >= static_cast<double>(out.size())) {
      return bad(name + " has sparse indices out of order or range");
    }
    out[static_cast<std::size_t>(place)] = read(*values, i);
    last = place;
  }
  return {};
}

}  // namespace

Result<std::vector<Eigen::Vector3d>> read_gltf_points(const tinygltf::Model& model, int index) {
  const Result<const tinygltf::Accessor*> found = accessor_at(model, index, TINYGLTF_TYPE_VEC3);
  if (!found) return found.error();
  const tinygltf::Accessor& accessor = **found;
  const std::string name = "accessor " + std::to_string(index);
  if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
    return bad(name + " has the wrong component type for positions");
  }
  const auto read = [&accessor](const Elements& from, std::size_t i) {
    return Eigen::Vector3d(component(from, i, 0, accessor.normalized),
                           component(from, i, 1, accessor.normalized),
                           component(from, i, 2, accessor.normalized));
  };
  std::vector<Eigen::Vector3d> points;
  if (accessor.bufferView >= 0 || !accessor.sparse.isSparse) {
    const Result<Elements> from = elements(model, name, accessor.bufferView, accessor.byteOffset,
                                           accessor.componentType, 3, accessor.count, true);
    if (!from) return from.error();
    points.reserve(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i) points.push_back(read(*from, i));
  } else {
    points.assign(accessor.count, Eigen::Vector3d::Zero());  // glTF 2.0, 3.6.2.3
  }
  if (Status done = apply_sparse(model, accessor, name, 3, points, read); !done)
    return done.error();
  for (const Eigen::Vector3d& point : points) {
    if (!point.allFinite()) return bad(name + " holds a position that is not a number");
  }
  return points;
}

Result<std::vector<std::uint32_t>> read_gltf_indices(const tinygltf::Model& model, int index,
                                                     std::size_t limit) {
  const Result<const tinygltf::Accessor*> found = accessor_at(model, index, TINYGLTF_TYPE_SCALAR);
  if (!found) return found.error();
  const tinygltf::Accessor& accessor = **found;
  const std::string name = "accessor " + std::to_string(index);
  if (!is_index_type(accessor.componentType)) {
    return bad(name + " has the wrong component type for indices");
  }
  const auto read = [](const Elements& from, std::size_t i) {
    return static_cast<std::uint32_t>(component(from, i, 0, false));
  };
  std::vector<std::uint32_t> indices;
  if (accessor.bufferView >= 0 || !accessor.sparse.isSparse) {
    const Result<Elements> from = elements(model, name, accessor.bufferView, accessor.byteOffset,
                                           accessor.componentType, 1, accessor.count, true);
    if (!from) return from.error();
    indices.reserve(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i) indices.push_back(read(*from, i));
  } else {
    indices.assign(accessor.count, 0);
  }
  if (Status done = apply_sparse(model, accessor, name, 1, indices, read); !done)
    return done.error();
  for (const std::uint32_t each : indices) {
    if (each >= limit) return bad(name + " holds an index past the last vertex");
  }
  return indices;
}

}  // namespace spool
