// SPDX-License-Identifier: MIT
// OFF as text: a header such as "OFF" or "COFF", the counts, one point per line, one polygon per
// line. The prefixes ST, C and N announce numbers after each point's coordinates.
#include "io/mesh_readers.hpp"
#include "io/point_collector.hpp"

namespace convexact {
namespace {

class OffReader {
 public:
  OffReader(std::string_view bytes, Decimal decimal)
      : cursor_(bytes, {.comment = '#'}), points_(decimal) {}

  Mesh read() {
    std::string_view token = read_header();
    if (token.empty()) token = cursor_.expect_line("the numbers of points, polygons and edges");
    const std::uint32_t point_count = cursor_.to_count(token, "the number of points");
    const std::uint32_t polygon_count =
        cursor_.to_count(cursor_.expect_token("the number of polygons"), "the number of polygons");
    // The number of edges is not used, and some writers leave it out.
    if (const auto edges = cursor_.token(); !edges.empty()) {
      (void)cursor_.to_count(edges, "the number of edges");
    }
    cursor_.expect_line_end();
    check_counts(point_count, polygon_count);
    for (std::uint32_t k = 0; k < point_count; ++k) read_point();
    for (std::uint32_t k = 0; k < polygon_count; ++k) read_polygon();
    cursor_.expect_end();
    mesh_.parts.push_back({"", 0, mesh_.polygons.size()});
    mesh_.points = points_.finish();
    return std::move(mesh_);
  }

 private:
  // Returns the next token of the header's line, if any.
  std::string_view read_header() {
    const std::string_view header = cursor_.expect_line("an OFF header");
    std::string_view prefix = header;
    const auto takes = [&prefix](std::string_view part) {
      const bool found = prefix.starts_with(part);
      if (found) prefix.remove_prefix(part.size());
      return found;
    };
    for (const std::string_view part : {"ST", "C", "N"}) has_attributes_ |= takes(part);
    if (prefix != "OFF") {
      cursor_.fail_expected("a header of OFF for three dimensions, such as OFF or COFF", header);
    }
    const std::string_view next = cursor_.token();
    if (next == "BINARY") cursor_.fail("expected OFF as text, found its binary form");
    return next;
  }

  void check_counts(std::size_t points, std::size_t polygons) const {
    // A line with a single digit is wrong, but a message about that line is more helpful than one
    // about the size of the file.
    constexpr std::size_t kShortestLine = 2;
    if ((points + polygons) * kShortestLine > cursor_.remaining() + 1) {
      cursor_.fail("expected " + std::to_string(points) + " points and " +
                   std::to_string(polygons) + " polygons, found a file too short for them");
    }
  }

  void read_point() {
    std::array<std::string_view, 3> coordinates;
    coordinates[0] = cursor_.expect_line("point", points_.size());
    for (int k : {1, 2}) coordinates[k] = cursor_.expect_token("three coordinates");
    points_.add(coordinates, cursor_);
    if (!has_attributes_) return cursor_.expect_line_end();
    for (auto token = cursor_.token(); !token.empty(); token = cursor_.token()) {
      (void)cursor_.to_number(token);
    }
  }

  // n i1 ... in [colour]
  void read_polygon() {
    const std::string_view first = cursor_.expect_line("polygon", mesh_.polygons.size());
    const std::uint32_t size = cursor_.to_count(first, "the number of corners");
    if (size < 3) cursor_.fail_expected("a polygon of at least 3 corners", first);
    corners_.clear();
    for (std::uint32_t k = 0; k < size; ++k) {
      const std::string_view token = cursor_.expect_token("as many corners as announced");
      const std::uint32_t corner = cursor_.to_count(token, "the index of a point, from 0");
      if (corner >= points_.size()) {
        cursor_.fail_expected("an index below " + std::to_string(points_.size()), token);
      }
      corners_.push_back(corner);
    }
    mesh_.polygons.emplace_back(corners_.begin(), corners_.end());
    for (auto token = cursor_.token(); !token.empty(); token = cursor_.token()) {
      (void)cursor_.to_number(token);
    }
  }

  TextCursor cursor_;
  PointCollector points_;
  Mesh mesh_;
  std::vector<std::uint32_t> corners_;
  bool has_attributes_ = false;
};

}  // namespace

Mesh read_off(std::string_view bytes, Decimal decimal) { return OffReader(bytes, decimal).read(); }

}  // namespace convexact
