// What else stands in the room: floor, walls, tables, stands, boxes, drums, pipes and frames.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/clutter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/campaign/labels.h"
#include "tools/campaign/spool_router.h"
#include "tools/campaign/standard_sizes.h"

namespace spool::campaign {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kClear = 0.03;  // m between things that do not belong together

Pose standing(const Vector3d& origin, double yaw_rad) {
  Pose pose(Eigen::AngleAxisd(yaw_rad, Vector3d::UnitZ()));
  pose.translation() = origin;
  return pose;
}

Eigen::AlignedBox3d box_of(const Placed& placed) {
  const Eigen::AlignedBox3d local = bounds(placed.patch);
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8; ++corner)
    box.extend(placed.T_scan_patch *
               local.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  return box;
}

// One thing being put together before it is known to fit.
using Item = std::vector<Placed>;

void add_patch(const Shape& shape, const Pose& pose, std::uint16_t label, Item& item) {
  item.push_back({Patch{shape}, pose, label, kNoInstance});
}

// In the item's own frame, standing on z = 0.
Item table(const Vector2d& half, double height, const Pose& T_scan_item) {
  constexpr double kTop = 0.04, kLeg = 0.03;
  Item item;
  const auto block = [&](const Vector3d& middle, const Vector3d& sides) {
    add_patch(Block{sides}, T_scan_item * Eigen::Translation3d(middle), kTable, item);
  };
  block({0, 0, height - kTop / 2}, {half.x(), half.y(), kTop / 2});
  const double leg = (height - kTop) / 2;
  for (const double x : {-half.x() + kLeg, half.x() - kLeg})
    for (const double y : {-half.y() + kLeg, half.y() - kLeg})
      block({x, y, leg}, {kLeg, kLeg, leg});
  return item;
}

Item drum(double radius, double height, const Pose& T_scan_item) {
  Item item;
  add_patch(Cylinder{radius, 0, height}, T_scan_item, kCylinder, item);
  add_patch(Annulus{0, radius}, T_scan_item * Eigen::Translation3d(0, 0, height), kCylinder, item);
  return item;
}

Item assembled(const Assembly& assembly, const Pose& T_scan_design, std::uint16_t label) {
  Item item;
  const std::vector<Pose> poses = poses_of(assembly);
  for (std::size_t i = 0; i < poses.size(); ++i)
    for (const Patch& patch : patches_of(assembly.members[i].spec))
      item.push_back({patch, T_scan_design * poses[i] * patch.T_part_patch, label, kNoInstance});
  return item;
}

// A length of pipe or a piece of somebody else's spool, lying on the ground or on a block.
Item other_pipe(double nps, const Vector2d& place, const Ground& ground, Random& random) {
  const double scale = ground.height > 0 ? 0.25 : 1;
  SpoolRouter r("other", nps);
  if (random.chance(0.4)) r.start_with_flange();
  r.pipe(scale * random.uniform(0.4, 1.6));
  if (random.chance(0.6)) {
    r.elbow(random.chance(0.75) ? 90 : 45, random.uniform(0, kTurn));
    r.pipe(scale * random.uniform(0.2, 0.8));
    if (random.chance(0.4)) r.flange();
  }
  // Upright now and then; else along the floor, rolled as it may lie.
  Pose lying = Pose::Identity();
  if (random.chance(0.75)) lying.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()));
  lying.prerotate(Eigen::AngleAxisd(random.uniform(0, kTurn), Vector3d::UnitZ()));
  Item item = assembled(r.assembly(), lying, kOtherPipe);
  Eigen::AlignedBox3d box;
  for (const Placed& placed : item) box.extend(box_of(placed));
  const double height = scale < 1 || random.chance(0.5) ? 0 : random.uniform(0.1, 0.8);
  const Vector3d shift(place.x() - box.center().x(), place.y() - box.center().y(),
                       ground.height + height - box.min().z());
  for (Placed& placed : item) placed.T_scan_patch.pretranslate(shift);
  if (height > 0) {
    const Vector3d half(0.08, 0.08, height / 2);
    add_patch(Block{half}, standing({place.x(), place.y(), height / 2}, 0), kStand, item);
  }
  return item;
}

// Two posts and a beam of the same tube as the box frame.
Item portal(const Pose& T_scan_item, Random& random) {
  constexpr double kWidth = 0.1;
  const double span = random.uniform(0.8, 2.0);
  const double height = random.uniform(1.0, 2.2);
  Assembly assembly{"portal", {}};
  const auto tube = [&](const Vector3d& from, const Vector3d& direction, double length) {
    Pose pose(Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), direction));
    pose.translation() = from;
    PartSpec spec{.kind = PartKind::kTube};
    spec.length_m = length;
    spec.width_m = kWidth;
    assembly.place(spec, pose);
  };
  tube({-span / 2, 0, 0}, Vector3d::UnitZ(), height);
  tube({span / 2, 0, 0}, Vector3d::UnitZ(), height);
  tube({-span / 2 + kWidth / 2, 0, height - kWidth / 2}, Vector3d::UnitX(), span - kWidth);
  return assembled(assembly, T_scan_item, kStructure);
}

Item random_item(const std::vector<double>& sizes, const Ground& ground, Random& random) {
  // Nearer the middle is likelier: even in the distance, not in the area.
  const double share = random.uniform();
  const double angle = random.uniform(0, kTurn);
  const Vector2d place =
      ground.middle + share * ground.half.cwiseProduct(Vector2d(std::cos(angle), std::sin(angle)));
  const Pose T_scan_item =
      standing({place.x(), place.y(), ground.height}, random.uniform(0, kTurn));
  // What lies on a table is hand-sized, and neither a table nor a frame.
  const bool small = ground.height > 0;
  const double scale = small ? 0.25 : 1;
  const double kind = random.uniform(0, small ? 0.87 : 1);
  if (kind < 0.40) {
    const Vector3d half(random.uniform(0.08, 0.5), random.uniform(0.08, 0.4),
                        random.uniform(0.05, 0.5));
    Item item;
    add_patch(Block{scale * half}, T_scan_item * Eigen::Translation3d(0, 0, scale * half.z()), kBox,
              item);
    return item;
  }
  if (kind < 0.60)
    return drum(scale * random.uniform(0.06, 0.3), scale * random.uniform(0.3, 1.2), T_scan_item);
  if (kind < 0.87) {
    const int size = random.below(static_cast<int>(sizes.size()));
    return other_pipe(sizes[static_cast<std::size_t>(size)], place, ground, random);
  }
  if (kind < 0.95)
    return table({random.uniform(0.4, 0.9), random.uniform(0.3, 0.45)}, random.uniform(0.7, 1.0),
                 T_scan_item);
  return portal(T_scan_item, random);
}

bool fits(const Item& item, const Ground& ground, const Room& room) {
  const Vector2d low = ground.middle - ground.half;
  const Vector2d high = ground.middle + ground.half;
  for (const Placed& placed : item) {
    const Eigen::AlignedBox3d box = box_of(placed);
    if (box.min().z() < ground.height - 0.001 ||
        (box.min().head<2>().array() < low.array()).any() ||
        (box.max().head<2>().array() > high.array()).any())
      return false;
    // Up to a table's top, and not into it.
    const Vector3d margin = Vector3d::Constant(kClear);
    Eigen::AlignedBox3d wide(box.min() - margin, box.max() + margin);
    wide.min().z() = std::max(wide.min().z(), ground.height + 1e-4);
    for (const Eigen::AlignedBox3d& taken : room.taken)
      if (wide.intersects(taken)) return false;
  }
  return true;
}

void put(const Item& item, Room& room) {
  for (const Placed& placed : item) {
    room.placed.push_back(placed);
    room.taken.push_back(box_of(placed));
  }
}

}  // namespace

void add_assembly(const Assembly& assembly, const std::vector<Pose>& T_scan_part,
                  std::uint16_t label, bool counted, std::uint8_t instance, Room& room) {
  for (std::size_t i = 0; i < assembly.members.size(); ++i) {
    if (assembly.members[i].missing) continue;
    const auto own = static_cast<std::uint16_t>(counted ? label + i : label);
    for (const Patch& patch : patches_of(assembly.members[i].spec)) {
      room.placed.push_back({patch, T_scan_part[i] * patch.T_part_patch, own, instance});
      room.taken.push_back(box_of(room.placed.back()));
    }
  }
}

void add_block(const Vector3d& middle, const Vector3d& half, double yaw_rad, std::uint16_t label,
               Room& room) {
  room.placed.push_back({Patch{Block{half}}, standing(middle, yaw_rad), label, kNoInstance});
}

void add_floor_and_walls(Room& room) {
  // In tiles, so that what lies far from the object can be left out of sampling.
  const auto tiled = [&](const Pose& pose, double half_x, double half_y, std::uint16_t label) {
    constexpr double kTile = 1.0;
    const int across = static_cast<int>(std::ceil(2 * half_x / kTile));
    const int up = static_cast<int>(std::ceil(2 * half_y / kTile));
    const Rectangle tile{half_x / across, half_y / up};
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < up; ++j) {
        const Eigen::Translation3d shift((2 * i + 1) * tile.x - half_x,
                                         (2 * j + 1) * tile.y - half_y, 0);
        room.placed.push_back({Patch{tile}, pose * shift, label, kNoInstance});
      }
  };
  tiled(Pose::Identity(), room.half_x, room.half_y, kFloor);
  const Vector3d up = Vector3d::UnitZ();
  for (int side = 0; side < 4; ++side) {
    const double angle = kTurn / 4 * side;
    const Vector3d in(-std::cos(angle), -std::sin(angle), 0);
    const bool along_x = side % 2 == 0;
    Pose pose = Pose::Identity();
    pose.linear().col(2) = in;
    pose.linear().col(1) = up;
    pose.linear().col(0) = up.cross(in);
    pose.translation() = -in * (along_x ? room.half_x : room.half_y) + up * room.height / 2;
    tiled(pose, along_x ? room.half_y : room.half_x, room.height / 2, kWall);
  }
}

void add_table(const Ground& top, Room& room) {
  put(table(top.half, top.height, standing({top.middle.x(), top.middle.y(), 0}, 0)), room);
}

void add_items(double area, const Ground& ground, const std::vector<double>& sizes, Random& random,
               Room& room) {
  for (int failures = 0; area > 0 && failures < 400;) {
    const Item item = random_item(sizes, ground, random);
    if (!fits(item, ground, room)) {
      ++failures;
      continue;
    }
    put(item, room);
    // About half of a thing is seen from the stations.
    for (const Placed& placed : item) area -= 0.5 * sampled_area(placed.patch);
  }
}

}  // namespace spool::campaign
