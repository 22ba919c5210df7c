// What was understood of a Piping Component File, as text for people.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/pcf_info.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "vision/design/pipework_design.h"
#include "vision/piping/catalogue.h"
#include "vision/piping/cut_list.h"

namespace spool::tools {
namespace {

using piping::Component;
using piping::ComponentKind;
using piping::Pipework;

class Page {
 public:
  Page(const Pipework& pipework, double root_gap)
      : pipework_(pipework), names_(part_names(pipework)), root_gap_(root_gap) {}

  std::string write(const std::string& path) {
    const auto bodies = std::count_if(pipework_.components.begin(), pipework_.components.end(),
                                      [](const Component& each) { return is_body(each); });
    line("{}: {} components in {} pipeline{}, coordinates in {}{}, bores in {}{}", path, bodies,
         pipework_.pipelines.size(), pipework_.pipelines.size() == 1 ? "" : "s",
         pipework_.coordinate_unit, pipework_.coordinate_unit_inferred ? " (inferred)" : "",
         pipework_.bore_unit, pipework_.bore_unit_inferred ? " (inferred)" : "");
    for (const piping::Pipeline& each : pipework_.pipelines)
      line("pipeline {} (line {}){}{}{}", each.reference, each.line, with(", spec ", each.spec),
           with(", class ", each.nominal_class), with(", revision ", each.revision));
    write_spools();
    write_parts();
    write_welds();
    write_cut_list();
    write_others();
    line("problems: {}", pipework_.problems.size());
    for (const piping::Problem& each : pipework_.problems)
      line("  line {}: {}", each.line, each.text);
    return std::move(text_);
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    text_ += '\n';
  }
  static std::string with(const char* before, const std::string& text) {
    return text.empty() ? std::string() : before + text;
  }
  const Component& component(int index) const {
    return pipework_.components[static_cast<std::size_t>(index)];
  }
  const std::string& name_of(int index) const { return names_[static_cast<std::size_t>(index)]; }

  void write_spools() {
    line("spools: {}", pipework_.spools.size());
    for (const piping::Spool& each : pipework_.spools) {
      const auto welds_of = [&](piping::WeldPlace place) {
        return std::count_if(
            pipework_.joints.begin(), pipework_.joints.end(), [&](const auto& joint) {
              const bool is_its =
                  component(joint.a).spool == each.name || component(joint.b).spool == each.name;
              return !joint.number.empty() && joint.where == place && is_its;
            });
      };
      line("  {}{}: {} parts, {} fab, {} field, {} yaw welds", each.name,
           each.is_made_up ? " (made up: the file names none)" : "", each.components.size(),
           welds_of(piping::WeldPlace::kFab), welds_of(piping::WeldPlace::kField),
           welds_of(piping::WeldPlace::kYaw));
    }
  }

  static std::string sizes_of(const Component& each) {
    std::string text;
    double last = -1;
    for (int p = 0; p < port_count(each); ++p) {
      const double nps = port_of(each, p).nps;
      if (nps == last) continue;
      text += (text.empty() ? "NPS " : " x ") + (nps > 0 ? piping::nps_text(nps) : "?");
      last = nps;
    }
    return text;
  }

  void write_parts() {
    line("parts");
    for (std::size_t c = 0; c < names_.size(); ++c) {
      const Component& each = pipework_.components[c];
      if (names_[c].empty()) continue;
      line("  {:<14} line {:<6} {:<16} {}{}{}{}{}{}", names_[c], each.line, sizes_of(each),
           each.schedule, with(" class ", each.rating), with(", spool ", each.spool),
           each.is_erection ? ", erection" : "", with(", tag ", each.tag),
           with(", ", each.description));
    }
  }

  void write_welds() {
    line("welds");
    for (const piping::PipeJoint& joint : pipework_.joints) {
      if (joint.number.empty()) continue;
      line("  {:<8} {:<6} {} to {}{}", joint.number, name(joint.where), name_of(joint.a),
           name_of(joint.b),
           joint.weld >= 0 ? fmt::format(", line {}{}", component(joint.weld).line,
                                         joint.is_made_up ? " (number made up)" : "")
                           : ", no WELD in the file (number made up)");
    }
  }

  static std::string mm(double metres) { return fmt::format("{:.1f}", metres * 1000); }

  void write_cut_list() {
    line("cut list, mm, root gap {} mm{}", mm(root_gap_),
         root_gap_ > 0 ? "" : " (give yours by --root-gap-mm)");
    double total = 0;
    for (const piping::CutPipe& each : piping::cut_list(pipework_, root_gap_)) {
      const Component& pipe = component(each.component);
      const auto side = [&](const piping::CutEnd& end) {
        if (end.neighbour < 0) return std::string("open end");
        return fmt::format("{} less {}{}", name_of(end.neighbour), mm(end.take_off),
                           end.root_gap > 0 ? " and gap " + mm(end.root_gap) : "");
      };
      line("  {:<10} {:<9} {:<4} {:>9} to centres: {}; {}; cut {}", name_of(each.component),
           sizes_of(pipe), pipe.schedule, mm(each.centre_to_centre()), side(each.ends[0]),
           side(each.ends[1]), mm(each.cut()));
      total += each.cut();
    }
    line("  in all {:.3f} m of pipe", total);
  }

  void write_others() {
    for (const Component& each : pipework_.components) {
      if (each.kind == ComponentKind::kSupport)
        line("support {} {} (line {})", each.tag, each.skey, each.line);
      if (each.kind == ComponentKind::kBolt)
        line("bolts {}{} (line {})", each.item_code, with(", ", each.description), each.line);
    }
    for (const piping::LineEnd& each : pipework_.line_ends)
      line("{} {} (line {})", each.keyword, each.reference, each.line);
  }

  const Pipework& pipework_;
  std::vector<std::string> names_;
  double root_gap_;
  std::string text_;
};

}  // namespace

std::string pcf_info(const std::string& path, const piping::Pipework& pipework, double root_gap) {
  return Page(pipework, root_gap).write(path);
}

}  // namespace spool::tools
