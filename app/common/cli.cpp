// What every program of ours shares at its command line: --help, --version, --log-level, exit
// codes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/common/cli.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <iostream>

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include "vision/core/version.h"

namespace spool {
namespace {

// "program: message" as one line, whatever a library put into its text.
void print_line(const std::string& program, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  while (!message.empty() && message.back() == ' ') message.pop_back();
  std::fprintf(stderr, "%s: %s\n", program.c_str(), message.c_str());
}

// Text that reached stdout, or 74: results that nobody got are no success.
int flushed(const std::string& program, int code) {
  std::cout.flush();
  const bool failed = !std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  if (!failed) return code;
  print_line(program, "standard output: cannot be written; free space or choose another place");
  return exit_code(ErrorCode::kIo);
}

CLI::Validator number_check(const std::string& name, bool zero_is_good) {
  return {[=](std::string& text) {
            double value = 0;
            const bool is_number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
            if (is_number && (value > 0 || (zero_is_good && value == 0))) return std::string();
            return text + " is no number " + (zero_is_good ? "from 0 on" : "above 0");
          },
          name};
}

}  // namespace

CLI::Validator positive_number() { return number_check("POSITIVE", false); }
CLI::Validator non_negative_number() { return number_check("NONNEGATIVE", true); }

void add_common_options(CLI::App& app, const std::string& program) {
  app.name(program);
  app.set_version_flag("--version", program + " " + std::string(version()) + " (commit " +
                                        std::string(commit()) + ")");
  auto logger = spdlog::stderr_logger_mt(program);
  logger->set_pattern("%n: %l: %v");
  spdlog::set_default_logger(logger);
  spdlog::set_level(spdlog::level::info);
  app.add_option_function<std::string>(
         "--log-level",
         [](const std::string& level) {
           spdlog::set_level(level == "error" ? spdlog::level::err
                                              : spdlog::level::from_str(level));
         },
         "How much is said on stderr")
      ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}))
      ->default_str("info");
}

int run_program(CLI::App& app, int argc, char** argv, const std::function<Result<int>()>& body) {
  const std::string program = app.get_name();
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);
#endif
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);
#endif
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return flushed(program, app.exit(error));  // --help, --version
    print_line(program, std::string(error.what()) + "; --help lists what there is");
    return exit_code(ErrorCode::kUsage);
  }
  try {
    const Result<int> result = body();
    if (result) return flushed(program, *result);
    std::cout.flush();
    print_line(program, result.error().message);
    return exit_code(result.error().code);
  } catch (const std::bad_alloc&) {
    print_line(program, "memory ran out; use a smaller file");
  } catch (const std::exception& error) {
    print_line(program, std::string("a fault of ours: ") + error.what());
  }
  return exit_code(ErrorCode::kInternal);
}

}  // namespace spool
