// Where an isometric draws each node: lengths not to scale, axes at 30 degrees, the side that hides
// least.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/isometric_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "vision/guide/plane_geometry.h"

namespace spool::guide {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSamePlace = 0.0015;  // m: coordinates this near are one level
constexpr double kLeastSkew_mm = 7;    // of each component of a skew leg, to be told apart
constexpr double kNear_mm = 4;         // what is drawn nearer than this is hard to tell apart
constexpr double kLargest = 2.0;       // a small spool is not blown up beyond this

// How long an edge wants to be drawn (mm).
double wanted_mm(const DesignModel& design, const CentreLine& line, int edge) {
  const LineEdge& own = line.edges[static_cast<std::size_t>(edge)];
  const double length = (line.nodes[static_cast<std::size_t>(own.to)].place -
                         line.nodes[static_cast<std::size_t>(own.from)].place)
                            .norm();
  switch (design.parts[static_cast<std::size_t>(own.part)].kind) {
    case PartKind::kPipe:
      return std::min(11 + 16 * std::sqrt(length), 60.0);
    case PartKind::kGasket:
      return 1;
    case PartKind::kFlange:
      return 4;
    case PartKind::kBlind:
    case PartKind::kCap:
    case PartKind::kOlet:
      return 4.5;
    case PartKind::kReducer:
      return 8;
    case PartKind::kValve:
      return 12;
    default:
      return 6.5;
  }
}

// One leg's claim on one axis.
struct Claim {
  std::size_t from = 0, to = 0;  // levels, from < to
  double least_mm = 0;
};

// The coordinates of one axis, each level once, and where they are drawn.
class Axis {
 public:
  explicit Axis(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    for (const double value : values)
      if (levels_.empty() || value - levels_.back() > kSamePlace) levels_.push_back(value);
  }
  [[nodiscard]] std::size_t level(double value) const {
    const auto next = std::upper_bound(levels_.begin(), levels_.end(), value + 1e-12);
    return next == levels_.begin() ? 0 : static_cast<std::size_t>(next - levels_.begin()) - 1;
  }
  void claim(double from, double to, double least_mm) {
    const std::size_t a = level(std::min(from, to)), b = level(std::max(from, to));
    if (a < b) claims_.push_back({a, b, least_mm});
  }
  // The longest path from below; then what only begins legs is moved up to them, so that neither
  // end of a leg that is free drifts away.
  void solve() {
    const std::size_t count = levels_.size();
    drawn_.assign(count, 0);
    for (std::size_t k = 1; k < count; ++k) {
      drawn_[k] = drawn_[k - 1] + step(k);
      for (const Claim& each : claims_)
        if (each.to == k) drawn_[k] = std::max(drawn_[k], drawn_[each.from] + each.least_mm);
    }
    for (std::size_t k = count - 1; k-- > 0;) {
      double highest = drawn_[k + 1] - step(k + 1);
      bool only_begins = true;
      for (const Claim& each : claims_) {
        if (each.from == k) highest = std::min(highest, drawn_[each.to] - each.least_mm);
        only_begins = only_begins && each.to != k;
      }
      if (only_begins) drawn_[k] = std::max(drawn_[k], highest);
    }
  }
  [[nodiscard]] double drawn(double value) const { return drawn_[level(value)]; }

 private:
  [[nodiscard]] double step(std::size_t k) const {
    return std::min(0.6 + 12 * (levels_[k] - levels_[k - 1]), 4.0);
  }
  std::vector<double> levels_, drawn_;
  std::vector<Claim> claims_;
};

std::vector<bool> key_nodes(const CentreLine& line) {
  std::vector<bool> is_key(line.nodes.size(), false);
  for (const LineRun& run : line.runs)
    for (const int node : {run.nodes.front(), run.nodes.back()})
      is_key[static_cast<std::size_t>(node)] = true;
  return is_key;
}

// Calls visit(run, first, last) for each stretch of a run between two key nodes.
template <class Visit>
void each_stretch(const CentreLine& line, const std::vector<bool>& is_key, const Visit& visit) {
  for (const LineRun& run : line.runs) {
    std::size_t first = 0;
    for (std::size_t n = 1; n < run.nodes.size(); ++n) {
      if (!is_key[static_cast<std::size_t>(run.nodes[n])]) continue;
      visit(run, first, n);
      first = n;
    }
  }
}

std::vector<Vector3d> compressed(const DesignModel& design, const CentreLine& line) {
  const std::vector<bool> is_key = key_nodes(line);
  const auto place = [&](int node) { return line.nodes[static_cast<std::size_t>(node)].place; };
  std::vector<Axis> axes;
  for (int a = 0; a < 3; ++a) {
    std::vector<double> values;
    for (std::size_t n = 0; n < line.nodes.size(); ++n)
      if (is_key[n]) values.push_back(line.nodes[n].place[a]);
    axes.emplace_back(std::move(values));
  }
  each_stretch(line, is_key, [&](const LineRun& run, std::size_t first, std::size_t last) {
    double wanted = 0;
    for (std::size_t e = first; e < last; ++e) wanted += wanted_mm(design, line, run.edges[e]);
    for (int a = 0; a < 3; ++a) {
      const double share = std::abs(run.direction[a]);
      if (share < 0.01) continue;
      const bool is_whole_leg = wanted > 2 * kLeastSkew_mm;
      axes[static_cast<std::size_t>(a)].claim(
          place(run.nodes[first])[a], place(run.nodes[last])[a],
          is_whole_leg ? std::max(wanted * share, kLeastSkew_mm) : wanted * share);
    }
  });
  for (Axis& axis : axes) axis.solve();
  std::vector<Vector3d> drawn(line.nodes.size(), Vector3d::Zero());
  for (std::size_t n = 0; n < line.nodes.size(); ++n) {
    if (!is_key[n]) continue;
    for (int a = 0; a < 3; ++a)
      drawn[n][a] = axes[static_cast<std::size_t>(a)].drawn(line.nodes[n].place[a]);
  }
  each_stretch(line, is_key, [&](const LineRun& run, std::size_t first, std::size_t last) {
    double whole = 0, so_far = 0;
    for (std::size_t e = first; e < last; ++e) whole += wanted_mm(design, line, run.edges[e]);
    const Vector3d from = drawn[static_cast<std::size_t>(run.nodes[first])];
    const Vector3d to = drawn[static_cast<std::size_t>(run.nodes[last])];
    for (std::size_t n = first + 1; n < last; ++n) {
      so_far += wanted_mm(design, line, run.edges[n - 1]);
      drawn[static_cast<std::size_t>(run.nodes[n])] = from + so_far / whole * (to - from);
    }
  });
  return drawn;
}

// How much of the drawing hides something else, in crossings.
double hidden(const CentreLine& line, const std::vector<Vector2d>& places) {
  double sum = 0;
  const auto at = [&](int node) { return places[static_cast<std::size_t>(node)]; };
  for (std::size_t a = 0; a < line.runs.size(); ++a) {
    if (line.runs[a].is_skew) {
      // A skew leg that is drawn like a straight one has but its hatching to tell it apart.
      const Vector2d leg =
          (at(line.runs[a].nodes.back()) - at(line.runs[a].nodes.front())).normalized();
      for (const double degrees : {30.0, 90.0, 150.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        if (std::abs(cross(leg, {std::cos(angle), std::sin(angle)})) < 0.1) sum += 0.5;
      }
    }
    for (std::size_t b = a + 1; b < line.runs.size(); ++b) {
      const LineRun &one = line.runs[a], &other = line.runs[b];
      const Segment2 first{at(one.nodes.front()), at(one.nodes.back())};
      const Segment2 second{at(other.nodes.front()), at(other.nodes.back())};
      const bool meet = std::any_of(one.nodes.begin(), one.nodes.end(), [&](int node) {
        return std::find(other.nodes.begin(), other.nodes.end(), node) != other.nodes.end();
      });
      if (!meet && crossing(first, second)) sum += 1;
      // Legs on one another: the length over which they are too near, also of legs that meet.
      const Vector2d along = (first.b - first.a).normalized();
      if (std::abs(cross(along, (second.b - second.a).normalized())) > 0.2) continue;
      if (std::abs(cross(along, second.a - first.a)) > kNear_mm) continue;
      const double length = (first.b - first.a).norm();
      double low = along.dot(second.a - first.a), high = along.dot(second.b - first.a);
      if (low > high) std::swap(low, high);
      sum += 0.3 * std::max(0.0, std::min(high, length) - std::max(low, 0.0));
    }
  }
  return sum;
}

}  // namespace

Eigen::Matrix<double, 2, 3> isometric_axes(int quarter) {
  const double c = std::sqrt(3.0) / 2, s = 0.5;
  Eigen::Matrix<double, 2, 3> axes;
  axes.col(2) = Vector2d(0, -1);
  const Vector2d right_down(c, s), right_up(c, -s);
  const Vector2d turned[4] = {right_down, right_up, -right_down, -right_up};
  axes.col(0) = turned[quarter % 4];
  axes.col(1) = turned[(quarter + 1) % 4];
  return axes;
}

Vector3d towards_eye(int quarter) {
  const Eigen::Matrix<double, 2, 3> axes = isometric_axes(quarter);
  const Vector3d first = axes.row(0), second = axes.row(1);
  const Vector3d eye = first.cross(second).normalized();
  return eye.z() < 0 ? Vector3d(-eye) : eye;
}

IsometricLayout lay_out(const DesignModel& design, const CentreLine& line, const Box2& area) {
  IsometricLayout layout;
  layout.drawn = compressed(design, line);
  double least = std::numeric_limits<double>::infinity();
  for (const int quarter : {0, 1, 3, 2}) {
    const Eigen::Matrix<double, 2, 3> axes = isometric_axes(quarter);
    std::vector<Vector2d> places;
    for (const Vector3d& each : layout.drawn) places.emplace_back(axes * each);
    const double score = hidden(line, places) + (quarter >= 2 ? 1.5 : 0.01 * quarter);
    if (score >= least - 1e-9) continue;
    least = score;
    layout.quarter = quarter;
    layout.places = std::move(places);
  }
  Box2 extent;
  for (const Vector2d& each : layout.places) extent.extend(each);
  const Vector2d size = extent.sizes().cwiseMax(1.0);
  layout.scale = std::min(kLargest, area.sizes().cwiseQuotient(size).minCoeff());
  for (Vector3d& each : layout.drawn) each *= layout.scale;
  for (Vector2d& each : layout.places)
    each = area.center() + layout.scale * (each - extent.center());
  return layout;
}

}  // namespace spool::guide
