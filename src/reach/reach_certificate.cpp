// SPDX-License-Identifier: MIT
// reach_certificate.cpp - the cells that hold some parts, as a proof that somebody else can check.
#include <map>

#include "convexact/reach.hpp"
#include "reach/clear_cell.hpp"
#include "reach/reach_search.hpp"

namespace convexact {
namespace {

class CertificateWriter {
 public:
  CertificateWriter(ReachCells& cells, std::span<const ConvexPart* const> parts, const Watch& watch)
      : cells_(cells), watch_(watch) {
    made_.slack = to_rational(kInnerSlack);
    for (std::size_t k = 0; k < parts.size(); ++k) near_.push_back(placed(*parts[k], k));
  }

  ReachCertificate write() {
    const CellPlace root = cells_.root();
    made_.center = cells_.frame().point(root.center);
    made_.half_width = cells_.frame().length(root.half);
    std::vector<MetPart> met;
    for (std::uint32_t k = 0; k < near_.size(); ++k) {
      MetPart& all = met.emplace_back(MetPart{k, {root, {}}});
      for (std::uint32_t plane = 0; plane < near_[k].planes(); ++plane) {
        all.cell.planes.push_back(plane);
      }
    }
    add(root, met);
    std::stable_sort(made_.apart.begin(), made_.apart.end(),
                     [](const auto& a, const auto& b) { return a.part < b.part; });
    return std::move(made_);
  }

 private:
  using Kind = ReachCertificate::Kind;
  struct MetPart {
    std::uint32_t part;
    MetCell cell;
  };

  // The part as the proof has it.
  NearPart placed(const ConvexPart& part, std::size_t number) {
    NearPart near(part, cells_.frame());
    // A flat part has no facets to name: directions alone show that it is elsewhere.
    if (!part.solid) return NearPart({near.vertices().begin(), near.vertices().end()});
    std::optional<InnerPart> inner = inner_part(cells_, near);
    if (!inner) return near;
    made_.inner.push_back({number, cells_.frame().point(inner->middle), to_rational(inner->share)});
    return std::move(inner->part);
  }

  // Adds a cell and those below it; `met` are the parts that planes do not separate from it.
  void add(const CellPlace& place, const std::vector<MetPart>& met) {
    watch_.ask();
    const std::size_t number = made_.cells.size();
    made_.cells.emplace_back();
    if (met.empty()) return;
    switch (cells_.label(place)) {
      case ReachCells::Label::Near:
        made_.cells[number] = {Kind::Near, TriangleId(cells_.triangle(place.cell)), {}};
        return;
      case ReachCells::Label::Inside:
        made_.cells[number] = {Kind::Inside, {}, find_beside(place)};
        inside_.emplace(place.cell, number);
        return;
      default:
        break;
    }
    std::vector<const MetPart*> open;
    for (const MetPart& part : met) {
      if (!settles(part, number)) open.push_back(&part);
    }
    if (open.empty()) return;
    if (place.half <= cells_.least_half() || made_.cells.size() + 8 > kReachCells) {
      throw Error(
          ErrorCode::Unrepresentable,
          "cells alone do not prove how far a part reaches, or only more cells than a proof "
          "may have: choose a larger distance, or no proof");
    }
    made_.cells[number].kind = Kind::Split;
    MetCell half;
    for (const CellPlace& at : cells_.children(place)) {
      std::vector<MetPart> below;
      for (const MetPart* part : open) {
        if (part->cell.may_meet(near_[part->part], at, half)) below.push_back({part->part, half});
      }
      add(at, below);
    }
  }

  // Whether the part is elsewhere, or all that it has in the cell is inside of the solid.
  bool settles(const MetPart& met, std::size_t number) {
    const SeenPart seen = seen_from(met.cell, near_[met.part]);
    if (seen.is_apart) {
      made_.apart.push_back({number, met.part, -seen.hull.towards});
      return true;
    }
    const auto clear = clear_point(cells_, near_[met.part], met.cell, seen.nearest);
    if (!clear || clear->is_outside) return false;
    made_.clear.push_back({number, met.part, cells_.frame().point(clear->point)});
    return true;
  }

  // An earlier cell of the inside that has a side, or a piece of it, in common with this one.
  std::optional<std::size_t> find_beside(const CellPlace& place) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        Point y = place.center;
        y[axis] += sign * (place.half + cells_.least_half() / 4);
        if (const auto found = find_inside(y)) return found;
      }
    }
    return {};
  }
  std::optional<std::size_t> find_inside(const Point& y) {
    CellPlace place = cells_.root();
    if (y.lpNorm<Eigen::Infinity>() >= place.half) return {};
    for (;;) {
      const auto found = inside_.find(place.cell);
      if (found != inside_.end()) return found->second;
      if (!cells_.has_children(place.cell)) return {};
      const int k = (y[0] > place.center[0] ? 1 : 0) + (y[1] > place.center[1] ? 2 : 0) +
                    (y[2] > place.center[2] ? 4 : 0);
      place = cells_.children(place)[static_cast<std::size_t>(k)];
    }
  }

  ReachCells& cells_;
  const Watch& watch_;
  std::vector<NearPart> near_;
  std::map<std::uint32_t, std::size_t> inside_;  // by cell, its number
  ReachCertificate made_;
};

}  // namespace

ReachCertificate ReachLimit::certificate(std::span<const ConvexPart* const> parts,
                                         const Watch& watch) {
  if (search_->cells.is_at_zero()) {
    throw Error(ErrorCode::InvalidArgument, "cells do not prove a distance of 0");
  }
  search_->cells.make_room();
  return CertificateWriter(search_->cells, parts, watch).write();
}

}  // namespace convexact
