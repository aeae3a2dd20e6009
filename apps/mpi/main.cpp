// The program `linkwright-mpi`: `linkwright sweep` by many processes, for mpirun and srun.

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <mpi.h>
#include <string>

#include "command_line.hpp"
#include "console.hpp"
#include "rank_team.hpp"
#include "sweep_command.hpp"

namespace linkwright {
namespace {

/// MPI as long as it lives.
class MpiSession {
 public:
  MpiSession(int* argc, char*** argv) {
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(argc, argv, MPI_THREAD_SERIALIZED, &provided);
    if (provided >= MPI_THREAD_SERIALIZED) return;
    cli::print_failure("this MPI knows no threads (MPI_THREAD_SERIALIZED), which linkwright-mpi needs");
    MPI_Abort(MPI_COMM_WORLD, cli::failure);
  }
  ~MpiSession() { MPI_Finalize(); }
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

int lead(int argc, char** argv, RankTeam& team) {
  CLI::App app("Sweeps of Linkwright by many processes: mpirun -n 4 linkwright-mpi sweep SWEEP.json -o OUT.h5",
               "linkwright-mpi");
  app.set_version_flag("--version", "linkwright-mpi " LINKWRIGHT_VERSION);
  app.require_subcommand(0, 1);
  cli::SweepArguments arguments;
  cli::add_sweep(app, arguments);
  if (const auto status = cli::parse(app, argc, argv)) return *status;
  if (app.got_subcommand("sweep")) return cli::sweep(arguments, team);
  std::fputs(app.help().c_str(), stderr);
  return cli::mistake;
}

int run(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that must not grow is a full disk; mpirun resets what its caller ignores
  const MpiSession session(&argc, &argv);
  RankTeam team;
  if (team.leads()) return cli::guarded([&] { return lead(argc, argv, team); });
  team.follow();
  return 0;
}

}  // namespace
}  // namespace linkwright

int main(int argc, char** argv) { return linkwright::run(argc, argv); }
