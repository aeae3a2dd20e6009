#pragma once

#include <set>
#include <string>
#include <utility>

namespace linkwright {

/// Names of which no two are alike.
class UnlikeNames {
 public:
  UnlikeNames() = default;
  explicit UnlikeNames(std::set<std::string> taken) : taken_(std::move(taken)) {}

  void take(const std::string& name) { taken_.insert(name); }
  /// The name, behind it a _ for each that is called so before.
  [[nodiscard]] std::string unlike_others(std::string name) {
    while (!taken_.insert(name).second) name += '_';
    return name;
  }

 private:
  std::set<std::string> taken_;
};

}  // namespace linkwright
