// Where labels go so that none lies on another, and few on a line.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/label_placement.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace spool::guide {
namespace {

using Eigen::Vector2d;

constexpr double kApart_mm = 0.5;         // between any two labels
constexpr double kClear_mm = 1.6;         // between the anchor and its label
constexpr double kLeader_mm = 3.2;        // from here on a label needs a leader
constexpr double kRing_mm = 2.5;          // from ring to ring
constexpr int kRings = 22, kPlaces = 24;  // 55 mm; every 15 degrees
constexpr double kLeaderOnLabel = 60;     // costs, in mm of leader
constexpr double kLeaderOnLine = 5;

Box2 box_at(const Vector2d& centre, const Vector2d& half) { return {centre - half, centre + half}; }

Box2 grown(const Box2& box, double by) {
  return {box.min() - Vector2d::Constant(by), box.max() + Vector2d::Constant(by)};
}

class Placer {
 public:
  Placer(const std::vector<LineToAvoid>& lines, const std::vector<Box2>& boxes, const Box2& area)
      : lines_(lines), boxes_(boxes), area_(area) {}

  PlacedLabel place(const LabelRequest& request) {
    best_ = {};
    least_ = std::numeric_limits<double>::infinity();
    if (request.may_cover_anchor) {
      consider(request, request.anchor, 0);
      for (const double share : {0.5, -0.5, 1.0, -1.0})
        consider(request, request.anchor + share * request.slide, std::abs(share));
    }
    for (int ring = 0; ring < kRings; ++ring) {
      const double reach = kClear_mm + kRing_mm * ring;
      if (reach > least_) break;  // all that follows costs more
      for (int k = 0; k < kPlaces; ++k) {
        const double angle = 2 * std::numbers::pi * k / kPlaces;
        const Vector2d out(std::cos(angle), -std::sin(angle));
        // The box begins `reach` from the anchor in that direction.
        const Vector2d half = request.half_size;
        const double depth = std::min(half.x() / std::max(std::abs(out.x()), 1e-9),
                                      half.y() / std::max(std::abs(out.y()), 1e-9));
        consider(request, request.anchor + (reach + depth) * out, reach);
      }
    }
    if (!best_.is_placed) anywhere(request);
    if (best_.is_placed) {
      boxes_.push_back(best_.box);
      if (best_.needs_leader) leaders_.push_back(best_.leader);
    }
    return best_;
  }

 private:
  void consider(const LabelRequest& request, const Vector2d& centre, double distance) {
    const Box2 box = box_at(centre, request.half_size);
    if (!area_.contains(box)) return;
    double cost = distance;
    if (cost >= least_) return;
    const Box2 room = grown(box, kApart_mm);
    for (const Box2& each : boxes_)
      if (room.intersects(each)) return;
    for (const Segment2& each : leaders_)
      if (length_within(each, grown(box, 0.3)) > 0) return;
    for (const LineToAvoid& each : lines_) {
      cost += each.cost * length_within(each.line, room);
      if (cost >= least_) return;
    }
    PlacedLabel label{box, true, false, {}};
    const Vector2d nearest = request.anchor.cwiseMax(box.min()).cwiseMin(box.max());
    label.leader = {request.anchor, nearest};
    label.needs_leader = (nearest - request.anchor).norm() > kLeader_mm;
    if (label.needs_leader) {
      // A leader starts at the line that it names: its first millimetre crosses nothing.
      const Vector2d along = (nearest - request.anchor).normalized();
      const Segment2 tested{request.anchor + 0.8 * along, nearest};
      for (const Box2& each : boxes_)
        if (length_within(tested, each) > 0) cost += kLeaderOnLabel;
      for (const Segment2& each : leaders_)
        if (crossing(tested, each)) cost += kLeaderOnLine;
      for (const LineToAvoid& each : lines_)
        if (crossing(tested, each.line)) cost += kLeaderOnLine * std::min(each.cost, 1.0);
    }
    if (cost >= least_) return;
    least_ = cost;
    best_ = label;
  }

  void anywhere(const LabelRequest& request) {
    const Vector2d step = (2 * request.half_size).cwiseMax(2.0);
    const Box2 room{area_.min() + request.half_size, area_.max() - request.half_size};
    if (room.isEmpty()) return;
    for (double y = room.min().y(); y <= room.max().y(); y += step.y())
      for (double x = room.min().x(); x <= room.max().x(); x += step.x())
        consider(request, {x, y}, (Vector2d(x, y) - request.anchor).norm());
  }

  const std::vector<LineToAvoid>& lines_;
  std::vector<Box2> boxes_;
  std::vector<Segment2> leaders_;
  Box2 area_;
  PlacedLabel best_;
  double least_ = 0;
};

}  // namespace

std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                      const std::vector<LineToAvoid>& lines,
                                      const std::vector<Box2>& boxes, const Box2& area) {
  Placer placer(lines, boxes, area);
  std::vector<PlacedLabel> placed;
  placed.reserve(requests.size());
  for (const LabelRequest& each : requests) placed.push_back(placer.place(each));
  return placed;
}

}  // namespace spool::guide
