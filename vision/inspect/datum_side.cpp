// The pose that the datum's side of a spool has.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/datum_side.h"

#include <algorithm>

namespace spool {
namespace {

// Of a part's points at the old pose: with as many at the new one it is where both have it, as a
// pipe is that was only slid along itself.
constexpr double kAsMany = 0.85;
constexpr std::size_t kFewPoints = 10;
constexpr double kSamePose = 0.02;  // of the size, mean displacement

std::vector<std::size_t> points_on_parts(const DesignModel& design,
                                         const Explanation& explanation) {
  std::vector<std::size_t> points(design.parts.size(), 0);
  for (const std::int32_t part : explanation.deviations.part)
    if (part >= 0) ++points[static_cast<std::size_t>(part)];
  return points;
}

// Adds to `is_held` what is joined to it, part by part, as long as `is_there`.
void grow(const DesignModel& design, const std::vector<std::uint8_t>& is_there,
          std::vector<std::uint8_t>& is_held) {
  for (bool grows = true; grows;) {
    grows = false;
    for (const Joint& joint : design.joints) {
      const auto a = static_cast<std::size_t>(joint.part_a);
      const auto b = static_cast<std::size_t>(joint.part_b);
      if (is_held[a] == is_held[b]) continue;
      const std::size_t next = is_held[a] != 0 ? b : a;
      if (is_there[next] == 0) continue;
      is_held[next] = 1;
      grows = true;
    }
  }
}

}  // namespace

std::optional<DatumSide> datum_side(const ExplainedDesign& design, const ExplainedScan& scan,
                                    const Explanation& explanation, const Watch& watch) {
  if (design.model.datums.empty() || watch.cancelled()) return std::nullopt;
  const std::vector<std::size_t> before = points_on_parts(design.model, explanation);
  const std::vector<Piece> pieces =
      moved_pieces(design, scan, explanation, datum_sides(design.model), 1, watch);
  if (pieces.empty()) return std::nullopt;
  DatumSide side;
  side.T_new_old = pieces.front().motion.inverse();
  if (pieces.front().fault == PieceFault::kExchanged) side.held_by = HeldBy::kShape;
  side.is_held.assign(design.model.parts.size(), 0);
  for (const int part : pieces.front().parts) side.is_held[static_cast<std::size_t>(part)] = 1;
  // What the new pose explains as well as the old one holds it too.
  const PointCloud moved_scan = moved(scan.design, side.T_new_old);
  const Explanation there =
      explain_surface(design, {moved_scan, scan.noise_m, scan.oriented_normals}, watch);
  const std::vector<std::size_t> after = points_on_parts(design.model, there);
  std::vector<std::uint8_t> is_there(after.size(), 0);
  for (std::size_t p = 0; p < after.size(); ++p)
    is_there[p] = after[p] >= kFewPoints &&
                          static_cast<double>(after[p]) >= kAsMany * static_cast<double>(before[p])
                      ? 1
                      : 0;
  grow(design.model, is_there, side.is_held);
  return side;
}

bool is_of_a_piece(const Pose& T_other, const Pose& T_found, const std::vector<Piece>& pieces,
                   const ExplainedDesign& design) {
  const double same = kSamePose * design.model.bounds().diagonal().norm();
  const std::vector<Eigen::Vector3f>& samples = design.samples.cloud.points;
  // Where the other pose has the design, in the frame of the found one.
  const Pose move = T_found * T_other.inverse();
  return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t s = 0; s < samples.size(); ++s) {
      if (std::find(piece.parts.begin(), piece.parts.end(), design.samples.part[s]) ==
          piece.parts.end())
        continue;
      const Eigen::Vector3d p = samples[s].cast<double>();
      sum += (move * p - piece.motion * p).norm();
      ++count;
    }
    return count > 0 && sum < same * static_cast<double>(count);
  });
}

}  // namespace spool
