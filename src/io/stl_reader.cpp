// SPDX-License-Identifier: MIT
// STL, as text and binary. The format repeats a point in every triangle that has it; the reader
// merges points that are exactly equal. Normals and attribute bytes are ignored.
#include <algorithm>
#include <unordered_set>

#include "io/binary_cursor.hpp"
#include "io/mesh_readers.hpp"
#include "io/point_collector.hpp"

namespace convexact {
namespace {

constexpr std::size_t kHeaderSize = 84, kTriangleSize = 50;

// Collects points and gives equal ones the index of the first.
class PointMerger {
 public:
  explicit PointMerger(Decimal decimal) : points_(decimal) {}

  template <class... Place>
  std::uint32_t add(Place&&... place) {
    points_.add(std::forward<Place>(place)...);
    const auto [found, is_new] = known_.insert(static_cast<std::uint32_t>(points_.size() - 1));
    if (!is_new) points_.drop_last();
    return *found;
  }
  PointSet finish() { return points_.finish(); }

 private:
  struct Hash {
    const PointCollector* points;
    std::size_t operator()(std::uint32_t index) const {
      std::size_t hash = 0;
      for (const double x : points->double_at(index)) {
        // x + 0.0 turns -0 into the 0 that it equals; the multiplier is 2^64 over the golden ratio.
        hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 32;
      }
      return hash;
    }
  };
  struct Equal {
    const PointCollector* points;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return points->equal(a, b); }
  };

  PointCollector points_;
  std::unordered_set<std::uint32_t, Hash, Equal> known_{16, Hash{&points_}, Equal{&points_}};
};

Mesh read_binary(std::string_view bytes, Decimal decimal) {
  Mesh mesh;
  PointMerger points(decimal);
  BinaryCursor cursor(bytes, kHeaderSize, ByteOrder::Little);
  mesh.polygons.reserve(cursor.remaining() / kTriangleSize);
  while (cursor.remaining() > 0) {
    cursor.skip(3 * sizeof(float));  // the normal
    std::array<std::uint32_t, 3> corners;
    for (std::uint32_t& corner : corners) {
      Point point;
      for (double& x : point) {
        x = cursor.take_float();
        if (!std::isfinite(x)) {
          cursor.fail("expected a finite number in triangle " +
                          std::to_string(mesh.polygons.size()) + ", found NaN or infinity",
                      ErrorCode::NotFinite);
        }
      }
      corner = points.add(point);
    }
    mesh.polygons.emplace_back(corners.begin(), corners.end());
    cursor.skip(2);  // the attribute
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
  TextStlReader(std::string_view bytes, Decimal decimal) : cursor_(bytes), points_(decimal) {}

  Mesh read() {
    expect_word("solid", cursor_.expect_line("solid"));
    do {
      read_solid();
      if (!cursor_.next_line()) break;
      expect_word("solid", cursor_.token());
    } while (true);
    mesh_.points = points_.finish();
    return std::move(mesh_);
  }

 private:
  void expect_word(std::string_view word, std::string_view token) const {
    if (!is_word(token, word)) cursor_.fail_expected(word, token);
  }

  // From after "solid" to the end of the line of "endsolid".
  void read_solid() {
    const std::string name(cursor_.rest());
    const std::size_t first = mesh_.polygons.size();
    while (true) {
      const std::string_view token = cursor_.expect_line("facet or endsolid");
      if (is_word(token, "endsolid")) break;
      if (!is_word(token, "facet")) cursor_.fail_expected("facet or endsolid", token);
      read_triangle();
    }
    mesh_.parts.push_back({name, first, mesh_.polygons.size()});
  }

  void read_triangle() {
    expect_word("outer", cursor_.expect_line("outer loop"));
    expect_word("loop", cursor_.token());
    std::array<std::uint32_t, 3> corners;
    for (std::uint32_t& corner : corners) {
      expect_word("vertex", cursor_.expect_line("vertex"));
      std::array<std::string_view, 3> coordinates;
      for (auto& coordinate : coordinates) coordinate = cursor_.expect_token("three coordinates");
      cursor_.expect_line_end();
      corner = points_.add(coordinates, cursor_);
    }
    expect_word("endloop", cursor_.expect_line("endloop"));
    expect_word("endfacet", cursor_.expect_line("endfacet"));
    mesh_.polygons.emplace_back(corners.begin(), corners.end());
  }

  TextCursor cursor_;
  PointMerger points_;
  Mesh mesh_;
};

// Reports what is wrong with a file that is not text, taken as a binary STL: it is cut off, or
// longer than announced. Its first word does not matter. Text has no byte 0.
void reject_wrong_size(std::string_view bytes) {
  if (bytes.size() < kHeaderSize || bytes.find('\0') == bytes.npos) return;
  const std::size_t count = BinaryCursor(bytes, 80, ByteOrder::Little).take<std::uint32_t>();
  throw Error(ErrorCode::Malformed, "expected " +
                                        std::to_string(kHeaderSize + kTriangleSize * count) +
                                        " bytes of binary STL for the " + std::to_string(count) +
                                        " triangles that bytes 80 to 83 announce, found " +
                                        std::to_string(bytes.size()) + " bytes");
}

}  // namespace

// Many binary files start with "solid", as text files do; only the size distinguishes them.
bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kHeaderSize) return false;
  const std::size_t count = BinaryCursor(bytes, 80, ByteOrder::Little).take<std::uint32_t>();
  return bytes.size() == kHeaderSize + kTriangleSize * count;
}

Mesh read_stl(std::string_view bytes, Decimal decimal) {
  if (is_binary_stl(bytes)) return read_binary(bytes, decimal);
  TextCursor start(bytes);
  try {
    if (start.next_line() && is_word(start.token(), "solid")) {
      return TextStlReader(bytes, decimal).read();
    }
  } catch (const Error&) {
    reject_wrong_size(bytes);
    throw;
  }
  reject_wrong_size(bytes);
  throw Error(
      ErrorCode::Malformed,
      "expected STL: text that begins with solid, or 84 + 50 n bytes of which bytes 80 to 83 "
      "hold n, found neither in " +
          std::to_string(bytes.size()) + " bytes");
}

}  // namespace convexact
