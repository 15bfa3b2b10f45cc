// SPDX-License-Identifier: MIT
// joined_hulls.hpp - the common hulls of pieces that a merger by reach asks for, and which of them
// may be parts.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "convexact/reach.hpp"
#include "hull/near_solid.hpp"
#include "surface/box_tree.hpp"

namespace convexact {

/// What parts may reach beyond a plane between them, in the frame, where coordinates are at most 2:
/// about what rounding makes of a common facet.
inline constexpr double kApart = 0x1p-42;

using PieceSet = std::vector<std::uint32_t>;  // ascending

[[nodiscard]] PieceSet united(const PieceSet& a, const PieceSet& b);

/// The common hull of some pieces.
struct Joined {
  PieceSet pieces;
  std::vector<Point> vertices;
  double volume = 0;
  NearBox box;
  std::optional<bool> is_allowed = {};
  std::vector<NearSolid::Plane> planes = {};  ///< If parts are kept apart.
};

/// The hulls that were asked for, so that no question is asked twice; those that exchanges asked
/// for in vain are forgotten.
class JoinedHulls {
 public:
  /// Keeps references.
  /// @param pieces  Points of the frame of the limit.
  /// @param jobs    Threads, at least 1, on which no answer depends.
  JoinedHulls(std::span<const std::vector<Point>> pieces, ReachLimit& limit, bool keeps_apart,
              std::size_t jobs, const Watch& watch);

  Joined& piece(std::uint32_t k) { return *hulls_.at({k}); }
  Joined& join(const Joined& a, const Joined& b);
  /// Each of several with one.
  std::vector<Joined*> join_each(std::span<Joined* const> others, const Joined& one);
  Joined& of(PieceSet pieces);

  /// Whether pieces that were refused are among these: what holds them is refused.
  bool is_refused(const PieceSet& pieces) const;

  /// Whether a hull may be a part.
  bool allows(Joined& joined);
  /// Whether two hulls may be parts together.
  bool allows(const Joined& a, const Joined& b);

  /// Drops the hull of several pieces unless it is allowed. Which pieces were refused is still
  /// known. Single pieces stay, since piece() needs them.
  void forget(const PieceSet& pieces);

 private:
  struct Wanted {
    PieceSet pieces;
    std::vector<Point> points;
  };
  static std::vector<Point> points_of(const Joined& a, const Joined& b);
  Joined& add(Wanted wanted) { return keep(make(std::move(wanted))); }
  void add_all(std::vector<Wanted> wanted);
  std::unique_ptr<Joined> make(Wanted wanted) const;
  Joined& keep(std::unique_ptr<Joined> made);

  ReachLimit& limit_;
  bool keeps_apart_;
  const std::size_t jobs_;
  const Watch& watch_;
  std::map<std::pair<const Joined*, const Joined*>, bool> apart_;
  std::map<PieceSet, std::unique_ptr<Joined>> hulls_;
  std::vector<PieceSet> refused_;
};

}  // namespace convexact
