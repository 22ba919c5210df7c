// Whether fittings and flanges are as long as the catalogue says: take-offs, bend angles, classes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/size_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "vision/piping/catalogue.h"
#include "vision/piping/pcf_numbers.h"

namespace spool::piping {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::string mm(double metres) {
  std::string text = std::to_string(std::round(metres * 10000) / 10);
  return text.substr(0, text.find('.') + 2) + " mm";
}

class Checker {
 public:
  explicit Checker(Pipework& pipework) : out_(pipework) {}

  void check(Component& each) {
    switch (each.kind) {
      case ComponentKind::kElbow:
        check_elbow(each);
        break;
      case ComponentKind::kTee:
        check_tee(each);
        break;
      case ComponentKind::kReducer:
        check_reducer(each);
        break;
      case ComponentKind::kFlange:
      case ComponentKind::kBlind:
        check_flange(each);
        break;
      default:
        break;
    }
    fill_schedule(each);
  }

 private:
  void tell(const Component& each, const std::string& what) {
    out_.problems.push_back({each.line, mention(each) + " " + what});
  }
  // Of what many components share, once.
  void tell_once(const Component& each, const std::string& key, const std::string& what) {
    if (told_.insert(key).second) tell(each, what);
  }

  void compare(const Component& each, const char* what, double drawn, double meant) {
    if (std::abs(drawn - meant) <= kSameLength) return;
    tell(each, std::string("has ") + what + " " + mm(drawn) + " where the catalogue has " +
                   mm(meant) + "; it is taken as drawn");
  }

  void check_elbow(const Component& each) {
    if (!each.centre || each.ends.size() != 2) return;
    const double angle = bend_angle(each);
    if (each.angle) {
      const double written = angle_nearest(*each.angle, angle / kDegree);
      if (std::abs(written - angle / kDegree) > 0.5)
        tell(each, "says " + std::to_string(written).substr(0, 5) + " degrees and is drawn at " +
                       std::to_string(angle / kDegree).substr(0, 5) + "; it is taken as drawn");
    }
    const double leg1 = (each.ends[0].position - each.centre->position).norm();
    const double leg2 = (each.ends[1].position - each.centre->position).norm();
    if (std::abs(leg1 - leg2) > kSameLength && each.ends[0].nps == each.ends[1].nps)
      tell(each, "has legs of different length, " + mm(leg1) + " and " + mm(leg2));
    // A BEND is bent to any radius; an ELBOW is a fitting.
    if (each.keyword != "ELBOW" || !is_listed(each)) return;
    const FittingSize size = *fitting_size(each.ends[0].nps);
    const double radius = leg1 / std::tan(angle / 2);
    if (std::abs(angle - 90 * kDegree) < kDegree) {
      const bool is_short = size.elbow_90_short > 0 && std::abs(leg1 - size.elbow_90_short) <
                                                           std::abs(leg1 - size.elbow_90_long);
      compare(each, "a centre to end of", leg1,
              is_short ? size.elbow_90_short : size.elbow_90_long);
    } else if (std::abs(angle - 45 * kDegree) < kDegree) {
      compare(each, "a centre to end of", leg1, size.elbow_45);
    } else if (std::abs(radius - size.elbow_90_long) > 0.1 * size.elbow_90_long) {
      tell(each, "is bent to " + mm(radius) + ", neither cut from a long radius of " +
                     mm(size.elbow_90_long) + " nor of a listed angle");
    }
  }

  void check_tee(const Component& each) {
    if (each.keyword != "TEE" || !each.centre || each.ends.size() != 2 || each.branches.empty())
      return;
    if (!is_listed(each)) return;
    const FittingSize size = *fitting_size(each.ends[0].nps);
    for (const PipePoint& end : each.ends)
      compare(each, "a centre to end of", (end.position - each.centre->position).norm(), size.tee);
    const Result<double> outlet = tee_outlet(each.ends[0].nps, each.branches[0].nps);
    const double drawn = (each.branches[0].position - each.centre->position).norm();
    if (outlet)
      compare(each, "a branch of", drawn, *outlet);
    else if (each.branches[0].nps > 0)
      tell_once(each, outlet.error().message,
                "has a branch that is not checked: " + outlet.error().message);
  }

  void check_reducer(const Component& each) {
    if (each.ends.size() != 2) return;
    const double large = std::max(each.ends[0].nps, each.ends[1].nps);
    if (each.ends[0].nps == each.ends[1].nps && large > 0)
      tell(each, "has the same bore at both ends");
    const Result<FittingSize> size = fitting_size(large);
    if (!size || size->reducer == 0) return;
    const double along =
        std::abs((each.ends[1].position - each.ends[0].position).dot(each.directions[1]));
    compare(each, "a length of", along, size->reducer);
  }

  void check_flange(Component& each) {
    if (each.ends.empty()) return;
    if (each.skey.substr(0, 2) == "FO" && each.taps.empty())
      tell(each, "is an orifice flange without a TAP-CONNECTION; where its taps look is not known");
    const double nps = each.ends[each.face > 0 ? 1 : 0].nps;
    if (each.rating.empty() && out_.pipelines.size() > 0 && each.pipeline >= 0)
      each.rating = out_.pipelines[static_cast<std::size_t>(each.pipeline)].nominal_class;
    const double drawn =
        each.ends.size() == 2 ? (each.ends[0].position - each.ends[1].position).norm() : 0;
    if (each.rating.empty()) guess_class(each, nps, drawn);
    const Result<FlangeSize> size = flange_size(nps, std::atoi(each.rating.c_str()));
    if (!size) {
      tell_once(each, "flange " + nps_text(nps) + " " + each.rating,
                "is drawn without holes: " + size.error().message);
      return;
    }
    if (drawn == 0) return;
    // Editions of B16.5 from 2003 on list lengths without the raised face.
    const double meant = each.kind == ComponentKind::kBlind ? size->thickness : size->weld_neck;
    const bool is_newer = std::abs(drawn + kRaisedFaceHeight - meant) <= kSameLength;
    if (each.kind == ComponentKind::kBlind || each.form == FlangeForm::kWeldNeck) {
      if (!is_newer) compare(each, "a length of", drawn, meant);
    }
  }

  void guess_class(Component& each, double nps, double drawn) {
    std::string fits;
    for (const int rating : {150, 300}) {
      const Result<FlangeSize> size = flange_size(nps, rating);
      if (!size || each.form != FlangeForm::kWeldNeck) continue;
      const double meant = each.kind == ComponentKind::kBlind ? size->thickness : size->weld_neck;
      if (std::abs(drawn - meant) <= kSameLength)
        fits = fits.empty() ? std::to_string(rating) : "?";
    }
    const bool is_told = !fits.empty() && fits != "?";
    each.rating = is_told ? fits : "150";
    tell_once(each, "class of " + each.item_code + each.rating,
              is_told ? "has no class in its text; by its length it is class " + fits
                      : "has no class in its text; class 150 is taken, confirm it");
  }

  void fill_schedule(Component& each) {
    const bool has_wall = each.kind == ComponentKind::kPipe || each.kind == ComponentKind::kElbow ||
                          each.kind == ComponentKind::kTee || each.kind == ComponentKind::kCross ||
                          each.kind == ComponentKind::kReducer ||
                          each.kind == ComponentKind::kCap || each.kind == ComponentKind::kFlange;
    if (!has_wall || port_count(each) == 0) return;
    const double nps = port_of(each, 0).nps;
    if (each.schedule.empty()) {
      each.schedule = "STD";
      if (each.kind != ComponentKind::kFlange)
        tell_once(each, "schedule of " + each.item_code + std::string(name(each.kind)),
                  "has no schedule in its text; STD is taken, confirm it");
    }
    const Result<double> wall = wall_thickness(nps, each.schedule);
    if (!wall && nps > 0)
      tell_once(each, wall.error().message,
                "has a wall that is not known: " + wall.error().message);
  }

  // Whether B16.9 holds its size; says so once where not.
  bool is_listed(const Component& each) {
    const Result<FittingSize> size = fitting_size(each.ends[0].nps);
    if (!size && each.ends[0].nps > 0)
      tell_once(each, size.error().message, "is not checked: " + size.error().message);
    return size.has_value();
  }

  Pipework& out_;
  std::set<std::string> told_;
};

}  // namespace

double bend_angle(const Component& elbow) {
  if (!elbow.centre || elbow.ends.size() != 2) return 0;
  const Eigen::Vector3d in = elbow.centre->position - elbow.ends[0].position;
  const Eigen::Vector3d out = elbow.ends[1].position - elbow.centre->position;
  return std::atan2(in.cross(out).norm(), in.dot(out));
}

void check_sizes(Pipework& pipework) {
  Checker checker(pipework);
  for (Component& each : pipework.components) checker.check(each);
}

}  // namespace spool::piping
