// The program `linkwright`: reads files, calls the library, prints for people or writes files; serves the workbench.

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <string>

#include "attitude_flags.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "sweep_command.hpp"

namespace linkwright::cli {
namespace {

void add_solve(CLI::App& app, SolveArguments& arguments) {
  CLI::App* command = app.add_subcommand("solve", "Find all linkages that do a task, and the best of them");
  command->add_option("PROBLEM", arguments.problem, "Problem file (JSON; - reads standard input)")->required();
  command->add_option("-o,--output", arguments.result, "Write the result as JSON to this file (- for standard output)");
  command->add_option("--svg", arguments.picture, "Draw the solution to this SVG file");
  command->add_flag("--region", arguments.with_region, "Write the arrays of the solution region into the result, too");
  command->add_option("--samples", arguments.samples,
                      "Samples per axis of the solution region (overrides options.region_samples)");
}

/// Flags of `analyze --instant`.
void add_instant(CLI::App& command, AnalyzeArguments& arguments) {
  CLI::Option* instant = command.add_flag(
      "--instant", arguments.instant,
      "What one instant of the coupler tells, too: pole, inflection circle, stationary curvature, Ball's point, "
      "Burmester points; also of a problem file with one pose and its derivatives");
  command.add_option("--input-deg", arguments.input_deg, "Turn the input to this angle from the ground link first")
      ->needs(instant);
  command
      .add_option("--point", arguments.point,
                  "A point x,y of the coupler as the linkage lies in the file (default: the file's point, if any)")
      ->delimiter(',')
      ->expected(2);
  command
      .add_option("--input-acceleration", arguments.input_acceleration,
                  "Angular acceleration of the input over its squared angular velocity (default 0)")
      ->needs(instant);
  command.add_option("--svg", arguments.picture, "Draw the instant, or what is compared, to this SVG file");
}

/// Flags of `analyze --compare`.
void add_comparison(CLI::App& command, AnalyzeArguments& arguments) {
  CLI::Option* compared = command.add_option(
      "--compare", arguments.compared,
      "How near the path of the point comes to those of FILE: a problem with a path, a table x,y as FILE.csv, or a "
      "drawing, FILE.dxf or FILE.svg; or the body to poses: a problem of a motion, or a table x,y,theta_deg");
  command.add_flag("--closed", arguments.closed, "The points of the table are those of a closed path")->needs(compared);
  command
      .add_option("--body", arguments.body,
                  "Where the body compared with poses is as the linkage lies in the file, x,y,theta_deg (default: the "
                  "first of the file's poses)")
      ->delimiter(',')
      ->expected(3)
      ->needs(compared);
}

void add_analyze(CLI::App& app, AnalyzeArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("analyze", "Type, input ranges, dead points and transmission angles of one linkage");
  command
      ->add_option("LINKAGE", arguments.linkage,
                   "Linkage file (JSON: pivots, lengths, axes, angles, or an exported linkage)")
      ->required();
  command->add_option("--drive", arguments.drive, "Which grounded link drives: input (default) or output")
      ->check(CLI::IsMember({"input", "output"}));
  command->add_option("-o,--output", arguments.report,
                      "Write the analysis to FILE.json or the motion to FILE.csv (- for JSON on standard output)");
  add_instant(*command, arguments);
  add_comparison(*command, arguments);
}

/// Flags of `export` for what is built; lengths in the file's unit.
void add_machine(CLI::App& command, MachineWishes& wishes) {
  const auto above_zero = CLI::Validator(
      [](const std::string& text) {
        double value = 0;
        const bool is_number = CLI::detail::lexical_cast(text, value);
        return is_number && value > 0 ? "" : fmt::format("{} is not a number above 0", in_quotes(text));
      },
      "");
  const auto size = [&](const char* flag, double& value, const char* help) {
    command.add_option(flag, value, help)->check(above_zero);
  };
  size("--width", wishes.sizes.width, "Width of the plates (default: 12 % of the longest link, or less)");
  size("--thickness", wishes.sizes.thickness, "Thickness of the plates (default: 6 % of the longest link)");
  size("--gap", wishes.sizes.gap, "Gap between plates (default: a tenth of the thickness)");
  size("--pin", wishes.sizes.pin, "Diameter of the pins (default: 5 % of the longest link, or less)");
  command
      .add_option("--clearance", wishes.sizes.clearance, "How much wider holes are than pins (default: 2 % of the pin)")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return text.starts_with('-') ? fmt::format("{} is below 0", in_quotes(text)) : std::string();
          },
          ""));
  size("--radius", wishes.sizes.radius, "Radius of the outermost sphere of a spherical linkage (default: 100)");
  command
      .add_option_function<double>(
          "--density", [&wishes](double density) { wishes.density = density; },
          "Density for simulators, kg/m³ (default: 7850, steel)")
      ->check(above_zero);
  command.add_option_function<int>(
      "--position", [&wishes](int position) { wishes.position = position - 1; },
      "Position of the task, from 1, in which a STEP file shows the linkage (default: 1)");
}

void add_export(CLI::App& app, ExportArguments& arguments) {
  CLI::App* command = app.add_subcommand("export", "Export one linkage as a drawing, a table or a model");
  command->add_option("FILE", arguments.result, "Result file written by solve -o, or file of one linkage")->required();
  command->add_option("--linkage", arguments.linkage, "Which linkage of the result, from 1 (default 1, the best)");
  std::vector<std::string> formats = {"svg", "dxf", "csv", "json"};
  formats.insert(formats.end(), machine_formats().begin(), machine_formats().end());
  command
      ->add_option(
          "--format", arguments.format,
          "svg, dxf (a drawing of a linkage of the plane), csv (its motion), json; as plates and pins in layers "
          "that do not collide: step (an assembly), stl or 3mf (to print), plates (DXF, to cut), "
          "mjcf, sdf or urdf (for simulators)")
      ->required()
      ->check(CLI::IsMember(formats));
  command->add_option("-o,--output", arguments.output, "Output file (default: standard output)");
  add_machine(*command, arguments.machine);
}

void add_outline(CLI::App& app, OutlineArguments& arguments) {
  CLI::App* command = app.add_subcommand("outline",
                                         "Put a shape of a drawing, or a table of points, into a problem file: as the "
                                         "outline of its body, or as its path");
  command
      ->add_option("DRAWING", arguments.drawing,
                   "Drawing of another program: FILE.dxf (ASCII) or FILE.svg; or points as FILE.csv")
      ->required();
  command->add_option("PROBLEM", arguments.problem, "Problem file (JSON; - reads standard input)")->required();
  command->add_option("-o,--output", arguments.output,
                      "Write the problem with the outline to this file (default: standard output)");
  command->add_option("--shape", arguments.shape,
                      "Which of the drawing's shapes, from 1 (default 1, the largest part)");
  CLI::Option* unit = command->add_option("--unit", arguments.unit,
                                          "Unit of the drawing, as mm, cm, m, in or ft (default: as it says)");
  command
      ->add_option(
          "--scale", arguments.scale,
          "Lengths of the problem to a unit of the drawing (default: from the two units; a shape of quite another "
          "size is brought to the task's)")
      ->excludes(unit);
  command
      ->add_option(
          "--at", arguments.at,
          "x,y,degrees of the drawing's origin in the moving frame (default 0,0,0 where it lies in or near the "
          "shape, else the shape's middle is the frame's origin); of a path in the fixed frame (default 0,0,0)")
      ->delimiter(',')
      ->expected(3);
  command->add_option("--points", arguments.points,
                      "Of a path: how many points are laid along the shape (default 48; of a table its own)");
}

void add_tolerance(CLI::App& app, ToleranceArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "tolerance", "What tolerances do to one linkage of a result: error, yield, what to tighten and what to loosen");
  command->add_option("RESULT", arguments.result, "Result file written by solve -o")->required();
  command->add_option("--linkage", arguments.linkage, "Which linkage of the result, from 1 (default 1, the best)");
  command->add_option("--length", arguments.length,
                      "Half tolerance of all lengths (default: the \"tolerances\" of the result's problem)");
  command->add_option("--samples", arguments.samples, "How many linkages are sampled (default 100000)");
  command->add_option("--seed", arguments.seed, "Seed of the samples: the same one gives the same answer (default 1)");
  command->add_option("-o,--output", arguments.report, "Write everything as JSON to this file (- for standard output)");
  command->add_option("--svg", arguments.picture,
                      "Draw the errors of the samples in each position and what contributes to them to this SVG file");
}

void add_loads(CLI::App& app, LoadsArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "loads", "The forces in one linkage of a result: hand, springs, pins, what holds it and when it moves by itself");
  command->add_option("RESULT", arguments.result, "Result file written by solve -o")->required();
  command->add_option("--linkage", arguments.linkage, "Which linkage of the result, from 1 (default 1, the best)");
  command->add_option("--case", arguments.of_case, "One of the cases of its loads (default: all)");
  command->add_flag("--balance", arguments.balance,
                    "Also tell the springs or counterweights by which it would rest anywhere, and the springs with a "
                    "free length that come nearest to that");
  command->add_option("--free-share", arguments.free_share,
                      "The free length of these, by the shortest that they get (0 to 1; default 0.75)");
  CLI::Option* boxes = command->add_option(
      "--place-springs", arguments.boxes,
      "Place the gas spring of this file, its studs within the file's boxes, where the hand needs the least force");
  command->add_option("--catalogue", arguments.catalogue, "Rank the gas springs of this file in the same boxes")
      ->needs(boxes);
  command->add_option("-o,--output", arguments.output,
                      "Write the curves as a table (.csv), as a picture (.svg), or the report (.json, - for standard "
                      "output); of springs placed the report");
}

/// One of the commands of `attitude`; its flags are those of the table.
void add_attitude_command(CLI::App& app, const std::string& name, const std::string& help, bool with_picture,
                          AttitudeArguments& arguments) {
  CLI::App* command = app.add_subcommand(name, help);
  command->callback([&arguments, name] { arguments.command = name; });
  command->add_option("IN", arguments.input, "JSON file (- reads standard input), instead of the flags below");
  command->add_option("-o,--output", arguments.report, "Write everything as JSON to this file (- for standard output)");
  if (with_picture) command->add_option("--svg", arguments.picture, "Draw it to this SVG file");
  for (const AttitudeFlag& flag : attitude_flags(name)) {
    const std::string key(flag.name);
    if (flag.content == FlagContent::set) {
      command->add_flag_callback(
          key, [&arguments, key] { arguments.flags[key]; }, std::string(flag.help));
      continue;
    }
    const auto keep = [&arguments, key](const CLI::results_t& values) {
      arguments.flags[key] = values;
      return true;
    };
    CLI::Option* option = command->add_option(key, keep, std::string(flag.help));
    option->type_name(std::string(flag.shape))->type_size(flag.content == FlagContent::sequence ? 2 : 1);
    if (may_repeat(flag.content)) option->take_all()->allow_extra_args(false);
  }
}

void add_attitude(CLI::App& app, AttitudeArguments& arguments) {
  CLI::App* group =
      app.add_subcommand("attitude", "Rotations and displacements of a rigid body in every representation");
  group->require_subcommand(1);
  add_attitude_command(*group, "convert", "An orientation in every representation, drawn on request", true, arguments);
  add_attitude_command(*group, "screw", "A displacement as a screw and back, drawn on request", true, arguments);
  add_attitude_command(*group, "twist", "The instantaneous screw of a moving body, and back to velocities", false,
                       arguments);
  add_attitude_command(*group, "rates", "Angular velocity and acceleration from derivatives or rates, and back", false,
                       arguments);
  add_attitude_command(*group, "dh", "A chain of links by Hartenberg-Denavit parameters", false, arguments);
}

void add_studio(CLI::App& app, StudioArguments& arguments) {
  CLI::App* command = app.add_subcommand("studio", "Serve the workbench to a browser on this machine");
  command->add_option("--port", arguments.port, "Port on 127.0.0.1 (0: any free one; default 4180, or any free one)")
      ->check(CLI::Range(0, 65535));
  command->add_option("--folder", arguments.folder, "Serve this built workbench instead of the installed one");
}

int run(int argc, char** argv) {
  CLI::App app(
      "Linkwright finds linkages: all four-bars that guide a body through given poses, in one solution region.",
      "linkwright");
  app.set_version_flag("--version", "linkwright " LINKWRIGHT_VERSION);
  app.require_subcommand(0, 1);
  SolveArguments solve_arguments;
  AnalyzeArguments analyze_arguments;
  ExportArguments export_arguments;
  OutlineArguments outline_arguments;
  ToleranceArguments tolerance_arguments;
  LoadsArguments loads_arguments;
  AttitudeArguments attitude_arguments;
  SweepArguments sweep_arguments;
  StudioArguments studio_arguments;
  add_solve(app, solve_arguments);
  add_analyze(app, analyze_arguments);
  add_export(app, export_arguments);
  add_outline(app, outline_arguments);
  add_tolerance(app, tolerance_arguments);
  add_loads(app, loads_arguments);
  add_attitude(app, attitude_arguments);
  add_sweep(app, sweep_arguments);
  add_studio(app, studio_arguments);
  if (const auto status = parse(app, argc, argv)) return *status;
  if (app.got_subcommand("solve")) return solve(solve_arguments);
  if (app.got_subcommand("analyze")) return analyze(analyze_arguments);
  if (app.got_subcommand("export")) return export_linkage(export_arguments);
  if (app.got_subcommand("outline")) return outline(outline_arguments);
  if (app.got_subcommand("tolerance")) return tolerance(tolerance_arguments);
  if (app.got_subcommand("loads")) return loads(loads_arguments);
  if (app.got_subcommand("attitude")) return attitude(attitude_arguments);
  if (app.got_subcommand("sweep")) {
    ThreadsHere threads;
    return sweep(sweep_arguments, threads);
  }
  if (app.got_subcommand("studio")) return studio(studio_arguments);
  std::fputs(app.help().c_str(), stderr);
  return mistake;
}

}  // namespace
}  // namespace linkwright::cli

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that must not grow is a full disk
  return linkwright::cli::guarded([&] { return linkwright::cli::run(argc, argv); });
}
