// A page of paper to draw on: PDF as vectors, or PNG of the same page.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/page_canvas.h"

#include <cmath>
#include <cstring>

#include <cairo.h>

#include <cairo-pdf.h>
#include <pango/pangocairo.h>

namespace spool::isometric {
namespace {

constexpr double kPoint_mm = 25.4 / 72;

template <auto Delete>
struct With {
  template <class T>
  void operator()(T* object) const {
    Delete(object);
  }
};
using Surface = std::unique_ptr<cairo_surface_t, With<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, With<cairo_destroy>>;
using Layout = std::unique_ptr<PangoLayout, With<g_object_unref>>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

Error cairo_error(cairo_status_t status) {
  return {ErrorCode::kInternal,
          std::string("cairo could not draw the page: ") + cairo_status_to_string(status)};
}

}  // namespace

struct PageCanvas::Impl {
  Surface surface;
  Context context;
  Layout layout;

  explicit Impl(cairo_surface_t* own) : surface(own), context(cairo_create(own)) {
    // The fonts' own advances, whatever the surface's pixels: PDF and PNG break alike.
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    layout.reset(pango_cairo_create_layout(context.get()));
    pango_cairo_context_set_font_options(pango_layout_get_context(layout.get()), options);
    cairo_font_options_destroy(options);
    // Else every letter would begin at a whole millimetre.
    pango_context_set_round_glyph_positions(pango_layout_get_context(layout.get()), FALSE);
  }

  // The em of Inter is 1.25 times its letters' body as drawings count it.
  void set(const std::string& utf8, double height_mm, bool is_bold, double room_mm) {
    PangoFontDescription* font =
        pango_font_description_from_string(is_bold ? "Inter Bold" : "Inter Medium");
    pango_font_description_set_absolute_size(font, height_mm * 1.25 * PANGO_SCALE);
    pango_layout_set_font_description(layout.get(), font);
    pango_font_description_free(font);
    pango_layout_set_text(layout.get(), utf8.data(), static_cast<int>(utf8.size()));
    pango_layout_set_width(layout.get(),
                           room_mm > 0 ? static_cast<int>(room_mm * PANGO_SCALE) : -1);
    pango_layout_set_ellipsize(layout.get(),
                               room_mm > 0 ? PANGO_ELLIPSIZE_END : PANGO_ELLIPSIZE_NONE);
    pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
    pango_cairo_update_layout(context.get(), layout.get());
  }
};

PageCanvas::PageCanvas(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PageCanvas::PageCanvas(PageCanvas&&) noexcept = default;
PageCanvas& PageCanvas::operator=(PageCanvas&&) noexcept = default;
PageCanvas::~PageCanvas() = default;

void PageCanvas::stroke(const guide::Stroke& stroke) {
  if (stroke.points.size() < 2) return;
  cairo_t* cairo = impl_->context.get();
  cairo_move_to(cairo, stroke.points[0].x(), stroke.points[0].y());
  for (std::size_t k = 1; k < stroke.points.size(); ++k)
    cairo_line_to(cairo, stroke.points[k].x(), stroke.points[k].y());
  if (stroke.is_closed) cairo_close_path(cairo);
  if (stroke.fill != guide::Stroke::Fill::kNone) {
    const double shade = stroke.fill == guide::Stroke::Fill::kPaper ? 1 : 0;
    cairo_set_source_rgb(cairo, shade, shade, shade);
    cairo_fill_preserve(cairo);
  }
  cairo_set_source_rgb(cairo, 0, 0, 0);
  cairo_set_line_width(cairo, stroke.width_mm);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  const double dash[2] = {1.2, 0.9};
  cairo_set_dash(cairo, dash, stroke.is_dashed ? 2 : 0, 0);
  cairo_stroke(cairo);
}

void PageCanvas::line(double x0, double y0, double x1, double y1, double width_mm) {
  stroke({{{x0, y0}, {x1, y1}}, width_mm});
}

void PageCanvas::box(double x, double y, double width, double height, double width_mm) {
  stroke({{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, width_mm, true});
}

void PageCanvas::text(const std::string& utf8, double x, double y, double height_mm,
                      TextAlign align, bool is_bold, double room_mm) {
  if (utf8.empty()) return;
  if (room_mm > 0 && text_width(utf8, height_mm, is_bold) <= room_mm) room_mm = 0;
  cairo_t* cairo = impl_->context.get();
  impl_->set(utf8, height_mm, is_bold, room_mm);
  PangoRectangle extents;
  pango_layout_get_extents(impl_->layout.get(), nullptr, &extents);
  const double width = static_cast<double>(extents.width) / PANGO_SCALE;
  const double base =
      static_cast<double>(pango_layout_get_baseline(impl_->layout.get())) / PANGO_SCALE;
  const double left = align == TextAlign::kLeft     ? x
                      : align == TextAlign::kCentre ? x - width / 2
                                                    : x - width;
  // Capitals of Inter are 0.727 of the em high.
  cairo_set_source_rgb(cairo, 0, 0, 0);
  cairo_move_to(cairo, left, y - base + 0.5 * 0.727 * 1.25 * height_mm);
  pango_cairo_show_layout(cairo, impl_->layout.get());
}

double PageCanvas::text_width(const std::string& utf8, double height_mm, bool is_bold) {
  impl_->set(utf8, height_mm, is_bold, 0);
  PangoRectangle extents;
  pango_layout_get_extents(impl_->layout.get(), nullptr, &extents);
  return static_cast<double>(extents.width) / PANGO_SCALE;
}

void PageCanvas::draw(const guide::Drawing& drawing) {
  for (const guide::Stroke& each : drawing.strokes) stroke(each);
  cairo_t* cairo = impl_->context.get();
  for (const guide::DrawnText& each : drawing.texts) {
    if (each.on_paper) {
      cairo_set_source_rgb(cairo, 1, 1, 1);
      cairo_rectangle(cairo, each.centre.x() - each.half_size.x(),
                      each.centre.y() - each.half_size.y(), 2 * each.half_size.x(),
                      2 * each.half_size.y());
      cairo_fill(cairo);
    }
    text(each.utf8, each.centre.x(), each.centre.y(), each.height_mm, TextAlign::kCentre);
  }
}

void PageCanvas::image(const render::Image& image, double x, double y, double width,
                       double height) {
  if (image.width <= 0 || image.height <= 0) return;
  Surface picture(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
  if (cairo_surface_status(picture.get()) != CAIRO_STATUS_SUCCESS) return;
  cairo_surface_flush(picture.get());
  unsigned char* rows = cairo_image_surface_get_data(picture.get());
  const int stride = cairo_image_surface_get_stride(picture.get());
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const std::uint8_t* from = image.pixel(u, v);
      const std::uint32_t pixel =
          (std::uint32_t{from[0]} << 16) | (std::uint32_t{from[1]} << 8) | std::uint32_t{from[2]};
      std::memcpy(rows + static_cast<std::ptrdiff_t>(v) * stride + 4 * u, &pixel, 4);
    }
  }
  cairo_surface_mark_dirty(picture.get());
  cairo_t* cairo = impl_->context.get();
  cairo_save(cairo);
  cairo_translate(cairo, x, y);
  cairo_scale(cairo, width / image.width, height / image.height);
  cairo_set_source_surface(cairo, picture.get(), 0, 0);
  cairo_paint(cairo);
  cairo_restore(cairo);
}

Result<std::string> draw_pdf(const Pages& pages, const std::string& title, const PageSize& size) {
  std::string bytes;
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(
      append, &bytes, size.width_mm / kPoint_mm, size.height_mm / kPoint_mm);
  // Without one cairo would write the clock's.
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, title.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "SpoolSight");
  PageCanvas canvas(std::make_unique<PageCanvas::Impl>(surface));
  cairo_t* cairo = canvas.impl_->context.get();
  cairo_scale(cairo, 1 / kPoint_mm, 1 / kPoint_mm);
  for (const auto& page : pages) {
    page(canvas);
    cairo_show_page(cairo);
  }
  cairo_surface_finish(surface);
  const cairo_status_t status = cairo_status(cairo) != CAIRO_STATUS_SUCCESS
                                    ? cairo_status(cairo)
                                    : cairo_surface_status(surface);
  if (status != CAIRO_STATUS_SUCCESS) return cairo_error(status);
  return bytes;
}

Result<render::Image> draw_page(const std::function<void(PageCanvas&)>& page, double dpi,
                                const PageSize& size) {
  render::Image image;
  image.width = static_cast<int>(std::lround(size.width_mm / 25.4 * dpi));
  image.height = static_cast<int>(std::lround(size.height_mm / 25.4 * dpi));
  cairo_surface_t* surface =
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height);
  PageCanvas canvas(std::make_unique<PageCanvas::Impl>(surface));
  cairo_t* cairo = canvas.impl_->context.get();
  cairo_set_source_rgb(cairo, 1, 1, 1);
  cairo_paint(cairo);
  cairo_scale(cairo, dpi / 25.4, dpi / 25.4);
  page(canvas);
  cairo_surface_flush(surface);
  if (cairo_status(cairo) != CAIRO_STATUS_SUCCESS) return cairo_error(cairo_status(cairo));
  const unsigned char* rows = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  image.rgba.resize(4 * static_cast<std::size_t>(image.width) *
                    static_cast<std::size_t>(image.height));
  std::uint8_t* to = image.rgba.data();
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u, to += 4) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, rows + static_cast<std::ptrdiff_t>(v) * stride + 4 * u, 4);
      to[0] = static_cast<std::uint8_t>(pixel >> 16);
      to[1] = static_cast<std::uint8_t>(pixel >> 8);
      to[2] = static_cast<std::uint8_t>(pixel);
      to[3] = 255;
    }
  }
  return image;
}

double text_width_mm(const std::string& utf8, double height_mm) {
  PageCanvas canvas(
      std::make_unique<PageCanvas::Impl>(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1)));
  return canvas.text_width(utf8, height_mm);
}

std::vector<std::string> wrapped_lines(const std::string& utf8, double height_mm, double room_mm,
                                       bool is_bold) {
  std::vector<std::string> lines;
  if (utf8.empty()) return lines;
  PageCanvas canvas(
      std::make_unique<PageCanvas::Impl>(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1)));
  PangoLayout* layout = canvas.impl_->layout.get();
  canvas.impl_->set(utf8, height_mm, is_bold, room_mm);
  pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_NONE);
  pango_layout_set_single_paragraph_mode(layout, FALSE);
  pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
  const std::string text = pango_layout_get_text(layout);  // what is no UTF-8 was replaced
  for (const GSList* each = pango_layout_get_lines_readonly(layout); each != nullptr;
       each = each->next) {
    const auto* line = static_cast<const PangoLayoutLine*>(each->data);
    lines.push_back(text.substr(static_cast<std::size_t>(line->start_index),
                                static_cast<std::size_t>(line->length)));
  }
  return lines;
}

}  // namespace spool::isometric
