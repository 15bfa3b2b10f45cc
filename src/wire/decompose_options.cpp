// SPDX-License-Identifier: MIT
#include "wire/decompose_options.hpp"

#include <fmt/format.h>

#include "convexact/error.hpp"
#include "number/text.hpp"
#include "simplify/run_names.hpp"

namespace convexact {

namespace {

constexpr auto kBitsNames =
    name_table<Precision>({{Precision::Binary64, "64"}, {Precision::Binary32, "32"}});

std::string spell_limit(const ConcavityLimit& limit) {
  return limit.is_share ? to_string(Rational(limit.value * 100)) + "%" : to_string(limit.value);
}

constexpr std::uint64_t kMostFaces = std::uint64_t(1) << 32;

Fields<DecomposeRequest> make_fields() {
  using R = DecomposeRequest;
  Fields<R> fields = {
      choice_field<R>(
          "method", &R::method, kDecomposeMethodNames,
          "auto: cut for solids, hacd for open surfaces and if one of its options is "
          "given; cut cuts the solid by planes into few parts that hold it, none farther "
          "from it than the distance; hacd merges neighbouring triangles, then "
          "clusters, by concavity and shape; acd splits the most concave part at its "
          "deepest notch, again and again"),
      text_field<R>(
          "concavity", &R::limit, parse_concavity, spell_limit,
          "hacd and acd: how deep a cluster may lie in its hull: a share of the diameter, "
          "3% or 0.03d, or a length, 0.05"),
      count_field<R>("max_parts", &R::max_parts, {1},
                     "at least 1: cut and hacd keep merging, beyond the distance or the concavity "
                     "allowed, until this many parts are left; acd stops splitting at this many"),
      choice_field<R>("guard", &R::guard, kReachUseNames,
                      "reach: no part is made that reaches farther from the solid than the "
                      "distance allowed, so that cavities stay open"),
      choice_field<R>("merge", &R::merge, kReachUseNames,
                      "reach: parts are merged in the end, adjacent or not, as long as none "
                      "reaches farther than the distance allowed"),
      text_field<R>(
          "distance", &R::distance, parse_concavity,
          [](const std::optional<ConcavityLimit>& limit) {
            return spell_limit(limit.value_or(kDefaultDistance));
          },
          "how far a point of a part may be from the solid, for cut, guard and merge: a share of "
          "the diameter, 3% or 0.03d, or a length, 0.05; 0, cut only: parts in the solid, exactly"),
      choice_field<R>("effort", &R::effort, kEffortNames,
                      "cut only: how much to try for fewer parts: high takes several times as long "
                      "as low"),
      text_field<R>(
          "max_excess", &R::max_excess, parse_excess,
          [](const std::optional<Rational>& share) {
            return share ? to_string(Rational(*share * 100)) + "%" : std::string("none");
          },
          "cut only: how much larger the volumes of the parts together may be than the "
          "solid's: a share of it, 20%"),
      flag_field<R>("disjoint", &R::disjoint,
                    "cut only: parts have no common interior, but for what rounding moves their "
                    "corners, which is told and proven; takes more parts"),
      choice_field<R>(
          "close", &R::close, kCloseNames,
          "for cut, guard and merge: a surface whose borders are all at most a quarter of "
          "the diameter wide is closed by caps, or never"),
      choice_field<R>("measure", &R::measure, kConcavityMeasureNames,
                      "hacd only: concavity at every point of the triangles, or at their corners "
                      "only, as published, which sees no notch whose corners all lie on the hull"),
      choice_field<R>(
          "bridge", &R::bridge, kBridgeChoiceNames,
          "acd only: concavity is the distance to a bridge, facets of the hull over the "
          "nearest path; to the farther of its bridges, to that of the whole region, or "
          "to the nearer"),
      text_field<R>(
          "coplanar", &R::coplanar, parse_cosine,
          [](const Rational& x) { return fmt::format("{}", to_double(x, Rounding::Nearest)); },
          "acd only: facets are one bridge where the cosine of the angle between their "
          "normals is larger; above 0, at most 1"),
      count_field<R>("faces", &R::faces, {4, kMostFaces},
                     "how many halfspaces to keep of each part, at least 4"),
      count_field<R>("max_part_vertices", &R::max_vertices, {4, kMostFaces},
                     "corners that a part may have, at least 4: one with more keeps so few faces "
                     "that it cannot have more"),
      count_field<R>("total_faces", &R::total_faces, {4, kMostFaces},
                     "how many halfspaces to keep in all parts together, at least 4 for each"),
      choice_field<R>(
          "flat", &R::flat, kFlatPartsNames,
          "how to treat clusters in a plane: thicken them, keep polygons, or merge them "
          "with a neighbour; auto thickens, and refuses an input that is entirely flat"),
      flag_field<R>("keep_inner", &R::keep_inner, "keep parts that lie in another part"),
      choice_field<R>("connect", &R::connect, kConnectNames,
                      "neighbours have a common edge; or also edges that overlap; or also a common "
                      "point of two components"),
      choice_field<R>(
          "orient", &R::orient, kOrientationNames,
          "turn faces so that they bound the solid correctly, or keep them as they are"),
      choice_field<R>("loose", &R::loose, kLoosePointsNames,
                      "points that no face uses go to the nearest part, or are refused"),
      choice_field<R>("engine", &R::engine, kEngineNames,
                      "hacd and cut: rationals everywhere, or the same parts, faster; hacd only: "
                      "doubles that choose, the parts still proven"),
      jobs_field<R>("threads for cutting, merging by reach and proofs, by default as many as there "
                    "are cores; the parts do not depend on it"),
      choice_field<R>("precision", &R::precision, kBitsNames,
                      "the numbers of the parts: binary64, or rounded outward to binary32")};
  for (Field<R>& field : fields) {
    if (field.name == "faces") field.letter = 'k';
  }
  return fields;
}

Fields<DecomposeRequest> make_call_fields() {
  using R = DecomposeRequest;
  Fields<R> fields = decompose_fields();
  fields.push_back(flag_field<R>("tree", &R::for_tree,
                                 "find the merges that would come next, for a tree of the parts"));
  fields.push_back(flag_field<R>("exact_volumes", &R::exact_volumes,
                                 "volumes as fractions, too, which may be very long"));
  Field<R> no_measures{
      {"no_measures", FieldKind::Flag, "measure no volumes and distances", {}, {}, 0},
      [](R& request, const std::string&, const std::string& text) {
        request.measures = text == "true" ? PartMeasures::None : PartMeasures::All;
      },
      [](const R& request) { return request.measures == PartMeasures::None ? "true" : ""; }};
  fields.push_back(std::move(no_measures));
  fields.push_back(count_field<R>("seed", &R::seed, {}, "of every random order"));
  return fields;
}

Fields<TreeRequest> make_tree_fields() {
  using R = TreeRequest;
  Fields<R> fields = {
      count_field<R>("faces", &R::faces, {4, kMostFaces},
                     "how many halfspaces to keep of each branch, at least 4"),
      count_field<R>("leaf_faces", &R::leaf_faces, {4, kMostFaces},
                     "how many halfspaces to keep of each part, at least 4"),
      choice_field<R>("precision", &R::precision, kBitsNames,
                      "the numbers of the hulls: binary64, or rounded outward to binary32")};
  fields[0].letter = 'k';
  return fields;
}

}  // namespace

const Fields<DecomposeRequest>& decompose_fields() {
  static const Fields<DecomposeRequest> fields = make_fields();
  return fields;
}

const Fields<DecomposeRequest>& decompose_call_fields() {
  static const Fields<DecomposeRequest> fields = make_call_fields();
  return fields;
}

const Fields<TreeRequest>& tree_fields() {
  static const Fields<TreeRequest> fields = make_tree_fields();
  return fields;
}

ConcavityLimit parse_concavity(const std::string& option, const std::string& text) {
  const bool is_percent = text.ends_with('%'), is_share = is_percent || text.ends_with('d');
  try {
    Rational value = parse_rational(text.substr(0, text.size() - (is_share ? 1 : 0)));
    if (is_percent) value /= 100;
    if (value >= 0 && (!is_share || value <= 1)) return {std::move(value), is_share};
  } catch (const Error&) {  // told below
  }
  throw Error(ErrorCode::InvalidArgument,
              option +
                  ": expected a share of the diameter from 0 to 1, such as 3% or 0.03d, or a "
                  "length of at least 0, such as 0.05, found " +
                  in_quotes(text));
}

Rational parse_excess(const std::string& option, const std::string& text) {
  try {
    if (text.ends_with('%')) {
      Rational share = parse_rational(text.substr(0, text.size() - 1)) / 100;
      if (share >= 0) return share;
    }
  } catch (const Error&) {  // told below
  }
  throw Error(ErrorCode::InvalidArgument,
              option +
                  ": expected a share of the solid's volume, at least 0%, such as 20%, found " +
                  in_quotes(text));
}

Rational parse_cosine(const std::string& option, const std::string& text) {
  try {
    Rational cosine = parse_rational(text);
    if (cosine > 0 && cosine <= 1) return cosine;
  } catch (const Error&) {  // told below
  }
  throw Error(ErrorCode::InvalidArgument,
              option +
                  ": expected the cosine of an angle, above 0 and at most 1, such as 0.99, found " +
                  in_quotes(text));
}

}  // namespace convexact
