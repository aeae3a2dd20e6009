#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "four_bar_loads.hpp"
#include "linkwright/core/angle.hpp"
#include "loads/cell_loads.hpp"
#include "loads_analysis.hpp"

namespace linkwright {
namespace {

struct Row {
  ReadOut read_out;
  const Measure* measure;
};
constexpr std::array rows = {Row{ReadOut::max_open_force, &measures::max_open_force},
                             Row{ReadOut::max_close_force, &measures::max_close_force},
                             Row{ReadOut::hand_force, &measures::hand_force},
                             Row{ReadOut::hold_open, &measures::hold_open},
                             Row{ReadOut::max_pin_force, &measures::max_pin_force},
                             Row{ReadOut::max_torque, &measures::max_torque},
                             Row{ReadOut::cylinder_force, &measures::cylinder_force},
                             Row{ReadOut::self_rise, &measures::self_rise},
                             Row{ReadOut::self_close, &measures::self_close},
                             Row{ReadOut::hand_force_error, &measures::hand_force_error},
                             Row{ReadOut::best_f1, &measures::best_f1}};

double no_value(ReadOut read_out) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return larger_is_worse(read_out) ? infinite : -infinite;
}

/// As a map has it.
double measured(CellLoads& cell, ReadOut read_out) {
  const auto found = cell.read_out(read_out);
  return found.value_or(no_value(read_out));
}

/// The forces in the linkages of a family: in a map's all at once, in those that a search looks at read-out by
/// read-out.
class FamilyLoads : public CellMeasures {
 public:
  /// Refers to the family.
  FamilyLoads(const LinkageFamily& family, const Loads& loads) : family_(family), loads_(loads) {}

  [[nodiscard]] Rows rows_of(const RegionMap& map, std::span<const Measure> measures) const override {
    std::vector<ReadOut> read_outs;
    for (const Measure& measure : measures) read_outs.push_back(*read_out_of(measure));
    auto links = family_.four_bar_cells(map);
    if (links && links->has_rows_and_columns() && fits_lanes(loads_, links->positions()))
      if (const auto body = body_of(map)) return four_bar_loads(std::move(links), map, loads_, read_outs, *body);
    return [this, &map, read_outs, output_of = family_.outputs_of(map)](std::size_t row, auto values) {
      for (std::size_t column = 0; column < map.columns(); ++column) {
        const auto found = cell_of(map, output_of, row, column, read_outs);
        for (std::size_t k = 0; k < read_outs.size(); ++k) values[k][column] = static_cast<float>(found[k]);
      }
    };
  }

  /// Nothing: no linkage is there; infinite, to the worse side, where a defect keeps it from having a value.
  [[nodiscard]] std::optional<double> at(MapPoint place, ReadOut read_out) const {
    const std::shared_ptr<CellLoads> cell = last_at(place);
    return cell ? std::optional(measured(*cell, read_out)) : std::nullopt;
  }

 private:
  /// Cell by cell; 0 where there is no linkage.
  template <class OutputOf>
  [[nodiscard]] std::vector<double> cell_of(const RegionMap& map, const OutputOf& output_of, std::size_t row,
                                            std::size_t column, const std::vector<ReadOut>& read_outs) const {
    const std::size_t cell = map.index(row, column);
    std::vector<double> found(read_outs.size());
    if (map.type(cell) == LinkageType::degenerate) return found;
    std::transform(read_outs.begin(), read_outs.end(), found.begin(), no_value);
    const auto output = map.defects(cell).none() ? output_of(row, column) : std::nullopt;
    const auto* planar = output ? std::get_if<PlanarOutput>(&*output) : nullptr;
    if (!planar) return found;
    CellLoads loaded(loads_, *planar, CellLook::map);
    for (std::size_t k = 0; k < read_outs.size(); ++k) found[k] = measured(loaded, read_outs[k]);
    return found;
  }
  /// Where all linkages have the body in position 1; nothing where the map has none.
  [[nodiscard]] std::optional<Pose> body_of(const RegionMap& map) const {
    for (const double input : map.input_coordinates())
      for (const double output : map.output_coordinates())
        if (const auto found = family_.output({input, output}))
          if (const auto* planar = std::get_if<PlanarOutput>(&*found))
            return Pose{planar->positions.front().point, planar->body_angle};
    return std::nullopt;
  }

  /// Null: no linkage is there.
  [[nodiscard]] std::shared_ptr<CellLoads> last_at(MapPoint place) const {
    const auto self = std::this_thread::get_id();
    const auto is_it = [&](const Looked& at) {
      return at.by == self && at.place.input == place.input && at.place.output == place.output;
    };
    {
      const std::lock_guard lock(mutex_);
      const auto known = std::find_if(looked_.begin(), looked_.end(), is_it);
      if (known != looked_.end()) return known->cell;
    }
    const auto output = family_.output(place);
    const auto* planar = output ? std::get_if<PlanarOutput>(&*output) : nullptr;
    auto cell = planar ? std::make_shared<CellLoads>(loads_, *planar, CellLook::search) : nullptr;
    const std::lock_guard lock(mutex_);
    looked_[next_++ % looked_.size()] = {self, place, cell};
    return cell;
  }

  /// By a thread, whose own it is.
  struct Looked {
    std::thread::id by;
    MapPoint place;
    std::shared_ptr<CellLoads> cell;
  };
  const LinkageFamily& family_;
  Loads loads_;
  mutable std::mutex mutex_;
  mutable std::array<Looked, 16> looked_{};
  mutable std::size_t next_ = 0;
};

class LoadMeasure : public CellMeasure {
 public:
  LoadMeasure(std::shared_ptr<const FamilyLoads> loads, const Row& row)
      : CellMeasure(*row.measure), loads_(std::move(loads)), read_out_(row.read_out) {}

  [[nodiscard]] std::optional<double> at(MapPoint place) const override { return loads_->at(place, read_out_); }

 private:
  std::shared_ptr<const FamilyLoads> loads_;
  ReadOut read_out_;
};

/// Between what a search looks at and what is listed: in newtons, newton metres or radians.
std::function<double(double limit)> margin_of(const Measure& measure) {
  const bool is_angle = measure.stored == Measure::Stored::as_angle;
  return [least = is_angle ? radians(0.01) : 0.01](double limit) { return least + 1e-4 * std::abs(limit); };
}

}  // namespace

bool is_counted(ReadOut read_out, const Loads& loads) {
  if (read_out == ReadOut::best_f1) return true;
  if (read_out == ReadOut::hand_force_error) return is_counted(ReadOut::hand_force, loads);
  const std::vector<LoadCase> cases = cases_of(loads);
  return std::any_of(cases.begin(), cases.end(), [&](const LoadCase& of) { return of.counts(read_out); });
}

bool has_value(ReadOut read_out, const Loads& loads) {
  switch (read_out) {
    case ReadOut::max_torque:
      return loads.drive == LoadDrive::input || loads.drive == LoadDrive::output;
    case ReadOut::cylinder_force:
      return loads.drive == LoadDrive::cylinder;
    case ReadOut::max_pin_force:
      return true;
    case ReadOut::best_f1:
      return free_spring(loads).has_value();
    default:
      return loads.handle.has_value();
  }
}

std::optional<ReadOut> read_out_of(const Measure& measure) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return *row.measure == measure; });
  return found == rows.end() ? std::nullopt : std::optional(found->read_out);
}

AddedMeasures load_measures(const LinkageFamily& family, const Loads& loads) {
  const auto forces = std::make_shared<const FamilyLoads>(family, loads);
  AddedMeasures added;
  for (const Row& row : rows)
    if (has_value(row.read_out, loads) && is_counted(row.read_out, loads))
      added.all.push_back({.measure = std::make_shared<LoadMeasure>(forces, row),
                           .together = forces,
                           .margin_of = margin_of(*row.measure)});
  return added;
}

}  // namespace linkwright
