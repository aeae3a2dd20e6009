#include "sweep_file.hpp"

namespace linkwright {
namespace {

Error no_hdf5() {
  return {"no_hdf5", "",
          "this program was built without HDF5, which sweeps are kept in; install libhdf5-dev and build it anew"};
}

}  // namespace

std::optional<Error> missing_sweep_files() { return no_hdf5(); }

std::optional<Error> write_sweep_file(const std::filesystem::path& /*output*/, const SweepPlan& /*plan*/,
                                      SweepFolder& /*folder*/) {
  return no_hdf5();
}

Result<SweepFileHead> read_sweep_head(const std::filesystem::path& /*path*/) { return no_hdf5(); }

bool is_head_of(const SweepFileHead& /*head*/, const SweepPlan& /*plan*/) { return false; }

Result<SweepFileSummary> summarize_sweep_file(const std::filesystem::path& /*path*/) { return no_hdf5(); }

}  // namespace linkwright
