// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing/canvas.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <numbers>
#include <utility>

#include "model/error.h"

namespace mikromakro {
namespace {

cairo_status_t append(void* content, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(content)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw run_failed("cannot draw the picture", "a size that fits into memory",
                     cairo_status_to_string(status));
}

// Removes the surface number from the id, which Cairo counts per process: the same picture must give the same
// file.
void forget_count(std::string& svg) {
  const std::string name = "<g id=\"surface";
  const std::size_t at = svg.find(name);
  if (at == std::string::npos) return;
  const std::size_t end = svg.find('"', at + name.size());
  svg.erase(at + name.size(), end - at - name.size());
}

}  // namespace

struct Canvas::Cairo {
  std::string content;
  Kind kind;
  cairo_surface_t* surface = nullptr;
  cairo_t* context = nullptr;

  void colour(const Colour& c) const { cairo_set_source_rgba(context, c.red, c.green, c.blue, c.alpha); }
  void stroke(const Colour& c, double width) const {
    colour(c);
    cairo_set_line_width(context, width);
    cairo_stroke(context);
  }
};

Canvas::Canvas(Kind kind, int width, int height) : cairo_(std::make_unique<Cairo>()) {
  cairo_->kind = kind;
  if (kind == Kind::svg) {
    cairo_->surface = cairo_svg_surface_create_for_stream(append, &cairo_->content, width, height);
    cairo_svg_surface_set_document_unit(cairo_->surface, CAIRO_SVG_UNIT_PX);
  } else {
    cairo_->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  }
  cairo_->context = cairo_create(cairo_->surface);
  check(cairo_status(cairo_->context));
  cairo_set_antialias(cairo_->context, CAIRO_ANTIALIAS_BEST);
  cairo_select_font_face(cairo_->context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_line_cap(cairo_->context, CAIRO_LINE_CAP_ROUND);
  cairo_->colour({1, 1, 1, 1});
  cairo_paint(cairo_->context);
}

Canvas::~Canvas() {
  cairo_destroy(cairo_->context);
  cairo_surface_destroy(cairo_->surface);
}

void Canvas::disc(const Pixel& centre, double radius, const Colour& fill, const Colour& outline,
                  double line_width) {
  cairo_new_path(cairo_->context);
  cairo_arc(cairo_->context, centre.x(), centre.y(), radius, 0, 2 * std::numbers::pi);
  cairo_close_path(cairo_->context);
  cairo_->colour(fill);
  cairo_fill_preserve(cairo_->context);
  cairo_->stroke(outline, line_width);
}

void Canvas::line(const Pixel& from, const Pixel& to, double width, const Colour& colour) {
  cairo_move_to(cairo_->context, from.x(), from.y());
  cairo_line_to(cairo_->context, to.x(), to.y());
  cairo_->stroke(colour, width);
}

void Canvas::polygon(std::span<const Pixel> corners, const Colour& fill) {
  for (const Pixel& corner : corners) cairo_line_to(cairo_->context, corner.x(), corner.y());
  cairo_close_path(cairo_->context);
  cairo_->colour(fill);
  cairo_fill(cairo_->context);
}

void Canvas::frame(const Pixel& corner, const Pixel& opposite, double width, const Colour& colour) {
  const Pixel size = opposite - corner;
  cairo_rectangle(cairo_->context, corner.x(), corner.y(), size.x(), size.y());
  cairo_->stroke(colour, width);
}

void Canvas::text(const Pixel& at, const std::string& words, double size, Anchor anchor, bool upwards) {
  cairo_t* const context = cairo_->context;
  cairo_save(context);
  cairo_set_font_size(context, size);
  cairo_text_extents_t extents;
  cairo_text_extents(context, words.c_str(), &extents);
  // Use the height of the font rather than of these letters, so that adjacent texts share a baseline.
  cairo_font_extents_t font;
  cairo_font_extents(context, &font);
  const double capital = 0.73 * font.ascent;
  cairo_translate(context, at.x(), at.y());
  if (upwards) cairo_rotate(context, -std::numbers::pi / 2);
  cairo_move_to(context, -anchor.x * extents.x_advance, (1 - anchor.y) * capital);
  cairo_->colour({0.1, 0.1, 0.1, 1});
  cairo_show_text(context, words.c_str());
  cairo_restore(context);
  cairo_new_path(context);
}

void Canvas::show_only(const Pixel& corner, const Pixel& opposite) {
  const Pixel size = opposite - corner;
  cairo_save(cairo_->context);
  cairo_rectangle(cairo_->context, corner.x(), corner.y(), size.x(), size.y());
  cairo_clip(cairo_->context);
}

void Canvas::show_all() {
  cairo_restore(cairo_->context);
}

std::string Canvas::encoded() {
  check(cairo_status(cairo_->context));
  if (cairo_->kind == Kind::png)
    check(cairo_surface_write_to_png_stream(cairo_->surface, append, &cairo_->content));
  cairo_surface_finish(cairo_->surface);
  check(cairo_surface_status(cairo_->surface));
  if (cairo_->kind == Kind::svg) forget_count(cairo_->content);
  return std::move(cairo_->content);
}

}  // namespace mikromakro
