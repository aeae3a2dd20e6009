#include <algorithm>
#include <fmt/format.h>
#include <pugixml.hpp>

#include "files/text/plain_text.hpp"
#include "linkwright/files/outline_file.hpp"
#include "linkwright/files/point_table.hpp"
#include "linkwright/files/text_file.hpp"
#include "strokes.hpp"

namespace linkwright {
namespace {

std::string line_of(std::string_view text, std::ptrdiff_t offset) {
  const std::string_view before = text.substr(0, static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
  return fmt::format("line {}", 1 + std::count(before.begin(), before.end(), '\n'));
}

/// Without recursion: documents may be nested deeper than a stack is.
class ElementCollector : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node& node) override {
    if (node.type() != pugi::node_element) return true;
    const auto nested = static_cast<std::size_t>(depth());
    open_.resize(nested);
    if (nested > 0) elements_[open_.back()].children.push_back(elements_.size());
    open_.push_back(elements_.size());
    XmlElement& element = elements_.emplace_back(XmlElement{node.name()});
    for (const pugi::xml_attribute& each : node.attributes()) element.attributes.emplace(each.name(), each.value());
    return true;
  }
  XmlElements take() { return std::move(elements_); }

 private:
  XmlElements elements_;
  std::vector<std::size_t> open_;  ///< those around the next one, from the outermost
};

}  // namespace

Result<Drawing> read_svg_outlines(std::string_view text) {
  pugi::xml_document document;
  const pugi::xml_parse_result read =
      document.load_buffer(text.data(), text.size(), pugi::parse_minimal | pugi::parse_escapes);
  if (!read) return unreadable_drawing("not_xml", line_of(text, read.offset), in_small_letters(read.description()));
  ElementCollector collector;
  document.traverse(collector);
  return read_svg_outlines(collector.take());
}

Result<Drawing> read_outlines_file(const std::filesystem::path& path) {
  const std::string ending = in_small_letters(path.extension().string());
  if (ending != ".dxf" && ending != ".svg" && ending != ".csv")
    return Error{"unknown_drawing", "",
                 "an outline is read from a drawing whose name ends in .dxf or .svg, or from a table of points, .csv"};
  const auto text = read_text_file(path, max_drawing_bytes);
  if (!text)
    return text.errors().front().code == "file_too_large" ? Result<Drawing>(drawing_of_too_much()) : text.errors();
  if (ending == ".csv") {
    auto points = read_point_table(*text);
    return points ? Result<Drawing>(drawing_of_points(*std::move(points))) : points.errors();
  }
  return ending == ".dxf" ? read_dxf_outlines(*text) : read_svg_outlines(*text);
}

}  // namespace linkwright
