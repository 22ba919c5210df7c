// The lines of a Piping Component File: bytes to text, and what is no such file refused by name.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/pcf_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace spool::piping {
namespace {

constexpr std::size_t kMaxLines = 2'000'000;   // 100 times the largest plant export seen
constexpr std::size_t kMaxLineBytes = 20'000;  // longer is no line of text

Error bad(const std::string& name, const std::string& what) {
  return {ErrorCode::kBadInput, name + " " + what};
}

// ---- Characters

// The code points of CP1252's 0x80 to 0x9F; 0: not assigned.
constexpr std::array<std::uint16_t, 32> kCp1252{
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void append_utf8(std::string& out, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0U | (code >> 6U));
    put(0x80U | (code & 0x3FU));
  } else {  // no plane beyond the first is written into drawings
    put(0xE0U | (code >> 12U));
    put(0x80U | ((code >> 6U) & 0x3FU));
    put(0x80U | (code & 0x3FU));
  }
}

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const std::size_t more = first < 0x80                     ? 0
                             : first >= 0xC2 && first <= 0xDF ? 1
                             : (first & 0xF0U) == 0xE0        ? 2
                             : first >= 0xF0 && first <= 0xF4 ? 3
                                                              : bytes.size();
    if (more > bytes.size() - i - 1) return false;
    for (std::size_t k = 1; k <= more; ++k) {
      if ((static_cast<unsigned char>(bytes[i + k]) & 0xC0U) != 0x80) return false;
    }
    i += more + 1;
  }
  return true;
}

std::string from_cp1252(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    const std::uint32_t code = byte >= 0x80 && byte < 0xA0 ? kCp1252[byte - 0x80U] : byte;
    append_utf8(out, code == 0 ? 0xFFFD : code);
  }
  return out;
}

std::string from_utf16(std::string_view bytes, bool big_endian) {
  std::string out;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const auto low = static_cast<unsigned char>(bytes[i + (big_endian ? 1 : 0)]);
    const auto high = static_cast<unsigned char>(bytes[i + (big_endian ? 0 : 1)]);
    const std::uint32_t code = (std::uint32_t{high} << 8U) | low;
    append_utf8(out, code >= 0xD800 && code < 0xE000 ? 0xFFFD : code);
  }
  return out;
}

std::string decode(std::string_view bytes, bool& was_transcoded) {
  was_transcoded = true;
  if (bytes.substr(0, 2) == "\xFF\xFE") return from_utf16(bytes, false);
  if (bytes.substr(0, 2) == "\xFE\xFF") return from_utf16(bytes, true);
  const std::string_view text = bytes.substr(0, 3) == "\xEF\xBB\xBF" ? bytes.substr(3) : bytes;
  if (!is_utf8(text)) return from_cp1252(text);
  was_transcoded = false;
  return std::string(text);
}

// ---- Other files of the same ending

// Share of bytes that no text holds.
bool is_binary(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 65536);
  const auto odd = std::count_if(start.begin(), start.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r' && byte != '\f' &&
           byte != 0x1A;  // an old end of file
  });
  return start.find('\0') != std::string_view::npos ||
         static_cast<std::size_t>(odd) * 50 > start.size();
}

// An IDF line is columns of numbers that start with its record's: nearly all lines do.
bool looks_like_idf(const std::vector<PcfLine>& lines) {
  const std::size_t looked = std::min<std::size_t>(lines.size(), 500);
  if (looked < 2) return false;
  const auto numbered = std::count_if(
      lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(looked), [](const PcfLine& line) {
        return line.keyword.find_first_not_of("-+0123456789") == std::string::npos;
      });
  return static_cast<std::size_t>(numbered) * 10 >= looked * 9;
}

// ---- Lines

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\x1A'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

PcfLine split(std::string_view raw, int number) {
  PcfLine line;
  line.number = number;
  line.raw = std::string(raw);
  std::size_t at = 0;
  for (; at < raw.size() && is_blank(raw[at]); ++at) {
    line.indent = raw[at] == '\t' ? (line.indent / 4 + 1) * 4 : line.indent + 1;
  }
  std::string_view rest = trimmed(raw.substr(at));
  std::size_t end = rest.find_first_of(" \t");
  if (!rest.empty() && rest.front() == '<' && rest.find('>') != std::string_view::npos) {
    end = rest.find('>');
    line.keyword = to_capitals(trimmed(rest.substr(1, end - 1)));
    ++end;
  } else {
    std::string_view word = rest.substr(0, end);
    if (word.size() > 1 && (word.back() == ':' || word.back() == '=')) word.remove_suffix(1);
    line.keyword = to_capitals(word);
  }
  std::replace(line.keyword.begin(), line.keyword.end(), '_', '-');
  std::string_view value =
      end == std::string_view::npos ? std::string_view{} : trimmed(rest.substr(end));
  if (value.size() >= 2 && value.front() == '"' && value.back() == '"')
    value = trimmed(value.substr(1, value.size() - 2));
  line.value = std::string(value);
  return line;
}

}  // namespace

std::string to_capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return out;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

Result<PcfText> read_pcf_text(std::string_view bytes, const std::string& name) {
  if (bytes.substr(0, 4) ==
      "\x01"
      "fcp")
    return bad(name, "is a screen font (X11 Portable Compiled Format), not a piping file");
  const bool is_wide = bytes.substr(0, 2) == "\xFF\xFE" || bytes.substr(0, 2) == "\xFE\xFF";
  if (!is_wide && is_binary(bytes))
    return bad(name,
               "is a binary file, such as an embroidery pattern; a Piping Component File is text");
  PcfText text;
  const std::string decoded = decode(bytes, text.was_transcoded);
  int number = 0;
  for (std::size_t at = 0; at < decoded.size();) {
    std::size_t end = decoded.find_first_of("\r\n", at);
    if (end == std::string::npos) end = decoded.size();
    const std::string_view raw = std::string_view(decoded).substr(at, end - at);
    const bool is_pair =
        end + 1 < decoded.size() && decoded[end] == '\r' && decoded[end + 1] == '\n';
    at = end + (is_pair ? 2 : 1);
    ++number;
    if (raw.size() > kMaxLineBytes)
      return bad(name, "has a line of " + std::to_string(raw.size()) + " bytes (line " +
                           std::to_string(number) + "); a Piping Component File has short lines");
    const std::string_view said = trimmed(raw);
    if (said.empty() || said.front() == '!' || said.front() == '#') continue;
    if (text.lines.size() == kMaxLines)
      return bad(name, "has more than " + std::to_string(kMaxLines) + " lines; split it by line");
    text.lines.push_back(split(raw, number));
  }
  if (looks_like_idf(text.lines))
    return bad(name,
               "looks like an Isometric Data File (IDF: columns of numbers); export it as PCF");
  return text;
}

}  // namespace spool::piping
