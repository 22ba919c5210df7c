// A small spool made from formulas, and what a depth camera would see of it: what the pictures
// show.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/render/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace spool::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 0.05715;  // m; NPS 4
constexpr double kBend = 0.1524;     // m; long-radius elbow
constexpr double kStraight = 0.30;   // m
constexpr int kAround = 48;

// Appends a grid of (rows + 1) x (columns + 1) points as triangles of a part.
void append_grid(Scene& scene, Part part, int rows, int columns,
                 const std::function<Eigen::Vector3d(double, double)>& at) {
  const auto first = static_cast<std::uint32_t>(scene.mesh.vertices.size());
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c <= columns; ++c) {
      scene.mesh.vertices.push_back(
          at(static_cast<double>(r) / rows, static_cast<double>(c) / columns).cast<float>());
    }
  }
  const auto index = [&](int r, int c) {
    return first + static_cast<std::uint32_t>(r * (columns + 1) + c);
  };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      scene.mesh.triangles.push_back({index(r, c), index(r, c + 1), index(r + 1, c + 1)});
      scene.mesh.triangles.push_back({index(r, c), index(r + 1, c + 1), index(r + 1, c)});
      scene.part.insert(scene.part.end(), 2, part);
    }
  }
}

// A solid of revolution about +z through `centre`: rings of (radius, z), outwards wound.
void append_lathe(Scene& scene, Part part, const Eigen::Vector3d& centre,
                  const std::vector<Eigen::Vector2d>& profile, int around) {
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    append_grid(scene, part, 1, around, [&](double along, double turn) {
      const Eigen::Vector2d p = (1 - along) * profile[i] + along * profile[i + 1];
      const double angle = 2 * kPi * turn;
      return Eigen::Vector3d(
          centre + Eigen::Vector3d(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()));
    });
  }
}

double edge(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

}  // namespace

Scene make_spool() {
  Scene scene;
  append_grid(scene, kPipe, 8, kAround, [](double along, double turn) {
    const double angle = 2 * kPi * turn;
    return Eigen::Vector3d(kStraight * along, kRadius * std::cos(angle), kRadius * std::sin(angle));
  });
  append_grid(scene, kElbow, 24, kAround, [](double along, double turn) {
    const double bend = 0.5 * kPi * along;
    const double angle = 2 * kPi * turn;
    const double out = kBend - kRadius * std::sin(angle);  // from the bend's axis, which is +-y
    return Eigen::Vector3d(kStraight + out * std::sin(bend), kRadius * std::cos(angle),
                           kBend - out * std::cos(bend));
  });
  const double x = kStraight + kBend;
  append_lathe(scene, kFlange, {x, 0, kBend},
               {{kRadius, 0},
                {kRadius, 0.03},
                {0.067, 0.10},
                {0.1145, 0.10},
                {0.1145, 0.125},
                {0.0785, 0.125},
                {0.0785, 0.127},
                {0.051, 0.127},
                {0.051, 0.02}},
               kAround);
  for (int stud = 0; stud < 8; ++stud) {
    const double angle = (stud + 0.5) * kPi / 4;
    append_lathe(scene, kFlange, {x + 0.09525 * std::cos(angle), 0.09525 * std::sin(angle), kBend},
                 {{0.008, 0.08}, {0.008, 0.155}, {0.0, 0.155}}, 12);
  }
  return scene;
}

Measured measure(const Scene& scene, const render::View& view,
                 const std::function<double(Part, const Eigen::Vector3d&)>& deviation_m,
                 double floor_z) {
  const Camera& camera = view.camera;
  struct Hit {
    double z = std::numeric_limits<double>::infinity();
    int triangle = -1;
  };
  std::vector<Hit> hits(static_cast<std::size_t>(camera.width) *
                        static_cast<std::size_t>(camera.height));
  const auto corner = [&](std::size_t t, std::size_t c) -> Eigen::Vector3d {
    return scene.mesh.vertices[scene.mesh.triangles[t][c]].cast<double>();
  };
  for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
    std::array<Eigen::Vector3d, 3> p;
    std::array<Eigen::Vector2d, 3> pixel;
    for (std::size_t c = 0; c < 3; ++c) {
      p[c] = view.T_camera_design * corner(t, c);
      pixel[c] = camera.project(p[c]);
    }
    const double area = edge(pixel[0], pixel[1], pixel[2]);
    if (std::abs(area) < 1e-9) continue;
    const auto [x0, x1] = std::minmax({pixel[0].x(), pixel[1].x(), pixel[2].x()});
    const auto [y0, y1] = std::minmax({pixel[0].y(), pixel[1].y(), pixel[2].y()});
    const int last_x = std::min(camera.width - 1, static_cast<int>(x1));
    const int last_y = std::min(camera.height - 1, static_cast<int>(y1));
    for (int v = std::max(0, static_cast<int>(std::ceil(y0))); v <= last_y; ++v) {
      for (int u = std::max(0, static_cast<int>(std::ceil(x0))); u <= last_x; ++u) {
        const Eigen::Vector2d here(u, v);
        const double a = edge(pixel[1], pixel[2], here) / area;
        const double b = edge(pixel[2], pixel[0], here) / area;
        if (a < 0 || b < 0 || a + b > 1) continue;
        const double z = 1 / (a / p[0].z() + b / p[1].z() + (1 - a - b) / p[2].z());
        Hit& hit = hits[static_cast<std::size_t>(v * camera.width + u)];
        if (z < hit.z) hit = {z, static_cast<int>(t)};
      }
    }
  }

  Measured measured;
  const auto append = [&measured](const Eigen::Vector3d& p, double deviation, int point_class) {
    measured.points.push_back(p.cast<float>());
    measured.deviation.push_back(static_cast<float>(deviation));
    measured.classes.push_back(static_cast<std::uint8_t>(point_class));
  };
  const Pose T_design_camera = view.T_camera_design.inverse();
  const Eigen::Vector3d eye = T_design_camera.translation();
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Hit& hit = hits[static_cast<std::size_t>(v * camera.width + u)];
      if (hit.triangle >= 0) {
        const auto t = static_cast<std::size_t>(hit.triangle);
        const Eigen::Vector3d p = T_design_camera * camera.back_project(u, v, hit.z);
        Eigen::Vector3d normal =
            (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).normalized();
        if (normal.dot(eye - p) < 0) normal = -normal;
        const double deviation = deviation_m(static_cast<Part>(scene.part[t]), p);
        append(p + deviation * normal, deviation, 1);
        continue;
      }
      const Eigen::Vector3d ray = T_design_camera.linear() * camera.back_project(u, v, 1.0);
      const double range = (floor_z - eye.z()) / ray.z();
      if (floor_z > -1e6 && range > 0 && range < 3) {
        append(eye + range * ray, std::numeric_limits<double>::quiet_NaN(), 0);
      }
    }
  }
  return measured;
}

render::View spool_view(int width, int height) {
  const Scene scene = make_spool();
  Eigen::AlignedBox3d bounds;
  for (const auto& vertex : scene.mesh.vertices) bounds.extend(vertex.cast<double>());
  return render::view_of(bounds, {-0.45, 0.85, -0.5}, Eigen::Vector3d::UnitZ(), width, height);
}

}  // namespace spool::test
