// The model library on disk: read whole and checked, or refused; written whole.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pair_library_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool {
namespace {

static_assert(std::endian::native == std::endian::little, "the file is little-endian");

constexpr std::string_view kMagic = "SPOOLPRS";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kDigest = 64;  // hexadecimal digits of a SHA-256
constexpr std::size_t kHeader = kMagic.size() + sizeof kVersion + kDigest;

// The fields of the options in the file's order, for reading and for writing alike.
template <class Options, class Visit>
void visit_fields(Options& options, Visit&& visit) {
  visit(options.distance_over_diameter);
  visit(options.cell_rad);
  visit(options.model_samples);
  visit(options.leaf_over_spacing);
  visit(options.tolerance_over_leaf);
  visit(options.normal_neighbours);
  visit(options.seed);
}

class Writer {
 public:
  template <class T>
  void number(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(std::string_view value) {
    number(static_cast<std::uint64_t>(value.size()));
    bytes_.append(value);
  }
  template <class T>
  void numbers(const std::vector<T>& values) {
    number(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values) number(value);
  }
  void vectors(const std::vector<Eigen::Vector3f>& values) {
    number(static_cast<std::uint64_t>(values.size()));
    for (const Eigen::Vector3f& value : values)
      for (const float coordinate : value) number(coordinate);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// Takes values off the front; after the first that is not there, or is longer than what is left,
// ok() is false and everything is zero or empty.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

  template <class T>
  void number(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    value = T{};
    if (!take(sizeof value)) return;
    std::memcpy(&value, bytes_.data() - sizeof value, sizeof value);
  }
  void text(std::string& value) {
    const std::size_t length = count(1);
    if (take(length)) value.assign(bytes_.data() - length, length);
  }
  template <class T>
  void numbers(std::vector<T>& values) {
    values.resize(count(sizeof(T)));
    for (T& value : values) number(value);
  }
  void vectors(std::vector<Eigen::Vector3f>& values) {
    values.resize(count(3 * sizeof(float)));
    for (Eigen::Vector3f& value : values)
      for (float& coordinate : value) number(coordinate);
  }

 private:
  bool take(std::size_t length) {
    ok_ = ok_ && length <= bytes_.size();
    if (ok_) bytes_.remove_prefix(length);
    return ok_;
  }
  // A number of things of `size` bytes, never more than the bytes left can hold.
  std::size_t count(std::size_t size) {
    std::uint64_t value = 0;
    number(value);
    ok_ = ok_ && value <= bytes_.size() / size;
    return ok_ ? static_cast<std::size_t>(value) : 0;
  }

  std::string_view bytes_;
  bool ok_ = true;
};

bool is_length(double value) { return std::isfinite(value) && value > 0; }

bool is_consistent(const PairModel& model, std::size_t cells) {
  if (!is_length(model.diameter_m) || !is_length(model.distance_m) || !is_length(model.leaf_m) ||
      !is_length(model.tolerance_m))
    return false;
  const auto finite = [](const Eigen::Vector3f& v) { return v.allFinite(); };
  const auto& points = model.points;
  if (points.empty() || !points.has_normals() ||
      !std::all_of(points.points.begin(), points.points.end(), finite) ||
      !std::all_of(points.normals.begin(), points.normals.end(), finite))
    return false;
  const auto& first = model.cell_first;
  if (first.size() != cells + 1 || first.front() != 0 || first.back() != model.pairs.size() ||
      !std::is_sorted(first.begin(), first.end()))
    return false;
  return std::all_of(model.pairs.begin(), model.pairs.end(), [&](const OrientedPair& pair) {
    return pair.first < points.size() && pair.second < points.size() && pair.first != pair.second;
  });
}

}  // namespace

Status write_pair_library(const std::filesystem::path& path, const PairLibrary& library) {
  Writer content;
  visit_fields(library.options, [&](const auto& field) { content.number(field); });
  content.number(static_cast<std::uint64_t>(library.models.size()));
  for (const PairModel& model : library.models) {
    content.text(model.key);
    content.number(model.diameter_m);
    content.number(model.distance_m);
    content.number(model.tolerance_m);
    content.number(model.leaf_m);
    content.vectors(model.points.points);
    content.vectors(model.points.normals);
    content.numbers(model.cell_first);
    content.numbers(model.pairs);
  }
  Writer version;
  version.number(kVersion);
  return write_file_whole(
      path, std::string(kMagic) + version.bytes() + sha256_hex(content.bytes()) + content.bytes());
}

Result<PairLibrary> read_pair_library(const std::filesystem::path& path) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  return read_pair_library_bytes(*bytes, path.string());
}

Result<PairLibrary> read_pair_library_bytes(std::string_view all, const std::string& name) {
  const auto refused = [&](const std::string& what) {
    return Error{ErrorCode::kBadInput, name + ": " + what + "; delete it and it is made again"};
  };
  if (!all.starts_with(kMagic)) return refused("is not a model library");
  if (all.size() < kHeader) return refused("is a model library cut short");
  std::uint32_t version = 0;
  Reader(all.substr(kMagic.size())).number(version);
  if (version != kVersion)
    return refused("is a model library of version " + std::to_string(version) +
                   ", not of this program's " + std::to_string(kVersion));
  const std::string_view content = all.substr(kHeader);
  if (all.substr(kHeader - kDigest, kDigest) != sha256_hex(content))
    return refused("is a model library cut short or damaged");

  PairLibrary library;
  Reader reader(content);
  visit_fields(library.options, [&](auto& field) { reader.number(field); });
  if (!reader.ok() || validate(library.options))
    return refused("is a model library with options that make no sense");
  const std::size_t cells = FeatureCells(library.options.cell_rad).count();
  std::uint64_t models = 0;
  reader.number(models);
  for (std::uint64_t i = 0; i < models && reader.ok(); ++i) {
    PairModel model;
    reader.text(model.key);
    reader.number(model.diameter_m);
    reader.number(model.distance_m);
    reader.number(model.tolerance_m);
    reader.number(model.leaf_m);
    reader.vectors(model.points.points);
    reader.vectors(model.points.normals);
    reader.numbers(model.cell_first);
    reader.numbers(model.pairs);
    if (!reader.ok() || !is_consistent(model, cells)) break;
    library.models.push_back(std::move(model));
  }
  if (library.models.size() != models || !reader.at_end())
    return refused("is a model library that contradicts itself");
  return library;
}

Result<OpenedPairLibrary> open_pair_library(const std::filesystem::path& path,
                                            std::span<const DesignModel* const> designs,
                                            const PairLibraryOptions& options, const Watch& watch) {
  OpenedPairLibrary opened;
  opened.library.options = options;
  PairLibrary known;  // what the file holds: other designs stay in it
  auto there = read_pair_library(path);
  if (!there)
    opened.not_read = there.error().message;
  else if (there->options == options)
    known = std::move(*there);
  else
    opened.not_read = path.string() + ": was made with other options and is made again";
  known.options = options;
  for (const DesignModel* design : designs) {
    const std::string key = pair_model_key(*design, options);
    if (known.find(key) == nullptr) {
      auto model = build_pair_model(*design, options, watch);
      if (!model) return model.error();
      known.models.push_back(std::move(*model));
      ++opened.built;
    } else {
      ++opened.reused;
    }
    opened.library.models.push_back(*known.find(key));
  }
  if (opened.built == 0) return opened;
  if (const Status written = write_pair_library(path, known); !written)
    opened.not_written = written.error().message;
  return opened;
}

}  // namespace spool
