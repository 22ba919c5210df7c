// Pairs laid on pairs: the true pose is among the hypotheses, and chance is the seed's alone.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pose_search.h"

#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "tests/vision/find/room.h"
#include "vision/scan/thinning.h"

namespace spool {
namespace {

// A flanged tee seen from one side, alone, and what the search needs of both.
struct Task {
  FinderModel model = test::finder_of(test::design_of(test::tee_spool()), 4000);
  Pose T_true = Pose::Identity();
  std::vector<Eigen::Vector3f> scan;
  std::vector<Element> elements;
  Occupancy occupancy;

  Task() {
    std::mt19937 random{1};
    T_true = test::random_motion(2, 2, random);
    const PointCloud seen =
        test::scan_of(test::tee_spool(), T_true.inverse(),
                      {.points = 8000, .noise_m = 0.001, .towards = {0.3, 1, 0.4}}, random);
    scan = thin_to_voxels(CloudView(seen.points), model.cell_m()).points;
    elements = local_elements(scan, model.levels[0].elements);
    occupancy = Occupancy(scan, model.rough_m());
  }

  [[nodiscard]] std::vector<PoseHypothesis> search(const PoseSearchOptions& options,
                                                   const Watch& watch = {}) const {
    return search_poses(model.levels[0].pairs, elements, occupancy, model.probes, options, watch);
  }
};

const Task& task() {
  static const Task task;
  return task;
}

bool are_same(const std::vector<PoseHypothesis>& a, const std::vector<PoseHypothesis>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const PoseHypothesis& x, const PoseHypothesis& y) {
                      return x.score == y.score && x.chunk == y.chunk &&
                             x.T_design_scan.matrix() == y.T_design_scan.matrix();
                    });
}

TEST(PoseSearch, MeetsTheTruePose) {
  const auto found = task().search({.pairs = 192});
  ASSERT_FALSE(found.empty());
  for (std::size_t i = 0; i + 1 < found.size(); ++i)
    EXPECT_GE(found[i].score, found[i + 1].score) << "best first";
  double nearest = 1;
  for (std::size_t i = 0; i < std::min<std::size_t>(8, found.size()); ++i)
    nearest = std::min(
        nearest, displacement_m(task().model, found[i].T_design_scan, task().T_true.cast<float>()));
  // What a refinement gets home from: half as much again as a pair's pose is said to be off by.
  EXPECT_LT(nearest, 1.5 * task().model.rough_m());
}

TEST(PoseSearch, ScoresAreTheSharesOfSamplesWithAPointNear) {
  for (const PoseHypothesis& hypothesis : task().search({.pairs = 64})) {
    EXPECT_FLOAT_EQ(hypothesis.score,
                    pose_score(hypothesis.T_design_scan, task().occupancy, task().model.probes));
    EXPECT_GE(hypothesis.score, 0.2F);
    EXPECT_LT(hypothesis.chunk, 2U);
  }
}

TEST(PoseSearch, GivesTheSameOnAnyNumberOfThreadsAndAnotherForAnotherSeed) {
  const auto alone = task().search({.pairs = 128, .seed = 7});
  // Four at once share the cores, so that each gets as many as are left.
  std::vector<std::vector<PoseHypothesis>> together(4);
  std::vector<std::thread> threads;
  for (auto& found : together)
    threads.emplace_back([&found] { found = task().search({.pairs = 128, .seed = 7}); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& found : together) EXPECT_TRUE(are_same(found, alone));
  EXPECT_FALSE(are_same(task().search({.pairs = 128, .seed = 8}), alone));
}

TEST(PoseSearch, FindsNothingInNothing) {
  const Task& t = task();
  const PairTable& pairs = t.model.levels[0].pairs;
  EXPECT_TRUE(search_poses(PairTable(), t.elements, t.occupancy, t.model.probes, {}).empty());
  EXPECT_TRUE(search_poses(pairs, {}, t.occupancy, t.model.probes, {}).empty());
  EXPECT_TRUE(search_poses(pairs, {t.elements.data(), 1}, t.occupancy, t.model.probes, {}).empty());
  EXPECT_TRUE(search_poses(pairs, t.elements, t.occupancy, {}, {}).empty());
  EXPECT_TRUE(search_poses(pairs, t.elements, Occupancy(), t.model.probes, {}).empty());
  EXPECT_TRUE(t.search({.pairs = 0}).empty());
  // A scan whose elements are too near each other for any pair of the design.
  const std::vector<Element> heap(20, t.elements[0]);
  EXPECT_TRUE(search_poses(pairs, heap, t.occupancy, t.model.probes, {}).empty());
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(t.search({}, {stop.get_token(), {}}).empty());
}

}  // namespace
}  // namespace spool
