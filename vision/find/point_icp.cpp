// ICP from point to point, as the thesis refines its match with; else see vision/align/icp.h.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/point_icp.h"

#include <vector>

#include "vision/find/rigid_fit.h"

namespace spool {

Pose refine_point_to_point(const CloudView& model, const PointIndex& scan_index,
                           const CloudView& scan, const Pose& T_design_scan,
                           const PointIcpOptions& options) {
  Pose T_scan_design = T_design_scan.inverse();
  std::vector<Eigen::Vector3d> from, to;
  for (int round = 0; round < options.iterations; ++round) {
    from.clear();
    to.clear();
    const Eigen::Isometry3f T = T_scan_design.cast<float>();
    for (const Eigen::Vector3f& p : model.points) {
      const auto nearest = scan_index.nearest(T * p, static_cast<float>(options.reach_m));
      if (!nearest) continue;
      from.push_back(p.cast<double>());
      to.push_back(scan.points[nearest->index].cast<double>());
    }
    if (from.size() < 3) break;
    const Pose before = T_scan_design;
    T_scan_design = fit_rigid_motion(from, to);
    if ((before.matrix() - T_scan_design.matrix()).isZero(1e-12)) break;
  }
  return T_scan_design.inverse();
}

}  // namespace spool
