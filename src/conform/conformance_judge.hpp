// SPDX-License-Identifier: MIT
// conformance_judge.hpp - the parts of judge_run(), which judges an output.
#pragma once
#include <span>

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
  StageWatch watch = {};          ///< Ends the judgement.
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

/// Whether the rounding of a mesh's corners explains a distance: if each coordinate of them moves
/// by up to s, no point of their hull moves by more than the root of 3 times s. Of halfspaces: no.
[[nodiscard]] bool is_moved_corner(const Case& c, const Rational& squared_distance);
/// Whether rounding explains the points outside: of a mesh, by the distance of the worst one; of
/// halfspaces, for each of them if its coefficients move. Precondition: contains-input is violated,
/// by a distance.
[[nodiscard]] bool leak_is_rounding(const Case& c);
/// Whether the faces are the surface of the hull up to the rounding of its corners: it must
/// explain, for each face, the corner that is farthest beyond it and the corners of the face; and
/// the faces must enclose the hull once. Precondition: they are closed and oriented.
[[nodiscard]] bool faces_are_rounded(const Case& c);

/// Whether the distance of a point to the plane of a face is explained by these movements: each
/// coordinate of a corner by up to `slack`, each of the point by up to `point_slack`.
///
/// Six times the volume between face and point is the sum of the determinants
/// D_k = det(c_k - c_0, c_(k+1) - c_0, p - c_0). If each entry of a matrix moves by up to w, its
/// determinant moves by at most perm(|D| + w) - perm(|D|), with the permanents of the absolute
/// values. The distance is explained if |sum of D_k| is at most the sum of these bounds. The test
/// is exact. It allows long distances for slivers, whose planes mean little, and only tiny ones for
/// large faces.
/// @param corners  Three or more, in cyclic order.
[[nodiscard]] bool is_explained(std::span<const RationalPoint> corners, const Rational& slack,
                                const RationalPoint& point, const Rational& point_slack);

}  // namespace convexact::oracle
