// Sizes of pipe, butt-weld fittings and class 150 flanges, NPS 2 to 8, typed from the standards.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/standard_sizes.h"

#include <array>
#include <cassert>

namespace spool::campaign {
namespace {

constexpr StandardSizes row(double nps, double od, double wall, double a, double b, double c,
                            double e, double h, double flange, double thickness, double face,
                            double circle, int holes, double hole, double hub, double neck) {
  constexpr double mm = 0.001;
  return {nps,    od * mm,   wall * mm,   a * mm,         b * mm,    c * mm,
          e * mm, h * mm,    flange * mm, thickness * mm, face * mm, circle * mm,
          holes,  hole * mm, hub * mm,    neck * mm};
}

// clang-format off
constexpr std::array kSizes = {
    //  NPS     OD   wall  LR90   45  tee  cap  red. | flange thick.    RF  circle n  hole    hub  neck
    row(2.0,  60.3,  3.91,   76,  35,  64,  38,  76,   152.4,  19.0,  92.1, 120.6, 4, 19.0,  77.8,  63.5),
    row(2.5,  73.0,  5.16,   95,  44,  76,  38,  89,   177.8,  22.2, 104.8, 139.7, 4, 19.0,  90.5,  69.8),
    row(3.0,  88.9,  5.49,  114,  51,  86,  51,  89,   190.5,  23.8, 127.0, 152.4, 4, 19.0, 107.9,  69.8),
    row(4.0, 114.3,  6.02,  152,  64, 105,  64, 102,   228.6,  23.8, 157.2, 190.5, 8, 19.0, 134.9,  76.2),
    row(5.0, 141.3,  6.55,  190,  79, 124,  76, 127,   254.0,  23.8, 185.7, 215.9, 8, 22.2, 163.5,  88.9),
    row(6.0, 168.3,  7.11,  229,  95, 143,  89, 140,   279.4,  25.4, 215.9, 241.3, 8, 22.2, 192.1,  88.9),
    row(8.0, 219.1,  8.18,  305, 127, 178, 102, 152,   342.9,  28.6, 269.9, 298.4, 8, 22.2, 246.1, 101.6),
};

struct Outlet { double nps, nps2, length; };
constexpr std::array kReducingOutlets = {
    Outlet{3, 2, 0.076}, Outlet{4, 2, 0.089}, Outlet{4, 3, 0.098}, Outlet{6, 3, 0.124},
    Outlet{6, 4, 0.130}, Outlet{8, 4, 0.156}, Outlet{8, 6, 0.168},
};
// clang-format on

}  // namespace

std::span<const StandardSizes> standard_sizes() { return kSizes; }

const StandardSizes& sizes_of(double nps) {
  for (const StandardSizes& sizes : kSizes)
    if (sizes.nps == nps) return sizes;
  assert(false && "a size of the table");
  return kSizes.front();
}

double tee_outlet(double nps, double nps2) {
  if (nps == nps2) return sizes_of(nps).tee;
  for (const Outlet& outlet : kReducingOutlets)
    if (outlet.nps == nps && outlet.nps2 == nps2) return outlet.length;
  assert(false && "a reducing tee of the table");
  return sizes_of(nps).tee;
}

}  // namespace spool::campaign
