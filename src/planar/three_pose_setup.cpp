#include "three_pose_setup.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string_view>

#include "chosen_length.hpp"
#include "given_pivot_family.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "planar/degenerate_task.hpp"
#include "three_pose_family.hpp"

namespace linkwright {
namespace {

using Dyads = std::shared_ptr<const ThreePoseDyads>;

// What both kinds of task look at before they look at numbers.
struct Start {
  explicit Start(const PoseConditions& conditions, const Requirements& wanted = {})
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
                                const SideLengths& given, const Requirements& requirements, Objective objective,
                                const Progress& progress) {
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
  const ChosenLength output =
      chosen_length(family_of, start.frame, start.requirements, objective,
                    lengths_in_windows(*start.dyads, start.frame, requirements), given.input, progress);
  ThreePoseSetup setup = opened(start, family_of(output.length));
  setup.notices.push_back(chosen_notice("output", output));
  setup.chose_length = true;
  return setup;
}

ThreePoseSetup three_pose_setup(const PoseConditions& conditions, const std::vector<PrescribedPose>& poses,
                                const SideAngle& given, const Requirements& requirements, Objective objective,
                                const Progress& progress) {
  const Start start(conditions, requirements);
  if (start.degeneracy) return closed(start.degeneracy);
  const auto family_of = [&](double input) {
    return std::make_unique<const SideAngleFamily>(start.frame, poses, start.dyads, given.angle, given.directed, input);
  };
  std::optional<ChosenLength> chosen;
  if (!given.input_length)
    chosen = chosen_length(family_of, start.frame, start.requirements, objective,
                           lengths_in_windows(*start.dyads, start.frame, requirements), 0, progress);
  const double input = chosen ? chosen->length : *given.input_length;
  if (auto reason = no_side_link(start, input, "input")) return closed(std::move(reason));
  if (!has_output(*start.dyads, given, input / start.frame.scale)) return closed(no_side_link_at_angle(input));
  ThreePoseSetup setup = opened(start, family_of(input));
  if (chosen) setup.notices.push_back(chosen_notice("input", *chosen));
  setup.chose_length = chosen.has_value();
  return setup;
}

namespace {

PivotKind partner_of(PivotKind kind) { return kind == PivotKind::ground ? PivotKind::moving : PivotKind::ground; }

Notice about_pivot(std::string_view code, Side side, const GivenPivot& pivot, std::string message) {
  return {std::string(code),
          std::move(message),
          {{"side", std::string(name(side))},
           {"pivot", std::string(name(pivot.kind))},
           {"x", pivot.point.real()},
           {"y", pivot.point.imag()}}};
}

// A rotation about the given pivot takes the body from one position to another: that condition holds for any partner.
Notice pivot_at_pole(Side side, const GivenPivot& pivot) {
  return about_pivot(
      "pivot_at_pole", side, pivot,
      fmt::format("The given {} pivot of the {} link, ({:.6g}, {:.6g}), is a pole of two of the "
                  "positions{}: any point of a line is a {} pivot to it, and no single linkage is "
                  "left. Move the pivot.",
                  name(pivot.kind), name(side), pivot.point.real(), pivot.point.imag(),
                  pivot.kind == PivotKind::moving ? ", seen from the body" : "", name(partner_of(pivot.kind))));
}

Notice pivot_of_slider(Side side, const GivenPivot& pivot) {
  return about_pivot(
      "pivot_of_slider", side, pivot,
      fmt::format("The {} pivot that belongs to the given {} pivot of the {} link, ({:.6g}, {:.6g}), is "
                  "at infinity: instead of a link with two pivots it takes a {}. Move the pivot.",
                  name(partner_of(pivot.kind)), name(pivot.kind), name(side), pivot.point.real(), pivot.point.imag(),
                  pivot.kind == PivotKind::moving ? "straight guide, on which it slides"
                                                  : "guide of the body, which slides through it"));
}

// The link with a given pivot, or why there is none.
struct FoundLink {
  Dyad dyad;
  std::optional<Notice> missing;
};

FoundLink link_with(const Start& start, Side side, const GivenPivot& pivot) {
  const auto found = start.dyads->dyad_with(pivot.kind, Homogeneous::of(start.frame.to_working(pivot.point)));
  if (!found) return {{}, pivot_at_pole(side, pivot)};
  if (is_at_infinity(found->center) || is_at_infinity(found->circle)) return {{}, pivot_of_slider(side, pivot)};
  return {*found, std::nullopt};
}

bool are_one_link(const Dyad& a, const Dyad& b) {
  const auto near = [](Homogeneous p, Homogeneous q) {
    return std::abs(*finite_point(p) - *finite_point(q)) < tolerance::change_point;
  };
  return near(a.center, b.center) && near(a.circle, b.circle);
}

Notice pivots_of_one_link() {
  return {"pivots_of_one_link",
          "Both given pivots belong to one and the same link: it has its other pivot just there. Move one of them.",
          {}};
}

Notice lines_notice(std::string_view code, std::string_view message) {
  return {std::string(code), std::string(message), {}};
}

ThreePoseSetup setup_between(const Start& start, const std::vector<PrescribedPose>& poses, const PivotLines& given) {
  const auto working = [&](const DirectedLine& line) {
    return DirectedLine{start.frame.to_working(line.point), line.direction};
  };
  const auto dyads = start.dyads->dyads_on_lines(working(*given.ground), working(*given.moving));
  if (!dyads)
    return closed(lines_notice(
        "lines_of_dyads", "Infinitely many dyads have their pivots on these two lines. Turn or move one of them."));
  if (dyads->empty())
    return closed(lines_notice("no_dyad_on_lines",
                               "No dyad of these positions has its ground pivot on one of the lines and its moving "
                               "pivot on the other. Move a line, or give one of them only."));
  if (dyads->size() == 1)
    return closed(lines_notice("one_dyad_on_lines",
                               "Only one dyad has its ground pivot on one of the lines and its moving pivot on the "
                               "other, and a four-bar needs two. Move a line, or give one of them only."));
  return {std::make_shared<const PointFamily>(start.frame, poses, *dyads), {}, {}};
}

}  // namespace

ThreePoseSetup three_pose_setup(const PoseConditions& conditions, const std::vector<PrescribedPose>& poses,
                                const GivenPivots& given) {
  const Start start(conditions);
  if (start.degeneracy) return closed(start.degeneracy);
  if (!given.input || !given.output) {
    const Side side = given.input ? Side::input : Side::output;
    const GivenPivot& pivot = given.input ? *given.input : *given.output;
    FoundLink link = link_with(start, side, pivot);
    if (link.missing) return closed(std::move(link.missing));
    return {
        std::make_shared<const PivotPlaceFamily>(start.frame, poses, start.dyads, side, link.dyad, pivot.kind), {}, {}};
  }
  FoundLink input = link_with(start, Side::input, *given.input), output = link_with(start, Side::output, *given.output);
  for (FoundLink* link : {&input, &output})
    if (link->missing) return closed(std::move(link->missing));
  if (are_one_link(input.dyad, output.dyad)) return closed(pivots_of_one_link());
  return {std::make_shared<const GivenPivotsFamily>(start.frame, poses, DyadPair{input.dyad, output.dyad}), {}, {}};
}

ThreePoseSetup three_pose_setup(const PoseConditions& conditions, const std::vector<PrescribedPose>& poses,
                                const PivotLines& given) {
  const Start start(conditions);
  if (start.degeneracy) return closed(start.degeneracy);
  if (given.ground && given.moving) return setup_between(start, poses, given);
  const PivotKind kind = given.ground ? PivotKind::ground : PivotKind::moving;
  return {std::make_shared<const PivotsOnLineFamily>(start.frame, poses, start.dyads, kind,
                                                     given.ground ? *given.ground : *given.moving),
          {},
          {}};
}

}  // namespace linkwright
