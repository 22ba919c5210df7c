// A job with captures of made-up files: enough for what is done to evidence.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/evidence/sample_job.h"

#include <chrono>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/support/write_file.h"
#include "tests/vision/piping/pcf_samples.h"
#include "vision/core/file_io.h"

namespace spool::test {

namespace fs = std::filesystem;

SampleJob::SampleJob() {
  const auto pcf = write_file(outside("line.pcf"), spool_pcf());
  const Status made = job::create_job(path(), {.design = pcf, .spool = "SP1"});
  EXPECT_TRUE(made) << made.error().message;
}

evidence::CaptureRequest SampleJob::request(int seed) const {
  evidence::CaptureRequest request;
  request.check.outcome = job::Outcome::kRedo;
  request.check.status = "not_ok";
  request.check.operator_name = "operator 1";
  request.state = "state " + std::to_string(seed);
  request.context = {{"datum", {"flange-1"}}, {"standard", "pfi-es3"}};
  request.options = {{"align", "pose"}, {"scan", "scan"}};
  for (const char* name : {"report.json", "overlay_1.png", "points.ply"}) {
    constexpr std::size_t kBytes = 3000;
    const auto from = write_file(outside(name + std::to_string(seed)),
                                 std::string(kBytes, static_cast<char>('a' + seed % 26)) + name);
    request.files.push_back({from, name, ""});
  }
  request.picture = "overlay_1.png";
  request.write_more = [seed](const fs::path& folder) {
    return make_folder(folder / "scan")
               ? write_file_whole(folder / "scan/000000.png", "frame " + std::to_string(seed))
               : Status(Error{ErrorCode::kIo, "no folder"});
  };
  return request;
}

Result<evidence::Captured> SampleJob::capture(int seed, const std::string& key) const {
  auto job = job::Job::open(path(), job::JobUse::kWork);
  if (!job) return job.error();
  auto asked = request(seed);
  if (!key.empty()) {
    const auto read = evidence::read_key(key);
    if (!read) return read.error();
    asked.key.emplace(*read);
  }
  return evidence::capture(*job, asked);
}

fs::path SampleJob::copy() const {
  const fs::path to = outside("copy.spooljob");
  fs::remove_all(to);
  fs::copy(path(), to, fs::copy_options::recursive);
  for (const auto& each : fs::recursive_directory_iterator(path())) {
    if (each.is_regular_file())
      fs::last_write_time(to / each.path().lexically_relative(path()), each.last_write_time());
  }
  return to;
}

std::vector<std::string> job_files(const fs::path& job) {
  std::vector<std::string> files;
  for (const std::string& file : job::files_below(job)) {
    if (!file.ends_with('/') && file != "lock" && !file.starts_with("journal.db-"))
      files.push_back(file);
  }
  return files;
}

std::vector<std::string> told(const fs::path& job, const std::string& signer) {
  const auto verified = evidence::verify_job(job, {.signer = signer});
  if (!verified) return {"error " + verified.error().message};
  std::vector<std::string> lines;
  for (const auto& change : verified->changes)
    lines.push_back(std::string(job::name(change.kind)) + " " + change.file);
  return lines;
}

void flip_bit(const fs::path& file, std::size_t bit) {
  const auto time = fs::last_write_time(file);
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  const auto at = static_cast<std::streamoff>(bit / 8);
  stream.seekg(at);
  const int byte = stream.get();
  stream.seekp(at);
  stream.put(static_cast<char>(byte ^ (1 << (bit % 8))));
  stream.close();
  fs::last_write_time(file, time);
}

void redate(const fs::path& file, double by_s) {
  const auto by =
      std::chrono::duration_cast<fs::file_time_type::duration>(std::chrono::duration<double>(by_s));
  fs::last_write_time(file, fs::last_write_time(file) + by);
}

}  // namespace spool::test
