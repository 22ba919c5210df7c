// Reads a piping file written in a test and asks what came of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/vision/piping/pcf_samples.h"
#include "vision/piping/pcf_reader.h"

namespace spool::test {

// The pipework of a file that has to be read.
inline piping::Pipework read_good(const std::string& text) {
  auto read = piping::read_pcf(text, "file.pcf");
  EXPECT_TRUE(read.has_value()) << (read ? "" : read.error().message);
  return read ? std::move(*read) : piping::Pipework{};
}

// The line of the first problem whose text holds `what`; -1 where there is none.
inline int problem_line(const piping::Pipework& pipework, std::string_view what) {
  for (const piping::Problem& each : pipework.problems) {
    if (each.text.find(what) != std::string::npos) return each.line;
  }
  return -1;
}

inline std::string all_problems(const piping::Pipework& pipework) {
  std::string text;
  for (const piping::Problem& each : pipework.problems)
    text += std::to_string(each.line) + ": " + each.text + "\n";
  return text;
}

inline int count_of(const piping::Pipework& pipework, piping::ComponentKind kind) {
  return static_cast<int>(
      std::count_if(pipework.components.begin(), pipework.components.end(),
                    [&](const piping::Component& each) { return each.kind == kind; }));
}

}  // namespace spool::test
