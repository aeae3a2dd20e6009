#include "linkwright/planar/three_pose_setup.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string_view>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/chosen_length.hpp"
#include "linkwright/planar/three_pose_family.hpp"
#include "planar/degenerate_task.hpp"

namespace linkwright {
namespace {

using Dyads = std::shared_ptr<const ThreePoseDyads>;

// What both kinds of task look at before they look at numbers.
struct Start {
  Start(const PoseConditions& conditions, const Requirements& wanted)
      : frame(conditions.frame),
        dyads(std::make_shared<const ThreePoseDyads>(conditions)),
        degeneracy(shared_center(conditions)),
        requirements(with_default_lengths(wanted, conditions.frame.scale)) {
    if (!degeneracy && dyads->freedom() == DirectionFreedom::only_shifts) degeneracy = only_translations_reason();
  }

  WorkingFrame frame;
  Dyads dyads;
  std::optional<Notice> degeneracy;
  Requirements requirements;
};

bool has_dyads(const ThreePoseDyads& dyads, double length) { return !dyads.directions(length).empty(); }

// The nearest length, in ratio, that has dyads; working frame. Nothing within a factor of 10⁴.
std::optional<double> nearest_length(const ThreePoseDyads& dyads, double length) {
  const double ratio = std::pow(10.0, 0.05);
  double longer = length, shorter = length;
  for (int step = 0; step < 80; ++step) {
    for (double* const tried : {&longer, &shorter}) {
      const double before = *tried;
      *tried *= tried == &longer ? ratio : 1 / ratio;
      if (!has_dyads(dyads, *tried)) continue;
      double with = *tried, without = before;
      for (int halving = 0; halving < 40; ++halving) {
        const double middle = std::sqrt(with * without);
        (has_dyads(dyads, middle) ? with : without) = middle;
      }
      return with;
    }
  }
  return std::nullopt;
}

// A length in the user's unit that has no dyad. `side`: input or output.
std::optional<Notice> no_side_link(const Start& start, double length, std::string_view side) {
  if (has_dyads(*start.dyads, length / start.frame.scale)) return std::nullopt;
  Notice notice{"no_side_link_of_length",
                fmt::format("No {} link of length {:.6g} satisfies the poses, in any direction.", side, length),
                {{"side", std::string(side)}, {"length", length}}};
  if (const auto nearest = nearest_length(*start.dyads, length / start.frame.scale)) {
    const double value = *nearest * start.frame.scale;
    notice.message += fmt::format(" The nearest length that does is {:.6g}.", value);
    notice.values.push_back({"nearest", value});
  } else {
    notice.message += " No other length does; move a pose.";
  }
  return notice;
}

Notice chosen_notice(std::string_view side, const ChosenLength& chosen) {
  const auto [shortest, longest] = chosen.within;
  const std::string tried = fmt::format(
      "The length of the {} link was left open. Of {} lengths tried from {:.6g} to "
      "{:.6g}, ",
      side, chosen.tried, shortest, longest);
  const Values values = {{"side", std::string(side)},
                         {"length", chosen.length},
                         {"tried", static_cast<double>(chosen.tried)},
                         {"shortest", shortest},
                         {"longest", longest}};
  if (chosen.meeting > 0)
    return {"chosen_length",
            tried + fmt::format("{:.6g} gives the best linkage; give a length to get another solution region.",
                                chosen.length),
            values};
  return {"no_length_meets",
          tried + fmt::format("none has a linkage that meets the requirements. The solution region is that of {:.6g}, "
                              "with most linkages that fail one requirement only, and so is the advice.",
                              chosen.length),
          values};
}

Notice fixed_direction_notice(const ThreePoseDyads& dyads) {
  return {
      "fixed_direction",
      fmt::format("From the first pose to another the motion is a pure translation: that fixes {} of a grounded link, "
                  "and its fixed pivot may lie anywhere on a circle. The axes of the solution region run round "
                  "these circles.",
                  dyads.length_of(0) || dyads.length_of(pi / 2) || dyads.length_of(pi) || dyads.length_of(-pi / 2)
                      ? "the direction that goes with a length"
                      : "the direction"),
      {}};
}

ThreePoseSetup opened(const Start& start, std::shared_ptr<const FourBarFamily> family) {
  ThreePoseSetup setup;
  setup.family = std::move(family);
  if (start.dyads->freedom() == DirectionFreedom::of_length)
    setup.notices.push_back(fixed_direction_notice(*start.dyads));
  return setup;
}

ThreePoseSetup closed(std::optional<Notice> reason) { return {nullptr, {}, std::move(reason)}; }

// Some direction that the input can have goes with an output at the angle.
bool has_output(const ThreePoseDyads& dyads, const SideAngle& given, double input_length) {
  if (dyads.freedom() == DirectionFreedom::free) return true;
  for (const DirectionArc arc : dyads.directions(input_length)) {
    if (dyads.length_of(arc.from + given.angle)) return true;
    if (!given.directed && dyads.length_of(arc.from + given.angle + pi)) return true;
  }
  return false;
}

Notice no_side_link_at_angle(double input_length) {
  return {
      "no_side_link_at_angle",
      fmt::format("From the first pose to another the motion is a pure translation, which fixes the direction of an "
                  "input link of length {:.6g}, and no output link at the given angle from it satisfies the "
                  "poses. Change the angle or the length, or rotate a pose.",
                  input_length),
      {{"length", input_length}}};
}

}  // namespace

ThreePoseSetup three_pose_setup(const PoseConditions& conditions, const std::vector<PrescribedPose>& poses,
                                const SideLengths& given, const Requirements& requirements, Objective objective) {
  const Start start(conditions, requirements);
  if (start.degeneracy) return closed(start.degeneracy);
  if (auto reason = no_side_link(start, given.input, "input")) return closed(std::move(reason));
  const auto family_of = [&](double output) {
    return std::make_unique<const SideLengthsFamily>(start.frame, poses, start.dyads, given.input, output);
  };
  if (given.output) {
    if (auto reason = no_side_link(start, *given.output, "output")) return closed(std::move(reason));
    return opened(start, family_of(*given.output));
  }
  const ChosenLength output = chosen_length(family_of, start.frame, start.requirements, objective, given.input);
  ThreePoseSetup setup = opened(start, family_of(output.length));
  setup.notices.push_back(chosen_notice("output", output));
  return setup;
}

ThreePoseSetup three_pose_setup(const PoseConditions& conditions, const std::vector<PrescribedPose>& poses,
                                const SideAngle& given, const Requirements& requirements, Objective objective) {
  const Start start(conditions, requirements);
  if (start.degeneracy) return closed(start.degeneracy);
  const auto family_of = [&](double input) {
    return std::make_unique<const SideAngleFamily>(start.frame, poses, start.dyads, given.angle, given.directed, input);
  };
  std::optional<ChosenLength> chosen;
  if (!given.input_length) chosen = chosen_length(family_of, start.frame, start.requirements, objective);
  const double input = chosen ? chosen->length : *given.input_length;
  if (auto reason = no_side_link(start, input, "input")) return closed(std::move(reason));
  if (!has_output(*start.dyads, given, input / start.frame.scale)) return closed(no_side_link_at_angle(input));
  ThreePoseSetup setup = opened(start, family_of(input));
  if (chosen) setup.notices.push_back(chosen_notice("input", *chosen));
  return setup;
}

}  // namespace linkwright
