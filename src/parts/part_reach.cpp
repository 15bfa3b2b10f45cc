// SPDX-License-Identifier: MIT
#include "parts/part_reach.hpp"

#include "convexact/error.hpp"
#include "parts/part_volumes.hpp"

namespace convexact {
namespace {

using Farther = DecompositionReach::Farther;

// Those that have a volume outside of the solid. `farther` are those that cells do not prove to be
// inside.
std::vector<Farther> farther_than_zero(const Decomposition& made,
                                       const std::vector<ConvexPart>& stored,
                                       std::vector<Farther> farther, std::size_t jobs,
                                       const StageWatch& quiet, const Watch& watch) {
  const Rational most = made.squared_diameter() * 4 * kLeastReach * kLeastReach;
  std::vector<Farther> beyond = std::move(farther);
  std::erase_if(beyond, [](const Farther& x) { return x.reach.reach != Reach::Beyond; });
  farther.clear();
  if (beyond.empty() && exact_excess(made.surface, stored, quiet, jobs) == Rational(0))
    return farther;
  auto next = beyond.begin();
  for (std::size_t k = 0; k < stored.size(); ++k) {
    watch.at(k, stored.size());
    if (next != beyond.end() && next->part == k) {
      farther.push_back(std::move(*next++));
    } else if (exact_excess(made.surface, {stored[k]}, quiet, jobs) != Rational(0)) {
      farther.push_back({k, {Reach::Undecided, {}, SquaredBracket{Rational(0), most}}});
    }
  }
  return farther;
}

}  // namespace

void require_told(const Rational& squared_share, bool is_closed) {
  if (squared_share > 0 && squared_share < kLeastReach * kLeastReach) {
    throw Error(ErrorCode::InvalidArgument,
                "a distance of less than 2^-20 of the diameter, about a millionth, cannot be told "
                "by cells: allow more, or 0 with the method cut");
  }
  if (squared_share == 0 && !is_closed) {
    throw Error(ErrorCode::InvalidArgument,
                "an open surface bounds no solid that its parts could fill: allow a distance "
                "above 0");
  }
}

std::vector<Farther> farther_parts(const Decomposition& made, const std::vector<ConvexPart>& stored,
                                   ReachLimit& limit, std::size_t jobs, const StageWatch& quiet,
                                   const Watch& watch) {
  std::vector<Farther> farther;
  const std::vector<bool> allowed = limit.allows_each(stored, jobs, watch);
  for (std::size_t k = 0; k < stored.size(); ++k) {
    if (allowed[k]) continue;
    watch.ask();
    PartReach reach = limit(stored[k], watch);
    if (reach.reach != Reach::Within) farther.push_back({k, std::move(reach)});
  }
  if (made.reach->squared_distance > 0) return farther;
  return farther_than_zero(made, stored, std::move(farther), jobs, quiet, watch);
}

}  // namespace convexact
