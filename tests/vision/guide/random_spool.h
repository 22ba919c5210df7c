// Spools written as piping files by a random walk: for drawings that nobody laid out by hand.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace spool::test {

struct RandomSpool {
  unsigned seed = 1;
  int parts = 40;       // bodies
  bool inches = false;  // of the coordinates; else millimetres
  std::string name = "SP1";
};

// NPS 4 of flanges, pipes of 200 to 1500 mm, elbows of 90 degrees, offsets of two 45s with a skew
// leg between, tees with a branch to a cap, and olets; every joint with a WELD record, W1, W2 ...,
// one in eight made on site.
[[nodiscard]] std::string random_spool_pcf(const RandomSpool& spool);

}  // namespace spool::test
