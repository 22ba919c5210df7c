// What every program of ours shares at its command line: --help, --version, --log-level, exit
// codes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include "vision/core/result.h"

namespace spool {

// Adds --version and --log-level to `app` (--help is CLI11's own). Log lines go to stderr.
void add_common_options(CLI::App& app, const std::string& program);

// A finite number above zero, or from zero on; anything else is told in a few words.
[[nodiscard]] CLI::Validator positive_number();
[[nodiscard]] CLI::Validator non_negative_number();

// Parses, runs `body`, prints an Error as one line on stderr, and gives the exit code: that of
// `body`, 64 for a bad command line, the error's own, 70 for an exception that got this far.
// Signals that would end the process on a full disk or a closed pipe are ignored, so that such a
// write fails with its reason instead.
[[nodiscard]] int run_program(CLI::App& app, int argc, char** argv,
                              const std::function<Result<int>()>& body);

}  // namespace spool
