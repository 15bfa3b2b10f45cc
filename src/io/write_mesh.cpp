// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/glb_writer.hpp"
#include "io/output_buffer.hpp"

namespace convexact {
namespace {

bool is_binary32(double x) {
  return std::abs(x) <= std::numeric_limits<float>::max() &&
         static_cast<double>(static_cast<float>(x)) == x;
}

void check_representable(const Mesh& mesh, Precision precision) {
  if (!mesh.points.is_binary()) {
    throw Error(ErrorCode::Unrepresentable, "a mesh file cannot hold rationals as coordinates");
  }
  if (mesh.points.size() > std::numeric_limits<std::int32_t>::max()) {
    throw Error(ErrorCode::Unrepresentable, "a mesh file cannot hold 2^31 points or more");
  }
  if (precision == Precision::Binary64) return;
  for (const Point& p : mesh.points.doubles()) {
    if (!std::all_of(p.begin(), p.end(), is_binary32)) {
      throw Error(ErrorCode::Unrepresentable, "a coordinate is no number of binary32");
    }
  }
}

void check_names(const Mesh& mesh) {
  for (const MeshPart& part : mesh.parts) {
    if (part.name.find_first_of("\r\n") != std::string::npos) {
      throw Error(ErrorCode::InvalidArgument, "the name of a part has a line end");
    }
  }
}

// The parts as they are, or a single part that holds all polygons.
std::vector<MeshPart> parts_of(const Mesh& mesh) {
  return mesh.parts.empty() ? std::vector<MeshPart>{{"", 0, mesh.polygons.size()}} : mesh.parts;
}

void append_point(OutputBuffer& out, const Point& p) {
  out.number(p.x()).text(" ").number(p.y()).text(" ").number(p.z()).text("\n");
}

// "n i1 ... in" with indices from 0, as OFF and PLY have it.
void append_polygon(OutputBuffer& out, const std::vector<std::uint32_t>& polygon) {
  out.number(polygon.size());
  for (const std::uint32_t corner : polygon) out.text(" ").number(corner);
  out.text("\n");
}

std::string write_obj(const Mesh& mesh) {
  OutputBuffer out;
  for (const Point& p : mesh.points.doubles()) append_point(out.text("v "), p);
  const std::vector<MeshPart> parts = parts_of(mesh);
  for (const MeshPart& part : parts) {
    // The format has all points first, so a part that is only points cannot say which are its own.
    if (part.first_polygon == part.last_polygon) continue;
    if (parts.size() > 1 || !part.name.empty()) out.text("o ").text(part.name).text("\n");
    for (std::size_t f = part.first_polygon; f < part.last_polygon; ++f) {
      out.text("f");
      for (const std::uint32_t corner : mesh.polygons[f]) out.text(" ").number(corner + 1);
      out.text("\n");
    }
  }
  return out.finish();
}

std::string write_off(const Mesh& mesh) {
  OutputBuffer out;
  out.text("OFF\n").number(mesh.points.size()).text(" ").number(mesh.polygons.size());
  out.text(" 0\n");
  for (const Point& p : mesh.points.doubles()) append_point(out, p);
  for (const auto& polygon : mesh.polygons) append_polygon(out, polygon);
  return out.finish();
}

std::string write_xyz(const Mesh& mesh) {
  OutputBuffer out;
  for (const Point& p : mesh.points.doubles()) append_point(out, p);
  return out.finish();
}

// Lengths of lists take one byte, as every reader expects, unless some polygon is too long for one.
bool has_long_polygon(const Mesh& mesh) {
  return std::any_of(mesh.polygons.begin(), mesh.polygons.end(),
                     [](const auto& polygon) { return polygon.size() > 255; });
}

void append_ply_body(OutputBuffer& out, const Mesh& mesh, Precision precision) {
  for (const Point& p : mesh.points.doubles()) {
    for (const double x : p) {
      if (precision == Precision::Binary64) {
        out.little_endian(x);
      } else {
        out.little_endian(static_cast<float>(x));
      }
    }
  }
  const bool has_long = has_long_polygon(mesh);
  for (const auto& polygon : mesh.polygons) {
    if (has_long) {
      out.little_endian(static_cast<std::uint32_t>(polygon.size()));
    } else {
      out.little_endian(static_cast<std::uint8_t>(polygon.size()));
    }
    for (const std::uint32_t corner : polygon) out.little_endian(corner);
  }
}

std::string write_ply(const Mesh& mesh, const MeshWriteOptions& options) {
  OutputBuffer out;
  const bool is_text = options.encoding == Encoding::Text;
  const std::string_view type = options.precision == Precision::Binary64 ? "double" : "float";
  out.text("ply\nformat ").text(is_text ? "ascii" : "binary_little_endian").text(" 1.0\n");
  out.text("element vertex ").number(mesh.points.size()).text("\n");
  for (const char* axis : {"x", "y", "z"}) {
    out.text("property ").text(type).text(" ").text(axis).text("\n");
  }
  out.text("element face ").number(mesh.polygons.size()).text("\nproperty list ");
  out.text(has_long_polygon(mesh) ? "uint" : "uchar").text(" int vertex_indices\nend_header\n");
  if (is_text) {
    for (const Point& p : mesh.points.doubles()) append_point(out, p);
    for (const auto& polygon : mesh.polygons) append_polygon(out, polygon);
  } else {
    append_ply_body(out, mesh, options.precision);
  }
  return out.finish();
}

// Unit normal for display only, in plain doubles; zero, which STL allows, if it cannot be computed.
Point display_normal(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a, v = c - a;
  const Point normal =
      (u / u.lpNorm<Eigen::Infinity>()).cross(v / v.lpNorm<Eigen::Infinity>()).normalized();
  return normal.allFinite() ? normal : Point(0, 0, 0);
}

// Calls visit(a, b, c) for each triangle of the fans of the polygons [first, last).
template <class Visitor>
void for_each_triangle(const Mesh& mesh, std::size_t first, std::size_t last, Visitor&& visit) {
  const auto points = mesh.points.doubles();
  for (std::size_t f = first; f < last; ++f) {
    const auto& polygon = mesh.polygons[f];
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      visit(points[polygon[0]], points[polygon[k - 1]], points[polygon[k]]);
    }
  }
}

std::string write_stl_text(const Mesh& mesh) {
  OutputBuffer out;
  for (const MeshPart& part : parts_of(mesh)) {
    out.text("solid ").text(part.name).text("\n");
    for_each_triangle(mesh, part.first_polygon, part.last_polygon,
                      [&out](const Point& a, const Point& b, const Point& c) {
                        append_point(out.text("facet normal "), display_normal(a, b, c));
                        out.text("outer loop\n");
                        for (const Point& p : {a, b, c}) append_point(out.text("vertex "), p);
                        out.text("endloop\nendfacet\n");
                      });
    out.text("endsolid ").text(part.name).text("\n");
  }
  return out.finish();
}

std::string write_stl_binary(const Mesh& mesh) {
  OutputBuffer out;
  std::uint32_t count = 0;
  for_each_triangle(mesh, 0, mesh.polygons.size(), [&count](auto&&...) { ++count; });
  out.text(std::string(80, ' ')).little_endian(count);
  for_each_triangle(mesh, 0, mesh.polygons.size(),
                    [&out](const Point& a, const Point& b, const Point& c) {
                      for (const Point& p : {display_normal(a, b, c), a, b, c}) {
                        for (const double x : p) out.little_endian(static_cast<float>(x));
                      }
                      out.little_endian(std::uint16_t{0});
                    });
  return out.finish();
}

}  // namespace

std::string write_mesh(const Mesh& mesh, MeshFormat format, const MeshWriteOptions& options) {
  if (format == MeshFormat::Pcd || format == MeshFormat::Ext || format == MeshFormat::Collada) {
    throw Error(ErrorCode::InvalidArgument,
                "PCD, V-representations and COLLADA are read, not written");
  }
  if (format == MeshFormat::Gltf) {
    check_representable(mesh, Precision::Binary32);
    return write_glb(mesh, parts_of(mesh));
  }
  const bool is_binary = options.encoding == Encoding::Binary;
  const bool is_stl = format == MeshFormat::Stl;
  check_representable(mesh, is_binary && is_stl ? Precision::Binary32 : options.precision);
  check_names(mesh);
  if (is_stl) return is_binary ? write_stl_binary(mesh) : write_stl_text(mesh);
  if (format == MeshFormat::Ply) return write_ply(mesh, options);
  if (is_binary) {
    throw Error(ErrorCode::InvalidArgument, "OBJ, OFF and XYZ files are text, not binary");
  }
  if (format == MeshFormat::Xyz) return write_xyz(mesh);
  return format == MeshFormat::Obj ? write_obj(mesh) : write_off(mesh);
}

}  // namespace convexact
