// The spellings of part kinds and the size of a design.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/design_model.h"

#include <array>
#include <utility>

namespace spool {
namespace {

constexpr std::array<std::pair<PartKind, std::string_view>, 14> kKindNames{{
    {PartKind::kPipe, "pipe"},
    {PartKind::kElbow, "elbow"},
    {PartKind::kTee, "tee"},
    {PartKind::kCross, "cross"},
    {PartKind::kReducer, "reducer"},
    {PartKind::kFlange, "flange"},
    {PartKind::kBlind, "blind"},
    {PartKind::kCap, "cap"},
    {PartKind::kOlet, "olet"},
    {PartKind::kValve, "valve"},
    {PartKind::kGasket, "gasket"},
    {PartKind::kSupport, "support"},
    {PartKind::kStructure, "structure"},
    {PartKind::kOther, "other"},
}};

constexpr std::array<std::pair<EndType, std::string_view>, 5> kEndNames{{
    {EndType::kButtWeld, "BW"},
    {EndType::kFlanged, "FL"},
    {EndType::kSocketWeld, "SW"},
    {EndType::kScrewed, "SC"},
    {EndType::kPlain, "PL"},
}};

constexpr std::array<std::pair<JointType, std::string_view>, 3> kJointNames{{
    {JointType::kFab, "fab"},
    {JointType::kField, "field"},
    {JointType::kYaw, "yaw"},
}};

template <class Names, class Key>
std::string_view spelling(const Names& names, Key key) {
  for (const auto& [each, text] : names) {
    if (each == key) return text;
  }
  return {};
}

template <class Key, std::size_t N>
std::optional<Key> parse(const std::array<std::pair<Key, std::string_view>, N>& names,
                         std::string_view text) {
  for (const auto& [each, spelled] : names) {
    if (spelled == text) return each;
  }
  return std::nullopt;
}

}  // namespace

std::string_view name(PartKind kind) { return spelling(kKindNames, kind); }
std::string_view name(EndType end) { return spelling(kEndNames, end); }
std::string_view name(JointType type) { return spelling(kJointNames, type); }

std::optional<PartKind> parse_part_kind(std::string_view text) { return parse(kKindNames, text); }
std::optional<EndType> parse_end_type(std::string_view text) { return parse(kEndNames, text); }
std::optional<JointType> parse_joint_type(std::string_view text) {
  return parse(kJointNames, text);
}

Eigen::AlignedBox3d DesignModel::bounds() const {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex.cast<double>());
  for (const Eigen::Vector3f& point : cloud.points) {
    if (point.allFinite()) box.extend(point.cast<double>());
  }
  return box;
}

}  // namespace spool
