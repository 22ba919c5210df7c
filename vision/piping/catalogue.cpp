// The sizes of pipe, butt-weld fittings and flanges by nominal pipe size: the tables and their
// look-up.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/catalogue.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace spool::piping {
namespace {

constexpr double kMm = 0.001;

constexpr PipeSize pipe(double nps, int dn, double od) { return {nps, dn, od * kMm}; }

constexpr FittingSize fitting(double nps, double lr, double sr, double b, double c, double e,
                              double h) {
  return {nps, lr * kMm, sr * kMm, b * kMm, c * kMm, e * kMm, h * kMm};
}

constexpr FlangeSize flange(int rating, double nps, double od, double thickness, double face,
                            double circle, int holes, double hole, double hub, double neck,
                            double slip_on) {
  return {rating, nps,        od * kMm,  thickness * kMm, face * kMm,   circle * kMm,
          holes,  hole * kMm, hub * kMm, neck * kMm,      slip_on * kMm};
}

// Columns of the table of walls. Schedule 40 is STD up to NPS 10 and 80 is XS up to NPS 8.
constexpr std::array<std::string_view, 15> kSchedules{"5S",  "10S", "10",  "20",  "30",
                                                      "STD", "40",  "60",  "XS",  "80",
                                                      "100", "120", "140", "160", "XXS"};
struct Walls {
  double nps;
  std::array<double, 15> mm;  // kSchedules' order; 0: not made
};

// clang-format off
constexpr std::array kPipes{
    pipe(0.125, 6, 10.3), pipe(0.25, 8, 13.7), pipe(0.375, 10, 17.1), pipe(0.5, 15, 21.3), pipe(0.75, 20, 26.7),
    pipe(1, 25, 33.4), pipe(1.25, 32, 42.2), pipe(1.5, 40, 48.3), pipe(2, 50, 60.3), pipe(2.5, 65, 73.0),
    pipe(3, 80, 88.9), pipe(3.5, 90, 101.6), pipe(4, 100, 114.3), pipe(5, 125, 141.3), pipe(6, 150, 168.3),
    pipe(8, 200, 219.1), pipe(10, 250, 273.0), pipe(12, 300, 323.8), pipe(14, 350, 355.6), pipe(16, 400, 406.4),
    pipe(18, 450, 457), pipe(20, 500, 508), pipe(24, 600, 610),
};

constexpr std::array kWalls{
    //             5S    10S    10     20     30    STD     40     60     XS     80    100    120    140    160    XXS
    Walls{0.125, {0,    1.24,  1.24,  0,     1.45,  1.73,  1.73,  0,     2.41,  2.41,  0,     0,     0,     0,     0}},
    Walls{0.25,  {0,    1.65,  1.65,  0,     1.85,  2.24,  2.24,  0,     3.02,  3.02,  0,     0,     0,     0,     0}},
    Walls{0.375, {0,    1.65,  1.65,  0,     1.85,  2.31,  2.31,  0,     3.20,  3.20,  0,     0,     0,     0,     0}},
    Walls{0.5,   {1.65, 2.11,  2.11,  0,     2.41,  2.77,  2.77,  0,     3.73,  3.73,  0,     0,     0,     4.78,  7.47}},
    Walls{0.75,  {1.65, 2.11,  2.11,  0,     2.41,  2.87,  2.87,  0,     3.91,  3.91,  0,     0,     0,     5.56,  7.82}},
    Walls{1,     {1.65, 2.77,  2.77,  0,     2.90,  3.38,  3.38,  0,     4.55,  4.55,  0,     0,     0,     6.35,  9.09}},
    Walls{1.25,  {1.65, 2.77,  2.77,  0,     2.97,  3.56,  3.56,  0,     4.85,  4.85,  0,     0,     0,     6.35,  9.70}},
    Walls{1.5,   {1.65, 2.77,  2.77,  0,     3.18,  3.68,  3.68,  0,     5.08,  5.08,  0,     0,     0,     7.14, 10.15}},
    Walls{2,     {1.65, 2.77,  2.77,  0,     3.18,  3.91,  3.91,  0,     5.54,  5.54,  0,     0,     0,     8.74, 11.07}},
    Walls{2.5,   {2.11, 3.05,  3.05,  0,     4.78,  5.16,  5.16,  0,     7.01,  7.01,  0,     0,     0,     9.53, 14.02}},
    Walls{3,     {2.11, 3.05,  3.05,  0,     4.78,  5.49,  5.49,  0,     7.62,  7.62,  0,     0,     0,    11.13, 15.24}},
    Walls{3.5,   {2.11, 3.05,  3.05,  0,     4.78,  5.74,  5.74,  0,     8.08,  8.08,  0,     0,     0,     0,     0}},
    Walls{4,     {2.11, 3.05,  3.05,  0,     4.78,  6.02,  6.02,  0,     8.56,  8.56,  0,    11.13,  0,    13.49, 17.12}},
    Walls{5,     {2.77, 3.40,  3.40,  0,     0,     6.55,  6.55,  0,     9.53,  9.53,  0,    12.70,  0,    15.88, 19.05}},
    Walls{6,     {2.77, 3.40,  3.40,  0,     0,     7.11,  7.11,  0,    10.97, 10.97,  0,    14.27,  0,    18.26, 21.95}},
    Walls{8,     {2.77, 3.76,  3.76,  6.35,  7.04,  8.18,  8.18, 10.31, 12.70, 12.70, 15.09, 18.26, 20.62, 23.01, 22.23}},
    Walls{10,    {3.40, 4.19,  4.19,  6.35,  7.80,  9.27,  9.27, 12.70, 12.70, 15.09, 18.26, 21.44, 25.40, 28.58, 25.40}},
    Walls{12,    {3.96, 4.57,  4.57,  6.35,  8.38,  9.53, 10.31, 14.27, 12.70, 17.48, 21.44, 25.40, 28.58, 33.32, 25.40}},
    Walls{14,    {3.96, 4.78,  6.35,  7.92,  9.53,  9.53, 11.13, 15.09, 12.70, 19.05, 23.83, 27.79, 31.75, 35.71,  0}},
    Walls{16,    {4.19, 4.78,  6.35,  7.92,  9.53,  9.53, 12.70, 16.66, 12.70, 21.44, 26.19, 30.96, 36.53, 40.49,  0}},
    Walls{18,    {4.19, 4.78,  6.35,  7.92, 11.13,  9.53, 14.27, 19.05, 12.70, 23.83, 29.36, 34.93, 39.67, 45.24,  0}},
    Walls{20,    {4.78, 5.54,  6.35,  9.53, 12.70,  9.53, 15.09, 20.62, 12.70, 26.19, 32.54, 38.10, 44.45, 50.01,  0}},
    Walls{24,    {5.54, 6.35,  6.35,  9.53, 14.27,  9.53, 17.48, 24.61, 12.70, 30.96, 38.89, 46.02, 52.37, 59.54,  0}},
};

// B16.9 reducing tees: NPS of run and branch, M in mm.
struct Outlet {
  double nps, branch_nps, mm;
};
constexpr std::array kOutlets{
    Outlet{2, 1, 51}, Outlet{2, 1.5, 60}, Outlet{3, 1.5, 73}, Outlet{3, 2, 76}, Outlet{4, 2, 89}, Outlet{4, 3, 98},
    Outlet{6, 3, 124}, Outlet{6, 4, 130}, Outlet{8, 4, 156}, Outlet{8, 6, 168}, Outlet{10, 6, 194}, Outlet{10, 8, 203},
    Outlet{12, 6, 219}, Outlet{12, 8, 229}, Outlet{12, 10, 241}, Outlet{14, 10, 257}, Outlet{16, 12, 295},
    Outlet{18, 14, 330}, Outlet{20, 16, 356}, Outlet{24, 12, 397}, Outlet{24, 20, 432},
};

constexpr std::array kFittings{
    //       NPS   LR90  SR90    45   tee  cap  red.
    fitting(  0.5,   38,    0,   16,   25,   25,    0),
    fitting( 0.75,   38,    0,   19,   29,   25,   38),
    fitting(    1,   38,   25,   22,   38,   38,   51),
    fitting( 1.25,   48,   32,   25,   48,   38,   51),
    fitting(  1.5,   57,   38,   29,   57,   38,   64),
    fitting(    2,   76,   51,   35,   64,   38,   76),
    fitting(  2.5,   95,   64,   44,   76,   38,   89),
    fitting(    3,  114,   76,   51,   86,   51,   89),
    fitting(  3.5,  133,   89,   57,   95,   64,  102),
    fitting(    4,  152,  102,   64,  105,   64,  102),
    fitting(    5,  190,  127,   79,  124,   76,  127),
    fitting(    6,  229,  152,   95,  143,   89,  140),
    fitting(    8,  305,  203,  127,  178,  102,  152),
    fitting(   10,  381,  254,  159,  216,  127,  178),
    fitting(   12,  457,  305,  190,  254,  152,  203),
    fitting(   14,  533,  356,  222,  279,  165,  330),
    fitting(   16,  610,  406,  254,  305,  178,  356),
    fitting(   18,  686,  457,  286,  343,  203,  381),
    fitting(   20,  762,  508,  318,  381,  229,  508),
    fitting(   24,  914,  610,  381,  432,  267,  508),
};

constexpr std::array kFlanges{
    //      class   NPS     OD thick.     RF circle  n  hole    hub   neck slip-on
    flange(150,   0.5,   88.9,  11.1,   34.9,   60.3,  4,  15.9,   30.2,   47.6,   15.9),
    flange(150,  0.75,   98.4,  12.7,   42.9,   69.8,  4,  15.9,   38.1,   52.4,   15.9),
    flange(150,     1,  107.9,  14.3,   50.8,   79.4,  4,  15.9,   49.2,   55.6,   17.5),
    flange(150,  1.25,  117.5,  15.9,   63.5,   88.9,  4,  15.9,   58.7,   57.1,   20.6),
    flange(150,   1.5,  127.0,  17.5,   73.0,   98.4,  4,  15.9,   65.1,   61.9,   22.2),
    flange(150,     2,  152.4,  19.0,   92.1,  120.6,  4,  19.0,   77.8,   63.5,   25.4),
    flange(150,   2.5,  177.8,  22.2,  104.8,  139.7,  4,  19.0,   90.5,   69.8,   28.6),
    flange(150,     3,  190.5,  23.8,  127.0,  152.4,  4,  19.0,  107.9,   69.8,   30.2),
    flange(150,   3.5,  215.9,  23.8,  139.7,  177.8,  8,  19.0,  122.2,   71.4,   31.8),
    flange(150,     4,  228.6,  23.8,  157.2,  190.5,  8,  19.0,  134.9,   76.2,   33.3),
    flange(150,     5,  254.0,  23.8,  185.7,  215.9,  8,  22.2,  163.5,   88.9,   36.5),
    flange(150,     6,  279.4,  25.4,  215.9,  241.3,  8,  22.2,  192.1,   88.9,   39.7),
    flange(150,     8,  342.9,  28.6,  269.9,  298.4,  8,  22.2,  246.1,  101.6,   44.4),
    flange(150,    10,  406.4,  30.2,  323.8,  361.9, 12,  25.4,  304.8,  101.6,   49.2),
    flange(150,    12,  482.6,  31.8,  381.0,  431.8, 12,  25.4,  365.1,  114.3,   55.6),
    flange(150,    14,  533.4,  34.9,  412.8,  476.2, 12,  28.6,  400.0,  127.0,   57.1),
    flange(150,    16,  596.9,  36.5,  469.9,  539.8, 16,  28.6,  457.2,  127.0,   63.5),
    flange(150,    18,  635.0,  39.7,  533.4,  577.9, 16,  31.8,  504.8,  139.7,   68.3),
    flange(150,    20,  698.5,  42.9,  584.2,  635.0, 20,  31.8,  558.8,  144.5,   73.0),
    flange(150,    24,  812.8,  47.6,  692.1,  749.3, 20,  34.9,  663.6,  152.4,   82.5),
    flange(300,   0.5,   95.2,  14.3,   34.9,   66.7,  4,  15.9,   38.1,   52.4,   22.2),
    flange(300,  0.75,  117.5,  15.9,   42.9,   82.5,  4,  19.0,   47.6,   57.1,   25.4),
    flange(300,     1,  123.8,  17.5,   50.8,   88.9,  4,  19.0,   54.0,   61.9,   27.0),
    flange(300,  1.25,  133.3,  19.0,   63.5,   98.4,  4,  19.0,   63.5,   65.1,   27.0),
    flange(300,   1.5,  155.6,  20.6,   73.0,  114.3,  4,  22.2,   69.8,   68.3,   30.2),
    flange(300,     2,  165.1,  22.2,   92.1,  127.0,  8,  19.0,   84.1,   69.8,   33.3),
    flange(300,   2.5,  190.5,  25.4,  104.8,  149.2,  8,  22.2,  100.0,   76.2,   38.1),
    flange(300,     3,  209.5,  28.6,  127.0,  168.3,  8,  22.2,  117.5,   79.4,   42.9),
    flange(300,   3.5,  228.6,  30.2,  139.7,  184.1,  8,  22.2,  133.3,   81.0,   44.4),
    flange(300,     4,  254.0,  31.8,  157.2,  200.0,  8,  22.2,  146.0,   85.7,   47.6),
    flange(300,     5,  279.4,  34.9,  185.7,  234.9,  8,  22.2,  177.8,   98.4,   50.8),
    flange(300,     6,  317.5,  36.5,  215.9,  269.9, 12,  22.2,  206.4,   98.4,   52.4),
    flange(300,     8,  381.0,  41.3,  269.9,  330.2, 12,  25.4,  260.3,  111.1,   61.9),
    flange(300,    10,  444.5,  47.6,  323.8,  387.3, 16,  28.6,  320.7,  117.5,   66.7),
    flange(300,    12,  520.7,  50.8,  381.0,  450.8, 16,  31.8,  374.6,  130.2,   73.0),
    flange(300,    14,  584.2,  54.0,  412.8,  514.4, 20,  31.8,  425.4,  142.9,   76.2),
    flange(300,    16,  647.7,  57.1,  469.9,  571.5, 20,  34.9,  482.6,  146.0,   82.5),
    flange(300,    18,  711.2,  60.3,  533.4,  628.6, 24,  34.9,  533.4,  158.8,   88.9),
    flange(300,    20,  774.7,  63.5,  584.2,  685.8, 24,  34.9,  587.4,  161.9,   95.2),
    flange(300,    24,  914.4,  69.8,  692.1,  812.8, 24,  41.3,  701.7,  168.3,  106.4),
};
// clang-format on

bool same_size(double a, double b) { return std::abs(a - b) < 1e-3; }

Error unknown(const std::string& what, double nps, const std::string& covers) {
  return {ErrorCode::kBadInput,
          what + " of NPS " + nps_text(nps) + " is not in the catalogue, which holds " + covers};
}

// "SCH 40", "sch-xs", "S40": the bare name in capitals.
std::string bare_schedule(std::string_view text) {
  std::string bare;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      bare += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  for (const std::string_view start : {"SCHEDULE", "SCHED", "SCH"}) {
    if (bare.size() > start.size() && bare.compare(0, start.size(), start) == 0)
      return bare.substr(start.size());
  }
  if (bare.size() > 1 && bare[0] == 'S' && std::isdigit(static_cast<unsigned char>(bare[1])) != 0)
    bare.erase(0, 1);
  return bare;
}

}  // namespace

std::span<const PipeSize> pipe_sizes() { return kPipes; }

Result<PipeSize> pipe_size(double nps) {
  for (const PipeSize& size : kPipes) {
    if (same_size(size.nps, nps)) return size;
  }
  return unknown("pipe", nps, "NPS 1/8 to 24 (ASME B36.10M)");
}

Result<double> wall_thickness(double nps, std::string_view schedule) {
  const auto* row = std::find_if(kWalls.begin(), kWalls.end(),
                                 [&](const Walls& each) { return same_size(each.nps, nps); });
  if (row == kWalls.end()) return unknown("pipe", nps, "NPS 1/8 to 24 (ASME B36.10M)");
  std::string wanted = bare_schedule(schedule);
  // B36.19M: 40S is STD and 80S is XS throughout.
  if (wanted == "40S") wanted = "STD";
  if (wanted == "80S") wanted = "XS";
  for (std::size_t i = 0; i < kSchedules.size(); ++i) {
    if (kSchedules[i] == wanted && row->mm[i] > 0) return row->mm[i] * kMm;
  }
  return unknown("schedule '" + std::string(schedule) + "'", nps,
                 "5S to 80S, 10 to 160, STD, XS and XXS where they are made (ASME B36.10M)");
}

Result<FittingSize> fitting_size(double nps) {
  for (const FittingSize& size : kFittings) {
    if (same_size(size.nps, nps)) return size;
  }
  return unknown("butt-weld fitting", nps, "NPS 1/2 to 24 (ASME B16.9)");
}

Result<double> tee_outlet(double nps, double branch_nps) {
  const Result<FittingSize> run = fitting_size(nps);
  if (!run) return run.error();
  if (same_size(nps, branch_nps)) return run->tee;
  for (const Outlet& outlet : kOutlets) {
    if (same_size(outlet.nps, nps) && same_size(outlet.branch_nps, branch_nps))
      return outlet.mm * kMm;
  }
  return unknown("tee with a branch of NPS " + nps_text(branch_nps), nps,
                 "straight tees and the common reducing ones (ASME B16.9)");
}

Result<FlangeSize> flange_size(double nps, int rating) {
  for (const FlangeSize& size : kFlanges) {
    if (size.rating == rating && same_size(size.nps, nps)) return size;
  }
  return unknown("flange of class " + std::to_string(rating), nps,
                 "class 150 and 300, NPS 1/2 to 24 (ASME B16.5)");
}

std::optional<double> nps_of_outside_diameter(double diameter, double tolerance) {
  const PipeSize* best = nullptr;
  for (const PipeSize& size : kPipes) {
    if (std::abs(size.outside_diameter - diameter) > tolerance) continue;
    if (best == nullptr ||
        std::abs(size.outside_diameter - diameter) < std::abs(best->outside_diameter - diameter))
      best = &size;
  }
  if (best == nullptr) return std::nullopt;
  return best->nps;
}

std::string nps_text(double nps) {
  if (!(nps >= 0 && nps < 1e6)) return "unknown";
  const auto whole = static_cast<long>(std::floor(nps + 1e-9));
  const auto eighths = std::lround((nps - static_cast<double>(whole)) * 8);
  if (std::abs(nps - static_cast<double>(whole) - static_cast<double>(eighths) / 8) > 1e-6) {
    std::string text = std::to_string(nps);
    text.erase(text.find_last_not_of('0') + 1);
    return text;
  }
  if (eighths == 0) return std::to_string(whole);
  long over = eighths;
  long under = 8;
  while (over % 2 == 0) {
    over /= 2;
    under /= 2;
  }
  const std::string fraction = std::to_string(over) + "/" + std::to_string(under);
  return whole == 0 ? fraction : std::to_string(whole) + "-" + fraction;
}

}  // namespace spool::piping
