// Scans in which nothing can be found, searches that are stopped, and the same answer every time.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <limits>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/cancelling.h"
#include "tests/vision/find/room.h"
#include "vision/find/finder.h"

namespace spool {
namespace {

using Clock = std::chrono::steady_clock;
using Eigen::Vector3f;

const FinderModel& tee() {
  static const FinderModel model = test::finder_of(test::design_of(test::tee_spool()), 4000);
  return model;
}

std::vector<Vector3f> noise(std::size_t count, float wide) {
  std::mt19937 random{1};
  std::uniform_real_distribution<float> unit(0, wide);
  std::vector<Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = unit(random), y = unit(random), z = unit(random);
    points.emplace_back(x, y, z);
  }
  return points;
}

TEST(Finder, RefusesAScanThatHoldsNothing) {
  std::mt19937 random{2};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float largest = std::numeric_limits<float>::max();
  std::vector<Vector3f> plane, far = noise(2000, 1);
  test::add_rectangle(plane, {0, 0, 0}, {3, 0, 0}, {0, 3, 1}, 5000, 0.002, random);
  for (const float sign : {-1.0F, 1.0F}) far.emplace_back(sign * largest, sign * largest, 0.0F);
  struct Case {
    const char* name;
    std::vector<Vector3f> scan;
    const char* reason;
  };
  for (const Case& each :
       {Case{"empty", {}, "too few points"}, Case{"a hundred points", noise(100, 1), "not found"},
        Case{"a hundred in one place", std::vector<Vector3f>(100, Vector3f::Ones()),
             "too few points"},
        Case{"unmeasured", std::vector<Vector3f>(1000, Vector3f(nan, nan, nan)), "too few points"},
        Case{"half measured", std::vector<Vector3f>(1000, Vector3f(0, nan, 1)), "too few points"},
        Case{"a floor", plane, ""}, Case{"noise", noise(20000, 1.5F), "not found"},
        Case{"the ends of the world", far, "not found"}}) {
    const FindResult found = find_design(tee(), each.scan, {.noise_m = 0.002});
    EXPECT_FALSE(found.found) << each.name;
    EXPECT_TRUE(found.others.empty()) << each.name;
    EXPECT_NE(found.reason.find(each.reason), std::string::npos)
        << each.name << ": " << found.reason;
    EXPECT_FALSE(found.reason.empty()) << each.name;
  }
}

TEST(Finder, SaysThatADesignWithoutNormalsCannotBeFound) {
  const FindResult found = find_design(FinderModel(), noise(1000, 1), {});
  EXPECT_FALSE(found.found);
  EXPECT_NE(found.reason.find("design has no surface"), std::string::npos) << found.reason;
}

// How long (s) the search goes on when it is stopped some way in: the least of a few tries, since
// other programs may hold the cores.
double delay_s(const std::vector<Vector3f>& scan, int after_ms) {
  double least = 1e9;
  for (int i = 0; i < 5 && least > 0.1; ++i) {
    std::stop_source stop;
    Clock::time_point asked;
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(after_ms));
      asked = Clock::now();
      stop.request_stop();
    });
    const FindResult found = find_design(tee(), scan, {}, {stop.get_token(), {}});
    const Clock::time_point ended = Clock::now();
    other.join();
    EXPECT_FALSE(found.found);
    EXPECT_NE(found.reason.find("stopped"), std::string::npos) << found.reason;
    least = std::min(least, std::chrono::duration<double>(ended - asked).count());
  }
  return least;
}

TEST(Finder, StopsWithinATenthOfASecond) {
  std::mt19937 random{4};
  const test::Room room = test::make_room(test::tee_spool(), {.copies = 0}, random);
  static_cast<void>(tee());
  for (const int after_ms : {0, 30, 100, 250})
    EXPECT_LT(delay_s(room.points, after_ms), test::kObeyed_s) << after_ms;
}

// What is prepared of a design takes longer than most searches.
TEST(Finder, StopsPreparingADesignWithinATenthOfASecond) {
  const DesignModel design = test::design_of(test::tee_spool());
  const Result<DesignSurface> surface = DesignSurface::build(design);
  ASSERT_TRUE(surface);
  const SurfaceSamples samples = sample_surface(design, 12000);
  std::vector<double> shares;
  const auto prepare = [&](const Watch& watch) {
    return FinderModel::prepare(design, *surface, samples, 1, watch);
  };
  const double whole_s = test::seconds_of([&] {
    EXPECT_FALSE(prepare({{}, [&](std::string_view, double share) { shares.push_back(share); }})
                     .alike.empty());
  });
  EXPECT_GE(shares.size(), 5U) << "what is done is said";
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()) && shares.back() < 1);
  int stopped = 0;
  for (double share = 0; share < 1; share += 0.1) {
    const auto obeyed_s = test::seconds_until_obeyed(
        share * whole_s, [&](const Watch& watch) { static_cast<void>(prepare(watch)); });
    if (!obeyed_s) continue;  // it was done before
    ++stopped;
    EXPECT_LT(*obeyed_s, test::kObeyed_s) << share;
  }
  EXPECT_GE(stopped, 5);
}

TEST(Finder, GivesTheSameAnswerEveryTimeOnAnyNumberOfThreads) {
  std::mt19937 random{5};
  const test::Room room = test::make_room(test::tee_spool(), {}, random);
  const FindResult alone = find_design(tee(), room.points, {.noise_m = 0.002});
  // Three at once share the cores, so that each gets as many as are left.
  std::vector<FindResult> together(3);
  std::vector<std::thread> threads;
  for (FindResult& found : together)
    threads.emplace_back([&] { found = find_design(tee(), room.points, {.noise_m = 0.002}); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(alone.found) << alone.reason;
  for (const FindResult& found : together) {
    EXPECT_EQ(found.found, alone.found);
    EXPECT_EQ(found.rounds, alone.rounds);
    ASSERT_EQ(found.tried.size(), alone.tried.size());
    for (std::size_t i = 0; i < alone.tried.size(); ++i) {
      EXPECT_EQ(found.tried[i].T_design_scan.matrix(), alone.tried[i].T_design_scan.matrix());
      EXPECT_EQ(found.tried[i].points, alone.tried[i].points);
      EXPECT_EQ(found.tried[i].hits, alone.tried[i].hits);
    }
  }
}

}  // namespace
}  // namespace spool
