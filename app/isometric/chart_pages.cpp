// The pages of a job's charts: a row a joint with its tries and minutes, then a plot a joint.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "app/isometric/job_charts.h"

namespace spool::isometric {
namespace {

constexpr double kLeft_mm = kMargin_mm + 6, kTop_mm = kMargin_mm + 8;
constexpr double kFoot_mm = kPageHeight_mm - kMargin_mm - kBlockHeight_mm - 4;
constexpr double kLetters_mm = 2.5;

// ---- Tries and minutes ----

constexpr double kRow_mm = 7.2, kHead_mm = 14;
constexpr double kTries_mm = kLeft_mm + 86, kTriesWide_mm = 110;
constexpr double kMinutes_mm = kTries_mm + kTriesWide_mm + 18, kMinutesWide_mm = 90;
constexpr double kShrunk_mm = kMinutes_mm + kMinutesWide_mm + 30;

std::size_t rows_a_page() {
  return static_cast<std::size_t>((kFoot_mm - kTop_mm - kHead_mm) / kRow_mm);
}

guide::Stroke circle(double x, double y, double r, guide::Stroke::Fill fill) {
  guide::Stroke stroke{{}, 0.25, true, fill};
  for (int k = 0; k < 24; ++k) {
    const double angle = 2 * std::numbers::pi * k / 24;
    stroke.points.emplace_back(x + r * std::cos(angle), y + r * std::sin(angle));
  }
  return stroke;
}

// A shape an outcome, so that a copy without colours tells as much: cross redo, disc accepted, disc
// in a ring accepted against the numbers, triangle accepted with a remark.
void draw_mark(PageCanvas& page, const Try& made, double x, double y, double r) {
  using Fill = guide::Stroke::Fill;
  if (made.outcome == job::Outcome::kRedo) {
    page.line(x - r, y - r, x + r, y + r, 0.45);
    page.line(x - r, y + r, x + r, y - r, 0.45);
  } else if (made.outcome == job::Outcome::kRemark) {
    page.stroke({{{x, y - r}, {x + r, y + r}, {x - r, y + r}}, 0.25, true, Fill::kInk});
  } else {
    page.stroke(circle(x, y, 0.8 * r, Fill::kInk));
  }
  if (made.by_override) page.stroke(circle(x, y, 1.5 * r, Fill::kNone));
}

// A legend of the marks, from (x, y) on.
void draw_mark_legend(PageCanvas& page, double x, double y) {
  const auto one = [&](const Try& made, const char* text) {
    draw_mark(page, made, x, y, 1.3);
    page.text(text, x + 4, y, kLetters_mm);
    x += 9 + page.text_width(text, kLetters_mm);
  };
  one({job::Outcome::kRedo}, "to be done again");
  one({job::Outcome::kAccept}, "accepted");
  one({job::Outcome::kRemark}, "accepted with a remark");
  one({job::Outcome::kAccept, job::Phase::kAfterTack, true}, "accepted against the numbers");
}

// 1, 2 or 5 times a power of ten: at most six to `most`.
double tick_for(double most) {
  double tick = std::pow(10, std::floor(std::log10(std::max(most, 1e-9) / 6)));
  for (const double times : {2.0, 2.5, 2.0, 2.0, 2.5}) {
    if (most / tick <= 6) break;
    tick *= times;
  }
  return tick;
}

std::string minutes_text(double seconds) {
  return seconds < 600 ? fmt::format("{:.1f} min", seconds / 60)
                       : fmt::format("{:.0f} min", seconds / 60);
}

std::string shrinkage_text(const job::Shrinkage& each) {
  const bool is_length = each.unit == "m";
  const double scale = is_length ? 1000 : 180 / std::numbers::pi;
  return fmt::format("{} {:+.1f} ± {:.1f} {}", each.number, each.change * scale, 2 * each.u * scale,
                     is_length ? "mm" : "°");
}

struct Scales {
  double mark_mm = 5, minutes = 1;  // a try's width; minutes along the whole bar
};

Scales scales_of(const JobCharts& charts) {
  std::size_t most = 1;
  double seconds = 60;
  for (const JointChart& each : charts.joints) {
    most = std::max(most, each.tries.size());
    seconds = std::max(seconds, each.history.seconds);
  }
  return {std::min(6.0, kTriesWide_mm / static_cast<double>(most)), seconds / 60};
}

void draw_row(PageCanvas& page, const JointChart& chart, const Scales& scales, double y) {
  const double middle = y + kRow_mm / 2;
  const job::JointHistory& history = chart.history;
  page.text(chart.joint, kLeft_mm, middle, kLetters_mm, TextAlign::kLeft, true, 34);
  page.text(chart.part, kLeft_mm + 36, middle, kLetters_mm, TextAlign::kLeft, false, 46);
  page.line(kLeft_mm, y + kRow_mm, kPageWidth_mm - kMargin_mm - 6, y + kRow_mm, 0.08);
  if (chart.tries.empty()) {
    page.text("no check yet", kTries_mm, middle, kLetters_mm);
    return;
  }
  for (std::size_t k = 0; k < chart.tries.size(); ++k)
    draw_mark(page, chart.tries[k], kTries_mm + (static_cast<double>(k) + 0.5) * scales.mark_mm,
              middle, std::min(1.5, 0.3 * scales.mark_mm));
  page.text(std::to_string(history.tries), kTries_mm + kTriesWide_mm + 8, middle, kLetters_mm,
            TextAlign::kRight, true);
  const double length = kMinutesWide_mm * history.seconds / 60 / scales.minutes;
  using Fill = guide::Stroke::Fill;
  if (length > 0)
    page.stroke({{{kMinutes_mm, middle - 1.8},
                  {kMinutes_mm + length, middle - 1.8},
                  {kMinutes_mm + length, middle + 1.8},
                  {kMinutes_mm, middle + 1.8}},
                 0.2,
                 true,
                 history.time_is_whole ? Fill::kInk : Fill::kNone,
                 !history.time_is_whole});
  page.text(history.checks == 1
                ? "one check"
                : (history.time_is_whole ? "" : "at least ") + minutes_text(history.seconds),
            kMinutes_mm + length + 1.5, middle, kLetters_mm);
  if (!history.shrinkage.empty()) {
    std::string text = shrinkage_text(history.shrinkage.front());
    if (history.shrinkage.size() > 1)
      text += fmt::format(", and {} more", history.shrinkage.size() - 1);
    page.text(text, kShrunk_mm, middle, kLetters_mm, TextAlign::kLeft, false,
              kPageWidth_mm - kMargin_mm - 6 - kShrunk_mm);
  }
}

void draw_overview(PageCanvas& page, const JobCharts& charts, std::size_t from, int number,
                   int count) {
  TitleBlock title = charts.title;
  title.content = "Tries and minutes by joint";
  draw_frame(page, title, number, count);
  const Scales scales = scales_of(charts);
  const double heads = kTop_mm + 3;
  const auto head = [&](const char* text, double x) {
    page.text(text, x, heads, 3, TextAlign::kLeft, true);
  };
  head("Joint", kLeft_mm);
  head("Part", kLeft_mm + 36);
  head("Checks, one mark each; tries until accepted", kTries_mm);
  head("Minutes from the first check to the last", kMinutes_mm);
  head("Drawn by the weld", kShrunk_mm);
  const std::size_t to = std::min(charts.joints.size(), from + rows_a_page());
  const double foot = kTop_mm + kHead_mm + kRow_mm * static_cast<double>(to - from);
  const double tick = tick_for(scales.minutes);
  for (int k = 0; tick * k <= scales.minutes * (1 + 1e-9); ++k) {
    const double x = kMinutes_mm + kMinutesWide_mm * tick * k / scales.minutes;
    page.line(x, kTop_mm + kHead_mm - 1, x, foot, 0.08);
    page.text(fmt::format("{:g}", tick * k), x, kTop_mm + kHead_mm - 3, 2.2, TextAlign::kCentre);
  }
  for (std::size_t j = from; j < to; ++j)
    draw_row(page, charts.joints[j], scales,
             kTop_mm + kHead_mm + kRow_mm * static_cast<double>(j - from));
  if (charts.joints.empty())
    page.text("This job has no joints.", kLeft_mm, kTop_mm + kHead_mm + 5, 3);
  draw_mark_legend(page, kLeft_mm + 2, kFoot_mm + 6);
  page.text("A broken outline: of some time between two checks no clock tells; it took longer.",
            kLeft_mm, kFoot_mm + 12, kLetters_mm);
}

// ---- What each try measured ----

constexpr double kPlotWide_mm = 92, kPlotHigh_mm = 68, kPlotGap_mm = 8;
constexpr int kPlotsAcross = 4, kPlotsDown = 3;
constexpr double kMost =
    3;  // tolerances up and down; what is further out stands at the edge, with its share

// With a true minus, as wide as the plus.
std::string share_text(double share) {
  const std::string size = fmt::format("{:.2g}", std::abs(share));
  return share == 0 ? "0" : (share < 0 ? "−" : "+") + size;
}

void draw_plot(PageCanvas& page, const JointChart& chart, double x, double y) {
  page.text(chart.joint + "  " + chart.part, x, y + 2, kLetters_mm, TextAlign::kLeft, true,
            kPlotWide_mm);
  page.text(chart.number.empty() ? "nothing with a tolerance was measured" : chart.number, x, y + 6,
            2.2, TextAlign::kLeft, false, kPlotWide_mm);
  const double left = x + 8, wide = kPlotWide_mm - 8, top = y + 10, high = kPlotHigh_mm - 16;
  const double middle = top + high / 2;
  const auto height = [&](double share) {
    return middle - std::clamp(share, -kMost, kMost) / kMost * high / 2;
  };
  page.box(left, top, wide, high, 0.15);
  for (const int share : {-2, -1, 0, 1, 2}) {
    const bool is_limit = share == 1 || share == -1;
    page.stroke({{{left, height(share)}, {left + wide, height(share)}},
                 is_limit ? 0.3 : 0.08,
                 false,
                 guide::Stroke::Fill::kNone,
                 is_limit});
    page.text(share_text(share), left - 1.5, height(share), 2, TextAlign::kRight);
  }
  const auto count = static_cast<double>(chart.tries.size());
  const double step = std::min(12.0, wide / count);
  const double mark = std::min(1.3, 0.25 * step);
  const auto every = static_cast<std::size_t>(std::ceil(4 / step));  // numbers that do not touch
  for (std::size_t k = 0; k < chart.tries.size(); ++k) {
    const Try& made = chart.tries[k];
    const double at = left + (static_cast<double>(k) + 0.5) * step;
    if (k % every == 0)
      page.text(std::to_string(k + 1), at, top + high + 2.5, 2, TextAlign::kCentre);
    if (!made.deviation) {
      page.text("–", at, top + high - 2, 2.5, TextAlign::kCentre);
      continue;
    }
    const double low = height(*made.deviation - made.u), up = height(*made.deviation + made.u);
    page.line(at, low, at, up, 0.2);
    page.line(at - 0.6 * mark, low, at + 0.6 * mark, low, 0.2);
    page.line(at - 0.6 * mark, up, at + 0.6 * mark, up, 0.2);
    draw_mark(page, made, at, height(*made.deviation), mark);
    if (std::abs(*made.deviation) > kMost)
      page.text(share_text(*made.deviation), at + 1.6 * mark,
                height(*made.deviation) + (*made.deviation > 0 ? 2 : -2), 2);
  }
}

void draw_plots(PageCanvas& page, const JobCharts& charts,
                const std::vector<const JointChart*>& shown, std::size_t from, int number,
                int count) {
  TitleBlock title = charts.title;
  title.content = "What each try measured";
  draw_frame(page, title, number, count);
  constexpr std::size_t kPlots = std::size_t{kPlotsAcross} * kPlotsDown;
  for (std::size_t j = from; j < std::min(shown.size(), from + kPlots); ++j) {
    const auto at = static_cast<int>(j - from);
    draw_plot(page, *shown[j], kLeft_mm + (at % kPlotsAcross) * (kPlotWide_mm + kPlotGap_mm),
              kTop_mm + (at / kPlotsAcross) * (kPlotHigh_mm + kPlotGap_mm));
  }
  draw_mark_legend(page, kLeft_mm + 2, kFoot_mm + 6);
  page.text(
      "Up and down: deviation over tolerance, of the number that was furthest out in any try;",
      kLeft_mm, kFoot_mm + 12, kLetters_mm);
  page.text("bars: its U (k = 2); broken lines: the tolerance; –: not measured. Across: checks.",
            kLeft_mm, kFoot_mm + 17, kLetters_mm);
}

}  // namespace

Pages chart_pages(const JobCharts& charts) {
  std::vector<const JointChart*> plotted;
  for (const JointChart& each : charts.joints)
    if (!each.tries.empty()) plotted.push_back(&each);
  constexpr std::size_t kPlots = std::size_t{kPlotsAcross} * kPlotsDown;
  const std::size_t rows = rows_a_page();
  const std::size_t tables = std::max<std::size_t>(1, (charts.joints.size() + rows - 1) / rows);
  const std::size_t plots = (plotted.size() + kPlots - 1) / kPlots;
  const int count = static_cast<int>(tables + plots);
  Pages pages;
  for (std::size_t k = 0; k < tables; ++k)
    pages.emplace_back([&charts, k, rows, count](PageCanvas& page) {
      draw_overview(page, charts, k * rows, static_cast<int>(k) + 1, count);
    });
  for (std::size_t k = 0; k < plots; ++k)
    pages.emplace_back([&charts, plotted, k, tables, count](PageCanvas& page) {
      draw_plots(page, charts, plotted, k * kPlots, static_cast<int>(tables + k) + 1, count);
    });
  return pages;
}

}  // namespace spool::isometric
