// SPDX-License-Identifier: MIT
// reach_certificate.cpp - the cells that hold some parts, as a proof that somebody else can check.
#include <map>

#include "convexact/reach.hpp"
#include "reach/met_cell.hpp"
#include "reach/reach_search.hpp"

namespace convexact {
namespace {

class CertificateWriter {
 public:
  CertificateWriter(ReachCells& cells, std::span<const ConvexPart* const> parts, const Watch& watch)
      : cells_(cells), watch_(watch) {
    for (const ConvexPart* part : parts) {
      near_.emplace_back(*part, cells.frame());
      // A flat part has no facets to name: directions alone show that it is elsewhere.
      if (!part->solid) {
        near_.back() = NearPart({near_.back().vertices().begin(), near_.back().vertices().end()});
      }
    }
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
    std::vector<const MetPart*> inner;
    for (const MetPart& part : met) {
      if (!is_apart(place, part, number)) inner.push_back(&part);
    }
    if (inner.empty()) return;
    if (place.half <= cells_.least_half() ||
        (cells_.is_full() && !cells_.has_children(place.cell))) {
      throw Error(
          ErrorCode::Unrepresentable,
          "cells alone do not prove how far a part reaches, or only more cells than a proof "
          "may have: choose a larger distance, or no proof");
    }
    made_.cells[number].kind = Kind::Split;
    MetCell half;
    for (const CellPlace& at : cells_.children(place)) {
      std::vector<MetPart> below;
      for (const MetPart* part : inner) {
        if (part->cell.may_meet(near_[part->part], at, half)) below.push_back({part->part, half});
      }
      add(at, below);
    }
  }

  bool is_apart(const CellPlace& place, const MetPart& part, std::size_t number) {
    const NearHull hull =
        near_hull(near_[part.part].vertices(), place.center, place.radius() + kReachError);
    if (widened(hull.bounds, place.center).low <= place.radius()) return false;
    made_.apart.push_back({number, part.part, -hull.towards});
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
  search_->cells.make_room();
  return CertificateWriter(search_->cells, parts, watch).write();
}

}  // namespace convexact
