// Numbers of non-conformance reports, JOB-SHOP-NCR-NNN: each once, none left out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_register.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "app/common/json_file.h"
#include "app/job/job_lock.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::ncr {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMiddle = "-NCR-";
constexpr std::string_view kStaging = ".part-";
constexpr std::size_t kMaxNumber_bytes = 200;  // of the 255 of a file's name

Error cannot_write(const fs::path& path, const std::string& why) {
  return {ErrorCode::kIo, path.string() + ": cannot be written (" + why +
                              "); check the folder's rights and free space"};
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '_' || c == '-';
}

// The NNN of a name that is PREFIX-NCR-NNN; 0 of any other.
std::int64_t count_in(const std::string& name, const std::string& prefix) {
  const std::string start = prefix + std::string(kMiddle);
  if (!name.starts_with(start) || name.size() < start.size() + 3) return 0;
  std::int64_t count = 0;
  const char* const end = name.data() + name.size();
  const auto [at, code] = std::from_chars(name.data() + start.size(), end, count);
  return code == std::errc() && at == end && count > 0 ? count : 0;
}

fs::path register_path(const fs::path& folder) { return folder / "register.json"; }

// The highest number that was ever given: of the folders that are there and of the register.
Result<std::int64_t> last_given(const fs::path& folder, const std::string& prefix) {
  std::int64_t last = 0;
  std::error_code code;
  for (fs::directory_iterator at(folder, code), end; !code && at != end; at.increment(code))
    last = std::max(last, count_in(at->path().filename().string(), prefix));
  if (code) return cannot_write(folder, code.message());
  if (!fs::exists(register_path(folder), code)) return last;
  const auto json = read_json(register_path(folder));
  if (!json) return json.error();
  if (json->is_object() && json->contains(prefix) && (*json)[prefix].is_number_integer())
    last = std::max(last, (*json)[prefix].get<std::int64_t>());
  return last;
}

// The list of a report's files, which `spoolsight-inspect --verify` compares them with.
std::string list_of(const std::vector<NcrFile>& files) {
  nlohmann::json list = nlohmann::json::array();
  for (const NcrFile& each : files)
    list.push_back(
        {{"name", each.name}, {"bytes", each.bytes.size()}, {"sha256", sha256_hex(each.bytes)}});
  return json_text({{"schema", "spoolsight-ncr-files/1"}, {"files", list}});
}

nlohmann::json register_of(const fs::path& folder) {
  std::error_code code;
  if (fs::exists(register_path(folder), code))
    if (auto json = read_json(register_path(folder)); json && json->is_object())
      return *std::move(json);
  return nlohmann::json::object();
}

// Before the report appears: what its list will be. Until its number is given nobody misses it.
Status note_list(const fs::path& folder, const std::string& number, const std::string& list) {
  nlohmann::json all = register_of(folder);
  if (!all.contains("lists") || !all["lists"].is_object()) all["lists"] = nlohmann::json::object();
  all["lists"][number] = sha256_hex(list);
  return write_file_whole(register_path(folder), json_text(all));
}

Status note_given(const fs::path& folder, const std::string& prefix, std::int64_t count) {
  nlohmann::json all = register_of(folder);
  all[prefix] = count;
  return write_file_whole(register_path(folder), json_text(all));
}

// A rename is on the disk once its folder is.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)!::fsync(descriptor);
  ::close(descriptor);
}

// A folder beside the one to come; gone with this unless it was moved there.
class Staging {
 public:
  explicit Staging(const fs::path& parent)
      : parent_(parent), path_(parent / (std::string(kStaging) + std::to_string(::getpid()))) {}
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  ~Staging() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] Status fill(const std::vector<NcrFile>& files, const fs::path& final_folder) {
    if (Status made = make_folder(path_); !made) return named(made.error(), final_folder);
    for (const NcrFile& each : files)
      if (Status done = write_file_whole(path_ / each.name, each.bytes); !done)
        return named(done.error(), final_folder);
    return {};
  }
  [[nodiscard]] Status move_to(const fs::path& final_folder) {
    std::error_code code;
    fs::rename(path_, final_folder, code);
    if (code) return cannot_write(final_folder, code.message());
    sync_folder(parent_);
    return {};
  }

 private:
  // The error as the user knows the file: where it was to be.
  [[nodiscard]] Error named(Error error, const fs::path& final_folder) const {
    const auto at = error.message.find(path_.string());
    if (at != std::string::npos)
      error.message.replace(at, path_.string().size(), final_folder.string());
    return error;
  }
  fs::path parent_, path_;
};

// What a killed run left. Under the lock nobody else prepares anything there.
void remove_abandoned(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> abandoned;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with(kStaging)) abandoned.push_back(entry.path());
  for (const fs::path& each : abandoned) fs::remove_all(each, ignored);
}

Result<job::JobLock> wait_for_lock(const fs::path& folder, double patience_s) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration<double>(patience_s);
  for (;;) {
    auto lock = job::JobLock::take(folder / "lock");
    if (lock || Clock::now() >= until) return lock;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace

Result<std::string> number_prefix(const fs::path& job_folder, const std::string& shop) {
  constexpr std::size_t kMaxShop = 40;
  if (shop.empty() || shop.size() > kMaxShop || !std::all_of(shop.begin(), shop.end(), is_letter))
    return Error{ErrorCode::kUsage, fmt::format("--shop: has to be 1 to {} letters of A-Z a-z 0-9 "
                                                ". _ -, as it is part of the number",
                                                kMaxShop)};
  std::string name = job_folder.filename().string();
  if (name.empty()) name = job_folder.parent_path().filename().string();  // JOB.spooljob/
  constexpr std::string_view kEnding = ".spooljob";
  if (name.ends_with(kEnding)) name.resize(name.size() - kEnding.size());
  for (char& c : name)
    if (!is_letter(c)) c = '_';
  const std::string prefix = name + "-" + shop;
  if (name.empty() || prefix.size() + kMiddle.size() + 12 > kMaxNumber_bytes)
    return Error{ErrorCode::kUsage,
                 job_folder.string() + ": the folder's name is too long for a report's number"};
  return prefix;
}

Result<Issued> issue_ncr(const fs::path& job_folder, const std::string& prefix,
                         const MakeFiles& make, const fs::path& copy_to, double patience_s) {
  const fs::path folder = job_folder / "ncr";
  if (Status made = make_folder(folder); !made) return made.error();
  const auto lock = wait_for_lock(folder, patience_s);
  if (!lock) return lock.error();
  remove_abandoned(folder);
  const auto last = last_given(folder, prefix);
  if (!last) return last.error();
  Issued issued;
  issued.number = fmt::format("{}{}{:03}", prefix, kMiddle, *last + 1);
  issued.folder = folder / issued.number;
  auto files = make(issued.number);
  if (!files) return files.error();
  const std::string list = list_of(*files);
  files->push_back({"files.json", list});
  Staging staging(folder);
  if (Status filled = staging.fill(*files, issued.folder); !filled) return filled.error();
  if (copy_to.empty()) {
    if (Status noted = note_list(folder, issued.number, list); !noted) return noted.error();
    if (Status moved = staging.move_to(issued.folder); !moved) return moved.error();
  } else {
    if (Status made = make_folder(copy_to); !made) return made.error();
    std::error_code code;
    if (fs::exists(copy_to / issued.number, code))
      return cannot_write(copy_to / issued.number, "it is there already");
    Staging copy(copy_to);
    if (Status filled = copy.fill(*files, copy_to / issued.number); !filled) return filled.error();
    if (Status noted = note_list(folder, issued.number, list); !noted) return noted.error();
    if (Status moved = staging.move_to(issued.folder); !moved) return moved.error();
    if (Status moved = copy.move_to(copy_to / issued.number); !moved) return moved.error();
  }
  // The folder alone tells the number; where this is lost, only a removed folder would be missed.
  (void)note_given(folder, prefix, *last + 1);
  return issued;
}

Status void_ncr(const fs::path& job_folder, const std::string& number, const std::string& reason,
                const std::string& operator_name, const std::string& at, double patience_s) {
  const fs::path folder = job_folder / "ncr";
  std::error_code code;
  const bool is_name = !number.empty() && std::all_of(number.begin(), number.end(), is_letter) &&
                       number.find(kMiddle) != std::string::npos;
  if (!is_name || !fs::is_directory(folder / number, code))
    return Error{ErrorCode::kUsage, number + ": the job has no report of this number"};
  if (reason.empty()) return Error{ErrorCode::kUsage, "--reason: say why the report is void"};
  const auto lock = wait_for_lock(folder, patience_s);
  if (!lock) return lock.error();
  const fs::path file = folder / number / "void.json";
  if (fs::exists(file, code)) return Error{ErrorCode::kUsage, number + ": is void already"};
  return write_file_whole(file, json_text({{"schema", "spoolsight-ncr-void/1"},
                                           {"number", number},
                                           {"reason", reason},
                                           {"operator", operator_name},
                                           {"at", at}}));
}

}  // namespace spool::ncr
