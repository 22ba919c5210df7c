// Bodies with branches: a run with outlets, and a branch fitting that sits on a run.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/branch_solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spool::piping {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kClear = 1e-5;  // m that an edge keeps from the ends, so that no triangle is flat

// The outlet's own frame: its axis d, and y and e that span its circles (right-handed).
struct OutletFrame {
  Eigen::Vector3d d, e;
  explicit OutletFrame(const Outlet& outlet)
      : d(std::sin(outlet.angle), 0, std::cos(outlet.angle)),
        e(-std::cos(outlet.angle), 0, std::sin(outlet.angle)) {}
  [[nodiscard]] Eigen::Vector3d on_circle(double radius, double phi) const {
    return radius * (std::cos(phi) * Eigen::Vector3d::UnitY() + std::sin(phi) * e);
  }
};

// The curve in which a cylinder of `radius` about the outlet's axis meets the run's cylinder of
// `run_radius`, on the outlet's side; nothing where it does not lie between `down` and `up` or not
// below the outlet's end.
std::optional<std::vector<Eigen::Vector3d>> meeting_curve(const Outlet& outlet, double radius,
                                                          double run_radius, const RunTube& run,
                                                          int sides) {
  if (!(radius > 0) || radius > run_radius * (1 + 1e-9) || !(std::sin(outlet.angle) > 0.1))
    return std::nullopt;
  const OutletFrame frame(outlet);
  std::vector<Eigen::Vector3d> curve;
  for (int k = 0; k < sides; ++k) {
    const Eigen::Vector3d base = frame.on_circle(radius, kTurn * k / sides);
    const double x = std::sqrt(std::max(run_radius * run_radius - base.y() * base.y(), 0.0));
    const double t = (x - base.x()) / frame.d.x();
    const Eigen::Vector3d point = base + t * frame.d;
    if (t > outlet.length - kClear || point.z() < -run.down + kClear || point.z() > run.up - kClear)
      return std::nullopt;
    curve.push_back(point);
  }
  return curve;
}

std::vector<Eigen::Vector3d> end_circle(const Outlet& outlet, double radius, double distance,
                                        int sides) {
  const OutletFrame frame(outlet);
  std::vector<Eigen::Vector3d> circle;
  circle.reserve(static_cast<std::size_t>(sides));
  for (int k = 0; k < sides; ++k)
    circle.emplace_back(distance * frame.d + frame.on_circle(radius, kTurn * k / sides));
  return circle;
}

void turn_over(std::vector<Eigen::Vector3d>& points) {  // half a turn about z
  for (Eigen::Vector3d& p : points) p = {-p.x(), -p.y(), p.z()};
}

// A line along the run's wall from its lower end to its upper one. Where an outlet cuts it, `low`
// and `high` are the cut's ends; elsewhere both are one vertex on the line.
struct Column {
  double angle = 0;
  std::uint32_t bottom = 0, low = 0, high = 0, top = 0;
};

// One of the two walls (outer or inner) of a branched run.
struct Wall {
  std::vector<Column> columns;
  std::vector<Loop> outlet_ends;
  [[nodiscard]] Loop ends(bool top) const {
    Loop loop;
    for (const Column& each : columns) loop.push_back(top ? each.top : each.bottom);
    return loop;
  }
  [[nodiscard]] std::vector<double> angles() const {
    std::vector<double> all;
    for (const Column& each : columns) all.push_back(each.angle);
    return all;
  }
};

std::uint32_t add_vertex(Solid& solid, const Eigen::Vector3d& point) {
  solid.vertices.push_back(point);
  return static_cast<std::uint32_t>(solid.vertices.size() - 1);
}

class WallBuilder {
 public:
  WallBuilder(Solid& solid, const RunTube& run, double radius, bool is_outer)
      : solid_(solid), run_(run), radius_(radius), is_outer_(is_outer) {}

  // The columns through an outlet's edge, from its side of lesser angle to the other.
  void add_cut(const Outlet& outlet, const std::vector<Eigen::Vector3d>& curve,
               double outlet_radius, double from_angle) {
    const auto sides = static_cast<int>(curve.size());
    std::vector<Eigen::Vector3d> points = curve;
    std::vector<Eigen::Vector3d> end = end_circle(outlet, outlet_radius, outlet.length, sides);
    if (outlet.opposite) {
      turn_over(points);
      turn_over(end);
    }
    Loop edge = add_loop(solid_, points);
    const Loop mouth = add_loop(solid_, end);
    const auto angle_at = [&](std::size_t j) {
      return from_angle + std::asin(std::clamp(curve[j].y() / radius_, -1.0, 1.0));
    };
    // Two outlets as wide as the run touch at the side: they share that column.
    const std::size_t first = curve.size() / 2;  // phi = pi, y least
    const bool shares_first = touches_before(angle_at(first));
    const bool shares_last = touches_after(angle_at(0));
    if (shares_first) edge[first] = wall_.columns.back().low;
    if (shares_last) edge[0] = wall_.columns.front().low;
    strip(edge, mouth);
    wall_.outlet_ends.push_back(mouth);
    for (std::size_t c = 0; c <= first; ++c) {
      const std::size_t j = first - c;
      const bool is_there = (c == 0 && shares_first) || (j == 0 && shares_last);
      if (!is_there) add_column(angle_at(j), edge[(curve.size() - j) % curve.size()], edge[j]);
    }
  }

  // Columns between two angles, ends excluded, with a vertex each on the line between the cuts.
  void add_plain(double from, double to, double z_from, double z_to) {
    const int steps =
        std::max(1, static_cast<int>(std::ceil((to - from) / kTurn * sides_of(radius_))));
    for (int i = 1; i < steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      const double angle = from + share * (to - from);
      const std::uint32_t middle = add_vertex(
          solid_,
          {radius_ * std::cos(angle), radius_ * std::sin(angle), z_from + share * (z_to - z_from)});
      add_column(angle, middle, middle);
    }
  }

  Wall close() {
    const std::size_t count = wall_.columns.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Column& a = wall_.columns[i];
      const Column& b = wall_.columns[(i + 1) % count];
      quad(a.bottom, b.bottom, b.low, a.low);
      quad(a.high, b.high, b.top, a.top);
    }
    return std::move(wall_);
  }

 private:
  [[nodiscard]] bool touches_before(double angle) const {
    return !wall_.columns.empty() && std::abs(wall_.columns.back().angle - angle) < 1e-7;
  }
  [[nodiscard]] bool touches_after(double angle) const {
    return !wall_.columns.empty() && std::abs(wall_.columns.front().angle + kTurn - angle) < 1e-7;
  }
  void add_column(double angle, std::uint32_t low, std::uint32_t high) {
    const Eigen::Vector3d at(radius_ * std::cos(angle), radius_ * std::sin(angle), 0);
    const std::uint32_t bottom = add_vertex(solid_, at - run_.down * Eigen::Vector3d::UnitZ());
    const std::uint32_t top = add_vertex(solid_, at + run_.up * Eigen::Vector3d::UnitZ());
    wall_.columns.push_back({angle, bottom, low, high, top});
  }
  void strip(const Loop& lower, const Loop& upper) {
    if (is_outer_)
      add_strip(solid_, lower, upper);
    else
      add_strip(solid_, upper, lower);
  }
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const auto put = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
      if (p != q && q != r && r != p)
        solid_.triangles.push_back(is_outer_ ? Triangle{p, q, r} : Triangle{p, r, q});
    };
    put(a, b, c);
    put(a, c, d);
  }

  Solid& solid_;
  const RunTube& run_;
  double radius_;
  bool is_outer_;
  Wall wall_;
};

// Where a cut ends: its angle from its outlet's direction, and its height there.
struct CutEnd {
  double half_angle = 0, z = 0;
};

std::optional<Wall> add_wall(Solid& solid, const RunTube& run, std::span<const Outlet> outlets,
                             bool is_outer) {
  const double radius = is_outer ? run.outer : run.inner;
  std::vector<std::vector<Eigen::Vector3d>> curves;
  std::vector<CutEnd> cuts;
  for (const Outlet& outlet : outlets) {
    const double own = is_outer ? outlet.outer : outlet.inner;
    const auto curve = meeting_curve(outlet, own, radius, run, sides_of(outlet.outer));
    if (!curve) return std::nullopt;
    curves.push_back(*curve);
    cuts.push_back({std::asin(std::min(own / radius, 1.0)), curve->front().z()});
  }
  constexpr double kHalf = std::numbers::pi;
  WallBuilder builder(solid, run, radius, is_outer);
  const auto radius_of = [&](const Outlet& outlet) {
    return is_outer ? outlet.outer : outlet.inner;
  };
  builder.add_cut(outlets[0], curves[0], radius_of(outlets[0]), 0);
  if (outlets.size() == 1) {
    builder.add_plain(cuts[0].half_angle, kTurn - cuts[0].half_angle, cuts[0].z, cuts[0].z);
  } else {
    builder.add_plain(cuts[0].half_angle, kHalf - cuts[1].half_angle, cuts[0].z, cuts[1].z);
    builder.add_cut(outlets[1], curves[1], radius_of(outlets[1]), kHalf);
    builder.add_plain(kHalf + cuts[1].half_angle, kTurn - cuts[0].half_angle, cuts[1].z, cuts[0].z);
  }
  return builder.close();
}

}  // namespace

bool add_branched_run(Solid& solid, const RunTube& run, std::span<const Outlet> outlets) {
  const bool is_fit = !outlets.empty() && outlets.size() <= 2 && run.inner > 0 &&
                      run.inner < run.outer && !outlets[0].opposite &&
                      (outlets.size() == 1 || outlets[1].opposite);
  if (!is_fit) return false;
  Solid fresh;  // nothing is added where it cannot be
  const std::optional<Wall> outer = add_wall(fresh, run, outlets, true);
  if (!outer) return false;
  const std::optional<Wall> inner = add_wall(fresh, run, outlets, false);
  if (!inner) return false;
  add_zip(fresh, outer->ends(true), outer->angles(), inner->ends(true), inner->angles());
  add_zip(fresh, inner->ends(false), inner->angles(), outer->ends(false), outer->angles());
  for (std::size_t i = 0; i < outlets.size(); ++i)
    add_strip(fresh, outer->outlet_ends[i], inner->outlet_ends[i]);
  const auto first = static_cast<std::uint32_t>(solid.vertices.size());
  solid.vertices.insert(solid.vertices.end(), fresh.vertices.begin(), fresh.vertices.end());
  for (Triangle triangle : fresh.triangles) {
    for (std::uint32_t& vertex : triangle) vertex += first;
    solid.triangles.push_back(triangle);
  }
  return true;
}

bool add_saddle_branch(Solid& solid, double run_radius, double base, const Outlet& outlet) {
  const RunTube endless{run_radius, 0, 1e3, 1e3};
  const int sides = sides_of(std::max(base, outlet.outer));
  if (!(outlet.inner > 0) || outlet.inner >= std::min(base, outlet.outer)) return false;
  const auto foot = meeting_curve(outlet, base, run_radius, endless, sides);
  const auto bore = meeting_curve(outlet, outlet.inner, run_radius, endless, sides);
  if (!foot || !bore) return false;
  // The foot narrows half way up from its highest point.
  const OutletFrame frame(outlet);
  double highest = 0;
  for (const Eigen::Vector3d& point : *foot) highest = std::max(highest, point.dot(frame.d));
  const double shoulder = (highest + outlet.length) / 2;
  const Loop foot_loop = add_loop(solid, *foot);
  const Loop neck = add_loop(solid, end_circle(outlet, outlet.outer, shoulder, sides));
  const Loop end = add_loop(solid, end_circle(outlet, outlet.outer, outlet.length, sides));
  const Loop end_inner = add_loop(solid, end_circle(outlet, outlet.inner, outlet.length, sides));
  const Loop bore_loop = add_loop(solid, *bore);
  add_strip(solid, foot_loop, neck);
  add_strip(solid, neck, end);
  add_strip(solid, end, end_inner);
  add_strip(solid, end_inner, bore_loop);
  add_strip(solid, bore_loop, foot_loop);
  return true;
}

}  // namespace spool::piping
