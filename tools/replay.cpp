// spoolsight-inspect --replay: a captured report made again from its stored frames.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "app/common/json_file.h"
#include "app/evidence/entry.h"
#include "app/evidence/report_difference.h"
#include "tools/inspect_evidence.h"
#include "tools/inspection.h"
#include "tools/plain_text.h"
#include "tools/replay_options.h"

namespace spool::tools {
namespace {

namespace fs = std::filesystem;

bool is_entry_name(const std::string& name) {
  return name.size() >= 6 && name.find_first_not_of("0123456789") == std::string::npos;
}

// The entry that is meant: itself, or the newest of a job.
Result<fs::path> entry_folder(const std::string& text) {
  fs::path path = fs::path(text).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  std::error_code code;
  if (is_entry_name(path.filename().string()) && fs::exists(path / evidence::kEntryFile, code))
    return path;
  fs::path newest;
  for (const auto& each : fs::directory_iterator(path / "evidence", code)) {
    const std::string name = each.path().filename().string();
    const std::string best = newest.filename().string();
    if (is_entry_name(name) &&
        (name.size() > best.size() || (name.size() == best.size() && name > best)))
      newest = each.path();
  }
  if (newest.empty())
    return Error{ErrorCode::kBadInput,
                 text + ": holds no capture; name a job or JOB/evidence/NNNNNN"};
  return newest;
}

// Flags of the entry with its own files in place of those that were on the command line then.
Result<InspectOptions> stored_options(const evidence::Entry& entry, const fs::path& folder,
                                      const std::string& out) {
  auto options = options_from(entry.options, (folder / evidence::kEntryFile).string());
  if (!options) return options.error();
  const auto inside = [&](std::string& file) {
    for (const auto& each : entry.files) {
      // A folder of frames is named by what lies in it.
      if (!file.empty() && (each.file == file || each.file.starts_with(file + "/"))) {
        file = (folder / file).string();
        return;
      }
    }
  };
  for (std::string* file :
       {&options->pairs, &options->pose, &options->standard, &options->calibration, &options->scan})
    inside(*file);
  options->designs = {(folder.parent_path().parent_path() / entry.design).string()};
  options->out = out;
  return options;
}

// What the report made again calls otherwise: paths, and the number of the only frame there is.
evidence::CompareOptions renamed(const nlohmann::json& stored, const InspectOptions& options) {
  evidence::CompareOptions compare;
  const auto text = [&](const char* object, const char* key) {
    const auto found = stored.find(object);
    if (found == stored.end() || !found->is_object() || !found->contains(key)) return std::string();
    const auto& value = (*found)[key];
    return value.is_string() ? value.get<std::string>() : value.dump();
  };
  compare.renamed = {{options.designs.front(), text("design", "file")},
                     {options.scan, text("scan", "file")},
                     {"is used, frame 0;", "is used, frame " + text("scan", "frame") + ";"}};
  return compare;
}

}  // namespace

Result<int> replay(const EvidenceOptions& asked, const std::string& out) {
  if (out.empty()) return Error{ErrorCode::kUsage, "--replay needs --out DIR for the new report"};
  const auto folder = entry_folder(asked.replay);
  if (!folder) return folder.error();
  const auto entry = evidence::read_entry(*folder);
  if (!entry) return entry.error();
  if (entry->options.empty())
    return Error{ErrorCode::kBadInput,
                 folder->string() +
                     ": its numbers are of many frames of a live camera and cannot be made again "
                     "from one; verify it instead"};
  std::size_t differences = 0;
  for (const auto& file : entry->files) {
    if (const auto change = job::changed(file, *folder, "")) {
      std::cout << plain_text(fmt::format("{}: {}: {}", job::name(change->kind), change->file,
                                          change->text))
                << "\n";
      ++differences;
    }
  }
  const auto options = stored_options(*entry, *folder, out);
  if (!options) return options.error();
  const auto stored = read_json(*folder / "report.json");
  if (!stored) return stored.error();
  if (const auto done = inspect(*options); !done) return done.error();
  const auto again = read_json(fs::path(out) / "report.json");
  if (!again) return again.error();
  const auto difference = evidence::compare_reports(*stored, *again, renamed(*stored, *options));
  for (const auto& each : difference.differences) std::cout << plain_text(each) << "\n";
  differences += difference.differences.size();
  if (difference.over_frames > 0)
    std::cout << fmt::format(
        "note: what the camera saw of {} parts over many frames (over_frames) is stored and not "
        "made again\n",
        difference.over_frames);
  if (stored->value("software", nlohmann::json()) != again->value("software", nlohmann::json()))
    std::cout << "note: the report was made by another version of SpoolSight\n";
  std::cout << fmt::format(
      "replay of {}: {}, {} numbers compared, the largest difference is {:.3g}\n", folder->string(),
      differences == 0 ? "the same" : "not the same", difference.numbers, difference.largest);
  return differences == 0 ? 0 : 1;
}

}  // namespace spool::tools
