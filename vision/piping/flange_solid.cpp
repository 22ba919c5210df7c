// The body of a flange: plate with its bolt holes, raised face, hub and bore.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/flange_solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spool::piping {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kLand = 0.006;    // m, straight piece at a welding neck's end
constexpr double kNoHub = 0.0005;  // m; a lower one is the plate's back

// The sector of the plate that belongs to one hole, its centre at (c, 0): bounded by the rim, the
// two lines half way to the next holes and a chord x = x0. It is star-shaped about the hole's
// centre, so rays from there join its outline with the hole.
struct Ray {
  double direction = 0;
  double x = 0, y = 0;  // where it meets the outline
  bool on_rim = false, on_chord = false;
  int partner =
      -1;  // on the line to the next hole: the next sector's ray that meets the same point
};

struct Sector {
  double c, x0, rim, half_pitch;

  // How far the outline is from the hole's centre.
  [[nodiscard]] double reach(double direction) const {
    const double dx = std::cos(direction);
    const double dy = std::sin(direction);
    double best = -c * dx + std::sqrt(c * c * dx * dx - (c * c - rim * rim));
    if (dx < 0) best = std::min(best, (x0 - c) / dx);
    for (const double side : {1.0, -1.0}) {
      const double nx = -std::sin(half_pitch);
      const double speed = dx * nx + dy * side * std::cos(half_pitch);
      if (speed > 1e-12) best = std::min(best, -c * nx / speed);
    }
    return best;
  }

  [[nodiscard]] std::vector<Ray> rays(int count) const {
    std::vector<double> directions;
    for (int i = 0; i < count; ++i) directions.push_back(kTurn * i / count - std::numbers::pi);
    for (const double side : {1.0, -1.0}) {
      directions.push_back(std::atan2(side * x0 * std::tan(half_pitch), x0 - c));
      directions.push_back(
          std::atan2(side * rim * std::sin(half_pitch), rim * std::cos(half_pitch) - c));
    }
    std::sort(directions.begin(), directions.end());
    directions.erase(std::unique(directions.begin(), directions.end(),
                                 [](double a, double b) { return b - a < 1e-9; }),
                     directions.end());
    std::vector<Ray> rays;
    const auto same = [](double a, double b) { return std::abs(a - b) < 1e-9; };
    for (const double direction : directions) {
      const double t = reach(direction);
      Ray ray{direction, c + t * std::cos(direction), t * std::sin(direction)};
      ray.on_rim = same(std::hypot(ray.x, ray.y), rim);
      ray.on_chord = same(ray.x, x0);
      rays.push_back(ray);
    }
    for (Ray& high : rays) {
      if (!same(std::atan2(high.y, high.x), half_pitch)) continue;
      for (std::size_t low = 0; low < rays.size(); ++low) {
        if (same(rays[low].x, high.x) && same(rays[low].y, -high.y))
          high.partner = static_cast<int>(low);
      }
    }
    return rays;
  }
};

// One side of the plate, between the rim and an inner circle.
struct Plate {
  Loop rim, inner;
  std::vector<Loop> holes;  // each anticlockwise seen from +z
};

Loop circle_at(Solid& solid, double radius, double z, int sides) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translation().z() = z;
  return add_circle(solid, frame, radius, sides);
}

// Adds the side at a height; `faces_up` to +z.
Plate add_plate(Solid& solid, const FlangeSize& size, double z, double inner_radius, int sides,
                bool faces_up) {
  const double c = size.bolt_circle / 2;
  const Sector sector{c, (inner_radius + c - size.hole / 2) / 2, size.outside_diameter / 2,
                      kTurn / 2 / size.holes};
  // Few holes have wide sectors, whose rim needs as many points.
  const int count = size.holes <= 4 ? 48 : size.holes <= 8 ? 32 : 24;
  const std::vector<Ray> rays = sector.rays(count);
  std::vector<std::size_t> chord;  // rays on the chord, by angle about the axis
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rays[i].on_chord && rays[i].partner < 0) chord.push_back(i);
  }
  std::sort(chord.begin(), chord.end(),
            [&](std::size_t a, std::size_t b) { return rays[a].y < rays[b].y; });
  std::vector<Loop> own(static_cast<std::size_t>(size.holes), Loop(rays.size(), 0));
  Plate plate;
  Loop polygon;
  std::vector<double> polygon_angles;
  for (int k = 0; k < size.holes; ++k) {
    const double turn = sector.half_pitch * (2 * k + 1);
    const auto place = [&](double x, double y) {
      solid.vertices.emplace_back(x * std::cos(turn) - y * std::sin(turn),
                                  x * std::sin(turn) + y * std::cos(turn), z);
      return static_cast<std::uint32_t>(solid.vertices.size() - 1);
    };
    Loop& outline = own[static_cast<std::size_t>(k)];
    Loop hole;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (rays[i].partner < 0) outline[i] = place(rays[i].x, rays[i].y);
      if (rays[i].partner < 0 && rays[i].on_rim) plate.rim.push_back(outline[i]);
      hole.push_back(place(c + size.hole / 2 * std::cos(rays[i].direction),
                           size.hole / 2 * std::sin(rays[i].direction)));
    }
    for (const std::size_t i : chord) {
      polygon.push_back(outline[i]);
      polygon_angles.push_back(turn + std::atan2(rays[i].y, rays[i].x));
    }
    plate.holes.push_back(std::move(hole));
  }
  for (std::size_t k = 0; k < own.size(); ++k) {
    Loop outline = own[k];
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (rays[i].partner >= 0)
        outline[i] = own[(k + 1) % own.size()][static_cast<std::size_t>(rays[i].partner)];
    }
    add_strip(solid, faces_up ? outline : plate.holes[k], faces_up ? plate.holes[k] : outline);
  }
  plate.inner = circle_at(solid, inner_radius, z, sides);
  std::vector<double> inner_angles;
  for (int i = 0; i < sides; ++i) inner_angles.push_back(kTurn * i / sides);
  if (faces_up)
    add_zip(solid, polygon, polygon_angles, plate.inner, inner_angles);
  else
    add_zip(solid, plate.inner, inner_angles, polygon, polygon_angles);
  return plate;
}

// From the front's inner circle over face, bore, weld end and hub to the back's inner circle.
void add_middle(Solid& solid, const FlangeBody& body, double face_radius, double thickness,
                const Plate& front, const Plate& back) {
  const int sides = static_cast<int>(front.inner.size());
  const double end = -std::max(body.length, thickness);
  Loop from = front.inner;
  const auto go_to = [&](double radius, double z) {
    const Loop to = circle_at(solid, radius, z, sides);
    add_strip(solid, from, to);
    from = to;
  };
  if (body.has_raised_face) go_to(face_radius, 0);
  if (body.bore == 0) {
    add_fan(solid, from, {0, 0, 0});
    Loop under = back.inner;
    std::reverse(under.begin(), under.end());
    add_fan(solid, under, {0, 0, -thickness});
    return;
  }
  go_to(body.bore / 2, 0);
  double bore = body.bore / 2;
  if (body.counterbore > 0) {
    go_to(bore, end + body.counterbore_depth);
    bore = body.counterbore / 2;
    go_to(bore, end + body.counterbore_depth);
  }
  go_to(bore, end);
  const double hub = -thickness - end;
  if (hub > kNoHub) {
    go_to(body.hub_end / 2, end);
    go_to(body.hub_end / 2, end + std::min(kLand, hub / 2));
  }
  add_strip(solid, from, back.inner);
}

}  // namespace

void add_flange(Solid& solid, const FlangeSize& size, const FlangeBody& body) {
  const double face = size.raised_face / 2;
  const double hub = size.hub / 2;
  const int sides = sides_of(std::max(face, hub));
  const double front_z = body.has_raised_face ? -kRaisedFaceHeight : 0.0;
  const Plate front = add_plate(solid, size, front_z, face, sides, true);
  const Plate back = add_plate(solid, size, -size.thickness, hub, sides, false);
  add_strip(solid, back.rim, front.rim);
  for (std::size_t k = 0; k < front.holes.size(); ++k)
    add_strip(solid, front.holes[k], back.holes[k]);
  add_middle(solid, body, face, size.thickness, front, back);
}

}  // namespace spool::piping
