// SPDX-License-Identifier: MIT
#include "scene/search_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/search.hpp"
#include "number/precision.hpp"
#include "search/exchange_surface.hpp"

namespace convexact {
namespace {

// The solids that the moves of a search lead to, each from its planes alone.
class SolidsOfMoves {
 public:
  SolidsOfMoves(const RunInput& input, std::vector<HalfspaceId> start,
                const std::vector<Move>& moves)
      : input_(input), start_(std::move(start)), moves_(moves) {}

  // After so many moves. @throws Error Internal if the planes do not bound it.
  Polytope after(std::size_t count) const;

 private:
  const RunInput& input_;
  const std::vector<HalfspaceId> start_;  // what the removals left
  const std::vector<Move>& moves_;
};

Polytope SolidsOfMoves::after(std::size_t count) const {
  std::vector<Halfspace> planes;
  for (const HalfspaceId i : after_moves(start_, std::span(moves_).first(count))) {
    planes.push_back(input_.halfspace(i));
  }
  try {
    const HalfspaceDual dual = dual_of(planes, input_.inside());
    if (dual.redundant.empty()) return to_polytope(dual.dual.halfspaces, dual.dual.triangles);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidArgument) throw;
  }
  throw Error(ErrorCode::Internal, "a search left a solid that its planes do not bound");
}

// The first of the least changes, up to rounding: congruent caps are hardly ever rounded to the
// same number. A change that exact numbers prove to be below 0 may come out above it in doubles.
std::optional<std::size_t> best_of(const std::vector<double>& changes) {
  if (changes.empty()) return {};
  constexpr double kNearly = 0x1p-20;
  const double least = *std::min_element(changes.begin(), changes.end());
  const auto best = std::find_if(changes.begin(), changes.end(), [&](double change) {
    return change <= least + kNearly * std::abs(least);
  });
  return static_cast<std::size_t>(best - changes.begin());
}

void require_smaller(const Polytope& after, const Polytope& before,
                     const SimplifyRequest& request) {
  const Watch watch(request.watch.stop);
  const Ordering order =
      compare(exact_measure(after, request.cost, watch), exact_measure(before, request.cost, watch),
              request.compare, watch);
  if (order.order != Order::Less) {
    throw Error(ErrorCode::Internal, "a search did not make the solid smaller");
  }
}

// The halfspaces that the removals left, ascending.
HalfspaceIds left_by(const RunEnd& end, std::size_t halfspaces) {
  std::vector<bool> is_left(halfspaces, true);
  for (const HalfspaceId i : end.run ? removed_in(*end.run) : end.removed) {
    is_left[i.index()] = false;
  }
  HalfspaceIds left;
  for (std::size_t i = 0; i < is_left.size(); ++i) {
    if (is_left[i]) left.emplace_back(i);
  }
  return left;
}

const char* stage_of(const SearchRequest& search) {
  return search.kind == SearchKind::Optimal ? stage::kOptimum : stage::kSearch;
}

SearchOptions search_options(const SimplifyRequest& request, const RunInput& input) {
  const std::string name = stage_of(request.search);
  SearchOptions options{.request = request.search,
                        .engine = request.engine,
                        .keep = input.keep,
                        .cost = request.cost,
                        .compare = request.compare,
                        .seed = request.seed,
                        .watch = request.watch.of(name),
                        .settle = request.watch.settle};
  if (request.watch.progress) {
    options.bounded = [&request, name](std::size_t nodes, double gap) {
      request.watch.progress(fmt::format("{}, gap {:.1g}%", name, 100 * gap), nodes,
                             request.search.nodes);
    };
  }
  return options;
}

// Sets the measure after each move, if there is a trace, and proves that each makes the solid
// smaller, if that is asked for. Returns the last solid.
Polytope follow(std::vector<Move>& moves, const SolidsOfMoves& solids, Polytope before,
                const SimplifyRequest& request) {
  const std::size_t count = moves.size();
  const bool wants_each = request.trace || request.verify == VerifyLevel::Full;
  for (std::size_t k = wants_each || count == 0 ? 1 : count; k <= count; ++k) {
    Polytope after = solids.after(k);
    if (request.verify != VerifyLevel::None) require_smaller(after, before, request);
    if (request.trace) moves[k - 1].measure = exact_measure(after, request.cost);
    before = std::move(after);
  }
  return before;
}

// @param greedy, last  The solids before and after all moves.
SearchResult measure_search(const SearchRun& found, const SolidsOfMoves& solids,
                            const Polytope& greedy, const Polytope& last,
                            const SimplifyRequest& request) {
  const auto measured = [&](const Polytope& polytope) {
    return enclose_measure(polytope, request.cost, kMeasureBits);
  };
  SearchResult result{request.search, found.tried, found.moves, measured(greedy), measured(last)};
  result.optimality = found.optimality;
  const auto measured_after = [&](std::size_t k) {
    return k == 0                    ? result.greedy
           : k == found.moves.size() ? result.now
                                     : measured(solids.after(k));
  };
  if (const auto best = best_of(found.changes)) {
    result.best.emplace(
        SearchResult::Best{*best, measured_after(*best), measured_after(*best + 1)});
  }
  return result;
}

}  // namespace

void require_sensible_search(const SimplifyRequest& request) {
  if (request.search.kind == SearchKind::None) return;
  if (request.engine == Engine::Float) {
    reject_argument(
        "a search proves that each of its moves helps, which doubles cannot: choose the filtered "
        "or the exact engine");
  }
  if (request.search.kind == SearchKind::Optimal && request.cost != CostMeasure::Volume) {
    reject_argument(
        "only a volume can be proven the least: removing a halfspace may add less area or mean "
        "width later, so no bound holds for what is left to be tried; leave out the "
        "cost, or search by walk or local");
  }
  if (!request.faces) {
    reject_argument(
        "a search keeps the number of halfspaces, which a growth limit leaves open: give the "
        "number of faces as well");
  }
  if (request.record && request.search.kind != SearchKind::Optimal) {
    reject_argument(
        "a proof is about the removals of a run, and this search ends elsewhere: leave out one of "
        "them, or search for the optimum");
  }
}

namespace {

SearchRun search(const RunInput& input, std::span<const DualTriangle> start,
                 const SearchOptions& options) {
  if (input.hull) return search_from(*input.dual, *input.hull, start, options);
  const auto by_kind = options.request.kind == SearchKind::Optimal
                           ? search_optimal_from
                           : static_cast<decltype(search_optimal_from)*>(search_from);
  return by_kind(input.solid->dual, input.dual ? &*input.dual : nullptr, input.solid->polytope,
                 input.center, start, options);
}

}  // namespace

RunEnd search_further(RunEnd end, const RunInput& input, const SimplifyRequest& request,
                      StageLog& log) {
  const HalfspaceIds start = left_by(end, input.halfspaces());
  const SearchOptions options = search_options(request, input);
  SearchRun found =
      log.run(stage_of(request.search), [&] { return search(input, end.triangles, options); });
  end.search = log.run("search result", [&] {
    const SolidsOfMoves solids(input, start, found.moves);
    Polytope last = follow(found.moves, solids, end.polytope, request);
    SearchResult result = measure_search(found, solids, end.polytope, last, request);
    end.polytope = std::move(last);
    return result;
  });
  if (end.run) {
    end.run->is_least = found.optimality && found.optimality->is_proven;
    end.run->moves = std::move(found.moves);
  }
  return end;
}

}  // namespace convexact
