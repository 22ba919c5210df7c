// Numbers of welds and the spools that they make.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/spools.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace spool::piping {
namespace {

bool is_welded(const PipeJoint& joint) {
  return joint.kind == PipeJoint::Kind::kWeld || joint.kind == PipeJoint::Kind::kSocketWeld;
}

// What a shop welds into a spool.
bool is_fabricated(const Component& component) {
  return is_body(component) && !component.is_erection && component.kind != ComponentKind::kGasket;
}

WeldPlace place_without_record(const Component& a, const Component& b) {
  const bool two_spools = !a.spool.empty() && !b.spool.empty() && a.spool != b.spool;
  return a.is_erection || b.is_erection || two_spools ? WeldPlace::kField : WeldPlace::kFab;
}

void name_welds(Pipework& pipework) {
  const auto component = [&](int index) -> const Component& {
    return pipework.components[static_cast<std::size_t>(index)];
  };
  std::map<std::string, int> taken;  // number to line
  for (PipeJoint& joint : pipework.joints) {
    if (joint.weld < 0) continue;
    const Component& weld = component(joint.weld);
    joint.number = weld.weld_number;
    joint.where =
        weld.weld_place.value_or(place_without_record(component(joint.a), component(joint.b)));
    if (!weld.weld_place)
      pipework.problems.push_back({weld.line, mention(weld) + " does not say shop or site; " +
                                                  std::string(name(joint.where)) + " is taken"});
    if (joint.number.empty()) continue;
    const auto [first, is_new] = taken.emplace(joint.number, weld.line);
    if (!is_new)
      pipework.problems.push_back({weld.line, "weld number " + joint.number +
                                                  " is given twice, first in line " +
                                                  std::to_string(first->second)});
  }
  int next = 1;
  for (PipeJoint& joint : pipework.joints) {
    if (!is_welded(joint) || !joint.number.empty()) continue;
    if (joint.weld < 0) joint.where = place_without_record(component(joint.a), component(joint.b));
    do {
      joint.number = "W" + std::to_string(next++) + "?";
    } while (taken.count(joint.number) != 0);
    joint.is_made_up = true;
  }
}

// Sets of components (union by root).
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int i) {
    while (parent_[static_cast<std::size_t>(i)] != i) {
      int& parent = parent_[static_cast<std::size_t>(i)];
      parent = parent_[static_cast<std::size_t>(parent)];
      i = parent;
    }
    return i;
  }
  void join(int a, int b) { parent_[static_cast<std::size_t>(root(a))] = root(b); }

 private:
  std::vector<int> parent_;
};

Sets shop_welded(const Pipework& pipework) {
  Sets sets(pipework.components.size());
  for (const PipeJoint& joint : pipework.joints) {
    const bool holds = is_welded(joint) && joint.where == WeldPlace::kFab &&
                       is_fabricated(pipework.components[static_cast<std::size_t>(joint.a)]) &&
                       is_fabricated(pipework.components[static_cast<std::size_t>(joint.b)]);
    if (holds) sets.join(joint.a, joint.b);
  }
  return sets;
}

// A component without an identifier, welded in the shop to one spool only, is of that spool.
void spread_identifiers(Pipework& pipework, Sets& sets) {
  std::map<int, std::set<std::string>> names;
  for (std::size_t c = 0; c < pipework.components.size(); ++c) {
    const Component& each = pipework.components[c];
    if (!each.spool.empty()) names[sets.root(static_cast<int>(c))].insert(each.spool);
  }
  for (std::size_t c = 0; c < pipework.components.size(); ++c) {
    Component& each = pipework.components[c];
    if (!each.spool.empty() || !is_fabricated(each)) continue;
    const auto found = names.find(sets.root(static_cast<int>(c)));
    if (found != names.end() && found->second.size() == 1) each.spool = *found->second.begin();
  }
}

void make_up_identifiers(Pipework& pipework, Sets& sets) {
  std::map<int, std::vector<int>> members;
  for (std::size_t c = 0; c < pipework.components.size(); ++c) {
    if (is_fabricated(pipework.components[c]))
      members[sets.root(static_cast<int>(c))].push_back(static_cast<int>(c));
  }
  std::vector<std::vector<int>> by_file;
  for (auto& [root, list] : members) {
    if (list.size() > 1) by_file.push_back(std::move(list));
  }
  std::sort(by_file.begin(), by_file.end());
  int number = 0;
  for (const std::vector<int>& list : by_file) {
    const int pipeline = pipework.components[static_cast<std::size_t>(list.front())].pipeline;
    std::string prefix =
        pipeline < 0 ? "" : pipework.pipelines[static_cast<std::size_t>(pipeline)].spool_prefix;
    if (prefix.empty()) prefix = "SPOOL-";
    const std::string spool = prefix + std::to_string(++number);
    for (const int c : list) pipework.components[static_cast<std::size_t>(c)].spool = spool;
  }
}

}  // namespace

void name_welds_and_spools(Pipework& pipework) {
  name_welds(pipework);
  Sets sets = shop_welded(pipework);
  const bool has_identifiers =
      std::any_of(pipework.components.begin(), pipework.components.end(),
                  [](const Component& each) { return is_body(each) && !each.spool.empty(); });
  if (has_identifiers)
    spread_identifiers(pipework, sets);
  else
    make_up_identifiers(pipework, sets);
  pipework.spools.clear();
  std::map<std::string, std::size_t> places;
  for (std::size_t c = 0; c < pipework.components.size(); ++c) {
    const Component& each = pipework.components[c];
    if (!is_body(each) || each.spool.empty()) continue;
    const auto [place, is_new] = places.emplace(each.spool, pipework.spools.size());
    if (is_new) pipework.spools.push_back({each.spool, !has_identifiers, {}});
    pipework.spools[place->second].components.push_back(static_cast<int>(c));
  }
}

Result<Pipework> only_spool(const Pipework& pipework, const std::string& spool) {
  const auto found = std::find_if(pipework.spools.begin(), pipework.spools.end(),
                                  [&](const Spool& each) { return each.name == spool; });
  if (found == pipework.spools.end()) {
    std::string known;
    for (const Spool& each : pipework.spools) known += (known.empty() ? "" : ", ") + each.name;
    return Error{ErrorCode::kBadInput, "'" + spool + "' is no spool of the file; its spools are " +
                                           (known.empty() ? "none" : known)};
  }
  std::set<int> kept(found->components.begin(), found->components.end());
  for (const PipeJoint& joint : pipework.joints) {
    if (joint.weld >= 0 && kept.count(joint.a) != 0 && kept.count(joint.b) != 0)
      kept.insert(joint.weld);
  }
  Pipework out = pipework;
  out.components.clear();
  out.joints.clear();
  out.spools.clear();
  out.problems.clear();
  std::map<int, int> place;
  for (const int c : kept) {
    place[c] = static_cast<int>(out.components.size());
    out.components.push_back(pipework.components[static_cast<std::size_t>(c)]);
  }
  for (PipeJoint joint : pipework.joints) {
    if (place.count(joint.a) == 0 || place.count(joint.b) == 0) continue;
    joint.a = place[joint.a];
    joint.b = place[joint.b];
    if (joint.weld >= 0) joint.weld = place[joint.weld];
    out.joints.push_back(joint);
  }
  out.spools.push_back({found->name, found->is_made_up, {}});
  for (const int c : found->components) out.spools.front().components.push_back(place[c]);
  // A problem belongs to the component within whose lines it lies.
  for (const Problem& each : pipework.problems) {
    const auto next = std::upper_bound(
        pipework.components.begin(), pipework.components.end(), each.line,
        [](int line, const Component& component) { return line < component.line; });
    const int owner = static_cast<int>(next - pipework.components.begin()) - 1;
    if (owner < 0 || place.count(owner) != 0) out.problems.push_back(each);
  }
  return out;
}

}  // namespace spool::piping
