#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "machine/simulator/simulator_loads.hpp"
#include "machine/simulator/simulator_model.hpp"
#include "machine/simulator/xml_writer.hpp"
#include "machine/simulator_file.hpp"

namespace linkwright {
namespace {

class MjcfWriter {
 public:
  MjcfWriter(SimulatorModel model, std::optional<SimulatorLoads> loads)
      : model_(std::move(model)), loads_(std::move(loads)) {}

  std::string write(const std::string& title) {
    xml_.comment(model_.remark);
    xml_.open("mujoco", {{"model", title.empty() ? "linkage" : title}});
    xml_.leaf("compiler", {{"angle", "radian"}, {"autolimits", "true"}});
    xml_.comment(loads_ ? loads_->remark + "; links that they do not weigh weigh next to nothing."
                        : "Without gravity, so that the motor alone moves it; gravity 0 0 -9.81 pulls down along z.");
    xml_.leaf("option", {{"timestep", "0.001"},
                         {"integrator", "implicitfast"},
                         {"tolerance", "1e-12"},
                         {"gravity", loads_ ? numbers(loads_->gravity) : "0 0 0"}});
    write_defaults();
    xml_.open("worldbody");
    const double far = 3 * model_.size;
    if (loads_ && !loads_->forces.empty()) xml_.leaf("site", {{"name", "fixed_frame"}});
    xml_.leaf("light", {{"pos", numbers({far, -far, far})}, {"dir", "-1 1 -1"}});
    write_body(0);
    xml_.close();
    write_loops();
    write_lines();
    write_motor();
    write_keys();
    xml_.close();
    return xml_.file();
  }

 private:
  void write_defaults() {
    xml_.open("default");
    xml_.leaf("geom", {{"contype", "0"}, {"conaffinity", "0"}});
    xml_.leaf("site", {{"size", number(0.01 * model_.size)}});
    // As stiff as the time step allows.
    xml_.leaf("equality", {{"solref", "0.002 1"}, {"solimp", "0.9999 0.9999 0.001 0.5 2"}});
    xml_.close();
  }

  void write_body(int place) {
    const SimulatorLink& link = model_.links[static_cast<std::size_t>(place)];
    const Vector3 before = link.parent < 0 ? Vector3{} : model_.links[static_cast<std::size_t>(link.parent)].origin;
    xml_.open("body", {{"name", link.name}, {"pos", numbers(link.origin - before, model_.size)}});
    if (link.parent >= 0) write_joint(link);
    write_matter(link);
    for (const Solid& solid : link.solids) write_solid(link, solid);
    if (link.parent >= 0) write_site(link, model_.hinge_names[link.hinge], link.origin);
    for (const SimulatorLoop& loop : model_.loops)
      if (place == loop.first || place == loop.second)
        write_site(link, model_.hinge_names[loop.hinge] + "_of_" + link.name, model_.hinge_points[loop.hinge]);
    if (place == model_.guided) write_site(link, "guided", model_.guided_point);
    if (loads_) write_studs(link);
    for (int child = place + 1; child < static_cast<int>(model_.links.size()); ++child)
      if (model_.links[static_cast<std::size_t>(child)].parent == place) write_body(child);
    xml_.close();
  }

  void write_joint(const SimulatorLink& link) {
    XmlWriter::Attributes attributes = {
        {"name", model_.hinge_names[link.hinge]}, {"type", "hinge"}, {"axis", numbers(model_.hinge_axes[link.hinge])}};
    double stiffness = 0, turned = 0;  // of all springs there, and their sum of stiffness times where it rests
    if (loads_)
      for (const SimulatorLoads::HingeSpring& spring : loads_->hinges) {
        if (name(spring.hinge) != model_.hinge_names[link.hinge]) continue;
        stiffness += spring.stiffness;
        turned += spring.stiffness * spring.rests_at;
      }
    if (stiffness > 0) {
      attributes.emplace_back("stiffness", number(stiffness, stiffness));
      attributes.emplace_back("springref", number(turned / stiffness));
    }
    xml_.leaf("joint", attributes);
  }

  void write_studs(const SimulatorLink& link) {
    for (const SimulatorLoads::Line& line : loads_->lines)
      for (const auto& [stud, end] : {std::pair(line.from, "_from"), std::pair(line.to, "_to")})
        if (stud.body == link.body) write_site(link, line.name + end, stud.at);
    for (const SimulatorLoads::Force& force : loads_->forces)
      if (force.at.body == link.body) write_site(link, force.name + "_at", force.at.at);
  }

  /// What the loads weigh; without them the plates.
  [[nodiscard]] MassProperties matter_of(const SimulatorLink& link) const {
    if (!loads_ || link.body == 0) return link.matter;
    if (const auto& weighed = loads_->matter[static_cast<std::size_t>(link.body)]) return *weighed;
    constexpr double next_to_nothing = 1e-4;
    double all = 0;
    for (const auto& weighed : loads_->matter) all += weighed ? weighed->mass : 0;
    const double share = all > 0 ? next_to_nothing * all / link.matter.mass : next_to_nothing;
    return {share * link.matter.mass, link.matter.centre, share * link.matter.inertia};
  }

  void write_matter(const SimulatorLink& link) {
    const auto& [mass, centre, inertia] = matter_of(link);
    const double size = trace(inertia);
    xml_.leaf("inertial", {{"pos", numbers(centre - link.origin, model_.size)},
                           {"mass", number(mass, mass)},
                           {"fullinertia", numbers({inertia(0, 0), inertia(1, 1), inertia(2, 2)}, size) + ' ' +
                                               numbers({inertia(0, 1), inertia(0, 2), inertia(1, 2)}, size)}});
  }

  void write_solid(const SimulatorLink& link, const Solid& solid) {
    const UnitQuaternion q = solid.place.rotation.quaternion();
    XmlWriter::Attributes attributes;
    if (const auto* box = std::get_if<SolidBox>(&solid.shape))
      attributes = {{"type", "box"}, {"size", numbers(0.5 * box->size, model_.size)}};
    else {
      const auto& cylinder = std::get<SolidCylinder>(solid.shape);
      attributes = {{"type", "cylinder"},
                    {"size", number(cylinder.radius, model_.size) + ' ' + number(cylinder.length / 2, model_.size)}};
    }
    attributes.emplace_back("pos", numbers(solid.place.translation, model_.size));
    attributes.emplace_back("quat", number(q.w()) + ' ' + numbers(q.v()));
    attributes.emplace_back("rgba", fmt::format("{} {} {} 1", link.colour[0], link.colour[1], link.colour[2]));
    xml_.leaf("geom", attributes);
  }

  void write_site(const SimulatorLink& link, const std::string& name, Vector3 point) {
    xml_.leaf("site", {{"name", name}, {"pos", numbers(point - link.origin, model_.size)}});
  }

  void write_loops() {
    xml_.open("equality");
    for (const auto& [hinge, first, second] : model_.loops) {
      const SimulatorLink& one = model_.links[static_cast<std::size_t>(first)];
      if (loads_)
        for (const SimulatorLoads::HingeSpring& spring : loads_->hinges)
          if (name(spring.hinge) == model_.hinge_names[hinge])
            xml_.comment(fmt::format("A torsion spring at {}, where the loop is closed, is left out.",
                                     model_.hinge_names[hinge]));
      xml_.leaf("connect", {{"name", model_.hinge_names[hinge]},
                            {"body1", one.name},
                            {"body2", model_.links[static_cast<std::size_t>(second)].name},
                            {"anchor", numbers(model_.hinge_points[hinge] - one.origin, model_.size)}});
    }
    xml_.close();
  }

  void write_lines() {
    if (!loads_ || loads_->lines.empty()) return;
    xml_.open("tendon");
    for (const SimulatorLoads::Line& line : loads_->lines) {
      if (!line.remark.empty()) xml_.comment(line.remark);
      XmlWriter::Attributes attributes = {{"name", line.name}, {"width", number(0.01 * model_.size)}};
      if (line.stiffness > 0) {
        attributes.emplace_back("stiffness", number(line.stiffness, line.stiffness));
        attributes.emplace_back("springlength", number(line.slack[0]) + ' ' + number(line.slack[1]));
      }
      if (line.friction > 0) attributes.emplace_back("frictionloss", number(line.friction));
      xml_.open("spatial", attributes);
      xml_.leaf("site", {{"site", line.name + "_from"}});
      xml_.leaf("site", {{"site", line.name + "_to"}});
      xml_.close();
    }
    xml_.close();
  }

  /// What pushes whatever the control: gas, and forces given.
  void write_pushes() {
    if (!loads_) return;
    for (const SimulatorLoads::Line& line : loads_->lines)
      if (line.push)
        xml_.leaf("general", {{"name", line.name},
                              {"tendon", line.name},
                              {"gainprm", "0"},
                              {"biastype", "affine"},
                              {"biasprm", number((*line.push)[0]) + ' ' + number((*line.push)[1]) + " 0"}});
    for (const SimulatorLoads::Force& force : loads_->forces) {
      XmlWriter::Attributes attributes = {{"name", force.name}, {"site", force.name + "_at"}};
      if (!force.turns) attributes.emplace_back("refsite", "fixed_frame");
      attributes.insert(
          attributes.end(),
          {{"gear", numbers(force.force) + " 0 0 0"}, {"gainprm", "0"}, {"biastype", "affine"}, {"biasprm", "1 0 0"}});
      xml_.leaf("general", attributes);
    }
  }
  [[nodiscard]] std::size_t pushes() const {
    if (!loads_) return 0;
    const auto& lines = loads_->lines;
    return loads_->forces.size() +
           static_cast<std::size_t>(
               std::count_if(lines.begin(), lines.end(), [](const auto& line) { return line.push.has_value(); }));
  }

  /// A servo of some 10 Hz on all that moves, as if it were at the longest link's end; damped so that it does not
  /// overshoot.
  void write_motor() {
    double mass = 0;
    for (const SimulatorLink& link : model_.links)
      if (link.parent >= 0) mass += matter_of(link).mass;
    const double inertia = mass * model_.size * model_.size, speed = two_pi * 10;
    XmlWriter::Attributes attributes = {
        {"name", "motor"},
        {"joint", model_.hinge_names[model_.links[static_cast<std::size_t>(model_.driver)].hinge]},
        {"kp", number(inertia * speed * speed, inertia)},
        {"kv", number(2 * inertia * speed, inertia)}};
    if (model_.driver_range) {
      xml_.comment("Beyond this range the linkage locks.");
      attributes.emplace_back("ctrlrange",
                              number(model_.driver_range->first) + ' ' + number(model_.driver_range->second));
    }
    xml_.open("actuator");
    xml_.leaf("position", attributes);
    write_pushes();
    xml_.close();
  }

  void write_keys() {
    if (model_.keys.empty()) return;
    std::string idle;
    for (std::size_t k = 0; k < pushes(); ++k) idle += " 0";
    xml_.open("keyframe");
    for (const auto& [position, turns] : model_.keys) {
      std::string joints;
      for (const double turn : turns) joints += (joints.empty() ? "" : " ") + number(turn);
      xml_.leaf("key", {{"name", fmt::format("position_{}", position + 1)},
                        {"qpos", joints},
                        {"ctrl", number(turns[static_cast<std::size_t>(model_.driver - 1)]) + idle}});
    }
    xml_.close();
  }

  SimulatorModel model_;
  std::optional<SimulatorLoads> loads_;
  XmlWriter xml_;
};

}  // namespace

std::string write_mjcf(const Machine& machine, double density, const LinkageLoads* loads) {
  std::optional<SimulatorLoads> acting;
  if (loads) acting = simulator_loads(*loads, machine.linkage.millimetres() / 1000);
  return MjcfWriter(simulator_model(machine, density), std::move(acting)).write(machine.linkage.title);
}

}  // namespace linkwright
