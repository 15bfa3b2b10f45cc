// SPDX-License-Identifier: MIT
// conformance_judge.hpp - the parts of judge_run(), which judges an output.
#pragma once
#include "convexact/conform.hpp"

namespace convexact::oracle {

/// The solid that a vector's input stands for.
struct Given {
  PointSet points;  ///< Of the input, or the vertices of its halfspaces.
  Polytope hull;
};
/// Nothing if it has no volume.
[[nodiscard]] std::optional<Given> given_by(const TestVector& vector);

/// The data that all parts of the judgement need.
struct Case {
  const TestVector& vector;
  const Promise& promise;
  const Candidate& output;
  Given given;
  Verdict verdict;
  std::optional<Polytope> solid;  ///< Of the output; its vertices may be beyond doubles.
  Conformance result;

  void fail(Outcome outcome, std::string sentence, Rational size = 0, bool is_rounding = false) {
    result.failures.push_back({outcome, std::move(sentence), is_rounding, std::move(size)});
  }
  const auto* simplification() const { return std::get_if<SimplifyQuestion>(&vector.question); }
  bool asks(Asks what) const { return promise.asks == what; }
  bool tolerates(const Rational& squared_distance) const {
    return promise.tolerance.allows(squared_distance, verdict.squared_diameter);
  }
  Rational relative(const Rational& squared_distance) const {
    return squared_distance / verdict.squared_diameter;
  }
};

/// Whether the largest distances to which points are beyond the planes of the output, one for each
/// plane, are no larger than the rounding of its numbers explains.
[[nodiscard]] bool leak_is_rounding(const Case& c);
/// Whether the faces are the surface of the hull up to what the rounding of its corners explains:
/// for each face the corner that is farthest beyond it, and its own corners; and the faces enclose
/// the hull once. Precondition: they are closed and oriented.
[[nodiscard]] bool faces_are_rounded(const Case& c);

/// Of a hull by promise: each corner is a point of the input.
void judge_corners(Case& c);
/// Of an inner solid by promise: it lies in the input's hull.
void judge_inside(Case& c);

/// Judges the output of a run that ended well over a vector whose input has a volume.
[[nodiscard]] Conformance judge_output(const TestVector& vector, const Promise& promise,
                                       const Candidate& output, const std::atomic<bool>* stop);

}  // namespace convexact::oracle
