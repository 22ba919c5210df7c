// Schedule and pressure class out of the free text of a material list, where they mostly live.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/item_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "vision/piping/pcf_text.h"

namespace spool::piping {
namespace {

struct Token {
  std::string text;                // letters or digits, capitals
  char before = ' ', after = ' ';  // what stands directly beside it
};

// Runs of letters and runs of digits: "SCH40S" is SCH, 40, S with nothing between.
std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  const std::string capitals = to_capitals(text);
  const auto kind = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isdigit(byte) != 0 ? 1 : std::isalpha(byte) != 0 ? 2 : 0;
  };
  for (std::size_t at = 0; at < capitals.size();) {
    std::size_t end = at + 1;
    while (end < capitals.size() && kind(capitals[end]) == kind(capitals[at])) ++end;
    if (kind(capitals[at]) != 0)
      tokens.push_back({capitals.substr(at, end - at), at > 0 ? capitals[at - 1] : ' ',
                        end < capitals.size() ? capitals[end] : ' '});
    at = end;
  }
  return tokens;
}

template <std::size_t N>
bool is_one_of(const std::string& text, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

constexpr std::array<std::string_view, 12> kNumbers{"5",  "10",  "20",  "30",  "40",  "60",
                                                    "80", "100", "120", "140", "160", "05"};
constexpr std::array<std::string_view, 3> kWeights{"STD", "XS", "XXS"};
constexpr std::array<std::string_view, 9> kRatings{"150",  "300",  "400",  "600", "900",
                                                   "1500", "2500", "3000", "6000"};

// The schedule that starts at a token: a number with its S, or a weight.
std::string schedule_at(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size()) return {};
  if (is_one_of(tokens[at].text, kWeights)) return tokens[at].text;
  if (!is_one_of(tokens[at].text, kNumbers)) return {};
  std::string number = tokens[at].text == "05" ? "5" : tokens[at].text;
  const bool is_stainless =
      tokens[at].after == 'S' && at + 1 < tokens.size() && tokens[at + 1].text == "S";
  return is_stainless ? number + "S" : number;
}

}  // namespace

std::string schedule_in(std::string_view text) {
  const std::vector<Token> tokens = tokens_of(text);
  constexpr std::array<std::string_view, 4> kIntroductions{"SCH", "SCHED", "SCHEDULE", "S"};
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!is_one_of(tokens[i].text, kIntroductions)) continue;
    // "S 40" with a blank between is no schedule: "TYPE S 40 FT".
    if (tokens[i].text == "S" && tokens[i].after == ' ') continue;
    if (std::string found = schedule_at(tokens, i + 1); !found.empty()) return found;
  }
  for (const Token& token : tokens) {
    if (is_one_of(token.text, kWeights)) return token.text;
    if (token.text == "SXS" || token.text == "SSTD" || token.text == "SXXS")
      return token.text.substr(1);
  }
  return {};
}

std::string rating_in(std::string_view text) {
  const std::vector<Token> tokens = tokens_of(text);
  constexpr std::array<std::string_view, 5> kBefore{"CL", "CLASS", "ANSI", "RATING", "ASME"};
  constexpr std::array<std::string_view, 3> kBehind{"LB", "LBS", "CL"};
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!is_one_of(tokens[i].text, kRatings)) continue;
    const bool is_said = (i > 0 && is_one_of(tokens[i - 1].text, kBefore)) ||
                         tokens[i].before == '#' || tokens[i].after == '#' ||
                         (i + 1 < tokens.size() && is_one_of(tokens[i + 1].text, kBehind));
    if (is_said) return tokens[i].text;
  }
  return {};
}

}  // namespace spool::piping
