#include "supple/draw/canvas/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/new_file.hpp"
#include "supple/draw/canvas/jpeg.hpp"
#include "supple/draw/canvas/png.hpp"
#include "supple/draw/canvas/superscript.hpp"

namespace supple {

namespace {

/// Metric twin of Helvetica and Arial, which journals ask for; fontconfig replaces it where it is missing.
constexpr const char* font_family = "Liberation Sans";

cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

bool is_raster(PictureFormat format) { return format == PictureFormat::png || format == PictureFormat::jpg; }

/// Pixels of a length, an even number, because video encoders refuse frames of odd size.
int even_pixels(double points, double scale) { return 2 * static_cast<int>(std::ceil(points * scale / 2)); }

/// The pixels of an image surface, which nothing draws on any more.
PixelRows pixels_of(cairo_surface_t* image) {
  return {reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(image)),
          static_cast<std::size_t>(cairo_image_surface_get_width(image)),
          static_cast<std::size_t>(cairo_image_surface_get_height(image)),
          static_cast<std::size_t>(cairo_image_surface_get_stride(image)) / sizeof(std::uint32_t)};
}

/// Removes the date from the header of PostScript, so that the same picture has the same bytes.
void remove_date(std::string& bytes) {
  const std::size_t begin = bytes.find("\n%%CreationDate:");
  if (begin != std::string::npos) bytes.erase(begin, bytes.find('\n', begin + 1) - begin);
}

}  // namespace

PictureFormat picture_format(const std::string& path) {
  if (path == standard_output) return PictureFormat::png;
  const std::size_t dot = path.find_last_of("./");
  std::string ending = dot == std::string::npos || path[dot] == '/' ? "" : path.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending == "png") return PictureFormat::png;
  if (ending == "jpg" || ending == "jpeg") return PictureFormat::jpg;
  if (ending == "svg") return PictureFormat::svg;
  if (ending == "pdf") return PictureFormat::pdf;
  if (ending == "ps") return PictureFormat::ps;
  throw input_error("unknown picture format of '" + path + "'",
                    ending.empty() ? "the name has no ending" : "the ending is '." + ending + "'",
                    "end the name in .png, .jpg, .svg, .pdf or .ps");
}

struct Canvas::Surface {
  PictureFormat format;
  std::string bytes;
  cairo_surface_t* surface = nullptr;
  cairo_t* context = nullptr;

  Surface(PictureFormat f, double width, double height, double scale) : format(f) {
    switch (format) {
      case PictureFormat::svg:
        surface = cairo_svg_surface_create_for_stream(append_bytes, &bytes, width, height);
        break;
      case PictureFormat::pdf:
        surface = cairo_pdf_surface_create_for_stream(append_bytes, &bytes, width, height);
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                       "");  // the same bytes each time
        break;
      case PictureFormat::ps:
        surface = cairo_ps_surface_create_for_stream(append_bytes, &bytes, width, height);
        break;
      default:
        surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, even_pixels(width, scale),
                                             even_pixels(height, scale));
    }
    context = cairo_create(surface);
    if (is_raster(format)) cairo_scale(context, scale, scale);
  }
  ~Surface() {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }
  void check(const std::string& path) const {
    const cairo_status_t status = cairo_status(context);
    if (status != CAIRO_STATUS_SUCCESS)
      throw file_error(
          "cannot draw '" + path + "'",
          status == CAIRO_STATUS_NO_MEMORY ? "there is not enough memory" : "it is too large",
          std::string("ask for a smaller picture [Cairo: ") + cairo_status_to_string(status) + "]");
  }
};

Canvas::Canvas(const std::string& path, double width, double height, double dots_per_inch)
    : path_(path),
      width_(width),
      height_(height),
      surface_(std::make_unique<Surface>(picture_format(path), width, height, dots_per_inch / 72)) {
  surface_->check(path_);
  cairo_set_source_rgb(surface_->context, 1, 1, 1);
  cairo_paint(surface_->context);
  cairo_set_line_join(surface_->context, CAIRO_LINE_JOIN_ROUND);
}

Canvas::~Canvas() = default;

void Canvas::stroke_path(const Pen& pen) {
  cairo_t* c = surface_->context;
  cairo_set_source_rgb(c, pen.color.red, pen.color.green, pen.color.blue);
  cairo_set_line_width(c, pen.width);
  cairo_set_line_cap(c, pen.dash.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_set_dash(c, pen.dash.data(), static_cast<int>(pen.dash.size()), 0);
  cairo_stroke(c);
}

void Canvas::paint_path(const Paint& paint) {
  cairo_t* c = surface_->context;
  if (paint.fill) {
    cairo_set_source_rgb(c, paint.fill->red, paint.fill->green, paint.fill->blue);
    paint.pen ? cairo_fill_preserve(c) : cairo_fill(c);
  }
  if (paint.pen) stroke_path(*paint.pen);
  cairo_new_path(c);
}

void Canvas::line(Point from, Point to, const Pen& pen) {
  cairo_move_to(surface_->context, from[0], from[1]);
  cairo_line_to(surface_->context, to[0], to[1]);
  stroke_path(pen);
}

void Canvas::polyline(std::span<const Point> points, const Pen& pen) {
  bool drawing = false;
  for (const Point& p : points) {
    const bool finite = std::isfinite(p[0]) && std::isfinite(p[1]);
    if (finite) (drawing ? cairo_line_to : cairo_move_to)(surface_->context, p[0], p[1]);
    drawing = finite;
  }
  stroke_path(pen);
}

void Canvas::polygon(std::span<const Point> points, const Paint& paint) {
  for (const Point& p : points) cairo_line_to(surface_->context, p[0], p[1]);
  if (!points.empty()) cairo_close_path(surface_->context);
  paint_path(paint);
}

void Canvas::rectangle(Point low, Point high, const Paint& paint) {
  cairo_rectangle(surface_->context, low[0], low[1], high[0] - low[0], high[1] - low[1]);
  paint_path(paint);
}

void Canvas::circle(Point centre, double radius, const Paint& paint) {
  cairo_new_sub_path(surface_->context);
  cairo_arc(surface_->context, centre[0], centre[1], radius, 0, 2 * std::numbers::pi);
  cairo_close_path(surface_->context);
  paint_path(paint);
}

namespace {
void choose_font(cairo_t* c, const TextStyle& style) {
  cairo_select_font_face(c, font_family, CAIRO_FONT_SLANT_NORMAL,
                         style.weight == Weight::bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(c, style.size);
}
constexpr double raised_size = 0.68, rise = 0.36;  // of the size of the text

double run_width(cairo_t* c, const TextRun& run, TextStyle style) {
  if (run.raised) style.size *= raised_size;
  choose_font(c, style);
  cairo_text_extents_t extents;
  cairo_text_extents(c, run.text.c_str(), &extents);
  return extents.x_advance;
}

}  // namespace

double Canvas::text_width(const std::string& text, const TextStyle& style) const {
  double width = 0;
  for (const TextRun& run : text_runs(text)) width += run_width(surface_->context, run, style);
  return width;
}

void Canvas::text(Point at, const std::string& text, const TextStyle& style) {
  cairo_t* c = surface_->context;
  const double width = text_width(text, style);
  double x = style.across == Across::left ? 0 : style.across == Across::right ? -width : -width / 2;
  // By the height of capitals, not by the ink of this word, so that words beside each other share a baseline.
  const double capital = 0.72 * style.size;
  const double y = style.down == Down::top      ? capital
                   : style.down == Down::middle ? capital / 2
                   : style.down == Down::bottom ? -0.21 * style.size
                                                : 0;
  cairo_save(c);
  cairo_translate(c, at[0], at[1]);
  if (style.turn == Turn::left) cairo_rotate(c, -std::numbers::pi / 2);
  cairo_set_source_rgb(c, style.color.red, style.color.green, style.color.blue);
  for (const TextRun& run : text_runs(text)) {
    const double advance = run_width(c, run, style);  // chooses the font
    cairo_move_to(c, x, run.raised ? y - rise * style.size : y);
    cairo_show_text(c, run.text.c_str());
    x += advance;
  }
  cairo_restore(c);
  cairo_new_path(c);
}

void Canvas::image(Point upper_left, const PixelRows& pixels, double dots_per_inch) {
  cairo_t* c = surface_->context;
  cairo_surface_t* image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(pixels.width),
                                                      static_cast<int>(pixels.height));
  if (cairo_surface_status(image) == CAIRO_STATUS_SUCCESS) {
    cairo_surface_flush(image);
    for (std::size_t y = 0; y < pixels.height; ++y)
      std::copy_n(pixels.first + y * pixels.stride, pixels.width,
                  reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(image) +
                                                   y * cairo_image_surface_get_stride(image)));
    cairo_surface_mark_dirty(image);
  }
  double x = upper_left[0], y = upper_left[1];
  cairo_user_to_device(c, &x, &y);
  if (is_raster(surface_->format)) x = std::round(x), y = std::round(y);
  cairo_device_to_user(c, &x, &y);
  cairo_save(c);
  cairo_translate(c, x, y);
  cairo_scale(c, 72 / dots_per_inch, 72 / dots_per_inch);
  cairo_set_source_surface(c, image, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(c), CAIRO_FILTER_NEAREST);
  cairo_rectangle(c, 0, 0, static_cast<double>(pixels.width), static_cast<double>(pixels.height));
  cairo_fill(c);
  cairo_restore(c);
  cairo_surface_destroy(image);
}

void Canvas::clipped(std::span<const Point> polygon, ClipTo side, const std::function<void()>& draw) {
  cairo_t* c = surface_->context;
  cairo_save(c);
  if (side == ClipTo::outside) cairo_rectangle(c, 0, 0, width_, height_);
  cairo_new_sub_path(c);
  for (const Point& p : polygon) cairo_line_to(c, p[0], p[1]);
  cairo_close_path(c);
  cairo_set_fill_rule(c, CAIRO_FILL_RULE_EVEN_ODD);
  cairo_clip(c);
  cairo_set_fill_rule(c, CAIRO_FILL_RULE_WINDING);
  draw();
  cairo_restore(c);
}

void Canvas::finish() {
  cairo_surface_flush(surface_->surface);
  surface_->check(path_);
  std::string& bytes = surface_->bytes;
  if (surface_->format == PictureFormat::jpg) {
    bytes = encode_jpeg(pixels_of(surface_->surface));
  } else if (surface_->format == PictureFormat::png) {
    bytes = encode_png(pixels_of(surface_->surface));
  } else {
    cairo_show_page(surface_->context);
    cairo_surface_finish(surface_->surface);
  }
  NewFile file(path_, Existing::replace);
  if (surface_->format == PictureFormat::ps) remove_date(bytes);
  file.write(bytes);
  file.commit();
}

}  // namespace supple
