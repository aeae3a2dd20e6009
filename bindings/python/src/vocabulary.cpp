#include <fmt/format.h>

#include "bindings.hpp"
#include "drawing/palette.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/mechanism/linkage_type.hpp"

namespace linkwright::python {
namespace {

std::string hex(std::uint32_t color) { return fmt::format("#{:06X}", color); }

py::dict colors() {
  py::dict named;
  for (const auto& [name, color] : {std::pair("paper", palette::paper),
                                    {"ink", palette::ink},
                                    {"ink2", palette::ink2},
                                    {"ink3", palette::ink3},
                                    {"line", palette::line},
                                    {"grid", palette::grid},
                                    {"accent", palette::accent},
                                    {"input", palette::input},
                                    {"output", palette::output},
                                    {"body", palette::body},
                                    {"link_2", palette::link_2},
                                    {"link_5", palette::link_5},
                                    {"curve", palette::curve}})
    named[name] = std::string(color);
  named["defect"] = hex(palette::defect);
  named["hatch"] = hex(palette::hatch);
  return named;
}

}  // namespace

void bind_vocabulary(py::module_& module) {
  py::list names, labels, colors_of_types;
  for (std::size_t code = 0; code < linkage_type_count; ++code) {
    const auto type = static_cast<LinkageType>(code);
    names.append(std::string(name(type)));
    labels.append(std::string(label(type)));
    colors_of_types.append(hex(palette::types[code]));
  }
  module.attr("linkage_types") = py::tuple(names);
  module.attr("type_labels") = py::tuple(labels);
  module.attr("type_colors") = py::tuple(colors_of_types);
  module.attr("colors") = colors();
}

}  // namespace linkwright::python
