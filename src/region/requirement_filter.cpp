#include "linkwright/region/requirement_filter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <mutex>
#include <tuple>
#include <unordered_map>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

static_assert(max_requirements <= 8 * sizeof(FailureBits), "a requirement is a bit");

// A value with two digits at most, on the given side of `exact`: a quotient, since no fraction of ten is exact.
double rounded(double exact, bool upwards) {
  if (!(exact > 0)) return 0;
  const double exponent = std::floor(std::log10(exact)) - 1;
  const double larger = std::pow(10, std::max(exponent, 0.0)), smaller = std::pow(10, std::max(-exponent, 0.0));
  const double steps = exact / larger * smaller;
  return (upwards ? std::ceil(steps) : std::floor(steps)) * larger / smaller;
}

}  // namespace

double RequirementFilter::Bound::value(std::size_t cell) const {
  if (measure.stored == Measure::Stored::as_versine)
    return degrees(angle_of_versine(static_cast<double>(values[cell])));
  return static_cast<double>(per.empty() ? values[cell] : values[cell] / per[cell]);
}

RequirementFilter::RequirementFilter(const RegionMap& map, const Requirements& requirements,
                                     const std::function<MapPivots()>& pivots, const LinkageClass& linkages)
    : map_(&map), requirements_(requirements), judge_(requirements, linkages, map.measures()) {
  require(kinds().size() <= max_requirements, "a class has no more requirements than there are bits");
  require(requirements.max_length || place_among(kinds(), RequirementKind::max_length) == kinds().size(),
          "max_length is set");
  for (std::size_t code = 0; code < 8 * linkage_type_count; ++code)
    verdict_failures_.push_back(
        judge_.failures(static_cast<LinkageType>(code / 8), Defects{static_cast<std::uint8_t>(code % 8)}));
  const auto column = [&](std::size_t measure) { return map.values(map.measures()[measure]); };
  for (const CellJudge::Bound& bound : judge_.bounds())
    bounds_.push_back({bound.asked->kind, bound.bit, *bound.asked->of, column(bound.of),
                       bound.per ? column(*bound.per) : std::span<const float>{}, static_cast<float>(bound.limit),
                       bound.is_least()});
  if (!pivots || judge_.places().empty()) return;
  pivots_ = pivots();
  for (const GroundedLinkPivots& link : pivots_.rows) input_place_failures_.push_back(place_failures(link));
  for (const GroundedLinkPivots& link : pivots_.columns) output_place_failures_.push_back(place_failures(link));
}

FailureBits RequirementFilter::place_failures(const GroundedLinkPivots& link) const {
  unsigned failed = 0;
  for (const Place& place : judge_.places()) {
    const std::optional<Vector3>& hinge = link.*place.of_link;
    if (!hinge || !contains(place.within, *hinge)) failed |= place.bit;
  }
  return static_cast<FailureBits>(failed);
}

double RequirementFilter::distance_to_windows(std::size_t row, std::size_t column) const {
  const std::size_t cell = map_->index(row, column);
  if (map_->type(cell) == LinkageType::degenerate) return Requirements::unlimited;
  if (judge_.places().empty()) return 0;
  const auto found = pivots(cell);
  if (!found) return Requirements::unlimited;
  double farthest = 0;
  for (const Place& place : judge_.places())
    for (const Vector3 hinge : (*found).*place.of_linkage)
      farthest = std::max(farthest, distance_to(place.within, hinge));
  return farthest;
}

RequirementFilter filter_of(const LinkageFamily& family, const RegionMap& map, const Requirements& requirements) {
  return {map, requirements, [&] { return family.pivots(map); }, family.linkages()};
}

unsigned RequirementFilter::place_failures_at(std::size_t row, std::size_t column) const {
  if (!input_place_failures_.empty()) return input_place_failures_[row] | output_place_failures_[column];
  if (!pivots_.of_cell || map_->type(map_->index(row, column)) == LinkageType::degenerate) return 0;
  const auto found = pivots_.of_cell(row, column);
  unsigned failed = 0;
  for (const Place& place : judge_.places())
    if (!found || !place.holds(*found)) failed |= place.bit;
  return failed;
}

std::int64_t RequirementCensus::failing_only(RequirementKind kind) const {
  const std::size_t place = place_among(kinds, kind);
  const auto found = failing.find(FailureBits{1} << place);
  return place < kinds.size() && found != failing.end() ? found->second : 0;
}

std::int64_t RequirementCensus::left_after(RequirementKind kind) const {
  const FailureBits these = (FailureBits{2} << place_among(kinds, kind)) - 1;
  std::int64_t left = 0;
  for (const auto& [set, cells] : failing) left += (set & these) == 0 ? cells : 0;
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
  return fmt::format("No linkage looked at fails a single requirement alone: without {} together {} would be left.",
                     names, grouped_text(joint.leaves));
}

std::optional<JointRelaxation> RequirementCensus::joint_relaxation() const {
  // A linkage with a defect does not do the task: that is given up last.
  const auto dearness = [&](const auto& failed) {
    const auto& [set, cells] = failed;
    bool takes_defects = false;
    for (std::size_t k = 0; k < kinds.size(); ++k)
      takes_defects |= kinds[k] == RequirementKind::no_defects && (set >> k & 1) != 0;
    return std::tuple(takes_defects, std::popcount(set), -cells);
  };
  const auto* best = static_cast<const decltype(failing)::value_type*>(nullptr);
  for (const auto& failed : failing)
    if (failed.first != 0 && failed.second > 0 && (!best || dearness(failed) < dearness(*best))) best = &failed;
  if (!best || meeting > 0) return std::nullopt;
  return JointRelaxation{kinds_of(best->first, kinds), best->second};  // no smaller set holds a cell
}

FailureBits RequirementFilter::failures(std::size_t row, std::size_t column) const {
  const std::size_t cell = map_->index(row, column);
  unsigned failed = verdict_failures_[static_cast<std::size_t>(map_->types()[cell] * 8 + map_->defects()[cell])];
  failed |= place_failures_at(row, column);
  for (const Bound& bound : bounds_) failed |= bound.excludes(cell) ? bound.bit : 0u;
  return static_cast<FailureBits>(failed);
}

// Bound by bound, so that a row of cells is compared at once.
void RequirementFilter::failures_of_row(std::size_t row, FailureBits* failures) const {
  const std::size_t first = map_->index(row, 0), count = map_->columns();
  for (std::size_t k = 0; k < count; ++k)
    failures[k] =
        verdict_failures_[static_cast<std::size_t>(map_->types()[first + k] * 8 + map_->defects()[first + k])];
  for (const Bound& bound : bounds_)
    for (std::size_t k = 0; k < count; ++k) failures[k] |= bound.excludes(first + k) ? bound.bit : FailureBits{0};
  for (std::size_t k = 0; k < count && !judge_.places().empty(); ++k)
    failures[k] |= static_cast<FailureBits>(place_failures_at(row, k));
}

void RequirementFilter::failures_of_all(std::span<FailureBits> failures, const Progress& progress) const {
  require(failures.size() == map_->rows() * map_->columns(), "there is a place for each cell");
  parallel_for(map_->rows(), map_->threads(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      FailureBits* const of_row = failures.data() + map_->index(row, 0);
      if (progress.is_cancelled())
        std::fill_n(of_row, map_->columns(), all_failures);
      else
        failures_of_row(row, of_row);
    }
  });
}

namespace {

/// Counts of cells. Neighbours mostly fail the same, so that they are counted by runs.
class CensusCounter {
 public:
  void count(std::span<const FailureBits> failures, std::span<const std::uint8_t> types) {
    for (std::size_t cell = 0; cell < failures.size();) {
      std::size_t end = cell + 1;
      while (end < failures.size() && failures[end] == failures[cell] && types[end] == types[cell]) ++end;
      const auto run = static_cast<std::int64_t>(end - cell);
      if (types[cell] != static_cast<std::uint8_t>(LinkageType::degenerate)) failing_[failures[cell]] += run;
      if (failures[cell] == 0) met_[types[cell]] += run;
      cell = end;
    }
  }
  void add_to(RequirementCensus& total) const {
    for (const auto& [set, cells] : failing_) total.failing[set] += cells;
    for (std::size_t type = 0; type < met_.size(); ++type) total.meeting_types[type] += met_[type];
    total.meeting = total.failing[0];
  }

 private:
  std::unordered_map<FailureBits, std::int64_t> failing_;
  std::array<std::int64_t, linkage_type_count> met_{};
};

}  // namespace

RequirementCensus RequirementFilter::census(const Progress& progress) const {
  RequirementCensus total{kinds()};
  std::mutex adding;
  parallel_for(map_->rows(), map_->threads(), [&](std::size_t begin, std::size_t end) {
    CensusCounter part;
    std::vector<FailureBits> failures(map_->columns());
    for (std::size_t row = begin; row < end && !progress.is_cancelled(); ++row) {
      failures_of_row(row, failures.data());
      part.count(failures, map_->types().subspan(map_->index(row, 0), map_->columns()));
    }
    const std::lock_guard lock(adding);
    part.add_to(total);
  });
  return total;
}

RequirementCensus RequirementFilter::census(std::span<const FailureBits> failures) const {
  CensusCounter counter;
  counter.count(failures, map_->types());
  RequirementCensus total{kinds()};
  counter.add_to(total);
  return total;
}

std::array<RequirementFilter::Cells, max_requirements> RequirementFilter::cells_failing_one(
    const Progress& progress) const {
  std::array<Cells, max_requirements> cells;
  std::vector<FailureBits> failures(map_->rows() * map_->columns());
  failures_of_all(failures, progress);
  for (std::size_t cell = 0; cell < failures.size(); ++cell)
    if (std::has_single_bit(failures[cell]))
      cells[static_cast<std::size_t>(std::countr_zero(failures[cell]))].push_back(cell);
  return cells;
}

void RequirementFilter::put_value(Relaxation& relaxation, const Cells& cells, bool is_least,
                                  const ValueOfCell& value_of) const {
  std::optional<double> nearest;
  for (const std::size_t cell : cells) {
    const auto value = value_of(cell);
    // An infinite one cannot be asked for.
    if (value && std::isfinite(*value) && (!nearest || (is_least ? *value > *nearest : *value < *nearest)))
      nearest = value;
  }
  if (!nearest) return;
  const double limit = rounded(*nearest, !is_least);
  relaxation.value = criterion(relaxation.requirement).is_angle() ? radians(limit) : limit;
  relaxation.leaves -= relaxation.only_this;
  for (const std::size_t cell : cells) {
    const auto value = value_of(cell);
    relaxation.leaves += value && (is_least ? *value >= limit : *value <= limit);
  }
}

// The line furthest from the axis decides, in degrees.
void RequirementFilter::put_half_angle(Relaxation& relaxation, const Cells& cells, const Place& place) const {
  const Cone& cone = std::get<Cone>(place.within);
  put_value(relaxation, cells, false, [&](std::size_t cell) -> std::optional<double> {
    const auto found = pivots(cell);
    if (!found) return std::nullopt;
    double widest = 0;
    for (const Vector3 line : (*found).*place.of_linkage) widest = std::max(widest, cone.angle_to(line));
    return degrees(widest);
  });
}

std::optional<Pivots> RequirementFilter::pivots(std::size_t cell) const {
  const std::size_t row = cell / map_->columns(), column = cell % map_->columns();
  if (pivots_.of_cell) return pivots_.of_cell(row, column);
  const GroundedLinkPivots &input = pivots_.rows[row], &output = pivots_.columns[column];
  if (!input.ground || !input.moving || !output.ground || !output.moving) return std::nullopt;
  return Pivots{{*input.ground, *output.ground}, {*input.moving, *output.moving}};
}

namespace {

Box grown_to(Box box, const Hinges& points) {
  for (const Vector3 p : points)
    box = {std::min(box.x_low, p.x), std::max(box.x_high, p.x), std::min(box.y_low, p.y), std::max(box.y_high, p.y)};
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

}  // namespace

void RequirementFilter::put_box(Relaxation& relaxation, const Cells& cells, const Place& place) const {
  const Box& asked = std::get<Box>(place.within);
  std::optional<Box> nearest;
  for (const std::size_t cell : cells) {
    const auto found = pivots(cell);
    if (!found) continue;
    const Box larger = grown_to(asked, (*found).*place.of_linkage);
    if (!nearest || growth(asked, larger) < growth(asked, *nearest)) nearest = larger;
  }
  if (!nearest) return;
  const Box box = with_round_growth(asked, *nearest);
  Place relaxed = place;
  relaxed.within = box;
  std::int64_t gained = 0;
  for (const std::size_t cell : cells) {
    const auto found = pivots(cell);
    gained += found && relaxed.holds(*found);
  }
  if (gained == 0) return;  // rounding of a border kept out the only one
  relaxation.box = box;
  relaxation.leaves += gained - relaxation.only_this;
}

void RequirementFilter::put_relaxed(Relaxation& relaxation, const Cells& cells) const {
  for (const Bound& bound : bounds_)
    if (bound.kind == relaxation.requirement)
      put_value(relaxation, cells, bound.is_least, [&](std::size_t cell) { return std::optional(bound.value(cell)); });
  for (const Place& place : judge_.places()) {
    if (place.kind != relaxation.requirement) continue;
    std::holds_alternative<Box>(place.within) ? put_box(relaxation, cells, place)
                                              : put_half_angle(relaxation, cells, place);
  }
}

std::vector<Relaxation> RequirementFilter::relaxations(const RequirementCensus& census,
                                                       const Progress& progress) const {
  std::vector<Relaxation> found;
  const std::array<Cells, max_requirements> cells = cells_failing_one(progress);
  for (std::size_t k = 0; k < kinds().size(); ++k) {
    const std::int64_t only_this = census.failing_only(kinds()[k]);
    const Criterion& asked = criterion(kinds()[k]);
    if (only_this == 0 || (!asked.lets_infinite_pass && !asked.has_limit(requirements_))) continue;
    Relaxation relaxation{kinds()[k], only_this, std::nullopt, std::nullopt, census.meeting + only_this};
    put_relaxed(relaxation, cells[k]);
    found.push_back(relaxation);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Relaxation& a, const Relaxation& b) { return a.only_this > b.only_this; });
  return found;
}

}  // namespace linkwright
