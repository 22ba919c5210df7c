// Spools that nobody drew: a random walk of standard parts that does not run into itself.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/random_spool.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "tools/campaign/clearance.h"
#include "tools/campaign/random.h"
#include "tools/campaign/spool_router.h"
#include "tools/campaign/standard_sizes.h"

namespace spool::campaign {
namespace {

template <class T, std::size_t N>
T one_of(const std::array<T, N>& values, Random& random) {
  return values[static_cast<std::size_t>(random.below(N))];
}

// A smaller size that the tables have a reducing tee for, or the same.
double branch_size(double nps, Random& random) {
  if (random.chance(0.4)) return nps;
  if (nps == 8) return one_of(std::array{4.0, 6.0}, random);
  if (nps == 6) return one_of(std::array{3.0, 4.0}, random);
  if (nps == 4) return one_of(std::array{2.0, 3.0}, random);
  return nps == 3 ? 2.0 : nps;
}

double smaller(double nps) {
  if (nps == 8) return 6;
  if (nps == 6) return 4;
  return nps == 4 ? 3 : 2;
}

// Most spools turn in right angles; some are rolled.
double roll(Random& random) {
  if (random.chance(0.75)) return std::numbers::pi / 2 * random.below(4);
  return random.uniform(0, 2 * std::numbers::pi);
}

double pipe_length(double nps, Random& random) {
  const double diameter = sizes_of(nps).outside_diameter;
  return random.uniform(0.8 * diameter, 0.25 + 5 * diameter);
}

void walk(int parts, std::vector<int>& tees, Random& random, SpoolRouter& r) {
  for (int i = 0; i < parts; ++i) {
    r.pipe(pipe_length(r.nps(), random));
    const double next = random.uniform();
    if (next < 0.45) {
      r.elbow(random.chance(0.75) ? 90 : 45, roll(random));
    } else if (next < 0.75 && tees.size() < 4) {
      tees.push_back(r.tee(branch_size(r.nps(), random), roll(random)));
    } else if (next < 0.87 && r.nps() > 2) {
      r.reducer(smaller(r.nps()));
    } else {
      r.elbow(90, roll(random));
    }
  }
  r.pipe(pipe_length(r.nps(), random));
  if (random.chance(0.85))
    r.flange();
  else
    r.cap();
}

Assembly attempt(std::uint32_t seed, std::uint64_t number) {
  Random random(seed, 1000 + number);
  constexpr std::array kMainSizes = {2.0, 3.0, 4.0, 4.0, 6.0, 8.0};
  SpoolRouter r("random_spool_" + std::to_string(seed), one_of(kMainSizes, random));
  r.start_with_flange();
  std::vector<int> tees;
  walk(2 + random.below(4), tees, random, r);
  for (std::size_t i = 0; i < tees.size(); ++i) {
    r.branch(tees[i]);
    walk(random.below(3), tees, random, r);
  }
  return r.assembly();
}

bool is_spool(const Assembly& assembly) {
  const auto bends = [](const Member& m) {
    return m.spec.kind == PartKind::kElbow || m.spec.kind == PartKind::kTee;
  };
  const auto& members = assembly.members;
  const Eigen::Vector3d size = bounds_of(assembly).sizes();
  return members.size() >= 7 && members.size() <= 24 &&
         std::count_if(members.begin(), members.end(), bends) >= 2 && size.maxCoeff() >= 0.5 &&
         size.maxCoeff() <= 3.5 && !collides(assembly, 0.03);
}

}  // namespace

Assembly random_spool(std::uint32_t seed) {
  // Every other attempt or so is one.
  for (std::uint64_t number = 0;; ++number) {
    Assembly assembly = attempt(seed, number);
    if (is_spool(assembly)) return assembly;
  }
}

}  // namespace spool::campaign
