#pragma once

#include <cstddef>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/loads/spring_place.hpp"
#include "loads/place_model.hpp"

namespace linkwright {

/// Studs and what they are worth.
struct StudPlace {
  StudCoordinates studs{};
  PlaceModel::Value value;
};

/// The boxes of both studs as one of four dimensions.
struct StudRoom {
  StudCoordinates low{}, size{};

  explicit StudRoom(const SpringWanted& wanted);
  [[nodiscard]] StudCoordinates at(const StudCoordinates& shares) const;
};

/// The best of a grid, `along` ≥ 1 places a side in the middles of equal parts, the best ones first.
struct GridLook {
  std::vector<StudPlace> best;
  std::size_t places = 0;
};
[[nodiscard]] GridLook look_at_grid(const PlaceModel& model, const StudRoom& room, int along, std::size_t most,
                                    const Progress& progress);

/// From a place downhill within the room, by the simplex of Nelder and Mead, begun anew and smaller until it gains
/// nothing; at most `most_looks`. Never worse than the start.
[[nodiscard]] StudPlace polished(const PlaceModel& model, const StudRoom& room, StudPlace start,
                                 std::size_t most_looks);

/// Branch and bound: what is known of all places.
struct BoundedSearch {
  StudPlace best;
  double lower_bound = 0;  ///< nothing in the room is below; infinite: nothing can be built in it
  bool ended = false;      ///< otherwise cancelled, or at the most boxes
  std::size_t boxes = 0;
};
/// The box with the least bound is halved again and again until that bound is within `proof` of the best place, which
/// may get better on the way.
[[nodiscard]] BoundedSearch prove(const PlaceModel& model, const StudRoom& room, const StudPlace& best,
                                  const SpringSearchOptions& options, const Progress& progress, std::size_t places);

}  // namespace linkwright
