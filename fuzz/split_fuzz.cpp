// SPDX-License-Identifier: MIT
// Property of split: for any few triangles on a grid the tree obeys its laws: leaves partition the
// triangles and are connected, the most concave one is always split, by a plane beyond which the
// moved triangles lie, and each status is true. A run for fewer parts makes the first of these
// splits. For rare inputs the whole tree is compared with the one that the definitions give.
#include "convexact/cluster.hpp"
#include "decompose/patch.hpp"
#include "definitional_tree.hpp"
#include "few_triangles.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "split_laws.hpp"

using namespace convexact;

namespace {

SplitOptions options_of(FuzzInput& in) {
  constexpr std::array kLimits{0, 1, 3, 10, 30, 100};
  SplitOptions options;
  options.limit.value = Rational(kLimits[in.below(kLimits.size())], 100);
  options.limit.is_share = in.below(4) != 0;
  options.bridge =
      std::array{BridgeChoice::Farther, BridgeChoice::Region, BridgeChoice::Nearer}[in.below(3)];
  options.connect = std::array{Connect::Edge, Connect::Overlap, Connect::Touching}[in.below(3)];
  options.coplanar = Rational(1 + in.below(100), 100);
  return options;
}

void check(const std::string& broken) {
  if (!broken.empty()) std::fprintf(stderr, "%s\n", broken.c_str());
  FUZZ_CHECK(broken.empty());
}

void split_few(FuzzInput& in) {
  const Mesh mesh = few_triangles(in);
  if (mesh.polygons.empty()) return;
  const Surface surface = make_surface(mesh);
  SplitOptions options = options_of(in);
  const bool is_defined = in.rarely();
  const std::size_t fewer = in.below(8);
  const SplitTree made = split(surface, options);
  check(support::SplitLaws(surface, options, made).broken());
  if (is_defined) {
    const long exponent = NearSurface(surface).frame.exponent;
    definition::SplitReplay replay(surface, options, exponent, made.united);
    check(support::difference_in_place(made, replay.run()));
  }
  if (fewer >= made.splits.size()) return;
  options.max_parts = made.roots + fewer;
  const SplitTree first = split(surface, options);
  check(support::SplitLaws(surface, options, first).broken());
  FUZZ_CHECK(first.splits.size() == fewer);
  for (std::size_t k = 0; k < fewer; ++k) {
    FUZZ_CHECK(first.splits[k].plane == made.splits[k].plane);
    FUZZ_CHECK(first.splits[k].moved == made.splits[k].moved);
  }
}

const FuzzTarget kSplit("split", split_few);

}  // namespace
