// spoolsight-inspect --verify and --replay: what a job's evidence is worth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "vision/core/result.h"

namespace spool::tools {

struct EvidenceOptions {
  std::string verify, signer;  // a job; a NAME.pub
  std::string replay;          // a job or JOB/evidence/NNNNNN
};

void add_evidence_options(CLI::App& app, EvidenceOptions& options);

// A line for each change on stdout; 0 intact, 1 altered. kBadInput: no job, no public key.
[[nodiscard]] Result<int> verify(const EvidenceOptions& options);

// Makes the report of an entry (of a job: its newest) again into `out` and compares; a line for
// each difference on stdout, 0 the same, 1 not. kUsage: no --out; kBadInput: no such entry, or one
// that was made of more than one frame.
[[nodiscard]] Result<int> replay(const EvidenceOptions& options, const std::string& out);

}  // namespace spool::tools
