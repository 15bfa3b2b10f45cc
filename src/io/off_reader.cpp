// SPDX-License-Identifier: MIT
// OFF as text: a header such as "OFF" or "COFF", the counts, one point per line, one polygon per
// line; further numbers of a point are its colour, normal or texture, as prefixes ST, C and N
// announce, or as programs write without them. Or, as the format allows, numbers in free layout:
// then a point is three numbers and a polygon has no colour.
//
// qhull writes the dimension, 3, in the place of the header (option o).
// ModelNet40 has files whose header and counts are one line: "OFF490 518 0".
#include <array>

#include "io/mesh_readers.hpp"
#include "io/point_collector.hpp"

namespace convexact {
namespace {

class OffReader {
 public:
  OffReader(std::string_view bytes, const ReadOptions& options)
      : cursor_(bytes, {.comment = '#'}), points_(options.decimal), is_strict_(options.strict) {}

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
    is_free_ = has_free_layout(point_count, polygon_count);
    for (std::uint32_t k = 0; k < point_count; ++k) read_point();
    for (std::uint32_t k = 0; k < polygon_count; ++k) read_polygon();
    cursor_.expect_end();
    mesh_.parts.push_back({"", 0, mesh_.polygons.size()});
    if (skipped_faces_ > 0) mesh_.notes.push_back(skipped_faces_note(skipped_faces_));
    mesh_.points = points_.finish();
    return std::move(mesh_);
  }

 private:
  // Returns the next token of the header's line, if any.
  std::string_view read_header() {
    const std::string_view header = cursor_.expect_line("an OFF header");
    if (header == "3") return cursor_.token();  // is_off_of_qhull()
    std::string_view prefix = header;
    // In any order: MeshLab writes NCOFF.
    constexpr std::array<std::string_view, 3> kPrefixes = {"ST", "C", "N"};
    for (bool found = true; found;) {
      found = false;
      for (const std::string_view part : kPrefixes) {
        if (!prefix.starts_with(part)) continue;
        prefix.remove_prefix(part.size());
        found = true;
      }
    }
    const bool is_joined = prefix.size() > 3 && prefix.starts_with("OFF") &&
                           prefix.find_first_not_of("0123456789", 3) == prefix.npos;
    if (is_joined) return prefix.substr(3);
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

  // Whether the numbers are not in a line for each point and polygon, but there are enough.
  bool has_free_layout(std::size_t points, std::size_t polygons) const {
    if (points == 0) return false;
    TextCursor cursor = cursor_;
    std::size_t lines = 0, tokens = 0, in_first = 0;
    while (lines <= points + polygons && cursor.next_line()) {
      ++lines;
      while (!cursor.token().empty()) ++tokens;
      if (lines == 1) in_first = tokens;
    }
    const bool has_lines = lines >= points + polygons && in_first >= 3;
    if (has_lines) return false;
    while (cursor.next_line()) {
      while (!cursor.token().empty()) ++tokens;
    }
    return tokens >= 3 * points + 2 * polygons;
  }

  // The next number, wherever lines end.
  std::string_view next_free(std::string_view what, std::size_t number) {
    const std::string_view token = cursor_.token();
    return token.empty() ? cursor_.expect_line(what, number) : token;
  }

  void read_point() {
    std::array<std::string_view, 3> coordinates;
    if (is_free_) {
      for (auto& coordinate : coordinates) coordinate = next_free("point", points_.size());
      return points_.add(coordinates, cursor_);
    }
    coordinates[0] = cursor_.expect_line("point", points_.size());
    for (int k : {1, 2}) coordinates[k] = cursor_.expect_token("three coordinates");
    points_.add(coordinates, cursor_);
    for (auto token = cursor_.token(); !token.empty(); token = cursor_.token()) {
      (void)cursor_.to_number(token);
    }
  }

  // n i1 ... in [colour]
  void read_polygon() {
    const std::size_t number = mesh_.polygons.size() + skipped_faces_;
    const std::string_view first =
        is_free_ ? next_free("polygon", number) : cursor_.expect_line("polygon", number);
    const std::uint32_t size = cursor_.to_count(first, "the number of corners");
    if (size == 0 || (size < 3 && is_strict_))
      cursor_.fail_expected("a polygon of at least 3 corners", first);
    corners_.clear();
    for (std::uint32_t k = 0; k < size; ++k) {
      const std::string_view token = is_free_
                                         ? next_free("polygon", number)
                                         : cursor_.expect_token("as many corners as announced");
      const std::uint32_t corner = cursor_.to_count(token, "the index of a point, from 0");
      if (corner >= points_.size()) {
        cursor_.fail_expected("an index below " + std::to_string(points_.size()), token);
      }
      corners_.push_back(corner);
    }
    if (size < 3) {
      ++skipped_faces_;
    } else {
      mesh_.polygons.emplace_back(corners_.begin(), corners_.end());
    }
    if (is_free_) return;
    for (auto token = cursor_.token(); !token.empty(); token = cursor_.token()) {
      (void)cursor_.to_number(token);
    }
  }

  TextCursor cursor_;
  PointCollector points_;
  bool is_strict_;
  Mesh mesh_;
  std::vector<std::uint32_t> corners_;
  bool is_free_ = false;
  std::size_t skipped_faces_ = 0;  // of fewer than 3 corners
};

}  // namespace

bool is_off_of_qhull(std::string_view bytes) {
  TextCursor cursor(bytes, {.comment = '#'});
  if (!cursor.next_line() || cursor.token() != "3" || !cursor.token().empty()) return false;
  if (!cursor.next_line()) return false;
  std::array<std::uint64_t, 3> counts{};
  for (std::uint64_t& count : counts) {
    const std::string_view token = cursor.token();
    if (token.empty() || token.find_first_not_of("0123456789") != token.npos || token.size() > 10) {
      return false;
    }
    count = std::stoull(std::string(token));
  }
  if (!cursor.token().empty()) return false;
  std::uint64_t lines = 0;
  while (cursor.next_line()) ++lines;
  return lines == counts[0] + counts[1];
}

Mesh read_off(std::string_view bytes, const ReadOptions& options) {
  return OffReader(bytes, options).read();
}

}  // namespace convexact
