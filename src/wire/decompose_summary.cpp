// SPDX-License-Identifier: MIT
// The summary of a decomposition for people.
#include <fmt/format.h>

#include <algorithm>

#include "number/precision.hpp"
#include "number/text.hpp"
#include "simplify/run_names.hpp"
#include "wire/decompose_report.hpp"
#include "wire/surface_report.hpp"
#include "wire/tie_report.hpp"

namespace convexact {
namespace {

std::string percent_text(const Rational& percent) { return to_decimal(percent, 6) + "%"; }

// A share with its length, or the other way round.
std::string limit_text(const ConcavityLimit& limit, const Decomposition& decomposition) {
  const Enclosure length = enclosed_root_of(decomposition.squared_limit());
  if (limit.is_share) {
    return fmt::format("{} of the diameter, a length of {}", percent_text(limit.value * 100),
                       interval_text(length));
  }
  return fmt::format("a length of {}, {} of the diameter", to_decimal(limit.value, 6),
                     percent_text(percent_of(length, decomposition.squared_diameter())));
}

// Why some cluster is beyond the limit.
std::string cause_text(const Decomposition& decomposition, const DecomposeRequest& request) {
  std::vector<std::string> causes;
  if (const auto* clustering = std::get_if<Clustering>(&decomposition.origin)) {
    const std::size_t beyond = merges_beyond(*clustering);
    if (beyond > 0 && request.max_parts) {
      causes.push_back(fmt::format("--max-parts {} asked for {} beyond it", *request.max_parts,
                                   counted(beyond, "merge", "merges")));
    }
  } else if (const auto* split = std::get_if<SplitTree>(&decomposition.origin)) {
    const SplitTree& tree = *split;
    if (tree.stopped_by_count && request.max_parts) {
      causes.push_back(fmt::format("--max-parts {} allows no more splits", *request.max_parts));
    }
    if (const std::size_t stuck = count_leaves(tree, LeafStatus::Unsplittable)) {
      causes.push_back(counted(stuck, "part", "parts") +
                       " cannot be split: each plane at the deepest notch leaves all on one side");
    }
  }
  if (!decomposition.flat_merged.empty()) {
    causes.push_back(
        fmt::format("{} joined a neighbour",
                    counted(decomposition.flat_merged.size(), "flat cluster", "flat clusters")));
  }
  return fmt::format("{}", fmt::join(causes, "; "));
}

std::string limit_line(const Decomposition& decomposition, const DecomposeRequest& request) {
  const std::string limit = limit_text(request.limit, decomposition);
  if (decomposition.limit_holds) {
    return summary_line("limit", "holds: no cluster is more concave than " + limit);
  }
  const auto beyond = static_cast<std::size_t>(
      std::count_if(decomposition.parts.begin(), decomposition.parts.end(),
                    [](const Part& part) { return !part.is_within_limit; }));
  return summary_line("limit", fmt::format("not held: {} of {} {} more concave than {}", beyond,
                                           counted(decomposition.parts.size(), "part", "parts"),
                                           beyond == 1 ? "is" : "are", limit)) +
         summary_line("", cause_text(decomposition, request));
}

std::string parts_line(const std::vector<Part>& parts) {
  std::size_t facets = 0, corners = 0;
  for (const Part& part : parts) {
    facets = std::max(facets, part.faces);
    corners = std::max(corners, part.mesh.points.size());
  }
  return summary_line(
      "parts",
      fmt::format("{}, of at most {} and {}", with_separators(parts.size()),
                  counted(facets, "facet", "facets"), counted(corners, "corner", "corners")));
}

std::string concavity_line(const Decomposition& decomposition, std::span<const std::string> names) {
  const auto& parts = decomposition.parts;
  const auto worst = std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return a.concavity.squared < b.concavity.squared;
  });
  if (worst == parts.end()) return "";
  if (worst->concavity.squared == 0) return summary_line("concavity", "0 in every part");
  const Enclosure length = enclosed_root_of(worst->concavity.squared);
  return summary_line(
      "concavity",
      fmt::format("at most {} ({} of the diameter), in {} at triangle {}", interval_text(length),
                  percent_text(percent_of(length, decomposition.squared_diameter())),
                  names[static_cast<std::size_t>(worst - parts.begin())],
                  worst->concavity.triangle.value));
}

// "3% of the diameter (0.07764)", of a length.
std::string length_text(const Rational& squared, const Decomposition& decomposition) {
  if (squared == 0) return "0";
  const Enclosure length = enclosed_root_of(squared);
  return fmt::format("{} of the diameter ({})",
                     percent_text(percent_of(length, decomposition.squared_diameter())),
                     interval_text(length));
}

// How far the parts reach, as far as it was asked.
std::string reach_lines(const Decomposition& decomposition, std::span<const std::string> names) {
  if (!decomposition.reach) {
    return summary_line(
        "reach", decomposition.surface.is_closed
                     ? "not limited: --method cut keeps every point of the parts within 3% of the "
                       "diameter of the solid, and holds it; --guard reach only the former"
                     : "not limited: --guard reach keeps every point of the parts within 3% of the "
                       "diameter of the surface");
  }
  const DecompositionReach& reach = *decomposition.reach;
  const bool is_told = std::holds_alternative<Partition>(decomposition.origin);
  if (is_told && reach.farther.empty()) return "";
  const std::string limit = length_text(reach.squared_distance, decomposition);
  const char* of = decomposition.surface.is_closed ? "the solid" : "the surface";
  if (reach.farther.empty()) {
    return summary_line(
        "reach",
        fmt::format("no point of the parts is farther than {} from {}, proven", limit, of));
  }
  const auto beyond = static_cast<std::size_t>(
      std::count_if(reach.farther.begin(), reach.farther.end(),
                    [](const auto& x) { return x.reach.reach == Reach::Beyond; }));
  if (reach.squared_distance == 0 && beyond == 0) {
    const bool is_rounded =
        std::any_of(decomposition.parts.begin(), decomposition.parts.end(),
                    [](const Part& part) { return part.form == PartForm::Rounded; });
    return summary_line(
        "reach",
        fmt::format("{} of {} {} a volume outside of the solid, no farther than {} from it{}",
                    reach.farther.size(), counted(decomposition.parts.size(), "part", "parts"),
                    reach.farther.size() == 1 ? "has" : "have",
                    length_text(reach.farther.front().reach.bracket->high, decomposition),
                    is_rounded ? ": corners that are no numbers of the format are rounded outward"
                               : ": notches that are too shallow for cells are not cut"));
  }
  const DecompositionReach::Farther* worst = nullptr;
  for (const auto& x : reach.farther) {
    if (x.reach.witness && (!worst || x.reach.witness->squared > worst->reach.witness->squared)) {
      worst = &x;
    }
  }
  std::string text =
      fmt::format("{} of {} {} farther than {} from {}", beyond > 0 ? beyond : reach.farther.size(),
                  counted(decomposition.parts.size(), "part", "parts"),
                  beyond > 0 ? (beyond == 1 ? "reaches" : "reach") : "may reach", limit, of);
  if (worst != nullptr) {
    text += fmt::format("; {} at least {}", names[worst->part],
                        length_text(worst->reach.witness->squared, decomposition));
  }
  return summary_line("reach", text);
}

std::string excess_line(const Decomposition& decomposition) {
  if (!decomposition.excess) return "";
  const DecompositionExcess& excess = *decomposition.excess;
  const Enclosure percent = excess.share * Enclosure(Integer(100), kMeasureBits);
  const std::string allowed = percent_text(excess.most * 100);
  return summary_line(
      "volumes",
      excess.holds
          ? fmt::format("of the parts together exceed the solid's by no more than {} of it",
                        allowed)
          : fmt::format("not held: those of the parts together exceed the solid's by {}% of it, "
                        "more than the {} that --max-excess allows",
                        interval_text(percent), allowed));
}

// The guarantee of cut.
std::string guarantee_line(const Decomposition& decomposition) {
  if (!std::holds_alternative<Partition>(decomposition.origin)) return "";
  const bool is_within = decomposition.reach && decomposition.reach->farther.empty();
  return summary_line("result", proven_of_parts(decomposition) + (is_within ? ", proven" : ""));
}

std::string merges_line(const Clustering& clustering) {
  std::string text = with_separators(clustering.merges.size()) + " of two neighbours";
  if (clustering.whole_groups > 0) {
    text += fmt::format("; {} within the limit as a whole, without merges",
                        counted(clustering.whole_groups, "component", "components"));
  }
  const TieTally ties = ties_of(clustering);
  if (const std::size_t tied = tie_count(ties)) {
    text += fmt::format("; in {} several pairs cost the same ({}), and the first goes",
                        with_separators(tied), tie_proofs_text(ties));
  }
  return summary_line("merges", text);
}

std::string splits_line(const SplitTree& tree) {
  std::string text = with_separators(tree.splits.size()) + " by planes through the deepest notch";
  if (tree.roots > 1) text += fmt::format(", from {} components", with_separators(tree.roots));
  if (const std::size_t islands = island_count(tree)) {
    text += fmt::format("; {} went along as islands", counted(islands, "triangle", "triangles"));
  }
  return summary_line("splits", text);
}

std::string cuts_line(const Partition& partition) {
  std::string text = fmt::format("{} by planes, {} of which something is in",
                                 with_separators(partition.nodes.size() / 2),
                                 counted(partition.leaves.size(), "region", "regions"));
  const auto stuck = static_cast<std::size_t>(
      std::count_if(partition.leaves.begin(), partition.leaves.end(),
                    [](const PartitionLeaf& leaf) { return !leaf.is_within; }));
  if (stuck > 0) text += fmt::format("; {} could not be cut further", with_separators(stuck));
  return summary_line("cuts", text);
}

std::string covers_line(const Decomposition& decomposition) {
  const std::string triangles = counted(decomposition.tested_triangles, "triangle", "triangles");
  if (const auto* partition = std::get_if<Partition>(&decomposition.origin)) {
    return summary_line(
        "covers",
        fmt::format("{}: what each of {} has of it, and of {}, lies in one part, tested exactly",
                    decomposition.surface.is_closed ? "solid and surface" : "surface",
                    counted(partition->leaves.size(), "region", "regions"), triangles));
  }
  return summary_line(
      "covers",
      fmt::format("surface: each of {} lies in the part that owns it, tested exactly", triangles));
}

// The volumes are of the stored parts. That the surface is covered says nothing about them.
std::string measures_lines(const DecompositionMeasures& measures) {
  std::string text;
  if (measures.solid_volume) {
    const Enclosure& solid = measures.solid_volume->bounds;
    if (measures.excess_volume) {
      text +=
          summary_line("excess", fmt::format("volume {}{} of the parts is outside of the solid",
                                             interval_text(*measures.excess_volume),
                                             share_text(measures.excess_volume->bounds, solid)));
    }
  }
  if (!measures.union_volume) return text;
  return text + summary_line("union", fmt::format("volume {}; the parts overlap by {}",
                                                  interval_text(*measures.union_volume),
                                                  interval_text(*measures.overlap_volume)));
}

std::string apart_line(const Decomposition& decomposition) {
  if (!decomposition.apart) return "";
  const Rational& squared = decomposition.apart->squared_push;
  return summary_line(
      "disjoint", squared == 0 ? "no two parts have a common interior point, proven"
                               : "a plane is between each two parts, beyond which neither reaches "
                                 "farther than " +
                                     length_text(squared, decomposition) + ", proven");
}

// What the solid lacks, first of all: a result with voids does not begin with what it covers.
std::string hollow_line(const Decomposition& decomposition) {
  const auto& measures = decomposition.measures;
  if (!measures || !measures->uncovered_volume) return "";
  const Enclosure& uncovered = measures->uncovered_volume->bounds;
  if (uncovered.high() <= 0) {
    return summary_line("hollow", "nothing: the parts hold the solid");
  }
  return summary_line("hollow", fmt::format("volume {} of {}{} of the solid is in no part",
                                            interval_text(*measures->uncovered_volume),
                                            interval_text(*measures->solid_volume),
                                            share_text(uncovered, measures->solid_volume->bounds)));
}

// The way out of results that users complain about.
std::string way_out_notes(const Decomposition& decomposition) {
  const auto& measures = decomposition.measures;
  if (!measures || !measures->solid_volume) return "";
  const Enclosure& solid = measures->solid_volume->bounds;
  const auto exceeds = [&](const std::optional<Measured>& volume, long percent) {
    return volume && (volume->bounds * Enclosure(Integer(100), kMeasureBits) -
                      solid * Enclosure(Integer(percent), kMeasureBits))
                             .low() > 0;
  };
  constexpr long kMuch = 20, kSome = 1;
  std::string text;
  if (exceeds(measures->excess_volume, kMuch) && !decomposition.reach) {
    text += summary_line("note",
                         "the parts fill more than 20% beyond the solid: --method cut opens "
                         "cavities, and so does --guard reach, with --merge reach for few parts");
  }
  if (exceeds(measures->uncovered_volume, kSome)) {
    text += summary_line("note",
                         "where no triangle joins both sides of a wall, no part holds its inside: "
                         "--method cut holds the solid; a larger --concavity joins more of them");
  }
  return text;
}

std::string left_out_line(const Decomposition& decomposition, PartMeasures wanted) {
  if (wanted == PartMeasures::All) return "";
  if (!decomposition.surface.is_closed) {
    return summary_line("left out", "volume and overlap of the parts: --measures all");
  }
  return wanted == PartMeasures::Uncovered
             ? summary_line("left out",
                            "excess, and volume and overlap of the parts: --measures all")
             : summary_line("left out", "all volumes: --measures uncovered, --measures all");
}

std::string stored_line(const Decomposition& decomposition, Precision precision) {
  const auto count = [&](PartForm form) {
    return static_cast<std::size_t>(
        std::count_if(decomposition.parts.begin(), decomposition.parts.end(),
                      [&](const Part& part) { return part.form == form; }));
  };
  const bool is_cut = std::holds_alternative<Partition>(decomposition.origin);
  const std::pair<PartForm, const char*> said_of[] = {
      {PartForm::Hull, is_cut ? "exactly" : "with corners of the input, bit by bit"},
      {PartForm::Rounded, "rounded outward"},
      {PartForm::Simplified, "simplified"},
      {PartForm::Thickened, "flat, and thickened"},
      {PartForm::Flat, "flat, and left so"}};
  std::vector<std::string> forms;
  for (const auto& [form, said] : said_of) {
    if (const std::size_t parts = count(form)) {
      forms.push_back(fmt::format("{} {}", with_separators(parts), said));
    }
  }
  return summary_line("stored", fmt::format("in {}: {}", name_in(kPrecisionNames, precision),
                                            fmt::join(forms, ", ")));
}

// The changes to the surface, and its properties that may be unexpected.
std::string surface_notes(const Surface& surface) {
  std::size_t turned = 0, reversed = 0;
  for (const SurfaceComponent& component : surface.components) {
    turned += component.turned;
    reversed += component.is_reversed ? 1 : 0;
  }
  std::string text;
  const auto note = [&](std::size_t count, const char* one, const char* many,
                        const std::string& what) {
    if (count > 0) text += summary_line("note", counted(count, one, many) + what);
  };
  note(turned, "triangle was", "triangles were", " turned; --orient keep turns none");
  note(reversed, "component was", "components were", " inside out");
  note(surface.contradictions, "edge joins", "edges join",
       " triangles that cannot both look outward");
  note(surface.ambiguous_edges, "edge joins", "edges join",
       " sheets of which it is not clear how they belong together");
  note(surface.bent_faces, "face is", "faces are", " not planar: cut as a fan of triangles");
  note(surface.fans.size() - surface.bent_faces, "face is", "faces are",
       " not simple, as edges cross: cut as a fan of triangles");
  note(surface.flat_triangles, "triangle has", "triangles have", " no area");
  note(surface.repeated_triangles, "triangle repeats", "triangles repeat", " an earlier one");
  note(count_near_corners(surface), "corner lies", "corners lie",
       " within a millionth of the diameter of another one, and most components are open: the file "
       "may repeat corners with other roundings; --weld 1e-6d joins them");
  note(surface.unused.size(), "point is", "points are",
       " used by no face, and held by the nearest part; --points used leaves such points out");
  return text;
}

}  // namespace

std::string proven_of_parts(const Decomposition& decomposition) {
  std::string text =
      fmt::format("{} hold{} the {}", counted(decomposition.parts.size(), "part", "parts"),
                  decomposition.parts.size() == 1 ? "s" : "", covered_name(decomposition));
  if (decomposition.reach && decomposition.reach->farther.empty()) {
    if (decomposition.reach->squared_distance == 0) return text + " and nothing else";
    text += "; no point of them is farther than " +
            length_text(decomposition.reach->squared_distance, decomposition) + " from it";
  }
  return text;
}

std::string summary(const Decomposition& decomposition, const DecomposeRequest& request,
                    std::span<const std::string> names) {
  std::string text;
  if (decomposition.caps > 0) {
    const Enclosure largest = percent_of(enclosed_root_of(decomposition.squared_largest_cap),
                                         decomposition.squared_diameter());
    text += summary_line(
        "closed", fmt::format("by {}, the largest {} of the diameter wide; --close "
                              "never takes the surface as it is",
                              counted(decomposition.caps, "cap", "caps"), percent_text(largest)));
  }
  text += guarantee_line(decomposition) + parts_line(decomposition.parts);
  if (const std::size_t merged = decomposition.reach ? decomposition.reach->merged : 0) {
    text += summary_line("", counted(merged, "part", "parts") + " merged with others by reach");
  }
  if (const std::size_t inner = decomposition.inner.size()) {
    text += summary_line("", counted(inner, "cluster", "clusters") +
                                 " inside of other parts left out; --keep-inner keeps such parts");
  }
  text += hollow_line(decomposition) + reach_lines(decomposition, names) +
          excess_line(decomposition) + apart_line(decomposition) + way_out_notes(decomposition);
  text += summary_line("input", surface_text(decomposition.surface));
  text += surface_notes(decomposition.surface);
  const auto* partition = std::get_if<Partition>(&decomposition.origin);
  if (partition == nullptr) {
    text += concavity_line(decomposition, names) + limit_line(decomposition, request);
  }
  if (const auto* clustering = std::get_if<Clustering>(&decomposition.origin)) {
    text += merges_line(*clustering);
  } else if (partition != nullptr) {
    text += cuts_line(*partition);
  } else {
    text += splits_line(std::get<SplitTree>(decomposition.origin));
  }
  text += covers_line(decomposition);
  if (decomposition.measures) text += measures_lines(*decomposition.measures);
  text += left_out_line(decomposition, request.measures);
  return text + stored_line(decomposition, request.precision);
}

}  // namespace convexact
