// SPDX-License-Identifier: MIT
// Which vectors are put to a program, and in which numbers.
#include <algorithm>
#include <limits>

#include "oracle/conformance_judge.hpp"

namespace convexact {
namespace {

using oracle::Given;
using oracle::given_by;

std::optional<float> to_binary32(double x) {
  const auto rounded = static_cast<float>(x);
  if (!std::isfinite(rounded)) return std::nullopt;
  return rounded;
}

// The points in binary32; nothing if one is beyond its range.
std::optional<PointSet> rounded(const PointSet& points) {
  std::vector<Point> result(points.doubles().begin(), points.doubles().end());
  for (Point& p : result) {
    for (double& x : p) {
      const auto rounded = to_binary32(x);
      if (!rounded) return std::nullopt;
      x = *rounded;
    }
  }
  return PointSet(std::move(result));
}

bool is_binary32(const Integer& x) {
  const Rational value(x);
  const float rounded = to_float(value, Rounding::Nearest);
  return std::isfinite(rounded) && to_rational(rounded) == value;
}

bool is_binary32(const HalfspaceList& list) {
  return std::all_of(list.halfspaces.begin(), list.halfspaces.end(), [](const Halfspace& h) {
    return is_binary32(h.normal()[0]) && is_binary32(h.normal()[1]) && is_binary32(h.normal()[2]) &&
           is_binary32(h.offset());
  });
}

// The known answers for other points than those that they were known for.
void forget_answers(TestVector& vector, const std::optional<Given>& given) {
  if (auto* question = std::get_if<SimplifyQuestion>(&vector.question)) {
    question->volume.reset();
    question->costs.clear();
    question->ties.clear();
  } else if (auto* hull = std::get_if<HullQuestion>(&vector.question)) {
    hull->facets = given->hull.planes.size();
    hull->vertices = given->hull.vertices.size();
  }
}

std::variant<TestVector, NotRun> in_binary32(TestVector vector) {
  if (const auto* list = std::get_if<HalfspaceList>(&vector.input)) {
    if (!is_binary32(*list)) return NotRun::OtherNumbers;
    return vector;
  }
  auto* points = std::get_if<PointSet>(&vector.input);
  if (points == nullptr) return vector;
  std::optional<PointSet> nearest = rounded(*points);
  if (!nearest) return NotRun::OtherNumbers;
  if (std::equal(nearest->doubles().begin(), nearest->doubles().end(), points->doubles().begin())) {
    return vector;
  }
  *points = std::move(*nearest);
  const std::optional<Given> given = given_by(vector);
  const bool is_refusal = std::holds_alternative<RefuseQuestion>(vector.question);
  if (given.has_value() == is_refusal) return NotRun::OtherNumbers;
  forget_answers(vector, given);
  return vector;
}

// Whether the hull of the input has more facets or corners than the program handles.
bool is_beyond(const TestVector& vector, const Promise& promise) {
  const bool has_caps = promise.max_facets || promise.max_vertices || promise.max_facet_vertices;
  if (promise.asks != Asks::Hull || !has_caps ||
      std::holds_alternative<RefuseQuestion>(vector.question)) {
    return false;
  }
  constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
  const Polytope hull = given_by(vector)->hull;
  return hull.planes.size() > promise.max_facets.value_or(kAny) ||
         hull.vertices.size() > promise.max_vertices.value_or(kAny) ||
         std::any_of(hull.facets.begin(), hull.facets.end(), [&](const auto& facet) {
           return facet.size() > promise.max_facet_vertices.value_or(kAny);
         });
}

// A question that a program can answer that promises this.
bool is_asked(const TestVector& vector, const Promise& promise) {
  if (std::holds_alternative<VerifyQuestion>(vector.question)) return false;
  return promise.asks != Asks::Simplify || !std::holds_alternative<HullQuestion>(vector.question);
}

}  // namespace

bool repeats_hull_vector(const TestVector& vector, std::span<const TestVector> vectors) {
  const auto* points = std::get_if<PointSet>(&vector.input);
  if (points == nullptr || !std::holds_alternative<SimplifyQuestion>(vector.question)) return false;
  return std::any_of(vectors.begin(), vectors.end(), [&](const TestVector& other) {
    const auto* same = std::get_if<PointSet>(&other.input);
    return same != nullptr && std::holds_alternative<HullQuestion>(other.question) &&
           std::equal(same->doubles().begin(), same->doubles().end(), points->doubles().begin(),
                      points->doubles().end());
  });
}

std::variant<TestVector, NotRun> as_put(const TestVector& vector, const Promise& promise) {
  if (!is_asked(vector, promise)) return NotRun::AsksOtherwise;
  std::variant<TestVector, NotRun> put = vector;
  if (promise.numbers == Precision::Binary32) put = in_binary32(vector);
  const auto* given = std::get_if<TestVector>(&put);
  if (given != nullptr && is_beyond(*given, promise)) return NotRun::BeyondTheProgram;
  return put;
}

}  // namespace convexact
