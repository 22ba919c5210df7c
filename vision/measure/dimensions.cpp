// The drawing's dimensions by its joint graph, measured from the features and judged by the rules.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/dimensions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "vision/inspect/joint_tree.h"
#include "vision/measure/conformance.h"
#include "vision/measure/datum_frame.h"
#include "vision/measure/dimension_text.h"
#include "vision/measure/feature_geometry.h"
#include "vision/measure/part_shapes.h"
#include "vision/measure/rotation.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

VectorXd one(double value) { return VectorXd::Constant(1, value); }

class Measuring {
 public:
  Measuring(const DesignModel& design, const Drawing& drawing, const PartFeatures& features,
            const RuleSet& rules, const DimensionOptions& options)
      : design_(design),
        drawing_(drawing),
        features_(features),
        rules_(rules),
        options_(options),
        geometry_(design, drawing, features),
        datum_(datum_frame(design, drawing, features, geometry_)),
        nominal_(geometry_.nominal()),
        measured_(geometry_.measured()),
        tree_(joint_tree(design)) {}

  MeasuredDrawing all() {
    for (std::size_t leg = 0; leg < drawing_.legs.size(); ++leg) length(static_cast<int>(leg));
    for (std::size_t node = 0; node < drawing_.nodes.size(); ++node) {
      if (drawing_.nodes[node].legs.empty()) continue;
      const auto n = static_cast<int>(node);
      if (drawing_.nodes[node].kind == NodeKind::kCentre) angles(n);
      if (drawing_.nodes[node].kind != NodeKind::kFace) continue;
      face_alignment(n);
      if (n != datum_.node) offsets(n);
    }
    for (std::size_t part = 0; part < design_.parts.size(); ++part)
      rotation(static_cast<int>(part));
    return {std::move(dimensions_), datum_.text};
  }

 private:
  void length(int index) {
    const DrawingLeg& leg = drawing_.legs[at(index)];
    const DrawingNode& from = drawing_.nodes[at(leg.from)];
    const DrawingNode& to = drawing_.nodes[at(leg.to)];
    Dimension dimension = between(kind_between(from.kind, to.kind), name_of(from, design_),
                                  name_of(to, design_), leg.parts);
    dimension.nominal = leg.length_m;
    dimension.answers = leg.pipes.empty() ? to.part : leg.pipes.front();
    const int fittings = leg.pipes.empty() ? 2 : 0;
    tolerate(length_tolerance(rules_, leg.nps, leg.length_m, fittings), dimension);
    const FeaturePoint a = geometry_.point(leg.from, index), b = geometry_.point(leg.to, index);
    const FeaturePoint along = geometry_.direction(index);
    if (!a.at || !b.at || !along.at) {
      dimension.reason = !a.at ? a.why_not : !b.at ? b.why_not : along.why_not;
      return refuse(std::move(dimension));
    }
    take_number(
        [&](const FeatureState& state) {
          return one((b.at(state) - a.at(state)).dot(along.at(state)));
        },
        std::move(dimension));
  }

  // Of each leg at a centre the angle to the first other that it is not in line with.
  void angles(int node) {
    const std::vector<int>& legs = drawing_.nodes[at(node)].legs;
    for (std::size_t j = 1; j < legs.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        const Vector3d a = away(node, legs[i]), b = away(node, legs[j]);
        if (std::abs(a.dot(b)) > 0.99) continue;  // a run goes straight on
        angle(node, legs[i], legs[j], std::acos(a.dot(b)));
        break;
      }
    }
  }

  void angle(int node, int first, int second, double nominal) {
    const DrawingLeg& one_leg = drawing_.legs[at(first)];
    const DrawingLeg& other = drawing_.legs[at(second)];
    std::vector<int> parts = one_leg.pipes;
    parts.insert(parts.end(), other.pipes.begin(), other.pipes.end());
    parts.push_back(drawing_.nodes[at(node)].part);
    Dimension dimension =
        between("angle", axis_name(node, first), axis_name(node, second), std::move(parts));
    dimension.is_angle = true;
    dimension.nominal = nominal;
    dimension.answers = drawing_.nodes[at(node)].part;
    dimension.name += " at " + design_.parts[at(dimension.answers)].name;
    tolerate(angle_tolerance(rules_, std::min(one_leg.length_m, other.length_m),
                             std::min(diameter(first), diameter(second))),
             dimension);
    const FeaturePoint a = geometry_.outward(node, first), b = geometry_.outward(node, second);
    if (!a.at || !b.at) {
      dimension.reason = !a.at ? a.why_not : b.why_not;
      return refuse(std::move(dimension));
    }
    take_number(
        [&](const FeatureState& state) {
          return one(std::acos(std::clamp(a.at(state).dot(b.at(state)), -1.0, 1.0)));
        },
        std::move(dimension));
  }

  void face_alignment(int node) {
    const DrawingNode& face = drawing_.nodes[at(node)];
    const int leg = face.legs.front();
    Dimension dimension = between("face_alignment", axis_name(node, leg), name_of(face, design_),
                                  drawing_.legs[at(leg)].pipes);
    dimension.parts.push_back(face.part);
    dimension.is_angle = true;
    dimension.answers = face.part;
    const auto shape = face_shape(design_, face.part);
    tolerate(alignment_tolerance(rules_, shape ? shape->face_diameter_m : 0), dimension);
    const FeaturePoint axis = geometry_.outward(node, leg);
    const int plane = features_.of(face.part);
    if (!axis.at || plane < 0) {
      dimension.reason = !axis.at ? axis.why_not
                                  : "the face of " + design_.parts[at(face.part)].name +
                                        " is not known: " + features_.why_not[at(face.part)];
      return refuse(std::move(dimension));
    }
    const Eigen::Matrix3d across = nominal_[at(plane)].linear();
    // The axis runs from the face into the spool; the face looks the other way.
    take_tilt(
        [&](const FeatureState& state) -> VectorXd {
          const Vector3d lean = state[at(plane)].linear().col(2) + axis.at(state);
          return (across.transpose() * lean).head<2>();
        },
        std::move(dimension));
  }

  void offsets(int node) {
    const DrawingNode& face = drawing_.nodes[at(node)];
    const int leg = face.legs.front();
    const Vector3d along = drawing_.legs[at(leg)].direction;
    // The two axes of the design that lie most across the leg, made square to it.
    std::array<int, 3> order = {0, 1, 2};
    std::ranges::sort(order, {}, [&](int k) { return std::abs(along[k]); });
    for (int k = 0; k < 2; ++k) {
      const int axis = order[at(k)];
      Vector3d across = Vector3d::Unit(axis);
      across = (across - across.dot(along) * along).normalized();
      if (k == 1) {
        Vector3d first = Vector3d::Unit(order[0]);
        first = (first - first.dot(along) * along).normalized();
        across = (across - across.dot(first) * first).normalized();
      }
      offset(node, leg, across, std::string(1, "xyz"[axis]));
    }
  }

  void offset(int node, int leg, const Vector3d& across, const std::string& axis) {
    const DrawingNode& face = drawing_.nodes[at(node)];
    const std::string datum =
        datum_.node >= 0 ? name_of(drawing_.nodes[at(datum_.node)], design_) : "datum";
    // Whatever lies on the way may have moved it: an elbow that is rolled changes nothing nearer.
    const int from_part = datum_.node >= 0         ? drawing_.nodes[at(datum_.node)].part
                          : design_.datums.empty() ? 0
                                                   : design_.datums.front();
    Dimension dimension = between("offset", datum, name_of(face, design_),
                                  parts_between(tree_, from_part, face.part));
    dimension.name += " across, along " + axis;
    tolerate(length_tolerance(rules_, drawing_.legs[at(leg)].nps, drawing_.legs[at(leg)].length_m),
             dimension);
    const FeaturePoint point = geometry_.point(node, leg);
    if (!point.at || datum_.node < 0) {
      dimension.reason = point.at ? datum_.text : point.why_not;
      return refuse(std::move(dimension));
    }
    const DrawingNode& from = drawing_.nodes[at(datum_.node)];
    dimension.nominal = across.dot(face.point - from.point);
    const Pose T_nominal = datum_.T_design_datum(nominal_);
    const bool turns = !datum_.is_clocked() && is_aside(face.point, from);
    if (turns) {
      dimension.reason = "nothing that was measured holds the turn about the datum's axis";
      return refuse(std::move(dimension));
    }
    take_number(
        [&](const FeatureState& state) {
          const Pose T_nominal_measured = T_nominal * datum_.T_design_datum(state).inverse();
          return one(across.dot(T_nominal_measured * point.at(state) - from.point));
        },
        std::move(dimension));
  }

  void rotation(int index) {
    const Part& part = design_.parts[at(index)];
    if (part.holes) holes_turn(index);
    // Where a tap or a flat side points no feature here tells: it is listed, so that nothing is ok
    // without it.
    if (part.marks.empty()) return;
    const std::string& mark = part.marks.front().type;
    Dimension dimension = between("rotation", part.name + "/axis", part.name + "/" + mark, {index});
    dimension.is_angle = true;
    dimension.rule = "it is not judged";
    dimension.reason = "Not measured: where its " + mark + " points. Check it against the drawing.";
    dimensions_.push_back(std::move(dimension));
  }

  void holes_turn(int index) {
    const BoltHoles& holes = *design_.parts[at(index)].holes;
    HolesRotation turned =
        rotation_of_holes(design_, drawing_, features_, datum_, measured_, tree_, index);
    if (turned.is_datum) return;
    Dimension dimension = between("rotation", turned.from, design_.parts[at(index)].name + "/holes",
                                  std::move(turned.parts));
    dimension.is_angle = true;
    dimension.nominal = turned.nominal_rad;
    dimension.answers = turned.answers;
    dimension.is_one_holed = turned.is_one_holed;
    tolerate(rotation_tolerance(rules_, holes.count, holes.bolt_circle_m), dimension);
    if (!turned.at) {
      dimension.reason = "Not measured: " + turned.why_not + ". " + advice_on(dimension);
      dimensions_.push_back(std::move(dimension));
      return;
    }
    take_number([&](const FeatureState& state) { return one(turned.at(state)); },
                std::move(dimension));
  }

  [[nodiscard]] bool is_aside(const Vector3d& point, const DrawingNode& datum) const {
    const Vector3d axis = drawing_.legs[at(datum.legs.front())].direction, d = point - datum.point;
    return (d - d.dot(axis) * axis).norm() > 1e-3;
  }

  Dimension between(std::string kind, std::string from, std::string to, std::vector<int> parts) {
    Dimension dimension;
    dimension.kind = std::move(kind);
    dimension.from = std::move(from);
    dimension.to = std::move(to);
    dimension.name = dimension.from + " to " + dimension.to;
    dimension.parts = std::move(parts);
    return dimension;
  }

  // "pipe_2/axis", or where no pipe lies there the leg's first part.
  [[nodiscard]] std::string axis_name(int node, int leg) const {
    const int feature = geometry_.axis_near(node, leg);
    const DrawingLeg& along = drawing_.legs[at(leg)];
    const int part = feature >= 0          ? features_.features[at(feature)].part
                     : along.pipes.empty() ? along.parts[along.parts.size() / 2]
                                           : along.pipes.front();
    return design_.parts[at(part)].name + "/axis";
  }

  [[nodiscard]] Vector3d away(int node, int leg) const {
    const DrawingLeg& along = drawing_.legs[at(leg)];
    return along.from == node ? along.direction : Vector3d(-along.direction);
  }

  [[nodiscard]] double diameter(int leg) const {
    for (const int pipe : drawing_.legs[at(leg)].pipes)
      if (const auto shape = pipe_shape(design_, pipe)) return 2 * shape->radius_m;
    return 0;
  }

  static void tolerate(const std::optional<Tolerance>& tolerance, Dimension& dimension) {
    dimension.tolerance = tolerance ? tolerance->value : 0;
    dimension.rule = tolerance ? tolerance->rule : "the rules give it no tolerance";
  }

  void refuse(Dimension dimension) {
    dimension.reason = "Not measured: " + dimension.reason + ". Scan it from where it shows.";
    dimensions_.push_back(std::move(dimension));
  }

  template <class Function>
  void take_number(const Function& function, Dimension dimension) {
    const Propagated found = propagate(function, features_, measured_);
    if (!found.is_determined) {
      dimension.reason = "it moves with what no feature holds";
      return refuse(std::move(dimension));
    }
    // One that holds the datum's turn has no offset of its own.
    constexpr double kNothing = 1e-9;
    if (std::sqrt(found.fit(0, 0)) < kNothing) return;
    dimension.is_measured = true;
    // The features stay as the sensor saw them; of what is measured between them the length is put
    // right.
    dimension.measured = found.value[0] / (dimension.is_angle ? 1 : 1 + options_.scale_correction);
    dimension.deviation = dimension.measured - dimension.nominal;
    dimension.u = {std::sqrt(found.fit(0, 0)),
                   dimension.is_angle ? 0 : options_.scale_u * std::abs(dimension.measured),
                   std::sqrt(found.warp(0, 0))};
    settle(conformance_of(dimension.deviation, dimension.u.total(), dimension.tolerance),
           std::move(dimension));
  }

  // A tilt has a size and a way; noise alone makes its size positive. What is stated is the size
  // with the noise's share taken off, |t|^2 = |t'|^2 - trace(C).
  template <class Function>
  void take_tilt(const Function& function, Dimension dimension) {
    const Propagated found = propagate(function, features_, measured_);
    if (!found.is_determined) {
      dimension.reason = "it moves with what no feature holds";
      return refuse(std::move(dimension));
    }
    const Eigen::Vector2d tilt = found.value;
    const Eigen::Matrix2d covariance = found.fit + found.warp;
    dimension.is_measured = true;
    dimension.measured = std::sqrt(std::max(0.0, tilt.squaredNorm() - covariance.trace()));
    dimension.deviation = dimension.measured;
    const Eigen::Vector2d way = tilt.norm() > 0 ? Eigen::Vector2d(tilt.normalized())
                                                : Eigen::Vector2d(Eigen::Vector2d::UnitX());
    dimension.u = {std::sqrt(way.dot(found.fit * way)), 0, std::sqrt(way.dot(found.warp * way))};
    settle(conformance_of(tilt, covariance, dimension.tolerance), std::move(dimension));
  }

  void settle(const Conformance& conformance, Dimension dimension) {
    const auto text = [&](double value) { return number_text(value, dimension.is_angle); };
    const double u = dimension.u.total();
    if (!(dimension.tolerance > 0)) {
      dimension.status = Verdict::kSuspicious;
      dimension.reason = "It was measured, but the rules give it no tolerance.";
    } else {
      dimension.probability = conformance.probability;
      dimension.status = decide(conformance);
      dimension.reason = "Off by " + text(dimension.deviation) + " ± " + text(2 * u) +
                         ", allowed ± " + text(dimension.tolerance) + ".";
      if (dimension.is_one_holed)
        dimension.reason += " That is half a pitch: its holes look one-holed.";
      if (dimension.status == Verdict::kSuspicious) dimension.reason += " " + advice_on(dimension);
      if (dimension.status == Verdict::kOk && !options_.nothing_ok.empty()) {
        dimension.status = Verdict::kSuspicious;
        dimension.reason += " " + options_.nothing_ok;
      }
    }
    dimensions_.push_back(std::move(dimension));
  }

  const DesignModel& design_;
  const Drawing& drawing_;
  const PartFeatures& features_;
  const RuleSet& rules_;
  const DimensionOptions& options_;
  FeatureGeometry geometry_;
  DatumFrame datum_;
  FeatureState nominal_, measured_;
  std::vector<JointBranch> tree_;
  std::vector<Dimension> dimensions_;
};

}  // namespace

MeasuredDrawing measure_dimensions(const DesignModel& design, const Drawing& drawing,
                                   const PartFeatures& features, const RuleSet& rules,
                                   const DimensionOptions& options) {
  return Measuring(design, drawing, features, rules, options).all();
}

}  // namespace spool
