#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/region/criterion.hpp"
#include "loads_analysis.hpp"

namespace linkwright {
namespace {

/// What asks for a read-out.
struct Asked {
  std::string place;
  ReadOut read_out;
};

std::vector<Asked> asked_read_outs(const Requirements& wanted, const SynthesisOptions& options) {
  std::vector<Asked> asked;
  const auto add = [&](std::string place, const Measure& measure) {
    if (const auto read_out = read_out_of(measure)) asked.push_back({std::move(place), *read_out});
  };
  for (const Criterion& each : criteria())
    if (each.of && each.has_limit(wanted) && each.range.contains(each.limit(wanted)))
      add(fmt::format("requirements.{}", each.key), *each.of);
  add("options.objective", measure_of(options.objective));
  if (options.pareto)
    for (const Objective objective : *options.pareto) add("options.pareto", measure_of(objective));
  return asked;
}

std::optional<Error> mistake_in(const Asked& asked, const std::optional<Loads>& loads) {
  if (!loads) return Error{"no_loads", asked.place, "give the \"loads\" that act on the linkages"};
  if (!is_counted(asked.read_out, *loads))
    return Error{"no_case_counts",
                 asked.place,
                 fmt::format("no case counts for \"{0}\"; name it in \"for\" of one, or leave \"for\" out",
                             name(asked.read_out)),
                 {{"name", name(asked.read_out)}}};
  if (has_value(asked.read_out, *loads)) return std::nullopt;
  if (asked.read_out == ReadOut::max_torque)
    return Error{"no_driving_crank", asked.place,
                 "a torque is that of a driving crank: \"drive\": \"input\" or \"output\" in the loads"};
  return Error{"no_hand", asked.place, "a force of the hand needs \"handle\": {\"point\": [x, y]} in the loads"};
}

/// Where a stud between ground and body is in a pose, fixed frame.
std::optional<Point> known_place(const CarriedPoint& stud, const Pose& pose) {
  if (stud.on == LoadedBody::ground) return stud.at;
  if (stud.on == LoadedBody::body) return pose.origin + direction(pose.angle) * stud.at;
  return std::nullopt;  // by linkage
}

const std::vector<PrescribedPose>* poses_of_task(const Task& task) {
  const auto* motion = std::get_if<MotionTask>(&task);
  return motion ? &motion->poses : nullptr;
}

/// A spring between ground and body has the same length in a position in all linkages.
void check_length(const Loads& loads, std::size_t k, const std::vector<PrescribedPose>& poses,
                  std::vector<Error>& found) {
  if (poses.empty()) return;
  const Spring& spring = loads.springs[k];
  const std::string place = fmt::format("loads.springs[{}]", k);
  const std::string name = spring_name(loads, k);
  const auto* gas = std::get_if<GasSpring>(&spring.law);
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  int at_shortest = 0, at_longest = 0;
  for (std::size_t j = 0; j < poses.size(); ++j) {
    const auto from = known_place(spring.from, poses[j].pose), to = known_place(spring.to, poses[j].pose);
    if (!from || !to) return;
    const double length = std::abs(*to - *from);
    if (length < shortest) shortest = length, at_shortest = static_cast<int>(j) + 1;
    if (length > longest) longest = length, at_longest = static_cast<int>(j) + 1;
  }
  constexpr double coincident = 1e-9;
  if (shortest <= coincident * longest || longest == 0) {
    found.push_back({"studs_meet",
                     place,
                     fmt::format("{}: the studs meet in position {}, where it has no direction; move one of them", name,
                                 at_shortest),
                     {{"name", name}, {"position", at_shortest}}});
  } else if (gas && longest > gas->extended_length) {
    found.push_back(
        {"spring_too_short",
         place + ".extended_length",
         fmt::format("{}: {} too short in position {}: extended_length at least {}", name,
                     exact_text(longest - gas->extended_length), at_longest, exact_text(longest)),
         {{"name", name}, {"by", longest - gas->extended_length}, {"position", at_longest}, {"least", longest}}});
  } else if (gas && shortest < gas->extended_length - gas->stroke) {
    const double needed = gas->extended_length - shortest;
    found.push_back({"spring_stroke_short",
                     place + ".stroke",
                     fmt::format("{}: {} too long in position {}: stroke at least {}", name,
                                 exact_text(needed - gas->stroke), at_shortest, exact_text(needed)),
                     {{"name", name}, {"by", needed - gas->stroke}, {"position", at_shortest}, {"least", needed}}});
  }
}

}  // namespace

bool carries_loads(const Task& task) {
  return std::holds_alternative<MotionTask>(task) || std::holds_alternative<PathTask>(task);
}

std::vector<Error> mistakes_about_loads(const Task& task, const Requirements& wanted, const SynthesisOptions& options) {
  std::vector<Error> found;
  if (!carries_loads(task)) {
    // Forces that are asked for are told by their LinkageClass, which has none.
    if (options.loads)
      found.push_back({"loads_of_task", "loads",
                       "loads are for planar four-bars that guide a body or trace a path so far; leave them out here"});
    return found;
  }
  for (const Asked& asked : asked_read_outs(wanted, options))
    if (auto mistake = mistake_in(asked, options.loads)) found.push_back(*std::move(mistake));
  if (!options.loads) return found;
  if (const auto* poses = poses_of_task(task); poses && mistakes_in(*options.loads).empty())
    for (std::size_t k = 0; k < options.loads->springs.size(); ++k)
      if (!std::holds_alternative<TorsionSpring>(options.loads->springs[k].law))
        check_length(*options.loads, k, *poses, found);
  return found;
}

}  // namespace linkwright
