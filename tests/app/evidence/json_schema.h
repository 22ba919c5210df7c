// The part of JSON Schema 2020-12 that the report's schema uses, to check reports without
// another package.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace spool::test {

// Everything in `value` that `schema` does not allow, one line each with its place; a key that the
// schema does not describe counts, and so does a schema keyword that is not understood here
// (nothing is waved through).
[[nodiscard]] std::vector<std::string> schema_violations(const nlohmann::json& schema,
                                                         const nlohmann::json& value);

}  // namespace spool::test
