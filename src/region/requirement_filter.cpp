#include "linkwright/region/requirement_filter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, requirement_kinds> keys = {
    "types",      "no_defects",           "min_transmission_angle_deg", "max_link_ratio",
    "max_length", "ground_pivots_within", "moving_pivots_within"};

constexpr std::uint8_t bit(RequirementKind kind) {
  return static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind));
}
constexpr std::uint8_t all_failures = (1u << requirement_kinds) - 1;

// Of the points of a side link, user's frame; nothing at infinity.
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

// A value with two digits at most, on the given side of `exact`: a quotient, since no fraction of ten is exact.
double rounded(double exact, bool upwards) {
  if (!(exact > 0)) return 0;
  const double exponent = std::floor(std::log10(exact)) - 1;
  const double larger = std::pow(10, std::max(exponent, 0.0)), smaller = std::pow(10, std::max(-exponent, 0.0));
  const double steps = exact / larger * smaller;
  return (upwards ? std::ceil(steps) : std::floor(steps)) * larger / smaller;
}

}  // namespace

std::string_view key(RequirementKind kind) { return keys[static_cast<std::size_t>(kind)]; }

RequirementFilter::RequirementFilter(const RegionMap& map, const Requirements& requirements, Point origin, double unit,
                                     PivotsAt pivots_at)
    : map_(&map), requirements_(requirements), verdict_failures_(verdict_failures(requirements)) {
  assert(requirements.max_length);
  const double half = std::sin(requirements.min_transmission_angle / 2);
  least_versine_ = static_cast<float>(2 * half * half);
  largest_ratio_ = static_cast<float>(requirements.max_link_ratio);
  largest_length_ = static_cast<float>(*requirements.max_length);
  const auto of_dyads = [&](std::span<const Dyad> dyads) {
    std::vector<std::uint8_t> failures;
    const auto user = [&](Homogeneous point) {
      const auto p = finite_point(point);
      return p ? std::optional(origin + unit * *p) : std::nullopt;
    };
    for (const Dyad& dyad : dyads) failures.push_back(box_failures(user(dyad.center), user(dyad.circle), requirements));
    return failures;
  };
  input_box_failures_ = of_dyads(map.input_dyads());
  output_box_failures_ = of_dyads(map.output_dyads());
  if (map.input_dyads().empty() && (requirements.ground_pivots_within || requirements.moving_pivots_within))
    pivots_at_ = std::move(pivots_at);
}

unsigned RequirementFilter::box_failures_at(std::size_t row, std::size_t column) const {
  if (!input_box_failures_.empty()) return input_box_failures_[row] | output_box_failures_[column];
  if (!pivots_at_ || map_->type(map_->index(row, column)) == LinkageType::degenerate) return 0;
  const auto pivots = pivots_at_(row, column);
  const auto outside = [&](const std::optional<Box>& box, std::vector<Point> Pivots::*of_kind) {
    if (!box) return false;
    return !pivots || !std::all_of(((*pivots).*of_kind).begin(), ((*pivots).*of_kind).end(),
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

std::uint8_t RequirementFilter::failures(std::size_t row, std::size_t column) const {
  const std::size_t cell = map_->index(row, column);
  unsigned failed = verdict_failures_[static_cast<std::size_t>(map_->types()[cell] * 8 + map_->defects()[cell])];
  failed |= box_failures_at(row, column);
  failed |= map_->transmission_versines()[cell] < least_versine_ ? bit(RequirementKind::min_transmission_angle) : 0u;
  failed |= map_->link_ratios()[cell] > largest_ratio_ ? bit(RequirementKind::max_link_ratio) : 0u;
  failed |= map_->longest_links()[cell] > largest_length_ ? bit(RequirementKind::max_length) : 0u;
  return static_cast<std::uint8_t>(failed);
}

void RequirementFilter::failures_of_row(std::size_t row, std::uint8_t* failures) const {
  for (std::size_t column = 0; column < map_->columns(); ++column) failures[column] = this->failures(row, column);
}

void RequirementFilter::failures_of_all(std::span<std::uint8_t> failures) const {
  assert(failures.size() == map_->rows() * map_->columns());
  parallel_for(map_->rows(), 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) failures_of_row(row, &failures[map_->index(row, 0)]);
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

RequirementCensus RequirementFilter::census() const {
  RequirementCensus total;
  std::mutex adding;
  parallel_for(map_->rows(), 0, [&](std::size_t begin, std::size_t end) {
    CensusCounter part;
    std::vector<std::uint8_t> failures(map_->columns());
    for (std::size_t row = begin; row < end; ++row) {
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

template <class Visit>
void RequirementFilter::for_each_failing_only(RequirementKind kind, const Visit& visit) const {
  for (std::size_t row = 0; row < map_->rows(); ++row)
    for (std::size_t column = 0; column < map_->columns(); ++column)
      if (failures(row, column) == bit(kind)) visit(violated_value(kind, map_->index(row, column)));
}

double RequirementFilter::violated_value(RequirementKind kind, std::size_t cell) const {
  switch (kind) {
    case RequirementKind::min_transmission_angle:
      return degrees(map_->min_transmission_angle(cell));
    case RequirementKind::max_link_ratio:
      return static_cast<double>(map_->link_ratios()[cell]);
    case RequirementKind::max_length:
      return static_cast<double>(map_->longest_links()[cell]);
    default:
      return 0;
  }
}

std::optional<double> RequirementFilter::round_value_that_would_do(RequirementKind kind) const {
  const bool is_angle = kind == RequirementKind::min_transmission_angle;
  if (!is_angle && kind != RequirementKind::max_link_ratio && kind != RequirementKind::max_length) return std::nullopt;
  std::optional<double> nearest;
  for_each_failing_only(kind, [&](double value) {
    if (!nearest || (is_angle ? value > *nearest : value < *nearest)) nearest = value;
  });
  return nearest ? std::optional(rounded(*nearest, !is_angle)) : std::nullopt;
}

std::vector<Relaxation> RequirementFilter::relaxations(const RequirementCensus& census) const {
  std::vector<Relaxation> found;
  for (std::size_t k = 0; k < requirement_kinds; ++k) {
    const auto kind = static_cast<RequirementKind>(k);
    const std::int64_t only_this = census.failing_only(kind);
    if (only_this == 0) continue;
    Relaxation relaxation{kind, only_this, std::nullopt, census.meeting + only_this};
    if (const auto value = round_value_that_would_do(kind)) {
      const bool is_angle = kind == RequirementKind::min_transmission_angle;
      relaxation.value = is_angle ? radians(*value) : *value;
      relaxation.leaves = census.meeting;
      for_each_failing_only(kind, [&](double v) { relaxation.leaves += is_angle ? v >= *value : v <= *value; });
    }
    found.push_back(relaxation);
  }
  std::sort(found.begin(), found.end(), [](const Relaxation& a, const Relaxation& b) {
    return a.only_this != b.only_this ? a.only_this > b.only_this : a.requirement < b.requirement;
  });
  return found;
}

}  // namespace linkwright
