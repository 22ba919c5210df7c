// Pipework as a piping file tells it: components with their ends, joints, spools, and what is odd.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace spool::piping {

// Coordinates are the file's: x = east, y = north, z = up, metres in double, not rebased.

// Something about the file that its reader ought to know; line from 1, 0 for the file as a whole.
struct Problem {
  int line = 0;
  std::string text;  // one clause, without line and full stop
};

enum class ComponentKind {
  kPipe,
  kElbow,
  kTee,
  kCross,
  kOlet,
  kFlange,
  kStubEnd,  // of a lap joint
  kBlind,
  kReducer,
  kCap,
  kValve,
  kInstrument,
  kGasket,
  kBolt,
  kWeld,
  kSupport,
  kLink  // anything else: rigid between its ends
};
[[nodiscard]] std::string_view name(ComponentKind kind);  // "pipe", "stub end"

enum class FlangeForm { kWeldNeck, kSlipOn, kSocketWeld, kThreaded, kLoose };

enum class WeldPlace { kFab, kField, kYaw };
[[nodiscard]] std::string_view name(WeldPlace place);  // fab field yaw

// Where something else joins, or a place on the way.
struct PipePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // m
  double nps = 0;                                      // inches; 0: not given or unknown
  double outside_diameter = 0;                         // m; 0: not given
  std::string end;                                     // BW SW SC FL PL ...; "" not given
  int line = 0;
};

struct Component {
  int line = 0;
  std::string keyword, skey, raw;  // raw: its lines as written
  ComponentKind kind = ComponentKind::kLink;
  FlangeForm form = FlangeForm::kWeldNeck;
  std::vector<PipePoint> ends, branches, places, taps;  // places: CO-ORDS
  std::optional<PipePoint> centre;
  std::string id, item_code, description, tag, spool, piece, heat, category;
  std::string schedule, rating;                       // as found; "" where nothing says
  bool is_erection = false;                           // put up on site: no part of a shop's spool
  double bend_radius = 0;                             // m; 0: not given
  std::optional<double> angle;                        // as written: degrees or hundredths
  std::optional<Eigen::Vector3d> spindle, flat_side;  // unit
  std::string weld_number;                            // of a weld, "" where it has none
  std::optional<WeldPlace> weld_place;
  int pipeline = -1;
  // Known once the joints are: the unit direction out of each port, zero where nothing tells, and
  // which end of a flange, stub end or blind is the face.
  std::vector<Eigen::Vector3d> directions;
  int face = -1;
};

struct Pipeline {
  int line = 0;
  std::string reference, spec, nominal_class, revision, spool_prefix;
};

// Where a line ends, and how: END-CONNECTION-EQUIPMENT, END-POSITION-OPEN, -VENT, -DRAIN ...
struct LineEnd {
  int line = 0;
  std::string keyword, reference;
  std::optional<Eigen::Vector3d> place;
};

// A bolted, threaded or welded connection of two ports. A port is numbered through a component's
// ends and then its branches; kOnRun is a place on its body where a branch fitting sits.
inline constexpr int kOnRun = -1;
struct PipeJoint {
  enum class Kind { kWeld, kSocketWeld, kBolted, kThreaded, kOther };
  Kind kind = Kind::kWeld;
  int a = -1, port_a = 0;  // components and their ports
  int b = -1, port_b = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double gap = 0;      // m between the two ends as drawn
  int weld = -1;       // the WELD component that stands here; -1: none in the file
  std::string number;  // of a weld
  bool is_made_up = false;
  WeldPlace where = WeldPlace::kFab;
};

struct Spool {
  std::string name;
  bool is_made_up = false;
  std::vector<int> components;
};

struct Pipework {
  std::vector<Pipeline> pipelines;
  std::vector<Component> components;  // in the file's order
  std::vector<LineEnd> line_ends;
  std::vector<PipeJoint> joints;
  std::vector<Spool> spools;
  std::vector<Problem> problems;           // by line
  std::string coordinate_unit, bore_unit;  // as the file says or as found, for people
  bool coordinate_unit_inferred = false, bore_unit_inferred = false;
};

// The port's point: ends first, then branches.
[[nodiscard]] const PipePoint& port_of(const Component& component, int port);
[[nodiscard]] int port_count(const Component& component);

// Whether it takes up length between other components: not a weld, bolt or support.
[[nodiscard]] bool is_body(const Component& component);

// "ELBOW (line 12)", for problems.
[[nodiscard]] std::string mention(const Component& component);

}  // namespace spool::piping
