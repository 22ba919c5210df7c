// How a flange is turned about its axis by one scan: the lack of points where its bolt holes are.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/bolt_holes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "vision/inspect/bolt_phase.h"
#include "vision/inspect/bolt_ring.h"
#include "vision/inspect/hole_harmonic.h"
#include "vision/measure/feature_geometry.h"
#include "vision/measure/part_shapes.h"

namespace spool {
namespace {

using Eigen::Vector3d;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kBinsOfPitch = 16;
constexpr int kOvertones = 6;  // a hole takes a sixth of its pitch at least: more are hardly there
constexpr double kStandsOut = 5;
// The steel beside the ring that it is compared with, in half widths of the ring from the bolt
// circle; between the two a hole's edge may reach over the ring.
constexpr double kFlankFrom = 1.25, kFlankTo = 2.5;
constexpr double kRim_m = 0.003;        // where the face ends readings are lost or drawn aside
constexpr double kLeastGate_m = 0.002;  // a sensor's depth step may be as much
constexpr double kGate = 3;             // standard deviations of a point
constexpr double kFewest = 60;          // points, as of one frame's ring

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// The flange's own frame, moved with its face: z along the part's z, its origin where the axis of
// the pipe meets the face.
struct FaceFrame {
  Pose T_design_nominal = Pose::Identity(), T_design_measured = Pose::Identity();
  Eigen::Matrix2d centre_covariance = Eigen::Matrix2d::Zero();  // m^2, along its x and y
  double side = 1;                                              // along z, the face looks so
};

std::optional<FaceFrame> face_frame(const DesignModel& design, const Drawing& drawing,
                                    const PartFeatures& features, int part, std::string& why) {
  const int face = features.of(part);
  if (face < 0) {
    why = "its face is not known: " + features.why_not[at(part)];
    return std::nullopt;
  }
  const auto node = std::ranges::find_if(drawing.nodes, [&](const DrawingNode& each) {
    return each.part == part && each.kind == NodeKind::kFace && !each.legs.empty();
  });
  if (node == drawing.nodes.end()) {
    why = "no pipe on it says where its middle is";
    return std::nullopt;
  }
  const FeatureGeometry geometry(design, drawing, features);
  const FeaturePoint centre =
      geometry.point(static_cast<int>(node - drawing.nodes.begin()), node->legs.front());
  if (!centre.at) {
    why = centre.why_not;
    return std::nullopt;
  }
  const Propagated known =
      propagate([&](const FeatureState& state) -> Eigen::VectorXd { return centre.at(state); },
                features, geometry.measured());
  if (!known.is_determined) {
    why = "where its middle is moves with what no feature holds";
    return std::nullopt;
  }
  FaceFrame frame;
  const PartFeature& plane = features.features[at(face)];
  const Pose& T_design_part = design.parts[at(part)].T_design_part;
  frame.T_design_nominal.linear() = T_design_part.linear();
  frame.T_design_nominal.translation() = node->point;
  const Vector3d nominal = plane.T_design_nominal.linear().col(2);
  const Vector3d measured = plane.T_design_measured.linear().col(2);
  frame.side = nominal.dot(T_design_part.linear().col(2)) < 0 ? -1 : 1;
  // The least turn from one normal to the other turns nothing about them.
  frame.T_design_measured.linear() = Eigen::Quaterniond::FromTwoVectors(nominal, measured) *
                                     Eigen::Matrix3d(T_design_part.linear());
  frame.T_design_measured.translation() = known.value;
  const Eigen::Matrix<double, 3, 2> across = frame.T_design_measured.linear().leftCols<2>();
  frame.centre_covariance = across.transpose() * (known.fit + known.warp) * across;
  return frame;
}

// The counts round one face.
struct RingCount {
  std::vector<RingBin> bins;  // through: on the steel beside the ring
  double flank_area_m2 = 0;   // of the whole steel beside it
};

// Standard deviation (m) of heights about the plane that most lie on, by their median deviation.
double scatter_of(std::vector<double> heights) {
  if (heights.empty()) return 0;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  const double median = *middle;
  for (double& each : heights) each = std::abs(each - median);
  std::nth_element(heights.begin(), middle, heights.end());
  return 1.4826 * *middle;
}

RingCount count_round(const BoltRing& ring, const FaceShape& shape, double ring_height_m,
                      const FaceFrame& frame, const FeatureScan& scan, const Watch& watch) {
  const double radius = 0.5 * ring.holes().bolt_circle_m, half = ring.half_width_m();
  const double inner = radius - kFlankTo * half;
  const double outer = std::min(radius + kFlankTo * half, shape.flange_radius_m - kRim_m);
  struct InRing {
    double off_m, angle, height_m;
  };
  std::vector<InRing> points;
  std::vector<double> heights;
  const Pose T_face_design = frame.T_design_measured.inverse();
  watched_loop(scan.scan_design.size(), watch, [&](std::size_t i) {
    const Vector3d p = T_face_design * scan.scan_design.points[i].cast<double>();
    const double r = p.head<2>().norm(), height = frame.side * p.z();
    if (!(std::abs(height) < scan.bound_m && r > inner && r < outer)) return;  // NaN is nowhere
    points.push_back({std::abs(r - radius), std::atan2(p.y(), p.x()), height});
    if (points.back().off_m < half) heights.push_back(height - ring_height_m);
  });
  const double gate = std::max(kLeastGate_m, kGate * scatter_of(std::move(heights)));
  const double top = std::max(ring_height_m, shape.levels.back());
  RingCount count;
  count.bins.resize(at(kBinsOfPitch * ring.holes().count));
  const auto bins = static_cast<double>(count.bins.size());
  for (const InRing& p : points) {
    const bool is_ring = p.off_m < half;
    if (!is_ring && p.off_m < kFlankFrom * half) continue;
    if (p.height_m < ring_height_m - gate || p.height_m > (is_ring ? ring_height_m : top) + gate)
      continue;
    const double turns = p.angle / kTurn + (p.angle < 0 ? 1 : 0);
    RingBin& bin = count.bins[static_cast<std::size_t>(std::min(bins - 1, turns * bins))];
    bin.seen += 1;
    bin.through += is_ring ? 0.0F : 1.0F;
  }
  const double outside = std::max(0.0, outer * outer - std::pow(radius + kFlankFrom * half, 2));
  const double inside = std::pow(radius - kFlankFrom * half, 2) - inner * inner;
  count.flank_area_m2 = std::numbers::pi * (inside + outside);
  return count;
}

std::string millimetres(double metres) {
  return std::to_string(std::max(1L, std::lround(1000 * metres))) + " mm";
}

struct HoleTurn {
  double turn_rad = 0, u_rad = 0;
};

std::optional<HoleTurn> turn_of(const BoltRing& ring, const RingCount& count,
                                const FaceFrame& frame, std::string& why) {
  const int holes = ring.holes().count;
  const double radius = 0.5 * ring.holes().bolt_circle_m;
  double seen = 0, flank = 0, filled = 0;
  Eigen::Vector2d along = Eigen::Vector2d::Zero();  // the mean way round of what was seen
  for (std::size_t i = 0; i < count.bins.size(); ++i) {
    const double angle =
        kTurn * (static_cast<double>(i) + 0.5) / static_cast<double>(count.bins.size());
    const double weight{count.bins[i].seen};
    seen += weight;
    flank += double{count.bins[i].through};
    filled += weight > 0 ? 1 : 0;
    along += weight * Eigen::Vector2d(-std::sin(angle), std::cos(angle));
  }
  if (seen < kFewest || flank < 1 || flank > seen - 1) {
    why = "only " + std::to_string(std::lround(seen)) + " points lie round its bolt holes";
    return std::nullopt;
  }
  const double seen_share = filled / static_cast<double>(count.bins.size());
  const double spacing = std::sqrt(count.flank_area_m2 * seen_share / flank);
  const auto harmonic = hole_harmonic(count.bins, holes, kOvertones);
  if (!harmonic || !(kStandsOut * harmonic->sigma_rad < 1) ||
      !are_holes(count.bins, holes, *harmonic)) {
    why = "its bolt holes do not stand out, where points lie " + millimetres(spacing) +
          " apart and a hole is about " + millimetres(2 * ring.half_width_m()) + " wide";
    return std::nullopt;
  }
  // A centre that is off by e has a hole at angle a turned by e . (-sin a, cos a) / radius.
  along /= seen * radius;
  const double of_count = harmonic->sigma_rad / holes;
  const double of_grid = BoltPhaseOptions{}.bias_px * spacing / radius;
  const double of_centre2 = along.dot(frame.centre_covariance * along);
  return HoleTurn{std::remainder(harmonic->phase_rad - ring.holes().clocking_rad, kTurn / holes),
                  std::sqrt(of_count * of_count + of_grid * of_grid + of_centre2)};
}

std::optional<PartFeature> holes_of(const DesignModel& design, const Drawing& drawing,
                                    const FeatureScan& scan, const PartFeatures& features, int part,
                                    const Watch& watch, std::string& why) {
  const auto ring = BoltRing::of(design, part);
  const auto shape = face_shape(design, part);
  if (!ring || !shape) {
    why = "the design draws no flat face round its bolt holes";
    return std::nullopt;
  }
  const auto frame = face_frame(design, drawing, features, part, why);
  if (!frame) return std::nullopt;
  const auto flat = ring->face_height_m(frame->side);
  if (!flat) {
    why = "the design draws no flat face round its bolt holes";
    return std::nullopt;
  }
  const Vector3d port = design.parts[at(part)].T_design_part.inverse() * shape->point;
  const double height = frame->side * (*flat - port.z());
  const auto turn =
      turn_of(*ring, count_round(*ring, *shape, height, *frame, scan, watch), *frame, why);
  if (!turn) return std::nullopt;
  const PartFeature& face = features.features[at(features.of(part))];
  PartFeature holes;
  holes.part = part;
  holes.kind = FeatureKind::kHoles;
  holes.T_design_nominal = frame->T_design_nominal;
  holes.T_design_measured =
      frame->T_design_measured * Eigen::AngleAxisd(turn->turn_rad, Vector3d::UnitZ());
  // They lean with their face, about whichever axis.
  const double lean2 = face.fit_covariance.diagonal().segment<2>(3).maxCoeff();
  holes.fit_covariance.diagonal() << 0, 0, 0, lean2, lean2, turn->u_rad * turn->u_rad;
  holes.is_observed = {false, false, false, true, true, true};
  return holes;
}

}  // namespace

void add_bolt_holes(const DesignModel& design, const Drawing& drawing, const FeatureScan& scan,
                    PartFeatures& features, const Watch& watch) {
  features.why_no_holes.resize(design.parts.size());
  for (std::size_t p = 0; p < design.parts.size() && !watch.cancelled(); ++p) {
    if (!design.parts[p].holes) continue;
    auto holes = holes_of(design, drawing, scan, features, static_cast<int>(p), watch,
                          features.why_no_holes[p]);
    if (holes) features.features.push_back(*holes);
  }
}

}  // namespace spool
