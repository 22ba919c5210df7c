// Parts of which nothing shows although what they are joined to does.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/missing_parts.h"

#include <algorithm>
#include <cmath>

#include "vision/core/median.h"
#include "vision/inspect/scan_gaps.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

constexpr double kNothing = 0.05;       // of the part's own surface
constexpr double kWell = 0.35;          // of what it is joined to
constexpr std::size_t kFewSamples = 8;  // of its own surface: then all of it is looked at
constexpr double kThere = 0.25;         // of what a camera looked at: no more of a missing part
// Of the points about a part's surface, so many lie within so many standard deviations of it.
constexpr double kMostAlong = 0.75, kAlong = 2.0;
constexpr float kRound = 3;  // times what a point vouches for: its surroundings

// What it is joined to shows well, and there is something.
bool is_seen_all_round(const DesignModel& design, int part,
                       const std::vector<PartDeviation>& parts) {
  bool has_neighbour = false;
  for (const Joint& joint : design.joints) {
    if (joint.part_a != part && joint.part_b != part) continue;
    const int other = joint.part_a == part ? joint.part_b : joint.part_a;
    has_neighbour = true;
    if (parts[static_cast<std::size_t>(other)].coverage < kWell) return false;
  }
  return has_neighbour;
}

// Of a part's own surface, what shows.
struct Shown {
  std::size_t own = 0, own_shown = 0, all = 0, all_shown = 0;

  [[nodiscard]] bool is_nothing() const {
    const bool is_enough = own >= kFewSamples;
    const auto shown = static_cast<double>(is_enough ? own_shown : all_shown);
    return shown <= kNothing * static_cast<double>(is_enough ? own : all);
  }
};

// The samples of a part, with whether nothing else of the design is within `apart_m` of each.
template <class Look>
void each_sample(const SurfaceSamples& samples, int part, const PointIndex& surface, float apart_m,
                 const Look& look) {
  std::vector<Neighbour> neighbours;
  for (std::size_t s = 0; s < samples.part.size(); ++s) {
    if (samples.part[s] != part) continue;
    surface.within(samples.cloud.points[s], apart_m, neighbours);
    look(s, std::none_of(neighbours.begin(), neighbours.end(),
                         [&](const Neighbour& n) { return samples.part[n.index] != part; }));
  }
}

// The standard deviation (m) of the object's points about the surface, whatever a few of them do.
double spread_m(const MeasuredScan& scan) {
  std::vector<float> sizes;
  for (std::size_t i = 0; i < scan.classes.size(); ++i)
    if (scan.classes[i] == PointClass::kObject)
      sizes.push_back(std::abs(scan.deviations.distance_m[i]));
  if (sizes.empty()) return 0;
  return 1.4826 * double{median(sizes)};
}

// The points about a part that are its own. Where a flange is missing, the stand that was to hold
// it still reaches its place: among clutter, and through the surface rather than along it.
std::vector<Eigen::Vector3f> own_points(const SurfaceSamples& samples, int part,
                                        const MeasuredScan& scan, float near_m, double spread_m) {
  Eigen::AlignedBox3f box;
  for (std::size_t s = 0; s < samples.part.size(); ++s)
    if (samples.part[s] == part) box.extend(samples.cloud.points[s]);
  const Eigen::Vector3f round = Eigen::Vector3f::Constant(kRound * near_m);
  const Eigen::AlignedBox3f wider(box.min() - round, box.max() + round);
  std::vector<Eigen::Vector3f> all, object;
  std::vector<std::uint8_t> is_object, is_along;
  for (std::size_t i = 0; i < scan.classes.size(); ++i) {
    if (!wider.contains(scan.points.points[i])) continue;  // nor is a NaN
    if (scan.classes[i] == PointClass::kContradicting) continue;
    all.push_back(scan.points.points[i]);
    is_object.push_back(scan.classes[i] == PointClass::kObject ? 1 : 0);
    is_along.push_back(double{std::abs(scan.deviations.distance_m[i])} < kAlong * spread_m ? 1 : 0);
    if (is_object.back() != 0) object.push_back(all.back());
  }
  const PointIndex index(all);
  std::vector<Neighbour> near;
  std::erase_if(object, [&](const Eigen::Vector3f& p) {
    index.within(p, kRound * near_m, near);
    std::size_t objects = 0, along = 0;
    for (const Neighbour& n : near) {
      objects += is_object[n.index];
      along += is_object[n.index] != 0 && is_along[n.index] != 0 ? 1U : 0U;
    }
    return 2 * objects < near.size() ||
           static_cast<double>(along) < kMostAlong * static_cast<double>(objects);
  });
  return object;
}

// Of each part, the object's points on it.
std::vector<std::vector<Eigen::Vector3f>> points_on_parts(const MeasuredScan& scan,
                                                          std::size_t parts) {
  std::vector<std::vector<Eigen::Vector3f>> on(parts);
  for (std::size_t i = 0; i < scan.classes.size(); ++i) {
    const std::int32_t part = scan.deviations.part[i];
    if (scan.classes[i] == PointClass::kObject && part >= 0)
      on[static_cast<std::size_t>(part)].push_back(scan.points.points[i]);
  }
  return on;
}

Shown what_shows(const SurfaceSamples& samples, int part, const PointIndex& surface,
                 const PointIndex& scan, float near_m) {
  Shown shown;
  each_sample(samples, part, surface, 2 * near_m, [&](std::size_t s, bool is_own) {
    const bool is_shown = scan.nearest(samples.cloud.points[s], near_m).has_value();
    ++shown.all;
    shown.all_shown += is_shown ? 1U : 0U;
    shown.own += is_own ? 1U : 0U;
    shown.own_shown += is_own && is_shown ? 1U : 0U;
  });
  return shown;
}

bool is_seen_through(const SurfaceSamples& samples, int part, const PointIndex& surface,
                     float near_m, const DesignInSight& in) {
  Sighted sighted;
  each_sample(samples, part, surface, 2 * near_m, [&](std::size_t s, bool is_own) {
    if (is_own)
      sighted.look(in.sight, in.T_camera_design * samples.cloud.points[s],
                   in.T_camera_design.linear() * samples.cloud.normals[s], in.gate_m);
  });
  return sighted.through >= kFewSamples && sighted.through >= sighted.others / 2 &&
         sighted.share_there() < kThere;
}

// Whether the scan leaves out some other part, or a length of it. A piece that is elsewhere is not
// left out.
bool has_gap_beside(int part, const std::vector<std::uint8_t>& has_gap,
                    std::span<const Piece> pieces) {
  for (std::size_t p = 0; p < has_gap.size(); ++p) {
    const auto is_it = [&](int each) { return each == static_cast<int>(p); };
    const bool is_elsewhere = std::any_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
      return std::any_of(piece.parts.begin(), piece.parts.end(), is_it);
    });
    if (has_gap[p] != 0 && !is_it(part) && !is_elsewhere) return true;
  }
  return false;
}

}  // namespace

std::vector<MissingPart> missing_parts(const DesignModel& design, const MeasuredScan& scan,
                                       const SurfaceSamples& samples,
                                       const std::vector<PartDeviation>& parts,
                                       const std::optional<DesignInSight>& in_sight,
                                       const Watch& watch) {
  std::vector<MissingPart> missing;
  std::vector<int> doubtful;
  const bool by_sight = in_sight && samples.cloud.has_normals();
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (parts[p].coverage < kWell &&
        (by_sight || is_seen_all_round(design, static_cast<int>(p), parts)))
      doubtful.push_back(static_cast<int>(p));
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < scan.classes.size() && !doubtful.empty(); ++i)
    if (scan.classes[i] == PointClass::kObject) points.push_back(scan.points.points[i]);
  if (points.empty()) return missing;
  const PointIndex object(points, watch);
  const PointIndex surface(samples.cloud.points, watch);
  if (watch.cancelled()) return missing;
  const auto near = static_cast<float>(vouching_radius(object, points, samples.radius_m));
  const double spread = spread_m(scan);
  const auto shows_nothing = [&](int part) {
    const std::vector<Eigen::Vector3f> own = own_points(samples, part, scan, near, spread);
    return what_shows(samples, part, surface, PointIndex(own), near).is_nothing();
  };
  const std::vector<std::uint8_t> has_gap =
      by_sight ? std::vector<std::uint8_t>{}
               : parts_with_gaps(samples, points_on_parts(scan, parts.size()), near, watch);
  for (const int part : doubtful) {
    if (watch.cancelled()) return {};
    if (by_sight ? is_seen_through(samples, part, surface, near, *in_sight)
                 : !has_gap_beside(part, has_gap, scan.pieces) && shows_nothing(part))
      missing.push_back({part, by_sight});
  }
  return missing;
}

}  // namespace spool
