#include <algorithm>
#include <fmt/format.h>
#include <pugixml.hpp>
#include <string>
#include <unordered_map>

#include "files/text/plain_text.hpp"
#include "strokes.hpp"
#include "svg_path.hpp"

namespace linkwright {
namespace {

constexpr int deepest_group = 100;

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name.substr(name.rfind(':') + 1);  // npos + 1 is 0
}

double number_of(const pugi::xml_node& node, const char* attribute) {
  return attribute_number(node.attribute(attribute).value());
}

struct ViewBox {
  double x, y, width, height;
};
std::optional<ViewBox> view_box(const pugi::xml_node& svg) {
  const std::vector<double> n = read_numbers(svg.attribute("viewBox").value());
  return n.size() >= 4 && n[2] > 0 && n[3] > 0 ? std::optional(ViewBox{n[0], n[1], n[2], n[3]}) : std::nullopt;
}

/// y turned up. The outermost frame keeps its own unit: what it is in millimetres is told apart.
SvgMatrix view_of(const pugi::xml_node& root) {
  const auto box = view_box(root);
  return {1, 0, 0, -1, box ? -box->x : 0, box ? box->y + box->height : 0};
}

std::optional<double> mm_of_unit(const pugi::xml_node& root) {
  const std::string text = in_small_letters(root.attribute("width").value());
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
SvgMatrix inner_view(const pugi::xml_node& svg) {
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

bool is_hidden(const pugi::xml_node& node) {
  if (std::string_view(node.attribute("display").value()) == "none") return true;
  if (std::string_view(node.attribute("visibility").value()) == "hidden") return true;
  std::string_view style = node.attribute("style").value();
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

std::string rectangle_path(const pugi::xml_node& node) {
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

std::string polygon_path(const pugi::xml_node& node, bool closed) {
  const std::vector<double> n = read_numbers(node.attribute("points").value());
  if (n.size() < 4) return {};
  std::string path = "M";
  for (std::size_t i = 0; i + 1 < n.size(); i += 2) path += fmt::format("{} {} ", n[i], n[i + 1]);
  return closed ? path + "Z" : path;
}

std::string path_of(const pugi::xml_node& node) {
  const auto number = [&](const char* attribute) { return number_of(node, attribute); };
  const std::string_view name = local_name(node);
  if (name == "path") return node.attribute("d").value();
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
  explicit SvgPainter(const pugi::xml_node& root) : root_(root) {}

  Result<Strokes> strokes() {
    draw_children(root_, view_of(root_), 0);
    if (collector_.is_full()) return drawing_of_too_much();
    const auto box = view_box(root_);
    const Extent sheet =
        box ? Extent{box->width, box->height} : Extent{number_of(root_, "width"), number_of(root_, "height")};
    const bool has_sheet = sheet.width > 0 && sheet.height > 0;
    return Strokes{collector_.take(), mm_of_unit(root_), has_sheet ? std::optional(sheet) : std::nullopt};
  }

 private:
  void draw_children(const pugi::xml_node& of, const SvgMatrix& frame, int nested) {
    if (nested > deepest_group) return collector_.refuse();
    for (const pugi::xml_node& child : of.children())
      if (child.type() == pugi::node_element && !collector_.is_full()) draw(child, frame, nested);
  }
  void draw(const pugi::xml_node& node, const SvgMatrix& outer, int nested) {
    collector_.step();
    const std::string_view name = local_name(node);
    if (is_hidden(node)) return;
    const pugi::xml_attribute transform = node.attribute("transform");
    const SvgMatrix frame = transform ? outer * read_transform(transform.value()) : outer;
    if (name == "g" || name == "a" || name == "switch") return draw_children(node, frame, nested + 1);
    if (name == "svg") return draw_children(node, frame * inner_view(node), nested + 1);
    if (name == "use") return draw_used(node, frame, nested);
    if (const std::string path = path_of(node); !path.empty()) draw_path(path, frame, collector_);
  }
  void draw_used(const pugi::xml_node& use, const SvgMatrix& frame, int nested) {
    const pugi::xml_attribute href = use.attribute("href");
    const std::string_view address = href ? href.value() : use.attribute("xlink:href").value();
    const pugi::xml_node used = address.starts_with('#') ? by_id(std::string(address.substr(1))) : pugi::xml_node();
    if (!used) return;
    if (nested > deepest_group) return collector_.refuse();  // it may use itself
    const SvgMatrix moved = frame * SvgMatrix{1, 0, 0, 1, number_of(use, "x"), number_of(use, "y")};
    if (local_name(used) == "symbol")
      draw_children(used, moved, nested + 1);
    else
      draw(used, moved, nested + 1);
  }
  /// The first of that name.
  pugi::xml_node by_id(const std::string& id) {
    if (ids_.empty()) {
      for (pugi::xml_node node = root_; node; node = next(node))
        if (const pugi::xml_attribute own = node.attribute("id")) ids_.emplace(own.value(), node);
      ids_.emplace("", pugi::xml_node());
    }
    const auto found = ids_.find(id);
    return found == ids_.end() ? pugi::xml_node() : found->second;
  }
  /// In the order of the file.
  pugi::xml_node next(pugi::xml_node node) const {
    if (node.first_child()) return node.first_child();
    while (node && node != root_ && !node.next_sibling()) node = node.parent();
    return node == root_ ? pugi::xml_node() : node.next_sibling();
  }

  pugi::xml_node root_;
  std::unordered_map<std::string, pugi::xml_node> ids_;
  StrokeCollector collector_;
};

std::string line_of(std::string_view text, std::ptrdiff_t offset) {
  const std::string_view before = text.substr(0, static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
  return fmt::format("line {}", 1 + std::count(before.begin(), before.end(), '\n'));
}

}  // namespace

Result<Strokes> svg_strokes(std::string_view text) {
  pugi::xml_document document;
  const pugi::xml_parse_result read =
      document.load_buffer(text.data(), text.size(), pugi::parse_minimal | pugi::parse_escapes);
  if (!read) return unreadable_drawing(line_of(text, read.offset), in_small_letters(read.description()));
  const pugi::xml_node root = document.document_element();
  if (local_name(root) != "svg") return unreadable_drawing("", "its outermost element is no <svg>");
  return SvgPainter(root).strokes();
}

}  // namespace linkwright
