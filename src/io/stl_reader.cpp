// SPDX-License-Identifier: MIT
// STL, as text and binary. The format repeats a point in every triangle that has it; the reader
// merges points that are exactly equal. Normals and attribute bytes are ignored.
#include <algorithm>
#include <cmath>

#include "io/binary_cursor.hpp"
#include "io/mesh_readers.hpp"
#include "io/point_merger.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

constexpr std::size_t kHeaderSize = 84;

std::uint32_t announced_triangles(std::string_view bytes) {
  return BinaryCursor(bytes, 80, ByteOrder::Little).take<std::uint32_t>();
}

// Up to 50 times 2^32, which std::size_t need not hold.
std::uint64_t announced_bytes(std::string_view bytes) {
  constexpr std::uint64_t kTriangleSize = 50;
  return kHeaderSize + kTriangleSize * announced_triangles(bytes);
}

std::string skipped_facets_note(std::size_t count) {
  return counted(count, "facet was", "facets were") +
         " skipped: a coordinate is not finite; the other corners stay as points";
}

Mesh read_binary(std::string_view bytes, const ReadOptions& options) {
  Mesh mesh;
  PointMerger points(options.decimal);
  BinaryCursor cursor(bytes, kHeaderSize, ByteOrder::Little);
  const std::size_t count = announced_triangles(bytes);
  std::size_t skipped = 0;
  mesh.polygons.reserve(count);
  for (std::size_t triangle = 0; triangle < count; ++triangle) {
    cursor.skip(3 * sizeof(float));  // the normal
    std::vector<std::uint32_t> corners;
    for (int k = 0; k < 3; ++k) {
      Point point;
      for (double& x : point) {
        x = cursor.take_float();
        if (std::isfinite(x) || options.skip_bad) continue;
        cursor.fail("expected a finite number in triangle " + std::to_string(triangle) +
                        ", found NaN or infinity; --skip-bad leaves such facets out",
                    ErrorCode::NotFinite);
      }
      if (point.allFinite()) corners.push_back(points.add(point));
    }
    if (corners.size() == 3) {
      mesh.polygons.push_back(std::move(corners));
    } else {
      ++skipped;
    }
    cursor.skip(2);  // the attribute
  }
  if (skipped > 0) mesh.notes.push_back(skipped_facets_note(skipped));
  if (cursor.remaining() > 0) {
    mesh.notes.push_back(counted(cursor.remaining(), "byte", "bytes") + " behind the last facet " +
                         (cursor.remaining() == 1 ? "was" : "were") + " skipped");
  }
  mesh.parts.push_back({"", 0, mesh.polygons.size()});
  mesh.points = points.finish();
  return mesh;
}

// Keywords come in both cases.
bool is_word(std::string_view token, std::string_view lower_case) {
  return std::equal(token.begin(), token.end(), lower_case.begin(), lower_case.end(),
                    [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a + 32 == b); });
}

class TextStlReader {
 public:
  TextStlReader(std::string_view bytes, const ReadOptions& options)
      : cursor_(bytes), points_(options.decimal), skip_bad_(options.skip_bad) {}

  Mesh read() {
    expect_word("solid", cursor_.expect_line("solid"));
    do {
      read_solid();
      if (!cursor_.next_line()) break;
      expect_word("solid", cursor_.token());
    } while (true);
    if (skipped_ > 0) mesh_.notes.push_back(skipped_facets_note(skipped_));
    mesh_.points = points_.finish();
    return std::move(mesh_);
  }

 private:
  // "endloop", or two words, as some programs write.
  bool is_end_of(std::string_view token, std::string_view what) {
    if (is_word(token, "end" + std::string(what))) return true;
    if (!is_word(token, "end")) return false;
    expect_word(what, cursor_.expect_token(what));
    return true;
  }
  void expect_end_of(std::string_view what) {
    const std::string_view token = cursor_.expect_line("end" + std::string(what));
    if (!is_end_of(token, what)) cursor_.fail_expected("end" + std::string(what), token);
  }
  void expect_word(std::string_view word, std::string_view token) const {
    if (!is_word(token, word)) cursor_.fail_expected(word, token);
  }

  // From after "solid" to the end of the line of "endsolid".
  void read_solid() {
    const std::string name(cursor_.rest());
    const std::size_t first = mesh_.polygons.size();
    while (true) {
      const std::string_view token = cursor_.expect_line("facet or endsolid");
      if (is_end_of(token, "solid")) break;
      if (!is_word(token, "facet")) cursor_.fail_expected("facet or endsolid", token);
      read_triangle();
    }
    mesh_.parts.push_back({name, first, mesh_.polygons.size()});
  }

  void read_triangle() {
    expect_word("outer", cursor_.expect_line("outer loop"));
    expect_word("loop", cursor_.token());
    std::vector<std::uint32_t> corners;
    for (int k = 0; k < 3; ++k) {
      expect_word("vertex", cursor_.expect_line("vertex"));
      std::array<std::string_view, 3> coordinates;
      for (auto& coordinate : coordinates) coordinate = cursor_.expect_token("three coordinates");
      cursor_.expect_line_end();
      try {
        corners.push_back(points_.add(coordinates, cursor_));
      } catch (const Error& error) {
        if (!skip_bad_ || error.code() != ErrorCode::NotFinite) throw;
      }
    }
    expect_end_of("loop");
    expect_end_of("facet");
    if (corners.size() == 3) {
      mesh_.polygons.push_back(std::move(corners));
    } else {
      ++skipped_;
    }
  }

  TextCursor cursor_;
  PointMerger points_;
  bool skip_bad_;
  std::size_t skipped_ = 0;  // facets
  Mesh mesh_;
};

// A file that is not text, taken as a binary STL: more bytes than announced are read, fewer are
// told. Its first word does not matter. Text has no byte 0.
std::optional<Mesh> read_wrong_size(std::string_view bytes, const ReadOptions& options) {
  if (bytes.size() < kHeaderSize || bytes.find('\0') == bytes.npos) return {};
  const std::uint32_t count = announced_triangles(bytes);
  const std::uint64_t needed = announced_bytes(bytes);
  if (bytes.size() > needed && count > 0) return read_binary(bytes, options);
  throw Error(ErrorCode::Malformed, "expected " + std::to_string(needed) +
                                        " bytes of binary STL for the " + std::to_string(count) +
                                        " triangles that bytes 80 to 83 announce, found " +
                                        std::to_string(bytes.size()) + " bytes");
}

}  // namespace

// Many binary files start with "solid", as text files do; only the size distinguishes them.
bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kHeaderSize) return false;
  return bytes.size() == announced_bytes(bytes);
}

Mesh read_stl(std::string_view bytes, const ReadOptions& options) {
  if (is_binary_stl(bytes)) return read_binary(bytes, options);
  TextCursor start(bytes);
  try {
    if (start.next_line() && is_word(start.token(), "solid")) {
      return TextStlReader(bytes, options).read();
    }
  } catch (const Error&) {
    if (auto mesh = read_wrong_size(bytes, options)) return std::move(*mesh);
    throw;
  }
  if (auto mesh = read_wrong_size(bytes, options)) return std::move(*mesh);
  throw Error(
      ErrorCode::Malformed,
      "expected STL: text that begins with solid, or 84 + 50 n bytes of which bytes 80 to 83 "
      "hold n, found neither in " +
          std::to_string(bytes.size()) + " bytes");
}

}  // namespace convexact
