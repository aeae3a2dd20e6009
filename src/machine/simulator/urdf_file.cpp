#include <fmt/format.h>

#include "machine/simulator/simulator_model.hpp"
#include "machine/simulator/xml_writer.hpp"
#include "machine/simulator_file.hpp"

namespace linkwright {
namespace {

class UrdfWriter {
 public:
  explicit UrdfWriter(SimulatorModel model) : model_(std::move(model)) {}

  std::string write() {
    xml_.comment(model_.remark);
    xml_.open("robot", {{"name", "linkage"}});
    xml_.leaf("link", {{"name", "world"}});
    xml_.open("joint", {{"name", "ground_to_world"}, {"type", "fixed"}});
    xml_.leaf("parent", {{"link", "world"}});
    xml_.leaf("child", {{"link", model_.links.front().name}});
    xml_.close();
    for (const SimulatorLink& link : model_.links) write_link(link);
    for (int place = 1; place < static_cast<int>(model_.links.size()); ++place) write_joint(place);
    for (const SimulatorLoop& loop : model_.loops) write_loop(loop);
    xml_.close();
    return xml_.file();
  }

 private:
  void write_origin(const Displacement& place) {
    xml_.leaf("origin",
              {{"xyz", numbers(place.translation, model_.size)}, {"rpy", numbers(roll_pitch_yaw(place.rotation))}});
  }

  void write_link(const SimulatorLink& link) {
    xml_.open("link", {{"name", link.name}});
    const auto& [mass, centre, inertia] = link.matter;
    const double size = trace(inertia);
    xml_.open("inertial");
    write_origin(Displacement::translated(centre - link.origin));
    xml_.leaf("mass", {{"value", number(mass, mass)}});
    XmlWriter::Attributes elements;
    for (const auto& [name, row, column] : inertia_elements)
      elements.emplace_back(name, number(inertia(row, column), size));
    xml_.leaf("inertia", elements);
    xml_.close();
    for (const Solid& solid : link.solids) write_solid(link, solid);
    xml_.close();
  }

  void write_solid(const SimulatorLink& link, const Solid& solid) {
    xml_.open("visual");
    write_origin(solid.place);
    xml_.open("geometry");
    if (const auto* box = std::get_if<SolidBox>(&solid.shape))
      xml_.leaf("box", {{"size", numbers(box->size, model_.size)}});
    else {
      const auto& cylinder = std::get<SolidCylinder>(solid.shape);
      xml_.leaf("cylinder",
                {{"radius", number(cylinder.radius, model_.size)}, {"length", number(cylinder.length, model_.size)}});
    }
    xml_.close();
    xml_.open("material", {{"name", link.name}});
    xml_.leaf("color", {{"rgba", fmt::format("{} {} {} 1", link.colour[0], link.colour[1], link.colour[2])}});
    xml_.close();
    xml_.close();
  }

  void write_joint(int place) {
    const SimulatorLink& link = model_.links[static_cast<std::size_t>(place)];
    const SimulatorLink& parent = model_.links[static_cast<std::size_t>(link.parent)];
    const bool limited = place == model_.driver && model_.driver_range;
    xml_.open("joint", {{"name", model_.hinge_names[link.hinge]}, {"type", limited ? "revolute" : "continuous"}});
    write_origin(Displacement::translated(link.origin - parent.origin));
    xml_.leaf("parent", {{"link", parent.name}});
    xml_.leaf("child", {{"link", link.name}});
    xml_.leaf("axis", {{"xyz", numbers(model_.hinge_axes[link.hinge])}});
    if (limited) {
      xml_.comment("The format asks for the last two; they are those of no motor in particular.");
      xml_.leaf("limit", {{"lower", number(model_.driver_range->first)},
                          {"upper", number(model_.driver_range->second)},
                          {"effort", "1000"},
                          {"velocity", "10"}});
    }
    write_dependence(place);
    xml_.close();
  }

  void write_dependence(int place) {
    if (place == model_.driver) return;
    const std::string& driver = model_.hinge_names[model_.links[static_cast<std::size_t>(model_.driver)].hinge];
    if (const auto ratio = model_.ratios[static_cast<std::size_t>(place)])
      xml_.leaf("mimic", {{"joint", driver}, {"multiplier", number(*ratio)}});
    else
      xml_.comment(fmt::format("Follows {} through the loop, at no constant ratio: mimic would not be exact.", driver));
  }

  void write_loop(const SimulatorLoop& loop) {
    const std::string& name = model_.hinge_names[loop.hinge];
    const SimulatorLink &one = model_.links[static_cast<std::size_t>(loop.first)],
                        &other = model_.links[static_cast<std::size_t>(loop.second)];
    const Vector3 in_one = model_.hinge_points[loop.hinge] - one.origin,
                  in_other = model_.hinge_points[loop.hinge] - other.origin;
    xml_.comment(fmt::format(
        "URDF knows trees only. The hinge {} closes a loop: it joins {} at ({}) and {} at ({}), in their frames, "
        "about the axis ({}).",
        name, one.name, numbers(in_one, model_.size), other.name, numbers(in_other, model_.size),
        numbers(model_.hinge_axes[loop.hinge])));
  }

  SimulatorModel model_;
  XmlWriter xml_;
};

}  // namespace

std::string write_urdf(const Machine& machine, double density) {
  return UrdfWriter(simulator_model(machine, density)).write();
}

}  // namespace linkwright
