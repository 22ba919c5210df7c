// From where an overlay is drawn so that a few pictures together show every part.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/view_choice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spool::evidence {
namespace {

constexpr std::size_t kMinViews = 2;
constexpr std::size_t kMaxViews = 6;
constexpr std::size_t kMaxItems = 4000;  // surface points looked at in all: 0.1 s of ray casts
constexpr std::size_t kMinMeasured =
    16;  // fewer measured points say too little of where a part was seen
constexpr double kShownShare = 0.5;  // of what the best direction shows
constexpr double kFacing = 0.17;     // cosine: seen at less than 80 degrees from head on

// A point of a part's surface that a picture should show.
struct Item {
  Eigen::Vector3f point;
  Eigen::Vector3f normal;
};

// Every `step`-th of `all`, so that `limit` are left at most.
std::vector<Item> thinned(const std::vector<Item>& all, std::size_t limit) {
  const std::size_t step = std::max<std::size_t>(1, (all.size() + limit - 1) / limit);
  std::vector<Item> kept;
  for (std::size_t i = 0; i < all.size(); i += step) kept.push_back(all[i]);
  return kept;
}

// Each piece that is elsewhere, and steel that should not be there, is to be shown as a part is.
// Which way a point of it faces is not known.
void add_contradicting(const Inspection& inspection, std::size_t limit,
                       std::vector<std::vector<Item>>& items) {
  const auto add = [&](const std::vector<std::uint32_t>& places) {
    std::vector<Item> points;
    for (const std::uint32_t i : places)
      points.push_back({inspection.scan_design.points[i], Eigen::Vector3f::Zero()});
    items.push_back(thinned(points, limit));
  };
  for (const Piece& piece : inspection.pieces) add(piece.points);
  for (const Unexpected& unexpected : inspection.unexpected) add(unexpected.points);
}

// What of each part there is to show.
std::vector<std::vector<Item>> evidence_of(const InspectionRecord& record) {
  const auto& design = *record.design;
  const auto& inspection = record.inspection;
  const auto& points = inspection.scan_design.points;
  const std::size_t parts = design.model.parts.size();
  std::vector<std::vector<Item>> measured(parts);
  const bool judged = inspection.deviations.part.size() == points.size() &&
                      inspection.deviations.distance_m.size() == points.size();
  // At most a few thousand closest-point queries: every part keeps enough of a thinned scan.
  const std::size_t step = std::max<std::size_t>(1, points.size() / (20 * kMaxItems));
  for (std::size_t i = 0; judged && i < points.size(); i += step) {
    const std::int32_t part = inspection.deviations.part[i];
    if (part < 0 || static_cast<std::size_t>(part) >= parts) continue;
    const float distance = std::abs(inspection.deviations.distance_m[i]);
    if (!std::isfinite(distance)) continue;
    const auto surface = design.surface->closest(points[i], 1.1F * distance + 1e-3F);
    if (surface)
      measured[static_cast<std::size_t>(part)].push_back({surface->point, surface->normal});
  }
  std::vector<std::vector<Item>> nominal(parts);
  for (std::size_t i = 0; i < design.samples.part.size(); ++i) {
    const std::int32_t part = design.samples.part[i];
    const auto& cloud = design.samples.cloud;
    const Eigen::Vector3f normal = cloud.has_normals() ? cloud.normals[i] : Eigen::Vector3f::Zero();
    if (part >= 0 && static_cast<std::size_t>(part) < parts)
      nominal[static_cast<std::size_t>(part)].push_back({cloud.points[i], normal});
  }
  const std::size_t limit =
      std::clamp<std::size_t>(kMaxItems / std::max<std::size_t>(parts, 1), 8, 64);
  std::vector<std::vector<Item>> items(parts);
  for (std::size_t p = 0; p < parts; ++p)
    items[p] = thinned(measured[p].size() >= kMinMeasured ? measured[p] : nominal[p], limit);
  add_contradicting(inspection, limit, items);
  return items;
}

// Which of `items` face a picture looking along `direction` with no design in between.
std::vector<bool> visible_items(const std::vector<Item>& items, const DesignSurface& surface,
                                const Eigen::Vector3f& direction, float size) {
  std::vector<bool> visible;
  for (const auto& item : items) {
    // A normal of length zero is one not known: such a point counts from every side.
    const bool faces = item.normal.squaredNorm() < 0.5F || -item.normal.dot(direction) > kFacing;
    const Eigen::Vector3f from = item.point + 1e-3F * size * (0.5F * item.normal - direction);
    visible.push_back(faces && !surface.cast(from, -direction, size));
  }
  return visible;
}

// One candidate: of each part, which items it shows and their share.
struct Sight {
  std::vector<std::vector<bool>> visible;
  std::vector<double> share;
};

// The share of items in `sight` that are not in `seen` yet.
double fresh_share(const std::vector<bool>& sight, const std::vector<bool>& seen) {
  std::size_t fresh = 0;
  for (std::size_t i = 0; i < sight.size(); ++i) fresh += sight[i] && !seen[i] ? 1U : 0U;
  return sight.empty() ? 0 : static_cast<double>(fresh) / static_cast<double>(sight.size());
}

// Upwards in the picture: the design's y if that does not waste the picture, else the axis that
// fills it best.
Eigen::Vector3d best_up(const Eigen::AlignedBox3d& bounds, const Eigen::Vector3d& direction,
                        double aspect) {
  const std::array<Eigen::Vector3d, 3> axes = {Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(),
                                               Eigen::Vector3d::UnitX()};
  const Eigen::Vector3d size = bounds.sizes();
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double best_fill = 0;
  for (const auto& axis : axes) {
    if (std::abs(axis.dot(direction)) > 0.9) continue;
    const Eigen::Vector3d up = (axis - axis.dot(direction) * direction).normalized();
    const Eigen::Vector3d right = direction.cross(up);
    const double height = size.dot(up.cwiseAbs());
    const double width = size.dot(right.cwiseAbs());
    const double fill = 1.0 / std::max({width / aspect, height, 1e-9});
    // A later axis has to be clearly better: pictures that agree on what is up are easier to
    // compare.
    if (fill > 1.3 * best_fill) {
      best_fill = fill;
      best = up;
    }
  }
  return best;
}

std::string axes_text(const Eigen::Vector3d& direction) {
  std::string text = "seen from";
  const char* names = "xyz";
  for (int i = 0; i < 3; ++i)
    if (std::abs(direction(i)) > 0.3)
      text += std::string(direction(i) < 0 ? " +" : " -") + names[i];
  return text;
}

std::vector<ViewChoice> candidates(const InspectionRecord& record, double aspect) {
  const Eigen::AlignedBox3d bounds = record.design->model.bounds();
  std::vector<ViewChoice> views;
  if (record.scan.frame >= 0 && record.inspection.alignment.found) {
    // The camera frame: z forward, y down.
    const Eigen::Matrix3d turn = record.inspection.alignment.T_design_scan.linear();
    views.push_back({turn.col(2), -turn.col(1), "seen from where the sensor was"});
  }
  // Corners before edges before faces: an oblique picture shows three sides of a part.
  for (int axes = 3; axes >= 1; --axes)
    for (int x = 1; x >= -1; --x)
      for (int y = 1; y >= -1; --y)
        for (int z = 1; z >= -1; --z) {
          if (std::abs(x) + std::abs(y) + std::abs(z) != axes) continue;
          const Eigen::Vector3d direction = -Eigen::Vector3d(x, y, z).normalized();
          views.push_back({direction, best_up(bounds, direction, aspect), axes_text(direction)});
        }
  return views;
}

std::vector<Sight> sights_of(const std::vector<ViewChoice>& views,
                             const std::vector<std::vector<Item>>& items,
                             const DesignSurface& surface, float size) {
  std::vector<Sight> sights(views.size());
  for (std::size_t v = 0; v < views.size(); ++v)
    for (const auto& part : items) {
      sights[v].visible.push_back(
          visible_items(part, surface, views[v].direction.cast<float>(), size));
      const auto& visible = sights[v].visible.back();
      sights[v].share.push_back(fresh_share(visible, std::vector<bool>(visible.size(), false)));
    }
  return sights;
}

// What is left to show while pictures are chosen.
class Cover {
 public:
  Cover(const std::vector<std::vector<Item>>& items, const std::vector<Sight>& sights)
      : best_(items.size(), 0.0), shown_(items.size(), false) {
    for (const auto& part : items) seen_.emplace_back(part.size(), false);
    for (const auto& sight : sights)
      for (std::size_t p = 0; p < best_.size(); ++p) best_[p] = std::max(best_[p], sight.share[p]);
  }

  // Parts that `sight` would show for the first time.
  [[nodiscard]] std::size_t new_parts(const Sight& sight) const {
    std::size_t count = 0;
    for (std::size_t p = 0; p < best_.size(); ++p) count += !shown_[p] && shows(sight, p) ? 1U : 0U;
    return count;
  }
  // Evidence that it would show for the first time, every part counting as one.
  [[nodiscard]] double new_evidence(const Sight& sight) const {
    double sum = 0;
    for (std::size_t p = 0; p < best_.size(); ++p) sum += fresh_share(sight.visible[p], seen_[p]);
    return sum;
  }
  void take(const Sight& sight) {
    for (std::size_t p = 0; p < best_.size(); ++p) {
      if (shows(sight, p)) shown_[p] = true;
      for (std::size_t i = 0; i < seen_[p].size(); ++i)
        seen_[p][i] = seen_[p][i] || sight.visible[p][i];
    }
  }

 private:
  [[nodiscard]] bool shows(const Sight& sight, std::size_t p) const {
    return best_[p] > 0 && sight.share[p] >= kShownShare * best_[p];
  }
  std::vector<double> best_;  // share in the direction best for the part
  std::vector<bool> shown_;
  std::vector<std::vector<bool>> seen_;
};

}  // namespace

std::vector<ViewChoice> choose_views(const InspectionRecord& record, double aspect) {
  const auto views = candidates(record, aspect);
  const auto items = evidence_of(record);
  const auto size = static_cast<float>(record.design->model.bounds().diagonal().norm());
  const auto sights = sights_of(views, items, *record.design->surface, size);
  Cover cover(items, sights);
  std::vector<ViewChoice> chosen;
  while (chosen.size() < kMaxViews) {
    std::size_t winner = 0;
    for (std::size_t v = 1; v < views.size(); ++v) {
      const auto parts = cover.new_parts(sights[v]);
      const auto most = cover.new_parts(sights[winner]);
      const double gain = cover.new_evidence(sights[v]) - cover.new_evidence(sights[winner]);
      if (parts > most || (parts == most && gain > 1e-9)) winner = v;
    }
    const bool nothing_new = cover.new_parts(sights[winner]) == 0;
    const bool enough = chosen.size() >= kMinViews;
    const bool no_evidence = cover.new_evidence(sights[winner]) <= 0;
    if (nothing_new && !chosen.empty() && (enough || no_evidence)) break;
    chosen.push_back(views[winner]);
    cover.take(sights[winner]);
  }
  return chosen;
}

}  // namespace spool::evidence
