#include "linkwright/analyses/spring_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "analyses/listed_place.hpp"
#include "files/document_fields.hpp"
#include "files/fields/field_reader.hpp"
#include "files/fields/field_writer.hpp"
#include "files/fields/forms.hpp"
#include "files/fields/result_forms.hpp"
#include "files/file_header.hpp"
#include "files/json/json.hpp"
#include "files/json/json_document.hpp"
#include "files/json/json_object.hpp"
#include "files/listed_problem.hpp"
#include "files/result_fields.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/problem_file.hpp"
#include "loads_analysis.hpp"
#include "spring_schema.hpp"
#include "synthesis/listed_linkages.hpp"

namespace linkwright {
namespace {

constexpr Number amount = {.least = 0, .most = largest_coordinate};
constexpr std::size_t most_parts = 1000, most_forces = 100;

void box_field(FieldVisitor& v, const char* key, StudBox& box) {
  constexpr Pair side = {.form = {"low_high", "[low, high]"}, .each = forms::coordinate};
  v.member(Field(key).missing({"stud_box", "the room of a stud: {\"x\": [low, high], \"y\": [low, high]}"}), true,
           [&](FieldVisitor& at) {
             at.object(
                 {.name = "stud_box", .about = "A box of no size is a stud that is given."}, [&](FieldVisitor& to) {
                   std::array<double, 2> x = {box.low.real(), box.high.real()}, y = {box.low.imag(), box.high.imag()};
                   to.required("x", x, side);
                   to.required("y", y, side);
                   box = {{x[0], y[0]}, {x[1], y[1]}};
                 });
           });
}

void wanted_spring(FieldVisitor& v, SpringWanted& wanted) {
  v.optional(Field("name", "Of the spring; one of the loads that has it gives way."), wanted.name);
  v.optional(Field("count", "Side by side."), wanted.count, Whole{1, 1000});
  v.required(Field("F2_over_F1", "Of the forces without friction."), wanted.f2_over_f1, amount);
  v.optional(Field("friction", "Half of the difference of compressing and extending, N."), wanted.friction, amount);
  v.given(Field("measured_at", "From both ends."), wanted.measured_at, amount);
}

void boxes(FieldVisitor& v, SpringWanted& wanted) {
  SpringDemands& demands = wanted.demands;
  const std::array gas = {Case{"gas", {}, [&](FieldVisitor& to) { wanted_spring(to, wanted); }}};
  v.object({}, [&](FieldVisitor& to) {
    version_field(to);
    to.member(
        Field("spring").missing({"wanted_spring", "the spring: {\"kind\": \"gas\", \"F2_over_F1\": 1.33, …}"}), true,
        [&](FieldVisitor& at) {
          at.object({}, [&](FieldVisitor& in) { in.switch_on(Field("kind").missing({"wanted_kind", "gas"}), 0, gas); });
        });
    box_field(to, "ground", wanted.ground);
    box_field(to, "body", wanted.body);
    to.given(Field("max_F1", "N: without it the search runs into short springs of any force."), demands.max_f1,
             forms::positive);
    to.given("min_hold_open", demands.min_hold_open);
    to.given("max_open_force", demands.max_open_force);
    to.given("max_close_force", demands.max_close_force);
    to.given(Field("self_close_below_deg", "Turn of the body below which it shuts by itself."),
             demands.self_close_below, Number{.least = 0, .most = 360, .is_angle = true});
    to.optional("min_stroke", wanted.min_stroke, amount);
    to.given(Field("end_margin", "Beyond the lengths used, at both ends."), wanted.end_margin, amount);
    to.given(Field("end_length", "The extended length is at least two strokes and this."), wanted.end_length, amount);
    to.optional(Field("min_lever", "Of |dl/ds| over half of the handle's way."), wanted.min_lever, amount);
  });
}

void catalogue_version(FieldVisitor& v) {
  double version = 1;
  v.member(Field("linkwright_catalogue").missing({"catalogue_version", "the version: \"linkwright_catalogue\": 1"}),
           true, [&](FieldVisitor& to) {
             to.number(version, {.least = 1, .most = 1});
             if (version != 1)
               to.mistake("unknown_version", fmt::format("there is no version {} of catalogues; this is 1", version),
                          {{"version", version}, {"known", 1}});
           });
}

struct ForceRange {
  double from = 0, to = 0;
};

void sold_forces(FieldVisitor& v, CatalogueSpring& part) {
  const std::array shapes = {
      Shape{JsonType::list,
            [&part](FieldVisitor& to) {
              visit(to, part.f1, List{.what = {"forces", "a list of forces"}, .least = 1, .most = most_forces},
                    forms::positive);
            }},
      Shape{JsonType::object, [&part](FieldVisitor& to) {
              ForceRange range;
              to.object({}, [&](FieldVisitor& in) {
                in.required("from", range.from, forms::positive);
                in.required("to", range.to, forms::positive);
              });
              part.f1_from = range.from;
              part.f1_to = range.to;
            }}};
  v.shapes(part.f1_from ? 1 : 0, shapes, Wanted{"sold_forces", "[200, 250, …] or {\"from\": 200, \"to\": 400}"});
}

/// What of a part can be no spring.
std::vector<Error> mistakes_in_part(const CatalogueSpring& part) {
  std::vector<Error> found;
  const auto add = [&](const char* code, const char* place, const char* message) {
    found.push_back({code, place, message, {}});
  };
  if (!(part.extended_length > 0)) add("not_positive", "extended_length", "a length above 0");
  if (!(part.stroke > 0 && part.stroke < part.extended_length))
    add("bad_stroke", "stroke", "a stroke is above 0 and shorter than the extended length");
  if (!(part.f2_over_f1 >= 1 && part.f2_over_f1 <= 10)) add("bad_ratio", "F2_over_F1", "F2 is from 1 to 10 times F1");
  if (part.friction < 0) add("negative", "friction", "a number from 0 on");
  if (part.rod_diameter < 0) add("negative", "rod_diameter", "a number from 0 on");
  if (part.measured_at && *part.measured_at < 0) add("negative", "measured_at", "a number from 0 on");
  const bool is_range = part.f1_from && part.f1_to;
  if (is_range ? !(*part.f1_from > 0 && *part.f1_to >= *part.f1_from) : part.f1.empty())
    add("bad_forces", "F1", "one force at least, or a range from the smaller to the larger one");
  if (std::any_of(part.f1.begin(), part.f1.end(), [](double f1) { return !(f1 > 0); }))
    add("bad_forces", "F1", "forces above 0");
  return found;
}

}  // namespace

static void fields(FieldVisitor& v, CatalogueSpring& part) {
  v.object({}, [&](FieldVisitor& to) {
    to.required(Field("name").missing("\"name\": \"8-128-325\""), part.name);
    to.optional(Field("rod_diameter", "Always in millimetres."), part.rod_diameter, amount);
    to.required("extended_length", part.extended_length, forms::length);
    to.required("stroke", part.stroke, forms::length);
    to.member(Field("F1", "Those that it is sold with, N.").missing({"sold_forces", "the forces: [200, 250, …]"}), true,
              [&](FieldVisitor& in) { sold_forces(in, part); });
    to.required(Field("F2_over_F1", "Of the forces without friction."), part.f2_over_f1, amount);
    to.optional(Field("friction", "Half of the difference of compressing and extending, N."), part.friction, amount);
    to.given("measured_at", part.measured_at, amount);
  });
}

namespace {

void catalogue_fields(FieldVisitor& v, SpringCatalogue& catalogue) {
  const std::array kinds = {Case{"gas_springs", {}, [&](FieldVisitor& to) {
                                   to.required(
                                       "springs", catalogue.springs,
                                       List{.what = {"parts", "a list of springs"},
                                            .most = most_parts,
                                            .most_read = most_parts,
                                            .code = "too_many_parts",
                                            .sentence = "{count} springs are too many; {most} are read at most"});
                                 }}};
  v.object({}, [&](FieldVisitor& to) {
    catalogue_version(to);
    to.optional("length_unit", catalogue.length_unit);
    to.optional(Field("source", "Where the numbers are from."), catalogue.source);
    to.switch_on(Field("kind").missing({"catalogue_kind", "gas_springs"}), 0, kinds);
  });
}

template <class Content, class Read>
Result<Content> read_whole(std::string_view text, bool has_version, const Read& read) {
  const auto tree = parse_json(text, {.max_bytes = max_file_bytes, .deepest_nesting = deepest_nesting, .kept = {}});
  if (!tree) return tree.errors();
  Mistakes mistakes;
  const JsonValue root(*tree, "", mistakes);
  if (has_version)
    if (const auto refusal = refuse_version(root)) return *refusal;
  Content content;
  FieldReader reader(root, mistakes);
  read(reader, content);
  if (!mistakes.empty()) return mistakes.take();
  return content;
}

}  // namespace

Result<SpringWanted> read_spring_boxes(std::string_view text) {
  auto wanted = read_whole<SpringWanted>(text, true, boxes);
  if (!wanted) return wanted;
  // What the unit of length decides is looked at where it is known: in metres no margin of 10 mm is too small.
  Loads unit;
  unit.metres = 1;
  SpringWanted checked = *wanted;
  checked.end_margin.reset();
  checked.measured_at = std::min(checked.measured_at.value_or(0), 0.0);
  if (auto mistakes = mistakes_in(checked, unit); !mistakes.empty()) return mistakes;
  return wanted;
}

Result<SpringCatalogue> read_spring_catalogue(std::string_view text) {
  auto read = read_whole<SpringCatalogue>(text, false, catalogue_fields);
  if (!read) return read;
  std::vector<Error> mistakes;
  for (std::size_t k = 0; k < read->springs.size(); ++k)
    for (Error& mistake : mistakes_in_part(read->springs[k])) {
      mistake.place = fmt::format("springs[{}].{}", k, mistake.place);
      mistakes.push_back(std::move(mistake));
    }
  if (!mistakes.empty()) return mistakes;
  return read;
}

OrderedJson spring_boxes_schema(const OrderedJson& rules) {
  SpringWanted wanted;
  FieldSchema visitor;
  boxes(visitor, wanted);
  return visitor.take(rules);
}

OrderedJson spring_catalogue_schema(const OrderedJson& rules) {
  SpringCatalogue catalogue;
  FieldSchema visitor;
  catalogue_fields(visitor, catalogue);
  return visitor.take(rules);
}

Loads loads_beside(const SpringWanted& wanted, Loads loads) {
  if (!wanted.name.empty())
    std::erase_if(loads.springs, [&](const Spring& spring) { return spring.name == wanted.name; });
  return loads;
}

Result<std::vector<CatalogueSpring>> parts_in(const SpringCatalogue& catalogue, const std::string& unit) {
  std::vector<CatalogueSpring> parts = catalogue.springs;
  if (catalogue.length_unit.empty() || catalogue.length_unit == unit) return parts;
  const auto from = millimetres(catalogue.length_unit), to = millimetres(unit);
  if (!from || !to)
    return Error{"other_unit",
                 "length_unit",
                 fmt::format("the catalogue is in \"{}\" and the problem in \"{}\": one of them is not known",
                             catalogue.length_unit, unit),
                 {{"catalogue", catalogue.length_unit}, {"problem", unit}}};
  const double scale = *from / *to;
  for (CatalogueSpring& part : parts) {
    part.extended_length *= scale;
    part.stroke *= scale;
    if (part.measured_at) *part.measured_at *= scale;
  }
  return parts;
}

Result<LoadedLinkage> loaded_linkage(std::string_view text, int linkage) {
  auto listed = read_listed_problem(text, linkage);
  if (!listed) return listed.errors();
  if (!listed->problem.options.loads) return no_loads();
  LoadedLinkage on{listed->problem.title, listed->problem.length_unit, *listed->problem.options.loads, {}, {}};
  on.title += fmt::format("{}linkage {}", on.title.empty() ? "" : ", ", linkage);
  auto solved = solved_place(std::move(listed->problem), listed->layer);
  if (!solved) return solved.errors();
  const auto output = listed_outputs(solved->answer, 0)[solved->place];
  const auto& planar = std::get<PlanarOutput>(*output);
  on.bars = planar.positions.front().bars;
  on.poses = poses_of(planar);
  return on;
}

Result<PlacedSpring> place_spring_on(const LoadedLinkage& linkage, const SpringWanted& wanted,
                                     std::optional<std::vector<CatalogueSpring>> catalogue,
                                     const SpringSearchOptions& options, const Progress& progress) {
  if (auto mistakes = mistakes_in(wanted, linkage.loads); !mistakes.empty()) return mistakes;
  const Loads loads = loads_as_used(loads_beside(wanted, linkage.loads), linkage.bars, linkage.poses);
  PlacedSpring placed{linkage.title, linkage.length_unit, {}, {}, {}};
  placed.place = place_spring(loads, linkage.bars, linkage.poses, wanted, options, progress);
  if (!catalogue) return placed;
  placed.catalogue = *std::move(catalogue);
  placed.parts = rank_parts(loads, linkage.bars, linkage.poses, wanted, placed.catalogue, progress);
  return placed;
}

Result<PlacedSpring> place_listed_spring(std::string_view text, int linkage, const SpringWanted& wanted,
                                         const std::optional<SpringCatalogue>& catalogue,
                                         const SpringSearchOptions& options, const Progress& progress) {
  const auto on = loaded_linkage(text, linkage);
  if (!on) return on.errors();
  std::optional<std::vector<CatalogueSpring>> parts;
  if (catalogue) {
    auto scaled = parts_in(*catalogue, on->length_unit);
    if (!scaled) return scaled.errors();
    parts = *std::move(scaled);
  }
  return place_spring_on(*on, wanted, std::move(parts), options, progress);
}

namespace {

struct FitRecord {
  std::string name;
  const PlacedPart* part = nullptr;
};
struct MissRecord {
  std::string name;
  const MissedPart* part = nullptr;
};

}  // namespace

static void fields(FieldVisitor& v, const FitRecord& fit) {
  v.object({}, [&](FieldVisitor& to) {
    to.shown("name", fit.name);
    to.shown("max_hand_force", fit.part->max_hand_force);
    to.shown("F1_that_would_do", std::array{fit.part->low, fit.part->high}, Pair{.form = "[low, high]"});
    to.member("spring", true, [&](FieldVisitor& in) {
      Spring spring = fit.part->spring;
      fields(in, spring);
    });
  });
}

static void fields(FieldVisitor& v, const MissRecord& miss) {
  v.object({}, [&](FieldVisitor& to) {
    to.shown("name", miss.name);
    to.shown("why", miss.part->why);
  });
}

namespace {

void placed_fields(FieldVisitor& v, const PlacedSpring& placed) {
  v.object({.on_lines = true}, [&](FieldVisitor& to) {
    head_fields(to, placed);
    const auto& found = placed.place.found;
    bool is_there = found.has_value();
    to.member("spring", true, [&](FieldVisitor& in) {
      in.null_or(is_there, [&](FieldVisitor& at) {
        Spring spring = found ? found->spring : Spring{};
        fields(at, spring);
      });
    });
    const auto number = [&](double value) { return found ? std::optional(value) : std::nullopt; };
    to.shown("max_hand_force", number(found ? found->max_hand_force : 0));
    to.shown("at_stations", number(found ? found->at_stations : 0));
    to.shown("lower_bound", found ? found->lower_bound : std::nullopt);
    to.shown("proven", found && found->proven);
    to.shown("places", number(found ? static_cast<double>(found->places) : 0));
    to.shown("boxes", number(found ? static_cast<double>(found->boxes) : 0));
    const auto& why_not = placed.place.why_not;
    to.shown_if_any("why_not", why_not);
    if (!placed.parts) return;
    std::vector<FitRecord> fit;
    for (const PlacedPart& part : placed.parts->fit) fit.push_back({placed.catalogue[part.part].name, &part});
    std::vector<MissRecord> missed;
    for (const MissedPart& part : placed.parts->missed) missed.push_back({placed.catalogue[part.part].name, &part});
    to.shown("parts", fit, forms::on_lines);
    to.shown("missed", missed, forms::on_lines);
  });
}

}  // namespace

std::string write_placed_spring(const PlacedSpring& placed) {
  return json_text_of([&](JsonWriter& json) {
    FieldWriter writer(json);
    placed_fields(writer, placed);
  });
}

}  // namespace linkwright
