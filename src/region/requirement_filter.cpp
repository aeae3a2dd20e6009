#include "linkwright/region/requirement_filter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <mutex>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, requirement_kinds> requirement_keys = {
    "types",      "no_defects", "min_transmission_angle_deg", "max_link_ratio",
    "max_length", "min_length", "ground_pivots_within",       "moving_pivots_within"};

constexpr std::uint8_t bit(RequirementKind kind) {
  return static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind));
}
constexpr std::uint8_t all_failures = (1u << requirement_kinds) - 1;

// Of the points of a grounded link, user's frame; nothing at infinity.
std::uint8_t box_failures(const std::optional<Point>& center, const std::optional<Point>& circle,
                          const Requirements& wanted) {
  const auto outside = [](const std::optional<Box>& box, const std::optional<Point>& p) {
    return box && !(p && box->contains(*p));
  };
  return static_cast<std::uint8_t>(
      (outside(wanted.ground_pivots_within, center) ? bit(RequirementKind::ground_pivots_within) : 0) |
      (outside(wanted.moving_pivots_within, circle) ? bit(RequirementKind::moving_pivots_within) : 0));
}

// What a cell fails by its type and its defects.
std::array<std::uint8_t, 80> verdict_failures(const Requirements& wanted) {
  std::array<std::uint8_t, 80> failures{};
  for (std::size_t type = 0; type < 10; ++type)
    for (std::size_t defects = 0; defects < 8; ++defects) {
      const auto named = std::find(wanted.types.begin(), wanted.types.end(), static_cast<LinkageType>(type));
      unsigned failed = 0;
      if (!wanted.types.empty() && named == wanted.types.end()) failed |= bit(RequirementKind::types);
      if (wanted.no_defects && defects != 0) failed |= bit(RequirementKind::no_defects);
      if (type == static_cast<std::size_t>(LinkageType::degenerate)) failed = all_failures;
      failures[type * 8 + defects] = static_cast<std::uint8_t>(failed);
    }
  return failures;
}

// Requirements of a number that a linkage has at least, and at most.
bool is_least(RequirementKind kind) {
  return kind == RequirementKind::min_transmission_angle || kind == RequirementKind::min_length;
}
bool is_most(RequirementKind kind) {
  return kind == RequirementKind::max_link_ratio || kind == RequirementKind::max_length;
}

// A value with two digits at most, on the given side of `exact`: a quotient, since no fraction of ten is exact.
double rounded(double exact, bool upwards) {
  if (!(exact > 0)) return 0;
  const double exponent = std::floor(std::log10(exact)) - 1;
  const double larger = std::pow(10, std::max(exponent, 0.0)), smaller = std::pow(10, std::max(-exponent, 0.0));
  const double steps = exact / larger * smaller;
  return (upwards ? std::ceil(steps) : std::floor(steps)) * larger / smaller;
}

}  // namespace

std::string_view key(RequirementKind kind) { return requirement_keys[static_cast<std::size_t>(kind)]; }

RequirementFilter::RequirementFilter(const RegionMap& map, const Requirements& requirements,
                                     const std::function<MapPivots()>& pivots)
    : map_(&map),
      requirements_(requirements),
      verdict_failures_(verdict_failures(requirements)),
      versines_(map.values(measures::min_transmission_angle)),
      ratios_(map.values(measures::link_ratio)),
      longest_(map.values(measures::longest_link)) {
  require(requirements.max_length.has_value(), "max_length is set");
  least_versine_ = static_cast<float>(versine_of_angle(requirements.min_transmission_angle));
  largest_ratio_ = static_cast<float>(requirements.max_link_ratio);
  largest_length_ = static_cast<float>(*requirements.max_length);
  smallest_length_ = static_cast<float>(requirements.min_length.value_or(0));
  if (!pivots || !(requirements.ground_pivots_within || requirements.moving_pivots_within)) return;
  pivots_ = pivots();
  for (const GroundedLinkPivots& link : pivots_.rows)
    input_box_failures_.push_back(box_failures(link.ground, link.moving, requirements));
  for (const GroundedLinkPivots& link : pivots_.columns)
    output_box_failures_.push_back(box_failures(link.ground, link.moving, requirements));
}

RequirementFilter filter_of(const LinkageFamily& family, const RegionMap& map, const Requirements& requirements) {
  return {map, requirements, [&] { return family.pivots(map); }};
}

unsigned RequirementFilter::box_failures_at(std::size_t row, std::size_t column) const {
  if (!input_box_failures_.empty()) return input_box_failures_[row] | output_box_failures_[column];
  if (!pivots_.of_cell || map_->type(map_->index(row, column)) == LinkageType::degenerate) return 0;
  const auto found = pivots_.of_cell(row, column);
  const auto outside = [&](const std::optional<Box>& box, std::vector<Point> Pivots::*of_kind) {
    if (!box) return false;
    return !found || !std::all_of(((*found).*of_kind).begin(), ((*found).*of_kind).end(),
                                  [&](Point p) { return box->contains(p); });
  };
  return (outside(requirements_.ground_pivots_within, &Pivots::ground) ? bit(RequirementKind::ground_pivots_within)
                                                                       : 0u) |
         (outside(requirements_.moving_pivots_within, &Pivots::moving) ? bit(RequirementKind::moving_pivots_within)
                                                                       : 0u);
}

std::int64_t RequirementCensus::left_after(RequirementKind kind) const {
  const std::size_t these = (std::size_t{2} << static_cast<std::size_t>(kind)) - 1;
  std::int64_t left = 0;
  for (std::size_t set = 0; set < failing.size(); ++set) left += (set & these) == 0 ? failing[set] : 0;
  return left;
}

std::string joint_relaxation_text(const JointRelaxation& joint) {
  std::string names;
  for (std::size_t i = 0; i < joint.requirements.size(); ++i)
    names += fmt::format("{}{}",
                         i == 0                               ? ""
                         : i + 1 == joint.requirements.size() ? " and "
                                                              : ", ",
                         key(joint.requirements[i]));
  return fmt::format("Relaxing a single requirement does not help: without {} together {} would be left.", names,
                     grouped_text(joint.leaves));
}

std::optional<JointRelaxation> RequirementCensus::joint_relaxation() const {
  std::size_t best = 0;
  const auto fewer = [](std::size_t a, std::size_t b) { return std::popcount(a) < std::popcount(b); };
  for (std::size_t set = 1; set < failing.size(); ++set)
    if (failing[set] > 0 && (best == 0 || fewer(set, best) || (!fewer(best, set) && failing[set] > failing[best])))
      best = set;
  if (best == 0 || meeting > 0) return std::nullopt;
  JointRelaxation joint{{}, failing[best]};  // no smaller set holds a cell
  for (std::size_t k = 0; k < requirement_kinds; ++k)
    if ((best >> k & 1) != 0) joint.requirements.push_back(static_cast<RequirementKind>(k));
  return joint;
}

std::uint8_t RequirementFilter::failures(std::size_t row, std::size_t column) const {
  const std::size_t cell = map_->index(row, column);
  unsigned failed = verdict_failures_[static_cast<std::size_t>(map_->types()[cell] * 8 + map_->defects()[cell])];
  failed |= box_failures_at(row, column);
  if (!versines_.empty())
    failed |= versines_[cell] < least_versine_ ? bit(RequirementKind::min_transmission_angle) : 0u;
  if (!longest_.empty()) {
    failed |= ratios_[cell] > largest_ratio_ ? bit(RequirementKind::max_link_ratio) : 0u;
    failed |= longest_[cell] > largest_length_ ? bit(RequirementKind::max_length) : 0u;
    failed |= longest_[cell] < smallest_length_ * ratios_[cell] ? bit(RequirementKind::min_length) : 0u;
  }
  return static_cast<std::uint8_t>(failed);
}

void RequirementFilter::failures_of_row(std::size_t row, std::uint8_t* failures) const {
  for (std::size_t column = 0; column < map_->columns(); ++column) failures[column] = this->failures(row, column);
}

void RequirementFilter::failures_of_all(std::span<std::uint8_t> failures, const Progress& progress) const {
  require(failures.size() == map_->rows() * map_->columns(), "there is a place for each cell");
  parallel_for(map_->rows(), map_->threads(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      std::uint8_t* const of_row = failures.data() + map_->index(row, 0);
      if (progress.is_cancelled())
        std::fill_n(of_row, map_->columns(), all_failures);
      else
        failures_of_row(row, of_row);
    }
  });
}

namespace {

/// Counts of cells, four times over, since neighbours are mostly alike and would wait for each other.
class CensusCounter {
 public:
  void count(std::span<const std::uint8_t> failures, std::span<const std::uint8_t> types) {
    for (std::size_t cell = 0; cell < failures.size(); ++cell) {
      auto& [failing, met] = turns_[cell % turns_.size()];
      const bool degenerate = types[cell] == static_cast<std::uint8_t>(LinkageType::degenerate);
      failing[failures[cell]] += !degenerate;
      met[types[cell]] += failures[cell] == 0;
    }
  }
  void add_to(RequirementCensus& total) const {
    for (const auto& [failing, met] : turns_) {
      for (std::size_t set = 0; set < failing.size(); ++set) total.failing[set] += failing[set];
      for (std::size_t type = 0; type < met.size(); ++type) total.meeting_types[type] += met[type];
    }
    total.meeting = total.failing[0];
  }

 private:
  struct Turn {
    std::array<std::int64_t, 1u << requirement_kinds> failing{};
    std::array<std::int64_t, 10> met{};
  };
  std::array<Turn, 4> turns_{};
};

}  // namespace

RequirementCensus RequirementFilter::census(const Progress& progress) const {
  RequirementCensus total;
  std::mutex adding;
  parallel_for(map_->rows(), map_->threads(), [&](std::size_t begin, std::size_t end) {
    CensusCounter part;
    std::vector<std::uint8_t> failures(map_->columns());
    for (std::size_t row = begin; row < end && !progress.is_cancelled(); ++row) {
      failures_of_row(row, failures.data());
      part.count(failures, map_->types().subspan(map_->index(row, 0), map_->columns()));
    }
    const std::lock_guard lock(adding);
    part.add_to(total);
  });
  return total;
}

RequirementCensus RequirementFilter::census(std::span<const std::uint8_t> failures) const {
  CensusCounter counter;
  counter.count(failures, map_->types());
  RequirementCensus total;
  counter.add_to(total);
  return total;
}

std::array<RequirementFilter::Cells, requirement_kinds> RequirementFilter::cells_failing_one(
    const Progress& progress) const {
  std::array<Cells, requirement_kinds> cells;
  std::vector<std::uint8_t> failures(map_->rows() * map_->columns());
  failures_of_all(failures, progress);
  for (std::size_t cell = 0; cell < failures.size(); ++cell)
    if (std::has_single_bit(failures[cell]))
      cells[static_cast<std::size_t>(std::countr_zero(failures[cell]))].push_back(cell);
  return cells;
}

double RequirementFilter::violated_value(RequirementKind kind, std::size_t cell) const {
  switch (kind) {
    case RequirementKind::min_transmission_angle:
      return degrees(map_->min_transmission_angle(cell));
    case RequirementKind::max_link_ratio:
      return static_cast<double>(ratios_[cell]);
    case RequirementKind::max_length:
      return static_cast<double>(longest_[cell]);
    case RequirementKind::min_length:
      return static_cast<double>(longest_[cell] / ratios_[cell]);
    default:
      return 0;
  }
}

std::optional<double> RequirementFilter::round_value_that_would_do(RequirementKind kind, const Cells& cells) const {
  if (!is_least(kind) && !is_most(kind)) return std::nullopt;
  std::optional<double> nearest;
  for (const std::size_t cell : cells) {
    const double value = violated_value(kind, cell);
    if (!nearest || (is_least(kind) ? value > *nearest : value < *nearest)) nearest = value;
  }
  return nearest ? std::optional(rounded(*nearest, is_most(kind))) : std::nullopt;
}

void RequirementFilter::put_value(Relaxation& relaxation, const Cells& cells, std::int64_t meeting) const {
  const RequirementKind kind = relaxation.requirement;
  const auto value = round_value_that_would_do(kind, cells);
  if (!value) return;
  relaxation.value = kind == RequirementKind::min_transmission_angle ? radians(*value) : *value;
  relaxation.leaves = meeting;
  for (const std::size_t cell : cells) {
    const double v = violated_value(kind, cell);
    relaxation.leaves += is_least(kind) ? v >= *value : v <= *value;
  }
}

std::optional<Pivots> RequirementFilter::pivots(std::size_t cell) const {
  const std::size_t row = cell / map_->columns(), column = cell % map_->columns();
  if (pivots_.of_cell) return pivots_.of_cell(row, column);
  const GroundedLinkPivots &input = pivots_.rows[row], &output = pivots_.columns[column];
  if (!input.ground || !input.moving || !output.ground || !output.moving) return std::nullopt;
  return Pivots{{*input.ground, *output.ground}, {*input.moving, *output.moving}};
}

namespace {

Box grown_to(Box box, const std::vector<Point>& points) {
  for (const Point p : points)
    box = {std::min(box.x_low, p.real()), std::max(box.x_high, p.real()), std::min(box.y_low, p.imag()),
           std::max(box.y_high, p.imag())};
  return box;
}

// By how much the borders of the larger box have moved.
double growth(const Box& box, const Box& larger) {
  return box.x_low - larger.x_low + (larger.x_high - box.x_high) + (box.y_low - larger.y_low) +
         (larger.y_high - box.y_high);
}

// Moves each border outwards by a round length.
Box with_round_growth(const Box& box, const Box& larger) {
  return {box.x_low - rounded(box.x_low - larger.x_low, true), box.x_high + rounded(larger.x_high - box.x_high, true),
          box.y_low - rounded(box.y_low - larger.y_low, true), box.y_high + rounded(larger.y_high - box.y_high, true)};
}

bool holds(const Box& box, const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [&](Point p) { return box.contains(p); });
}

}  // namespace

std::optional<Box> RequirementFilter::larger_box_that_would_do(RequirementKind kind, const Cells& cells) const {
  const bool ground = kind == RequirementKind::ground_pivots_within;
  const std::optional<Box>& asked = ground ? requirements_.ground_pivots_within : requirements_.moving_pivots_within;
  std::optional<Box> nearest;
  for (const std::size_t cell : cells) {
    const auto found = pivots(cell);
    if (!found) continue;
    const Box larger = grown_to(*asked, ground ? found->ground : found->moving);
    if (!nearest || growth(*asked, larger) < growth(*asked, *nearest)) nearest = larger;
  }
  return nearest ? std::optional(with_round_growth(*asked, *nearest)) : std::nullopt;
}

void RequirementFilter::put_box(Relaxation& relaxation, const Cells& cells, std::int64_t meeting) const {
  const RequirementKind kind = relaxation.requirement;
  const auto box = larger_box_that_would_do(kind, cells);
  if (!box) return;
  std::int64_t leaves = meeting;
  for (const std::size_t cell : cells) {
    const auto found = pivots(cell);
    leaves += found && holds(*box, kind == RequirementKind::ground_pivots_within ? found->ground : found->moving);
  }
  if (leaves == meeting) return;  // rounding of a border kept out the only one
  relaxation.box = box;
  relaxation.leaves = leaves;
}

std::vector<Relaxation> RequirementFilter::relaxations(const RequirementCensus& census,
                                                       const Progress& progress) const {
  std::vector<Relaxation> found;
  const std::array<Cells, requirement_kinds> cells = cells_failing_one(progress);
  for (std::size_t k = 0; k < requirement_kinds; ++k) {
    const auto kind = static_cast<RequirementKind>(k);
    const std::int64_t only_this = census.failing_only(kind);
    if (only_this == 0) continue;
    Relaxation relaxation{kind, only_this, std::nullopt, std::nullopt, census.meeting + only_this};
    if (kind == RequirementKind::ground_pivots_within || kind == RequirementKind::moving_pivots_within)
      put_box(relaxation, cells[k], census.meeting);
    else
      put_value(relaxation, cells[k], census.meeting);
    found.push_back(relaxation);
  }
  std::sort(found.begin(), found.end(), [](const Relaxation& a, const Relaxation& b) {
    return a.only_this != b.only_this ? a.only_this > b.only_this : a.requirement < b.requirement;
  });
  return found;
}

}  // namespace linkwright
