// Exit codes and the one line on stderr.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/common/cli.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "vision/core/version.h"

namespace spool {
namespace {

struct Outcome {
  int code = 0;
  std::string out, err;
};

Outcome run(std::vector<std::string> arguments, const std::function<Result<int>()>& body) {
  static int counter = 0;  // the logger's name has to be new each time
  const std::string program = "program-" + std::to_string(++counter);
  CLI::App app{"Does nothing."};
  add_common_options(app, program);
  arguments.insert(arguments.begin(), program);
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.code = run_program(app, static_cast<int>(argv.size()), argv.data(), body);
  outcome.out = testing::internal::GetCapturedStdout();
  outcome.err = testing::internal::GetCapturedStderr();
  if (outcome.err.find(program + ": ") == 0) outcome.err = outcome.err.substr(program.size() + 2);
  return outcome;
}

TEST(RunProgram, GivesTheBodysOwnCode) {
  EXPECT_EQ(run({}, [] { return Result<int>(2); }).code, 2);
}

TEST(RunProgram, MapsEveryErrorToItsExitCodeAndOneLine) {
  for (const auto code : {ErrorCode::kUsage, ErrorCode::kBadInput, ErrorCode::kNoDevice,
                          ErrorCode::kInternal, ErrorCode::kIo}) {
    const auto outcome = run({}, [&] { return Result<int>(Error{code, "a.ply: is\nempty"}); });
    EXPECT_EQ(outcome.code, static_cast<int>(code));
    EXPECT_EQ(outcome.err, "a.ply: is empty\n");
    EXPECT_TRUE(outcome.out.empty());
  }
}

TEST(Numbers, AreFiniteAndToldInAFewWords) {
  for (const char* bad : {"nan", "inf", "-1", "0", "abc", "1e999", "1 2", ""}) {
    const std::string why = positive_number()(std::string(bad));
    EXPECT_FALSE(why.empty()) << bad;
    EXPECT_LT(why.size(), 40U) << why;
  }
  EXPECT_TRUE(positive_number()(std::string("2.5")).empty());
  EXPECT_TRUE(non_negative_number()(std::string("0")).empty());
  EXPECT_FALSE(non_negative_number()(std::string("-1e-9")).empty());
}

TEST(RunProgram, AnswersAnUnknownFlagWith64WithoutRunning) {
  bool ran = false;
  const auto outcome = run({"--no-such-flag"}, [&] {
    ran = true;
    return Result<int>(0);
  });
  EXPECT_EQ(outcome.code, 64);
  EXPECT_FALSE(ran);
  EXPECT_NE(outcome.err.find("--no-such-flag"), std::string::npos) << outcome.err;
}

TEST(RunProgram, RefusesAnUnknownLogLevel) {
  EXPECT_EQ(run({"--log-level", "loud"}, [] { return Result<int>(0); }).code, 64);
  EXPECT_EQ(run({"--log-level", "error"}, [] { return Result<int>(0); }).code, 0);
}

TEST(RunProgram, PrintsHelpAndVersionOnStdoutAndSucceeds) {
  const auto never = [] { return Result<int>(70); };
  const auto help = run({"--help"}, never);
  EXPECT_EQ(help.code, 0);
  EXPECT_NE(help.out.find("--log-level"), std::string::npos);
  const auto shown = run({"--version"}, never);
  EXPECT_EQ(shown.code, 0);
  EXPECT_NE(shown.out.find(std::string(version())), std::string::npos) << shown.out;
  EXPECT_NE(shown.out.find(std::string(commit())), std::string::npos) << shown.out;
}

TEST(RunProgram, TurnsAnExceptionInto70) {
  const auto outcome = run({}, []() -> Result<int> { throw std::runtime_error("lost"); });
  EXPECT_EQ(outcome.code, 70);
  EXPECT_NE(outcome.err.find("lost"), std::string::npos);
}

}  // namespace
}  // namespace spool
