#pragma once

#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/analyses/load_study.hpp"
#include "linkwright/analyses/spring_places.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/analysis_file.hpp"
#include "linkwright/files/angular_motion_file.hpp"
#include "linkwright/files/displacement_file.hpp"
#include "linkwright/files/link_chain_file.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/orientation_file.hpp"
#include "linkwright/files/position_error.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/files/spherical_file.hpp"
#include "linkwright/files/twist_file.hpp"
#include "linkwright/mechanism/drive_table.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/planar/four_bar_solution.hpp"
#include "linkwright/sweep/sweep_plan.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "sweep_file.hpp"
#include "text_table.hpp"

namespace linkwright::cli {

/// What was found, in words and tables for people, at most 100 columns wide.
[[nodiscard]] std::string report(const Problem& problem, const Answer& answer);

/// How near a path comes to points, or a body to poses, in words for people.
[[nodiscard]] std::string comparison_words(const PathComparison& comparison, const std::string& length_unit);
[[nodiscard]] std::string comparison_words(const PoseComparison& comparison, const std::string& length_unit);

/// What one instant tells, in words for people.
[[nodiscard]] std::string instant_words(const LinkageAnalysis& analysis);
[[nodiscard]] std::string instant_words(const PrescribedInstant& instant);

/// What report() says of a straight line below its heading.
[[nodiscard]] std::string straight_line_report(const Problem& problem, const StraightLineAnswer& answer);

/// The analysis of one linkage in words for people; `drive`: which of the file's grounded links is the input.
[[nodiscard]] std::string linkage_words(const LinkageAnalysis& analysis, std::string_view drive);

/// What varies and how, how many samples, the first of them.
[[nodiscard]] std::string report_plan(const SweepPlan& plan);

/// What is in a table: where from, its columns with units and ranges, how many samples came to what.
[[nodiscard]] std::string report_sweep_file(const SweepFileSummary& summary);

/// What was searched and what was found for a six-bar's task, in words and tables, at most 100 columns wide; title and
/// unit of `problem` are printable.
[[nodiscard]] std::string six_bar_report(const Problem& problem, const SixBarAnswer& answer);

/// The analysis of one six-bar in words for people.
[[nodiscard]] std::string six_bar_words(const StoredSixBarAnalysis& analysis);

/// What positions of its file a linkage misses, in a paragraph; or nothing.
[[nodiscard]] inline std::string missed_words(AnyStoredLinkage linkage) {
  std::visit([](auto& stored) { stored.length_unit = printable(stored.length_unit); }, linkage);
  std::string words = position_error_words(linkage);
  if (words.empty()) return "";
  words.front() = 'A';
  return wrapped(words + ".");
}

// Reports of `linkwright attitude` in words and tables for people; angles in degrees, at most 100 columns wide.

[[nodiscard]] std::string orientation_words(const OrientationReport& report);
[[nodiscard]] std::string displacement_words(const DisplacementReport& report);
[[nodiscard]] std::string twist_words(const TwistReport& report);
[[nodiscard]] std::string angular_motion_words(const AngularMotionReport& report);
[[nodiscard]] std::string link_chain_words(const LinkChainReport& report);

/// How well the linkages listed generate the function, a row to each; empty for other tasks.
[[nodiscard]] std::string function_error_words(const FourBarAnswer& answer);
[[nodiscard]] std::string function_error_words(const SphericalAnswer& answer);

/// "the output stands right at every pair to 2e-14°".
[[nodiscard]] std::string precision_words(const FourBarAnswer& answer);
[[nodiscard]] std::string precision_words(const SphericalAnswer& answer);

/// Where the linkages of a function lie that are counted.
[[nodiscard]] std::string function_map_words(const LinkageFamily& family, const RegionMap& map);
/// What a task of a function leaves open.
[[nodiscard]] std::string function_free_words(const LinkageFamily* family, const WantedFunction& wanted);

/// Five positions: the table of grounded links. Empty for other tasks.
[[nodiscard]] std::string dyad_words(const FourBarAnswer& answer);

/// Paths of five positions: the table of cranks. Empty for others.
[[nodiscard]] std::string crank_words(const PathAnswer& answer);

/// How the linkages listed lead the point, a row to each; empty where none is.
[[nodiscard]] std::string path_table(const Problem& problem, const PathAnswer& answer);
/// How near linkages carry their body to near poses; empty without such.
[[nodiscard]] std::string near_table(const Problem& problem, const MotionAnswer& answer);

/// Five positions: every pair as a four-bar, and why it fails; five precision points: every linkage. Empty for others.
[[nodiscard]] std::string pair_words(const FourBarAnswer& answer, std::string_view heading);

/// Five positions with one freed: what the linkages miss it by. Empty for other tasks.
[[nodiscard]] std::string pose_error_words(const Problem& problem, const FourBarAnswer& answer);

/// What freeing one of five positions comes to; empty where nothing was tried.
[[nodiscard]] std::string ways_out_words(const Problem& problem, const MotionAnswer& answer);

// Cells of tables of four-bars.

/// Least transmission angle over the task, "–" with a defect.
[[nodiscard]] std::string task_gamma(const DefectReport& report);

/// Over the full turn of a crank, "–" for others.
[[nodiscard]] std::string full_turn_gamma(const DefectReport& report);

/// The sense in which it is driven, or the defect that forbids it.
[[nodiscard]] std::string drive_text(const DefectReport& report);

/// Longest over shortest link, ground, input, coupler, output.
[[nodiscard]] std::vector<std::string> length_cells(const LinkLengths& lengths, int decimals);

/// "x, y".
[[nodiscard]] std::string pivot_text(Point pivot, int decimals);

/// Decimals for the lengths of all of them.
[[nodiscard]] int decimals_for(const std::vector<FourBarSolution>& linkages);

/// What is found for a task of spherical four-bars, for people; `problem` with printable text.
[[nodiscard]] std::string spherical_report(const Problem& problem, const SphericalMotionAnswer& answer);

/// Type, drive and angles of linkages, numbered from 1.
[[nodiscard]] std::string spherical_table(const std::vector<SphericalSolution>& all);

/// The analysis of one spherical four-bar in words for people; `drive`: which of the file's grounded links is the
/// input.
[[nodiscard]] std::string spherical_words(const StoredSphericalAnalysis& analysis, std::string_view drive);

/// The counts of the map, the linkages listed with their angles, and how well each generates the function.
[[nodiscard]] std::string spherical_function_report(const Problem& problem, const SphericalFunctionAnswer& answer);

/// The forces in the linkages listed, a row to each; empty without loads.
[[nodiscard]] std::string loads_table(const Findings& found);
/// What ranks a linkage listed by loads.
[[nodiscard]] std::optional<std::string> load_score(const Findings& found, std::size_t place);
/// What loads do to one linkage: tables of cases by read-outs, of pins and of springs, and where it rests.
[[nodiscard]] std::string load_words(const LoadStudy& study);
/// What would hold it at rest anywhere: springs of no free length, counterweights.
[[nodiscard]] std::string balance_words(const LoadStudy& study);
/// A spring that was placed, what is proven, and the parts of a catalogue; or why there is none.
[[nodiscard]] std::string spring_words(const PlacedSpring& placed);

/// What tolerances do to the linkages listed, a row to each; empty without tolerances.
[[nodiscard]] std::string tolerance_table(const Problem& problem, const Findings& found);

/// "Linkages that no other beats in both …", the heading of a front; nothing where none is asked for.
[[nodiscard]] std::optional<std::string> front_heading(const Findings& found);

/// "Best linkages, smallest link ratio first:", the heading of a list by an objective.
[[nodiscard]] std::string best_heading(std::string_view what, Objective objective);

/// "0.662 mm", "99.8 %": the score of a linkage listed; nothing where no analysis ranks them.
[[nodiscard]] std::optional<std::string> analysis_score(const Findings& found, std::size_t place,
                                                        std::string_view unit);

/// Of one linkage, for a designer: error, yield, what contributes what, what to tighten and what to loosen.
/// `place`: among the linkages listed; it has a report.
[[nodiscard]] std::string tolerance_words(const Problem& problem, const Findings& found, std::size_t place);

/// "x −450…60, y −220…−30".
[[nodiscard]] std::string box_words(const Box& box);
/// "30° of (0, 0, 1)".
[[nodiscard]] std::string cone_words(const Cone& cone);

/// The requirements of the class in plain words, "no defects, transmission angle at least 30°, …". `position`: in which
/// the moving pivots are told, from 1.
[[nodiscard]] std::string requirement_words(const Requirements& requirements, const LinkageClass& asked,
                                            std::string_view unit, int position = 1);

/// The limits at which a linkage lies (to half a percent), in words.
[[nodiscard]] std::vector<std::string> limits_touched(const Requirements& requirements, const FourBarSolution& found,
                                                      std::string_view unit);

/// Of a six-bar; `search`: the box in which its hinges were looked for.
[[nodiscard]] std::vector<std::string> limits_touched(const Requirements& requirements, const SixBarSolution& found,
                                                      const std::optional<Box>& search, std::string_view unit);

/// Of a spherical four-bar.
[[nodiscard]] std::vector<std::string> limits_touched(const Requirements& requirements, const SphericalSolution& found);

/// "touches no limit: …", or at which it lies.
[[nodiscard]] std::string held_back_words(const std::vector<std::string>& limits);

/// "a transmission angle of at least 24° would leave 112", or what dropping the requirement would.
[[nodiscard]] std::string relaxation_words(const Relaxation& relaxation, std::string_view unit);

/// The transmission angle of a planar or spherical four-bar that was analysed: as it lies, and where it is least over a
/// crank's full turn (`least`, radians) or largest between dead points.
template <class Analysis>
[[nodiscard]] std::string transmission_words(const Analysis& analysis, double least) {
  std::string text =
      fmt::format("Transmission angle in the position given: {}", angle_text(analysis.transmission_angle));
  if (input_is_crank(analysis.type)) {
    text += fmt::format("; minimum over a full turn: {}", angle_text(least));
  } else if (!analysis.motion.empty()) {
    const TransmissionPeak& peak = analysis.largest_transmission;
    text += fmt::format("; it is 0 at the dead points and largest, {}, at input angle {}", angle_text(peak.angle),
                        angle_text(wrap_signed(peak.input_angle)));
  }
  return wrapped(text + ".");
}

}  // namespace linkwright::cli
