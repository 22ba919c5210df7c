// Bodies of components by kind, each in its part's frame.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "vision/piping/part_solid.h"

namespace spool::piping {

// Each sets T_file_part, solid and, where it has them, holes. False where the component's points do
// not make such a body; then nothing is set. Metres, radians.
[[nodiscard]] bool make_straight(const Component& component, PartShape& shape);
[[nodiscard]] bool make_elbow(const Component& component, PartShape& shape);
[[nodiscard]] bool make_reducer(const Component& component, PartShape& shape);
[[nodiscard]] bool make_cap(const Component& component, int weld_port, PartShape& shape);
[[nodiscard]] bool make_gasket(const Component& component, PartShape& shape);
[[nodiscard]] bool make_flange(const Component& component, PartShape& shape);
[[nodiscard]] bool make_stub_end(const Component& component, PartShape& shape);
[[nodiscard]] bool make_branched(const Component& component, PartShape& shape);
// On a run of this outside diameter, whose axis has this direction.
[[nodiscard]] bool make_olet(const Component& component, double run_diameter,
                             const Eigen::Vector3d& run_axis, PartShape& shape);
// A solid rod with discs where its ends are flanged (valves and the like), or rods from the middle
// to each end where they are not in line.
[[nodiscard]] bool make_rods(const Component& component, PartShape& shape);

// A frame at `origin` with this z; x as near to `x_hint` as can be, else natural: up, or north
// where z is vertical.
[[nodiscard]] Eigen::Isometry3d frame_at(
    const Eigen::Vector3d& origin, const Eigen::Vector3d& z,
    const std::optional<Eigen::Vector3d>& x_hint = std::nullopt);

}  // namespace spool::piping
