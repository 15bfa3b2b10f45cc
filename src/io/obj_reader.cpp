// SPDX-License-Identifier: MIT
// The polygonal part of Wavefront OBJ; statements of the format about anything but points, polygons
// and groups are ignored, and words that are not statements of the format are errors.
#include <algorithm>
#include <array>
#include <limits>

#include "io/mesh_readers.hpp"
#include "io/point_collector.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

constexpr std::array<std::string_view, 38> kPassedOver = {
    "vt",       "vn",       "vp",   "p",          "l",         "s",     "usemtl", "mtllib",
    "mg",       "cstype",   "deg",  "bmat",       "step",      "curv",  "curv2",  "surf",
    "parm",     "trim",     "hole", "scrv",       "sp",        "end",   "con",    "bevel",
    "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech", "stech",  "usemap",
    "maplib",   "res",      "bzp",  "bsp",        "cdc",       "cdp"};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const ReadOptions& options)
      : cursor_(bytes, {.comment = '#', .continuation = true}),
        points_(options.decimal),
        is_strict_(options.strict),
        points_only_(options.points_only) {}

  Mesh read() {
    while (cursor_.next_line()) read_statement(cursor_.token());
    if (largest_index_ > points_.size()) {
      throw Error(ErrorCode::Malformed,
                  "expected the index of one of " + std::to_string(points_.size()) +
                      " points, found " + std::to_string(largest_index_),
                  line_of_largest_);
    }
    end_part();
    if (has_named_part_ && !points_only_) find_loose_points();
    if (mesh_.parts.empty()) mesh_.parts.push_back({"", 0, 0});
    if (skipped_faces_ > 0) mesh_.notes.push_back(skipped_faces_note(skipped_faces_));
    mesh_.points = points_.finish();
    return std::move(mesh_);
  }

 private:
  void read_statement(std::string_view keyword) {
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f" || keyword == "fo") {  // "fo" is the older spelling
      read_face();
    } else if (keyword == "o" || keyword == "g") {
      end_part();
      has_named_part_ = true;
      part_name_ = cursor_.rest();
    } else if (std::find(kPassedOver.begin(), kPassedOver.end(), keyword) == kPassedOver.end()) {
      cursor_.fail_expected("an OBJ statement such as v, f, o or g", keyword);
    } else {
      while (!cursor_.token().empty()) {  // it may go on in the next line
      }
    }
  }

  // v x y z [weight] [red green blue]
  void read_vertex() {
    std::array<std::string_view, 3> coordinates;
    for (auto& coordinate : coordinates) coordinate = cursor_.expect_token("three coordinates");
    points_.add(coordinates, cursor_);
    int extra = 0;
    for (auto token = cursor_.token(); !token.empty(); token = cursor_.token(), ++extra) {
      (void)cursor_.to_number(token);
    }
    if (extra == 2 || extra > 4) {
      cursor_.fail("expected x y z, with a weight or a colour or both, found " +
                   std::to_string(3 + extra) + " numbers");
    }
  }

  // f v v v ..., where each v may have a texture and a normal: v/vt, v//vn, v/vt/vn
  void read_face() {
    corners_.clear();
    while (true) {
      // Many corners are an index and nothing else, which needs no token.
      std::int64_t index = cursor_.take_plain_index();
      if (index == 0) {
        const std::string_view token = cursor_.token();
        if (token.empty()) break;
        index = read_corner(token);
      }
      if (std::size_t(index) > largest_index_) {
        largest_index_ = std::size_t(index);
        line_of_largest_ = cursor_.line();
      }
      corners_.push_back(static_cast<std::uint32_t>(index - 1));
    }
    if (corners_.empty()) cursor_.fail_expected("the corners of a polygon", "");
    if (corners_.size() < 3) {
      if (is_strict_) {
        cursor_.fail("expected a polygon of at least 3 corners, found " +
                     std::to_string(corners_.size()));
      }
      ++skipped_faces_;
      return;
    }
    if (!points_only_) mesh_.polygons.emplace_back(corners_.begin(), corners_.end());
  }

  // The index of the point, from 1, and perhaps beyond all points: they may follow their faces.
  std::int64_t read_corner(std::string_view token) const {
    const char* end = token.data() + token.size();
    const char* next = token.data();
    const std::int64_t vertex = read_index(next, end, token);
    for (int k = 0; k < 2 && next != end && *next == '/'; ++k) {
      ++next;
      const bool absent = k == 0 && next != end && *next == '/';
      if (!absent) (void)read_index(next, end, token);
    }
    if (next != end) fail_corner(token);
    // -1 is the point last read.
    const std::int64_t index = vertex > 0 ? vertex : vertex + std::int64_t(points_.size()) + 1;
    if (index < 1) {
      cursor_.fail("expected an index of one of the " + std::to_string(points_.size()) +
                   " points so far, found " + in_quotes(token));
    }
    return index;
  }

  // A nonzero integer at `next`, which is moved past it.
  std::int64_t read_index(const char*& next, const char* end, std::string_view token) const {
    const bool is_negative = next != end && *next == '-';
    const char* const first = is_negative ? ++next : next;
    constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max(), kFar = 1000 * kMost;
    std::int64_t value = 0;
    for (; next != end && '0' <= *next && *next <= '9'; ++next) {
      if (value < kFar) value = 10 * value + (*next - '0');
    }
    if (next == first || value == 0 || value > kMost + is_negative) fail_corner(token);
    return is_negative ? -value : value;
  }

  [[noreturn]] void fail_corner(std::string_view token) const {
    cursor_.fail_expected("a corner such as 3, -1, 3/2, 3//4 or 3/2/4 with indices from 1", token);
  }

  // Makes a part of the polygons and points since the last o or g, if there are any. The same name
  // twice in a row is one part. Points before the first o or g are for all parts, and of none: many
  // write all points first.
  void end_part() {
    if (points_only_) return;
    const std::size_t last = mesh_.polygons.size(), last_point = points_.size();
    const std::size_t first = mesh_.parts.empty() ? 0 : mesh_.parts.back().last_polygon;
    const bool has_points = has_named_part_ && part_of_point_.size() < last_point;
    if (!has_named_part_) part_of_point_.resize(last_point, kNoPart);
    if (first == last && !has_points) return;
    if (!mesh_.parts.empty() && mesh_.parts.back().name == part_name_) {
      mesh_.parts.back().last_polygon = last;
    } else {
      mesh_.parts.push_back({std::string(part_name_), first, last});
    }
    part_of_point_.resize(last_point, mesh_.parts.size() - 1);
  }

  // Only now it is known which points polygons use: they may use points of other parts.
  void find_loose_points() {
    const std::vector<bool> is_used = used_points(points_.size(), mesh_.polygons);
    for (std::uint32_t p = 0; p < part_of_point_.size(); ++p) {
      if (is_used[p] || part_of_point_[p] == kNoPart) continue;
      mesh_.parts[part_of_point_[p]].loose.push_back(p);
    }
    std::erase_if(mesh_.parts, [](const MeshPart& part) {
      return part.first_polygon == part.last_polygon && part.loose.empty();
    });
    // What stood between two parts of one name may be gone.
    std::vector<MeshPart> parts;
    for (MeshPart& part : mesh_.parts) {
      if (parts.empty() || parts.back().name != part.name) {
        parts.push_back(std::move(part));
        continue;
      }
      parts.back().last_polygon = part.last_polygon;
      parts.back().loose.insert(parts.back().loose.end(), part.loose.begin(), part.loose.end());
    }
    mesh_.parts = std::move(parts);
  }

  static constexpr std::size_t kNoPart = ~std::size_t{0};
  TextCursor cursor_;
  PointCollector points_;
  bool is_strict_;
  bool points_only_;  // polygons are checked, but neither kept nor counted in parts
  Mesh mesh_;
  std::string_view part_name_;
  bool has_named_part_ = false;             // an o or g was read
  std::vector<std::size_t> part_of_point_;  // by point, under which part it was read
  std::vector<std::uint32_t> corners_;
  std::size_t skipped_faces_ = 0;  // of fewer than 3 corners
  std::size_t largest_index_ = 0;
  std::size_t line_of_largest_ = 0;
};

}  // namespace

std::string skipped_faces_note(std::size_t count) {
  return counted(count, "face", "faces") + " of fewer than 3 corners " +
         (count == 1 ? "was" : "were") + " skipped; the points count";
}

Mesh read_obj(std::string_view bytes, const ReadOptions& options) {
  return ObjReader(bytes, options).read();
}

}  // namespace convexact
