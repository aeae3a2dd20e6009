#include "support/robust_cases.hpp"

#include <fstream>

#include "linkwright/mechanism/position.hpp"

namespace linkwright::testing {

nlohmann::json robust_file(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/robust/" + name + ".json"));
}

std::vector<TracingFourBar> robust_positions(const nlohmann::json& par, const nlohmann::json& phis, double sign) {
  const auto at = [&](const char* key) { return par.at(key).get<double>(); };
  const Point input_fixed{at("A0x"), at("A0y")}, output_fixed{at("B0x"), at("B0y")};
  const LinkLengths lengths{std::abs(output_fixed - input_fixed), at("a"), at("h"), at("b")};
  const FourBar frame{input_fixed, input_fixed + lengths.input, output_fixed, output_fixed + lengths.output};
  const double ground = std::arg(output_fixed - input_fixed);
  std::vector<TracingFourBar> positions;
  for (const double phi : phis) {
    const auto configuration = assemble(lengths, phi - ground, sign > 0 ? Assembly::positive : Assembly::negative);
    FourBar bars = placed(frame, configuration.value());
    bars.input_moving = input_fixed + lengths.input * direction(phi);
    const Point along = direction(configuration->coupler_angle + ground);
    bars.output_moving = bars.input_moving + lengths.coupler * along;
    positions.push_back({bars, bars.input_moving + Point{at("cx"), at("cy")} * along});
  }
  return positions;
}

}  // namespace linkwright::testing
