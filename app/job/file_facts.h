// What is recorded of a file so that any later change of it shows: bytes, SHA-256, time.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "vision/core/result.h"

namespace spool::job {

struct FileFacts {
  std::string file;  // relative to what it is recorded in, with '/' between
  std::uint64_t bytes = 0;
  std::string sha256;     // 64 hexadecimal digits
  double modified_s = 0;  // since 1970, UTC
};

// One thing that is not as it was recorded.
struct Change {
  enum class Kind { kChanged, kRemoved, kAdded, kRedated };
  Kind kind = Kind::kChanged;
  std::string file;  // relative to the job's folder
  std::string text;  // what about it
};
[[nodiscard]] std::string_view name(Change::Kind kind);  // changed removed added re-dated

// A file system may round times to this (FAT): less is no other date.
inline constexpr double kDateSlack_s = 2;

// Reads folder/file. kBadInput: missing, or not a plain file (a link is never followed); kIo.
[[nodiscard]] Result<FileFacts> facts_of(const std::filesystem::path& folder,
                                         const std::string& file);

// What differs between the record and folder/record.file now; nothing where it is as recorded.
// `prefix` goes before the name in the answer. Never follows a link.
[[nodiscard]] std::optional<Change> changed(const FileFacts& recorded,
                                            const std::filesystem::path& folder,
                                            const std::string& prefix);

[[nodiscard]] nlohmann::json facts_json(const std::vector<FileFacts>& files);
// kBadInput, with `where` named: not a list of such objects, one name twice, or a name that leads
// out of the folder (absolute, "..", empty parts).
[[nodiscard]] Result<std::vector<FileFacts>> facts_from_json(const nlohmann::json& list,
                                                             const std::string& where);

// Everything below `folder` that is no folder, links as themselves, relative with '/' between; and
// folders that hold nothing, with '/' at their end. Links are not followed.
[[nodiscard]] std::set<std::string> files_below(const std::filesystem::path& folder);

}  // namespace spool::job
