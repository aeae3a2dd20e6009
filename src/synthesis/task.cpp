#include "linkwright/synthesis/task.hpp"

#include <type_traits>

namespace linkwright {

const LinkageClass& linkages(const Task& task) {
  return std::visit(
      [](const auto& of_kind) -> const LinkageClass& {
        if constexpr (requires { of_kind.linkage_class(); })
          return of_kind.linkage_class();
        else
          return of_kind.linkages;
      },
      task);
}

const WantedFunction* wanted_function(const Task& task) {
  return std::visit(
      [](const auto& of_kind) -> const WantedFunction* {
        if constexpr (std::is_base_of_v<WantedFunction, std::decay_t<decltype(of_kind)>>) return &of_kind;
        return nullptr;
      },
      task);
}

OutputKind output_kind(const Task& task) {
  return std::visit([](const auto& of_kind) { return of_kind.output; }, task);
}

std::span<const PrescribedPose> guided_poses(const Task& task) {
  return std::visit(
      [](const auto& of_kind) -> std::span<const PrescribedPose> {
        if constexpr (requires { of_kind.poses; }) return of_kind.poses;
        return {};
      },
      task);
}

std::span<const BodyPoints> points_of(const Task& task) {
  return std::visit(
      [](const auto& of_kind) -> std::span<const BodyPoints> {
        if constexpr (requires { std::span<const BodyPoints>(of_kind.points); }) return of_kind.points;
        return {};
      },
      task);
}

bool is_search(const Task& task) {
  return std::visit(
      [](const auto& of_kind) {
        if constexpr (requires { of_kind.is_search(); }) return of_kind.is_search();
        return false;
      },
      task);
}

std::vector<Error> mistakes_in(const Task& task) {
  return std::visit([](const auto& of_kind) { return mistakes_in(of_kind); }, task);
}

}  // namespace linkwright
