#include <CLI/CLI.hpp>

#include "sweep_command.hpp"

namespace linkwright::cli {

void add_sweep(CLI::App& app, SweepArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("sweep", "Solve a problem for many values of its numbers, and keep the answers in one table");
  CLI::Option* sweep = command->add_option("SWEEP", arguments.sweep, "Sweep file (JSON; - reads standard input)");
  command->add_option("-o,--output", arguments.output, "Write the table to this HDF5 file")->needs(sweep);
  CLI::Option* resume = command->add_flag(
      "--resume", arguments.resumes, "Go on with a sweep that was stopped; what is done is kept beside the output");
  command->add_flag("--overwrite", arguments.overwrites, "Begin anew, whatever is there")->excludes(resume);
  command
      ->add_option("--threads", arguments.threads,
                   "Threads (default: as many as the machine has; by MPI: of each rank, its share of the node)")
      ->check(CLI::Range(1, 4096));
  command
      ->add_flag("--dry-run", arguments.is_dry, "Say how many samples there are, the first ones, and how long it takes")
      ->needs(sweep);
  command
      ->add_option("--inspect", arguments.inspected,
                   "Say what is in this table, or how far the sweep is that is to become it")
      ->excludes(sweep);
}

}  // namespace linkwright::cli
