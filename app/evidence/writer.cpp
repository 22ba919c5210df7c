// Writes an inspection's folder: report.json, report.html, points.ply, overlay_*.png (ARCHITECTURE,
// What inspect writes).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/writer.h"

#include <cerrno>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

#include <signal.h>
#include <unistd.h>

#include "app/evidence/points_ply.h"
#include "vision/core/file_io.h"

namespace spool::evidence {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStagingPrefix = ".part-";

// A folder beside the files to come, on the same disk; gone with this, whatever happened.
class Staging {
 public:
  explicit Staging(const fs::path& folder)
      : path_(folder / (std::string(kStagingPrefix) + std::to_string(::getpid()))) {}
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  ~Staging() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// The error as the user knows the file: where it was to be, not where it was prepared.
Error in_folder(Error error, const fs::path& staging, const fs::path& folder) {
  const auto at = error.message.find(staging.string());
  if (at != std::string::npos) error.message.replace(at, staging.string().size(), folder.string());
  return error;
}

// What a killed run left: the folder's name ends in the number of a process that is no more.
void remove_abandoned(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> abandoned;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string file = entry.path().filename().string();
    int process = 0;
    const bool ours =
        file.starts_with(kStagingPrefix) &&
        std::from_chars(file.data() + kStagingPrefix.size(), file.data() + file.size(), process)
                .ec == std::errc{};
    if (ours && process > 0 && ::kill(process, 0) != 0 && errno == ESRCH)
      abandoned.push_back(entry.path());
  }
  for (const auto& path : abandoned) fs::remove_all(path, ignored);
}

// Of an inspection, overlay_1.png and on; a picture of somebody else's stays.
bool is_old_picture(const fs::path& path) {
  constexpr std::string_view kPrefix = "overlay_";
  const std::string file = path.stem().string();
  return file.starts_with(kPrefix) && path.extension() == ".png" && file.size() > kPrefix.size() &&
         file.find_first_not_of("0123456789", kPrefix.size()) == std::string::npos;
}

Error cannot_write(const fs::path& path, const std::string& why) {
  return {ErrorCode::kIo,
          path.string() + ": cannot be written (" + why + "); choose another folder"};
}

Status write_all(const fs::path& folder, const InspectionRecord& record,
                 const std::vector<OverlayPicture>& pictures) {
  for (const auto& picture : pictures)
    if (auto status = render::write_png(folder / picture.file, picture.image); !status)
      return status;
  if (auto status = write_points(folder / "points.ply", record); !status) return status;
  if (auto status = write_file_whole(folder / "report.html", report_html(record, pictures));
      !status)
    return status;
  return write_file_whole(folder / "report.json", report_json(record));
}

Status move_into_place(const fs::path& staging, const fs::path& folder,
                       const std::vector<OverlayPicture>& pictures) {
  std::error_code code;
  std::vector<std::string> files;
  files.reserve(pictures.size() + 3);
  for (const auto& picture : pictures) files.push_back(picture.file);
  for (const char* file : {"points.ply", "report.html", "report.json"}) files.emplace_back(file);
  // What cannot be replaced is found out before anything is.
  for (const auto& file : files)
    if (fs::is_directory(folder / file, code))
      return cannot_write(folder / file, "a folder of that name lies there");
  // From here on no report.json says that the folder is complete, until the new one does.
  fs::remove(folder / "report.json", code);
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder, code))
    if (is_old_picture(entry.path())) old.push_back(entry.path());
  for (const auto& path : old) fs::remove(path, code);
  for (const auto& file : files) {
    fs::rename(staging / file, folder / file, code);
    if (code) return cannot_write(folder / file, code.message());
  }
  return {};
}

}  // namespace

Status write_inspection(const fs::path& folder, const InspectionRecord& record,
                        const std::vector<OverlayPicture>& pictures) {
  if (auto status = make_folder(folder); !status) return status;
  remove_abandoned(folder);
  const Staging staging(folder);
  if (auto status = make_folder(staging.path()); !status)
    return in_folder(status.error(), staging.path(), folder);
  if (auto status = write_all(staging.path(), record, pictures); !status)
    return in_folder(status.error(), staging.path(), folder);
  return move_into_place(staging.path(), folder, pictures);
}

}  // namespace spool::evidence
