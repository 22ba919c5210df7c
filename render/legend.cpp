// What the colours mean: a bar with numbers and unit, the tolerance marked, other points named.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/legend.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <vector>

#include "render/deviation_colour.h"

namespace spool::render {
namespace {

constexpr double kInch = 0.0254;  // m
const Eigen::Vector3f kInk{0.05F, 0.06F, 0.08F};
const Eigen::Vector3f kText{0.93F, 0.95F, 0.97F};
const Eigen::Vector3f kDimText{0.74F, 0.78F, 0.82F};

// A minus as long as the plus, as type has it.
std::string sign_of(double value) { return value > 0 ? "+" : value < 0 ? "\xE2\x88\x92" : ""; }

std::string trimmed(double value, int decimals) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  std::string result = text.data();
  if (result.find('.') != std::string::npos) {
    result.resize(result.find_last_not_of('0') + 1);
    if (result.back() == '.') result.pop_back();
  }
  return result;
}

// A whole number in raised or lowered small digits, for a set fraction.
std::string small_digits(int number, bool raised) {
  static constexpr std::array<const char*, 10> kRaised{
      "\xE2\x81\xB0", "\xC2\xB9",     "\xC2\xB2",     "\xC2\xB3",     "\xE2\x81\xB4",
      "\xE2\x81\xB5", "\xE2\x81\xB6", "\xE2\x81\xB7", "\xE2\x81\xB8", "\xE2\x81\xB9"};
  std::string result;
  for (const char digit : std::to_string(number)) {
    const auto d = static_cast<std::size_t>(digit - '0');
    result +=
        raised ? std::string(kRaised[d]) : std::string("\xE2\x82") + static_cast<char>(0x80 + d);
  }
  return result;
}

std::string inches(double magnitude_m) {
  const double in = magnitude_m / kInch;
  const auto parts = static_cast<int>(std::lround(in * 32));
  if (std::abs(magnitude_m - parts / 32.0 * kInch) > 0.00005) return trimmed(in, 3);
  int numerator = parts % 32;
  int denominator = 32;
  while (numerator != 0 && numerator % 2 == 0) {
    numerator /= 2;
    denominator /= 2;
  }
  const std::string whole = parts / 32 > 0 ? std::to_string(parts / 32) : "";
  if (numerator == 0) return whole.empty() ? "0" : whole;
  return whole + small_digits(numerator, true) + "\xE2\x81\x84" + small_digits(denominator, false);
}

std::string magnitude(double length_m, LengthDisplay units) {
  const double size = std::abs(length_m);
  return units == LengthDisplay::kMillimetre ? trimmed(1000 * size, 2) : inches(size);
}

struct Row {
  enum class Key { kTolerance, kNeutral, kClutter, kContradicting } key;
  std::string text;
};

std::vector<Row> key_rows(const LegendContent& content) {
  const std::string plus_minus = "\xC2\xB1";
  std::vector<Row> rows;
  rows.push_back({Row::Key::kTolerance,
                  plus_minus + magnitude(content.tolerance_m, content.units) + " tolerance"});
  rows.push_back(
      {Row::Key::kNeutral, plus_minus + magnitude(content.neutral_m, content.units) + " noise"});
  if (content.has_contradicting) rows.push_back({Row::Key::kContradicting, "contradicts design"});
  if (content.has_clutter) rows.push_back({Row::Key::kClutter, "other things"});
  return rows;
}

// Draws in density-independent units from the panel's top left corner, itself on whole pixels.
struct Pen {
  Canvas& canvas;
  Eigen::Vector2f origin;
  float scale;
  float text_px;

  [[nodiscard]] Eigen::Vector2f at(float x, float y) const {
    return origin + Eigen::Vector2f(x, y);
  }
  void box(float left, float top, float width, float height, const Eigen::Vector4f& fill,
           float corner = 0) const {
    CanvasShape shape;
    shape.half_size = 0.5F * Eigen::Vector2f(width, height);
    shape.centre = at(left, top) + shape.half_size;
    shape.corner_px = corner;
    shape.fill = fill;
    canvas.shapes.push_back(shape);
  }
  void triangle(float x, float y, float half_width, float half_height, float turn,
                const Eigen::Vector3f& fill) const {
    CanvasShape shape;
    shape.kind = CanvasShape::Kind::kTriangle;
    shape.centre = at(x, y);
    shape.half_size = {half_width, half_height};
    shape.turn_rad = turn;
    shape.fill = with_opacity(fill, 1.0F);
    canvas.shapes.push_back(shape);
  }
  void text(const std::string& utf8, float x, float y, const Eigen::Vector3f& colour) const {
    CanvasText t;
    t.utf8 = utf8;
    t.at = at(x, y);
    t.size_px = text_px;
    t.colour = with_opacity(colour, 1.0F);
    canvas.texts.push_back(t);
  }
};

// The sample before a row of the key.
void draw_key(const Pen& pen, Row::Key key, float x, float y) {
  const float s = pen.scale;
  const auto swatch = [&](const Eigen::Vector3f& colour) {
    pen.box(x, y - 6 * s, 14 * s, 12 * s, with_opacity(colour, 1.0F), 2 * s);
  };
  switch (key) {
    case Row::Key::kTolerance:
      pen.triangle(x + 7 * s, y, 5 * s, 5 * s, 1.5708F, kText);
      return;
    case Row::Key::kNeutral:
      swatch(inside_stops()[0]);
      return;
    case Row::Key::kClutter:
      swatch(clutter_colour());
      return;
    case Row::Key::kContradicting:
      swatch(contradicting_colour());
      for (const float aside : {-4.0F, 0.0F, 4.0F}) {  // hatched as the points are
        CanvasShape stripe;
        stripe.centre = pen.at(x + (7 + aside) * s, y);
        stripe.half_size = {0.9F * s, 6 * s};
        stripe.turn_rad = 0.4F;
        stripe.fill = {0.20F, 0.0F, 0.17F, 1.0F};
        pen.canvas.shapes.push_back(stripe);
      }
      return;
  }
}

struct Number {
  double value_m = 0;
  bool is_tolerance = false;
};

// The tolerance marks first, then the round numbers; one that would stand on another's line is left
// out.
std::vector<Number> bar_numbers(const LegendContent& content, float half_bar, float line) {
  std::vector<Number> numbers;
  const auto add = [&](double value_m, bool is_tolerance) {
    const auto clash = [&](const Number& other) {
      return std::abs(other.value_m - value_m) / content.range_m * half_bar < 0.95 * line;
    };
    if (std::ranges::none_of(numbers, clash)) numbers.push_back({value_m, is_tolerance});
  };
  if (content.tolerance_m > 0 && content.tolerance_m <= content.range_m) {
    add(content.tolerance_m, true);
    add(-content.tolerance_m, true);
  }
  const double step = legend_step(content.range_m, content.units);
  const int count = static_cast<int>(std::floor(content.range_m / step + 1e-9));
  for (int i = count; i >= 0; --i) {
    add(i * step, false);
    if (i > 0) add(-i * step, false);
  }
  return numbers;
}

}  // namespace

std::string legend_number(double length_m, LengthDisplay units) {
  const std::string text = magnitude(length_m, units);
  return text == "0" ? text : sign_of(length_m) + text;
}

double legend_step(double range_m, LengthDisplay units) {
  assert(range_m > 0 && "a range");
  const bool metric = units == LengthDisplay::kMillimetre;
  double step = metric ? 0.0001 : kInch / 32;
  for (int i = 0; range_m / step > 4 + 1e-9; ++i) {
    // 1, 2, 5, 10 of a millimetre; halves of an inch
    step *= metric ? (i % 3 == 1 ? 2.5 : 2.0) : 2.0;
  }
  return step;
}

float legend_text_px(double scale) {
  return std::max(1.0F, std::round(static_cast<float>(14 * scale)));
}

Canvas draw_legend(const LegendContent& content, int width, int height, double scale,
                   const FontAtlas& font, double top_px) {
  assert(content.range_m > content.neutral_m && content.neutral_m >= 0 &&
         "a range beyond the neutral band");
  (void)width;
  const auto s = static_cast<float>(scale);
  const auto line = std::round(20 * s);
  const auto pad = std::round(12 * s);
  const auto margin = std::round(12 * s);
  const std::vector<Row> rows = key_rows(content);

  // Down the panel: title, "outside", the bar between its caps, "inside", the key.
  const auto cap = std::round(9 * s);
  const float fixed = 2 * pad + line * static_cast<float>(rows.size() + 3) + 3 * cap;
  const float room = static_cast<float>(height) - 2 * margin - fixed;
  const auto half_bar = std::round(0.5F * std::clamp(room, 60 * s, 220 * s));
  const float panel_height = fixed + 2 * half_bar;

  const std::string title =
      content.units == LengthDisplay::kMillimetre ? "Deviation, mm" : "Deviation, inch";
  const auto bar_left = std::round(pad + 14 * s);
  const auto bar_width = std::round(16 * s);
  const float number_left = bar_left + bar_width + std::round(10 * s);
  const std::vector<Number> numbers = bar_numbers(content, half_bar, line);
  float panel_width = pad + font.width(title);
  for (const Number& n : numbers) {
    panel_width =
        std::max(panel_width, number_left + font.width(legend_number(n.value_m, content.units)));
  }
  for (const Row& row : rows)
    panel_width = std::max(panel_width, pad + 22 * s + font.width(row.text));
  panel_width = std::ceil(panel_width + pad);

  Canvas canvas;
  const float top =
      std::round(static_cast<float>(top_px) +
                 std::max(margin, 0.5F * (static_cast<float>(height) - panel_height)));
  const Pen pen{canvas, {margin, top}, s, legend_text_px(scale)};
  pen.box(0, 0, panel_width, panel_height, with_opacity(kInk, 0.72F), 8 * s);

  float y = pad + 0.5F * line;
  pen.text(title, pad, y, kText);
  y += line;
  pen.text("outside", number_left, y, kDimText);
  y += 0.5F * line + cap;
  const float middle = std::round(y + half_bar);
  const float bar_middle = bar_left + 0.5F * bar_width;
  // Pointed ends: whatever lies beyond the range has the last colour.
  pen.triangle(bar_middle, middle - half_bar - 0.5F * cap, 0.5F * bar_width, 0.5F * cap, 0,
               outside_stops().back());
  pen.triangle(bar_middle, middle + half_bar + 0.5F * cap, 0.5F * bar_width, 0.5F * cap,
               3.14159265F, inside_stops().back());
  const auto pixels = static_cast<int>(2 * half_bar);
  for (int i = 0; i < pixels; ++i) {
    const double value = content.range_m * (1 - (i + 0.5) / half_bar);
    pen.box(bar_left, middle - half_bar + static_cast<float>(i), bar_width, 1,
            with_opacity(deviation_colour(value, content.neutral_m, content.range_m), 1.0F));
  }
  for (const Number& n : numbers) {
    const float at = middle - static_cast<float>(n.value_m / content.range_m) * half_bar;
    const float thick = std::max(1.0F, std::round((n.is_tolerance ? 2.0F : 1.0F) * s));
    const float line_top = std::round(at - 0.5F * thick);
    if (n.is_tolerance) {
      pen.box(bar_left, line_top, bar_width + 5 * s, thick, with_opacity(kInk, 1.0F));
      pen.triangle(bar_left - 6 * s, at, 5 * s, 5 * s, 1.5708F, kText);
    } else {
      pen.box(bar_left + bar_width, line_top, 5 * s, thick, with_opacity(kDimText, 1.0F));
    }
    pen.text(legend_number(n.value_m, content.units), number_left, at,
             n.is_tolerance ? kText : kDimText);
  }
  y = middle + half_bar + cap + 0.5F * line;
  pen.text("inside", number_left, y, kDimText);
  y += line + cap;
  for (const Row& row : rows) {
    draw_key(pen, row.key, pad, y);
    pen.text(row.text, pad + 22 * s, y, kText);
    y += line;
  }
  return canvas;
}

}  // namespace spool::render
