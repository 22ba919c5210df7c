// Small pieces of the HTML report: escaped text, status badges, embedded pictures.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/html_parts.h"

#include <array>
#include <cstdint>

namespace spool::evidence {
namespace {

// Bytes of the UTF-8 sequence that starts `text`; 0 where there is none (RFC 3629: no overlong
// forms, no surrogates, nothing beyond U+10FFFF).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto follows = [&](std::size_t i, unsigned low, unsigned high) {
    return i < text.size() && byte(i) >= low && byte(i) <= high;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return follows(1, 0x80, 0xBF) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const unsigned low = lead == 0xE0 ? 0xA0 : 0x80;
    const unsigned high = lead == 0xED ? 0x9F : 0xBF;
    return follows(1, low, high) && follows(2, 0x80, 0xBF) ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const unsigned low = lead == 0xF0 ? 0x90 : 0x80;
    const unsigned high = lead == 0xF4 ? 0x8F : 0xBF;
    return follows(1, low, high) && follows(2, 0x80, 0xBF) && follows(3, 0x80, 0xBF) ? 4 : 0;
  }
  return 0;
}

// On paper and on a light page (dark values are the screen's).
std::string_view colour(Verdict verdict) {
  switch (verdict) {
    case Verdict::kOk:
      return "#00795A";
    case Verdict::kSuspicious:
      return "#8A5A00";
    case Verdict::kNotOk:
      return "#B3261E";
    case Verdict::kNotMeasured:
      return "#5F6670";
  }
  return "#5F6670";
}

std::string_view outline(Verdict verdict) {
  switch (verdict) {
    case Verdict::kOk:
      return R"(<circle cx="12" cy="12" r="10.5" fill="currentColor"/>)"
             R"(<path d="M7 12.5l3.5 3.5L17 9" fill="none" stroke="#fff" stroke-width="2.6"/>)";
    case Verdict::kSuspicious:
      return R"(<path d="M12 2.2L22.6 21H1.4z" fill="none" stroke="currentColor" stroke-width="2.2" stroke-linejoin="round"/>)"
             R"(<text x="12" y="18.6" text-anchor="middle" font-size="12" font-weight="700" fill="currentColor">?</text>)";
    case Verdict::kNotOk:
      return R"(<path d="M7.6 1.5h8.8l6.1 6.1v8.8l-6.1 6.1H7.6l-6.1-6.1V7.6z" fill="currentColor"/>)"
             R"(<path d="M6 12h12" stroke="#fff" stroke-width="3.2"/>)";
    case Verdict::kNotMeasured:
      return R"(<circle cx="12" cy="12" r="9.8" fill="none" stroke="currentColor" stroke-width="2.4" stroke-dasharray="4 3.7"/>)";
  }
  return "";
}

constexpr std::string_view kStyle = R"(
:root{color-scheme:light}
*{box-sizing:border-box}
body{margin:0 auto;max-width:1180px;padding:20px;background:#fff;color:#15191e;
 font:17px/1.45 "Inter","DejaVu Sans","Segoe UI",Roboto,sans-serif;font-variant-numeric:tabular-nums}
h1{font-size:26px;margin:0 0 2px}
h2{font-size:20px;margin:34px 0 10px;padding-bottom:4px;border-bottom:2px solid #d6dae0}
p{margin:8px 0}
.sub{color:#4a525c;margin:0 0 18px}
.verdict{display:flex;gap:20px;align-items:center;border:3px solid currentColor;border-radius:12px;padding:16px 22px;margin:0 0 10px}
.verdict svg{flex:none}
.verdict .word{font-size:34px;font-weight:700;line-height:1.1}
.verdict .why{color:#15191e;margin-top:4px;font-size:18px}
.badge{display:inline-flex;gap:8px;align-items:center;font-weight:650;white-space:nowrap}
table{border-collapse:collapse;width:100%}
th,td{text-align:left;padding:9px 12px;border-bottom:1px solid #d6dae0;vertical-align:top}
thead th{font-size:14px;color:#4a525c;border-bottom:2px solid #aab2bc;vertical-align:bottom}
td.n,th.n{text-align:right;white-space:nowrap}
tr.why td{padding-top:0;color:#4a525c;font-size:15px}
tr.head td{border-bottom:0;padding-bottom:3px}
table.facts th{width:13em;font-weight:600;color:#4a525c}
table.facts td{overflow-wrap:anywhere}
.bar{display:inline-block;vertical-align:middle;width:84px;height:10px;border:1px solid #7b8490;border-radius:5px;overflow:hidden;margin-right:8px}
.bar i{display:block;height:100%;background:#5a8fb8;-webkit-print-color-adjust:exact;print-color-adjust:exact}
.wide{overflow-x:auto}
code{font:13px/1.4 "DejaVu Sans Mono",monospace;overflow-wrap:anywhere}
figure{margin:0 0 22px;break-inside:avoid}
figure img{display:block;width:100%;height:auto;border:1px solid #aab2bc;border-radius:8px}
figcaption{color:#4a525c;margin-top:6px;font-size:15px}
ul{margin:8px 0;padding-left:24px}
li{margin:5px 0}
.note{background:#f2f4f7;border-left:5px solid #7b8490;border-radius:4px;padding:10px 16px;margin:12px 0;-webkit-print-color-adjust:exact;print-color-adjust:exact}
@media print{body{max-width:none;padding:0;font-size:11pt}h2{break-after:avoid}tr,.verdict,.note{break-inside:avoid}
 .verdict .word{font-size:24pt}code{font-size:8pt}th,td{padding:5px 8px}.wide{overflow:visible}}
@page{size:auto;margin:14mm}
)";

}  // namespace

std::string escaped(std::string_view text) {
  std::string html;
  html.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) {
      html += "\xEF\xBF\xBD";
      text.remove_prefix(1);
      continue;
    }
    const char c = text[0];
    if (length > 1) {
      html += text.substr(0, length);
    } else if (c == '&') {
      html += "&amp;";
    } else if (c == '<') {
      html += "&lt;";
    } else if (c == '>') {
      html += "&gt;";
    } else if (c == '"') {
      html += "&quot;";
    } else if (c == '\'') {
      html += "&#39;";
    } else {
      html += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
    }
    text.remove_prefix(length);
  }
  return html;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const auto byte = [&](std::size_t k) {
      return k < left ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])) : 0U;
    };
    const std::uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
    text += kDigits[group >> 18];
    text += kDigits[group >> 12 & 63];
    text += left > 1 ? kDigits[group >> 6 & 63] : '=';
    text += left > 2 ? kDigits[group & 63] : '=';
  }
  return text;
}

std::string_view word(Verdict verdict) {
  switch (verdict) {
    case Verdict::kOk:
      return "OK";
    case Verdict::kSuspicious:
      return "Can't tell";
    case Verdict::kNotOk:
      return "Out";
    case Verdict::kNotMeasured:
      return "Not seen";
  }
  return "Not seen";
}

std::string status_shape(Verdict verdict, int size_px) {
  const std::string size = std::to_string(size_px);
  return "<svg width=\"" + size + "\" height=\"" + size +
         "\" viewBox=\"0 0 24 24\" aria-hidden=\"true\" style=\"color:" +
         std::string(colour(verdict)) + "\">" + std::string(outline(verdict)) + "</svg>";
}

std::string row(std::string_view label, std::string_view value_html) {
  return "<tr><th>" + escaped(label) + "</th><td>" + std::string(value_html) + "</td></tr>\n";
}

std::string page_start(std::string_view title) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + std::string(kStyle) + "</style></head>\n<body>\n";
}

}  // namespace spool::evidence
