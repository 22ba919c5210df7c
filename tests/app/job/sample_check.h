// A check with every field filled, each number another.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/job/check_record.h"

namespace spool::test {

// `seed` makes it another one.
[[nodiscard]] job::CheckRecord sample_check(int seed = 1);

// The fields of a record as one text, id included: equal texts are equal records.
[[nodiscard]] std::string text_of(const job::CheckRecord& record);

}  // namespace spool::test
