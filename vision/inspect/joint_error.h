// How each joint of the spool is off against the one before it, whose fault that is, what to do.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/core/pose.h"

namespace spool {

// A motion at a joint that no feature tells.
struct UnobservedMotion {
  Vector6d direction = Vector6d::Zero();  // unit; translation or rotation, in the joint's frame
  std::string text;                       // "turn about pipe_2"
};

// What one joint's error alone does to an end beyond it; design frame, the datum aligned.
struct EndEffect {
  std::string end;                                                    // part/port
  Eigen::Vector3d displacement_m = Eigen::Vector3d::Zero();           // of the end's nominal place
  Eigen::Matrix3d displacement_covariance = Eigen::Matrix3d::Zero();  // m^2
  Eigen::Vector3d tilt_rad = Eigen::Vector3d::Zero();                 // rotation vector
};

// An end of the chain: where it is against the drawing, the datum aligned. To first order the sum
// of all joints' effects on it.
struct ChainEnd {
  std::string end;  // part/port
  int part = -1;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // m, design frame, nominal
  Eigen::Vector3d displacement_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d displacement_covariance = Eigen::Matrix3d::Zero();
  Eigen::Vector3d tilt_rad = Eigen::Vector3d::Zero();
  double tolerance_m = 0;  // of a length there; 0: no rule
};

// A joint, or the joints of a fitting that has no feature of its own: how what lies beyond is off
// against what lies before.
struct JointError {
  std::vector<int> joints;            // of the design, outward
  std::string weld;                   // "W4", or "W2+W3": their split is not observed
  int part_near = -1, part_far = -1;  // the parts with features on either side
  std::string near_port, far_port;    // part/port that meet there
  bool is_measured = false;           // false: only the above and the reason
  std::string reason;                 // why not
  // Nominal: at the joint, of several where the two axes cross; z outward along what lies before.
  Pose T_design_joint = Pose::Identity();
  Pose T_design_near = Pose::Identity();  // that frame, carried along by what lies before
  std::vector<int> parts;                 // beyond it
  // inverse(nominal) * measured of what lies beyond as seen from what lies before, in that frame:
  // translation (m), rotation vector (rad). Zero along what is not observed. Along and about a pipe
  // the error is counted from the joint at its other end: along it is the pipe's cut length.
  Vector6d error = Vector6d::Zero();
  Matrix6d covariance = Matrix6d::Zero();  // zero along what is not observed
  std::vector<UnobservedMotion> unobserved;
  bool is_significant = false;   // at kJointLevel, over all joints of the spool together
  double against_tolerance = 0;  // the largest of its errors and effects over their tolerances
  double blame = 0;              // its share of all significant errors, 0 to 1
  bool is_to_blame = false;      // significant, and largest against its tolerance
  std::vector<EndEffect> ends;   // beyond it
};

// The probability that any joint of a spool built as drawn is called significant.
inline constexpr double kJointLevel = 0.001;

enum class BumpKind : std::uint8_t {
  kTurn,    // about the axis of what lies before
  kTilt,    // about an axis across it
  kShift,   // across it
  kLength,  // along it: the pipe before is cut shorter or made longer
};

// One motion that undoes what a joint is off by.
struct Bump {
  int part = -1;         // that is moved, with all beyond it; of kLength the pipe that is cut
  int joint_error = -1;  // into joint errors
  std::string weld;
  BumpKind kind = BumpKind::kTurn;
  // Unit, design frame, the datum aligned: what it turns or tilts about (right-handed, amount over
  // 0) or moves along.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double amount = 0;    // rad, or m; of kLength below 0 to cut shorter
  double u = 0;         // standard uncertainty of it
  std::string end;      // that it moves most
  double at_end_m = 0;  // by how much
  Eigen::Vector3d at_end_way = Eigen::Vector3d::Zero();  // unit, design frame; zero: not at all
  // Of kTurn: looking from here along the axis, amount over 0 is clockwise.
  std::string seen_from;
  // The motion of the measured parts beyond the joint, all bumps before it done (m, the scan's own
  // place in the design frame).
  Pose T_design_bumped = Pose::Identity();
};

// Two pipes at a butt weld.
struct FitUp {
  int joint = -1;  // of the design
  std::string weld, a, b;
  bool is_measured = false;
  std::string reason;        // why not
  double offset_m = 0;       // between the two axes there, the noise's share taken off
  double radius_step_m = 0;  // half the difference of the outside diameters, b less a
  double hi_lo_m = 0;        // the largest step of the outside around the joint
  double u_m = 0;            // standard uncertainty of hi_lo_m
  std::string root_gap;      // why it is not measured, and with what to
};

struct ChainResult {
  std::vector<JointError> joints;
  std::vector<ChainEnd> ends;
  std::vector<Bump> bumps;  // together they undo the error of the joint to blame
  std::vector<FitUp> fit_ups;
  std::string datum;          // what the chain starts from, or why there is none
  bool is_turn_held = false;  // about the datum's axis, by bolt holes
};

}  // namespace spool
