// The thesis's figures of merit: what was found, how closely, and what was kept and lost.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/measures.h"

#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "vision/core/parallel.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

constexpr std::size_t kGrain = 2048;

double over(double numerator, double denominator) {
  return denominator == 0 ? std::numeric_limits<double>::quiet_NaN() : numerator / denominator;
}
double over(std::size_t numerator, std::size_t denominator) {
  return over(static_cast<double>(numerator), static_cast<double>(denominator));
}

struct Squares {
  double sum = 0;
  std::size_t count = 0;
  Squares& operator+=(const Squares& other) {
    sum += other.sum;
    count += other.count;
    return *this;
  }
};

RmsDistance root_mean(const Squares& squares) {
  if (squares.count == 0) return {};
  return {std::sqrt(squares.sum / static_cast<double>(squares.count)), squares.count};
}

}  // namespace

KeptCounts count_kept(std::span<const std::uint8_t> is_object,
                      std::span<const std::uint8_t> is_kept) {
  assert(is_object.size() == is_kept.size() && "a flag of each kind for every point");
  KeptCounts counts;
  for (std::size_t i = 0; i < is_object.size(); ++i) {
    counts.object += is_object[i] != 0 ? 1U : 0U;
    counts.kept += is_kept[i] != 0 ? 1U : 0U;
    counts.true_kept += is_object[i] != 0 && is_kept[i] != 0 ? 1U : 0U;
  }
  return counts;
}

double recognition_rate(const KeptCounts& c) { return over(c.true_kept, c.object); }  // (4.2)
double void_rate(const KeptCounts& c) { return over(c.object - c.true_kept, c.object); }
double noise_rate(const KeptCounts& c) { return over(c.kept - c.true_kept, c.object); }
double void_rate_as_printed(const KeptCounts& c) {
  return over(c.object - c.true_kept, c.kept);  // Equation (5.1)
}
double noise_rate_as_printed(const KeptCounts& c) {
  return over(c.kept - c.true_kept, c.kept);  // Equation (5.2)
}
double precision(const KeptCounts& c) { return over(c.true_kept, c.kept); }
double recall(const KeptCounts& c) { return over(c.true_kept, c.object); }
double f1(const KeptCounts& c) { return over(2 * c.true_kept, c.object + c.kept); }

double density_ratio(std::size_t scene_points, std::size_t model_points) {
  return over(scene_points, model_points);
}
double clutter_ratio(std::size_t scene_points, std::size_t object_points) {
  assert(object_points <= scene_points && "the object is part of the scene");
  return over(scene_points - object_points, object_points);  // Equation (4.3)
}
double completeness_ratio(std::size_t object_points, std::size_t whole_points) {
  return over(object_points, whole_points);
}

int success(const Pose& T_design_scan, const Pose& true_T_design_scan,
            const Eigen::AlignedBox3d& box, double limit_m) {
  const Pose off = T_design_scan * true_T_design_scan.inverse();
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    if (!((off * corner - corner).norm() <= limit_m)) return 0;
  }
  return 1;
}

double effectiveness_ratio(std::size_t with_given_parameters, std::size_t with_any) {
  return over(with_given_parameters, with_any);
}

RmsDistance rms_point_to_point(const CloudView& model, const CloudView& isolated,
                               const Watch& watch) {
  const PointIndex index(isolated.points);
  Eigen::AlignedBox3f box;
  for (const CloudView& cloud : {model, isolated})
    for (const Eigen::Vector3f& p : cloud.points)
      if (p.allFinite()) box.extend(p);
  const float farthest = box.isEmpty() ? 1.0F : 1.001F * box.diagonal().norm() + 1e-6F;
  return root_mean(
      parallel_sum(model.size(), kGrain, Squares{}, [&](std::size_t begin, std::size_t end) {
        Squares squares;
        for (std::size_t i = begin; i < end && !watch.cancelled(); ++i)
          if (const auto nearest = index.nearest(model.points[i], farthest)) {
            squares.sum += static_cast<double>(nearest->distance) * nearest->distance;
            ++squares.count;
          }
        return squares;
      }));
}

RmsDistance rms_point_to_surface(const CloudView& isolated, const DesignSurface& surface,
                                 const Pose& T_design_scan, double max_distance_m,
                                 const Watch& watch) {
  const Eigen::Isometry3f T = T_design_scan.cast<float>();
  return root_mean(
      parallel_sum(isolated.size(), kGrain, Squares{}, [&](std::size_t begin, std::size_t end) {
        Squares squares;
        for (std::size_t i = begin; i < end && !watch.cancelled(); ++i) {
          if (!isolated.points[i].allFinite()) continue;
          const auto nearest =
              surface.closest(T * isolated.points[i], static_cast<float>(max_distance_m));
          if (!nearest) continue;
          squares.sum += static_cast<double>(nearest->distance) * nearest->distance;
          ++squares.count;
        }
        return squares;
      }));
}

}  // namespace spool
