// SPDX-License-Identifier: MIT
#include "wire/simplify_report.hpp"

#include "convexact/number.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"
#include "proof/proof.hpp"
#include "simplify/run_names.hpp"
#include "wire/mass_report.hpp"
#include "wire/simplify_options.hpp"
#include "wire/tie_report.hpp"

namespace convexact {
namespace {

Json stored_json(const std::string& format, const Growth& growth, std::size_t violations) {
  return {{"format", format},
          {"push", growth.push},
          {"volume_ratio", growth.volume_ratio},
          {"violations", violations}};
}

std::string format_name(Precision precision, const char* what) {
  return std::string(what) + " in " + name_in(kPrecisionNames, precision);
}

// The most derived form that was asked for; the exact integers if none was.
Json stored_json(const Stored& solid) {
  if (const auto& mesh = solid.mesh) {
    return stored_json(format_name(mesh->precision, "mesh"), mesh->growth, mesh->violations);
  }
  if (const auto& planes = solid.planes) {
    return stored_json(format_name(planes->precision, "planes"), planes->growth,
                       planes->violations);
  }
  return stored_json("planes in integers", Growth{}, 0);
}

Json input_json(std::size_t points, std::size_t vertices, std::size_t halfspaces,
                const std::vector<std::size_t>& redundant) {
  Json input = {{"points", points}, {"hull_vertices", vertices}, {"halfspaces", halfspaces}};
  if (points > 0) return input;
  input["redundant"] = redundant;
  return input;
}

bool is_reached(StopReason stop) {
  return stop == StopReason::Reached || stop == StopReason::GrowthLimit;
}

// Ids among the input's facets, and the places of these planes in the output.
Json kept_json(const std::vector<KeptFacet>& kept) {
  Json ids = Json::array(), planes = Json::array();
  for (const auto& [id, plane] : kept) {
    ids.push_back(id);
    planes.push_back(plane);
  }
  return {{"ids", ids}, {"planes", planes}};
}

// A removal that doubles cannot prove to be bounded need not be unbounded.
Json stop_json(StopReason stop, bool is_end_proven) {
  return !is_reached(stop) && !is_end_proven ? "none-certain" : name_of(stop);
}

const char* measure_key(CostMeasure measure) {
  return measure == CostMeasure::Area ? "area" : "mean_width";
}

// The ratio is an upper bound, so that it never shows less than 1.
Json growth_json(const Measured& before, const Measured& after) {
  return {{"input", measured_json(before, kDigits)},
          {"output", measured_json(after, kDigits)},
          {"ratio", (after.bounds / before.bounds).high_double()}};
}

Json growth_json(const std::array<Enclosure, 2>& measure) {
  return growth_json({measure[0], {}}, {measure[1], {}});
}

Json float_bound_json(const FloatBound& bound) {
  return {
      {"vouched", bound.is_vouched()}, {"cost", bound.cost}, {"regret", bound.regret},
      {"doubtful", bound.doubtful},    {"ties", bound.ties}, {"end_proven", bound.is_end_proven}};
}

// @param is_exact  Whether volumes are to be given as fractions, too.
Json search_json(const SearchResult& search, bool is_exact) {
  const SearchKind kind = search.request.kind;
  const auto measure = [](const Enclosure& x) { return measured_json({x, {}}, kDigits); };
  Json json = {{"kind", name_in(kSearchKindNames, kind)}};
  if (kind != SearchKind::Walk) json["kicks"] = search.request.kicks;
  if (search.optimality) {
    const auto& [is_proven, lower_bound, nodes] = *search.optimality;
    const Enclosure bound(lower_bound, kMeasureBits);
    json["optimum"] = {
        {"proven", is_proven},
        {"nodes", nodes},
        {"node_limit", search.request.nodes},
        {"lower_bound",
         measured_json({bound, is_exact ? std::optional(lower_bound) : std::nullopt}, kDigits)},
        {"gap", is_proven ? 0 : ((search.now - bound) / search.now).high_double()}};
  }
  json["tried"] = search.tried;
  json["accepted"] = search.moves.size();
  json["greedy"] = measure(search.greedy);
  json["now"] = measure(search.now);
  if (const auto& best = search.best) {
    json["best_move"] = {{"removed", search.moves[best->move].removed},
                         {"inserted", search.moves[best->move].inserted},
                         {"before", measure(best->before)},
                         {"after", measure(best->after)}};
  }
  return json;
}

// Null where doubles cannot hold the planes.
Json doubles_json(const Stored& solid) {
  try {
    Json rows = Json::array();
    for (const auto& plane : solid.planes_in_doubles()) rows.push_back(plane);
    return rows;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Unrepresentable) throw;
    return nullptr;
  }
}

}  // namespace

Json result_json(const SimplifyResult& result) {
  Json json;
  json["input"] = input_json(result.input_points, result.hull_vertices, result.input_halfspaces,
                             result.redundant);
  json["output"] = {
      {"halfspaces", result.solid.exact.planes.size()},
      {"reached", is_reached(result.stop)},
      {"stop", stop_json(result.stop, !result.float_bound || result.float_bound->is_end_proven)},
      {"planes_in_doubles", doubles_json(result.solid)},
      {"planes", result.solid.exact.planes},
      {"stored", stored_json(result.solid)}};
  if (!result.kept.empty()) json["kept"] = kept_json(result.kept);
  json["volume"] = growth_json(result.input_volume, result.output_volume);
  json["cost"] = name_of(result.cost);
  if (result.measure) json[measure_key(result.cost)] = growth_json(*result.measure);
  if (result.growth_of) json["growth_of"] = name_of(*result.growth_of);
  if (result.limited) json[measure_key(*result.growth_of)] = growth_json(*result.limited);
  if (result.growth_bits > 0) json["growth_undecided_bits"] = result.growth_bits;
  if (!result.float_bound) json["ties"] = ties_json(result.ties);
  if (result.search)
    json["search"] = search_json(*result.search, result.output_volume.exact.has_value());
  json["engine"] = name_of(result.engine);
  if (result.float_bound) json["float_bound"] = float_bound_json(*result.float_bound);
  if (result.start && result.run)
    json["proof"] = name_in(kProofClaimNames, proof_claim(*result.run));
  json["verified"] = {{"level", name_in(kVerifyLevelNames, result.verified)},
                      {"steps", result.engine == Engine::Float ? 0 : result.steps},
                      {"violations", 0}};
  return json;
}

Json gaps_json(const Gaps& gaps) {
  return {{"faces", gaps.faces},
          {"out_of_own_part", gaps.out_of_own.size()},
          {"in_no_part", gaps.in_no_part.size()}};
}

Json totals_json(const SceneTotals& totals, const Gaps& gaps) {
  Json json = {{"input", {{"halfspaces", totals.input_halfspaces}}},
               {"output",
                {{"halfspaces", totals.output_halfspaces},
                 {"reached", is_reached(totals.stop)},
                 {"stop", stop_json(totals.stop, totals.is_end_proven)}}},
               {"volume", growth_json(totals.input_volume, totals.output_volume)},
               {"cost", name_of(totals.cost)}};
  if (totals.measure) json[measure_key(totals.cost)] = growth_json(*totals.measure);
  if (totals.growth_of) json["growth_of"] = name_of(*totals.growth_of);
  if (totals.limited) json[measure_key(*totals.growth_of)] = growth_json(*totals.limited);
  if (totals.growth_bits > 0) json["growth_undecided_bits"] = totals.growth_bits;
  if (totals.engine != Engine::Float) json["ties"] = ties_json(totals.ties);
  if (gaps.faces > 0) json["gaps"] = gaps_json(gaps);
  return json;
}

Json hull_json(const HullResult& result, int digits) {
  const Polytope& hull = result.solid.exact;
  Json vertices = Json::array();
  for (const RationalPoint& vertex : hull.vertices) vertices.push_back(vector_json(vertex));
  Json json = {
      {"input",
       input_json(result.input_points, hull.vertices.size(), hull.planes.size(), result.redundant)},
      {"edges", result.edges},
      {"box", {{"low", vector_json(result.box.low)}, {"high", vector_json(result.box.high)}}},
      {"diameter", measured_json(result.diameter, digits)}};
  if (result.volume) json["volume"] = measured_json(*result.volume, digits);
  if (result.area) json["area"] = measured_json(*result.area, digits);
  if (result.mean_width) json["mean_width"] = measured_json(*result.mean_width, digits);
  if (result.mass) json["mass"] = mass_json(*result.mass);
  json["planes"] = hull.planes;
  json["vertices"] = vertices;
  json["facets"] = hull.facets;
  json["stored"] = stored_json(result.solid);
  return json;
}

}  // namespace convexact
