// Points of a PLY file, ascii or binary of either byte order; other elements and lists are skipped.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "vision/scan/cloud_reader.h"
#include "vision/scan/ply_header.h"
#include "vision/scan/text_scanner.h"

namespace spool {
namespace {

constexpr int kNoSlot = -1;
constexpr std::array<std::string_view, 6> kNames = {"x", "y", "z", "nx", "ny", "nz"};

// Where each property of a vertex goes: 0 to 2 the point, 3 to 5 the normal, or nowhere.
struct VertexLayout {
  std::vector<int> slots;  // one a property
  bool has_points = false;
  bool has_normals = false;
};

VertexLayout layout_of(const PlyElement& vertex) {
  VertexLayout layout;
  std::array<bool, 6> taken{};
  for (const PlyProperty& property : vertex.properties) {
    int slot = kNoSlot;
    for (std::size_t i = 0; i < kNames.size(); ++i)
      if (property.name == kNames[i] && !property.list_length_type && !taken[i]) {
        slot = static_cast<int>(i);
        taken[i] = true;
      }
    layout.slots.push_back(slot);
  }
  layout.has_points = taken[0] && taken[1] && taken[2];
  layout.has_normals = taken[3] && taken[4] && taken[5];
  return layout;
}

void append(RawCloud& cloud, const VertexLayout& layout, const std::array<double, 6>& values) {
  cloud.points.emplace_back(values[0], values[1], values[2]);
  if (layout.has_normals)
    cloud.normals.emplace_back(Eigen::Vector3d(values[3], values[4], values[5]).cast<float>());
}

// Where the bytes or words end before the elements do.
enum class Walk { kDone, kEnded, kNotANumber, kNegativeLength };

// Numbers from a binary body, in order.
class BinarySource {
 public:
  BinarySource(std::string_view body, ByteOrder order) : rest_(body), order_(order) {}

  Walk next(Scalar type, double& value) {
    const std::size_t size = bytes_of(type);
    if (rest_.size() < size) return Walk::kEnded;
    value = load_scalar(rest_.data(), type, order_);
    rest_.remove_prefix(size);
    return Walk::kDone;
  }
  Walk skip(Scalar type, std::uint64_t count) {
    if (count > rest_.size() / bytes_of(type)) return Walk::kEnded;
    rest_.remove_prefix(count * bytes_of(type));
    return Walk::kDone;
  }
  // All at once, where an element has no lists.
  Walk skip_elements(const PlyElement& element) {
    if (element.count > rest_.size() / element.stride()) return Walk::kEnded;
    rest_.remove_prefix(element.count * element.stride());
    return Walk::kDone;
  }
  [[nodiscard]] std::uint64_t most(const PlyElement& element) const {
    return rest_.size() / std::max<std::size_t>(1, element.stride());
  }

 private:
  std::string_view rest_;
  ByteOrder order_;
};

// Numbers from a text body: words, wherever the lines end.
class TextSource {
 public:
  explicit TextSource(std::string_view body) : rest_(body) {}

  Walk next(Scalar /*type*/, double& value) {
    const std::string_view word = next_word(rest_);
    if (word.empty()) return Walk::kEnded;
    const auto number = parse_number(word);
    if (!number) return Walk::kNotANumber;
    value = *number;
    return Walk::kDone;
  }
  Walk skip(Scalar /*type*/, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i)
      if (next_word(rest_).empty()) return Walk::kEnded;
    return Walk::kDone;
  }
  Walk skip_elements(const PlyElement& element) {
    for (std::uint64_t i = 0; i < element.count; ++i)
      if (skip(Scalar::kFloat, element.properties.size()) != Walk::kDone) return Walk::kEnded;
    return Walk::kDone;
  }
  // A number and its blank take two characters.
  [[nodiscard]] std::uint64_t most(const PlyElement& element) const {
    return rest_.size() / std::max<std::size_t>(1, 2 * element.properties.size()) + 1;
  }

 private:
  std::string_view rest_;
};

template <class Source>
Walk walk_list(Source& source, const PlyProperty& property) {
  double length = 0;
  if (const Walk walk = source.next(*property.list_length_type, length); walk != Walk::kDone)
    return walk;
  if (!(length >= 0 && length < 9e15)) return Walk::kNegativeLength;
  return source.skip(property.type, static_cast<std::uint64_t>(length));
}

// Goes through one element; into `cloud` where `layout` is given. Every step takes at least a byte,
// so that no count that a header promises makes it run past the end of the file.
template <class Source>
Walk walk_element(Source& source, const PlyElement& element, const VertexLayout* layout,
                  RawCloud* cloud) {
  if (element.properties.empty()) return Walk::kDone;
  if (layout == nullptr && !element.has_lists()) return source.skip_elements(element);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    std::array<double, 6> values{};
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      double value = 0;
      const Walk walk = property.list_length_type ? walk_list(source, property)
                                                  : source.next(property.type, value);
      if (walk != Walk::kDone) return walk;
      if (layout != nullptr && layout->slots[p] != kNoSlot)
        values[static_cast<std::size_t>(layout->slots[p])] = value;
    }
    if (layout != nullptr) append(*cloud, *layout, values);
  }
  return Walk::kDone;
}

std::string complaint(Walk walk, const PlyElement& element) {
  const std::string where = " in element \"" + element.name + "\"";
  switch (walk) {
    case Walk::kNotANumber:
      return "has text where a number belongs" + where;
    case Walk::kNegativeLength:
      return "has a list of impossible length" + where;
    default:
      return "is cut short: fewer than the promised " + std::to_string(element.count) +
             " of element \"" + element.name + "\" follow";
  }
}

template <class Source>
Result<RawCloud> read_body(Source source, const PlyHeader& header, const std::string& name) {
  const auto refused = [&](const std::string& why) {
    return Error{ErrorCode::kBadInput, name + ": " + why + "; copy or export it again"};
  };
  for (const PlyElement& element : header.elements) {
    if (element.name != "vertex") {
      if (const Walk walk = walk_element(source, element, nullptr, nullptr); walk != Walk::kDone)
        return refused(complaint(walk, element));
      continue;
    }
    const VertexLayout layout = layout_of(element);
    if (!layout.has_points) return refused("its vertices have no x, y and z");
    // A promise beyond the file's size is refused before anything is allocated.
    if (element.count > source.most(element)) return refused(complaint(Walk::kEnded, element));
    RawCloud cloud;
    cloud.points.reserve(element.count);
    if (layout.has_normals) cloud.normals.reserve(element.count);
    if (const Walk walk = walk_element(source, element, &layout, &cloud); walk != Walk::kDone)
      return refused(complaint(walk, element));
    return cloud;  // what follows (faces) is not needed
  }
  return refused("has no element \"vertex\"");
}

}  // namespace

Result<RawCloud> read_ply(std::string_view bytes, const std::string& name) {
  const auto header = read_ply_header(bytes, name);
  if (!header) return header.error();
  if (header->format == PlyHeader::Format::kAscii)
    return read_body(TextSource(header->body), *header, name);
  return read_body(BinarySource(header->body, header->order), *header, name);
}

}  // namespace spool
