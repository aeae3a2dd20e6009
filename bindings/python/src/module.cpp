#include "bindings.hpp"

PYBIND11_MODULE(_linkwright, module) {
  using namespace linkwright::python;
  module.doc() = "The compiled half of linkwright: use the package.";
  module.attr("version") = LINKWRIGHT_VERSION;
  bind_mistakes(module);
  bind_vocabulary(module);
  bind_solving(module);
  bind_linkages(module);
  bind_attitude(module);
  bind_session(module);
  bind_sweeps(module);
}
