#include "machine/simulator/xml_writer.hpp"

#include <fmt/format.h>

#include "drawing/svg_canvas.hpp"

namespace linkwright {

void XmlWriter::begin(std::string_view name, const Attributes& attributes) {
  file_ += fmt::format("{:{}}<{}", "", 2 * open_.size(), name);
  for (const auto& [key, value] : attributes) file_ += fmt::format(" {}=\"{}\"", key, xml_text(value));
}

void XmlWriter::open(std::string_view name, const Attributes& attributes) {
  begin(name, attributes);
  file_ += ">\n";
  open_.emplace_back(name);
}

void XmlWriter::close() {
  const std::string name = std::move(open_.back());
  open_.pop_back();
  file_ += fmt::format("{:{}}</{}>\n", "", 2 * open_.size(), name);
}

void XmlWriter::leaf(std::string_view name, const Attributes& attributes) {
  begin(name, attributes);
  file_ += "/>\n";
}

void XmlWriter::text(std::string_view name, std::string_view content, const Attributes& attributes) {
  begin(name, attributes);
  file_ += fmt::format(">{}</{}>\n", xml_text(content), name);
}

void XmlWriter::comment(std::string_view content) {
  std::string safe = xml_text(content);
  // A comment must not have "--" within it.
  for (std::size_t at = safe.find("--"); at != std::string::npos; at = safe.find("--", at)) safe.insert(at + 1, " ");
  file_ += fmt::format("{:{}}<!-- {} -->\n", "", 2 * open_.size(), safe);
}

}  // namespace linkwright
