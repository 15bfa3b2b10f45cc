// SPDX-License-Identifier: MIT
// test_vector.hpp - a conformance vector: an input, a question, and the answer that is known.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry/halfspace_list.hpp"
#include "convexact/oracle/candidate.hpp"
#include "convexact/oracle/claim.hpp"

namespace convexact {

/// The bytes of a file, which may be malformed, and the extension that says how to read them.
struct RawFile {
  std::string bytes;
  std::string extension;  ///< Without a dot.
};

/// What is the hull?
struct HullQuestion {
  std::size_t facets, vertices;
  Rational volume;
};

/// What does the greedy removal of halfspaces lead to?
struct SimplifyQuestion {
  std::size_t faces;               ///< How many to keep.
  std::size_t facets;              ///< How many are left; more than `faces` if not `reached`.
  bool reached;                    ///< False if every further removal would be unbounded.
  std::optional<Rational> volume;  ///< The rest is known only together with the volume.
  std::vector<Rational> costs;     ///< Of each step.
  std::vector<std::vector<Halfspace>> ties;  ///< For each step the tied halfspaces; none if one.
};

/// What is to be said of a candidate?
struct VerifyQuestion {
  Candidate candidate;
  std::optional<std::size_t> max_facets, max_vertices, max_facet_vertices;
  std::vector<std::pair<ClaimCode, Status>> claims;  ///< Those whose status is known.
  struct Outside {
    std::size_t points;
    Rational squared_distance;  ///< Of the worst one; 0 if none is outside.
  };
  std::optional<Outside> outside;
};

/// Is the input refused, and why?
struct RefuseQuestion {
  ErrorCode error;               ///< Malformed, NotFinite or NoInterior.
  std::optional<int> dimension;  ///< Of points that span no volume.
  /// The points of a malformed file whose points are sound: of its faces a program that reads
  /// points only knows nothing.
  std::optional<PointSet> points = {};
};
/// What {faces} stands for in a run on an input that is to be refused.
inline constexpr std::size_t kFacesOfRefusals = 8;

struct TestVector {
  std::string id, title;
  int level = 1;  ///< 1 everyday, 2 hard, 3 cruel.
  bool required = true;
  std::vector<std::string> flags;  ///< docs/flags has a page for each.
  std::variant<PointSet, HalfspaceList, RawFile> input;
  std::variant<HullQuestion, SimplifyQuestion, VerifyQuestion, RefuseQuestion> question;
};

}  // namespace convexact
