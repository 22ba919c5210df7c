// Points of a design that a fitter can find again on the steel.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/landmarks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spool {

namespace {

// The 26 directions from a cube's middle to its faces, edges and corners.
std::vector<Eigen::Vector3d> directions() {
  std::vector<Eigen::Vector3d> out;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) out.push_back(Eigen::Vector3d(x, y, z).normalized());
      }
    }
  }
  return out;
}

// How sure a finger finds such a point: a flange's sharp rim best, a smooth pipe worst.
double distinctness(PartKind kind) {
  switch (kind) {
    case PartKind::kFlange:
    case PartKind::kBlind:
    case PartKind::kValve:
    case PartKind::kStructure:
    case PartKind::kSupport:
      return 1.0;
    case PartKind::kElbow:
    case PartKind::kTee:
    case PartKind::kCross:
    case PartKind::kCap:
    case PartKind::kOlet:
    case PartKind::kOther:
      return 0.8;
    case PartKind::kPipe:
    case PartKind::kReducer:
    case PartKind::kGasket:
      break;
  }
  return 0.6;
}

std::string words(const Part& part) {
  const char* place = "outermost point";
  switch (part.kind) {
    case PartKind::kFlange:
    case PartKind::kBlind:
      place = "rim";
      break;
    case PartKind::kElbow:
      place = "outside of the bend";
      break;
    case PartKind::kPipe:
    case PartKind::kReducer:
      place = "edge of its end";
      break;
    case PartKind::kTee:
    case PartKind::kCross:
    case PartKind::kOlet:
      place = "edge of a branch";
      break;
    case PartKind::kCap:
      place = "crown";
      break;
    default:
      break;
  }
  return (part.kind == PartKind::kOther ? std::string() : std::string(name(part.kind)) + " ") +
         part.name + ", " + place;
}

struct Candidate {
  Landmark landmark;
  double weight = 1;
};

// The vertex of a part (or the point of a cloud design) furthest along a direction.
class Extremes {
 public:
  explicit Extremes(const DesignModel& design) : design_(design) {}

  [[nodiscard]] Eigen::Vector3d furthest(const Part& part, const Eigen::Vector3d& direction) const {
    const Eigen::Vector3f d = direction.cast<float>();
    Eigen::Vector3f best = Eigen::Vector3f::Zero();
    float reach = -std::numeric_limits<float>::infinity();
    const auto consider = [&](const Eigen::Vector3f& p) {
      if (const float r = d.dot(p); r > reach) {
        reach = r;
        best = p;
      }
    };
    if (design_.is_cloud()) {
      for (const Eigen::Vector3f& p : design_.cloud.points) consider(p);
    } else {
      for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count;
           ++t) {
        for (const std::uint32_t v : design_.mesh.triangles[t]) consider(design_.mesh.vertices[v]);
      }
    }
    return best.cast<double>();
  }

 private:
  const DesignModel& design_;
};

// Nothing of the design stands between the point and an eye far off against `look`.
bool is_visible(const DesignSurface& surface, const Eigen::Vector3d& point,
                const Eigen::Vector3d& look, double size) {
  const double lift = 2e-3 * size;  // off the surface the point itself lies on
  const Eigen::Vector3f from = (point - lift * look).cast<float>();
  return !surface.cast(from, (-look).cast<float>(), static_cast<float>(2 * size)).has_value();
}

double triangle_area(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

// Greedy: the widest pair, the largest triangle over it, then whatever is furthest from all chosen.
std::vector<std::size_t> spread(const std::vector<Candidate>& candidates, std::size_t count) {
  const auto at = [&](std::size_t i) -> const Eigen::Vector3d& {
    return candidates[i].landmark.position;
  };
  const auto weight = [&](std::size_t i) { return candidates[i].weight; };
  std::vector<std::size_t> chosen;
  double best = 0;
  std::array<std::size_t, 2> pair{};
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t j = i + 1; j < candidates.size(); ++j) {
      const double value = (at(i) - at(j)).norm() * weight(i) * weight(j);
      if (value > best) {
        best = value;
        pair = {i, j};
      }
    }
  }
  if (best <= 0) return chosen;
  const double length = (at(pair[0]) - at(pair[1])).norm();
  best = 0;
  std::size_t third = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double value = triangle_area(at(pair[0]), at(pair[1]), at(i)) * weight(i);
    if (value > best) {
      best = value;
      third = i;
    }
  }
  // A height under a hundredth of the length is a line for any finger.
  if (triangle_area(at(pair[0]), at(pair[1]), at(third)) < 0.005 * length * length) return chosen;
  chosen = {pair[0], pair[1], third};
  while (chosen.size() < count) {
    best = 0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const std::size_t c : chosen) nearest = std::min(nearest, (at(i) - at(c)).norm());
      if (nearest * weight(i) > best) {
        best = nearest * weight(i);
        next = i;
      }
    }
    if (best < 0.05 * length) break;  // the rest lies next to what is there
    chosen.push_back(next);
  }
  return chosen;
}

}  // namespace

LandmarkProposal propose_landmarks(const DesignModel& design, const DesignSurface& surface,
                                   std::size_t count) {
  LandmarkProposal out;
  const Eigen::AlignedBox3d bounds = design.bounds();
  if (bounds.isEmpty() || design.parts.empty() || count < 3) return out;
  const double size = bounds.diagonal().norm();
  const std::vector<Eigen::Vector3d> all_directions = directions();
  const Extremes extremes(design);

  std::vector<Candidate> candidates;
  for (std::size_t p = 0; p < design.parts.size(); ++p) {
    const Part& part = design.parts[p];
    if (!design.is_cloud() && part.triangle_count == 0) continue;
    for (const Eigen::Vector3d& direction : all_directions) {
      const Eigen::Vector3d point = extremes.furthest(part, direction);
      const bool known = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) {
        return (c.landmark.position - point).norm() < 0.01 * size;
      });
      // Outermost of its part, and nothing of another part over it.
      if (known || !is_visible(surface, point, -direction, size)) continue;
      candidates.push_back(
          {{point, static_cast<std::int32_t>(p), words(part)}, distinctness(part.kind)});
    }
  }
  // Each look has its own landmarks: those in sight from there. The largest triangle wins.
  double best = 0;
  for (const Eigen::Vector3d& look : all_directions) {
    std::vector<Candidate> in_sight;
    for (const Candidate& candidate : candidates) {
      if (is_visible(surface, candidate.landmark.position, look, size))
        in_sight.push_back(candidate);
    }
    const std::vector<std::size_t> chosen = spread(in_sight, count);
    if (chosen.size() < 3) continue;
    const auto at = [&](std::size_t i) { return in_sight[chosen[i]].landmark.position; };
    const Eigen::Vector3d across = (at(1) - at(0)).cross(at(2) - at(0));
    double value = std::abs(look.dot(across));
    for (std::size_t i = 0; i < 3; ++i) value *= in_sight[chosen[i]].weight;
    // From above rather than from below, as files have it: y or z up.
    value *= 1.0 - 0.35 * (look.y() + look.z());
    // A slanting look shows form; one along an axis, an outline.
    if (look.cwiseAbs().maxCoeff() > 0.9) value *= 0.7;
    if (value <= best) continue;
    best = value;
    out.look = look;
    out.landmarks.clear();
    for (const std::size_t i : chosen) out.landmarks.push_back(in_sight[i].landmark);
  }
  return out;
}

}  // namespace spool
