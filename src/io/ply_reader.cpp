// SPDX-License-Identifier: MIT
// PLY, as text and binary of either byte order: the points and polygons are read, every other
// element and property is skipped by its declared size.
#include <cmath>

#include "io/mesh_readers.hpp"
#include "io/ply_header.hpp"
#include "io/point_collector.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

// Both kinds of bodies offer the same operations on one row of an element after another. In a text
// a value takes at least two bytes, with its blank; the last one may lack the blank.

class TextBody {
 public:
  TextBody(TextCursor& cursor, Decimal decimal) : cursor_(cursor), points_(decimal) {}

  bool can_hold(std::uint64_t count, PlyType) const { return 2 * count <= cursor_.remaining() + 1; }
  void begin_row(std::string_view element, std::size_t row) {
    if (!cursor_.next_line()) fail_short(element, row);
  }
  void end_row() { cursor_.expect_line_end(); }
  void skip(PlyType, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) (void)cursor_.expect_token("a value per property");
  }
  std::uint32_t take_count(PlyType) { return take_integer("the length of a list"); }
  std::uint32_t take_index(PlyType) { return take_integer("the index of a point, from 0"); }
  /// -1 stands for an end.
  std::int64_t take_signed_index(PlyType) {
    const std::string_view token = cursor_.expect_token("the index of a point, or -1");
    return token == "-1" ? std::int64_t{-1}
                         : cursor_.to_count(token, "the index of a point, or -1");
  }
  void take_coordinate(PlyType, int axis) { row_[axis] = cursor_.expect_token("a coordinate"); }
  void end_point() { points_.add(row_, cursor_); }
  void expect_end() { cursor_.expect_end(); }
  PointSet finish() { return points_.finish(); }
  [[noreturn]] void fail(const std::string& message) const { cursor_.fail(message); }
  [[noreturn]] void fail_short(std::string_view element, std::size_t row) const {
    fail("expected " + std::string(element) + " " + std::to_string(row) +
         ", found the end of the file");
  }

 private:
  std::uint32_t take_integer(std::string_view what) {
    return cursor_.to_count(cursor_.expect_token(what), what);
  }
  TextCursor& cursor_;
  PointCollector points_;
  std::array<std::string_view, 3> row_;
};

class BinaryBody {
 public:
  BinaryBody(BinaryCursor cursor, Decimal decimal) : cursor_(cursor), decimal_(decimal) {}

  bool can_hold(std::uint64_t count, PlyType type) const {
    return count * size_of(type) <= cursor_.remaining();
  }
  void begin_row(std::string_view element, std::size_t row) {
    element_ = element;
    row_number_ = row;
  }
  void end_row() {}
  void skip(PlyType type, std::uint32_t count) {
    demand(type, count);
    cursor_.skip(count * size_of(type));
  }
  std::uint32_t take_count(PlyType type) { return take_integer(type); }
  std::uint32_t take_index(PlyType type) { return take_integer(type); }
  std::int64_t take_signed_index(PlyType type) {
    demand(type, 1);
    return take_signed(type);
  }
  void take_coordinate(PlyType type, int axis) {
    demand(type, 1);
    const std::size_t start = cursor_.offset();
    const double stored = take_number(type);
    // The conversion rounds half to even, and beyond the largest binary32 number to infinity.
    row_[axis] = decimal_ == Decimal::Nearest32 ? static_cast<float>(stored) : stored;
    if (std::isfinite(row_[axis])) return;
    throw Error(ErrorCode::NotFinite,
                "at byte " + std::to_string(start) + ": expected a finite number in point " +
                    std::to_string(row_number_) + ", found " +
                    (std::isfinite(stored) ? "one beyond binary32" : "NaN or infinity"));
  }
  void end_point() { points_.push_back(row_); }
  void expect_end() const {
    if (cursor_.remaining() > 0) fail("expected the end of the file, found more bytes");
  }
  PointSet finish() { return PointSet(std::move(points_)); }
  [[noreturn]] void fail(const std::string& message) const { cursor_.fail(message); }
  [[noreturn]] void fail_short(std::string_view element, std::size_t row) const {
    fail("expected " + std::string(element) + " " + std::to_string(row) +
         ", found the end of the file");
  }

 private:
  void demand(PlyType type, std::uint32_t count) const {
    if (!can_hold(count, type)) fail_short(element_, row_number_);
  }
  double take_number(PlyType type) {
    if (type == PlyType::Float64) return cursor_.take_double();
    if (type == PlyType::Float32) return cursor_.take_float();
    return static_cast<double>(take_signed(type));
  }
  std::int64_t take_signed(PlyType type) {
    switch (type) {
      case PlyType::Int8:
        return static_cast<std::int8_t>(cursor_.take<std::uint8_t>());
      case PlyType::UInt8:
        return cursor_.take<std::uint8_t>();
      case PlyType::Int16:
        return static_cast<std::int16_t>(cursor_.take<std::uint16_t>());
      case PlyType::UInt16:
        return cursor_.take<std::uint16_t>();
      case PlyType::Int32:
        return static_cast<std::int32_t>(cursor_.take<std::uint32_t>());
      default:
        return cursor_.take<std::uint32_t>();
    }
  }
  std::uint32_t take_integer(PlyType type) {
    demand(type, 1);
    const std::int64_t value = take_signed(type);
    if (value < 0) fail("expected a length or index, found " + std::to_string(value));
    return static_cast<std::uint32_t>(value);
  }

  BinaryCursor cursor_;
  Decimal decimal_;
  std::string_view element_;
  std::size_t row_number_ = 0;
  Point row_;
  std::vector<Point> points_;
};

template <class Body>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, std::uint32_t point_count, Body& body, bool is_strict)
      : header_(header), point_count_(point_count), body_(body), is_strict_(is_strict) {}

  Mesh read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;  // any number of empty rows
      check_count(element);
      for (std::uint32_t row = 0; row < element.count; ++row) read_row(element, row);
    }
    body_.expect_end();
    mesh_.parts.push_back({"", 0, mesh_.polygons.size()});
    if (skipped_faces_ > 0) mesh_.notes.push_back(skipped_faces_note(skipped_faces_));
    if (has_strips_) {
      mesh_.notes.push_back("strips of triangles were read as " +
                            counted(mesh_.polygons.size(), "triangle", "triangles"));
    }
    mesh_.points = body_.finish();
    return std::move(mesh_);
  }

 private:
  void check_count(const PlyElement& element) const {
    // The shortest row has empty lists. Its size is a sum of bytes, since types differ in size.
    bool fits = true;
    std::uint64_t shortest = 0;
    for (const PlyProperty& property : element.properties) {
      const PlyType type = property.count_type.value_or(property.type);
      shortest += header_.binary ? size_of(type) : 1;
      fits = fits && body_.can_hold(element.count, type);
    }
    fits = fits && body_.can_hold(element.count * shortest, PlyType::UInt8);
    if (!fits) {
      body_.fail("expected " + std::to_string(element.count) + " rows of element " +
                 in_quotes(element.name) + ", found a file too short for them");
    }
  }

  void read_row(const PlyElement& element, std::uint32_t row) {
    body_.begin_row(element.name, row);
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
    for (const PlyProperty& property : element.properties) {
      if (is_vertex && property.name.size() == 1 && property.name >= "x" && property.name <= "z") {
        body_.take_coordinate(property.type, property.name.front() - 'x');
      } else if (is_face && is_corner_list(property)) {
        read_polygon(property);
      } else if (element.name == "tristrips" && is_corner_list(property)) {
        read_strips(property);
      } else {
        body_.skip(property.type, property.count_type ? read_length(property) : 1);
      }
    }
    if (is_vertex) body_.end_point();
    body_.end_row();
  }

  static bool is_corner_list(const PlyProperty& property) {
    return property.name == "vertex_indices" || property.name == "vertex_index";
  }

  std::uint32_t read_length(const PlyProperty& property) {
    const std::uint32_t length = body_.take_count(*property.count_type);
    if (!body_.can_hold(length, property.type)) {
      body_.fail("expected a list of " + std::to_string(length) +
                 " values, found a file too short for it");
    }
    return length;
  }

  void read_polygon(const PlyProperty& property) {
    const std::uint32_t length = read_length(property);
    std::vector<std::uint32_t> corners(length);
    for (std::uint32_t& corner : corners) corner = checked(body_.take_index(property.type));
    if (length < 3) {
      if (is_strict_) {
        body_.fail("expected a polygon of at least 3 corners, found " + std::to_string(length));
      }
      ++skipped_faces_;
    } else {
      mesh_.polygons.push_back(std::move(corners));
    }
  }

  // Corners one after another, -1 between strips. Every second triangle of a strip is turned.
  void read_strips(const PlyProperty& property) {
    const std::uint32_t length = read_length(property);
    std::vector<std::uint32_t> strip;
    for (std::uint32_t k = 0; k < length; ++k) {
      const std::int64_t corner = body_.take_signed_index(property.type);
      if (corner == -1) {
        strip.clear();
        continue;
      }
      strip.push_back(checked(corner));
      const std::size_t n = strip.size();
      if (n < 3) continue;
      const std::uint32_t a = strip[n - 3], b = strip[n - 2], c = strip[n - 1];
      if (a == b || b == c || c == a) continue;  // it joins two strips
      mesh_.polygons.push_back(n % 2 == 1 ? std::vector{a, b, c} : std::vector{b, a, c});
    }
    has_strips_ = true;
  }

  std::uint32_t checked(std::int64_t corner) const {
    if (corner < 0 || corner >= point_count_) {
      body_.fail("expected an index below " + std::to_string(point_count_) + ", found " +
                 std::to_string(corner));
    }
    return static_cast<std::uint32_t>(corner);
  }

  const PlyHeader& header_;
  std::uint32_t point_count_;
  Body& body_;
  bool is_strict_;
  Mesh mesh_;
  std::size_t skipped_faces_ = 0;  // of fewer than 3 corners
  bool has_strips_ = false;
};

// Requires what the readers above assume about the two elements that they read.
const PlyElement& check_declarations(const PlyHeader& header, const TextCursor& cursor) {
  const PlyElement* vertex = header.find("vertex");
  int coordinates = 0;
  for (const PlyProperty& property : vertex ? vertex->properties : std::vector<PlyProperty>()) {
    const bool is_axis = property.name == "x" || property.name == "y" || property.name == "z";
    if (is_axis && !property.count_type) ++coordinates;
  }
  if (coordinates != 3) {
    cursor.fail("expected an element vertex with the properties x, y and z, none of them a list");
  }
  for (const char* name : {"face", "tristrips"}) {
    const PlyElement* face = header.find(name);
    if (face == nullptr) continue;
    for (const PlyProperty& property : face->properties) {
      const bool is_corners = property.name == "vertex_indices" || property.name == "vertex_index";
      if (is_corners && (!property.count_type || !is_integer(property.type))) {
        cursor.fail("expected " + in_quotes(property.name) + " to be a list of integers");
      }
    }
  }
  return *vertex;
}

}  // namespace

Mesh read_ply(std::string_view bytes, const ReadOptions& options) {
  TextCursor cursor(bytes);
  const PlyHeader header = read_ply_header(bytes, cursor);
  const std::uint32_t point_count = check_declarations(header, cursor).count;
  if (header.binary) {
    BinaryBody body(BinaryCursor(bytes, header.body, *header.binary), options.decimal);
    return PlyReader<BinaryBody>(header, point_count, body, options.strict).read();
  }
  TextBody body(cursor, options.decimal);
  return PlyReader<TextBody>(header, point_count, body, options.strict).read();
}

}  // namespace convexact
