// What a spool's dimensions truly are: from where its parts stand, by lines and planes of its
// ports.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/built_truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/campaign/standard_sizes.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;

std::string part_of(const std::string& name) { return name.substr(0, name.find('/')); }

bool passes(PartKind kind) { return kind == PartKind::kPipe || kind == PartKind::kReducer; }

}  // namespace

int BuiltTruth::member(const std::string& name) const {
  for (std::size_t i = 0; i < assembly_.members.size(); ++i)
    if (assembly_.members[i].spec.name == part_of(name)) return static_cast<int>(i);
  return -1;
}

BuiltTruth::Line BuiltTruth::line(int pipe) const {
  const Pose& T = poses_[static_cast<std::size_t>(pipe)];
  const Vector3d along = T.linear().col(2);
  const double half = assembly_.members[static_cast<std::size_t>(pipe)].spec.length_m / 2;
  return {T.translation(), along, T.translation() + half * along};
}

// Through parents up to where the two meet; both ends included.
std::vector<int> BuiltTruth::path(int from, int to) const {
  const auto ancestors = [&](int part) {
    std::vector<int> chain;
    for (; part >= 0; part = assembly_.members[static_cast<std::size_t>(part)].parent)
      chain.push_back(part);
    return chain;
  };
  std::vector<int> up = ancestors(from), down = ancestors(to);
  while (up.size() > 1 && down.size() > 1 && up[up.size() - 2] == down[down.size() - 2]) {
    up.pop_back();
    down.pop_back();
  }
  down.pop_back();  // where they meet is in both
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

// The next pipes beyond each port of a fitting, in the order of its ports.
std::vector<int> BuiltTruth::pipes_at(int part) const {
  std::vector<int> pipes;
  const auto& members = assembly_.members;
  const auto ports = ports_of(members[static_cast<std::size_t>(part)].spec).size();
  for (int port = 0; port < static_cast<int>(ports); ++port) {
    int at = part, through = port;
    for (int step = 0; step < 3; ++step) {  // a reducer may come before the pipe
      const Member& here = members[static_cast<std::size_t>(at)];
      int next = here.own_port == through ? here.parent : -1;
      int entered = here.parent_port;
      for (std::size_t i = 0; i < members.size() && next < 0; ++i)
        if (members[i].parent == at && members[i].parent_port == through) {
          next = static_cast<int>(i);
          entered = members[i].own_port;
        }
      if (next < 0 || !passes(members[static_cast<std::size_t>(next)].spec.kind)) break;
      if (members[static_cast<std::size_t>(next)].spec.kind == PartKind::kPipe) {
        pipes.push_back(next);
        break;
      }
      at = next;
      through = 1 - entered;
    }
  }
  return pipes;
}

std::optional<Vector3d> BuiltTruth::node(int part, int pipe) const {
  const PartSpec& spec = assembly_.members[static_cast<std::size_t>(part)].spec;
  const auto [p, d, middle] = line(pipe);
  if (spec.kind == PartKind::kFlange) {
    const Pose T = poses_[static_cast<std::size_t>(part)] * ports_of(spec)[0].T_part_port;
    const Vector3d n = T.linear().col(2);
    return p + n.dot(T.translation() - p) / n.dot(d) * d;
  }
  if (spec.kind != PartKind::kElbow && spec.kind != PartKind::kTee) return std::nullopt;
  for (const int other : pipes_at(part)) {
    const auto [q, e, far] = line(other);
    const Vector3d common = d.cross(e);
    if (common.norm() < 0.3) continue;  // the run of a tee
    // p + t d is nearest to the other line where it meets the plane through that line and the
    // common perpendicular.
    const Vector3d n = e.cross(common);
    return p + n.dot(q - p) / n.dot(d) * d;
  }
  return std::nullopt;
}

std::optional<double> BuiltTruth::length(const std::string& from, const std::string& to) const {
  const int a = member(from), b = member(to);
  if (a < 0 || b < 0) return std::nullopt;
  std::vector<int> pipes;
  for (const int part : path(a, b))
    if (assembly_.members[static_cast<std::size_t>(part)].spec.kind == PartKind::kPipe)
      pipes.push_back(part);
  if (pipes.empty()) return std::nullopt;
  const auto start = node(a, pipes.front()), end = node(b, pipes.back());
  if (!start || !end) return std::nullopt;
  return std::abs((*end - *start).dot(line(pipes.front()).along));
}

std::optional<double> BuiltTruth::angle(const std::string& from, const std::string& to) const {
  const int a = member(from), b = member(to);
  if (a < 0 || b < 0) return std::nullopt;
  // Away from where they meet: from there to their middles, which is along them.
  const auto away = [&](int pipe, int other) {
    const auto [p, d, middle] = line(pipe);
    const auto [q, e, ignored] = line(other);
    const Vector3d n = e.cross(d.cross(e));
    const Vector3d meet = p + n.dot(q - p) / n.dot(d) * d;
    return (middle - meet).dot(d) < 0 ? Vector3d(-d) : d;
  };
  const Vector3d u = away(a, b), v = away(b, a);
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

std::optional<double> BuiltTruth::lean(const std::string& pipe, const std::string& face) const {
  const int a = member(pipe), b = member(face);
  if (a < 0 || b < 0) return std::nullopt;
  const PartSpec& spec = assembly_.members[static_cast<std::size_t>(b)].spec;
  if (spec.kind != PartKind::kFlange) return std::nullopt;
  const Pose T = poses_[static_cast<std::size_t>(b)] * ports_of(spec)[0].T_part_port;
  return std::asin(std::min(1.0, T.linear().col(2).cross(line(a).along).norm()));
}

std::optional<Pose> BuiltTruth::frame(int datum, const std::string& from) const {
  const std::vector<int> pipes = pipes_at(datum);
  if (pipes.empty()) return std::nullopt;
  const auto place = node(datum, pipes.front());
  if (!place) return std::nullopt;
  const auto [point, along, middle] = line(pipes.front());
  const Vector3d z = along.dot(middle - *place) < 0 ? Vector3d(-along) : along;
  Vector3d aside;
  if (from.ends_with("/holes")) {
    aside = poses_[static_cast<std::size_t>(datum)].linear().col(0);
  } else {
    const int part = member(from);
    if (part < 0 || pipes_at(part).empty()) return std::nullopt;
    const auto there = node(part, pipes_at(part).front());
    if (!there) return std::nullopt;
    aside = *there - *place;
  }
  Pose frame = Pose::Identity();
  frame.translation() = *place;
  frame.linear().col(0) = (aside - aside.dot(z) * z).normalized();
  frame.linear().col(1) = z.cross(frame.linear().col(0));
  frame.linear().col(2) = z;
  return frame;
}

std::optional<double> BuiltTruth::turn(const BuiltTruth& drawn, const std::string& datum,
                                       const std::string& from, const std::string& flange) const {
  const int part = member(flange), root = member(datum);
  if (part < 0 || root < 0) return std::nullopt;
  const PartSpec& spec = assembly_.members[static_cast<std::size_t>(part)].spec;
  if (spec.kind != PartKind::kFlange) return std::nullopt;
  const auto here = frame(root, from), there = drawn.frame(root, from);
  if (!here || !there) return std::nullopt;
  const Eigen::Matrix3d built = poses_[static_cast<std::size_t>(part)].linear();
  const Vector3d x = drawn.poses_[static_cast<std::size_t>(part)].linear().col(0);
  // Where the drawing would have its x, in the flange as it was built.
  const Vector3d wanted = built.transpose() * (here->linear() * (there->linear().transpose() * x));
  const double pitch = 2 * std::numbers::pi / sizes_of(spec.nps).holes;
  return std::remainder(-std::atan2(wanted.y(), wanted.x()), pitch);
}

}  // namespace spool::campaign
