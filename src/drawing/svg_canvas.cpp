#include "svg_canvas.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

/// A coordinate to a hundredth of a px, without needless zeros.
std::string px(double value) {
  constexpr double farthest = 1e6;  // renderers keep coordinates as float
  std::string text = rounded_text(std::clamp(value, -farthest, farthest), 2);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string point_list(std::span<const Point> points) {
  std::string text;
  for (const Point point : points)
    text += fmt::format("{}{},{}", text.empty() ? "" : " ", px(point.real()), px(point.imag()));
  return text;
}

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

/// Width of the character that starts with this byte, in sizes: wide for the scripts of three and more bytes beyond
/// punctuation and arrows.
double character_width(char first) {
  const auto byte = static_cast<unsigned char>(first);
  if (byte >= 0xE3) return 1.0;
  if (std::string_view("il.,:;|!'()[] ").find(first) != std::string_view::npos) return 0.33;
  if (byte >= 'A' && byte <= 'Z') return 0.68;
  if (first == 'm' || first == 'w') return 0.9;
  return 0.6;
}

/// Bytes of the character that the text starts with; 0 where it is not UTF-8 or not a character of XML 1.0
/// (U+FFFE and U+FFFF are none).
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool surrogate = first == 0xED && byte(1) >= 0xA0;
  const bool beyond = first == 0xF4 && byte(1) >= 0x90;
  const bool no_character = first == 0xEF && byte(1) == 0xBF && byte(2) >= 0xBE;
  return overlong || surrogate || beyond || no_character ? 0 : length;
}

void put_escaped(std::string& escaped, char c) {
  switch (c) {
    case '&':
      escaped += "&amp;";
      break;
    case '<':
      escaped += "&lt;";
      break;
    case '>':
      escaped += "&gt;";
      break;
    case '"':
      escaped += "&quot;";
      break;
    case '\n':
    case '\r':
    case '\t':
      escaped += ' ';
      break;
    default:
      if (static_cast<unsigned char>(c) >= 0x20) escaped += c;
  }
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string escaped;
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t length = character_length(text.substr(place));
    if (length > 1) escaped += text.substr(place, length);
    if (length == 1) put_escaped(escaped, text[place]);
    place += std::max<std::size_t>(length, 1);
  }
  return escaped;
}

double text_width(std::string_view text, double size) {
  double width = 0;
  for (const char c : text) {
    if (starts_character(c)) width += character_width(c);
  }
  return width * size;
}

std::string fit_text(std::string_view text, double size, double width) {
  if (text_width(text, size) <= width) return std::string(text);
  double used = size;  // the "…"
  std::size_t end = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!starts_character(text[i])) continue;
    used += character_width(text[i]) * size;
    if (used > width) break;
    end = i;
  }
  return std::string(text.substr(0, end)) + "…";
}

SvgCanvas::SvgCanvas(double width, double height, std::string_view title)
    : width_(width), height_(height), title_(xml_text(title)) {}

void SvgCanvas::line(Point from, Point to, std::string_view attributes) {
  content_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", px(from.real()), px(from.imag()),
                          px(to.real()), px(to.imag()), attributes);
}

void SvgCanvas::polyline(std::span<const Point> points, std::string_view attributes) {
  if (points.size() < 2) return;
  content_ += fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", point_list(points), attributes);
}

void SvgCanvas::polygon(std::span<const Point> points, std::string_view attributes) {
  content_ += fmt::format("<polygon points=\"{}\" {}/>\n", point_list(points), attributes);
}

void SvgCanvas::circle(Point center, double radius, std::string_view attributes) {
  content_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", px(center.real()), px(center.imag()),
                          px(radius), attributes);
}

void SvgCanvas::rectangle(Point corner, double width, double height, std::string_view attributes) {
  content_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", px(corner.real()),
                          px(corner.imag()), px(width), px(height), attributes);
}

void SvgCanvas::text(Point position, std::string_view content, const TextStyle& style) {
  const std::string x = px(position.real()), y = px(position.imag());
  std::string attributes =
      fmt::format("x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"", x, y, px(style.size), style.color);
  if (style.anchor != "start") attributes += fmt::format(" text-anchor=\"{}\"", style.anchor);
  if (style.weight != 400) attributes += fmt::format(" font-weight=\"{}\"", style.weight);
  if (style.turn != 0) attributes += fmt::format(" transform=\"rotate({} {} {})\"", px(style.turn), x, y);
  if (!style.halo.empty()) {
    attributes +=
        fmt::format(" stroke=\"{}\" stroke-width=\"4\" stroke-linejoin=\"round\" paint-order=\"stroke\"", style.halo);
  }
  content_ += fmt::format("<text {}>{}</text>\n", attributes, xml_text(content));
}

void SvgCanvas::png(Point corner, double width, double height, std::string_view base64) {
  content_ += fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "xlink:href=\"data:image/png;base64,{}\"/>\n",
      px(corner.real()), px(corner.imag()), px(width), px(height), base64);
}

void SvgCanvas::begin_group(std::string_view attributes) { content_ += fmt::format("<g {}>\n", attributes); }
void SvgCanvas::end_group() { content_ += "</g>\n"; }

void SvgCanvas::begin_clip(Point corner, double width, double height) {
  const std::string name = fmt::format("clip{}", ++clips_);
  content_ += fmt::format("<clipPath id=\"{}\">\n", name);
  rectangle(corner, width, height, "");
  content_ += "</clipPath>\n";
  begin_group(fmt::format("clip-path=\"url(#{})\"", name));
}

std::string SvgCanvas::file() const {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', 'Noto Sans', 'DejaVu Sans', "
      "sans-serif\" style=\"font-variant-numeric: tabular-nums\">\n<title>{2}</title>\n{3}</svg>\n",
      px(width_), px(height_), title_, content_);
}

std::string stroke(std::string_view color, double width, std::string_view dashes) {
  std::string text = fmt::format("stroke=\"{}\" stroke-width=\"{}\"", color, px(width));
  return dashes.empty() ? text : text + fmt::format(" stroke-dasharray=\"{}\"", dashes);
}

std::string fill(std::string_view color, double opacity) {
  std::string text = fmt::format("fill=\"{}\"", color);
  return opacity == 1 ? text : text + fmt::format(" fill-opacity=\"{}\"", px(opacity));
}

}  // namespace linkwright
