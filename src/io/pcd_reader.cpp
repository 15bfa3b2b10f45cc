// SPDX-License-Identifier: MIT
// PCD, the files of the Point Cloud Library, as text and binary: the fields x, y and z of each
// point.
#include <charconv>
#include <cmath>

#include "io/binary_cursor.hpp"
#include "io/mesh_readers.hpp"
#include "io/point_collector.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

// One of the columns of a point.
struct PcdField {
  std::string name;
  std::uint32_t size = 4;
  char type = 'F';
  std::uint32_t count = 1;
};

class PcdReader {
 public:
  PcdReader(std::string_view bytes, const ReadOptions& options)
      : bytes_(bytes),
        cursor_(bytes, {.comment = '#'}),
        options_(options),
        points_(options.decimal) {}

  Mesh read() {
    const std::string data = read_header();
    find_coordinates();
    if (data == "ascii") {
      read_text();
    } else if (data == "binary") {
      read_binary();
    } else if (data == "binary_compressed") {
      cursor_.fail(
          "compressed PCD is not read: write it again with DATA binary, as "
          "pcl_convert_pcd_ascii_binary in.pcd out.pcd 1 does");
    } else {
      cursor_.fail_expected("DATA ascii or binary", data);
    }
    if (skipped_ > 0) mesh_.notes.push_back(skipped_points_note(skipped_));
    mesh_.points = points_.finish();
    mesh_.parts.push_back({"", 0, 0});
    return std::move(mesh_);
  }

 private:
  // Up to the line of DATA, whose word it returns.
  std::string read_header() {
    while (true) {
      const std::string_view key = cursor_.expect_line("a line of the header, such as FIELDS");
      if (key == "DATA") return std::string(cursor_.expect_token("ascii or binary"));
      if (key == "FIELDS" || key == "COLUMNS") {
        for (auto name = cursor_.token(); !name.empty(); name = cursor_.token()) {
          fields_.push_back({std::string(name)});
        }
      } else if (key == "SIZE" || key == "COUNT") {
        for (PcdField& field : fields_) {
          const auto value =
              cursor_.to_count(cursor_.expect_token("a number per field"), "a number per field");
          (key == "SIZE" ? field.size : field.count) = value;
        }
      } else if (key == "TYPE") {
        for (PcdField& field : fields_) field.type = cursor_.expect_token("F, I or U")[0];
      } else if (key == "POINTS") {
        count_ =
            cursor_.to_count(cursor_.expect_token("the number of points"), "the number of points");
      } else if (key != "VERSION" && key != "WIDTH" && key != "HEIGHT" && key != "VIEWPOINT") {
        cursor_.fail_expected("a line of a PCD header, such as FIELDS or DATA", key);
      }
    }
  }

  void find_coordinates() {
    std::size_t column = 0, byte = 0;
    for (const PcdField& field : fields_) {
      const int axis = field.name.size() == 1 ? field.name[0] - 'x' : -1;
      if (axis >= 0 && axis < 3) {
        if (field.type != 'F' || (field.size != 4 && field.size != 8) || field.count != 1) {
          cursor_.fail("expected " + field.name + " to be one number of TYPE F and SIZE 4 or 8");
        }
        columns_[axis] = column;
        places_[axis] = {byte, field.size};
        ++found_;
      }
      column += field.count;
      byte += std::size_t(field.size) * field.count;
    }
    column_count_ = column;
    row_size_ = byte;
    if (found_ != 3) cursor_.fail("expected the fields x, y and z");
    if (!count_) cursor_.fail("expected a line POINTS with the number of points");
  }

  void read_text() {
    for (std::uint32_t row = 0; row < *count_; ++row) {
      std::array<std::string_view, 3> coordinates;
      std::string_view token = cursor_.expect_line("point", row);
      for (std::size_t column = 0; column < column_count_; ++column) {
        if (column > 0) token = cursor_.expect_token("a value per column");
        for (int k = 0; k < 3; ++k) {
          if (columns_[k] == column) coordinates[k] = token;
        }
      }
      try {
        points_.add(coordinates, cursor_);
      } catch (const Error& error) {
        if (!options_.skip_bad || error.code() != ErrorCode::NotFinite) throw;
        ++skipped_;
      }
    }
    cursor_.expect_end();
  }

  void read_binary() {
    // After the end of the line of DATA.
    std::size_t start = cursor_.offset();
    if (bytes_.substr(start, 1) == "\r") ++start;
    if (bytes_.substr(start, 1) == "\n") ++start;
    const std::size_t needed = row_size_ * *count_;
    if (bytes_.size() - start < needed) {
      cursor_.fail("expected " + std::to_string(needed) + " bytes for " + std::to_string(*count_) +
                   " points, found " + std::to_string(bytes_.size() - start));
    }
    for (std::uint32_t row = 0; row < *count_; ++row) {
      Point point;
      for (int k = 0; k < 3; ++k) {
        const auto [place, size] = places_[k];
        BinaryCursor at(bytes_, start + row * row_size_ + place, ByteOrder::Little);
        point[k] = size == 4 ? at.take_float() : at.take_double();
        if (options_.decimal == Decimal::Nearest32) point[k] = static_cast<float>(point[k]);
      }
      if (point.allFinite()) {
        points_.add(point);
        continue;
      }
      if (!options_.skip_bad) {
        throw Error(ErrorCode::NotFinite,
                    "expected finite numbers in point " + std::to_string(row) +
                        ", found NaN or infinity; --skip-bad leaves such points out");
      }
      ++skipped_;
    }
  }

  std::string_view bytes_;
  TextCursor cursor_;
  ReadOptions options_;
  PointCollector points_;
  Mesh mesh_;
  std::vector<PcdField> fields_;
  std::optional<std::uint32_t> count_;
  int found_ = 0;
  std::array<std::size_t, 3> columns_{};
  std::array<std::pair<std::size_t, std::uint32_t>, 3> places_{};  // byte in a row, size
  std::size_t column_count_ = 0, row_size_ = 0, skipped_ = 0;
};

}  // namespace

Mesh read_pcd(std::string_view bytes, const ReadOptions& options) {
  return PcdReader(bytes, options).read();
}

}  // namespace convexact
