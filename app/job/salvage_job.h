// Puts what can be read of a damaged journal in its place, and keeps the damaged one.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "app/job/journal.h"
#include "vision/core/result.h"

namespace spool::job {

struct SalvagedJob {
  Journal::Salvaged found;
  std::filesystem::path kept;  // the damaged journal, with its log beside it
};

// Takes the job's lock. The damaged journal is copied to journal.damaged-N.db before anything
// else, and what is salvaged takes its name at the end only: a death on the way leaves that copy
// whole. kUsage: the journal is sound; kBadInput: nothing can be read of it; kIo.
[[nodiscard]] Result<SalvagedJob> salvage_job(const std::filesystem::path& folder);

}  // namespace spool::job
