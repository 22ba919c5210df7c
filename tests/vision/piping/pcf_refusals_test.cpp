// Files that are no Piping Component File, or a hostile one: refused by name, never a crash.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <random>
#include <string>

#include "tests/support/refusal.h"
#include "tests/vision/piping/pipework_probe.h"

namespace spool::piping {
namespace {

using test::pcf;
using test::spool_pcf;

TEST(PcfRefusals, SayWhatTheFileIs) {
  std::string idf;
  for (int i = 0; i < 40; ++i) idf += "   100  " + std::to_string(1000 * i) + "  0  0  64 BW\n";
  const struct {
    const char* what;
    std::string bytes, why;
  } cases[] = {
      {"font", std::string("\x01") + "fcp" + std::string(200, '\x02'), "screen font"},
      {"embroidery", std::string("STITCH\0\0\x04\x10\x81\x05", 12), "binary file"},
      {"pattern", "PCF" + std::string(300, '\x07'), "binary file"},
      {"IDF", idf, "Isometric Data File"},
      {"VPN profile", "[main]\nHost=10.0.0.1\nAuthType=1\n", "holds no piping component"},
      {"header only", "UNITS-BORE INCH\nPIPELINE-REFERENCE X\n", "holds no piping component"},
      {"materials only", "MATERIALS\nITEM-CODE A\n  DESCRIPTION PIPE\n",
       "holds no piping component"},
      {"zeros", pcf("PIPE\n  END-POINT 0 0 0 4\n  END-POINT 0 0 0 4\n"), "only zeros"},
      {"no unit of bores",
       pcf("PIPE\n  END-POINT 1 0 0 8\n  END-POINT 900 0 0 8\n", "UNITS-CO-ORDS MM\n"),
       "UNITS-BORE"},
      {"no unit of lengths",
       pcf("PIPE\n  END-POINT 1 0 0 4\n  END-POINT 9 0 0 4\n", "UNITS-BORE INCH\n"),
       "--design-unit"},
      {"no lines", "PIPE " + std::string(30000, 'x'), "has a line of 30005 bytes (line 1)"},
  };
  for (const auto& each : cases) {
    SCOPED_TRACE(each.what);
    test::expect_refused(read_pcf(each.bytes, "file.pcf"), ErrorCode::kBadInput, "file.pcf",
                         each.why);
  }
}

TEST(PcfRefusals, AFileCutAnywhereIsReadOrRefused) {
  const std::string text = spool_pcf();
  int read = 0;
  for (std::size_t length = 0; length < text.size(); length += 7) {
    const auto out = read_pcf(text.substr(0, length), "cut.pcf");
    if (out)
      ++read;
    else
      EXPECT_NE(out.error().message.find("cut.pcf"), std::string::npos);
  }
  EXPECT_GT(read, 400) << "most of its beginnings hold a component";
}

TEST(PcfRefusals, ADamagedFileIsReadOrRefused) {
  const std::string text = spool_pcf();
  std::mt19937 random(1);
  const std::string spice = "0123456789.-eE \n\t<>\"!#ABW,;/\xFF";
  int read = 0;
  for (int round = 0; round < 400; ++round) {
    std::string damaged = text;
    for (int i = 0; i < 20; ++i)
      damaged[random() % damaged.size()] = spice[random() % spice.size()];
    const auto out = read_pcf(damaged, "damaged.pcf");
    if (!out) continue;
    ++read;
    for (const PipeJoint& joint : out->joints) {
      ASSERT_LT(joint.a, static_cast<int>(out->components.size()));
      ASSERT_NE(joint.a, joint.b);
    }
  }
  EXPECT_GT(read, 300) << "twenty letters do not make a file unreadable";
}

TEST(PcfRefusals, ThousandsOfEndsAtOnePlaceTakeNoTime) {
  std::string heap;
  for (int i = 0; i < 5000; ++i) heap += "PIPE\n  END-POINT 5 5 5 4\n  END-POINT 5 5 6 4\n";
  const auto out = read_pcf(pcf(heap), "heap.pcf");  // finished at all: pairs are 5e7 otherwise
  ASSERT_TRUE(out);
  EXPECT_EQ(out->components.size(), 5000u);
  std::string more;
  for (int i = 0; i < 20001; ++i) more += "GASKET\n  END-POINT 5 5 5 4\n";
  test::expect_refused(read_pcf(pcf(more), "more.pcf"), ErrorCode::kBadInput, "more.pcf",
                       "more than the 20000");
}

}  // namespace
}  // namespace spool::piping
