#include "linkwright/planar/six_bar_task.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "core/number_check.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/motion_task.hpp"

namespace linkwright {
namespace {

constexpr std::array<SixBarRow, 11> rows = {{{{{{0, 2}, {0, 3}}}, SixBarTopology::stephenson_3},
                                             {{{{0, 2}, {1, 3}}}, SixBarTopology::watt_1},
                                             {{{{0, 2}, {4, 3}}}, SixBarTopology::watt_1},
                                             {{{{1, 3}, {0, 3}}}, SixBarTopology::stephenson_2},
                                             {{{{1, 3}, {0, 2}}}, SixBarTopology::watt_1},
                                             {{{{1, 3}, {0, 4}}}, SixBarTopology::watt_1},
                                             {{{{0, 3}, {0, 2}}}, SixBarTopology::stephenson_3},
                                             {{{{0, 3}, {1, 3}}}, SixBarTopology::stephenson_2},
                                             {{{{0, 3}, {1, 4}}}, SixBarTopology::stephenson_1},
                                             {{{{0, 3}, {2, 4}}}, SixBarTopology::stephenson_2},
                                             {{{{0, 3}, {0, 3}}}, SixBarTopology::stephenson_3}}};

bool same_bodies(BodyPair x, BodyPair y) { return x == y || (x.a == y.b && x.b == y.a); }

bool is_inside(Point p) { return std::abs(p.real()) <= largest_coordinate && std::abs(p.imag()) <= largest_coordinate; }

void check_pivot(Point p, const char* key, std::vector<Error>& found) {
  if (!is_inside(p))
    found.push_back(
        {"coordinates_range",
         fmt::format("task.chain.{}", key),
         fmt::format("both coordinates must be numbers between −{0} and {0}", limit_text(largest_coordinate)),
         {{"most", limit_text(largest_coordinate)}}});
}

void check_elbow(const ThreeLinkChain& chain, std::vector<Error>& found) {
  for (std::size_t j = 0; j < chain.assembly_mode.size(); ++j)
    if (chain.assembly_mode[j] != 0 && std::abs(chain.assembly_mode[j]) != 1)
      found.push_back({"elbow_range", fmt::format("task.chain.elbow[{}]", j),
                       "an elbow is 1 (b to the left of the line from a to d) or -1 (to its right)"});
  const int drawn = chain.assembly_mode_in_position_1();
  if (chain.assembly_mode[0] == -drawn)
    found.push_back({"wrong_elbow",
                     "task.chain.elbow[0]",
                     fmt::format("in position 1, where a, b and d are given, the elbow is {}; write {} or move b to "
                                 "the other side of the line from a to d",
                                 drawn, drawn),
                     {{"elbow", drawn}}});
}

void check_shape(const ThreeLinkChain& chain, std::vector<Error>& found) {
  const double first = chain.first_length(), second = chain.second_length(), size = chain.size();
  const double least = tolerance::change_point * size;
  if (!(first > least))
    found.push_back(
        {"zero_first_body", "task.chain.b", "a and b coincide and body 1 has no length; move b away from a"});
  if (!(second > least))
    found.push_back(
        {"zero_second_body", "task.chain.d", "b and d coincide and body 2 has no length; move d away from b"});
  if (first > least && second > least &&
      std::abs(cross(chain.d - chain.a, chain.b - chain.a)) <= tolerance::change_point * size * size)
    found.push_back({"stretched_chain", "task.chain.b",
                     "a, b and d lie on one line and the chain has no elbow; move b off the line from a to d"});
}

void check_reach(const SixBarTask& task, const ThreeLinkChain& chain, std::vector<Error>& found) {
  const double first = chain.first_length(), second = chain.second_length();
  for (std::size_t j = 1; j < task.poses.size(); ++j) {
    const Point d = displaced(chain.d, task.poses.front().pose, task.poses[j].pose);
    const double distance = std::abs(d - chain.a);
    if (distance < first + second && distance > std::abs(first - second)) continue;
    const bool too_far = distance >= first + second;
    found.push_back(
        {too_far ? "too_far" : "too_near",
         "task.chain",
         fmt::format("the chain cannot reach pose {}: its links are {:.4g} and {:.4g} long and the distance "
                     "from a to d is {:.4g} there; {}",
                     j + 1, first, second, distance,
                     too_far ? "make them longer or move a" : "make their lengths less different"),
         {{"pose", j + 1}, {"first", first}, {"second", second}, {"distance", distance}}});
  }
}

void check_chain(const SixBarTask& task, const ThreeLinkChain& chain, std::vector<Error>& found) {
  const std::size_t before = found.size();
  check_pivot(chain.a, "a", found);
  check_pivot(chain.b, "b", found);
  check_pivot(chain.d, "d", found);
  if (found.size() > before) return;
  check_shape(chain, found);
  if (found.size() > before) return;
  check_elbow(chain, found);
  if (before == 0) check_reach(task, chain, found);
}

// The allowed partners of the first link, or all first links.
std::string allowed_seconds(BodyPair first) {
  std::string list;
  for (const SixBarRow& row : rows)
    if (same_bodies(row.added[0], first)) list += (list.empty() ? "\"" : ", \"") + text(row.added[1]) + "\"";
  return list;
}

void check_added(const std::array<BodyPair, 2>& added, std::vector<Error>& found) {
  if (six_bar_row(added)) return;
  const std::string seconds = allowed_seconds(added[0]);
  if (seconds.empty())
    found.push_back({"unknown_first_link",
                     "task.added[0]",
                     fmt::format("no six-bar begins with a link between bodies {}; the first added link is \"0-2\", "
                                 "\"0-3\" or \"1-3\"",
                                 text(added[0])),
                     {{"first", text(added[0])}}});
  else
    found.push_back({"unknown_second_link",
                     "task.added[1]",
                     fmt::format("with \"{}\" as the first, \"{}\" makes no six-bar that guides body 3; the second "
                                 "added link is one of {}",
                                 text(added[0]), text(added[1]), seconds),
                     {{"first", text(added[0])}, {"second", text(added[1])}, {"seconds", seconds}}});
}

void check_box(const SixBarTask& task, std::vector<Error>& found) {
  if (!task.box) {
    if (!task.chain)
      found.push_back({"missing_box", "options.box",
                       "without a chain the pivots are searched for in a box: give \"box\": {\"x\": [low, high], "
                       "\"y\": [low, high]}, or a chain"});
    return;
  }
  std::vector<Error> mistakes = mistakes_in_search_box(*task.box);
  found.insert(found.end(), mistakes.begin(), mistakes.end());
}

void check_poses(const SixBarTask& task, std::vector<Error>& found) {
  constexpr std::size_t wanted = 4;
  const std::size_t count = task.poses.size();
  if (count != wanted) {
    const bool few = count < wanted;
    const std::size_t change = few ? wanted - count : count - wanted;
    found.push_back({few ? "too_few_for_six_bar" : "too_many_for_six_bar",
                     "task.poses",
                     fmt::format("{} pose{} given; a six_bar is found for {}: {} {}", count,
                                 count == 1 ? " was" : "s were", wanted, few ? "add" : "remove", change),
                     {{"count", count}, {"wanted", wanted}, {"change", change}}});
    return;
  }
  for (std::size_t j = 0; j < count; ++j)
    if (!task.poses[j].derivatives.empty()) {
      found.push_back({"derivatives_not_supported", fmt::format("task.poses[{}].derivatives", j),
                       "six-bars are found for four finite poses; leave the directions of travel out, or take a "
                       "four_bar"});
      return;
    }
  std::vector<Error> mistakes = mistakes_in(MotionTask{task.poses});
  found.insert(found.end(), mistakes.begin(), mistakes.end());
}

}  // namespace

double ThreeLinkChain::size() const { return std::max({std::abs(b - a), std::abs(d - b), std::abs(d - a)}); }

std::span<const SixBarRow> six_bar_rows() { return rows; }

std::optional<SixBarRow> six_bar_row(std::array<BodyPair, 2> added) {
  const auto* const found = std::find_if(rows.begin(), rows.end(), [&](const SixBarRow& row) {
    return same_bodies(row.added[0], added[0]) && same_bodies(row.added[1], added[1]);
  });
  return found == rows.end() ? std::nullopt : std::optional(*found);
}

std::vector<Error> mistakes_in_search_box(const Box& box) {
  if (!is_inside({box.x_low, box.y_low}) || !is_inside({box.x_high, box.y_high}))
    return {{"box_range",
             "options.box",
             fmt::format("its borders must be numbers between −{0} and {0}", limit_text(largest_coordinate)),
             {{"most", limit_text(largest_coordinate)}}}};
  if (!(box.x_low < box.x_high && box.y_low < box.y_high))
    return {{"empty_box", "options.box", "the box is empty; each of x and y is [low, high] with low below high"}};
  return {};
}

std::vector<Error> mistakes_in(const SixBarTask& task) {
  std::vector<Error> found;
  check_poses(task, found);
  if (task.chain) check_chain(task, *task.chain, found);
  check_added(task.added, found);
  check_box(task, found);
  return found;
}

}  // namespace linkwright
