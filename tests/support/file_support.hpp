#pragma once

#include <filesystem>
#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright::testing {

/// A folder of its own for a test, removed afterwards.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::size_t file_count() const;

 private:
  std::filesystem::path path_;
};
[[nodiscard]] inline std::filesystem::path operator/(const Folder& folder, const std::string& name) {
  return folder.path() / name;
}

[[nodiscard]] std::string text_of(const std::filesystem::path& path);

/// examples/tailgate.json, and its answer on a small region.
[[nodiscard]] const Problem& tailgate();
[[nodiscard]] const Answer& solved_tailgate();

/// examples/hood_hinge.json, a direction of travel and two poses, and its answer on a small region.
[[nodiscard]] const Problem& hood_hinge();
[[nodiscard]] const Answer& solved_hood_hinge();

/// One of examples/, with a small region.
[[nodiscard]] Problem example(const std::string& name, int region_samples);

/// examples/latch.json: three positions and both grounded links; examples/nose_gear.json: five positions;
/// examples/sine_generator.json: a function on four precision points. With their answers on small regions.
struct Solved {
  Problem problem;
  Answer answer;
};
[[nodiscard]] const Solved& three_positions();
[[nodiscard]] const Solved& five_positions();
[[nodiscard]] const Solved& function();

/// Five positions that no four-bar free of defects passes, and what freeing one of them comes to.
[[nodiscard]] const Solved& five_without_answer();

/// A problem from its text.
[[nodiscard]] Problem problem_from(const std::string& text);

/// The problem with other poses: x, y, degrees.
[[nodiscard]] Problem problem_of(const std::vector<std::array<double, 3>>& poses);
[[nodiscard]] Answer answer_of(const Problem& problem);

/// An answer that is one of four-bars.
[[nodiscard]] const FourBarAnswer& four_bars(const Answer& answer);

/// The task of a problem that is one of motion generation by a four-bar.
inline MotionTask& motion(Problem& problem) { return std::get<MotionTask>(problem.task); }
inline const MotionTask& motion(const Problem& problem) { return std::get<MotionTask>(problem.task); }

}  // namespace linkwright::testing
