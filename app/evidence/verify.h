// Tells what of a job is not as it was recorded: changed, removed, added, re-dated, out of chain.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/job/file_facts.h"
#include "vision/core/result.h"

namespace spool::evidence {

struct VerifyOptions {
  std::string signer;  // public key that every entry has to be signed with; "": none asked for
};

struct Verified {
  std::vector<job::Change> changes;  // empty: intact
  std::vector<std::string> notes;    // what is no change and still worth a line
  std::int64_t entries = 0, files = 0;
  std::set<std::string> signers;  // public keys with a valid signature
  std::int64_t signed_entries = 0;
};

// Looks only: takes no lock, changes nothing, follows no link, believes no file. kBadInput: no
// job's folder. How far this goes without a key stands in ARCHITECTURE, Evidence.
[[nodiscard]] Result<Verified> verify_job(const std::filesystem::path& folder,
                                          const VerifyOptions& options = {});

}  // namespace spool::evidence
