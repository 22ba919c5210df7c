// Bytes to lines: characters, line ends, comments, and words as numbers, sizes and directions.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/pcf_text.h"

#include <string>

#include <gtest/gtest.h>

#include "vision/piping/item_text.h"
#include "vision/piping/pcf_numbers.h"
#include "vision/piping/pcf_units.h"

namespace spool::piping {
namespace {

TEST(PcfText, DecodesWhatWindowsWrites) {
  const auto old = read_pcf_text("PIPE\n  DESCRIPTION \xD8 60\xB0 \x80\n", "f");
  ASSERT_TRUE(old);
  EXPECT_EQ(old->lines[1].value, "\xC3\x98 60\xC2\xB0 \xE2\x82\xAC");
  EXPECT_TRUE(old->was_transcoded);
  const auto marked = read_pcf_text("\xEF\xBB\xBFPIPE\n", "f");
  ASSERT_TRUE(marked);
  EXPECT_EQ(marked->lines[0].keyword, "PIPE");
  EXPECT_FALSE(marked->was_transcoded);
  const std::string wide("\xFF\xFEP\0I\0P\0E\0\n\0", 12);
  const auto read = read_pcf_text(wide, "f");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->lines[0].keyword, "PIPE");
}

TEST(PcfText, CountsLinesWhateverEndsThem) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string e(end);
    const auto text =
        read_pcf_text("PIPE" + e + e + "! a comment" + e + "# another" + e + "TEE", "f");
    ASSERT_TRUE(text);
    ASSERT_EQ(text->lines.size(), 2u);
    EXPECT_EQ(text->lines[1].number, 5);
  }
}

TEST(PcfText, TakesKeywordsAsWritersSpellThem) {
  const auto text =
      read_pcf_text("<End_Point> 1 2 3\n\t\"x\"\n  ITEM-CODE: \"A B\"\n    Skey\tFLWN\n", "f");
  ASSERT_TRUE(text);
  EXPECT_EQ(text->lines[0].keyword, "END-POINT");
  EXPECT_EQ(text->lines[0].value, "1 2 3");
  EXPECT_EQ(text->lines[1].indent, 4);
  EXPECT_EQ(text->lines[2].keyword, "ITEM-CODE");
  EXPECT_EQ(text->lines[2].value, "A B");
  EXPECT_EQ(text->lines[3].value, "FLWN");
  EXPECT_EQ(text->lines[3].raw, "    Skey\tFLWN");
}

TEST(PcfNumbers, ReadsBoresInFractions) {
  const struct {
    const char* text;
    double bore;
  } cases[] = {{"4", 4},       {"1.5", 1.5}, {"1-1/2", 1.5}, {"3/4", 0.75}, {"4\"", 4},
               {"100mm", 100}, {"+2", 2},    {"1,5", 1.5},   {"50NB", 50}};
  for (const auto& each : cases) EXPECT_EQ(bore_of(each.text), each.bore) << each.text;
  for (const char* none :
       {"", "0", "-4", "x", "1/0", "nan", "inf", "1e999", "4 4", "1-", "/2", "1-/"})
    EXPECT_EQ(bore_of(none), std::nullopt) << none;
}

TEST(PcfNumbers, ReadsPointsHoweverSeparated) {
  const struct {
    const char* text;
    double x, bore;
    const char* end;
  } cases[] = {{"1.5 2 3 4 BW", 1.5, 4, "BW"}, {"1.5,2,3,4,fl", 1.5, 4, "FL"},
               {"1.5, 2, 3, 4", 1.5, 4, ""},   {"1,5 2 3 1 1/2 SW", 1.5, 1.5, "SW"},
               {"1.5\t2\t3", 1.5, 0, ""},      {"1.5 2 3 0 BW", 1.5, 0, "BW"},
               {"1.5 2 3 PL", 1.5, 0, "PL"},   {"1.5;2;3;4", 1.5, 4, ""}};
  for (const auto& each : cases) {
    const auto point = point_of(each.text);
    ASSERT_TRUE(point) << each.text;
    EXPECT_EQ(point->position, Eigen::Vector3d(each.x, 2, 3)) << each.text;
    EXPECT_EQ(point->bore.value_or(0), each.bore) << each.text;
    EXPECT_EQ(point->end, each.end) << each.text;
    EXPECT_EQ(point->trouble, "") << each.text;
  }
  EXPECT_FALSE(point_of("1 2"));
  EXPECT_FALSE(point_of("1 2 east"));
  EXPECT_FALSE(point_of("nan 0 0"));
  EXPECT_EQ(point_of("1 2 3 4x4")->trouble, "the bore '4x4' is no size");
  EXPECT_EQ(point_of("1 2 3 4 12")->trouble, "'12' is no type of end");
}

TEST(PcfNumbers, TakesAnglesInDegreesOrHundredths) {
  EXPECT_EQ(angle_nearest(9000, 90.02), 90);
  EXPECT_EQ(angle_nearest(90, 90.02), 90);
  EXPECT_EQ(angle_nearest(4500, 45), 45);
  EXPECT_EQ(angle_nearest(1, 0.01), 0.01);
}

TEST(PcfNumbers, KnowsDirectionsByName) {
  EXPECT_EQ(direction_of("down"), -Eigen::Vector3d::UnitZ());
  EXPECT_EQ(direction_of("NORTH"), Eigen::Vector3d::UnitY());
  EXPECT_NEAR(direction_of("SW")->y(), -std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(direction_of("0 0 -5")->z(), -1, 1e-12);
  EXPECT_FALSE(direction_of("0 0 0"));
  EXPECT_FALSE(direction_of("sideways"));
}

TEST(PcfUnits, ReadsBoresAsNominalSizes) {
  const struct {
    double written;
    BoreUnit unit;
    double nps;
    const char* note;
  } cases[] = {
      {4, BoreUnit::kInch, 4, ""},
      {0.75, BoreUnit::kInch, 0.75, ""},
      {4.5, BoreUnit::kInch, 4, "outside diameter of NPS 4 in inches"},
      {2.375, BoreUnit::kInch, 2, "outside diameter of NPS 2"},
      {100, BoreUnit::kInch, 4, "mixes units"},
      {36, BoreUnit::kInch, 36, ""},
      {100, BoreUnit::kMillimetre, 4, ""},
      {60.3, BoreUnit::kMillimetre, 2, "outside diameter of NPS 2"},
      {273.1, BoreUnit::kMillimetre, 10, "outside diameter of NPS 10"},
      {50.8, BoreUnit::kMillimetre, 2, "turned into mm"},
      {4, BoreUnit::kMillimetre, 4, "mixes units"},
      {900, BoreUnit::kMillimetre, 36, ""},
      {64, BoreUnit::kInchSixteenth, 4, ""},
      {24, BoreUnit::kInchSixteenth, 1.5, ""},
      {47, BoreUnit::kMillimetre, 0, "no nominal size"},
      {7.3, BoreUnit::kInch, 0, "no nominal size"},
  };
  for (const auto& each : cases) {
    const Bore bore = read_bore(each.written, each.unit);
    EXPECT_EQ(bore.nps, each.nps) << each.written;
    EXPECT_NE(bore.note.find(each.note), std::string::npos) << bore.note;
    EXPECT_EQ(bore.note.empty(), std::string(each.note).empty()) << bore.note;
  }
  EXPECT_DOUBLE_EQ(read_bore(4, BoreUnit::kInch).outside_diameter, 0.1143);
  EXPECT_DOUBLE_EQ(read_bore(36, BoreUnit::kInch).outside_diameter, 36 * 0.0254);
}

TEST(PcfUnits, SettlesTheUnitOfBores) {
  using U = std::optional<BoreUnit>;
  const double inches[] = {4, 3, 0.75};
  const double millimetres[] = {100, 80, 25};
  const double both[] = {8, 10};  // DN 8 and NPS 8
  const double diameters[] = {60.3, 88.9};
  EXPECT_EQ(settle_bore_unit(U{}, inches), BoreUnit::kInch);
  EXPECT_EQ(settle_bore_unit(U{}, millimetres), BoreUnit::kMillimetre);
  EXPECT_EQ(settle_bore_unit(BoreUnit::kInch, millimetres), BoreUnit::kMillimetre);
  EXPECT_EQ(settle_bore_unit(BoreUnit::kMillimetre, inches), BoreUnit::kInch);
  EXPECT_EQ(settle_bore_unit(U{}, both), std::nullopt);
  EXPECT_EQ(settle_bore_unit(BoreUnit::kMillimetre, both), BoreUnit::kMillimetre);
  EXPECT_EQ(settle_bore_unit(BoreUnit::kMillimetre, diameters), BoreUnit::kMillimetre);
  EXPECT_EQ(settle_bore_unit(U{}, diameters), std::nullopt);
}

TEST(ItemText, FindsScheduleAndClassInFreeText) {
  const struct {
    const char* text;
    const char* schedule;
    const char* rating;
  } cases[] = {
      {"PIPE SMLS SCH 40 A106-B", "40", ""},
      {"PIPE, SCH.80S, A312", "80S", ""},
      {"ELBOW 90 LR BW S-STD", "STD", ""},
      {"Elbow sch40s", "40S", ""},
      {"RED CONC SCH 40 X SCH 80", "40", ""},
      {"FLANGE WN RF CL300 XS", "XS", "300"},
      {"FLANGE WN RF 150# S-40", "40", "150"},
      {"FLANGE CLASS 150", "", "150"},
      {"BLIND #300 RF", "", "300"},
      {"SOCKOLET 3000 LB", "", "3000"},
      {"ASTM A105 150 MM LONG", "", ""},
      {"TYPE S 40 FT", "", ""},
      {"CAP SCHEDULE 160", "160", ""},
      {"", "", ""},
  };
  for (const auto& each : cases) {
    EXPECT_EQ(schedule_in(each.text), each.schedule) << each.text;
    EXPECT_EQ(rating_in(each.text), each.rating) << each.text;
  }
}

}  // namespace
}  // namespace spool::piping
