// One program at a time works on a job: a lock file that says who does.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "vision/core/result.h"

namespace spool::job {

// Holds the job while it lives. The lock is the system's own on the file (flock), so that of a
// holder that died, however it died, nothing is left to clear away; the text in the file only names
// it.
class JobLock {
 public:
  // kIo: somebody else holds it, named with host, process and time; or the file cannot be made.
  [[nodiscard]] static Result<JobLock> take(const std::filesystem::path& file);

  JobLock(JobLock&& other) noexcept;
  JobLock& operator=(JobLock&&) = delete;
  ~JobLock();

  // The holder that died with the lock and from whom it was taken over; "" where there was none.
  [[nodiscard]] const std::string& taken_over_from() const { return taken_over_from_; }

 private:
  JobLock(int descriptor, std::string taken_over_from)
      : descriptor_(descriptor), taken_over_from_(std::move(taken_over_from)) {}
  int descriptor_ = -1;
  std::string taken_over_from_;
};

}  // namespace spool::job
