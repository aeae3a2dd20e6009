#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "console.hpp"
#include "linkwright/files/analysis_file.hpp"
#include "linkwright/machine/machine_export.hpp"

namespace linkwright::cli {

struct SolveArguments {
  std::string problem;  ///< path, or "-" for standard input
  std::string result;   ///< path, "-" for standard output, or empty
  std::string picture;  ///< path or empty
  bool with_region = false;
  std::optional<int> samples;  ///< nothing: as the problem says
};
[[nodiscard]] int solve(const SolveArguments& arguments);

struct AnalyzeArguments {
  std::string linkage;
  std::string drive = "input";      ///< input or output
  std::string report;               ///< path ending in .json or .csv, "-" for JSON on standard output, or empty
  bool instant = false;             ///< what follows belongs to it
  std::optional<double> input_deg;  ///< from the ground link
  std::vector<double> point;        ///< x and y, or empty
  std::optional<double> input_acceleration;
  std::string picture;       ///< path or empty
  std::string compared;      ///< path of a problem, a table of points or of poses, or a drawing; or empty
  std::vector<double> body;  ///< x, y and degrees of what is compared with poses, as the linkage lies; or empty
  bool closed = false;       ///< that path
};
[[nodiscard]] int analyze(const AnalyzeArguments& arguments);
/// What analyze() does with `compared`; the linkage is driven by its input.
[[nodiscard]] int compare(const StoredLinkage& linkage, const AnalyzeArguments& arguments);

struct ExportArguments {
  std::string result;
  int linkage = 1;     ///< from 1
  std::string format;  ///< svg, dxf, csv, json, or one of machine_formats()
  MachineWishes machine;
  std::string output = "-";
};
[[nodiscard]] int export_linkage(const ExportArguments& arguments);

struct OutlineArguments {
  std::string drawing;  ///< path ending in .dxf, .svg or .csv
  std::string problem;  ///< path, or "-" for standard input
  std::string output = "-";
  int shape = 1;                ///< from 1, in the order of the list that is printed
  std::string unit;             ///< of the drawing; empty: what it says itself
  std::optional<double> scale;  ///< lengths of the problem to the drawing's unit
  std::vector<double> at;       ///< x, y and degrees of the drawing's origin in the moving frame, or empty
  std::optional<int> points;    ///< along a path; nothing: those of a table, or 48
};
[[nodiscard]] int outline(const OutlineArguments& arguments);

struct ToleranceArguments {
  std::string result;            ///< path
  int linkage = 1;               ///< from 1
  std::optional<double> length;  ///< half tolerance of all lengths, instead of the file's
  std::optional<int> samples;
  std::optional<std::int64_t> seed;
  std::string report;   ///< path, "-" for standard output, or empty
  std::string picture;  ///< path or empty
};
[[nodiscard]] int tolerance(const ToleranceArguments& arguments);

struct LoadsArguments {
  std::string result;                ///< path
  int linkage = 1;                   ///< from 1
  std::string of_case;               ///< one of the cases; empty: all
  bool balance = false;              ///< also told: what would hold it at rest anywhere
  std::optional<double> free_share;  ///< of real springs of that balance
  std::string boxes;                 ///< of springs to be placed: path, or empty
  std::string catalogue;             ///< of parts for them: path, or empty
  std::string output;                ///< path ending in .csv, .svg or .json, "-" for JSON on standard output, or empty
};
[[nodiscard]] int loads(const LoadsArguments& arguments);

struct AttitudeArguments {
  std::string command;  ///< convert, screw, twist, rates or dh
  std::string input;    ///< path, "-" for standard input, or empty when flags say it
  std::string report;   ///< path, "-" for standard output, or empty
  std::string picture;  ///< path or empty; of convert and screw
  std::map<std::string, std::vector<std::string>>
      flags;  ///< those of attitude_flags() that were given, with their values
};
[[nodiscard]] int attitude(const AttitudeArguments& arguments);

struct StudioArguments {
  std::optional<int> port;  ///< 0: any free one; nothing: the usual one, or any free one
  std::string folder;       ///< of the built workbench; empty: where the program was installed or built
};
[[nodiscard]] int studio(const StudioArguments& arguments);

}  // namespace linkwright::cli
