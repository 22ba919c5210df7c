// What a depth camera saw in each direction: whether a place is seen through, hidden, or not looked
// at.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace spool {

enum class Seen {
  kNot,      // the camera read nothing there, or does not look there
  kThere,    // it read a surface about where the place is
  kThrough,  // it read what lies behind: there is nothing at the place
  kHidden    // it read what lies before
};

// One depth image's points as a coarse image of nearest and farthest. Immutable, any thread.
class Sight {
 public:
  // `scan`: m, in the frame of a camera at its origin that looks along +z; NaN allowed.
  explicit Sight(std::span<const Eigen::Vector3f> scan);

  // Careful: a place counts as seen through where all readings round its direction lie further off
  // than it by more than `gate_m` (along z), and as hidden where all lie nearer.
  [[nodiscard]] Seen at(const Eigen::Vector3f& place, float gate_m) const;

 private:
  struct Cell {
    float nearest, farthest;  // m along z; empty: nearest > farthest
  };
  [[nodiscard]] std::size_t index_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  // Column and row; nothing outside the image or behind the camera.
  [[nodiscard]] bool cell_of(const Eigen::Vector3f& place, int& column, int& row) const;

  Eigen::Array2f low_ = Eigen::Array2f::Zero();  // x/z, y/z of the image's corner
  float cells_per_unit_ = 0;
  int columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
};

// Of some places of a surface, how many a camera saw something at, and how many it saw through.
struct Sighted {
  std::size_t there = 0, through = 0, others = 0;

  // A place of a surface that would face the camera (m, camera frame; unit normal); what looks away
  // is not counted.
  void look(const Sight& sight, const Eigen::Vector3f& place, const Eigen::Vector3f& normal,
            float gate_m) {
    constexpr float kFacing = 0.3F;  // cosine; seen at less than 73 degrees from head on
    if (-normal.dot(place.normalized()) > kFacing) add(sight.at(place, gate_m));
  }
  void add(Seen seen) {
    ++(seen == Seen::kThere ? there : seen == Seen::kThrough ? through : others);
  }
  // Of those that were looked at; 1 where none was.
  [[nodiscard]] double share_there() const {
    return there + through == 0 ? 1.0
                                : static_cast<double>(there) / static_cast<double>(there + through);
  }
};

}  // namespace spool
