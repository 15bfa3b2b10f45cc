// SPDX-License-Identifier: MIT
#include "pages/verdict_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "convexact/query.hpp"
#include "io/json_document.hpp"
#include "number/text.hpp"
#include "pages/part_colors.hpp"

namespace convexact {
namespace {

constexpr double kLeastBall = 0.01;  // of the size of the input

PictureLayer input_layer(const SceneObject& input) {
  PictureLayer layer{.name = "input", .color = "#e69f00"};
  if (const auto* points = std::get_if<PointSet>(&input.shape)) {
    layer.add(points->doubles(), input.polygons);
  } else if (const auto solid = queried_solid(input.shape);
             std::holds_alternative<Polytope>(solid)) {
    layer.add(std::get<Polytope>(solid));
  }
  return layer;
}

// The solid that a candidate stands for, and beside it the faces of a mesh as they are.
void add_candidate(const Candidate& candidate, Picture& picture) {
  Shape shape;
  PictureLayer faces{.name = "faces of the candidate",
                     .color = "#009e73",
                     .edges = true,
                     .shown = false,
                     .right = true};
  if (const auto* mesh = std::get_if<Mesh>(&candidate)) {
    faces.add(mesh->points.doubles(), mesh->polygons);
    shape = mesh->points;
  } else if (const auto* list = std::get_if<HalfspaceList>(&candidate)) {
    if (list->impossible_row) return;
    shape = list->halfspaces;
  } else {
    return;
  }
  if (!faces.polygons.empty()) picture.layers.push_back(std::move(faces));
  const auto solid = queried_solid(shape);
  if (!std::holds_alternative<Polytope>(solid)) return;
  picture.layers.push_back({.name = "candidate: the solid that it stands for",
                            .color = "#56b4e9",
                            .opacity = 0.25,
                            .edges = true,
                            .right = true});
  picture.layers.back().add_to_pick(std::get<Polytope>(solid), "candidate");
}

double size_of(const Picture& picture) {
  Point low = Point::Constant(HUGE_VAL), high = -low;
  for (const PictureLayer& layer : picture.layers) {
    for (const Point& p : layer.points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return std::isfinite(low[0]) ? (high - low).maxCoeff() : 1;
}

}  // namespace

Picture verdict_picture(const SceneObject& input, const Candidate& candidate,
                        const Verdict& verdict, const std::string& title,
                        const std::string& answer) {
  Picture picture{as_utf8(title), as_utf8(answer), {}};
  picture.layers.push_back(input_layer(input));
  add_candidate(candidate, picture);
  for (const Claim& claim : verdict.claims) {
    if (claim.status != Status::Violated || !claim.witness.point) continue;
    const double distance =
        claim.witness.squared_distance
            ? std::sqrt(to_double(*claim.witness.squared_distance, Rounding::Nearest))
            : 0;
    PictureLayer ball{
        .name = fmt::format("witness of {}{}", name_of(claim.code),
                            distance > 0 ? fmt::format(", {:.3g} away", distance) : ""),
        .color = kOutsideColor,
        .opacity = 0.5,
        .right = true,
        .faces_reader = true};
    ball.add_ball(drawn_at(*claim.witness.point),
                  std::max(distance, kLeastBall * size_of(picture)));
    picture.layers.push_back(std::move(ball));
    break;
  }
  return picture;
}

}  // namespace convexact
