// A Piping Component File read as pipework: records to components, units, materials, joints.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/pcf_reader.h"

#include <algorithm>
#include <map>
#include <set>

#include "vision/piping/catalogue.h"
#include "vision/piping/item_text.h"
#include "vision/piping/joint_graph.h"
#include "vision/piping/pcf_components.h"
#include "vision/piping/pcf_numbers.h"
#include "vision/piping/pcf_units.h"
#include "vision/piping/size_checks.h"
#include "vision/piping/spools.h"

namespace spool::piping {
namespace {

constexpr std::size_t kMaxComponents = 20'000;
constexpr double kFurthest = 1e8;  // m; no plant's grid has larger numbers
constexpr double kWidest = 5;      // m; twice the largest pipe of B36.10M

// Units as they hold for a stretch of the file.
struct Units {
  std::optional<BoreUnit> bore;
  std::optional<double> coordinate;  // m
  int line = 0;
};

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

// Every point of a component.
template <class Each>
void for_each_point(Component& component, const Each& use) {
  for (auto* list : {&component.ends, &component.branches, &component.places, &component.taps}) {
    for (PipePoint& point : *list) use(point);
  }
  if (component.centre) use(*component.centre);
}

class Reading {
 public:
  Reading(const std::string& name, std::optional<double> coordinate_unit)
      : name_(name), forced_(coordinate_unit) {}

  Result<Pipework> read(std::string_view bytes) {
    const Result<PcfText> text = read_pcf_text(bytes, name_);
    if (!text) return text.error();
    for (const PcfRecord& record : group_records(text->lines, out_.problems)) take(record);
    const bool has_body = std::any_of(out_.components.begin(), out_.components.end(),
                                      [](const Component& each) { return port_count(each) > 0; });
    if (!has_body)
      return bad(
          "holds no piping component with an END-POINT; it is no Piping Component File, or "
          "an empty one");
    if (out_.components.size() > kMaxComponents)
      return bad("holds " + std::to_string(out_.components.size()) + " components, more than the " +
                 std::to_string(kMaxComponents) + " that are read; export one line at a time");
    drop_zeros();
    if (out_.components.empty())
      return bad("has only zeros for coordinates; export it with its geometry");
    if (Status settled = settle_units(); !settled) return settled.error();
    apply_units();
    apply_materials();
    seat_stubs();
    connect(out_);
    check_sizes(out_);
    name_welds_and_spools(out_);
    std::stable_sort(out_.problems.begin(), out_.problems.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    return std::move(out_);
  }

 private:
  [[nodiscard]] Error bad(const std::string& what) const {
    return {ErrorCode::kBadInput, name_ + " " + what};
  }
  void tell(int line, const std::string& what) { out_.problems.push_back({line, what}); }

  void take(const PcfRecord& record) {
    switch (record.role) {
      case KeywordRole::kHeader:
        take_header(record);
        break;
      case KeywordRole::kPipeline:
        out_.pipelines.push_back({record.line, record.value,
                                  std::string(record.attribute("PIPING-SPEC")),
                                  rating_of_class(record.attribute("NOMINAL-CLASS")),
                                  std::string(record.attribute("REVISION")),
                                  std::string(record.attribute("SPOOL-PREFIX"))});
        break;
      case KeywordRole::kMaterials:
        take_materials(record);
        break;
      case KeywordRole::kEnd: {
        LineEnd end{record.line, record.keyword, record.value, std::nullopt};
        if (const auto place = point_of(record.attribute("CO-ORDS"))) end.place = place->position;
        out_.line_ends.push_back(end);
        end_units_.push_back(units_.size());
        break;
      }
      case KeywordRole::kComponent:
        add(read_component(record, out_.problems));
        break;
      case KeywordRole::kUnknown:
        if (record.has("END-POINT")) add(read_component(record, out_.problems));
        break;
      case KeywordRole::kNotice:
      case KeywordRole::kAttribute:
        break;
    }
  }

  // "150", "CL150", "CLASS 150".
  static std::string rating_of_class(std::string_view text) {
    const std::string found = rating_in(text);
    const auto number = number_of(text);
    return found.empty() && number ? std::to_string(static_cast<int>(std::min(*number, 9999.0)))
                                   : found;
  }

  void add(Component component) {
    component.pipeline = static_cast<int>(out_.pipelines.size()) - 1;
    out_.components.push_back(std::move(component));
    component_units_.push_back(units_.size());
    units_used_ = true;
  }

  // UNITS-BORE and UNITS-CO-ORDS, and what writers make of them: UNITS-BOREMM MM, UNITS-COOR MM.
  void take_header(const PcfRecord& record) {
    const bool is_bore = starts_with(record.keyword, "UNITS-BORE");
    const bool is_place = starts_with(record.keyword, "UNITS-CO");
    if (!is_bore && !is_place) return;
    if (units_used_) {  // what came before keeps what held then
      units_.push_back(current_);
      units_used_ = false;
    }
    current_.line = record.line;
    if (record.keyword != "UNITS-BORE" && record.keyword != "UNITS-CO-ORDS")
      tell(record.line,
           "'" + record.keyword + "' is read as UNITS-" + (is_bore ? "BORE" : "CO-ORDS"));
    if (is_bore) current_.bore = bore_unit_of(record.value);
    if (is_place) current_.coordinate = coordinate_unit_of(record.value);
    if ((is_bore && !current_.bore) || (is_place && !current_.coordinate))
      tell(record.line, record.keyword + " '" + record.value + "' is no unit that is known");
  }

  void take_materials(const PcfRecord& record) {
    std::string code;
    for (const PcfAttribute& each : record.attributes) {
      if (each.keyword == "ITEM-CODE") {
        code = each.value;
        materials_.emplace(code, "");
      } else if (each.keyword == "DESCRIPTION" && !code.empty()) {
        std::string& text = materials_[code];
        if (!text.empty()) text += ' ';
        text += each.value;
      }
    }
    has_materials_ = true;
  }

  // A component at the origin in a file that lies elsewhere was never placed.
  void drop_zeros() {
    const auto is_zero = [](Component& each) {
      bool any = false;
      bool all_zero = true;
      for_each_point(each, [&](const PipePoint& point) {
        any = true;
        all_zero = all_zero && point.position.isZero(0);
      });
      return any && all_zero;
    };
    std::vector<Component> kept;
    std::vector<std::size_t> kept_units;
    for (std::size_t c = 0; c < out_.components.size(); ++c) {
      if (is_zero(out_.components[c])) {
        tell(out_.components[c].line,
             mention(out_.components[c]) + " has only zeros for coordinates; it is left out");
      } else {
        kept.push_back(std::move(out_.components[c]));
        kept_units.push_back(component_units_[c]);
      }
    }
    const bool any_body = std::any_of(kept.begin(), kept.end(),
                                      [](const Component& each) { return port_count(each) > 0; });
    out_.components = any_body ? std::move(kept) : std::vector<Component>{};
    component_units_ = std::move(kept_units);
  }

  // Decides the units of each stretch of the file.
  Status settle_units() {
    units_.push_back(current_);
    for (std::size_t u = 0; u < units_.size(); ++u) {
      std::vector<double> bores;
      for (std::size_t c = 0; c < out_.components.size(); ++c) {
        if (component_units_[c] != u) continue;
        for_each_point(out_.components[c], [&](const PipePoint& point) {
          if (point.nps > 0) bores.push_back(point.nps);
        });
      }
      if (bores.empty() && u + 1 < units_.size()) continue;
      if (Status settled = settle_bore(units_[u], bores); !settled) return settled;
      if (Status settled = settle_coordinate(units_[u], u); !settled) return settled;
    }
    return {};
  }

  Status settle_bore(Units& units, const std::vector<double>& bores) {
    const auto settled = settle_bore_unit(units.bore, bores);
    if (!settled && !bores.empty())
      return bad(
          "does not say the unit of its bores, which may be inches or mm; add a line "
          "UNITS-BORE INCH or UNITS-BORE MM");
    if (settled != units.bore && settled) {
      tell(units.line,
           (units.bore ? std::string("bores are said to be in ") + std::string(name(*units.bore)) +
                             ", but all of them are sizes in "
                       : std::string("the unit of bores is not said; by their sizes it is ")) +
               std::string(name(*settled)));
      out_.bore_unit_inferred = true;
    }
    units.bore = settled.value_or(BoreUnit::kInch);
    out_.bore_unit = name(*units.bore);
    return {};
  }

  Status settle_coordinate(Units& units, std::size_t index) {
    if (forced_) {
      if (units.coordinate && *units.coordinate != *forced_)
        tell(units.line, "coordinates are said to be in " +
                             std::string(coordinate_unit_name(*units.coordinate)) +
                             "; the unit that was asked for is taken instead");
      units.coordinate = forced_;
    }
    if (!units.coordinate) {
      units.coordinate = guess_coordinate_unit(known_lengths(units, index));
      if (!units.coordinate)
        return bad(
            "does not say the unit of its coordinates and has no fitting that tells it; "
            "confirm it by --design-unit");
      tell(units.line, "the unit of coordinates is not said; by the lengths of fittings it is " +
                           std::string(coordinate_unit_name(*units.coordinate)) +
                           ", confirm it by --design-unit");
      out_.coordinate_unit_inferred = true;
    }
    out_.coordinate_unit = coordinate_unit_name(*units.coordinate);
    return {};
  }

  // Legs of elbows, arms of tees and lengths of flanges beside the catalogue's.
  std::vector<KnownLength> known_lengths(const Units& units, std::size_t index) {
    std::vector<KnownLength> lengths;
    for (std::size_t c = 0; c < out_.components.size(); ++c) {
      const Component& each = out_.components[c];
      if (component_units_[c] != index || each.ends.size() != 2) continue;
      const double nps = read_bore(std::max(each.ends[0].nps, 1e-3), *units.bore).nps;
      const Result<FittingSize> fitting = fitting_size(nps);
      const Result<FlangeSize> flange = flange_size(nps, 150);
      const auto apart = [](const PipePoint& a, const PipePoint& b) {
        return (a.position - b.position).norm();
      };
      if (each.kind == ComponentKind::kElbow && each.centre && fitting) {
        const double turn = bend_angle(each);
        lengths.push_back({apart(each.ends[0], *each.centre),
                           turn > 1.2 ? fitting->elbow_90_long : fitting->elbow_45});
      } else if (each.kind == ComponentKind::kTee && each.centre && fitting) {
        lengths.push_back({apart(each.ends[0], *each.centre), fitting->tee});
      } else if (each.kind == ComponentKind::kFlange && flange) {
        lengths.push_back({apart(each.ends[0], each.ends[1]), flange->weld_neck});
      } else if (each.kind == ComponentKind::kReducer && fitting && fitting->reducer > 0) {
        lengths.push_back({apart(each.ends[0], each.ends[1]), fitting->reducer});
      }
    }
    return lengths;
  }

  // File units to metres, bores to nominal sizes; places that no plant has are left out.
  void apply_units() {
    std::set<std::string> told;
    for (std::size_t c = 0; c < out_.components.size(); ++c) {
      Component& each = out_.components[c];
      const Units& units = units_[std::min(component_units_[c], units_.size() - 1)];
      const double unit = units.coordinate.value_or(0.001);
      each.bend_radius *= unit;
      for (auto* list : {&each.ends, &each.branches, &each.places, &each.taps}) {
        list->erase(std::remove_if(list->begin(), list->end(),
                                   [&](const PipePoint& point) { return is_too_far(point, unit); }),
                    list->end());
      }
      if (each.centre && is_too_far(*each.centre, unit)) each.centre.reset();
      for_each_point(each, [&](PipePoint& point) {
        point.position *= unit;
        if (!(point.nps > 0)) return;
        Bore bore = read_bore(point.nps, units.bore.value_or(BoreUnit::kInch));
        if (bore.outside_diameter > kWidest) bore = {0, 0, "a bore is wider than any pipe"};
        point.nps = bore.nps;
        point.outside_diameter = bore.outside_diameter;
        if (!bore.note.empty() && told.insert(bore.note).second) tell(point.line, bore.note);
      });
      fill_bores(each);
    }
    for (std::size_t e = 0; e < out_.line_ends.size(); ++e) {
      const Units& units = units_[std::min(end_units_[e], units_.size() - 1)];
      if (out_.line_ends[e].place) *out_.line_ends[e].place *= units.coordinate.value_or(0.001);
    }
  }

  bool is_too_far(const PipePoint& point, double unit) {
    if ((point.position * unit).cwiseAbs().maxCoeff() <= kFurthest) return false;
    tell(point.line, "a coordinate is beyond any plant; the point is left out");
    return true;
  }

  // A point without a bore has that of the component's first point with one.
  static void fill_bores(Component& component) {
    const PipePoint* known = nullptr;
    for_each_point(component, [&](PipePoint& point) {
      if (known == nullptr && point.outside_diameter > 0) known = &point;
    });
    if (known == nullptr) return;
    const double nps = known->nps;
    const double diameter = known->outside_diameter;
    for_each_point(component, [&](PipePoint& point) {
      if (point.outside_diameter > 0) return;
      point.nps = nps;
      point.outside_diameter = diameter;
    });
  }

  // A tee whose run ends lie in its centre has no run of its own: it sits on the pipe there.
  void seat_stubs() {
    constexpr double kNoRun = 0.001;  // m
    for (Component& each : out_.components) {
      const bool is_stub =
          each.kind == ComponentKind::kTee && each.centre && !each.branches.empty() &&
          std::all_of(each.ends.begin(), each.ends.end(), [&](const PipePoint& end) {
            return (end.position - each.centre->position).norm() < kNoRun;
          });
      if (!is_stub) continue;
      each.kind = ComponentKind::kOlet;
      each.ends.clear();
      tell(each.line, mention(each) + " has its run in its centre; it is seated on the pipe there");
    }
  }

  // Descriptions by item code, and out of them schedule and class.
  void apply_materials() {
    std::set<std::string> told;
    for (Component& each : out_.components) {
      const auto found = materials_.find(each.item_code);
      if (found != materials_.end()) {
        if (each.description.empty()) each.description = found->second;
      } else if (has_materials_ && !each.item_code.empty() && told.insert(each.item_code).second) {
        tell(each.line, "item code '" + each.item_code + "' is not among the MATERIALS");
      }
      if (each.schedule.empty()) each.schedule = schedule_in(each.description);
      each.rating = rating_in(each.description);
    }
  }

  std::string name_;
  std::optional<double> forced_;
  Pipework out_;
  std::vector<Units> units_;  // closed stretches; current_ is the last
  Units current_;
  bool units_used_ = false;
  std::vector<std::size_t> component_units_, end_units_;
  std::map<std::string, std::string> materials_;
  bool has_materials_ = false;
};

}  // namespace

Result<Pipework> read_pcf(std::string_view bytes, const std::string& name,
                          std::optional<double> coordinate_unit) {
  return Reading(name, coordinate_unit).read(bytes);
}

}  // namespace spool::piping
