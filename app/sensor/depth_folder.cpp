// The files of a depth folder: the list of frames and their times.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/depth_folder.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>

#include "app/common/json_file.h"
#include "vision/core/file_io.h"

namespace spool::sensor {
namespace {

namespace fs = std::filesystem;

constexpr double kNominalPeriod = 1.0 / 30;                    // s, where nothing tells the times
constexpr std::uint64_t kListLimit = std::uint64_t{64} << 20;  // bytes of times.csv or depth.txt

Error bad(const fs::path& path, const std::string& why) {
  return Error{ErrorCode::kBadInput, path.string() + ": " + why};
}

template <class T>
std::optional<T> parse_number(std::string_view text) {
  T number{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// Calls `line(text, number)` for each line without its end, until it returns an error.
template <class Line>
Status for_each_line(std::string_view text, const Line& line) {
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view one = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!one.empty() && one.back() == '\r') one.remove_suffix(1);
    if (const Status status = line(one, number); !status) return status.error();
  }
  return {};
}

// times.csv: seconds by frame number.
Result<std::map<std::int64_t, double>> read_times(const fs::path& path) {
  auto text = read_file(path, kListLimit);
  if (!text) return text.error();
  std::map<std::int64_t, double> times;
  const Status status = for_each_line(*text, [&](std::string_view line, int number) -> Status {
    if (line.empty() || (number == 1 && line.rfind("frame", 0) == 0)) return {};
    const std::size_t comma = line.find(',');
    const auto frame = parse_number<std::int64_t>(line.substr(0, comma));
    const auto seconds =
        comma == line.npos ? std::nullopt : parse_number<double>(line.substr(comma + 1));
    if (!frame || !seconds || !std::isfinite(*seconds))
      return bad(path, "line " + std::to_string(number) + " is not \"frame,seconds\"; correct it");
    times[*frame] = *seconds;
    return {};
  });
  if (!status) return status.error();
  return times;
}

// TUM's list: "seconds path" a line, # for remarks.
Result<std::vector<DepthFile>> read_tum_list(const fs::path& path) {
  auto text = read_file(path, kListLimit);
  if (!text) return text.error();
  std::vector<DepthFile> files;
  const Status status = for_each_line(*text, [&](std::string_view line, int number) -> Status {
    if (line.empty() || line.front() == '#') return {};
    const std::size_t space = line.find(' ');
    const auto seconds = parse_number<double>(line.substr(0, space));
    const fs::path file = space == line.npos ? "" : std::string(line.substr(space + 1));
    const bool stays =
        !file.empty() && file.is_relative() &&
        std::none_of(file.begin(), file.end(), [](const fs::path& part) { return part == ".."; });
    if (!seconds || !std::isfinite(*seconds) || !stays)
      return bad(path, "line " + std::to_string(number) +
                           " is not \"seconds depth/FILE.png\"; correct it");
    files.push_back({path.parent_path() / file, *seconds});
    return {};
  });
  if (!status) return status.error();
  return files;
}

// depth/*.png in name order.
Result<std::vector<DepthFile>> list_images(const fs::path& folder) {
  std::vector<DepthFile> files;
  std::error_code code;
  for (fs::directory_iterator it(folder / "depth", code), end; !code && it != end;
       it.increment(code))
    if (it->path().extension() == ".png") files.push_back({it->path(), 0});
  if (code) return bad(folder, "its depth images cannot be listed (" + code.message() + ")");
  std::sort(files.begin(), files.end(), [](const DepthFile& a, const DepthFile& b) {
    return a.path.filename() < b.path.filename();
  });
  return files;
}

Status set_times(const fs::path& folder, std::vector<DepthFile>& files) {
  const fs::path path = folder / "times.csv";
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    for (std::size_t i = 0; i < files.size(); ++i)
      files[i].seconds = static_cast<double>(i) * kNominalPeriod;
    return {};
  }
  const auto times = read_times(path);
  if (!times) return times.error();
  const bool numbered = std::all_of(files.begin(), files.end(), [](const DepthFile& file) {
    return parse_number<std::int64_t>(file.path.stem().string()).has_value();
  });
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto number = numbered ? *parse_number<std::int64_t>(files[i].path.stem().string())
                                 : static_cast<std::int64_t>(i);
    const auto found = times->find(number);
    if (found == times->end())
      return bad(path, "has no time for frame " + std::to_string(number) + "; add it or remove " +
                           files[i].path.filename().string());
    files[i].seconds = found->second;
  }
  return {};
}

}  // namespace

Result<DepthFolder> read_depth_folder(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / "camera.json", ignored))
    return bad(folder, "is no depth folder, it has no camera.json; add the camera's intrinsics");
  auto camera = read_camera(folder / "camera.json");
  if (!camera) return camera.error();
  const fs::path tum = folder / "depth.txt";
  const bool has_tum = fs::exists(tum, ignored) && !fs::exists(folder / "times.csv", ignored);
  auto files = has_tum ? read_tum_list(tum) : list_images(folder);
  if (!files) return files.error();
  if (files->empty())
    return bad(folder, "holds no depth image; put 16-bit PNG files into its folder depth");
  if (!has_tum)
    if (const Status status = set_times(folder, *files); !status) return status.error();
  for (std::size_t i = 1; i < files->size(); ++i)
    if ((*files)[i].seconds < (*files)[i - 1].seconds)
      return bad((*files)[i].path,
                 "is earlier than the frame before it; correct the list of times");
  return DepthFolder{*std::move(camera), *std::move(files)};
}

}  // namespace spool::sensor
