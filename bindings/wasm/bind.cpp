#include <emscripten/bind.h>

#include "reply_fields.hpp"
#include "session.hpp"

// The session as a JavaScript class. Arrays are views into the engine's memory: to be copied before the next call.
namespace linkwright::wasm {
namespace {

using emscripten::typed_memory_view;
using emscripten::val;

template <class Values>
val view(const Values& values) {
  return val(typed_memory_view(values.size(), values.data()));
}

val curves_of(const LinkPolygon& links) {
  val curves = val::object();
  curves.set("tau", view(links.coordinate));
  curves.set("center", view(links.fixed));
  curves.set("circle", view(links.moving));
  curves.set("branch", view(links.branch));
  return curves;
}

val map_of(const ColouredMap& shown, const std::string& census) {
  val map = val::object();
  map.set("census", census);
  map.set("input_tau", view(shown.region.input_coordinates()));
  map.set("output_tau", view(shown.region.output_coordinates()));
  map.set("type", view(shown.region.types()));
  map.set("defects", view(shown.region.defects()));
  map.set("fails", view(shown.fails));
  map.set("value", view(shown.values));
  const auto& [input, output] = shown.ridges;
  map.set("ridge_input", view(input.value));
  map.set("ridge_input_partner", view(input.partner));
  map.set("ridge_output", view(output.value));
  map.set("ridge_output_partner", view(output.partner));
  return map;
}

/// Keeps what its views show until it is asked again.
class BoundSession : public PageSession {
 public:
  val linkage_reply(double input_tau, double output_tau) {
    linkage_ = linkage({input_tau, output_tau});
    val result = val::object();
    result.set("linkage", linkage_.linkage);
    result.set("states", view(linkage_.states));
    result.set("tolerance", linkage_.tolerance);
    return result;
  }
  val live_reply(double input_tau, double output_tau) {
    live_ = live({input_tau, output_tau});
    val result = val::object();
    result.set("input", view(live_.input));
    result.set("output", view(live_.output));
    return result;
  }
  val tolerance_reply(double input_tau, double output_tau, int bins, int drawn) {
    tolerance_ = tolerance({input_tau, output_tau}, bins, drawn);
    val result = val::object();
    result.set("report", tolerance_.report);
    result.set("drawn", view(tolerance_.drawn));
    return result;
  }
  val halo_reply(int part, bool turn, double reach, int steps, int samples) {
    counts_ = halo({part, turn, reach, steps, samples});
    return view(counts_);
  }
  val trace_reply(double input_tau, double output_tau, double x, double y) {
    path_ = trace({input_tau, output_tau}, {x, y});
    return val(typed_memory_view(2 * path_.size(), reinterpret_cast<const double*>(path_.data())));
  }
  val explore_reply(int samples, double input_from, double input_to, double output_from, double output_to,
                    const std::string& property, int order) {
    const ExploreReply reply = explore({samples, {input_from, input_to}, {output_from, output_to}, property, order});
    val result = val::object();
    result.set("task", reply.task);
    result.set("curves", curves_of(*reply.input_curves));
    result.set("output_curves", reply.output_curves ? curves_of(*reply.output_curves) : val::null());
    result.set("map", reply.map ? map_of(*reply.map, reply.census) : val::null());
    return result;
  }
  val machine_reply(double input_tau, double output_tau, const WantedSizes& sizes) {
    machine_ = machine({input_tau, output_tau}, sizes);
    val result = val::object();
    result.set("plan", machine_.plan);
    result.set("vertices", view(machine_.vertices));
    result.set("triangles", view(machine_.triangles));
    result.set("travel", view(machine_.travel));
    return result;
  }
  val machine_file_reply(double input_tau, double output_tau, const std::string& format, const WantedSizes& sizes) {
    auto file = machine_file({input_tau, output_tau}, format, sizes);
    file_.assign(file ? std::move(*file) : "");
    val result = val::object();
    result.set("mistakes", mistakes_json(file ? std::vector<Error>{} : file.errors()));
    result.set("bytes", val(typed_memory_view(file_.size(), reinterpret_cast<const std::uint8_t*>(file_.data()))));
    return result;
  }
  bool set_problem_text(const std::string& text) { return set_problem(text); }
  std::string read_text(const std::string& text) { return read(text); }
  std::string mistakes_text() { return mistakes(); }
  std::string notices_text() { return notices(); }
  std::string loads_text(double input_tau, double output_tau) { return loads({input_tau, output_tau}); }
  std::string place_spring_text(double input_tau, double output_tau, const std::string& boxes, unsigned most_boxes) {
    return place_spring({input_tau, output_tau}, boxes, most_boxes);
  }
  std::string stud_map_text(double input_tau, double output_tau, const std::string& boxes, const std::string& stud,
                            int columns, int rows) {
    return stud_map({input_tau, output_tau}, boxes, stud == "body" ? Stud::body : Stud::ground, columns, rows);
  }
  std::string sample_yields_text(int cells) { return sample_yields(cells); }
  std::string front_text(const std::string& first, const std::string& second) { return front(first, second); }
  std::string best_text(int most) { return best(most); }
  std::string improve_text(double input_tau, double output_tau) { return improve({input_tau, output_tau}); }
  std::string verify_text(double input_tau, double output_tau) { return verify({input_tau, output_tau}); }
  std::string exported_text(double input_tau, double output_tau, const std::string& format) {
    return exported({input_tau, output_tau}, format);
  }

 private:
  LinkageReply linkage_;
  LiveLinks live_;
  ToleranceReply tolerance_;
  std::vector<std::uint32_t> counts_;
  std::vector<Point> path_;
  MachineReply machine_;
  std::string file_;
};

std::string report(const std::string& of, const std::string& text) {
  if (of == "instant") return instant_reply(text);
  return of == "outlines" ? outlines_reply(text) : attitude_reply(of, text);
}
std::string search_fits(const std::string& text, const val& tell) {
  return fit_search_reply(text, {[&](double done) { tell(done); }});
}
std::string version() { return LINKWRIGHT_VERSION; }

EMSCRIPTEN_BINDINGS(linkwright) {
  emscripten::function("version", &version);
  emscripten::function("report", &report);
  emscripten::function("search_fits", &search_fits);
  emscripten::value_object<WantedSizes>("WantedSizes")
      .field("width", &WantedSizes::width)
      .field("thickness", &WantedSizes::thickness)
      .field("gap", &WantedSizes::gap)
      .field("pin", &WantedSizes::pin)
      .field("radius", &WantedSizes::radius)
      .field("clearance", &WantedSizes::clearance);
  emscripten::class_<BoundSession>("Session")
      .constructor<>()
      .function("set_problem", &BoundSession::set_problem_text)
      .function("mistakes", &BoundSession::mistakes_text)
      .function("read", &BoundSession::read_text)
      .function("notices", &BoundSession::notices_text)
      .function("explore", &BoundSession::explore_reply)
      .function("linkage", &BoundSession::linkage_reply)
      .function("live", &BoundSession::live_reply)
      .function("tolerance", &BoundSession::tolerance_reply)
      .function("loads", &BoundSession::loads_text)
      .function("place_spring", &BoundSession::place_spring_text)
      .function("stud_map", &BoundSession::stud_map_text)
      .function("sample_yields", &BoundSession::sample_yields_text)
      .function("front", &BoundSession::front_text)
      .function("halo", &BoundSession::halo_reply)
      .function("best", &BoundSession::best_text)
      .function("improve", &BoundSession::improve_text)
      .function("verify", &BoundSession::verify_text)
      .function("trace", &BoundSession::trace_reply)
      .function("exported", &BoundSession::exported_text)
      .function("machine", &BoundSession::machine_reply)
      .function("machine_file", &BoundSession::machine_file_reply);
}

}  // namespace
}  // namespace linkwright::wasm
