// spoolsight-job capture and keygen: an inspection's folder and its scan become evidence of a job.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>

#include "app/evidence/report_capture.h"
#include "tools/job_commands.h"

namespace spool::tools {

Result<int> capture(const JobOptions& options) {
  auto job = work_on(options);
  if (!job) return job.error();
  const std::filesystem::path folder = options.report;
  const auto record = check_of(options, *job, (folder / "report.json").string());
  if (!record) return record.error();
  auto request = evidence::report_request(folder);
  if (!request) return request.error();
  request->step = options.step - 1;
  request->check = *record;
  if (!options.key.empty()) {
    const auto key = evidence::read_key(options.key);
    if (!key) return key.error();
    request->key.emplace(*key);
  }
  if (Status taken = evidence::add_scan(options.scan, *request); !taken) return taken.error();
  const auto captured = evidence::capture(*job, *request);
  if (!captured) return captured.error();
  std::cout << "captured " << captured->folder.string() << ": check " << captured->check_id
            << " of step " << options.step << ", " << options.outcome << ", measured "
            << record->status << (request->key ? ", signed" : ", not signed") << "\n";
  return 0;
}

Result<int> keygen(const JobOptions& options) {
  const auto made = evidence::make_key(options.out);
  if (!made) return made.error();
  std::cout << "made " << options.out << " (keep it to yourself) and " << options.out
            << ".pub (give it to whoever verifies): " << *made << "\n";
  return 0;
}

}  // namespace spool::tools
