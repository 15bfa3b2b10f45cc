// SPDX-License-Identifier: MIT
#include "pages/solids_picture.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/json_document.hpp"
#include "io/used_points.hpp"
#include "number/text.hpp"
#include "wire/simplify_report.hpp"

namespace convexact {
namespace {

const PointSet* points_of(const SceneObject& object) {
  return std::get_if<PointSet>(&object.shape);
}

// The file's name without its folder and without the part that may follow.
std::string file_of(const SceneObject& object) {
  std::string path = object.name;
  const std::string part = ": " + object.part;
  if (path.ends_with(part)) path.resize(path.size() - part.size());
  return std::filesystem::path(path).filename().string();
}

// A scan has many points that no face uses; over its surface they would look like cracks.
PictureLayer points_of_no_face(const PictureLayer& input) {
  PictureLayer loose{.name = "points that no face uses", .color = "#009e73", .shown = false};
  const std::vector<bool> is_used = used_points(input.points.size(), input.polygons);
  for (std::size_t k = 0; k < is_used.size(); ++k) {
    if (!is_used[k]) loose.points.push_back(input.points[k]);
  }
  return loose;
}

// Of all objects together.
std::string growth_of(const std::vector<DrawnSolid>& objects) {
  std::optional<std::array<Enclosure, 2>> sum;
  for (const DrawnSolid& object : objects) {
    if (!object.volumes) return "";
    const auto& [before, after] = *object.volumes;
    sum = sum ? std::array{(*sum)[0] + before, (*sum)[1] + after} : object.volumes;
  }
  if (!sum) return "";
  const bool is_changed = std::any_of(objects.begin(), objects.end(), [](const DrawnSolid& object) {
    return object.is_simplified;
  });
  return is_changed ? "; volume " + growth_percent((*sum)[0], (*sum)[1]) : "; nothing was removed";
}

}  // namespace

Picture solids_picture(const std::vector<DrawnSolid>& objects) {
  PictureLayer input{.name = "input", .color = "#e69f00"};
  PictureLayer solids{
      .name = "enclosing solid", .color = "#56b4e9", .opacity = 0.25, .edges = true, .right = true};
  PictureLayer kept{.name = "kept faces", .color = "#d55e00", .edges = true, .right = true};
  std::set<std::string> files;
  for (const DrawnSolid& object : objects) {
    files.insert(file_of(object.source));
    if (const PointSet* points = points_of(object.source)) {
      input.add(points->doubles(), object.source.polygons);
    }
    solids.add_to_pick(object.solid.exact,
                       objects.size() > 1 ? as_utf8(object.source.name) : "enclosing solid");
    for (const std::size_t plane : object.kept) kept.add_facet(object.solid.exact, plane);
  }
  Picture picture;
  picture.title = as_utf8(file_of(objects[0].source));
  if (files.size() > 1) picture.title += " and " + std::to_string(files.size() - 1) + " more";
  picture.answer =
      with_separators(solids.polygons.size()) + " halfspaces hold " +
      (objects.size() > 1 ? counted(objects.size(), "object", "objects") : "every point") +
      growth_of(objects);
  if (!input.points.empty()) {
    PictureLayer loose = points_of_no_face(input);
    const bool is_surface = !input.polygons.empty();
    picture.layers.push_back(std::move(input));
    if (is_surface && !loose.points.empty()) picture.layers.push_back(std::move(loose));
  }
  if (!kept.polygons.empty()) picture.layers.push_back(std::move(kept));
  picture.layers.push_back(std::move(solids));
  return picture;
}

Picture inner_picture(const std::vector<DrawnInner>& objects) {
  PictureLayer inner{.name = "inner hull", .color = "#56b4e9", .edges = true, .right = true};
  PictureLayer input{.name = "input", .color = "#e69f00"};
  PictureLayer hull{.name = "hull of the input", .color = "#8f8f8f", .opacity = 0.25};
  for (const auto& [source, result] : objects) {
    inner.add_to_pick(result.solid, objects.size() > 1 ? as_utf8(source.name) : "inner hull");
    input.add(std::get<PointSet>(source.shape).doubles(), source.polygons);
    std::vector<std::vector<std::uint32_t>> triangles;
    for (const auto& [a, b, c] : result.start.triangles) {
      triangles.push_back({a.value, b.value, c.value});
    }
    hull.add(result.start.points.doubles(), triangles);
  }
  return {.title = as_utf8(std::filesystem::path(objects[0].source.name).filename().string()),
          .answer = with_separators(inner.points.size()) +
                    " vertices of the input; their hull lies in its hull",
          .layers = {std::move(inner), std::move(input), std::move(hull)}};
}

DrawnSolid drawn(const SceneObject& source, const HullResult& result) {
  return {source, result.solid};
}

DrawnSolid drawn(const SceneObject& source, const SimplifyResult& result) {
  DrawnSolid object{source, result.solid};
  object.volumes = {result.input_volume.bounds, result.output_volume.bounds};
  object.is_simplified = result.steps > 0;
  for (const auto& kept : result.kept) object.kept.push_back(kept.plane);
  return object;
}

}  // namespace convexact
