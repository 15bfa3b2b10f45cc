// SPDX-License-Identifier: MIT
// The output of convexact compare: tables, JSON and CSV.
#include <fmt/format.h>

#include <algorithm>

#include "io/json.hpp"
#include "lab/compare/compare.hpp"

namespace convexact {
namespace {

constexpr const char* kMeasures = "{:>10.5f} {:>10.5f} {:>11.5f} {:>9.5f} {:>9.3g}";

std::string heading(const char* first) {
  return fmt::format("  {:<18} {:>8} {:>10} {:>10} {:>11} {:>9} {:>9}\n", "method", first, "volume",
                     "area", "mean width", "distance", "seconds");
}

// The words that differ between solids around the inputs and those inside.
struct Wording {
  const char *size, *best, *beats, *better;
};
Wording wording_of(bool inner) {
  return inner ? Wording{"vertices", "most volume", "beats drop", "more volume than drop"}
               : Wording{"planes", "least volume", "beats greedy", "less volume than greedy"};
}

// The remark at the end of a row.
std::string remark(const MethodComparison& comparison, const MethodResult& result) {
  std::string text;
  const Wording words = wording_of(comparison.inner);
  if (result.solid() == nullptr) return comparison.inner ? "flat" : "unbounded";
  if (!result.fits(comparison.size)) {
    return fmt::format("more than {} {}, not ranked", comparison.size, words.size);
  }
  if (&result == comparison.tightest()) text = words.best;
  if (comparison.beats_own(result)) text += (text.empty() ? "" : ", ") + std::string(words.beats);
  return text;
}

std::string row_of(const MethodComparison& comparison, const MethodResult& result) {
  std::string row = fmt::format("  {:<18} ", result.method->name);
  if (const Refit* solid = result.solid()) {
    const Ratios ratios = ratios_of(*solid);
    row += fmt::format("{:>8} ", result.size()) +
           fmt::format(fmt::runtime(kMeasures), ratios.volume, ratios.area, ratios.mean_width,
                       ratios.distance, result.seconds);
  } else {
    row += fmt::format("{:>8} {:>10} {:>10} {:>11} {:>9} {:>9.3g}", "-", "-", "-", "-", "-",
                       result.seconds);
  }
  const std::string note = remark(comparison, result);
  return row + (note.empty() ? "" : "  " + note) + "\n";
}

// Results with a solid first, in order of tightness.
std::vector<const MethodResult*> by_tightness(const MethodComparison& comparison) {
  std::vector<const MethodResult*> order;
  for (const MethodResult& result : comparison.results) order.push_back(&result);
  std::stable_sort(order.begin(), order.end(), [](const MethodResult* a, const MethodResult* b) {
    if (a->solid() == nullptr || b->solid() == nullptr) return a->solid() != nullptr && !b->solid();
    return a->is_tighter(*b);
  });
  return order;
}

std::string winners_text(const MethodComparison& comparison) {
  std::string names;
  for (const MethodResult* result : by_tightness(comparison)) {
    if (!comparison.beats_own(*result)) continue;
    names += (names.empty() ? "" : ", ") + std::string(result->method->name);
  }
  if (names.empty()) return "";
  return fmt::format("  {}: {}\n", wording_of(comparison.inner).better, names);
}

std::string table_of(const MethodComparison& comparison) {
  const char* unit = wording_of(comparison.inner).size;
  std::string text = fmt::format(
                         "{}: {} facets, {} vertices; at most {} {}{}; measures over "
                         "those of the hull\n",
                         comparison.name, comparison.facets, comparison.vertices, comparison.size,
                         unit, comparison.inner ? ", inside" : "") +
                     heading(unit);
  for (const MethodResult* result : by_tightness(comparison)) text += row_of(comparison, *result);
  return text + winners_text(comparison);
}

std::string table_of(const std::vector<MethodMedian>& list, std::size_t inputs) {
  std::string text = fmt::format("medians over {} inputs\n", inputs) + heading("inputs");
  for (const MethodMedian& of : list) {
    text += fmt::format("  {:<18} {:>8} ", of.method->name, of.inputs) +
            fmt::format(fmt::runtime(kMeasures), of.volume, of.area, of.mean_width, of.distance,
                        of.seconds) +
            "\n";
  }
  return text;
}

Json result_json(const MethodComparison& comparison, const MethodResult& result) {
  Json json = {{"method", result.method->name},
               {"seconds", result.seconds},
               {"refit_seconds", result.refit_seconds}};
  if (const auto* ray = std::get_if<RecessionRay>(&result.outcome)) {
    json["unbounded"] = vector_json(ray->direction);
    return json;
  }
  if (result.solid() == nullptr) {
    json["flat"] = true;
    return json;
  }
  const Refit& refit = *result.solid();
  const auto ratio = [](const Enclosure& x) { return measured_json({x, {}}, kDigits); };
  json["planes"] = refit.solid.planes.size();
  if (comparison.inner) json["vertices"] = refit.solid.vertices.size();
  json["fits"] = result.fits(comparison.size);
  json[comparison.inner ? "most" : "least"] = &result == comparison.tightest();
  json[comparison.inner ? "beats_drop" : "beats_greedy"] = comparison.beats_own(result);
  json["volume"] = ratio(Enclosure(refit.volume_ratio, kMeasureBits));
  json["area"] = ratio(refit.area_ratio);
  json["mean_width"] = ratio(refit.mean_width_ratio);
  json["distance"] = ratio(sqrt(Enclosure(refit.squared_distance_ratio, kMeasureBits)));
  json["halfspaces"] = Json::array();
  for (const Halfspace& plane : refit.solid.planes) json["halfspaces"].push_back(plane_json(plane));
  return json;
}

std::vector<Method> all_methods() {
  std::vector<Method> all(methods().begin(), methods().end());
  all.insert(all.end(), inner_methods().begin(), inner_methods().end());
  return all;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string compare_text(const std::vector<MethodComparison>& comparisons) {
  std::string text;
  for (const MethodComparison& comparison : comparisons) {
    text += (text.empty() ? "" : "\n") + table_of(comparison);
  }
  if (comparisons.size() > 1) text += "\n" + table_of(medians(comparisons), comparisons.size());
  return text;
}

Json compare_json(const std::vector<MethodComparison>& comparisons, const CompareRequest& request) {
  Json json = {{request.inner ? "vertices" : "faces", request.size},
               {"seed", request.seed},
               {"inputs", Json::array()}};
  for (const MethodComparison& comparison : comparisons) {
    Json input = {{"name", comparison.name},
                  {"points", comparison.points},
                  {"vertices", comparison.vertices},
                  {"facets", comparison.facets},
                  {"methods", Json::array()}};
    for (const MethodResult& result : comparison.results) {
      input["methods"].push_back(result_json(comparison, result));
    }
    json["inputs"].push_back(std::move(input));
  }
  json["medians"] = Json::array();
  for (const MethodMedian& of : medians(comparisons)) {
    json["medians"].push_back({{"method", of.method->name},
                               {"inputs", of.inputs},
                               {"volume", of.volume},
                               {"area", of.area},
                               {"mean_width", of.mean_width},
                               {"distance", of.distance},
                               {"seconds", of.seconds}});
  }
  return json;
}

std::string compare_csv(const std::vector<MethodComparison>& comparisons) {
  const bool is_inner = !comparisons.empty() && comparisons.front().inner;
  std::string csv =
      is_inner ? "input,method,most vertices,vertices,volume,area,mean width,distance,seconds,"
                 "refit seconds,fits,beats drop\r\n"
               : "input,method,faces,planes,volume,area,mean width,distance,seconds,refit seconds,"
                 "fits,beats greedy\r\n";
  for (const MethodComparison& comparison : comparisons) {
    const std::string name = csv_field(as_utf8(comparison.name));
    for (const MethodResult& result : comparison.results) {
      csv += fmt::format("{},{},{},", name, result.method->name, comparison.size);
      if (const Refit* refit = result.solid()) {
        const Ratios ratios = ratios_of(*refit);
        csv += fmt::format("{},{},{},{},{},", result.size(), ratios.volume, ratios.area,
                           ratios.mean_width, ratios.distance);
      } else {
        csv += ",,,,,";
      }
      csv += fmt::format("{},{},{},{}\r\n", result.seconds, result.refit_seconds,
                         result.fits(comparison.size), comparison.beats_own(result));
    }
  }
  return csv;
}

std::string methods_text() {
  std::string text;
  for (const Method& method : all_methods()) {
    text += fmt::format("{:<18} {}{}\n", method.name, method.summary,
                        method.source.empty() ? "" : fmt::format(" [{}]", method.source));
  }
  return text;
}

Json methods_json() {
  Json list = Json::array();
  for (const Method& method : all_methods()) {
    list.push_back({{"name", method.name},
                    {"summary", method.summary},
                    {"source", method.source},
                    {"takes_faces", method.takes_faces},
                    {"inner", method.is_inner()}});
  }
  return {{"methods", list}};
}

}  // namespace convexact
