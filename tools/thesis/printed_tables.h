// The numbers of Sharif's tables 4-5 to 4-12 and 5-1 to 5-4, as printed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace spool::thesis {

// Tables 4-5 to 4-8. No RMS and no time: "Failed".
struct FindingRow {
  double ratio;  // density ratio, or clutter ratio
  std::size_t points;
  double rr;
  std::optional<double> rms_cm, seconds;
};
inline constexpr std::optional<double> kFailed;
inline constexpr std::array kTable4_5 = {
    // density, pipe spool
    FindingRow{0.3, 3000, 0, kFailed, kFailed}, FindingRow{1, 10000, 0, kFailed, kFailed},
    FindingRow{2, 20000, 0, kFailed, kFailed},  FindingRow{5, 50000, 0.956, 1.34, 27.5},
    FindingRow{8, 80000, 0.930, 1.28, 26.8},    FindingRow{10, 100000, 0.929, 1.31, 25.1},
    FindingRow{20, 200000, 0.924, 1.25, 19.2},
};
inline constexpr std::array kTable4_6 = {
    // density, box frame
    FindingRow{0.3, 3000, 0, kFailed, kFailed}, FindingRow{1, 10000, 0, kFailed, kFailed},
    FindingRow{2, 20000, 1, 2.92, 15.8},        FindingRow{5, 50000, 0.995, 2.86, 22.9},
    FindingRow{10, 100000, 0.979, 2.82, 22.9},  FindingRow{16, 160000, 0.983, 2.81, 22.9},
};
inline constexpr std::array kTable4_7 = {
    // clutter, pipe spool
    FindingRow{51.295, 322191, 0.764, 1.30, 20.9}, FindingRow{12.191, 81272, 0.929, 1.28, 13.2},
    FindingRow{7.466, 52156, 0.974, 1.28, 15.3},   FindingRow{1.473, 15236, 0.985, 1.28, 8.1},
    FindingRow{0.707, 10514, 0.984, 1.28, 0.8},
};
inline constexpr std::array kTable4_8 = {
    // clutter, box frame
    FindingRow{20.794, 322191, 0.764, 2.81, 17.4}, FindingRow{17.604, 279072, 0.929, 2.81, 15.8},
    FindingRow{9.579, 158692, 0.974, 2.81, 13.2},  FindingRow{5.087, 91302, 0.985, 2.83, 12.1},
    FindingRow{3.053, 60796, 0.984, 3.69, 10.9},
};

// Tables 4-9 and 4-10.
struct CompletenessRow {
  double ratio;
  std::size_t points;
  int success;
  std::optional<double> seconds;
};
inline constexpr std::array kTable4_9 = {  // pipe spool
    CompletenessRow{0.958, 74177, 1, 22.8}, CompletenessRow{0.923, 77842, 1, 22.9},
    CompletenessRow{0.913, 74979, 1, 23.1}, CompletenessRow{0.903, 73363, 0, kFailed}};
inline constexpr std::array kTable4_10 = {  // box frame
    CompletenessRow{0.993, 157631, 1, 20.2}, CompletenessRow{0.985, 156449, 1, 20.1},
    CompletenessRow{0.980, 157631, 1, 19.7}};
inline constexpr double kTable4_11 = 0.92, kTable4_12 = 0.91;  // ER, pipe spool and box frame

// Table 5-1, scene 1. The columns are named by their printed heads, which are wrong (THESIS.md,
// A1).
struct RatesRow {
  int k;
  std::size_t n_kept;  // "N"
  std::size_t m_less_q, n_less_q, q;
  double vr, nr;
};
inline constexpr std::size_t kTable5_1Model = 12061, kTable5_1Scene = 81272;
inline constexpr std::array kTable5_1 = {RatesRow{1, 3546, 33, 2648, 6161, 0.42, 0.005},
                                         RatesRow{7, 5447, 437, 1151, 6161, 0.18, 0.07},
                                         RatesRow{10, 5668, 481, 974, 6161, 0.158, 0.078},
                                         RatesRow{50, 6882, 776, 55, 6161, 0.009, 0.125},
                                         RatesRow{110, 7464, 1307, 4, 6161, 0.006, 0.2121},
                                         RatesRow{285, 7935, 1798, 24, 6161, 0.003, 0.29}};

// Table 5-2: "a b R1" of eq. 5.3, "a' b' R2" of eq. 5.4, the K said to be where they cross.
struct CurvesRow {
  double a, b, a_power, b_power, r1_squared, r2_squared;
  int k;
};
inline constexpr std::array kTable5_2 = {CurvesRow{0.0487, -0.0195, 0.832, -1.12, 0.92, 0.81, 11},
                                         CurvesRow{0.036, -0.035, 0.2478, -0.495, 0.87, 0.83, 17},
                                         CurvesRow{0.052, -0.0417, 0.0458, -0.273, 0.96, 0.46, 6},
                                         CurvesRow{0.196, -0.2294, 0.0965, -0.122, 0.66, 0.45, 7},
                                         CurvesRow{0.2938, -0.2586, -0.021, 0.13, 0.81, 0.47, 5},
                                         CurvesRow{0.1371, -0.1559, 0.4918, -0.68, 0.73, 0.80, 8},
                                         CurvesRow{0.0982, -0.0573, 1.0744, -0.65, 0.88, 0.66, 9}};

// Table 5-3, and the means and deviations in the text under it.
struct CoefficientRow {
  double value, low, high;
};
inline constexpr CoefficientRow kA0 = {9.14, 5.26, 13.02}, kA1 = {2.706, -1.52, 6.93},
                                kA2 = {2.05, -2.18, 6.27};
inline constexpr double kSceneMean = 9.3e4, kSceneDeviation = 3.67e4;
inline constexpr double kModelMean = 1.05e4, kModelDeviation = 1.533e3;

// Table 5-4.
struct PlaneRow {
  std::size_t scene, model;
  int k, predicted;
  double sse, sst, ssr;
};
inline constexpr std::array kTable5_4 = {PlaneRow{81272, 12061, 11, 10, 1, 3.45, 0.73},
                                         PlaneRow{145265, 12061, 14, 11, 49, 78.45, 3.45},
                                         PlaneRow{28009, 12061, 6, 9, 9, 9.87, 0.02},
                                         PlaneRow{108007, 8864, 7, 14, 49, 4.5, 23.59},
                                         PlaneRow{108007, 10841, 5, 12, 49, 17.16, 8.16},
                                         PlaneRow{108007, 9327, 8, 13, 25, 1.306, 14.87},
                                         PlaneRow{74569, 8864, 9, 15, 36, 0.02, 34.30}};
inline constexpr double kMeanK = 8.6, kSumSse = 218, kSumSst = 114.85, kRSquared = 0.75;

}  // namespace spool::thesis
