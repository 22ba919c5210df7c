// Pipework as a piping file tells it: spellings and small questions.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/pipework.h"

#include <cassert>

namespace spool::piping {

std::string_view name(ComponentKind kind) {
  switch (kind) {
    case ComponentKind::kPipe:
      return "pipe";
    case ComponentKind::kElbow:
      return "elbow";
    case ComponentKind::kTee:
      return "tee";
    case ComponentKind::kCross:
      return "cross";
    case ComponentKind::kOlet:
      return "olet";
    case ComponentKind::kFlange:
      return "flange";
    case ComponentKind::kStubEnd:
      return "stub-end";
    case ComponentKind::kBlind:
      return "blind";
    case ComponentKind::kReducer:
      return "reducer";
    case ComponentKind::kCap:
      return "cap";
    case ComponentKind::kValve:
      return "valve";
    case ComponentKind::kInstrument:
      return "instrument";
    case ComponentKind::kGasket:
      return "gasket";
    case ComponentKind::kBolt:
      return "bolt";
    case ComponentKind::kWeld:
      return "weld";
    case ComponentKind::kSupport:
      return "support";
    case ComponentKind::kLink:
      break;
  }
  return "item";
}

std::string_view name(WeldPlace place) {
  if (place == WeldPlace::kYaw) return "yaw";
  return place == WeldPlace::kFab ? "fab" : "field";
}

const PipePoint& port_of(const Component& component, int port) {
  assert(port >= 0 && port < port_count(component) && "a port that the component does not have");
  const auto at = static_cast<std::size_t>(port);
  return at < component.ends.size() ? component.ends[at]
                                    : component.branches[at - component.ends.size()];
}

int port_count(const Component& component) {
  return static_cast<int>(component.ends.size() + component.branches.size());
}

bool is_body(const Component& component) {
  return component.kind != ComponentKind::kWeld && component.kind != ComponentKind::kBolt &&
         component.kind != ComponentKind::kSupport;
}

std::string mention(const Component& component) {
  return component.keyword + " (line " + std::to_string(component.line) + ")";
}

}  // namespace spool::piping
