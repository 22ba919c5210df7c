// The main path: align, declutter, measure, judge.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspector.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "vision/core/stage_clock.h"
#include "vision/design/exterior.h"
#include "vision/inspect/datum_side.h"
#include "vision/inspect/explanation.h"
#include "vision/inspect/judge.h"
#include "vision/inspect/missing_parts.h"
#include "vision/inspect/scan_alignment.h"
#include "vision/inspect/spool_findings.h"
#include "vision/measure/bolt_holes.h"
#include "vision/measure/bumps.h"
#include "vision/measure/dimensions.h"
#include "vision/measure/fit_up.h"
#include "vision/measure/gauge_check.h"
#include "vision/measure/gauges.h"
#include "vision/measure/joint_errors.h"
#include "vision/measure/judge_dimensions.h"
#include "vision/measure/part_poses.h"
#include "vision/measure/sensor_findings.h"
#include "vision/measure/warp_check.h"

namespace spool {
namespace {

constexpr int kMostWrongJoints = 3;  // between the largest piece and the datum
constexpr std::size_t kModelSamples =
    12000;  // as many as the thesis's model had (12 061, Table 5-1)

bool has_finite_point(const PointCloud& scan) {
  return std::any_of(scan.points.begin(), scan.points.end(),
                     [](const Eigen::Vector3f& p) { return p.allFinite(); });
}

// The placement that the datum's side has, refined by what it holds.
void take_side(const DatumSide& side, const Alignment& alignment, const DesignModel& design,
               const PointCloud& scan, Placement& placement) {
  placement.T_design_scan =
      side.T_new_old * between_local(alignment.T_design_scan, design.origin, scan.origin);
  placement.is_held = side.is_held;
  placement.held_by = side.held_by;
  placement.alternatives.clear();  // they were of the other piece
}

// A piece that is elsewhere makes no second pose of the whole.
void drop_pieces(const std::vector<Piece>& pieces, const PreparedDesign& design,
                 const PointCloud& scan, Alignment& alignment) {
  if (pieces.empty() || alignment.alternatives.empty() || !design.finder) return;
  const auto local = [&](const Pose& T) {
    return between_local(T, design.model.origin, scan.origin);
  };
  const Pose T_found = local(alignment.T_design_scan);
  std::vector<Pose>& others = alignment.alternatives;
  std::erase_if(others, [&](const Pose& other) {
    return is_of_a_piece(local(other), T_found, pieces,
                         {design.model, *design.surface, design.samples});
  });
  alignment.ambiguous = !others.empty();
  alignment.is_symmetric = std::all_of(others.begin(), others.end(), [&](const Pose& other) {
    return design.finder->are_symmetric(T_found, local(other));
  });
}

// How the camera saw the design; nothing of a scan that is not one camera's.
std::optional<DesignInSight> in_sight(const InspectorOptions& options, const PointCloud& scan,
                                      const DesignModel& design, const Alignment& alignment,
                                      double noise_m) {
  if (!options.single_frame || !alignment.found) return std::nullopt;
  const Pose T_design_camera = between_local(alignment.T_design_scan, design.origin, scan.origin);
  return DesignInSight{Sight(scan.points), T_design_camera.inverse().cast<float>(),
                       deviation_bound(noise_m)};
}

// Why no dimension may be ok whatever was measured; empty where one may.
std::string why_nothing_ok(const Alignment& alignment, const InspectorOptions& options) {
  if (!options.units_confirmed) return "But a unit was guessed: say which it is.";
  if (alignment.ambiguous && !alignment.is_symmetric)
    return "But other poses explain the scan as well: pick three pairs.";
  return "";
}

// Pipe axes, flange faces and how their bolt holes stand, from the points of their parts; and what
// those of known size say of the sensor's scale.
PartFeatures fit_features(const DesignModel& design, const InspectorOptions& options,
                          double noise_m, Inspection& inspection, const Watch& watch) {
  FeatureScan scan{inspection.scan_design, inspection.declutter.classes, inspection.deviations};
  scan.correlated = options.correlated;
  scan.warp_u_m = options.warp_u_m;
  scan.bound_m = static_cast<double>(deviation_bound(noise_m));
  if (options.single_frame)  // the camera stands at the scan's origin
    scan.eye = inspection.alignment.T_design_scan.translation() - design.origin;
  PartFeatures features = measure_features(design, scan, watch);
  add_bolt_holes(design, drawing_of(design), scan, features, watch);
  std::vector<Gauge> gauges = gauges_of(design, scan, features, watch);
  gauges.insert(gauges.end(), options.scale_bars.begin(), options.scale_bars.end());
  inspection.scale = check_scale(gauges, {.scale_u = options.scale_u});
  return features;
}

// What was not taken for the spool: where floor, walls and tables are looked for.
std::vector<Eigen::Vector3f> beside_the_object(const PointCloud& scan,
                                               const std::vector<PointClass>& classes) {
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (classes[i] == PointClass::kClutter) points.push_back(scan.points[i]);
  return points;
}

// The drawing's dimensions between them, and what they say of the parts.
void measure_drawing(const DesignModel& design, const InspectorOptions& options,
                     const PartFeatures& features, const Watch& watch, Inspection& inspection) {
  const std::string sensor_wrong = sensor_doubt(inspection);
  const std::string nothing_ok =
      sensor_wrong.empty() ? why_nothing_ok(inspection.alignment, options) : sensor_wrong;
  const double scale_u = inspection.scale ? inspection.scale->scale_u : options.scale_u;
  const double correction = inspection.scale ? inspection.scale->correction : 0;
  const Drawing drawing = drawing_of(design);
  MeasuredDrawing measured = measure_dimensions(
      design, drawing, features, options.rules,
      {.scale_u = scale_u, .scale_correction = correction, .nothing_ok = nothing_ok});
  check_sizes(design, features, nothing_ok, inspection.parts);
  inspection.dimensions = std::move(measured.dimensions);
  inspection.datum = std::move(measured.datum);
  const double sensor_u = std::hypot(scale_u, correction);  // these are not corrected
  inspection.chain = measure_joints(design, drawing, features, options.rules, sensor_u, watch);
  std::vector<PartPose> poses =
      measure_part_poses(design, drawing, features, options.rules, sensor_u, watch);
  for (PartFinding& finding : inspection.parts)
    if (const auto part = static_cast<std::size_t>(finding.part); part < poses.size())
      finding.pose = std::move(poses[part]);
  // Where a unit was guessed or another pose fits as well, nothing is proposed.
  if (nothing_ok.empty()) inspection.chain.bumps = bumps_for(design, inspection.chain);
  inspection.chain.fit_ups = fit_ups(design, features);
}

}  // namespace

Result<std::shared_ptr<const PreparedDesign>> PreparedDesign::prepare(DesignModel model,
                                                                      std::uint32_t seed,
                                                                      bool to_be_found) {
  auto prepared = std::make_shared<PreparedDesign>();
  prepared->model = std::move(model);
  Result<DesignSurface> whole = DesignSurface::build(prepared->model);
  if (!whole) return whole.error();
  prepared->exterior = exterior_of(prepared->model, *whole);
  Result<DesignSurface> surface = DesignSurface::build(prepared->exterior);
  if (!surface) return surface.error();
  prepared->surface = std::make_unique<DesignSurface>(std::move(*surface));
  prepared->samples = seen_samples(sample_surface(prepared->exterior, kModelSamples, seed),
                                   prepared->model, *whole);
  if (to_be_found)
    prepared->finder = std::make_unique<FinderModel>(
        FinderModel::prepare(prepared->exterior, *prepared->surface, prepared->samples, seed));
  return std::shared_ptr<const PreparedDesign>(std::move(prepared));
}

Result<Inspection> Inspector::process(const PointCloud& scan, const NoiseModel& noise,
                                      const InspectorOptions& options, const Watch& watch) const {
  if (!scan.is_consistent() || !has_finite_point(scan))
    return Error{ErrorCode::kBadInput, "The scan has no measured point; scan the spool again."};
  const DesignModel& design = design_->model;
  const JudgeOptions judging{.units_confirmed = options.units_confirmed,
                             .single_frame = options.single_frame};
  Inspection inspection;
  StageClock clock(inspection.timing_s);

  // Where the picks, the pose or nothing put the scan.
  const AlignRequest request{options.align,         options.pairs, options.T_design_scan,
                             design_->finder.get(), options.seed,  options.single_frame,
                             options.posed_by};
  Placement placement = place_scan(request, design, scan, typical_noise_m(scan, noise), watch);
  const double noise_m = placement.noise_m;
  const ExplainedDesign prepared{design, *design_->surface, design_->samples};
  const ExplainedScan explained_scan{inspection.scan_design, noise_m, scan.has_normals()};
  Explanation explanation;
  clock.mark(options.align == AlignMethod::kFind ? "find" : "place");
  for (int wrong_joints = 0;; ++wrong_joints) {
    // What the refinement looks at: points near the design there, with normals.
    const PointCloud near = refinement_cloud(scan, *design_->surface, placement);
    clock.mark("normals");
    // The pose, and how far it can be trusted.
    inspection.alignment = align_scan(request, placement, near, scan.has_normals(), noise_m, design,
                                      *design_->surface, design_->samples, watch);
    clock.mark("align");
    // Every point in the design frame, in input order.
    inspection.scan_design = to_design_frame(scan, design, inspection.alignment.T_design_scan);
    if (!inspection.alignment.found) break;
    // Which of them are the object, and how far off its surface each lies.
    explanation = explain_surface(prepared, explained_scan, watch);
    clock.mark("declutter");
    // What was found is the largest piece of the spool, but all is measured from the datum.
    if (options.align != AlignMethod::kFind || wrong_joints == kMostWrongJoints) break;
    const auto side = datum_side(prepared, explained_scan, explanation, watch);
    clock.mark("datum");
    if (!side) break;
    take_side(*side, inspection.alignment, design, scan, placement);
  }
  inspection.alignment.seconds = inspection.timing_s["normals"] + inspection.timing_s["align"];
  if (inspection.alignment.found) {
    // What of the spool is elsewhere and contradicts it. The thesis's methods know no such thing.
    if (options.declutter.is_thesis())
      explanation = explain_by_thesis(prepared, explained_scan, options.declutter, watch);
    else
      explain_pieces(prepared, explained_scan, watch, explanation);
    drop_pieces(explanation.pieces, *design_, scan, inspection.alignment);
    inspection.declutter = std::move(explanation.declutter);
    inspection.deviations = std::move(explanation.deviations);
    inspection.pieces = std::move(explanation.pieces);
    inspection.unexpected = std::move(explanation.unexpected);
  } else if (!watch.cancelled()) {
    inspection.declutter = nothing_kept(scan.size(), options.declutter);
    inspection.deviations = no_deviations(scan.size());
  }
  clock.mark("declutter");
  // What that says of each part.
  std::vector<PartDeviation> parts(design.parts.size());
  std::vector<MissingPart> missing;
  PartFeatures features;
  if (!watch.cancelled()) {
    const std::vector<PointClass>& classes = inspection.declutter.classes;
    parts = summarise_parts(design, inspection.scan_design, classes, inspection.deviations,
                            design_->samples, watch);
    missing = missing_parts(
        design, {inspection.scan_design, classes, inspection.deviations, inspection.pieces},
        design_->samples, parts, in_sight(options, scan, design, inspection.alignment, noise_m),
        watch);
    clock.mark("deviation");
    if (inspection.alignment.found)
      features = fit_features(design, options, noise_m, inspection, watch);
    if (inspection.alignment.found && options.single_frame)
      inspection.warp = check_warp(
          beside_the_object(scan, classes), noise,
          {.warp_u_m = options.warp_u_m, .correlated = options.correlated, .seed = options.seed},
          watch);
    clock.mark("measure");
  }
  if (watch.cancelled()) {  // half an inspection says nothing
    mark_stopped(inspection.alignment);
    inspection.declutter = nothing_kept(scan.size(), options.declutter);
    inspection.deviations = {};
    inspection.pieces.clear();
    inspection.unexpected.clear();
  }
  inspection.scan_rms_m = rms(inspection.deviations, inspection.declutter.classes);
  // What may be said of it.
  inspection.parts = judge_parts(design, parts, inspection.alignment, judging);
  judge_pieces(design, inspection.pieces, inspection.parts);
  judge_unexpected(design, inspection.unexpected, inspection.parts);
  judge_missing(design, missing, inspection.parts);
  inspection.findings = collect_findings(inspection.alignment, judging);
  if (inspection.alignment.found) {
    for (Finding& finding : sensor_findings(design, inspection))
      inspection.findings.push_back(std::move(finding));
    for (Finding& finding : spool_findings(design, inspection.pieces, inspection.unexpected,
                                           missing, inspection.parts))
      inspection.findings.push_back(std::move(finding));
    measure_drawing(design, options, features, watch, inspection);
    clock.mark("measure");
    judge_dimensions(design, inspection.dimensions, inspection.parts, inspection.findings);
  }
  judge_whole(inspection, judging);
  if (!sensor_doubt(inspection).empty())
    inspection.status = worse(inspection.status, Verdict::kSuspicious);
  clock.mark("judge");
  inspection.timing_s["total"] = clock.total_s();
  return inspection;
}

}  // namespace spool
