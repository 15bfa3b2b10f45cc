// SPDX-License-Identifier: MIT
// Property of implicit: the reader takes any bytes and either reads a shape or refuses them with an
// Error of exit code 3. For a shape that was read, the interval of a value in doubles meets that in
// more bits.
#include "convexact/implicit.hpp"
#include "fuzz_target.hpp"
#include "unless_refused.hpp"

using namespace convexact;

namespace {

void hold_implicit(FuzzInput& in) {
  const auto shape = unless_refused([&, bytes = in.rest()] { return read_implicit_bytes(bytes); });
  if (!shape) return;
  const Point x(0.25, -0.5, 1);
  const ImplicitRange range = enclose_value(*shape, x);
  const Enclosure exact = enclose_value(*shape, to_rational(x), 128);
  FUZZ_CHECK(range.low <= exact.high_double() && exact.low_double() <= range.high);
}

const FuzzTarget kImplicit("implicit", hold_implicit);

}  // namespace
