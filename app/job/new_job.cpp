// Makes the folder of a job from a piping file or a design glTF.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <set>

#include <unistd.h>

#include "app/job/job.h"
#include "app/job/job_seal.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"
#include "vision/design/gltf_writer.h"
#include "vision/design/pipework_design.h"
#include "vision/guide/assembly_order.h"
#include "vision/piping/pcf_reader.h"
#include "vision/piping/spools.h"

namespace spool::job {
namespace {

struct Made {
  JobFile file;
  std::string design_bytes, source_bytes;
};

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return ending;
}

// The design of one spool of a piping file, as GLB.
Status from_piping_file(const NewJob& job, Made& made) {
  auto pipework = piping::read_pcf(made.source_bytes, job.design.string());
  if (!pipework) return pipework.error();
  made.file.spool = job.spool;
  if (job.spool.empty() && pipework->spools.size() == 1)
    made.file.spool = pipework->spools.front().name;
  auto one = piping::only_spool(*pipework, made.file.spool);
  if (!one) return Error{one.error().code, job.design.string() + ": " + one.error().message};
  DesignModel design;
  design.path = job.design.string();
  if (Status built = design_of(*one, design); !built) return built.error();
  auto bytes = write_gltf(design);
  if (!bytes) return bytes.error();
  made.design_bytes = *std::move(bytes);
  made.file.source = "source.pcf";
  made.file.source_sha256 = sha256_hex(made.source_bytes);
  return {};
}

// A glTF is taken as it is: one spool, and that asked for.
Status from_gltf(const NewJob& job, Made& made) {
  const auto design = read_design(job.design);
  if (!design) return design.error();
  std::set<std::string> spools;
  for (const Part& part : design->parts) {
    if (!part.spool.empty()) spools.insert(part.spool);
  }
  if (spools.empty() && !design->spool.empty()) spools.insert(design->spool);
  const bool is_it =
      job.spool.empty() ? spools.size() < 2 : spools == std::set<std::string>{job.spool};
  if (!is_it) {
    std::string names;
    for (const std::string& each : spools) names += (names.empty() ? "" : ", ") + each;
    return Error{ErrorCode::kBadInput, job.design.string() + ": holds " +
                                           (names.empty() ? "no named spool" : names) +
                                           "; a job is of one spool, named as the design names it"};
  }
  made.file.spool = spools.empty() ? "" : *spools.begin();
  made.design_bytes = std::exchange(made.source_bytes, {});
  return {};
}

Status fill(const std::filesystem::path& folder, Made& made) {
  if (Status done = make_folder(folder / "evidence"); !done) return done;
  if (Status done = write_file_whole(folder / made.file.design, made.design_bytes); !done)
    return done;
  if (!made.file.source.empty()) {
    if (Status done = write_file_whole(folder / made.file.source, made.source_bytes); !done)
      return done;
  }
  // The order is that of the design as it will be read again.
  const auto design = read_design(folder / made.file.design);
  if (!design) return design.error();
  for (const int part : guide::propose_order(*design))
    made.file.order.push_back(design->parts[static_cast<std::size_t>(part)].name);
  if (auto journal = Journal::create(journal_path(folder)); !journal) return journal.error();
  if (Status done = write_job_file(folder / "job.json", made.file); !done) return done;
  return write_seal(folder);
}

}  // namespace

std::filesystem::path journal_path(const std::filesystem::path& folder) {
  return folder / "journal.db";
}

Status create_job(const std::filesystem::path& folder, const NewJob& job) {
  std::error_code code;
  const std::string ending = ending_of(job.design);
  if (ending != ".pcf" && ending != ".glb")
    return Error{ErrorCode::kUsage,
                 job.design.string() + ": a job is made from a .pcf or a .glb design"};
  if (folder.extension() != ".spooljob")
    return Error{ErrorCode::kUsage, folder.string() + ": a job's folder is named NAME.spooljob"};
  if (std::filesystem::exists(folder, code))
    return Error{ErrorCode::kIo, folder.string() + ": is there already; choose another name"};
  auto bytes = read_file(job.design);
  if (!bytes) return bytes.error();
  Made made;
  made.source_bytes = *std::move(bytes);
  made.file.source_path = std::filesystem::absolute(job.design).string();
  made.file.gaps = job.gaps;
  made.file.design = "design.glb";
  made.file.created = utc_text(now().wall_s);
  Status read = ending == ".pcf" ? from_piping_file(job, made) : from_gltf(job, made);
  if (!read) return read;
  made.file.design_sha256 = sha256_hex(made.design_bytes);
  // Filled under another name first: who finds the folder finds all of it.
  const std::filesystem::path half = folder.string() + ".part-" + std::to_string(::getpid());
  Status filled = fill(half, made);
  if (filled) {
    std::filesystem::rename(half, folder, code);
    if (code)
      filled = Error{ErrorCode::kIo, folder.string() + ": cannot be made (" + code.message() + ")"};
  }
  if (!filled) std::filesystem::remove_all(half, code);
  return filled;
}

}  // namespace spool::job
