#pragma once

#include <string>
#include <vector>

#include "linkwright/core/result.hpp"

namespace linkwright {

/// The mistakes found in a file, in the order in which they were found. A hostile file can hold millions: after
/// `max_listed` they are only counted.
class Mistakes {
 public:
  static constexpr std::size_t max_listed = 100;

  void add(std::string code, std::string place, std::string message, Values values = {});
  void add(Error error);
  void add(const std::vector<Error>& errors);
  /// Those of the errors that are not in the list: two readers may look at the same member.
  void add_new(const std::vector<Error>& errors);
  [[nodiscard]] bool empty() const { return errors_.empty(); }
  [[nodiscard]] std::size_t size() const { return errors_.size() + unlisted_; }
  /// The list, with a last entry for those that were only counted.
  [[nodiscard]] std::vector<Error> take();

 private:
  std::vector<Error> errors_;
  std::size_t unlisted_ = 0;
};

}  // namespace linkwright
