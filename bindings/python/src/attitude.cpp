#include "bindings.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/angular_motion_file.hpp"
#include "linkwright/files/displacement_file.hpp"
#include "linkwright/files/link_chain_file.hpp"
#include "linkwright/files/orientation_file.hpp"
#include "linkwright/files/twist_file.hpp"

namespace linkwright::python {
namespace {

OrientationReport converted(const std::string& text) {
  return orientation_report(value_of(read_orientation_task(text)));
}
DisplacementReport displaced(const std::string& text) {
  return value_of(displacement_report(value_of(read_displacement_task(text))));
}

}  // namespace

void bind_attitude(py::module_& module) {
  py::module_ attitude = module.def_submodule("attitude", "JSON text to JSON text, as the files of `attitude`.");
  attitude.def("convert", [](const std::string& text) { return write_orientation_report(converted(text)); });
  attitude.def("convert_svg", [](const std::string& text) { return draw_orientation(converted(text)); });
  attitude.def("screw", [](const std::string& text) { return write_displacement_report(displaced(text)); });
  attitude.def("screw_svg", [](const std::string& text) { return draw_displacement(displaced(text)); });
  attitude.def("twist", [](const std::string& text) {
    return write_twist_report(value_of(twist_report(value_of(read_twist_task(text)))));
  });
  attitude.def("rates", [](const std::string& text) {
    return write_angular_motion_report(value_of(angular_motion_report(value_of(read_angular_motion_task(text)))));
  });
  attitude.def("dh", [](const std::string& text) {
    return write_link_chain_report(value_of(link_chain_report(value_of(read_link_chain_task(text)))));
  });
}

}  // namespace linkwright::python
