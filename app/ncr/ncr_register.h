// Numbers of non-conformance reports, JOB-SHOP-NCR-NNN: each once, none left out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "vision/core/result.h"

namespace spool::ncr {

struct NcrFile {
  std::string name;  // in the report's folder
  std::string bytes;
};
using MakeFiles = std::function<Result<std::vector<NcrFile>>(const std::string& number)>;

// "JOB-SHOP" of a job's folder and a shop: letters, digits, '.', '_' and '-'; of a folder what is
// none of them becomes '_'. kUsage: a shop that is empty, of other letters or over 40 long, a
// folder whose name is too long for a file's.
[[nodiscard]] Result<std::string> number_prefix(const std::filesystem::path& job_folder,
                                                const std::string& shop);

struct Issued {
  std::string number;
  std::filesystem::path folder;  // that holds its files
};

// Takes the next number of `prefix`, has its files made and puts them into JOB/ncr/NUMBER/, which
// appears whole, by one rename, or not at all; only then the number is used. So a failure or a
// death at any moment leaves no gap, and the highest number ever given is kept beside, so that a
// folder that somebody removes is no number to be given again. Holds JOB/ncr/lock meanwhile and
// waits up to `patience_s` for it; any thread, any number of processes, whoever works on the job.
// With `copy_to` the same files also as copy_to/NUMBER/: where that cannot be prepared no number is
// used. kIo: not writable, held too long; and what `make` gives.
[[nodiscard]] Result<Issued> issue_ncr(const std::filesystem::path& job_folder,
                                       const std::string& prefix, const MakeFiles& make,
                                       const std::filesystem::path& copy_to = {},
                                       double patience_s = 20);

// Marks a report that was given a number as void: NUMBER/void.json says why, who and when. Its
// files stay and its number is not used again. kUsage: no such number in the job, void already, no
// reason; kIo.
[[nodiscard]] Status void_ncr(const std::filesystem::path& job_folder, const std::string& number,
                              const std::string& reason, const std::string& operator_name,
                              const std::string& at, double patience_s = 20);

}  // namespace spool::ncr
