#include <fmt/format.h>

#include "attitude_header.hpp"
#include "displacement_reader.hpp"
#include "files/json/json.hpp"
#include "linkwright/files/link_chain_file.hpp"
#include "space_reader.hpp"

namespace linkwright {
namespace {

constexpr std::size_t max_links = 1000;

std::optional<HartenbergDenavit> read_link(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"theta_deg", "d", "a", "alpha_deg"});
  if (!value.is_object()) return std::nullopt;
  bool complete = true;
  const auto number = [&](std::string_view key, bool is_angle) {
    const auto found = object.find(key);
    const auto read = !found ? std::optional(0.0) : is_angle ? read_angle(*found) : read_quantity(*found);
    complete = complete && read;
    return read.value_or(0);
  };
  const HartenbergDenavit link{number("theta_deg", true), number("d", false), number("a", false),
                               number("alpha_deg", true)};
  return complete ? std::optional(link) : std::nullopt;
}

void read_links(const JsonValue& value, Mistakes& mistakes, std::vector<HartenbergDenavit>& links) {
  if (value.json().is_array() && (value.json().empty() || value.json().size() > max_links)) {
    value.mistake("link_count", fmt::format("{} links are given; a chain has 1 to {}", value.json().size(), max_links),
                  {{"count", value.json().size()}, {"most", max_links}});
    return;
  }
  value.for_each({"links", "a list of links [{\"theta_deg\": …, \"d\": …, \"a\": …, \"alpha_deg\": …}, …]"},
                 [&](const JsonValue& item) {
                   if (const auto link = read_link(item, mistakes)) links.push_back(*link);
                 });
}

HartenbergDenavitForm read_form(const JsonValue& value) {
  constexpr std::array<std::string_view, 2> forms = {"classic", "modified"};
  const auto form = value.as_one_of(forms);
  return form && *form == "modified" ? HartenbergDenavitForm::modified : HartenbergDenavitForm::classic;
}

LinkChainTask read_chain_members(const JsonObject& file, Mistakes& mistakes) {
  LinkChainTask task;
  const auto form = file.find("form"), points = file.find("points"), unit = file.find("length_unit");
  const auto displacement = file.find("displacement");
  if (form) task.form = read_form(*form);
  if (unit) task.length_unit = unit->as_text().value_or("");
  if (points) task.points = read_vectors(*points).value_or(std::vector<Vector3>());
  if (displacement) {
    DisplacementTask read;
    if (file.find("links")) {
      displacement->mistake("two_chains", "links are given already; keep \"links\" or \"displacement\"");
    } else if (read_displacement(*displacement, mistakes, read)) {
      task.displacement = read.displacement;
    }
    return task;
  }
  const auto links = file.require(
      "links",
      {"links_in_full", "the links: \"links\": [{\"theta_deg\": …, \"d\": …, \"a\": …, \"alpha_deg\": …}, …]"});
  if (links) read_links(*links, mistakes, task.links);
  return task;
}

}  // namespace

Result<LinkChainTask> read_link_chain_task(std::string_view text) {
  return read_attitude_task<LinkChainTask>(
      text, {"linkwright", "title", "length_unit", "form", "links", "points", "displacement"}, read_chain_members);
}

}  // namespace linkwright
