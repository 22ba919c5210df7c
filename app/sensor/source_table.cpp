// Which text opens which kind of source.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "app/sensor/source_kinds.h"

namespace spool::sensor {
namespace {

namespace fs = std::filesystem;

// What follows "NAME" or "NAME:" in a text; nothing where it names something else.
std::optional<std::string> after_name(const std::string& text, std::string_view name) {
  if (text == name) return std::string();
  if (text.size() > name.size() && text.compare(0, name.size(), name) == 0 &&
      text[name.size()] == ':')
    return text.substr(name.size() + 1);
  return std::nullopt;
}

bool ends_in_oni(const std::string& text) {
  std::string ending = fs::path(text).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".oni";
}

std::optional<std::string> as_folder(const std::string& text) {
  std::error_code ignored;
  if (fs::is_directory(text, ignored)) return text;
  return std::nullopt;
}

std::optional<std::string> as_oni(const std::string& text) {
  if (ends_in_oni(text)) return text;
  return std::nullopt;
}

struct SourceKind {
  // The argument for `open`, where the text is of this kind.
  std::optional<std::string> (*argument)(const std::string& text);
  OpenedSource (*open)(const std::string& argument, const SourceOptions& options);
};

constexpr std::array kKinds = {
    SourceKind{
        [](const std::string& text) { return after_name(text, "openni"); },
        [](const std::string& uri, const SourceOptions&) { return open_openni_device(uri); }},
    SourceKind{
        [](const std::string& text) { return after_name(text, "simulated"); },
        [](const std::string& scene, const SourceOptions&) { return open_simulated(scene); }},
    SourceKind{as_oni, open_oni_file},
    SourceKind{as_folder, open_depth_folder},
};

}  // namespace

Result<std::unique_ptr<DepthSource>> open_source(const std::string& text,
                                                 const SourceOptions& options) {
  if (!std::isfinite(options.speed) || options.speed < 0 || options.first_frame < 0)
    return Error{ErrorCode::kUsage,
                 text + ": the playback speed and the first frame must be 0 or more"};
  for (const SourceKind& kind : kKinds)
    if (const auto argument = kind.argument(text)) return kind.open(*argument, options);
  std::error_code ignored;
  if (fs::exists(text, ignored))
    return Error{ErrorCode::kBadInput,
                 text + ": is neither an .oni recording nor a depth folder; name one of these"};
  return Error{ErrorCode::kUsage,
               text +
                   ": is no source; use openni[:URI], FILE.oni, a depth folder or "
                   "simulated[:SCENE.json], and check the path"};
}

bool is_recording_path(const std::string& path) {
  std::error_code ignored;
  return fs::exists(fs::path(path) / "camera.json", ignored) ||
         (ends_in_oni(path) && fs::is_regular_file(path, ignored));
}

}  // namespace spool::sensor
