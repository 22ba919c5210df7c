// Tables 5-1 to 5-4 from scenes of our own, the printed numbers beside them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/thesis/declutter_tables.h"

#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "tools/thesis/bench_scene.h"
#include "tools/thesis/printed_tables.h"
#include "vision/design/sampling.h"
#include "vision/inspect/k_curves.h"
#include "vision/inspect/k_plane.h"
#include "vision/inspect/thesis_declutter.h"

namespace spool::thesis {
namespace {

// How far (m) the pose is off: the thesis's mean RMS of the found pipe spool (Table 4-7). At the
// true pose nothing of the object is lost from K = S/M on, and there is no curve to cross.
constexpr double kPoseError = 0.0128;

// Chapter 5's seven scenes: three of the whole assembly, four of single spools.
std::vector<RateAtK> rates_of_scene(std::size_t number, std::uint32_t seed,
                                    KObservation& observation, const Watch& watch) {
  campaign::SceneRequest request;
  request.kind =
      number < 3 ? campaign::ObjectKind::kFourBranch : campaign::ObjectKind::kRandomSpool;
  request.seed = seed + static_cast<std::uint32_t>(number);
  request.scene_points = kTable5_4[number].scene;
  const BenchScene scene = make_bench_scene(request);
  const SurfaceSamples model = sample_surface(scene.design, kTable5_4[number].model, request.seed);
  std::vector<Eigen::Vector3f> in_design;
  Pose off = Pose::Identity();
  off.translation() = kPoseError * Eigen::Vector3d(1, 1, 1).normalized();
  const Eigen::Isometry3f T = (off * scene.true_T_design_scan.front()).cast<float>();
  for (const Eigen::Vector3f& p : scene.cloud.points) in_design.push_back(T * p);
  observation.scene_points = scene.cloud.size();
  observation.model_points = model.cloud.size();
  return rates_by_k(CloudView(in_design), model.cloud, scene.is_object,
                    thesis_ks(scene.cloud.size(), model.cloud.size()), watch);
}

void print_rates(const std::vector<RateAtK>& rates, const KObservation& sizes, std::ostream& out) {
  out << fmt::format("Table 5-1, scene 1: M {}, S {} | printed M {}, S {}\n", sizes.model_points,
                     sizes.scene_points, kTable5_1Model, kTable5_1Scene);
  out << fmt::format(
      "{:>5}{:>7}{:>7}{:>7}{:>8}{:>8}{:>7} | printed{:>5}{:>7}{:>7}{:>7}{:>8}{:>8}\n", "K", "N",
      "noise", "missed", "VR", "NR", "F1", "K", "N", "noise", "missed", "VR", "NR");
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const KeptCounts& c = rates[i].counts;
    out << fmt::format("{:>5}{:>7}{:>7}{:>7}{:>8.4f}{:>8.4f}{:>7.3f} |", rates[i].k, c.kept,
                       c.kept - c.true_kept, c.object - c.true_kept, void_rate(c), noise_rate(c),
                       f1(c));
    if (i < kTable5_1.size())
      out << fmt::format("{:>13}{:>7}{:>7}{:>7}{:>8.4f}{:>8.4f}", kTable5_1[i].k,
                         kTable5_1[i].n_kept, kTable5_1[i].m_less_q, kTable5_1[i].n_less_q,
                         kTable5_1[i].vr, kTable5_1[i].nr);
    out << "\n";
  }
}

void print_curves(std::size_t number, const LogCurve& noise, const PowerCurve& lost,
                  const KCrossing& crossing, std::ostream& out) {
  const CurvesRow& row = kTable5_2[number];
  const auto line = [](double a, double b, double a2, double b2, double r1, double r2) {
    return fmt::format("{:>8.4f}{:>9.4f}{:>8.4f}{:>8.3f}{:>6.2f}{:>6.2f}", a, b, a2, b2, r1, r2);
  };
  out << fmt::format("{:>5}{}{:>7.1f} |{}{:>4}{:>8.1f}\n", number + 1,
                     line(noise.a, noise.b, lost.a, lost.b, noise.r_squared, lost.r_squared),
                     crossing.k,
                     line(row.a, row.b, row.a_power, row.b_power, row.r1_squared, row.r2_squared),
                     row.k, cross({row.a, row.b}, {row.a_power, row.b_power}).k);
}

// `numbers`: which scene each observation is of.
void print_plane(const std::vector<KObservation>& observations,
                 const std::vector<std::size_t>& numbers, std::ostream& out) {
  const KPlane plane = fit_k_plane(observations);
  out << "Table 5-3: the plane of K on standardised sizes\n";
  if (!plane.fit.is_determined) {
    out << "too few scenes with a K: no plane\n";
    return;
  }
  const struct {
    const char* name;
    CoefficientRow printed;
  } rows[] = {{"a0", kA0}, {"scene", kA1}, {"model", kA2}};
  for (Eigen::Index i = 0; i < 3; ++i)
    out << fmt::format(
        "{:>6}{:>8.3f} [{:>7.2f}, {:>7.2f}] | printed{:>8.3f} [{:>6.2f}, {:>6.2f}]\n", rows[i].name,
        plane.fit.coefficients[i], plane.fit.low[i], plane.fit.high[i], rows[i].printed.value,
        rows[i].printed.low, rows[i].printed.high);
  out << "Table 5-4\n"
      << fmt::format("{:>8}{:>8}{:>7}{:>7} | printed{:>8}{:>8}{:>5}{:>6}\n", "S", "M", "K", "plane",
                     "S", "M", "K", "plane");
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const KObservation& o = observations[i];
    const PlaneRow& row = kTable5_4[numbers[i]];
    out << fmt::format("{:>8}{:>8}{:>7.1f}{:>7.1f} |{:>16}{:>8}{:>5}{:>6}\n", o.scene_points,
                       o.model_points, o.k, plane.predict(o.scene_points, o.model_points),
                       row.scene, row.model, row.k, row.predicted);
  }
  out << fmt::format("R2 {:.2f} (leaving one out {:.2f}) | printed {:.2f}\n", plane.fit.r_squared,
                     plane.fit.left_out_r_squared, kRSquared);
}

}  // namespace

Status print_declutter_tables(std::uint32_t seed, std::ostream& out, const Watch& watch) {
  std::vector<KObservation> observations;
  std::vector<std::size_t> numbers;
  for (std::size_t number = 0; number < kTable5_4.size(); ++number) {
    watch.report("decluttering", static_cast<double>(number) / kTable5_4.size());
    KObservation observation;
    const std::vector<RateAtK> rates = rates_of_scene(number, seed, observation, watch);
    std::vector<double> k, noise, lost;
    for (const RateAtK& rate : rates) {
      k.push_back(rate.k);
      noise.push_back(noise_rate(rate.counts));
      lost.push_back(void_rate(rate.counts));
    }
    if (number == 0) {
      print_rates(rates, observation, out);
      out << "Table 5-2: NR = a ln K + b, VR = a' K^b' | printed, its K and the true crossing\n"
          << fmt::format("{:>5}{:>8}{:>9}{:>8}{:>8}{:>6}{:>6}{:>7} |\n", "scene", "a", "b", "a'",
                         "b'", "R1", "R2", "K");
    }
    const LogCurve noise_curve = fit_log_curve(k, noise);
    const PowerCurve void_curve = fit_power_curve(k, lost);
    const KCrossing crossing = cross(noise_curve, void_curve);
    print_curves(number, noise_curve, void_curve, crossing, out);
    if (crossing.exists && crossing.doubt.empty()) {
      observation.k = std::max(1.0, crossing.k);
      observations.push_back(observation);
      numbers.push_back(number);
    } else {
      out << "      no K for the plane: " << crossing.doubt << "\n";
    }
    out << std::flush;
  }
  print_plane(observations, numbers, out);
  return {};
}

}  // namespace spool::thesis
