// Joints, bumps and fit-up in the reports.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/joints_report.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/evidence/html_parts.h"

namespace spool::evidence {
namespace {

using Eigen::Vector3d;
using nlohmann::json;

json vector(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Vector3d u_of(const Eigen::Matrix3d& covariance) { return covariance.diagonal().cwiseSqrt(); }

const std::string& part_name(const DesignModel& design, int part) {
  return design.parts[static_cast<std::size_t>(part)].name;
}

std::string degrees(double angle) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f°", std::abs(angle) * 180 / std::numbers::pi);
  return text;
}

// The drawing's axis that lies nearest: "+y".
std::string way(const Vector3d& direction) {
  Eigen::Index k = 0;
  direction.cwiseAbs().maxCoeff(&k);
  return std::string(direction[k] < 0 ? "-" : "+") + "xyz"[k];
}

std::string_view kind_name(BumpKind kind) {
  constexpr std::string_view kNames[] = {"turn", "tilt", "shift", "length"};
  return kNames[static_cast<int>(kind)];
}

}  // namespace

json joints_json(const ChainResult& chain) {
  json list = json::array();
  for (const JointError& joint : chain.joints) {
    if (!joint.is_measured) continue;
    json covariance = json::array(), weak = json::array(), ends = json::array();
    for (int i = 0; i < 36; ++i) covariance.push_back(joint.covariance(i / 6, i % 6));
    for (const UnobservedMotion& motion : joint.unobserved) {
      json direction = json::array();
      for (int i = 0; i < 6; ++i) direction.push_back(motion.direction[i]);
      weak.push_back({{"direction", direction}, {"sigma", nullptr}, {"text", motion.text}});
    }
    for (const EndEffect& end : joint.ends)
      ends.push_back({{"end", end.end},
                      {"displacement_m", vector(end.displacement_m)},
                      {"u_m", vector(u_of(end.displacement_covariance))},
                      {"tilt_rad", vector(end.tilt_rad)}});
    list.push_back({{"weld", joint.weld},
                    {"between", {joint.near_port, joint.far_port}},
                    {"error",
                     {{"translation_m", vector(joint.error.head<3>())},
                      {"rotation_rad", vector(joint.error.tail<3>())},
                      {"covariance", covariance},
                      {"weak_directions", weak}}},
                    {"blame", joint.blame},
                    {"to_blame", joint.is_to_blame},
                    {"against_tolerance", joint.against_tolerance},
                    {"far_ends", ends}});
  }
  return list;
}

json joints_not_measured_json(const ChainResult& chain) {
  json list = json::array();
  for (const JointError& joint : chain.joints)
    if (!joint.is_measured)
      list.push_back({{"weld", joint.weld},
                      {"between", {joint.near_port, joint.far_port}},
                      {"reason", joint.reason}});
  return list;
}

json chain_json(const ChainResult& chain) {
  json ends = json::array();
  for (const ChainEnd& end : chain.ends)
    ends.push_back({{"end", end.end},
                    {"displacement_m", vector(end.displacement_m)},
                    {"u_m", vector(u_of(end.displacement_covariance))},
                    {"tilt_rad", vector(end.tilt_rad)},
                    {"tolerance_m", end.tolerance_m}});
  return {{"datum", chain.datum}, {"turn_held", chain.is_turn_held}, {"far_ends", ends}};
}

json bumps_json(const DesignModel& design, const ChainResult& chain) {
  json list = json::array();
  for (const Bump& bump : chain.bumps) {
    const bool is_angle = bump.kind == BumpKind::kTurn || bump.kind == BumpKind::kTilt;
    const std::string unit = is_angle ? "_rad" : "_m";
    list.push_back({{"part", part_name(design, bump.part)},
                    {"joint", bump.weld},
                    {"kind", kind_name(bump.kind)},
                    {"axis", vector(bump.axis)},
                    {"amount" + unit, bump.amount},
                    {"u" + unit, bump.u},
                    {"end", bump.end},
                    {"at_end_m", bump.at_end_m},
                    {"seen_from", bump.seen_from},
                    {"text", bump_text(design, bump, LengthStyle::kMillimetre)}});
  }
  return list;
}

json fit_up_json(const ChainResult& chain) {
  json list = json::array();
  for (const FitUp& fit_up : chain.fit_ups) {
    json object = {
        {"weld", fit_up.weld}, {"between", {fit_up.a, fit_up.b}}, {"root_gap", fit_up.root_gap}};
    if (fit_up.is_measured) {
      object["hi_lo_m"] = fit_up.hi_lo_m;
      object["offset_m"] = fit_up.offset_m;
      object["radius_step_m"] = fit_up.radius_step_m;
      object["u_m"] = fit_up.u_m;
    } else {
      object["reason"] = fit_up.reason;
    }
    list.push_back(std::move(object));
  }
  return list;
}

std::string bump_text(const DesignModel& design, const Bump& bump, LengthStyle style) {
  const std::string& part = part_name(design, bump.part);
  const std::string at_end = bump.end.empty()
                                 ? "."
                                 : " = " + length_text(bump.at_end_m, style) + " at " + bump.end +
                                       ", towards " + way(bump.at_end_way) + " of the drawing.";
  const std::string length = length_text(std::abs(bump.amount), style);
  switch (bump.kind) {
    case BumpKind::kTurn:
      return "Turn " + part + " " + degrees(bump.amount) +
             (bump.amount > 0 ? " clockwise" : " counter-clockwise") + " seen from " +
             bump.seen_from + at_end;
    case BumpKind::kTilt:
      return "Tilt " + part + " " + degrees(bump.amount) + at_end;
    case BumpKind::kShift:
      return "Move " + part + " " + length + " towards " + way(bump.axis) + " of the drawing.";
    case BumpKind::kLength:
      break;
  }
  return bump.amount < 0 ? "Cut " + part + " " + length + " shorter."
                         : "Make " + part + " " + length + " longer.";
}

std::string joint_text(const JointError& joint, LengthStyle style) {
  if (!joint.is_measured) return joint.reason;
  std::string text = joint.near_port + " to " + joint.far_port + ": off by " +
                     length_text(joint.error.head<3>().norm(), style) + " and " +
                     degrees(joint.error.tail<3>().norm());
  text += joint.is_to_blame      ? ". The joint to blame."
          : joint.is_significant ? "."
                                 : ", which may be chance.";
  for (const EndEffect& end : joint.ends)
    text += " At " + end.end + " " + length_text(end.displacement_m.norm(), style) + ".";
  return text;
}

std::string fit_up_text(const FitUp& fit_up, LengthStyle style) {
  if (!fit_up.is_measured) return fit_up.reason;
  return length_text(fit_up.hi_lo_m, style) + ", U (k = 2) " + length_text(2 * fit_up.u_m, style);
}

std::string joints_section(const DesignModel& design, const ChainResult& chain, LengthStyle style) {
  if (chain.joints.empty()) return "";
  std::string html = "<h2>Joints</h2>\n";
  for (const Bump& bump : chain.bumps)
    html += "<p><b>" + escaped(bump_text(design, bump, style)) + "</b></p>\n";
  html += "<table class=\"facts\">\n";
  for (const JointError& joint : chain.joints)
    html += row(escaped(joint.weld), escaped(joint_text(joint, style)));
  for (const FitUp& fit_up : chain.fit_ups)
    html += row(escaped(fit_up.weld + ", hi-lo"), escaped(fit_up_text(fit_up, style)));
  html += "</table>\n<p>What joints are counted outward from: " + escaped(chain.datum) + ".";
  if (!chain.fit_ups.empty()) html += " " + escaped(chain.fit_ups.front().root_gap);
  return html + "</p>\n";
}

}  // namespace spool::evidence
