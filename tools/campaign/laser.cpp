// A laser scanner's stations, merged and thinned to one spacing.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/laser.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "tools/campaign/labels.h"
#include "tools/campaign/point_spacing.h"
#include "vision/core/parallel.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kGrain = 2048;
constexpr std::size_t kBatch = 32 * kGrain;
constexpr double kGrazing = 0.17;  // cosine of 80 degrees: what is flatter to the ray is lost
constexpr double kNoCrop = std::numeric_limits<double>::infinity();
constexpr double kBeyond = 0.05;  // m past the crop that noise may carry a point

// The patches of the object or of the clutter, drawn from by their areas.
class Surfaces {
 public:
  // Of the clutter only what lies within `crop` (m) of the object's box.
  Surfaces(const RayWorld& world, bool of_object, const Eigen::AlignedBox3d& object = {},
           double crop = kNoCrop)
      : of_object_(of_object) {
    for (std::uint32_t i = 0; i < world.placed().size(); ++i) {
      if ((world.placed()[i].instance != kNoInstance) != of_object) continue;
      if (crop < kNoCrop && object.exteriorDistance(world.box(i)) > crop) continue;
      area_ += sampled_area(world.placed()[i].patch);
      patches_.push_back(i);
      up_to_.push_back(area_);
    }
  }
  [[nodiscard]] double area() const { return area_; }
  [[nodiscard]] bool of_object() const { return of_object_; }
  // The patch at `share` (0 to 1) of the area.
  [[nodiscard]] std::uint32_t at(double share) const {
    const auto found = std::upper_bound(up_to_.begin(), up_to_.end(), share * area_);
    const auto index = static_cast<std::size_t>(found - up_to_.begin());
    return patches_[std::min(index, patches_.size() - 1)];
  }

 private:
  bool of_object_;
  double area_ = 0;
  std::vector<std::uint32_t> patches_;
  std::vector<double> up_to_;
};

// A point of the true surface.
struct Candidate {
  Vector3d point;
  Vector3d normal;
  std::uint32_t placed = 0;
};

// Candidate `i` of `count`: they go through the patches in order, each in its share, so that what
// is near in space is looked at together.
std::optional<Candidate> draw(const RayWorld& world, const Surfaces& surfaces, std::size_t i,
                              std::size_t count, Random& random) {
  const double place = static_cast<double>(i) + random.uniform();
  const std::uint32_t index = surfaces.at(place / static_cast<double>(count));
  const Patch& patch = world.placed()[index].patch;
  const auto local = sample(patch, random);
  if (!local) return std::nullopt;
  const Rigid& T_scan_patch = world.T_scan_patch(index);
  return Candidate{T_scan_patch(*local), T_scan_patch.turn * normal_at(patch, *local), index};
}

// A station at random of those that see the point; nothing where none does.
std::optional<std::size_t> seen_from(const RayWorld& world, const std::vector<Vector3d>& stations,
                                     const Candidate& candidate, Random& random) {
  const std::size_t first = static_cast<std::size_t>(random.bits() % stations.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const std::size_t station = (first + i) % stations.size();
    const Vector3d ray = stations[station] - candidate.point;
    if (ray.dot(candidate.normal) < kGrazing * ray.norm()) continue;
    if (!world.blocked(stations[station], candidate.point)) return station;
  }
  return std::nullopt;
}

// What can be seen: its area, and of each seen sample how far it lies from the object's box.
struct Survey {
  double area = 0;
  std::vector<double> distances = {};  // m, sorted
};

Survey survey(const RayWorld& world, const Surfaces& surfaces,
              const std::vector<Vector3d>& stations, const Eigen::AlignedBox3d& object,
              std::uint32_t seed) {
  constexpr std::size_t kSamples = 40'000;
  std::vector<double> distance(kSamples, -1);
  parallel_chunks(kSamples, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Random random(seed, i);
      const auto candidate = draw(world, surfaces, i, kSamples, random);
      if (candidate && seen_from(world, stations, *candidate, random))
        distance[i] = object.exteriorDistance(candidate->point);
    }
  });
  Survey result;
  for (const double each : distance)
    if (each >= 0) result.distances.push_back(each);
  std::sort(result.distances.begin(), result.distances.end());
  result.area = surfaces.area() * static_cast<double>(result.distances.size()) / kSamples;
  return result;
}

struct Scanner {
  const RayWorld& world;
  const LaserSettings& settings;
  const Eigen::AlignedBox3d& object;
  std::uint32_t seed;
  std::vector<Pose> T_scan_station = {};  // what registration makes of a station's points

  // The measured point of one candidate, or nothing.
  std::optional<SensedPoint> measure(const Surfaces& surfaces, std::size_t i, double crop,
                                     const PointSpacing& spacing, Random& random) const {
    const auto candidate = draw(world, surfaces, i, kBatch, random);
    if (!candidate || beyond(candidate->point, crop)) return std::nullopt;
    // Cheap first: what has no room before its noise is known will hardly have room after.
    const double noise = settings.noise_m * random.normal();
    if (!spacing.has_room(candidate->point.cast<float>())) return std::nullopt;
    const auto station = seen_from(world, settings.stations, *candidate, random);
    if (!station) return std::nullopt;
    const Vector3d& eye = settings.stations[*station];
    const Vector3d ray = (candidate->point - eye).normalized();
    double range = (candidate->point - eye).norm();
    const Placed& placed = world.placed()[candidate->placed];
    SensedPoint sensed{{}, placed.label, placed.instance, static_cast<std::uint8_t>(*station)};
    if (const auto behind = edge(eye, ray, range, random)) {
      range += random.uniform(0.1, 0.9) * (*behind - range);
      sensed.label = kMixedPixel;
      sensed.instance = kNoInstance;
    }
    const Vector3d point = T_scan_station[*station] * (eye + (range + noise) * ray);
    if (beyond(point, crop + kBeyond)) return std::nullopt;
    sensed.point = point.cast<float>();
    return spacing.has_room(sensed.point) ? std::optional(sensed) : std::nullopt;
  }

  [[nodiscard]] bool beyond(const Vector3d& point, double crop) const {
    return crop < kNoCrop && object.exteriorDistance(point) > crop;
  }

  // The range of what a part of the beam hits instead, where that is well nearer or further.
  std::optional<double> edge(const Vector3d& eye, const Vector3d& ray, double range,
                             Random& random) const {
    const double radius = settings.beam_radius_m + settings.beam_spread_rad * range;
    const Vector3d across = ray.cross(random.direction()).normalized();
    const Vector3d beside =
        (ray + std::sqrt(random.uniform()) * radius / range * across).normalized();
    const bool mixes = random.chance(0.5);
    constexpr double kStep = 0.03;  // m: what is nearer the scanner keeps apart
    constexpr double kFarthest = 40;
    const auto hit = world.cast(eye, beside, kFarthest);
    if (!mixes || !hit || std::abs(hit->distance - range) < kStep) return std::nullopt;
    return hit->distance;
  }

  // Adds points of the surfaces within `crop` of the object until there are `target` of the object
  // or of clutter, whichever the surfaces are, with those that are there already. False: no room.
  bool collect(const Surfaces& surfaces, double crop, double area, std::size_t target,
               std::uint64_t stream, std::vector<SensedPoint>& points, PointSpacing& spacing) const;
};

bool Scanner::collect(const Surfaces& surfaces, double crop, double area, std::size_t target,
                      std::uint64_t stream, std::vector<SensedPoint>& points,
                      PointSpacing& spacing) const {
  const auto counts = [&](const SensedPoint& each) {
    return (each.instance != kNoInstance) == surfaces.of_object();
  };
  auto have = static_cast<std::size_t>(std::count_if(points.begin(), points.end(), counts));
  // A surface all but full takes many tries a point; more than this and it is fuller than reckoned.
  const double hidden = surfaces.area() / area;
  const auto most = static_cast<std::size_t>(20 * hidden * static_cast<double>(target)) + 100'000;
  std::vector<std::optional<SensedPoint>> batch(kBatch);
  for (std::size_t tried = 0; have < target && tried < most; tried += kBatch) {
    parallel_chunks(kBatch, kGrain, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        Random random(seed, (stream << 40) + tried + i);
        batch[i] = measure(surfaces, i, crop, spacing, random);
      }
    });
    // Not in the order of the patches: the target may be reached before the last of them.
    constexpr std::size_t kStride = 40'503;  // odd, and so a permutation of a power of two
    static_assert((kBatch & (kBatch - 1)) == 0);
    for (std::size_t i = 0; i < kBatch; ++i) {
      const auto& sensed = batch[i * kStride % kBatch];
      if (have >= target) break;
      if (!sensed || !spacing.has_room(sensed->point)) continue;
      spacing.add(sensed->point);
      points.push_back(*sensed);
      if (counts(*sensed)) ++have;
    }
  }
  return have >= target;
}

// Adds points until there are `target`, from the reckoned spacing to ever closer ones: noise and
// hidden corners leave some short.
void fill(const Scanner& scanner, const Surfaces& surfaces, double crop, double area,
          std::size_t target, std::vector<SensedPoint>& points) {
  if (!(area > 0)) return;  // nothing of it is seen
  const double spacing_m = spacing_for(static_cast<double>(target) / area);
  const std::uint64_t stream = surfaces.of_object() ? 1 : 100;
  for (int round = 0; round < 12; ++round) {
    PointSpacing spacing(std::pow(0.9, round) * spacing_m, points.size() + target);
    for (const SensedPoint& each : points) spacing.add(each.point);
    if (scanner.collect(surfaces, crop, area, target, stream + static_cast<std::uint64_t>(round),
                        points, spacing))
      return;
  }
}

}  // namespace

double seen_object_area(const RayWorld& world, const std::vector<Vector3d>& stations,
                        std::uint32_t seed) {
  return survey(world, Surfaces(world, true), stations, {}, seed).area;
}

std::vector<SensedPoint> scan_with_laser(const RayWorld& world, const LaserSettings& settings,
                                         const PointTargets& targets,
                                         const Eigen::AlignedBox3d& object, std::uint32_t seed) {
  Scanner scanner{world, settings, object, seed};
  for (std::size_t i = 0; i < settings.stations.size(); ++i) {
    Random random(seed, 500 + i);
    const Vector3d turn = settings.station_error_m / 5.0 * random.normals();
    Pose pose(Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()));
    pose.pretranslate(settings.station_error_m * random.normals());
    scanner.T_scan_station.push_back(pose);
  }
  std::vector<SensedPoint> points;
  double density = targets.density;
  if (targets.object > 0) {
    const Surfaces surfaces(world, true);
    const double area = survey(world, surfaces, settings.stations, object, seed + 1).area;
    density = static_cast<double>(targets.object) / area;
    fill(scanner, surfaces, kNoCrop, area, targets.object, points);
  }
  if (targets.clutter > 0) {
    const Surfaces surfaces(world, false);
    const Survey seen = survey(world, surfaces, settings.stations, object, seed + 2);
    // At the object's spacing the points need this share of what is seen: the nearest of it.
    const auto wanted = static_cast<double>(targets.clutter);
    const double share = density > 0 ? std::min(1.0, wanted / (seen.area * density)) : 1;
    const auto index = static_cast<std::size_t>(share * static_cast<double>(seen.distances.size()));
    const double crop = index < seen.distances.size() ? seen.distances[index] : kNoCrop;
    // What was seen between object and background belongs to what is cropped.
    std::erase_if(points, [&](const SensedPoint& each) {
      return each.label == kMixedPixel && scanner.beyond(each.point.cast<double>(), crop);
    });
    fill(scanner, Surfaces(world, false, object, crop), crop, share * seen.area, targets.clutter,
         points);
  }
  return points;
}

}  // namespace spool::campaign
