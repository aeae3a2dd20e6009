#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "files/fields/field_reader.hpp"
#include "files/json/json.hpp"
#include "files/problem_fields.hpp"
#include "files/vocabulary.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "six_bar_kind.hpp"

namespace linkwright {
namespace {

/// An added link as it is written: the hinge on the body named first comes first.
struct WrittenLink {
  BodyPair between;
  std::array<Point, 2> points{};
};

std::optional<BodyPair> read_between(const JsonObject& link) {
  const auto found = link.require("between", {"two_bodies", "two bodies, as in \"0-2\""});
  const auto text = found ? found->as_text() : std::nullopt;
  if (!text) return std::nullopt;
  const auto pair = body_pair_from(*text);
  if (!pair)
    found->mistake("unknown_bodies", fmt::format("{} names no two bodies; write them as in \"0-2\"", in_quotes(*text)),
                   {{"given", in_quotes(*text)}});
  return pair;
}

std::optional<std::array<Point, 2>> read_points(const JsonObject& link) {
  const auto found = link.require("points", {"two_hinges", "the two hinges [[x, y], [x, y]]"});
  if (!found) return std::nullopt;
  std::vector<Point> points;
  const bool is_list = found->for_each({"two_hinges", "two hinges [[x, y], [x, y]]"}, [&](const JsonValue& item) {
    if (const auto point = item.as_pair({"[x, y]"})) points.push_back(*point);
  });
  if (!is_list) return std::nullopt;
  if (points.size() == 2 && found->json().size() == 2) return std::array{points[0], points[1]};
  if (points.size() == found->json().size())
    found->mistake("hinge_count", fmt::format("{} hinges are given; an added link has two", points.size()),
                   {{"count", points.size()}});
  return std::nullopt;
}

std::optional<std::vector<WrittenLink>> read_added_links(const JsonObject& element, Mistakes& mistakes) {
  const auto found =
      element.require("added", {"two_added_links", "the two added links with \"between\" and \"points\""});
  if (!found) return std::nullopt;
  std::vector<WrittenLink> links;
  bool complete = true;
  const bool is_list = found->for_each({"two_added_links", "the two added links"}, [&](const JsonValue& item) {
    const JsonObject link(item, mistakes, {});
    const auto between = item.is_object() ? read_between(link) : std::nullopt;
    const auto points = item.is_object() ? read_points(link) : std::nullopt;
    complete = complete && between && points;
    if (between && points) links.push_back({*between, *points});
  });
  if (!is_list || !complete) return std::nullopt;
  if (links.size() == 2) return links;
  found->mistake("added_count",
                 fmt::format("{} added links are given; a six-bar has two beside the chain", links.size()),
                 {{"count", links.size()}});
  return std::nullopt;
}

/// The hinges in the order in which the library names the bodies.
std::array<Point, 2> ordered(const WrittenLink& link, BodyPair pair) {
  return link.between == pair ? link.points : std::array{link.points[1], link.points[0]};
}

bool in_range(const SixBar& six_bar) {
  for (const SixBarJoint& joint : six_bar.joints)
    if (!(std::abs(joint.point.real()) <= largest_number && std::abs(joint.point.imag()) <= largest_number))
      return false;
  return true;
}

}  // namespace

bool says_six_bar(const JsonValue& value) {
  if (!value.is_object()) return false;
  const auto mechanism = value.json().find("mechanism");
  return mechanism != value.json().end() && *mechanism == "six_bar";
}

std::optional<StoredSixBar> read_six_bar(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject element(value, mistakes, {});
  const auto written_chain =
      element.require("chain", {"chain", "the guiding chain {\"a\": [x, y], \"b\": [x, y], \"d\": [x, y]}"});
  const auto chain = written_chain ? read_fields<ThreeLinkChain>(*written_chain, mistakes) : std::nullopt;
  const auto links = read_added_links(element, mistakes);
  if (!chain || !links) return std::nullopt;
  const auto row = six_bar_row({(*links)[0].between, (*links)[1].between});
  if (!row) {
    value.mistake("unknown_row",
                  fmt::format("links {} and {} do not make a six-bar that body 1 drives and body 3 is guided by; "
                              "\"0-2\" and \"0-3\" do",
                              text((*links)[0].between), text((*links)[1].between)),
                  {{"first", text((*links)[0].between)}, {"second", text((*links)[1].between)}});
    return std::nullopt;
  }
  StoredSixBar stored;
  stored.row = *row;
  for (std::size_t j = 0; j < stored.assembly_mode.size(); ++j)
    stored.assembly_mode[j] = (chain->assembly_mode[j] > 0 ? 1 : 0) - (chain->assembly_mode[j] < 0 ? 1 : 0);
  stored.six_bar = SixBar::of({chain->a, chain->b, chain->d}, row->added, ordered((*links)[0], row->added[0]),
                              ordered((*links)[1], row->added[1]));
  if (!in_range(stored.six_bar)) {
    value.mistake("hinge_range", fmt::format("the coordinates of a hinge lie between ±{}", limit_text(largest_number)),
                  {{"most", limit_text(largest_number)}});
  } else if (shape_of(stored.six_bar).type == LinkageType::degenerate) {
    value.mistake("degenerate_six_bar", "two hinges of one body coincide; every link of a six-bar has a length");
  } else {
    return stored;
  }
  return std::nullopt;
}

}  // namespace linkwright
