// The words of a Piping Component File: tables of keywords and symbol keys.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/pcf_keywords.h"

#include <algorithm>
#include <array>
#include <utility>

#include "vision/piping/pcf_text.h"

namespace spool::piping {
namespace {

using Kind = ComponentKind;

constexpr std::array<std::pair<std::string_view, Kind>, 45> kComponents{{
    {"PIPE", Kind::kPipe},
    {"PIPE-FIXED", Kind::kPipe},
    {"PIPE-BLOCK-FIXED", Kind::kPipe},
    {"PIPE-BLOCK-VARIABLE", Kind::kPipe},
    {"ELBOW", Kind::kElbow},
    {"BEND", Kind::kElbow},
    {"ELBOW-REDUCING", Kind::kElbow},
    {"TEE", Kind::kTee},
    {"TEE-SET-ON", Kind::kTee},
    {"TEE-STUB", Kind::kTee},
    {"CROSS", Kind::kCross},
    {"CROSS-SET-ON", Kind::kCross},
    {"CROSS-STUB", Kind::kCross},
    {"OLET", Kind::kOlet},
    {"ELBOLET", Kind::kOlet},
    {"FLANGE", Kind::kFlange},
    {"FLANGE-REDUCING-CONCENTRIC", Kind::kFlange},
    {"FLANGE-REDUCING-ECCENTRIC", Kind::kFlange},
    {"LAPJOINT-RING", Kind::kFlange},
    {"LAPJOINT-STUBEND", Kind::kStubEnd},
    {"FLANGE-BLIND", Kind::kBlind},
    {"REDUCER-CONCENTRIC", Kind::kReducer},
    {"REDUCER-CONCENTRIC-TEED", Kind::kReducer},
    {"REDUCER-ECCENTRIC", Kind::kReducer},
    {"REDUCER-ECCENTRIC-TEED", Kind::kReducer},
    {"CAP", Kind::kCap},
    {"GASKET", Kind::kGasket},
    {"BOLT", Kind::kBolt},
    {"WELD", Kind::kWeld},
    {"SUPPORT", Kind::kSupport},
    {"SAFETY-DISC", Kind::kLink},
    {"UNION", Kind::kLink},
    {"COUPLING", Kind::kLink},
    {"CLAMP", Kind::kLink},
    {"NUT", Kind::kLink},
    {"CONNECTOR", Kind::kLink},
    {"REINFORCEMENT-PAD", Kind::kLink},
    {"NOZZLE", Kind::kLink},
    {"PENETRATION-PLATE", Kind::kLink},
    {"MULTI-PORT-COMPONENT", Kind::kLink},
    {"HOSE", Kind::kLink},
    {"EXPANSION-BELLOWS", Kind::kLink},
    {"BLIND", Kind::kBlind},
    {"REDUCER", Kind::kReducer},
    {"STUB-END", Kind::kStubEnd},
}};

// Families: VALVE, VALVE-ANGLE, VALVE-3WAY ...
constexpr std::array<std::pair<std::string_view, Kind>, 6> kFamilies{{
    {"VALVE", Kind::kValve},
    {"INSTRUMENT", Kind::kInstrument},
    {"FILTER", Kind::kLink},
    {"TRAP", Kind::kLink},
    {"MISC-COMPONENT", Kind::kLink},
    {"Y-PIECE", Kind::kLink},
}};

// By the first two letters of a symbol key.
constexpr std::array<std::pair<std::string_view, Kind>, 47> kSkeys{{
    {"EL", Kind::kElbow},      {"ER", Kind::kElbow},      {"BE", Kind::kElbow},
    {"BM", Kind::kElbow},      {"MI", Kind::kElbow},      {"PB", Kind::kElbow},
    {"TE", Kind::kTee},        {"TS", Kind::kTee},        {"TY", Kind::kTee},
    {"CR", Kind::kCross},      {"RC", Kind::kReducer},    {"RE", Kind::kReducer},
    {"KA", Kind::kCap},        {"CO", Kind::kLink},       {"UN", Kind::kLink},
    {"WT", Kind::kOlet},       {"SK", Kind::kOlet},       {"TH", Kind::kOlet},
    {"NI", Kind::kOlet},       {"LA", Kind::kOlet},       {"SW", Kind::kOlet},
    {"HC", Kind::kOlet},       {"FL", Kind::kFlange},     {"FO", Kind::kFlange},
    {"VT", Kind::kValve},      {"VG", Kind::kValve},      {"VB", Kind::kValve},
    {"VC", Kind::kValve},      {"CK", Kind::kValve},      {"VY", Kind::kValve},
    {"VP", Kind::kValve},      {"VN", Kind::kValve},      {"VD", Kind::kValve},
    {"VV", Kind::kValve},      {"AV", Kind::kValve},      {"CV", Kind::kInstrument},
    {"II", Kind::kInstrument}, {"ID", Kind::kInstrument}, {"OP", Kind::kInstrument},
    {"PR", Kind::kInstrument}, {"DR", Kind::kInstrument}, {"WW", Kind::kWeld},
    {"WS", Kind::kWeld},       {"WF", Kind::kWeld},       {"WO", Kind::kWeld},
    {"WM", Kind::kWeld},       {"GA", Kind::kGasket},
}};

constexpr std::array<std::string_view, 13> kNotices{
    "MESSAGE",      "FLOW-ARROW",    "ISO-SPLIT-POINT", "REFERENCE-DIMENSION", "INSULATION-SYMBOL",
    "FLOOR-SYMBOL", "WALL-SYMBOL",   "LOCATION-POINT",  "START-POINT",         "ITEM-POINT",
    "SPLIT-POINT",  "PIPELINE-NOTE", "BORE-NOTE"};

// Attributes that some writer puts at the margin, where records stand.
constexpr std::array<std::string_view, 50> kAttributes{"END-POINT",
                                                       "CENTRE-POINT",
                                                       "CO-ORDS",
                                                       "SKEY",
                                                       "DESCRIPTION",
                                                       "ITEM-CODE",
                                                       "ITEM-DESCRIPTION",
                                                       "ANGLE",
                                                       "CATEGORY",
                                                       "WEIGHT",
                                                       "FABRICATION-ITEM",
                                                       "ERECTION-ITEM",
                                                       "OFFSHORE-ITEM",
                                                       "SPOOL-IDENTIFIER",
                                                       "PIPING-SPEC",
                                                       "TAG",
                                                       "CONTINUATION",
                                                       "INSULATION",
                                                       "STATUS",
                                                       "MATERIAL-LIST",
                                                       "HEAT-NUMBER",
                                                       "BEND-RADIUS",
                                                       "FLAT-DIRECTION",
                                                       "SPINDLE-DIRECTION",
                                                       "DIRECTION",
                                                       "SUPPORT-DIRECTION",
                                                       "NAME",
                                                       "REPEAT-WELD-IDENTIFIER",
                                                       "MASTER-COMPONENT-IDENTIFIER",
                                                       "TAP-CONNECTION",
                                                       "NOMINAL-CLASS",
                                                       "REVISION",
                                                       "PROJECT-IDENTIFIER",
                                                       "AREA",
                                                       "BATCH",
                                                       "LINE-ID",
                                                       "PIPELINE-TEMP",
                                                       "PIPELINE-TYPE",
                                                       "SPECIFIC-GRAVITY",
                                                       "SPOOL-PREFIX",
                                                       "START-CO-ORDS",
                                                       "MATERIAL-IDENTIFIER",
                                                       "UNIQUE-COMPONENT-IDENTIFIER",
                                                       "COMPONENT-IDENTIFIER",
                                                       "WELD-NUMBER",
                                                       "TEXT",
                                                       "PIECE-NUMBER",
                                                       "PIECE-MARK",
                                                       "UCI",
                                                       "SCHEDULE"};
constexpr std::array<std::string_view, 11> kAttributeStarts{
    "BRANCH",         "ITEM-ATTRIBUTE", "COMPONENT-ATTRIBUTE",
    "WELD-ATTRIBUTE", "ATTRIBUTE",      "MISC-SPEC",
    "DATE-",          "BOLT-",          "TRACING",
    "PAINTING",       "INSULATION-S"};

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

template <class Table>
bool holds(const Table& table, std::string_view word) {
  return std::find(table.begin(), table.end(), word) != table.end();
}

}  // namespace

std::string_view canonical(std::string_view keyword) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 17> kSpellings{{
      {"CENTER-POINT", "CENTRE-POINT"},
      {"CENTREPOINT", "CENTRE-POINT"},
      {"CENTERPOINT", "CENTRE-POINT"},
      {"ENDPOINT", "END-POINT"},
      {"COORDS", "CO-ORDS"},
      {"CO-ORD", "CO-ORDS"},
      {"COORD", "CO-ORDS"},
      {"COORDINATES", "CO-ORDS"},
      {"BRANCH-POINT", "BRANCH1-POINT"},
      {"BRANCHPOINT", "BRANCH1-POINT"},
      {"UCI", "UNIQUE-COMPONENT-IDENTIFIER"},
      {"MATERIAL-IDENTIFIER", "ITEM-CODE"},
      {"SPOOL-ID", "SPOOL-IDENTIFIER"},
      {"ITEMCODE", "ITEM-CODE"},
      {"SYMBOL-KEY", "SKEY"},
      {"PIPELINE-REF", "PIPELINE-REFERENCE"},
      {"MATERIAL", "MATERIALS"},
  }};
  for (const auto& [written, meant] : kSpellings) {
    if (keyword == written) return meant;
  }
  return keyword;
}

KeywordRole role_of(std::string_view keyword) {
  if (starts_with(keyword, "UNITS-") || keyword == "ISOGEN-FILES") return KeywordRole::kHeader;
  if (keyword == "PIPELINE-REFERENCE") return KeywordRole::kPipeline;
  if (keyword == "MATERIALS") return KeywordRole::kMaterials;
  if (starts_with(keyword, "END-CONNECTION-") || starts_with(keyword, "END-POSITION-"))
    return KeywordRole::kEnd;
  if (kind_of_keyword(keyword)) return KeywordRole::kComponent;
  if (holds(kAttributes, keyword)) return KeywordRole::kAttribute;
  if (holds(kNotices, keyword) || starts_with(keyword, "MESSAGE-")) return KeywordRole::kNotice;
  if (std::any_of(kAttributeStarts.begin(), kAttributeStarts.end(),
                  [&](std::string_view start) { return starts_with(keyword, start); }))
    return KeywordRole::kAttribute;
  return KeywordRole::kUnknown;
}

std::optional<ComponentKind> kind_of_keyword(std::string_view keyword) {
  for (const auto& [word, kind] : kComponents) {
    if (word == keyword) return kind;
  }
  for (const auto& [word, kind] : kFamilies) {
    if (keyword == word || (starts_with(keyword, word) && keyword[word.size()] == '-')) return kind;
  }
  return std::nullopt;
}

std::optional<ComponentKind> kind_of_skey(std::string_view skey) {
  if (skey == "FLBL") return Kind::kBlind;
  if (skey == "FLSE") return Kind::kStubEnd;
  for (const auto& [start, kind] : kSkeys) {
    if (starts_with(skey, start)) return kind;
  }
  return std::nullopt;
}

std::string_view end_type_of_skey(std::string_view skey) {
  if (skey.size() != 4) return {};
  constexpr std::array<std::string_view, 8> kTypes{"BW", "SW", "SC", "FL", "PL", "CP", "GL", "CL"};
  const std::string_view last = skey.substr(2);
  return holds(kTypes, last) ? last : std::string_view{};
}

std::optional<FlangeForm> flange_form_of_skey(std::string_view skey) {
  if (skey.size() < 4 || (!starts_with(skey, "FL") && !starts_with(skey, "FO")))
    return std::nullopt;
  const std::string_view form = skey.substr(2, 2);
  if (form == "SO") return FlangeForm::kSlipOn;
  if (form == "SW") return FlangeForm::kSocketWeld;
  if (form == "SC") return FlangeForm::kThreaded;
  if (form == "LB") return FlangeForm::kLoose;
  return FlangeForm::kWeldNeck;
}

std::optional<WeldPlace> weld_place_of_skey(std::string_view skey) {
  if (starts_with(skey, "WW") || starts_with(skey, "WM")) return WeldPlace::kFab;
  if (starts_with(skey, "WS") || starts_with(skey, "WF") || starts_with(skey, "WO") ||
      starts_with(skey, "XX"))
    return WeldPlace::kField;
  return std::nullopt;
}

std::optional<WeldPlace> weld_place_of_text(std::string_view text) {
  const std::string capitals = to_capitals(text);
  const auto says = [&](std::string_view word) { return capitals.find(word) != std::string::npos; };
  if (says("YAW") || says("YARD")) return WeldPlace::kYaw;
  if (says("FIELD") || says("SITE") || says("ERECTION") || says("OFFSHORE"))
    return WeldPlace::kField;
  if (says("SHOP") || says("FABRICAT")) return WeldPlace::kFab;
  return std::nullopt;
}

}  // namespace spool::piping
