// SPDX-License-Identifier: MIT
#include "proof/partition_proof.hpp"

#include <map>

#include "convexact/hull.hpp"
#include "convexact/reach.hpp"

namespace convexact {
namespace {

std::string kind_text(const ReachCertificate::Cell& cell) {
  switch (cell.kind) {
    case ReachCertificate::Kind::Split:
      return "split";
    case ReachCertificate::Kind::Near:
      return "near " + std::to_string(cell.triangle.value);
    case ReachCertificate::Kind::Inside:
      return cell.beside ? "inside " + std::to_string(*cell.beside) : "inside";
    case ReachCertificate::Kind::Open:
      break;
  }
  return "open";
}

class PartitionWriter {
 public:
  PartitionWriter(const Decomposition& made, const DecomposeRequest& request)
      : made_(made), request_(request), partition_(std::get<Partition>(made.origin)) {}

  std::string write() {
    out_.line("convexact-proof", "6", "partition");
    write_surface(made_.surface, out_);
    for (std::size_t k = 0; k < made_.parts.size(); ++k) {
      write_part(made_.parts[k]);
      for (const std::uint32_t leaf : made_.parts[k].leaves) {
        part_of_[partition_.leaves[leaf].node] = k;
      }
    }
    write_node(0);
    if (made_.reach) write_reach(made_, request_, out_);
    if (made_.apart) write_apart(*made_.apart);
    return out_.finish();
  }

 private:
  void write_part(const Part& part) {
    Watch(request_.watch.stop).ask();
    const HullOutcome outcome = convex_hull(part.mesh.points);
    const auto* hull = std::get_if<Hull>(&outcome);
    if (hull == nullptr) {
      throw Error(ErrorCode::InvalidArgument,
                  "a part is flat, and there is no proof for flat parts of cut: let them be "
                  "thickened");
    }
    out_.line("part");
    out_.points("corner", part.mesh.points);
    for (std::size_t f = 0; f < hull->facets.size(); ++f) {
      const std::span<const PointId> facet = hull->facets[f];
      for (std::size_t k = 2; k < facet.size(); ++k) {
        out_.line("facet", facet[0], facet[k - 1], facet[k]);
      }
    }
  }

  void write_node(std::uint32_t n) {
    const PartitionNode& node = partition_.nodes[n];
    if (node.plane) {
      out_.line("node", "cut", *node.plane, node.raised);
      for (const std::uint32_t child : node.children) write_node(child);
    } else if (const auto part = part_of_.find(n); part != part_of_.end()) {
      out_.line("node", "part", part->second);
    } else {
      out_.line("node", "empty");
    }
  }

  void write_apart(const DecompositionApart& apart) {
    out_.line("disjoint", apart.squared_push);
    for (const auto& [first, second, plane] : apart.planes) {
      const IntegerVector3& n = plane.direction;
      out_.line("between", first, second, n[0], n[1], n[2]);
    }
  }

  const Decomposition& made_;
  const DecomposeRequest& request_;
  const Partition& partition_;
  std::map<std::uint32_t, std::size_t> part_of_;  // by node
  ProofLines out_;
};

}  // namespace

void write_surface(const Surface& surface, ProofLines& out) {
  out.points("point", surface.points);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    out.line("triangle", surface.triangles[t], surface.face[t]);
  }
}

namespace {

// What cells alone do not prove, or too many of them, is not claimed.
std::optional<ReachCertificate> certificate_of(ReachLimit& limit,
                                               const std::vector<ConvexPart>& stored,
                                               const Watch& watch) {
  std::vector<const ConvexPart*> parts;
  for (const ConvexPart& part : stored) {
    if (!limit.allows(part, watch)) return {};
    parts.push_back(&part);
  }
  try {
    return limit.certificate(parts, watch);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Unrepresentable) throw;
    return {};
  }
}

void write_cells(const ReachCertificate& certificate, ProofLines& out) {
  out.line("root", certificate.center, certificate.half_width);
  if (!certificate.inner.empty()) out.line("slack", certificate.slack);
  for (const auto& [part, middle, share] : certificate.inner) {
    out.line("inner", part, middle, share);
  }
  auto clear = certificate.clear.begin();
  for (std::size_t c = 0; c < certificate.cells.size(); ++c) {
    out.line("cell", kind_text(certificate.cells[c]));
    for (; clear != certificate.clear.end() && clear->cell == c; ++clear) {
      out.line("clear", clear->part, clear->point);
    }
  }
  for (const auto& [cell, part, direction] : certificate.apart) {
    out.line("beyond", cell, part, direction);
  }
}

}  // namespace

void write_reach(const Decomposition& made, const DecomposeRequest& request, ProofLines& out) {
  if (made.reach->squared_distance == 0) return;  // volumes prove that, and cells do not
  const Watch watch(request.watch.stop);
  const Surface& surface = made.surface;
  std::vector<ConvexPart> stored;
  std::vector<BoundingBox> boxes;
  for (const Part& part : made.parts) {
    stored.push_back(convex_part(part.mesh.points, watch));
    boxes.push_back(stored.back().box);
  }
  std::optional<Winding> winding;
  if (surface.is_closed) winding.emplace(surface);
  ReachLimit limit(surface, winding ? &*winding : nullptr, made.reach->squared_distance, boxes);
  const std::optional<ReachCertificate> certificate = certificate_of(limit, stored, watch);
  if (!certificate) return;
  const ConcavityLimit distance = request.distance.value_or(kDefaultDistance);
  out.line("reach", distance.is_share ? "share" : "length", distance.value);
  write_cells(*certificate, out);
}

std::string write_partition_proof(const Decomposition& made, const DecomposeRequest& request) {
  return PartitionWriter(made, request).write();
}

}  // namespace convexact
