// SPDX-License-Identifier: MIT
// scene_verdict.hpp - a candidate for each part of an input, and the gaps between the candidates.
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "convexact/simplify.hpp"
#include "convexact/verify.hpp"

namespace convexact {

/// The claim NoGaps: every face of the input lies inside the candidate of its own part.
struct GapVerdict {
  Gaps gaps;
  std::string sentence;
  /// If it is violated: a face, one of its points that is outside, and a plane that the point is
  /// beyond; no plane if the candidate encloses no volume.
  struct Witness {
    PartFace face;
    std::string part;
    RationalPoint point;
    std::optional<Halfspace> plane;
  };
  std::optional<Witness> witness;
};

struct PartVerdict {
  std::string part, candidate;  ///< Names.
  Verdict verdict;
};

struct SceneVerdict {
  std::vector<PartVerdict> parts;  ///< As the input has them; empty if no-gaps alone was asked for.
  std::optional<GapVerdict> gaps;  ///< If it was asked for, and the candidate can be read.

  bool holds() const;
};

/// For each part of the input its candidate: by name if both have the same names in different
/// orders, each once; by position if the names are the same in the same order, or if no name is in
/// both.
/// @throws Error InvalidArgument, with a name, if one side has more of them, or if only some names
///               match.
[[nodiscard]] std::vector<std::size_t> match_parts(const std::vector<std::string>& input,
                                                   const std::vector<std::string>& candidate);

/// Judges each part of a mesh as an enclosure of the same part of the input, and the gaps.
/// @param candidate  A mesh, or the error of its reader, which every part then has.
/// @param request    Of each part. Its claims may hold NoGaps, which is asked, too, if there are
///                   none; with nothing else no part is judged if the candidate can be read.
/// @throws Error InvalidArgument for halfspaces, for a mesh without faces, and as match_parts(); as
///               verify().
[[nodiscard]] std::variant<SceneVerdict, NotSolidPart> verify_scene(
    const std::vector<SceneObject>& input, const Candidate& candidate,
    const VerifyRequest& request);

}  // namespace convexact
