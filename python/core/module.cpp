// SPDX-License-Identifier: MIT
// convexact._core: the library as Python calls it. The package around it gives names, defaults and
// shapes; nothing is decided there.
#include "bindings.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace convexact::python;
  add_errors(module);
  add_hulls(module);
  add_verdicts(module);
  add_parts(module);
  add_queries(module);
}
