// Plays an untrusted .oni file to its end, so that what crashes or hangs is this and not the
// program.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <sys/resource.h>

#include "app/sensor/openni.h"

// The sanitizers reserve terabytes of address space for their shadow.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

namespace {

using namespace spool;
using namespace spool::sensor;

void limit(decltype(RLIMIT_CPU) what, rlim_t to) {
  const rlimit both{to, to};
  ::setrlimit(what, &both);
}

int refuse(const Error& error) {
  std::printf("%s\n", error.message.c_str());
  return exit_code(error.code);
}

int play(const std::string& path) {
  constexpr double kPatience = 5;  // s without a frame and without an end
  // Never closed: this process ends by _Exit.
  auto* source = new auto(open_oni_unchecked(path, {}));
  if (!*source) return refuse(source->error());
  for (double silent = 0; silent < kPatience;) {
    const auto output = (**source)->next(std::chrono::milliseconds(200));
    if (!output) return refuse(output.error());
    if (output->event == SourceEvent::kEnd) return 0;
    silent = output->event == SourceEvent::kFrame ? 0 : silent + 0.2;
  }
  return refuse({ErrorCode::kBadInput, path + ": stops before its end; record it again"});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::puts(
        "spoolsight-oni-check FILE.oni: plays a recording to its end; used by the other programs");
    return exit_code(ErrorCode::kUsage);
  }
  std::error_code ignored;
  const auto size = std::filesystem::file_size(argv[1], ignored);
  const rlim_t megabytes = ignored ? 0 : static_cast<rlim_t>(size >> 20U);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU,
        std::min<rlim_t>(20 + megabytes / 20, 3600));  // s; sound ones do 100 MB a second
  if (kLimitsMemory) limit(RLIMIT_AS, rlim_t{2} << 30U);
  const int code = play(argv[1]);
  std::fflush(stdout);
  std::_Exit(code);  // what is left of OpenNI2 then is of no interest
}
