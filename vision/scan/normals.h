// Surface normals: from the image grid of an organised cloud, or from the neighbours of any cloud.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "vision/core/camera.h"
#include "vision/core/point_cloud.h"
#include "vision/scan/noise_model.h"
#include "vision/scan/point_index.h"

namespace spool {

// Fills `cloud.normals` of an organised cloud in the camera frame: plane through the pixel window,
// with neighbours left out that lie further off in depth than the sensor's noise explains (edges);
// unit, towards the camera; zero where fewer than a plane's worth of neighbours remain.
void estimate_organised_normals(PointCloud& cloud, const Camera& camera, const NoiseModel& noise);

// Fills `cloud.normals` by the plane through the k nearest neighbours (thesis 4.3.2, PCA). Turned
// towards `viewpoint` (cloud frame) where given, else consistently as they come (their sign means
// nothing).
void estimate_neighbour_normals(PointCloud& cloud, const PointIndex& index, int k,
                                const std::optional<Eigen::Vector3d>& viewpoint);

}  // namespace spool
