// Which way each end of a component looks, from its own points or from what it is joined to.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/port_directions.h"

#include <cmath>
#include <optional>

namespace spool::piping {
namespace {

constexpr double kNoLength = 1e-6;  // m

Eigen::Vector3d unit_or_zero(const Eigen::Vector3d& v) {
  return v.norm() > kNoLength ? Eigen::Vector3d(v.normalized()) : Eigen::Vector3d::Zero();
}

bool is_eccentric(const Component& component) {
  return component.keyword.find("ECCENTRIC") != std::string::npos;
}

// The axis of a straight piece; an eccentric reducer's ends lie off it, towards or from its flat
// side.
Eigen::Vector3d axis_of(const Component& component) {
  Eigen::Vector3d along = component.ends[1].position - component.ends[0].position;
  if (is_eccentric(component) && component.flat_side)
    along -= along.dot(*component.flat_side) * *component.flat_side;
  return unit_or_zero(along);
}

bool has_bend(const Component& component) {
  return component.kind == ComponentKind::kElbow || component.kind == ComponentKind::kTee ||
         component.kind == ComponentKind::kCross || component.kind == ComponentKind::kValve ||
         component.kind == ComponentKind::kInstrument || component.kind == ComponentKind::kLink;
}

const Eigen::Vector3d& direction_at(const Pipework& pipework, int component, int port) {
  return pipework.components[static_cast<std::size_t>(component)]
      .directions[static_cast<std::size_t>(port)];
}

// The joint at a port, seen from it: what stands opposite.
struct Opposite {
  int component = -1, port = 0;
};
std::vector<std::vector<Opposite>> opposites_of(const Pipework& pipework) {
  std::vector<std::vector<Opposite>> all(pipework.components.size());
  for (std::size_t c = 0; c < all.size(); ++c)
    all[c].resize(static_cast<std::size_t>(port_count(pipework.components[c])));
  for (const PipeJoint& joint : pipework.joints) {
    if (joint.port_a == kOnRun) continue;
    all[static_cast<std::size_t>(joint.a)][static_cast<std::size_t>(joint.port_a)] = {joint.b,
                                                                                      joint.port_b};
    all[static_cast<std::size_t>(joint.b)][static_cast<std::size_t>(joint.port_b)] = {joint.a,
                                                                                      joint.port_a};
  }
  return all;
}

// Where two lines come within `tolerance` of each other; nothing where they do not, or are
// parallel.
std::optional<Eigen::Vector3d> crossing(const Eigen::Vector3d& p, const Eigen::Vector3d& u,
                                        const Eigen::Vector3d& q, const Eigen::Vector3d& v,
                                        double tolerance) {
  const double cosine = u.dot(v);
  const double determinant = 1 - cosine * cosine;
  if (determinant < 1e-4) return std::nullopt;
  const Eigen::Vector3d between = q - p;
  const double s = (between.dot(u) - cosine * between.dot(v)) / determinant;
  const double t = (cosine * between.dot(u) - between.dot(v)) / determinant;
  if ((p + s * u - q - t * v).norm() > tolerance) return std::nullopt;
  return (p + s * u + q + t * v) / 2;
}

void find_centre(Pipework& pipework, int index, const std::vector<Opposite>& opposite) {
  Component& elbow = pipework.components[static_cast<std::size_t>(index)];
  if (elbow.kind != ComponentKind::kElbow || elbow.centre || elbow.ends.size() != 2) return;
  std::optional<Eigen::Vector3d> centre;
  if (opposite[0].component >= 0 && opposite[1].component >= 0) {
    const Eigen::Vector3d& u = direction_at(pipework, opposite[0].component, opposite[0].port);
    const Eigen::Vector3d& v = direction_at(pipework, opposite[1].component, opposite[1].port);
    if (u.norm() > 0.5 && v.norm() > 0.5)
      centre = crossing(elbow.ends[0].position, u, elbow.ends[1].position, v, 0.002);
  }
  if (centre) {
    elbow.centre = PipePoint{*centre, 0, 0, "", elbow.line};
    elbow.directions = own_directions(elbow);
  }
  pipework.problems.push_back(
      {elbow.line,
       mention(elbow) + (centre ? " has no CENTRE-POINT; its centre is taken where the axes of its "
                                  "neighbours meet"
                                : " has no CENTRE-POINT and its neighbours do not tell it; it is "
                                  "drawn straight")});
}

int face_of(const Pipework& pipework, const Component& flange,
            const std::vector<Opposite>& opposite) {
  if (flange.ends.size() == 1) return 0;
  for (int p = 0; p < 2; ++p) {
    if (flange.ends[static_cast<std::size_t>(p)].end == "FL") return p;
  }
  for (int p = 0; p < 2; ++p) {
    if (!flange.ends[static_cast<std::size_t>(p)].end.empty()) return 1 - p;
  }
  for (int p = 0; p < 2; ++p) {
    const int other = opposite[static_cast<std::size_t>(p)].component;
    if (other < 0) continue;
    switch (pipework.components[static_cast<std::size_t>(other)].kind) {
      case ComponentKind::kGasket:
      case ComponentKind::kFlange:
      case ComponentKind::kBlind:
        return p;
      case ComponentKind::kPipe:
      case ComponentKind::kElbow:
      case ComponentKind::kTee:
      case ComponentKind::kReducer:
        return 1 - p;
      default:
        break;
    }
  }
  return 1;  // writers give the weld end first
}

}  // namespace

std::vector<Eigen::Vector3d> own_directions(const Component& component) {
  std::vector<Eigen::Vector3d> out(static_cast<std::size_t>(port_count(component)),
                                   Eigen::Vector3d::Zero());
  const std::size_t ends = component.ends.size();
  const bool is_bent = component.centre && has_bend(component);
  if (!is_bent && ends == 2) {
    out[1] = axis_of(component);
    out[0] = -out[1];
  }
  for (std::size_t p = 0; p < out.size(); ++p) {
    if (!component.centre || (p < ends && !is_bent)) continue;
    out[p] =
        unit_or_zero(port_of(component, static_cast<int>(p)).position - component.centre->position);
  }
  return out;
}

void complete_directions(Pipework& pipework) {
  const auto opposites = opposites_of(pipework);
  for (std::size_t c = 0; c < pipework.components.size(); ++c)
    find_centre(pipework, static_cast<int>(c), opposites[c]);
  // Twice: a gasket without length may stand between the end and what tells its direction.
  for (int round = 0; round < 2; ++round) {
    for (std::size_t c = 0; c < pipework.components.size(); ++c) {
      Component& each = pipework.components[c];
      const bool may_be_off_axis = is_eccentric(each) && !each.flat_side && each.ends.size() == 2;
      for (std::size_t p = 0; p < each.directions.size(); ++p) {
        const Opposite& other = opposites[c][p];
        if (other.component < 0) continue;
        if (each.directions[p].norm() > 0.5 && !may_be_off_axis) continue;
        const Eigen::Vector3d& towards = direction_at(pipework, other.component, other.port);
        if (towards.norm() < 0.5) continue;
        each.directions[p] = -towards;
        // The far end of a straight piece without length looks the other way.
        if (each.ends.size() == 2 && p < 2 &&
            (may_be_off_axis || each.directions[1 - p].norm() < 0.5))
          each.directions[1 - p] = towards;
      }
    }
  }
  for (std::size_t c = 0; c < pipework.components.size(); ++c) {
    Component& each = pipework.components[c];
    const bool has_face = each.kind == ComponentKind::kFlange ||
                          each.kind == ComponentKind::kStubEnd ||
                          each.kind == ComponentKind::kBlind;
    if (has_face && !each.ends.empty()) each.face = face_of(pipework, each, opposites[c]);
  }
}

}  // namespace spool::piping
