// Writes the first inputs of pcf_fuzz into a folder: small good piping files of several writers.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/vision/piping/pcf_samples.h"

int main(int argc, char** argv) {
  if (argc != 2) return 64;
  namespace test = spool::test;
  std::filesystem::create_directories(argv[1]);
  const auto seed = [&](const char* name, char unit, const std::string& text) {
    std::ofstream(std::filesystem::path(argv[1]) / name, std::ios::binary) << unit << text;
  };
  seed("spool", 0, test::spool_pcf());
  seed("unindented", 1, test::unindented(test::spool_pcf()));
  seed("inches", 2, test::in_small_letters(test::spool_pcf()));
  seed("flanges", 1,
       test::pcf("FLANGE\n  END-POINT 900 0 0 4 BW\n  END-POINT 976.2 0 0 4 FL\n  SKEY FLWN\n"
                 "GASKET\n  END-POINT 976.2 0 0 4\n  END-POINT 979.2 0 0 4\n"
                 "FLANGE-BLIND\n  END-POINT 979.2 0 0 4 FL\n  SKEY FLBL\n"));
  seed("bends", 0,
       test::pcf(
           "ELBOW\n  END-POINT 848 0 0 4\n  END-POINT 1000 152 0 4\n  CENTRE-POINT 1000 0 0\n"
           "  BEND-RADIUS 114\nREDUCER-ECCENTRIC\n  END-POINT 1000 152 0 4\n  END-POINT 1000 254 "
           "12.7 3\n  FLAT-DIRECTION UP\nPIPE\n  END-POINT 0 0 0 4\n  END-POINT 848 0 0 4\n"
           "OLET\n  CENTRE-POINT 400 0 0\n  BRANCH1-POINT 400 0 90 1\n  SKEY WTBW\n"));
  seed("branches", 0,
       test::pcf("CROSS\n  END-POINT 895 0 0 4\n  END-POINT 1105 0 0 4\n  CENTRE-POINT 1000 0 0\n"
                 "  BRANCH1-POINT 1000 105 0 4\n  BRANCH2-POINT 1000 -105 0 4\n"
                 "TEE\n  END-POINT 900 9 0 4\n  END-POINT 1400 9 0 4\n  CENTRE-POINT 1000 9 0\n"
                 "  BRANCH1-POINT 1282.8 291.8 0 4\n"
                 "LAPJOINT-STUBEND\n  END-POINT 900 0 0 4 BW\n  END-POINT 1000 0 0 4 FL\n"));
  return 0;
}
