#include "machine/spring_parts.hpp"

#include <algorithm>
#include <string>
#include <variant>

#include "loads/carried.hpp"
#include "machine/unlike_names.hpp"

namespace linkwright {
namespace {

constexpr double tube_by_rod = 2;

class SpringWorkshop {
 public:
  SpringWorkshop(const Machine& machine, const LinkageLoads& on, const MovingState& state)
      : machine_(machine), on_(on), state_(state) {
    double top = 0, thickest = stud_radius();
    for (const Part& part : machine.parts) {
      names_.take(part.name);
      if (const auto* plate = std::get_if<FlatPlate>(&part.shape)) top = std::max(top, plate->high);
    }
    for (const Spring& spring : on.loads.springs)
      if (const auto* gas = std::get_if<GasSpring>(&spring.law))
        thickest = std::max(thickest, tube_by_rod * rod_radius(*gas));
    plane_ = top + machine.sizes.gap + thickest;
    reach_ = plane_ + thickest;
  }

  std::vector<Part> make() {
    const Loads& loads = on_.loads;
    for (std::size_t k = 0; k < loads.springs.size(); ++k) {
      const Spring& spring = loads.springs[k];
      if (std::holds_alternative<TorsionSpring>(spring.law)) continue;
      const std::string name = spring_name(loads, k);
      make_studs(name, spring.from, spring.to);
      if (const auto* gas = std::get_if<GasSpring>(&spring.law)) make_strut(name, *gas, spring);
    }
    if (loads.drive == LoadDrive::cylinder) make_studs("cylinder", loads.cylinder.from, loads.cylinder.to);
    return std::move(parts_);
  }

 private:
  /// A spring may be called as another is by its number, or "cylinder".
  void add(const std::string& name, int body, const RoundPin& shape) {
    parts_.push_back({names_.unlike_others(name), body, shape});
  }
  [[nodiscard]] double stud_radius() const { return machine_.sizes.pin / 2; }
  [[nodiscard]] double rod_radius(const GasSpring& gas) const {
    return gas.rod_diameter > 0 ? gas.rod_diameter / machine_.linkage.millimetres() / 2 : stud_radius();
  }
  /// In position 1.
  [[nodiscard]] Vector3 place(const CarriedPoint& stud, double height) const {
    const Point at = place_of(stud, on_.bars, on_.poses.front().pose);
    return {at.real(), at.imag(), height};
  }
  [[nodiscard]] Vector3 moved(const CarriedPoint& stud) const {
    return state_.bodies[static_cast<std::size_t>(moving_body(stud.on))].apply_to_point(place(stud, plane_));
  }

  void make_studs(const std::string& name, const CarriedPoint& from, const CarriedPoint& to) {
    make_stud("stud_" + name + "_from", from);
    make_stud("stud_" + name + "_to", to);
  }
  void make_stud(const std::string& name, const CarriedPoint& stud) {
    const int body = moving_body(stud.on);
    const double low = std::get<FlatPlate>(machine_.parts[static_cast<std::size_t>(body)].shape).low;
    add(name, body, RoundPin{place(stud, low), place(stud, reach_), stud_radius()});
  }

  /// Between the studs' faces.
  void make_strut(const std::string& name, const GasSpring& gas, const Spring& of) {
    const Vector3 from = moved(of.from), to = moved(of.to);
    const double length = norm(to - from), stud = stud_radius();
    const double reach = gas.extended_length - gas.stroke - 2 * stud;  // of the tube from the middle of its stud
    if (!(reach > 2 * stud && length > reach + 1.5 * stud)) return;
    const Vector3 along = (to - from) / length, end = to - reach * along;
    add(name + "_tube", 0, RoundPin{end, to - stud * along, tube_by_rod * rod_radius(gas)});
    add(name + "_rod", 0, RoundPin{from + stud * along, end, rod_radius(gas)});
  }

  const Machine& machine_;
  const LinkageLoads& on_;
  const MovingState& state_;
  double plane_ = 0, reach_ = 0;
  std::vector<Part> parts_;
  UnlikeNames names_;
};

}  // namespace

std::vector<Part> spring_parts(const Machine& machine, const LinkageLoads& on, int position) {
  const MovingState* state = position >= 0 ? machine.linkage.at_position(position) : nullptr;
  return state ? SpringWorkshop(machine, on, *state).make() : std::vector<Part>();
}

}  // namespace linkwright
