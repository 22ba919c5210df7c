// From a record of a Piping Component File to a component, still in the file's units.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/pcf_components.h"

#include <array>
#include <string_view>

#include "vision/piping/pcf_numbers.h"

namespace spool::piping {
namespace {

constexpr std::size_t kMostPoints = 64;  // of one component, of each kind

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

// FABRICATION-ITEM and its like are flags: given without a value, or with a word for yes.
bool is_set(std::string_view value) {
  const std::string word = to_capitals(value);
  return word != "NO" && word != "OFF" && word != "FALSE" && word != "0" && word != "N";
}

class Reader {
 public:
  Reader(Component& out, std::vector<Problem>& problems) : out_(out), problems_(problems) {}

  void take(const PcfAttribute& each) {
    const std::string_view key = each.keyword;
    if (key == "TAP-CONNECTION") {
      in_tap_ = true;
      if (const auto tap = point_of(each.value)) keep(out_.taps, *tap, each);
      return;
    }
    if (key == "CO-ORDS") {
      add(in_tap_ ? out_.taps : out_.places, each);
      return;
    }
    in_tap_ = false;
    if (key == "END-POINT") {
      add(out_.ends, each);
    } else if (key == "CENTRE-POINT") {
      std::vector<PipePoint> one;
      add(one, each);
      if (out_.centre && !one.empty())
        tell(each, "a second CENTRE-POINT is left out");
      else if (!one.empty())
        out_.centre = one.front();
    } else if (starts_with(key, "BRANCH") && key.size() > 6 &&
               key.substr(key.size() - 6) == "-POINT") {
      add(out_.branches, each);
    } else if (!take_text(each)) {
      take_value(each);
    }
  }

 private:
  void tell(const PcfAttribute& each, const std::string& what) {
    problems_.push_back({each.line, what});
  }

  void keep(std::vector<PipePoint>& into, const RawPoint& raw, const PcfAttribute& each) {
    if (!raw.trouble.empty()) tell(each, raw.trouble);
    if (into.size() == kMostPoints) {
      tell(each, "a component has at most " + std::to_string(kMostPoints) + " such points");
      return;
    }
    PipePoint point;
    point.position = raw.position;
    point.nps = raw.bore.value_or(0);
    point.end = raw.end;
    point.line = each.line;
    into.push_back(point);
  }

  void add(std::vector<PipePoint>& into, const PcfAttribute& each) {
    if (const auto raw = point_of(each.value))
      keep(into, *raw, each);
    else
      tell(each, each.keyword + " '" + each.value.substr(0, 60) +
                     "' does not start with three numbers; it is left out");
  }

  // Attributes that are text. False for others.
  bool take_text(const PcfAttribute& each) {
    const std::string_view key = each.keyword;
    const auto set = [&](std::string& field) {
      if (field.empty()) field = each.value;
      return true;
    };
    if (key == "SKEY") {
      out_.skey = to_capitals(each.value);
      return true;
    }
    if (key == "ITEM-CODE") return set(out_.item_code);
    if (key == "DESCRIPTION" || key == "ITEM-DESCRIPTION") {
      if (!out_.description.empty()) out_.description += ' ';
      out_.description += each.value;
      return true;
    }
    if (key == "TAG" || key == "NAME") return set(out_.tag);
    if (key == "SPOOL-IDENTIFIER") return set(out_.spool);
    if (key == "HEAT-NUMBER") return set(out_.heat);
    if (key == "PIECE-NUMBER" || key == "PIECE-MARK") return set(out_.piece);
    if (key == "CATEGORY") return set(out_.category);
    if (key == "COMPONENT-IDENTIFIER" || key == "UNIQUE-COMPONENT-IDENTIFIER") return set(out_.id);
    if (key == "SCHEDULE") return set(out_.schedule);
    if (key == "WELD-NUMBER" || key == "REPEAT-WELD-IDENTIFIER") return set(out_.weld_number);
    return false;
  }

  void take_value(const PcfAttribute& each) {
    const std::string_view key = each.keyword;
    if (key == "ERECTION-ITEM" || key == "OFFSHORE-ITEM") {
      out_.is_erection = is_set(each.value);
    } else if (key == "FABRICATION-ITEM") {
      if (is_set(each.value)) out_.is_erection = false;
    } else if (key == "ANGLE") {
      out_.angle = number_of(each.value);
      if (!out_.angle) tell(each, "the angle '" + each.value.substr(0, 60) + "' is no number");
    } else if (key == "BEND-RADIUS") {
      const auto radius = number_of(each.value);
      if (radius && *radius > 0)
        out_.bend_radius = *radius;
      else
        tell(each, "the bend radius '" + each.value.substr(0, 60) + "' is no length");
    } else if (key == "SPINDLE-DIRECTION") {
      out_.spindle = direction_of(each.value);
      if (!out_.spindle) tell(each, "'" + each.value.substr(0, 60) + "' is no direction");
    } else if (key == "FLAT-DIRECTION") {
      out_.flat_side = direction_of(each.value);
      if (!out_.flat_side) tell(each, "'" + each.value.substr(0, 60) + "' is no direction");
    }
  }

  Component& out_;
  std::vector<Problem>& problems_;
  bool in_tap_ = false;  // CO-ORDS are a tap's
};

// Number and place of a weld out of what writers put them into.
void read_weld(const PcfRecord& record, Component& out) {
  std::string said = out.category;
  for (const PcfAttribute& each : record.attributes) {
    if (!starts_with(each.keyword, "WELD-ATTRIBUTE")) continue;
    said += ' ' + each.value;
    if (out.weld_number.empty() && !each.value.empty() && each.value.size() <= 24 &&
        !weld_place_of_text(each.value))
      out.weld_number = each.value;
  }
  if (out.weld_number.empty()) out.weld_number = out.tag;
  const auto place = weld_place_of_text(said);
  // A yard assembly weld has a site weld's key: the word outranks it.
  out.weld_place = place == WeldPlace::kYaw ? place : weld_place_of_skey(out.skey);
  if (!out.weld_place) out.weld_place = place;
}

}  // namespace

Component read_component(const PcfRecord& record, std::vector<Problem>& problems) {
  Component out;
  out.line = record.line;
  out.keyword = record.keyword;
  out.raw = record.raw;
  Reader reader(out, problems);
  for (const PcfAttribute& each : record.attributes) reader.take(each);
  const auto by_keyword = kind_of_keyword(record.keyword);
  const auto by_skey = kind_of_skey(out.skey);
  out.kind = by_keyword.value_or(by_skey.value_or(ComponentKind::kLink));
  if (out.kind == ComponentKind::kFlange) {
    if (by_skey == ComponentKind::kBlind || by_skey == ComponentKind::kStubEnd) out.kind = *by_skey;
    if (record.keyword == "LAPJOINT-RING") out.form = FlangeForm::kLoose;
    if (const auto form = flange_form_of_skey(out.skey)) out.form = *form;
  }
  const std::string category = to_capitals(out.category);
  if (category == "ERECTION" || category == "OFFSHORE") out.is_erection = true;
  if (out.kind == ComponentKind::kWeld) read_weld(record, out);
  return out;
}

}  // namespace spool::piping
