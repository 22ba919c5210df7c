// What each fitted feature at a part says of where that part stands.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/pose_evidence.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "vision/measure/drawing.h"
#include "vision/measure/part_shapes.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// A joint as seen from one of its parts.
struct Neighbour {
  int port = -1;  // of the part
  int part = -1;
  std::string weld;
};

std::vector<Neighbour> neighbours_of(const DesignModel& design, int part) {
  std::vector<Neighbour> all;
  for (const Joint& joint : design.joints) {
    if (joint.part_a == part) all.push_back({joint.port_a, joint.part_b, joint.weld});
    if (joint.part_b == part) all.push_back({joint.port_b, joint.part_a, joint.weld});
  }
  return all;
}

bool is_bolted(const DesignModel& design, int part, int port) {
  return design.parts[at(part)].ports[at(port)].end == EndType::kFlanged;
}

class Collecting {
 public:
  Collecting(const DesignModel& design, const PartFeatures& features, const RuleSet& rules,
             int part)
      : design_(design),
        features_(features),
        rules_(rules),
        index_(part),
        part_(design.parts[at(part)]) {}

  std::vector<PoseEvidence> all() {
    own_ = features_.of(index_);
    const bool is_own_axis = own_ >= 0 && feature(own_).kind == FeatureKind::kAxis;
    if (own_ >= 0) add_own();
    if (const int holes = features_.holes_of(index_); holes >= 0 && part_.holes) add_holes(holes);
    for (const Neighbour& next : neighbours_of(design_, index_)) {
      if (is_bolted(design_, index_, next.port)) continue;
      if (is_own_axis)
        add_stop(next);
      else
        add_neighbour(next);
    }
    return std::move(evidence_);
  }

 private:
  [[nodiscard]] const PartFeature& feature(int f) const { return features_.features[at(f)]; }

  [[nodiscard]] const std::string& name(int part) const { return design_.parts[at(part)].name; }

  [[nodiscard]] Pose in_part(const Pose& T_design_nominal) const {
    return part_.T_design_part.inverse() * T_design_nominal;
  }

  void add_own() {
    const bool is_axis = feature(own_).kind == FeatureKind::kAxis;
    PoseEvidence own{.kind = is_axis ? PoseHold::kLine : PoseHold::kPlane, .feature = own_};
    own.T_part_nominal = in_part(feature(own_).T_design_nominal);
    own.text = is_axis ? "its axis" : "its face";
    evidence_.push_back(std::move(own));
  }

  void add_holes(int holes) {
    PoseEvidence turn{.kind = PoseHold::kTurn, .feature = holes};
    turn.T_part_nominal = in_part(feature(holes).T_design_nominal);
    turn.pitch_rad = 2 * std::numbers::pi / part_.holes->count;
    turn.text = "its bolt holes";
    evidence_.push_back(std::move(turn));
  }

  // The neighbour's axis or face, at the port.
  void add_neighbour(const Neighbour& next) {
    const int f = features_.of(next.part);
    if (f < 0) return;
    const bool is_axis = feature(f).kind == FeatureKind::kAxis;
    PoseEvidence seen{.kind = is_axis ? PoseHold::kLine : PoseHold::kPlane, .feature = f};
    // The point of the axis or the face that is nearest to the port.
    Pose T_design_nominal = feature(f).T_design_nominal;
    const Vector3d z = T_design_nominal.linear().col(2);
    const Vector3d port = part_.T_design_part * part_.ports[at(next.port)].position;
    const Vector3d off = port - T_design_nominal.translation();
    T_design_nominal.translation() += is_axis ? Vector3d(off.dot(z) * z) : off - off.dot(z) * z;
    seen.T_part_nominal = in_part(T_design_nominal);
    seen.weld_u_m = weld_u_m(next.port, next.part);
    seen.weld_u_rad = weld_u_rad(next.part);
    seen.text = (is_axis ? "the axis of " : "the face of ") + name(next.part) + through(next);
    evidence_.push_back(std::move(seen));
  }

  void add_stop(const Neighbour& next) {
    const int f = features_.of(next.part);
    if (f >= 0 && feature(f).kind == FeatureKind::kFace) {
      add_stop_at(f, next, 1, "the face of " + name(next.part));
      return;
    }
    const PartKind kind = design_.parts[at(next.part)].kind;
    if (kind != PartKind::kElbow && kind != PartKind::kTee && kind != PartKind::kCross) return;
    constexpr double kParallel = 0.956;  // as in FeatureGeometry: nearer to it nothing is certain
    for (const Neighbour& beyond : neighbours_of(design_, next.part)) {
      const int other = features_.of(beyond.part);
      if (beyond.part == index_ || other < 0 || feature(other).kind != FeatureKind::kAxis) continue;
      const double c = feature(other).T_design_nominal.linear().col(2).dot(
          feature(own_).T_design_nominal.linear().col(2));
      if (std::abs(c) >= kParallel) continue;
      add_stop_at(other, next, std::numbers::sqrt2,
                  "the axis of " + name(beyond.part) + " across " + name(next.part));
      return;
    }
  }

  void add_stop_at(int f, const Neighbour& next, double welds, const std::string& text) {
    PoseEvidence stop{.kind = PoseHold::kStop, .feature = f, .own_axis = own_};
    const Pose& axis = feature(own_).T_design_nominal;
    const Pose& by = feature(f).T_design_nominal;
    Pose T_design_nominal = axis;
    stop.is_face = feature(f).kind == FeatureKind::kFace;
    T_design_nominal.translation() =
        stop.is_face ? line_meets_plane(axis, by) : nearest_on(axis, by);
    stop.T_part_nominal = in_part(T_design_nominal);
    stop.weld_u_m = welds * weld_u_m(next.port, index_);
    stop.text = text;
    evidence_.push_back(std::move(stop));
  }

  [[nodiscard]] static std::string through(const Neighbour& next) {
    return next.weld.empty() ? ", through the weld" : ", through " + next.weld;
  }

  // Half of what a length may be off by, and an alignment.
  [[nodiscard]] double weld_u_m(int port, int pipe) const {
    const auto shape = pipe_shape(design_, pipe);
    const double nps = part_.ports[at(port)].nps > 0 ? part_.ports[at(port)].nps : part_.nps;
    const double length_m = shape ? shape->length_m : 0;
    auto allowed = length_tolerance(rules_, nps, length_m);
    if (!allowed) allowed = length_tolerance(pfi_es3(), nps, length_m);
    return 0.5 * (allowed ? allowed->value : 0.003);  // PFI ES-3 up to NPS 10
  }

  [[nodiscard]] double weld_u_rad(int part) const {
    const auto pipe = pipe_shape(design_, part);
    const auto face = face_shape(design_, part);
    const double diameter_m = pipe ? 2 * pipe->radius_m : face ? face->face_diameter_m : 0;
    auto allowed = alignment_tolerance(rules_, diameter_m);
    if (!allowed) allowed = alignment_tolerance(pfi_es3(), diameter_m);
    return 0.5 * (allowed ? allowed->value : 3.0 / 64 / 12);  // PFI ES-3: 3/64 in a foot
  }

  const DesignModel& design_;
  const PartFeatures& features_;
  const RuleSet& rules_;
  const int index_;
  const Part& part_;
  int own_ = -1;
  std::vector<PoseEvidence> evidence_;
};

}  // namespace

Eigen::Index PoseEvidence::rows() const {
  return kind == PoseHold::kLine ? 4 : kind == PoseHold::kPlane ? 3 : 1;
}

std::vector<PoseEvidence> pose_evidence(const DesignModel& design, const PartFeatures& features,
                                        const RuleSet& rules, int part) {
  return Collecting(design, features, rules, part).all();
}

VectorXd residual_of(const PoseEvidence& evidence, const Pose& error, const Pose& T_part_state,
                     const FeatureState& state) {
  const Pose T_nominal_state = (error * evidence.T_part_nominal).inverse() * T_part_state;
  const Pose seen = T_nominal_state * state[at(evidence.feature)];
  const Vector3d o = seen.translation(), z = seen.linear().col(2);
  VectorXd off(evidence.rows());
  switch (evidence.kind) {
    case PoseHold::kLine: {
      const Vector3d foot = o - o.z() / z.z() * z;
      off << foot.x(), foot.y(), z.x() / z.z(), z.y() / z.z();
      break;
    }
    case PoseHold::kPlane:
      off << z.dot(o) / z.z(), z.x() / z.z(), z.y() / z.z();
      break;
    case PoseHold::kTurn: {
      const Vector3d x = seen.linear().col(0);
      off << std::remainder(std::atan2(x.y(), x.x()), evidence.pitch_rad);
      break;
    }
    case PoseHold::kStop: {
      const Pose own = T_nominal_state * state[at(evidence.own_axis)];
      off << (evidence.is_face ? line_meets_plane(own, seen) : nearest_on(own, seen)).z();
      break;
    }
  }
  return off;
}

}  // namespace spool
