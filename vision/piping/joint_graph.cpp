// Which ends of a pipework meet: joints by nearness, welds to their joints, branch fittings to
// their runs.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/joint_graph.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "vision/piping/catalogue.h"
#include "vision/piping/pcf_keywords.h"
#include "vision/piping/port_directions.h"
#include "vision/piping/run_of_branch.h"

namespace spool::piping {
namespace {

struct Port {
  int component = 0, port = 0;
  Eigen::Vector3d position;
};

std::uint64_t cell_key(std::int64_t x, std::int64_t y, std::int64_t z) {
  return static_cast<std::uint64_t>(x) * 73856093U ^ static_cast<std::uint64_t>(y) * 19349663U ^
         static_cast<std::uint64_t>(z) * 83492791U;
}

// Ports by cells of kNearby: what is near lies in one of 27.
class PortGrid {
 public:
  explicit PortGrid(const std::vector<Port>& ports) : ports_(&ports) {
    for (std::size_t i = 0; i < ports.size(); ++i)
      cells_[key(cell(ports[i].position))].push_back(i);
  }
  // Ports within kNearby of a place. Of a file that heaps up ends, the first of each cell only.
  template <class Use>
  void near(const Eigen::Vector3d& place, const Use& use) const {
    constexpr std::size_t kMost = 48;
    const Cell at = cell(place);
    for (std::int64_t x = -1; x <= 1; ++x) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        for (std::int64_t z = -1; z <= 1; ++z) {
          const auto found = cells_.find(key(at + Cell(x, y, z)));
          if (found == cells_.end()) continue;
          const std::size_t looked = std::min(found->second.size(), kMost);
          for (std::size_t i = 0; i < looked; ++i) {
            const std::size_t port = found->second[i];
            const double distance = ((*ports_)[port].position - place).norm();
            if (distance <= kNearby) use(port, distance);
          }
        }
      }
    }
  }

 private:
  using Cell = Eigen::Array<std::int64_t, 3, 1>;
  static Cell cell(const Eigen::Vector3d& place) {
    return (place.array() / kNearby).floor().cast<std::int64_t>();
  }
  static std::uint64_t key(const Cell& cell) { return cell_key(cell[0], cell[1], cell[2]); }
  const std::vector<Port>* ports_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

class Connector {
 public:
  explicit Connector(Pipework& pipework) : out_(pipework) {
    for (std::size_t c = 0; c < out_.components.size(); ++c) {
      Component& each = out_.components[c];
      each.directions = own_directions(each);
      each.face = -1;
      if (!is_body(each)) continue;
      for (int p = 0; p < port_count(each); ++p)
        ports_.push_back({static_cast<int>(c), p, port_of(each, p).position});
    }
    taken_.assign(ports_.size(), false);
  }

  void run() {
    const PortGrid grid(ports_);
    join_by_welds(grid);
    join_by_nearness(grid);
    for (std::size_t c = 0; c < out_.components.size(); ++c) join_to_run(static_cast<int>(c));
    std::sort(out_.joints.begin(), out_.joints.end(), [](const PipeJoint& x, const PipeJoint& y) {
      return std::tie(x.a, x.port_a, x.b) < std::tie(y.a, y.port_a, y.b);
    });
    complete_directions(out_);
    for (PipeJoint& joint : out_.joints) {
      joint.kind = kind_of(joint);
      compare_ends(joint);
    }
    for (std::size_t c = 0; c < out_.components.size(); ++c) {
      if (out_.components[c].kind == ComponentKind::kWeld) place_weld(static_cast<int>(c));
    }
    for (const PipeJoint& joint : out_.joints) report_gap(joint);
    report_crowds(grid);
  }

 private:
  Component& component(int index) { return out_.components[static_cast<std::size_t>(index)]; }
  void tell(int line, const std::string& what) { out_.problems.push_back({line, what}); }

  void join(std::size_t a, std::size_t b, int weld) {
    if (b < a) std::swap(a, b);  // the file's order
    taken_[a] = taken_[b] = true;
    PipeJoint joint;
    joint.a = ports_[a].component;
    joint.port_a = ports_[a].port;
    joint.b = ports_[b].component;
    joint.port_b = ports_[b].port;
    joint.place = (ports_[a].position + ports_[b].position) / 2;
    joint.gap = (ports_[a].position - ports_[b].position).norm();
    joint.weld = weld;
    out_.joints.push_back(joint);
  }

  // The free port that meets a place; ports_.size() where there is none.
  std::size_t free_port(const PortGrid& grid, const Eigen::Vector3d& place, int other_than) {
    std::size_t best = ports_.size();
    double nearest = kMeets;
    grid.near(place, [&](std::size_t port, double distance) {
      if (taken_[port] || distance > nearest || ports_[port].component == other_than) return;
      nearest = distance;
      best = port;
    });
    return best;
  }

  // WELD records with a gap between their two ends: what stands at either end is joined.
  void join_by_welds(const PortGrid& grid) {
    for (std::size_t w = 0; w < out_.components.size(); ++w) {
      const Component& weld = out_.components[w];
      if (weld.kind != ComponentKind::kWeld || weld.ends.size() != 2) continue;
      const double gap = (weld.ends[0].position - weld.ends[1].position).norm();
      if (gap <= kMeets || gap > 2 * kNearby) continue;
      const std::size_t a = free_port(grid, weld.ends[0].position, -1);
      if (a == ports_.size()) continue;
      const std::size_t b = free_port(grid, weld.ends[1].position, ports_[a].component);
      if (b != ports_.size()) join(a, b, static_cast<int>(w));
    }
  }

  void join_by_nearness(const PortGrid& grid) {
    struct Pair {
      double cost;
      std::size_t a, b;
    };
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < ports_.size(); ++a) {
      grid.near(ports_[a].position, [&](std::size_t b, double distance) {
        if (b <= a || ports_[a].component == ports_[b].component) return;
        // Of ends at one place those join that look at each other; 0.1 mm decides no more than
        // that.
        const double facing = 1 + direction(a).dot(direction(b));
        pairs.push_back({(distance <= kMeets ? 0 : distance) + 1e-4 * facing, a, b});
      });
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) {
      return std::tie(x.cost, x.a, x.b) < std::tie(y.cost, y.a, y.b);
    });
    for (const Pair& pair : pairs) {
      if (!taken_[pair.a] && !taken_[pair.b]) join(pair.a, pair.b, -1);
    }
  }

  Eigen::Vector3d direction(std::size_t port) {
    return component(ports_[port].component)
        .directions[static_cast<std::size_t>(ports_[port].port)];
  }

  // Olets, and tees without a run of their own, sit on what their centre lies in.
  void join_to_run(int index) {
    const Component& branch = component(index);
    if (branch.kind != ComponentKind::kOlet) return;
    if (!branch.centre) {
      tell(branch.line, mention(branch) + " has no CENTRE-POINT; what it sits on is not known");
      return;
    }
    const int run = run_of_branch(out_, index);
    if (run < 0) {
      tell(branch.line, mention(branch) + " sits on nothing: no pipe has its axis there");
      return;
    }
    PipeJoint joint;
    joint.a = run;
    joint.b = index;
    joint.port_a = joint.port_b = kOnRun;
    joint.place = branch.centre->position;
    out_.joints.push_back(joint);
  }

  PipeJoint::Kind kind_of(const PipeJoint& joint) {
    if (joint.port_a == kOnRun) return PipeJoint::Kind::kWeld;
    const std::string a = end_type(component(joint.a), joint.port_a);
    const std::string b = end_type(component(joint.b), joint.port_b);
    const auto either = [&](std::string_view type) { return a == type || b == type; };
    if (a == "FL" && (b == "FL" || b.empty())) return PipeJoint::Kind::kBolted;
    if (b == "FL" && a.empty()) return PipeJoint::Kind::kBolted;
    if (either("FL")) return PipeJoint::Kind::kOther;
    if (either("SW")) return PipeJoint::Kind::kSocketWeld;
    if (either("SC")) return PipeJoint::Kind::kThreaded;
    for (const std::string_view type : {"CP", "GL", "PF", "CL", "MP"}) {
      if (either(type)) return PipeJoint::Kind::kOther;
    }
    return PipeJoint::Kind::kWeld;
  }

  void compare_ends(const PipeJoint& joint) {
    if (joint.port_a == kOnRun) return;
    const PipePoint& a = port_of(component(joint.a), joint.port_a);
    const PipePoint& b = port_of(component(joint.b), joint.port_b);
    const std::string both = mention(component(joint.a)) + " and " + mention(component(joint.b));
    if (a.nps > 0 && b.nps > 0 && std::abs(a.nps - b.nps) > 1e-3)
      tell(b.line, both + " meet with different bores, NPS " + nps_text(a.nps) + " and NPS " +
                       nps_text(b.nps));
    if (joint.kind == PipeJoint::Kind::kOther && (a.end == "FL") != (b.end == "FL"))
      tell(b.line, both + " meet with ends that do not fit, " +
                       end_type(component(joint.a), joint.port_a) + " and " +
                       end_type(component(joint.b), joint.port_b));
  }

  // The joint at which a WELD record stands.
  void place_weld(int index) {
    const Component& weld = component(index);
    const auto stands = [&](const PipeJoint& joint) { return joint.weld == index; };
    if (std::any_of(out_.joints.begin(), out_.joints.end(), stands)) return;
    const std::vector<PipePoint>& points = weld.ends.empty() ? weld.places : weld.ends;
    if (points.empty()) {
      tell(weld.line, mention(weld) + " has no place; it is left out");
      return;
    }
    const Eigen::Vector3d place = (points.front().position + points.back().position) / 2;
    PipeJoint* best = nullptr;
    double nearest = kNearby;
    for (PipeJoint& joint : out_.joints) {
      const double distance = distance_to(joint, place);
      if (joint.weld >= 0 || distance > nearest) continue;
      nearest = distance;
      best = &joint;
    }
    if (best == nullptr) {
      tell(weld.line, mention(weld) + " stands where no two ends meet");
      return;
    }
    best->weld = index;
    if (best->kind == PipeJoint::Kind::kOther) best->kind = PipeJoint::Kind::kWeld;
    if (best->kind == PipeJoint::Kind::kBolted || best->kind == PipeJoint::Kind::kThreaded)
      tell(weld.line, mention(weld) + " stands at a joint that is not welded");
  }

  // A branch fitting's weld is drawn on the run's axis or on its surface.
  double distance_to(const PipeJoint& joint, const Eigen::Vector3d& place) {
    const double to_axis = (joint.place - place).norm();
    if (joint.port_a != kOnRun) return to_axis;
    const Component& fitting = component(joint.b);
    if (fitting.branches.empty()) return to_axis;
    const Eigen::Vector3d along = fitting.branches.front().position - joint.place;
    const double share =
        std::clamp((place - joint.place).dot(along) / along.squaredNorm(), 0.0, 0.9);
    return std::isfinite(share) ? (joint.place + share * along - place).norm() : to_axis;
  }

  void report_gap(const PipeJoint& joint) {
    if (joint.gap <= kMeets || joint.port_a == kOnRun) return;
    const Component& a = component(joint.a);
    const Component& b = component(joint.b);
    const PipePoint& from = port_of(a, joint.port_a);
    const PipePoint& to = port_of(b, joint.port_b);
    const Eigen::Vector3d outward = a.directions[static_cast<std::size_t>(joint.port_a)];
    const double along = (to.position - from.position).dot(outward);
    // Along the pipe, the gap of a weld is meant; ends that miss each other sideways never are.
    if (joint.weld >= 0 && along > 0.7 * joint.gap) return;
    std::string what = "side by side";
    if (std::abs(along) > 0.7 * joint.gap) what = along > 0 ? "a gap" : "an overlap";
    const bool faces = joint.kind == PipeJoint::Kind::kBolted && along > 0;
    tell(to.line,
         mention(a) + " and " + mention(b) + " are " +
             std::to_string(joint.gap * 1000).substr(0, 4) + " mm apart (" + what +
             (faces ? ", room for a gasket that the file does not have)" : "); nothing is moved"));
  }

  // More than two ends at one place: the rest stay open.
  void report_crowds(const PortGrid& grid) {
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      if (taken_[p]) continue;
      std::size_t other = ports_.size();
      grid.near(ports_[p].position, [&](std::size_t each, double distance) {
        if (each != p && distance <= kMeets && ports_[each].component != ports_[p].component)
          other = each;
      });
      if (other == ports_.size()) continue;
      tell(port_of(component(ports_[p].component), ports_[p].port).line,
           mention(component(ports_[p].component)) +
               " ends where two others already meet, one of " + "them " +
               mention(component(ports_[other].component)));
    }
  }

  Pipework& out_;
  std::vector<Port> ports_;
  std::vector<bool> taken_;
};

}  // namespace

void connect(Pipework& pipework) {
  pipework.joints.clear();
  Connector(pipework).run();
}

std::string end_type(const Component& component, int port) {
  const PipePoint& point = port_of(component, port);
  if (!point.end.empty()) return point.end;
  const std::string by_key(end_type_of_skey(component.skey));
  switch (component.kind) {
    case ComponentKind::kGasket:
    case ComponentKind::kBlind:
      return "FL";
    case ComponentKind::kFlange:
    case ComponentKind::kStubEnd:
      if (port == component.face) return "FL";
      if (component.form == FlangeForm::kSocketWeld) return "SW";
      return component.form == FlangeForm::kThreaded ? "SC" : "BW";
    case ComponentKind::kOlet:
      if (component.skey.substr(0, 2) == "SK") return "SW";
      if (component.skey.substr(0, 2) == "TH") return "SC";
      return by_key.empty() ? "BW" : by_key;
    case ComponentKind::kPipe:
    case ComponentKind::kElbow:
    case ComponentKind::kTee:
    case ComponentKind::kCross:
    case ComponentKind::kReducer:
    case ComponentKind::kCap:
      return by_key.empty() ? "BW" : by_key;
    default:
      return by_key;
  }
}

}  // namespace spool::piping
