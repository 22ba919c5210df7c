// The spool as a chain of links between fitted features.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/joint_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "vision/measure/datum_frame.h"

namespace spool {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Axes within 17 degrees of parallel cross nowhere certain, as in FeatureGeometry.
constexpr double kParallel = 0.956;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Vector3d axis_of(const Pose& pose) { return pose.linear().col(2); }

Pose turn_about_z(double angle) { return Pose(Eigen::AngleAxisd(angle, Vector3d::UnitZ())); }

// The turn about z in a rotation that is swing * turn.
double twist(const Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  return 2 * std::atan2(q.z(), q.w());
}

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

// How a feature's part is turned about the feature's own z by its holes, beyond what the measured
// feature says: of the turns a pitch apart the one nearest to `guess`.
double turn_by(const TurnHold& hold, const PartFeatures& features, const FeatureState& state,
               int feature, double guess) {
  const Matrix3d moved = state[at(hold.holes)].linear() *
                         features.features[at(hold.holes)].T_design_nominal.linear().transpose();
  const double turn = twist(state[at(feature)].linear().transpose() * moved *
                            features.features[at(feature)].T_design_nominal.linear());
  return guess + std::remainder(turn - guess, hold.pitch_rad);
}

struct Reach {
  int part = -1, joint = -1, from = -1;
};

// Parts in breadth-first order from `start` over the joints that `is_open` lets pass.
template <class IsOpen>
std::vector<Reach> reach(const DesignModel& design, const std::vector<std::vector<int>>& joints_of,
                         int start, const IsOpen& is_open) {
  std::vector<Reach> order(1, {start, -1, -1});
  std::vector<bool> met(design.parts.size(), false);
  met[at(start)] = true;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int here = order[i].part;
    for (const int j : joints_of[at(here)]) {
      const Joint& joint = design.joints[at(j)];
      const int there = joint.part_a == here ? joint.part_b : joint.part_a;
      if (met[at(there)] || !is_open(j)) continue;
      met[at(there)] = true;
      order.push_back({there, j, here});
    }
  }
  return order;
}

// How the root is turned about itself, beyond what its feature says of it (rad).
double root_turn(const JointChain& chain, const PartFeatures& features, const FeatureState& state) {
  const Pose& nominal = features.features[at(chain.root)].T_design_nominal;
  const Pose& measured = state[at(chain.root)];
  double turn = twist(measured.linear().transpose() * nominal.linear());
  if (chain.clock >= 0) {
    const int to = chain.links[at(chain.clock)].to;
    const Vector3d is = measured.linear().transpose() * axis_of(state[at(to)]);
    const Vector3d was =
        nominal.linear().transpose() * axis_of(features.features[at(to)].T_design_nominal);
    turn = wrapped(std::atan2(is.y(), is.x()) - std::atan2(was.y(), was.x()));
  }
  return chain.turn.holes < 0 ? turn : turn_by(chain.turn, features, state, chain.root, turn);
}

const Port& port_at(const DesignModel& design, const Joint& joint, int part) {
  const bool is_a = joint.part_a == part;
  return design.parts[at(part)].ports[at(is_a ? joint.port_a : joint.port_b)];
}

class Builder {
 public:
  Builder(const DesignModel& design, const Drawing& drawing, const PartFeatures& features)
      : design_(design), drawing_(drawing), features_(features) {}

  JointChain build() {
    find_root();
    if (chain_.root < 0) return std::move(chain_);
    std::vector<std::vector<int>> joints_of(design_.parts.size());
    for (std::size_t j = 0; j < design_.joints.size(); ++j) {
      joints_of[at(design_.joints[j].part_a)].push_back(static_cast<int>(j));
      joints_of[at(design_.joints[j].part_b)].push_back(static_cast<int>(j));
    }
    const int start = features_.features[at(chain_.root)].part;
    const auto all = reach(design_, joints_of, start, [](int) { return true; });
    std::vector<bool> is_bridge(design_.joints.size(), false);
    for (const Reach& each : all) {
      if (each.joint < 0) continue;
      // Without it what lies beyond is not reached.
      const auto without = reach(design_, joints_of, start, [&](int j) { return j != each.joint; });
      is_bridge[at(each.joint)] = without.size() < all.size();
    }
    const auto tree = reach(design_, joints_of, start, [&](int j) { return is_bridge[at(j)]; });
    add_links(tree);
    choose_clock();
    hold_turns();
    return std::move(chain_);
  }

 private:
  void find_root() {
    const FeatureGeometry geometry(design_, drawing_, features_);
    const DatumFrame datum = datum_frame(design_, drawing_, features_, geometry);
    if (datum.node >= 0) {
      const DrawingNode& face = drawing_.nodes[at(datum.node)];
      chain_.root = geometry.axis_near(datum.node, face.legs.front());
      chain_.face = features_.of(face.part);
      chain_.text = name_of(face, design_) + " and the axis of the pipe on it";
      return;
    }
    chain_.text = datum.text;
    for (std::size_t f = 0; f < features_.features.size() && chain_.root < 0; ++f)
      if (features_.features[f].kind == FeatureKind::kAxis) chain_.root = static_cast<int>(f);
    if (chain_.root < 0)
      chain_.text += " No pipe's axis is known.";
    else
      chain_.text += " Joints are counted from the axis of " + part_name(chain_.root) + ".";
  }

  [[nodiscard]] const std::string& part_name(int feature) const {
    return design_.parts[at(features_.features[at(feature)].part)].name;
  }

  void add_links(const std::vector<Reach>& tree) {
    struct Way {
      int feature = -1, link = -1;
      std::vector<int> joints;  // since that feature
    };
    std::vector<Way> way(design_.parts.size());
    for (const Reach& each : tree) {
      Way& here = way[at(each.part)];
      const int feature = features_.of(each.part);
      if (each.joint < 0) {
        here.feature = chain_.root;
        continue;
      }
      here = way[at(each.from)];
      here.joints.push_back(each.joint);
      if (feature < 0) continue;
      ChainLink link{.from = here.feature, .to = feature, .before = here.link};
      link.joints = std::exchange(here.joints, {});
      link.T_design_joint = joint_frame(link);
      here.feature = feature;
      here.link = static_cast<int>(chain_.links.size());
      chain_.links.push_back(std::move(link));
    }
    // A joint is loose where no feature lies beyond it: no link runs over it.
    std::vector<bool> is_linked(design_.joints.size(), false);
    for (const ChainLink& link : chain_.links)
      for (const int joint : link.joints) is_linked[at(joint)] = true;
    for (const Reach& each : tree) {
      if (each.joint < 0) continue;
      if (!is_linked[at(each.joint)]) chain_.loose.push_back({each.joint, each.from, each.part});
      for (int link = way[at(each.part)].link; link >= 0; link = chain_.links[at(link)].before)
        chain_.links[at(link)].parts.push_back(each.part);
      // A fitting that a link runs over hangs on that link too, from its first joint outward.
      if (is_linked[at(each.joint)] && features_.of(each.part) < 0) add_fitting(each);
    }
  }

  void add_fitting(const Reach& each) {
    for (ChainLink& link : chain_.links)
      if (std::ranges::find(link.joints, each.joint) != link.joints.end() &&
          std::ranges::find(link.parts, each.part) == link.parts.end())
        link.parts.push_back(each.part);
  }

  // At a joint the port of what lies before; of several where the two axes cross, else the last.
  [[nodiscard]] Pose joint_frame(const ChainLink& link) const {
    const PartFeature& a = features_.features[at(link.from)];
    const PartFeature& b = features_.features[at(link.to)];
    const Joint& first = design_.joints[at(link.joints.front())];
    const Joint& last = design_.joints[at(link.joints.back())];
    const auto place = [&](const Joint& joint, int part) -> Vector3d {
      return design_.parts[at(part)].T_design_part * port_at(design_, joint, part).position;
    };
    const Matrix3d R_design_a = design_.parts[at(a.part)].T_design_part.linear();
    const Vector3d z = (R_design_a * port_at(design_, first, a.part).direction).normalized();
    Vector3d p = axis_of(b.T_design_nominal);
    if (p.dot(b.T_design_nominal.translation() - place(last, b.part)) < 0) p = -p;
    Pose T = Pose::Identity();
    T.translation() = place(last, b.part);
    const bool bends = std::abs(p.dot(z)) < kParallel;
    if (bends && b.kind == FeatureKind::kAxis && a.kind == FeatureKind::kAxis) {
      // The point of a's axis that is nearest to b's.
      const Vector3d w = b.T_design_nominal.translation() - a.T_design_nominal.translation();
      const double c = z.dot(p);
      T.translation() =
          a.T_design_nominal.translation() + (z.dot(w) - c * p.dot(w)) / (1 - c * c) * z;
    }
    const Vector3d x = bends ? Vector3d((p - p.dot(z) * z).normalized()) : z.unitOrthogonal();
    T.linear().col(0) = x;
    T.linear().col(1) = z.cross(x);
    T.linear().col(2) = z;
    return T;
  }

  void choose_clock() {
    const Vector3d axis = axis_of(features_.features[at(chain_.root)].T_design_nominal);
    for (std::size_t l = 0; l < chain_.links.size() && chain_.clock < 0; ++l) {
      const PartFeature& to = features_.features[at(chain_.links[l].to)];
      if (std::abs(axis_of(to.T_design_nominal).dot(axis)) < kParallel)
        chain_.clock = static_cast<int>(l);
    }
  }

  [[nodiscard]] TurnHold holes_of(int part) const {
    const int holes = features_.holes_of(part);
    if (holes < 0) return {};
    return {holes, 2 * std::numbers::pi / design_.parts[at(part)].holes->count};
  }

  // Where holes are known they hold what they are drilled in, unless it was one-holed.
  void hold_turns() {
    FeatureState measured;
    for (const PartFeature& each : features_.features) measured.push_back(each.T_design_measured);
    if (chain_.face >= 0) {
      const double by_bend = root_turn(chain_, features_, measured);
      chain_.turn = holes_of(features_.features[at(chain_.face)].part);
      if (chain_.turn.holes >= 0 && chain_.clock >= 0 &&
          is_half_off(chain_.turn, root_turn(chain_, features_, measured) - by_bend))
        chain_.turn = {};
    }
    if (chain_.turn.holes < 0 && chain_.clock >= 0) chain_.links[at(chain_.clock)].is_clock = true;
    // Each is seen from what lies before it, which the turns before it have settled.
    for (ChainLink& link : chain_.links) {
      const PartFeature& to = features_.features[at(link.to)];
      const bool is_datum = chain_.turn.holes >= 0 && link.to == chain_.face;
      if (to.kind != FeatureKind::kFace || is_datum) continue;
      const TurnHold hold = holes_of(to.part);
      if (hold.holes < 0) continue;
      const ChainState without = chain_state(chain_, features_, measured);
      const auto l = static_cast<std::size_t>(&link - chain_.links.data());
      const Matrix3d was = without.links[l].linear();
      link.turn = hold;
      const Matrix3d is = chain_state(chain_, features_, measured).links[l].linear();
      if (is_half_off(hold, Eigen::AngleAxisd(was.transpose() * is).angle())) link.turn = {};
    }
  }

  [[nodiscard]] static bool is_half_off(const TurnHold& hold, double turn) {
    return is_one_holed(turn, static_cast<int>(std::lround(2 * std::numbers::pi / hold.pitch_rad)));
  }

  const DesignModel& design_;
  const Drawing& drawing_;
  const PartFeatures& features_;
  JointChain chain_;
};

// Where the axis `line` meets the plane, or is nearest to the axis, along itself (m).
double along(const Pose& line, const Pose& other, FeatureKind kind) {
  const Vector3d d = axis_of(line), n = axis_of(other),
                 w = other.translation() - line.translation();
  if (kind == FeatureKind::kFace) return n.dot(w) / n.dot(d);
  const double c = d.dot(n);
  return (d.dot(w) - c * n.dot(w)) / (1 - c * c);
}

Pose root_motion(const JointChain& chain, const PartFeatures& features, const FeatureState& state) {
  const Pose& nominal = features.features[at(chain.root)].T_design_nominal;
  const Pose& measured = state[at(chain.root)];
  const double turn = root_turn(chain, features, state);
  // Along itself by the datum's face, else by where the first bend leaves it.
  const int by = chain.face >= 0    ? chain.face
                 : chain.clock >= 0 ? chain.links[at(chain.clock)].to
                                    : -1;
  double slide = 0;
  if (by >= 0) {
    const PartFeature& holds = features.features[at(by)];
    slide = along(measured, state[at(by)], holds.kind) -
            along(nominal, holds.T_design_nominal, holds.kind);
  } else {
    slide = axis_of(measured).dot(nominal.translation() - measured.translation());
  }
  return measured * turn_about_z(turn) * Eigen::Translation3d(0, 0, slide) * nominal.inverse();
}

// The motion of the link's part, `before` being that of what it hangs on.
Pose link_motion(const ChainLink& link, const PartFeatures& features, const FeatureState& state,
                 const Pose& before) {
  const PartFeature& to = features.features[at(link.to)];
  const Pose& measured = state[at(link.to)];
  const Pose T_feature_joint = to.T_design_nominal.inverse() * link.T_design_joint;
  const Pose T_near = before * link.T_design_joint;
  const Vector3d p_nominal =
      link.T_design_joint.linear().transpose() * axis_of(to.T_design_nominal);
  // What is not observed is chosen so that the error has no part along this axis of the joint.
  const int axis = to.kind == FeatureKind::kAxis && is_bend(p_nominal) ? 0 : 2;
  Pose full = measured;
  const Matrix3d predicted = T_near.linear() * T_feature_joint.linear().transpose();
  double turn = -twist(predicted.transpose() * full.linear());
  if (link.turn.holes >= 0) turn = turn_by(link.turn, features, state, link.to, turn);
  full = full * turn_about_z(turn);
  if (to.kind == FeatureKind::kAxis)
    for (int round = 0; round < 4; ++round) {  // the rotation vector is all but straight in it
      const Matrix3d off_by =
          T_near.linear().transpose() * full.linear() * T_feature_joint.linear();
      const Vector3d p = T_near.linear().transpose() * axis_of(full);
      full = full * turn_about_z(-rotation_vector(off_by)[axis] / p[axis]);
    }
  const Vector3d off = (full * T_feature_joint).translation() - T_near.translation();
  const Vector3d z = axis_of(full);
  if (to.kind == FeatureKind::kFace) {
    full.translation() -= off - off.dot(z) * z;
  } else {
    const Vector3d across = T_near.linear().col(axis);
    full.translation() -= off.dot(across) / z.dot(across) * z;
  }
  return full * to.T_design_nominal.inverse();
}

}  // namespace

JointChain joint_chain(const DesignModel& design, const Drawing& drawing,
                       const PartFeatures& features) {
  return Builder(design, drawing, features).build();
}

ChainState chain_state(const JointChain& chain, const PartFeatures& features,
                       const FeatureState& state) {
  ChainState motions;
  motions.root = root_motion(chain, features, state);
  for (const ChainLink& link : chain.links) {
    const Pose& before = link.before < 0 ? motions.root : motions.links[at(link.before)];
    motions.links.push_back(link_motion(link, features, state, before));
  }
  return motions;
}

bool is_bend(const Vector3d& p) { return std::abs(p.z()) < kParallel; }

Vector6d link_error(const JointChain& chain, int link, const ChainState& state) {
  const ChainLink& here = chain.links[at(link)];
  const Pose& before = here.before < 0 ? state.root : state.links[at(here.before)];
  const Pose error = here.T_design_joint.inverse() * before.inverse() * state.links[at(link)] *
                     here.T_design_joint;
  Vector6d vector;
  vector << error.translation(), rotation_vector(error.linear());
  return vector;
}

}  // namespace spool
