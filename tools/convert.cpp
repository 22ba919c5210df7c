// spoolsight-convert: a design file to a design glTF or an isometric, and what a piping file says.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>

#include "app/common/cli.h"
#include "app/common/progress.h"
#include "tools/convert_isometric.h"
#include "tools/pcf_info.h"
#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"
#include "vision/design/gltf_writer.h"
#include "vision/design/pipework_design.h"
#include "vision/piping/pcf_reader.h"
#include "vision/piping/spools.h"

namespace spool::tools {
namespace {

struct ConvertOptions {
  std::string input, out, unit, spool;
  double root_gap_mm = 0;
  bool info = false;
  IsometricFlags isometric;
};

bool ends_in(const std::string& path, const std::string& ending) {
  std::string own = std::filesystem::path(path).extension().string();
  std::transform(own.begin(), own.end(), own.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return own == ending;
}

Status check(const ConvertOptions& options) {
  if (options.out.empty() && !options.info && options.isometric.out.empty())
    return Error{ErrorCode::kUsage,
                 "nothing to do: give -o FILE.glb, --info, --isometric FILE.pdf or several"};
  if (!options.out.empty() && !ends_in(options.out, ".glb"))
    return Error{ErrorCode::kUsage, "-o " + options.out + ": a design is written as .glb"};
  if ((options.info || !options.spool.empty()) && !ends_in(options.input, ".pcf"))
    return Error{ErrorCode::kUsage, (options.info ? "--info" : "--spool") +
                                        std::string(" is of a .pcf file, which ") + options.input +
                                        " is not"};
  return check(options.isometric);
}

// The piping file, or the one spool of it that was asked for.
Result<piping::Pipework> read_pipework(const ConvertOptions& options) {
  const Result<std::string> bytes = read_file(options.input);
  if (!bytes) return bytes.error();
  std::optional<double> unit;
  if (const auto asked = parse_length_unit(options.unit)) unit = metres(*asked);
  auto pipework = piping::read_pcf(*bytes, options.input, unit);
  if (!pipework || options.spool.empty()) return pipework;
  auto one = piping::only_spool(*pipework, options.spool);
  if (!one) return Error{one.error().code, options.input + ": " + one.error().message};
  return one;
}

Status print_info(const ConvertOptions& options) {
  const auto pipework = read_pipework(options);
  if (!pipework) return pipework.error();
  std::cout << pcf_info(options.input, *pipework, options.root_gap_mm / 1000);
  return {};
}

Result<DesignModel> read(const ConvertOptions& options) {
  if (options.spool.empty()) return read_design(options.input, parse_length_unit(options.unit));
  const auto pipework = read_pipework(options);
  if (!pipework) return pipework.error();
  DesignModel design;
  design.path = options.input;
  if (Status built = design_of(*pipework, design); !built) return built.error();
  return design;
}

Status write_glb(const ConvertOptions& options, const DesignModel& design) {
  const Result<std::string> bytes = write_gltf(design);
  if (!bytes) return bytes.error();
  if (Status written = write_file_whole(options.out, *bytes); !written) return written;
  std::cout << "written to " << options.out << ": " << design.parts.size() << " parts, "
            << design.joints.size() << " joints, " << design.mesh.triangles.size()
            << " triangles\n";
  return {};
}

// What is made of the design itself.
Status write_files(const ConvertOptions& options) {
  Progress progress;
  progress.report("design", 0);
  const Result<DesignModel> design = read(options);
  if (!design) return design.error();
  progress.report("writing", 0.5);
  if (!options.out.empty()) {
    if (Status status = write_glb(options, *design); !status) return status;
  }
  if (!options.isometric.out.empty()) {
    const double gap = options.root_gap_mm / 1000;
    if (Status status = write_isometric(*design, options.isometric, gap); !status) return status;
  }
  for (const std::string& warning : design->warnings) std::cerr << "warning: " << warning << "\n";
  return {};
}

Result<int> convert(const ConvertOptions& options) {
  if (Status status = check(options); !status) return status.error();
  if (options.info) {
    if (Status status = print_info(options); !status) return status.error();
  }
  if (!options.out.empty() || !options.isometric.out.empty()) {
    if (Status status = write_files(options); !status) return status.error();
  }
  return 0;
}

}  // namespace
}  // namespace spool::tools

int main(int argc, char** argv) {
  CLI::App app{"Turns a piping file, or any other design, into a design glTF or an isometric."};
  spool::tools::ConvertOptions options;
  spool::add_common_options(app, "spoolsight-convert");
  app.add_option("design", options.input, "Design: .pcf .glb .gltf .stl .obj .ply")
      ->required()
      ->type_name("FILE");
  app.add_option("-o,--out", options.out, "The design as glTF, with the semantics of its parts")
      ->type_name("FILE.glb");
  app.add_flag("--info", options.info,
               "Print what was understood of a .pcf: spools, parts, welds, cut list, problems");
  app.add_option("--spool", options.spool, "Of a .pcf: this spool alone, as --info names it")
      ->type_name("NAME");
  app.add_option("--root-gap-mm", options.root_gap_mm,
                 "Root gap of butt welds that cut lists take off, mm")
      ->check(spool::non_negative_number())
      ->capture_default_str()
      ->type_name("MM");
  app.add_option("--design-unit", options.unit, "Unit of the file's coordinates: m, mm or in")
      ->check(CLI::IsMember({"m", "mm", "in"}))
      ->type_name("UNIT");
  spool::tools::add_isometric_flags(app, options.isometric);
  app.footer("Exit code: 0 done; 64 usage, 65 bad input, 70 internal, 74 read or write failed.");
  return spool::run_program(app, argc, argv, [&] { return spool::tools::convert(options); });
}
