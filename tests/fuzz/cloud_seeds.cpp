// Writes the sample clouds as seeds for the fuzzer, the format's byte before each.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/vision/scan/cloud_samples.h"

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("usage: cloud_seeds FOLDER\n", stderr);
    return 64;
  }
  std::filesystem::create_directories(words[1]);
  int number = 0;
  for (const spool::test::CloudSample& sample : spool::test::cloud_samples()) {
    const char format = sample.name.starts_with("PLY")   ? '\0'
                        : sample.name.starts_with("PCD") ? '\1'
                        : sample.name.starts_with("XYZ") ? '\2'
                                                         : '\3';
    std::ofstream file(std::filesystem::path(words[1]) / std::to_string(number++),
                       std::ios::binary);
    file << format << sample.bytes;
  }
  return 0;
}
