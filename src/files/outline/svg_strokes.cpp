#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <unordered_map>

#include "files/text/plain_text.hpp"
#include "strokes.hpp"
#include "svg_path.hpp"

namespace linkwright {
namespace {

constexpr int deepest_group = 100;

double number_of(const XmlElement& node, std::string_view attribute) {
  return attribute_number(node.attribute(attribute));
}

struct ViewBox {
  double x, y, width, height;
};
std::optional<ViewBox> view_box(const XmlElement& svg) {
  const std::vector<double> n = read_numbers(svg.attribute("viewBox"));
  return n.size() >= 4 && n[2] > 0 && n[3] > 0 ? std::optional(ViewBox{n[0], n[1], n[2], n[3]}) : std::nullopt;
}

/// y turned up. The outermost frame keeps its own unit: what it is in millimetres is told apart.
SvgMatrix view_of(const XmlElement& root) {
  const auto box = view_box(root);
  return {1, 0, 0, -1, box ? -box->x : 0, box ? box->y + box->height : 0};
}

std::optional<double> mm_of_unit(const XmlElement& root) {
  const std::string text = in_small_letters(root.attribute("width"));
  const double width = attribute_number(text);
  const std::string unit =
      in_small_letters(std::string_view(text).substr(std::min(text.find_last_of("0123456789.") + 1, text.size())));
  const std::unordered_map<std::string, double> units = {{"mm", 1},         {"cm", 10},       {"in", 25.4},
                                                         {"pt", 25.4 / 72}, {"pc", 25.4 / 6}, {"q", 0.25}};
  const auto found = units.find(unit);
  if (found == units.end() || !(width > 0)) return std::nullopt;
  const auto box = view_box(root);
  return box ? width * found->second / box->width : 25.4 / 96;
}

/// Where an inner <svg> lies in the outer one, and how much larger its unit is there.
SvgMatrix inner_view(const XmlElement& svg) {
  const auto box = view_box(svg);
  const double x = number_of(svg, "x"), y = number_of(svg, "y"), width = number_of(svg, "width"),
               height = number_of(svg, "height");
  if (!box || !(width > 0) || !(height > 0)) return {1, 0, 0, 1, x, y};
  const double scale = std::min(width / box->width, height / box->height);
  return {scale,
          0,
          0,
          scale,
          x + (width - scale * box->width) / 2 - scale * box->x,
          y + (height - scale * box->height) / 2 - scale * box->y};
}

bool is_hidden(const XmlElement& node) {
  if (node.attribute("display") == "none") return true;
  if (node.attribute("visibility") == "hidden") return true;
  std::string_view style = node.attribute("style");
  while (!style.empty()) {
    const std::string_view rule = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(rule.size() + 1, style.size()));
    const std::size_t colon = rule.find(':');
    if (colon == std::string_view::npos) continue;
    const std::string name = in_small_letters(rule.substr(0, colon)), value = in_small_letters(rule.substr(colon + 1));
    if ((name == "display" && value.starts_with("none")) || (name == "visibility" && value.starts_with("hidden")))
      return true;
  }
  return false;
}

// ---- shapes as the data of a path
// ------------------------------------------------------------------------------------

std::string ellipse_path(double x, double y, double rx, double ry) {
  if (!(rx > 0) || !(ry > 0)) return {};
  return fmt::format("M{0} {1}A{2} {3} 0 0 1 {4} {1}A{2} {3} 0 0 1 {0} {1}Z", x + rx, y, rx, ry, x - rx);
}

std::string rectangle_path(const XmlElement& node) {
  const double x = number_of(node, "x"), y = number_of(node, "y"), w = number_of(node, "width"),
               h = number_of(node, "height");
  if (!(w > 0) || !(h > 0)) return {};
  const double given = number_of(node, "rx"), other = number_of(node, "ry");
  const double rx = std::min(given != 0 ? given : other, w / 2), ry = std::min(other != 0 ? other : rx, h / 2);
  if (!(rx > 0) || !(ry > 0)) return fmt::format("M{} {}h{}v{}h{}Z", x, y, w, h, -w);
  const auto corner = [&](double dx, double dy) { return fmt::format("a{} {} 0 0 1 {} {}", rx, ry, dx, dy); };
  return fmt::format("M{} {}h{}{}v{}{}h{}{}v{}{}Z", x + rx, y, w - 2 * rx, corner(rx, ry), h - 2 * ry, corner(-rx, ry),
                     2 * rx - w, corner(-rx, -ry), 2 * ry - h, corner(rx, -ry));
}

std::string polygon_path(const XmlElement& node, bool closed) {
  const std::vector<double> n = read_numbers(node.attribute("points"));
  if (n.size() < 4) return {};
  std::string path = "M";
  for (std::size_t i = 0; i + 1 < n.size(); i += 2) path += fmt::format("{} {} ", n[i], n[i + 1]);
  return closed ? path + "Z" : path;
}

std::string path_of(const XmlElement& node) {
  const auto number = [&](std::string_view attribute) { return number_of(node, attribute); };
  const std::string_view name = node.local_name();
  if (name == "path") return node.attribute("d");
  if (name == "rect") return rectangle_path(node);
  if (name == "circle") return ellipse_path(number("cx"), number("cy"), number("r"), number("r"));
  if (name == "ellipse") return ellipse_path(number("cx"), number("cy"), number("rx"), number("ry"));
  if (name == "line") return fmt::format("M{} {}L{} {}", number("x1"), number("y1"), number("x2"), number("y2"));
  if (name == "polyline" || name == "polygon") return polygon_path(node, name == "polygon");
  return {};
}

// ---- the tree
// --------------------------------------------------------------------------------------------------------

/// Draws what the tree of an SVG shows, used parts in their place.
class SvgPainter {
 public:
  explicit SvgPainter(const XmlElements& elements) : elements_(elements) {
    for (const XmlElement& each : elements)
      if (const std::string& id = each.attribute("id"); !id.empty()) ids_.emplace(id, &each);  // the first of that name
  }

  Result<Strokes> strokes() {
    const XmlElement& root = elements_.front();
    draw_children(root, view_of(root), 0);
    if (collector_.is_full()) return drawing_of_too_much();
    const auto box = view_box(root);
    const Extent sheet =
        box ? Extent{box->width, box->height} : Extent{number_of(root, "width"), number_of(root, "height")};
    const bool has_sheet = sheet.width > 0 && sheet.height > 0;
    return Strokes{collector_.take(), mm_of_unit(root), has_sheet ? std::optional(sheet) : std::nullopt};
  }

 private:
  void draw_children(const XmlElement& of, const SvgMatrix& frame, int nested) {
    if (nested > deepest_group) return collector_.refuse();
    for (const std::size_t child : of.children)
      if (!collector_.is_full()) draw(elements_[child], frame, nested);
  }
  void draw(const XmlElement& node, const SvgMatrix& outer, int nested) {
    collector_.step();
    const std::string_view name = node.local_name();
    if (is_hidden(node)) return;
    const SvgMatrix frame = outer * read_transform(node.attribute("transform"));
    if (name == "g" || name == "a" || name == "switch") return draw_children(node, frame, nested + 1);
    if (name == "svg") return draw_children(node, frame * inner_view(node), nested + 1);
    if (name == "use") return draw_used(node, frame, nested);
    if (const std::string path = path_of(node); !path.empty()) draw_path(path, frame, collector_);
  }
  void draw_used(const XmlElement& use, const SvgMatrix& frame, int nested) {
    const std::string& href = use.attribute("href");
    const std::string_view address = href.empty() ? use.attribute("xlink:href") : href;
    const auto found = address.starts_with('#') ? ids_.find(address.substr(1)) : ids_.end();
    if (found == ids_.end()) return;
    if (nested > deepest_group) return collector_.refuse();  // it may use itself
    const SvgMatrix moved = frame * SvgMatrix{1, 0, 0, 1, number_of(use, "x"), number_of(use, "y")};
    if (const XmlElement& used = *found->second; used.local_name() == "symbol")
      draw_children(used, moved, nested + 1);
    else
      draw(used, moved, nested + 1);
  }

  const XmlElements& elements_;
  std::unordered_map<std::string_view, const XmlElement*> ids_;
  StrokeCollector collector_;
};

}  // namespace

Result<Strokes> svg_strokes(const XmlElements& elements) {
  if (elements.empty()) return unreadable_drawing("not_xml", "", "it is no XML");
  if (elements.front().local_name() != "svg")
    return unreadable_drawing("not_svg", "", "its outermost element is no <svg>");
  return SvgPainter(elements).strokes();
}

}  // namespace linkwright
