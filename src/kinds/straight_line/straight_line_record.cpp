#include "straight_line_record.hpp"

#include <cmath>

#include "files/fields/result_forms.hpp"
#include "files/instant_fields.hpp"
#include "files/linkage_fields.hpp"
#include "files/problem_fields.hpp"
#include "straight_line_kind.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, const UsableLine& usable) {
  const Object described = {"usable_line", "A straight stretch by the way s along the line, 0 where the linkage lies."};
  const Names<PathEnd> ends = {{PathEnd::deviation, PathEnd::turn, PathEnd::travel, PathEnd::unfinished}};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("length", usable.length(), forms::not_negative);
    to.shown("from_s", usable.from, Number{.most = 0});
    to.shown("to_s", usable.to, forms::not_negative);
    to.shown(Field("ends", "Why it ends: farther off the line, or the point turns back."),
             std::array{usable.begin, usable.end}, List{.what = "", .least = 2, .most = 2}, ends);
  });
}

static void fields(FieldVisitor& v, const StrokeReport& stroke) {
  const auto& drive = stroke.drive;
  v.object({.name = "stroke", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("s_from", stroke.from);
    to.shown("s_to", stroke.to);
    to.shown(Field("max_deviation", "Off the line itself."), stroke.max_deviation, forms::not_negative);
    to.shown(Field("parallel_line_deviation", "Off the best line parallel to it."), stroke.parallel_line_deviation,
             forms::not_negative);
    to.shown(Field("best_line_deviation", "Off the best line of any direction."), stroke.best_line_deviation,
             forms::not_negative);
    to.shown("min_transmission_angle_deg", degrees(stroke.min_transmission_angle), forms::angle_deg);
    to.shown(Field("velocity_nonuniformity", "(max − min) / mean; null where the input turns back."),
             drive ? std::optional(drive->nonuniformity(stroke.to - stroke.from)) : std::nullopt, forms::not_negative);
    to.shown("crank_range_deg", drive ? std::optional(degrees(std::abs(drive->sweep))) : std::nullopt,
             forms::not_negative);
  });
}

static void fields(FieldVisitor& v, const LineShape& shape) {
  std::vector<double> numbers(shape.numbers.begin(),
                              shape.numbers.begin() + static_cast<std::ptrdiff_t>(number_count(shape.kind)));
  v.object({.name = "line_shape"}, [&](FieldVisitor& to) {
    to.shown(Field("turns", "Bits: the other side of the line, the other sense of it, the other side of the dyad."),
             shape.turns, Whole{0, 7});
    to.shown("numbers", numbers, List{.what = "", .least = 1, .most = 4}, forms::share);
  });
}

namespace {

void lengths_field(FieldVisitor& v, const TracingFourBar& linkage) {
  const LinkLengths lengths = linkage.bars.lengths();
  constexpr Number bar = {.least = 0, .above = true};
  v.member("lengths", true, [&](FieldVisitor& at) {
    at.object({.name = "tracing_lengths"}, [&](FieldVisitor& to) {
      to.shown("ground", lengths.ground, bar);
      to.shown("input", lengths.input, bar);
      to.shown("coupler", lengths.coupler, bar);
      to.shown("output", lengths.output, bar);
      to.shown("point_to_input", std::abs(linkage.point - linkage.bars.input_moving), bar);
      to.shown("point_to_output", std::abs(linkage.point - linkage.bars.output_moving), bar);
    });
  });
}

void built_fields(FieldVisitor& v, const TracingFourBar& linkage, LinkageType type) {
  v.shown("pivots", linkage);
  lengths_field(v, linkage);
  v.shown("type", type, forms::linkage_types);
}

}  // namespace

static void fields(FieldVisitor& v, const StraightLineCognate& other) {
  v.object({.name = "straight_line_cognate", .on_lines = true}, [&](FieldVisitor& to) {
    built_fields(to, other.linkage, other.type);
    to.shown(Field("min_transmission_angle_deg", "Over the usable length that counts, its own input driving."),
             degrees(other.over_usable.min_transmission_angle), forms::angle_deg);
    to.shown("over_usable", other.over_usable);
  });
}

namespace {

// The first three terms of the deviation from where the point is, the first that does not vanish among them.
void deviation_series_field(FieldVisitor& v, const LineContact& contact) {
  constexpr int terms = 3;
  std::vector<std::string> powers;
  std::vector<double> coefficients;
  for (int k = std::max(contact.points, 1); k < contact.points + terms && k <= static_cast<int>(motion_order); ++k) {
    powers.push_back(std::to_string(k));
    coefficients.push_back(contact.deviation[static_cast<std::size_t>(k)]);
  }
  const Field field("deviation_series",
                    "Coefficients of e(s) by the power of s, the first that does not vanish and those after it; e to "
                    "the left of the line.");
  v.member(field, true, [&](FieldVisitor& at) {
    at.keyed({"^[0-9]+$"}, powers, [&](FieldVisitor& to, std::size_t i) {
      double coefficient = i < coefficients.size() ? coefficients[i] : 0;
      visit(to, coefficient);
    });
  });
}

/// Of a search: whose map it is a place of.
void search_fields(FieldVisitor& v, const StraightLineRecord& of) {
  StraightLineTask task = of.found.task;
  v.member(Field("task", "Of a search: the task of whose map it is a place.").written(of.is_of_search), false,
           [&](FieldVisitor& at) {
             at.described_in("problem.schema.json#/$defs/straight_line_task",
                             [&](FieldVisitor& to) { fields(to, task); });
           });
  v.shown_if_any(Field("shape", "Of a search: what it is of the shapes of its case that are drawn."),
                 of.is_of_search ? of.found.shape : std::nullopt);
}

void place_fields(FieldVisitor& v, const StraightLineRecord& of) {
  v.shown("case", std::string(name(of.found.task.given)));
  v.shown("layer", of.found.place.layer, Whole{0, 2});
  v.shown_if_any("layer_name", forms::where(!of.layer_name.empty(), of.layer_name));
  v.shown(Field("place",
                "On the map of its case, by the numbers of its axes: the layer and [u, v] find it again (options.at)."),
          of.found.place.at, forms::two_numbers);
  search_fields(v, of);
}

void contact_fields(FieldVisitor& v, const StraightLineRecord& of) {
  const StraightLineSolution& found = of.found;
  const bool at_places = std::holds_alternative<straight_cases::MixedContacts>(found.task.given);
  v.shown_if_any(Field("defects", "Of contacts at places."), forms::where(at_places, found.defects));
  v.shown(Field("contact_points", "Of path and line where the linkage lies, as its path has them."),
          found.contact.points, Whole{1, forms::count.most});
  deviation_series_field(v, found.contact);
  v.shown("instant", of.instant);
  v.shown(Field("deviation", "Half the width of the strip by which it is measured."), found.deviation,
          Number{.least = 0, .above = true});
}

void usable_fields(FieldVisitor& v, const StraightLineSolution& found, LineMeasure measure) {
  v.shown("usable", found.usable);
  v.shown("usable_strip", found.usable_strip);
  v.shown(Field("stroke_over_longest", "Of the usable length that counts, over the longest link or arm."),
          found.counted(measure).length() / found.linkage.longest(), forms::not_negative);
  v.shown(Field("min_transmission_angle_deg",
                "Over the stroke where one is asked for and reached, otherwise over the usable length that counts."),
          degrees(found.judged().min_transmission_angle), forms::angle_deg);
  v.shown("over_usable", found.over_usable);
  v.shown(Field("stroke",
                "Over the stroke that is asked for or that of the case; null where there is none or the path does not "
                "reach so far."),
          found.stroke);
  v.shown(Field("cognates", "The others whose point traces the same curve (Roberts); none where it is a circle."),
          found.cognates, List{.what = "", .most = 2, .on_lines = true});
}

}  // namespace

void fields(FieldVisitor& v, const StraightLineRecord& of) {
  const StraightLineSolution& found = of.found;
  const Object described = {"straight_line_four_bar",
                            "A four-bar whose point runs straight, as it lies with its point on the line.", true};
  v.object(described, [&](FieldVisitor& to) {
    to.constant("mechanism", "four_bar");
    place_fields(to, of);
    built_fields(to, found.linkage, found.type);
    contact_fields(to, of);
    usable_fields(to, found, of.measure);
    to.shown(Field("residual", "Distance of the point from the line."), found.residual, forms::not_negative);
    to.shown("local_optimum", found.local_optimum);
    to.shown(Field("verified_by_driving",
                   "Assembled anew at places of its stroke it is where its path has it; driven, it passes the contacts "
                   "at places."),
             found.verified_by_driving);
    of.listed.visit(to);
  });
}

}  // namespace linkwright
