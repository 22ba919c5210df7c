// PCL's global registrations: prerejective RANSAC over FPFH matches, and ObjRecRANSAC.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <cstdlib>
#include <list>

#include <fcntl.h>
#include <unistd.h>

#include <pcl/features/fpfh.h>
#include <pcl/point_types.h>
#include <pcl/recognition/ransac_based/obj_rec_ransac.h>
#include <pcl/registration/sample_consensus_prerejective.h>

#include "tools/compare/contender.h"
#include "tools/compare/pcl_cloud.h"

namespace spool::compare {
namespace {

using Point = pcl::PointNormal;
using Cloud = pcl::PointCloud<Point>;
using Features = pcl::PointCloud<pcl::FPFHSignature33>;

Features::Ptr features(const Cloud::Ptr& cloud, double radius_m) {
  pcl::FPFHEstimation<Point, Point, pcl::FPFHSignature33> estimation;
  estimation.setRadiusSearch(radius_m);
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(cloud);
  auto found = std::make_shared<Features>();
  estimation.compute(*found);
  return found;
}

// Numbers as in PCL's tutorial "Robust pose estimation of rigid objects".
std::optional<Pose> by_prerejective(const FindCase& of) {
  std::srand(of.seed);  // what it draws from
  const auto spacing_m = static_cast<float>(0.01 * of.size_m);
  const Cloud::Ptr design = to_pcl(of.design), scan = to_pcl(of.scan);
  pcl::SampleConsensusPrerejective<Point, Point, pcl::FPFHSignature33> align;
  align.setInputSource(design);
  align.setSourceFeatures(features(design, 5 * spacing_m));
  align.setInputTarget(scan);
  align.setTargetFeatures(features(scan, 5 * spacing_m));
  align.setMaximumIterations(50'000);
  align.setNumberOfSamples(3);
  align.setCorrespondenceRandomness(5);
  align.setSimilarityThreshold(0.9F);
  align.setMaxCorrespondenceDistance(2.5 * spacing_m);
  align.setInlierFraction(0.25F);
  Cloud moved;
  align.align(moved);
  if (!align.hasConverged()) return std::nullopt;
  return Pose(align.getFinalTransformation().cast<double>()).inverse();
}

// ObjRecRANSAC tells its progress on stdout, a number for each hypothesis: nowhere, while this
// lives.
class Silence {
 public:
  Silence() {
    std::fflush(stdout);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    close(nowhere);
  }
  ~Silence() {
    std::fflush(stdout);
    dup2(stdout_, STDOUT_FILENO);
    close(stdout_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int stdout_ = dup(STDOUT_FILENO);
};

// Its model library is hashed within the time taken: it keeps none between calls.
std::optional<Pose> by_obj_rec_ransac(const FindCase& of) {
  std::srand(of.seed);
  const auto to = [](const PointCloud& from, pcl::PointCloud<pcl::PointXYZ>& points,
                     pcl::PointCloud<pcl::Normal>& normals) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Eigen::Vector3f &p = from.points[i], &n = from.normals[i];
      points.emplace_back(p.x(), p.y(), p.z());
      normals.emplace_back(n.x(), n.y(), n.z());
    }
  };
  pcl::PointCloud<pcl::PointXYZ> design, scan;
  pcl::PointCloud<pcl::Normal> design_normals, scan_normals;
  to(of.design, design, design_normals);
  to(of.scan, scan, scan_normals);
  const Silence silence;
  // Pairs a fifth of the design apart, voxels as wide as the points are thinned to.
  pcl::recognition::ObjRecRANSAC finder(static_cast<float>(0.2 * of.size_m),
                                        static_cast<float>(0.015 * of.size_m));
  finder.addModel(design, design_normals, "design");
  std::list<pcl::recognition::ObjRecRANSAC::Output> found;
  finder.recognize(scan, scan_normals, found, 0.99);
  const pcl::recognition::ObjRecRANSAC::Output* best = nullptr;
  for (const auto& each : found)
    if (best == nullptr || each.match_confidence_ > best->match_confidence_) best = &each;
  if (best == nullptr) return std::nullopt;
  Pose T_scan_design = Pose::Identity();
  for (int i = 0; i < 3; ++i) {  // nine of the rotation, row by row, then the translation
    for (int j = 0; j < 3; ++j)
      T_scan_design.linear()(i, j) = double{best->rigid_transform_[3 * i + j]};
    T_scan_design.translation()[i] = double{best->rigid_transform_[9 + i]};
  }
  return T_scan_design.inverse();
}

}  // namespace

std::vector<FindContender> pcl_find() {
  return {{"PCL prerejective", by_prerejective}, {"PCL ObjRecRANSAC", by_obj_rec_ransac}};
}

}  // namespace spool::compare
