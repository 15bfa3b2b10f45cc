// SPDX-License-Identifier: MIT
// cddlib.hpp - cddlib with rational numbers, for the tests against it.
#pragma once
#define GMPRATIONAL
#include <cddlib/setoper.h>
// cddlib wants setoper.h first.
#include <cddlib/cdd.h>

#include "convexact/number.hpp"

namespace convexact {

struct CddGlobals {
  CddGlobals() { dd_set_global_constants(); }
  ~CddGlobals() { dd_free_global_constants(); }
  CddGlobals(const CddGlobals&) = delete;
  CddGlobals& operator=(const CddGlobals&) = delete;
};

inline Rational to_rational(const mpq_t& x) {
  Rational q;
  mpq_set(q.backend().data(), x);
  return q;
}

}  // namespace convexact
