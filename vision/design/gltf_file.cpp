// A glTF or GLB file through tinygltf, with the checks that the library leaves to its callers.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/gltf_file.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <system_error>
#include <vector>

#include <tiny_gltf.h>

#include "vision/core/file_io.h"

namespace spool {
namespace {

constexpr int kMaxJsonDepth = 64;  // tinygltf's parser recurses: 300 000 levels overflow the stack
constexpr std::uint64_t kMaxBufferBytes = std::uint64_t{1} << 30;

Error bad(const DesignFile& file, const std::string& what) {
  return {ErrorCode::kBadInput, file.path.string() + " " + what};
}

// ---- Before the library: the container and the nesting.

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) {
    value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

// The JSON chunk of a GLB whose header and chunks agree with the file's size (glTF 2.0, 4.4).
Result<std::string_view> json_chunk(const DesignFile& file) {
  const std::string_view bytes = file.bytes;
  constexpr std::uint32_t kJson = 0x4E4F534A;
  constexpr std::uint32_t kBin = 0x004E4942;
  if (bytes.size() < 20) return bad(file, "is cut short: it holds no GLB header");
  if (little_endian(bytes, 4) != 2) return bad(file, "is not glTF 2.0; export it as 2.0");
  if (little_endian(bytes, 8) != bytes.size()) {
    return bad(file, "is cut short or damaged: its header says " +
                         std::to_string(little_endian(bytes, 8)) + " bytes, the file has " +
                         std::to_string(bytes.size()));
  }
  std::string_view json;
  std::size_t at = 12;
  for (int chunk = 0; at < bytes.size(); ++chunk) {
    if (bytes.size() - at < 8) return bad(file, "is damaged: a GLB chunk has no header");
    const std::size_t length = little_endian(bytes, at);
    const std::uint32_t type = little_endian(bytes, at + 4);
    at += 8;
    if (length > bytes.size() - at)
      return bad(file, "is cut short: a GLB chunk ends after the file");
    if ((chunk == 0) != (type == kJson)) {
      return bad(file, "is damaged: the first GLB chunk, and no other, has to be JSON");
    }
    if ((type == kBin) && chunk != 1)
      return bad(file, "is damaged: its BIN chunk is not the second");
    if (chunk == 0) json = bytes.substr(at, length);
    at += length;
  }
  return json;
}

// The deepest nesting of brackets outside strings.
int nesting(std::string_view json) {
  int depth = 0;
  int deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      deepest = std::max(deepest, ++depth);
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return deepest;
}

// ---- What the library may open.

struct Files {
  std::filesystem::path folder;  // canonical
  std::string base;              // the prefix that tinygltf puts before a URI
  std::string refused;           // the first URI that was not opened, and why
};

// The canonical path of a URI that tinygltf asks for, if it lies in the design's folder.
std::optional<std::filesystem::path> inside(const std::string& asked, Files& files) {
  if (asked.compare(0, files.base.size(), files.base) != 0)
    return std::nullopt;  // its try from "."
  const std::string uri = asked.substr(files.base.size());
  const std::filesystem::path relative(uri);
  const auto refuse = [&](const std::string& why) {
    if (files.refused.empty()) files.refused = "'" + uri.substr(0, 200) + "' " + why;
    return std::nullopt;
  };
  if (uri.empty()) return refuse("is no file name");
  if (uri.find("://") != std::string::npos || uri.find(':') < uri.find('/')) {
    return refuse("is not a file beside it; nothing is ever fetched");
  }
  if (uri.find('\0') != std::string::npos || uri.find('\\') != std::string::npos) {
    return refuse("is not a file name");
  }
  std::error_code failed;
  const std::filesystem::path whole =
      relative.is_absolute() ? relative
                             : std::filesystem::weakly_canonical(files.folder / relative, failed);
  const auto [end, rest] =
      std::mismatch(files.folder.begin(), files.folder.end(), whole.begin(), whole.end());
  if (failed || relative.is_absolute() || end != files.folder.end()) {
    return refuse("lies outside the design's folder");
  }
  if (!std::filesystem::is_regular_file(whole, failed)) return refuse("is missing beside it");
  return whole;
}

bool file_exists(const std::string& asked, void* user) {
  return inside(asked, *static_cast<Files*>(user)).has_value();
}
std::string expand_path(const std::string& path, void*) { return path; }
bool read_whole_file(std::vector<unsigned char>* out, std::string* error, const std::string& asked,
                     void* user) {
  const std::optional<std::filesystem::path> path = inside(asked, *static_cast<Files*>(user));
  if (!path) return false;
  const Result<std::string> bytes = read_file(*path, kMaxBufferBytes);
  if (!bytes) {
    if (error != nullptr) *error = bytes.error().message;
    return false;
  }
  out->assign(bytes->begin(), bytes->end());
  return true;
}
bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
  return false;
}
bool ignore_image(tinygltf::Image*, const int, std::string*, std::string*, int, int,
                  const unsigned char*, int, void*) {
  return true;
}

// ---- After the library.

// Extensions that change no position may be required; of those that do, quantization is read.
bool leaves_shape_alone(std::string_view extension) {
  constexpr std::array<std::string_view, 6> kHarmless{
      "KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_", "KHR_xmp"};
  for (const std::string_view start : kHarmless) {
    if (extension.substr(0, start.size()) == start) return true;
  }
  return extension == "KHR_mesh_quantization";
}

std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return text.substr(0, 300);
}

Status check_buffers(const DesignFile& file, const tinygltf::Model& model) {
  for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
    const tinygltf::BufferView& view = model.bufferViews[i];
    const std::string name = "buffer view " + std::to_string(i);
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) {
      return bad(file, "is damaged: " + name + " names a buffer that is not there");
    }
    const std::size_t size = model.buffers[static_cast<std::size_t>(view.buffer)].data.size();
    if (view.byteLength == 0 || view.byteOffset > size ||
        view.byteLength > size - view.byteOffset) {
      return bad(file, "is damaged: " + name + " does not lie within its buffer");
    }
  }
  return {};
}

}  // namespace

void GltfDelete::operator()(tinygltf::Model* model) const { delete model; }

Result<GltfModel> load_gltf(const DesignFile& file) {
  const bool is_binary = file.bytes.compare(0, 4, "glTF") == 0;
  std::string_view json = file.bytes;
  if (is_binary) {
    const Result<std::string_view> chunk = json_chunk(file);
    if (!chunk) return chunk.error();
    json = *chunk;
  } else if (file.path.extension() == ".glb") {
    return bad(file, "is not a GLB file: it does not start with 'glTF'");
  }
  if (nesting(json) > kMaxJsonDepth) {
    return bad(file, "is nested more than " + std::to_string(kMaxJsonDepth) +
                         " levels deep, as no design is; it is not read");
  }
  Files files;
  std::error_code failed;
  files.folder =
      std::filesystem::canonical(std::filesystem::absolute(file.path).parent_path(), failed);
  if (failed) return bad(file, "lies in a folder that cannot be opened");
  files.base = "design-folder/";
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks({&file_exists, &expand_path, &read_whole_file, &write_nothing, &files});
  loader.SetImageLoader(&ignore_image, nullptr);
  GltfModel model(new tinygltf::Model);
  std::string error;
  std::string warning;
  const auto size =
      static_cast<unsigned int>(file.bytes.size());  // read_design's limit is below 4 GiB
  const bool ok = is_binary ? loader.LoadBinaryFromMemory(
                                  model.get(), &error, &warning,
                                  reinterpret_cast<const unsigned char*>(file.bytes.data()), size,
                                  "design-folder")
                            : loader.LoadASCIIFromString(model.get(), &error, &warning,
                                                         file.bytes.data(), size, "design-folder");
  if (!ok && !files.refused.empty())
    return bad(file, "needs a buffer that is not read: " + files.refused);
  if (!ok) return bad(file, "is not a glTF 2.0 file that can be read: " + one_line(error));
  for (const std::string& extension : model->extensionsRequired) {
    if (!leaves_shape_alone(extension)) {
      return bad(file, "requires the glTF extension " + one_line(extension) +
                           ", which is not read; export it without");
    }
  }
  if (Status checked = check_buffers(file, *model); !checked) return checked.error();
  return model;
}

}  // namespace spool
