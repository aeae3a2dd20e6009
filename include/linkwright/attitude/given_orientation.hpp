#pragma once

#include <string>
#include <utility>

#include "linkwright/attitude/quaternion.hpp"

namespace linkwright {

/// A rotation and the form in which a file gave it, which is kept so that files echo what was asked: matrix, axis and
/// angle, angles of a sequence. Another rotation assigned to it has none; the same rotation in another form is equal.
class GivenOrientation : public UnitQuaternion {
 public:
  GivenOrientation() = default;
  GivenOrientation(const UnitQuaternion& rotation, std::string form = {})
      : UnitQuaternion(rotation), form_(std::move(form)) {}

  /// The members that give it, as JSON text without braces: `"axis": [0,0,1], "angle_deg": 30`; empty: not from a file.
  [[nodiscard]] const std::string& form() const { return form_; }

 private:
  std::string form_;
};

}  // namespace linkwright
