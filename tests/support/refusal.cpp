// What every refusal owes its reader, checked.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/refusal.h"

#include <algorithm>
#include <regex>

namespace spool::test {

void expect_sentence(const Error& error, ErrorCode code, std::string_view subject,
                     std::string_view why) {
  EXPECT_EQ(error.code, code) << error.message;
  EXPECT_NE(error.message.find(subject), std::string::npos)
      << "does not name " << subject << ": " << error.message;
  EXPECT_NE(error.message.find(why), std::string::npos)
      << "does not say \"" << why << "\": " << error.message;
  EXPECT_EQ(error.message.find('\n'), std::string::npos) << error.message;
}

void expect_refused(const ProcessResult& result, const std::string& program, int code,
                    std::string_view why) {
  EXPECT_EQ(result.code, code) << result.err;
  EXPECT_EQ(result.signal, 0) << result.err;
  EXPECT_NE(result.err.find(why), std::string::npos)
      << "does not say \"" << why << "\": " << result.err;
  // A run of over a second says how far it is before it says why it ends.
  const std::string said =
      std::regex_replace(result.err, std::regex("(^|\n)[a-z ]+: [0-9]+ %(?=\n)"), "");
  const std::string sentence = said.substr(std::min(said.find_first_not_of('\n'), said.size()));
  EXPECT_TRUE(sentence.starts_with(program + ": ")) << result.err;
  EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 1) << result.err;
  EXPECT_TRUE(result.out.empty()) << result.out;
}

}  // namespace spool::test
