// SHA-256 over checks as the journal has them: what a capture says that all before it were.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "app/job/check_record.h"

namespace spool::job {

// 64 hexadecimal digits over every field of every record, numbers included; texts go in with their
// length, doubles as the shortest text that reads back as the same, so that no two lists of records
// are written alike. The order of fields is fixed for good (captures/1). Pure; any thread.
[[nodiscard]] std::string checks_sha256(std::span<const CheckRecord> records);

}  // namespace spool::job
