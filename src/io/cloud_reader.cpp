// SPDX-License-Identifier: MIT
// Point clouds as text: x y z in each line, with blanks, commas or semicolons between them.
// Scanners and spreadsheets put names of columns in front, or the number of points; qhull and rbox
// put the dimension and the number of points.
#include <algorithm>
#include <charconv>

#include "io/mesh_readers.hpp"
#include "io/point_collector.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

using Fields = std::vector<std::string_view>;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\"");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\"") - first + 1);
}

// A token that starts with # ends the line.
std::string_view without_comment(std::string_view line) {
  for (std::size_t k = line.find('#'); k != line.npos; k = line.find('#', k + 1)) {
    if (k == 0 || line[k - 1] == ' ' || line[k - 1] == '\t') return line.substr(0, k);
  }
  return line;
}

[[noreturn]] void reject_decimal_comma(std::string_view field, const TextCursor& cursor) {
  std::string with_point(field);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  cursor.fail("a decimal comma is not read: expected " + with_point + " for " + in_quotes(field) +
              "; commas separate numbers here");
}

Fields split(std::string_view line, char separator) {
  Fields fields;
  for (std::size_t first = 0; first <= line.size();) {
    const std::size_t last = std::min(line.find(separator, first), line.size());
    fields.push_back(trimmed(line.substr(first, last - first)));
    first = last + 1;
  }
  if (fields.size() > 1 && fields.back().empty()) fields.pop_back();
  return fields;
}

Fields split_at_blanks(std::string_view line) {
  Fields fields;
  for (std::size_t first = line.find_first_not_of(" \t"); first < line.size();
       first = line.find_first_not_of(" \t", first)) {
    const std::size_t last = std::min(line.find_first_of(" \t", first), line.size());
    fields.push_back(trimmed(line.substr(first, last - first)));
    first = last;
  }
  return fields;
}

// The fields of a line, whatever separates them.
Fields fields_of(std::string_view line, const TextCursor& cursor) {
  if (line.find(';') != line.npos) {
    Fields fields = split(line, ';');
    for (const std::string_view field : fields) {
      if (field.find(',') != field.npos) reject_decimal_comma(field, cursor);
    }
    return fields;
  }
  if (line.find(',') == line.npos) return split_at_blanks(line);
  Fields fields = split(line, ',');
  const bool has_blanks = std::any_of(fields.begin(), fields.end(), [](std::string_view field) {
    return field.find_first_of(" \t") != field.npos;
  });
  if (has_blanks || fields.size() < 3) {
    for (const std::string_view field : split_at_blanks(line)) {
      if (field.find(',') != field.npos) reject_decimal_comma(field, cursor);
    }
  }
  return fields;
}

bool is_number(std::string_view field) {
  try {
    (void)nearest_double(field);
    return true;
  } catch (const Error& error) {
    return error.code() == ErrorCode::NotFinite;
  }
}

std::optional<std::uint64_t> count_of(std::string_view field) {
  std::uint64_t count = 0;
  const auto [end, status] = std::from_chars(field.data(), field.data() + field.size(), count);
  if (status != std::errc() || end != field.data() + field.size()) return {};
  return count;
}

// Whether a line may name columns: some letter, and no control character.
bool is_text(std::string_view line) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; };
  const auto is_letter = [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; };
  return std::none_of(line.begin(), line.end(), is_control) &&
         std::any_of(line.begin(), line.end(), is_letter);
}

class CloudReader {
 public:
  CloudReader(std::string_view bytes, const ReadOptions& options)
      : cursor_(bytes, {.comment = '#'}), points_(options.decimal), skip_bad_(options.skip_bad) {}

  Mesh read() {
    read_preamble();
    for (; !line_.empty(); next()) read_point();
    finish_notes();
    mesh_.points = points_.finish();
    mesh_.parts.push_back({"", 0, 0});
    return std::move(mesh_);
  }

 private:
  // To the next line with a field; none at the end.
  void next() {
    line_.clear();
    while (line_.empty() && cursor_.next_line()) {
      text_ = without_comment(cursor_.rest());
      line_ = fields_of(text_, cursor_);
      if (line_.size() == 1 && line_[0].empty()) line_.clear();
    }
  }

  // Names of columns, then a dimension and a count, or a count alone.
  void read_preamble() {
    next();
    if (line_.empty()) return;
    const bool is_rbox = line_.size() > 1 && line_[0] == "3" && !is_number(line_[1]);
    if (!is_number(line_[0]) && is_text(text_)) {
      name_columns();
      next();
      if (line_.empty()) cursor_.fail("expected points, found " + in_quotes(text_) + " alone");
    }
    if (line_.size() == 1 || is_rbox) {
      announced_ = count_of(line_[0]);
      if (!announced_) return;  // told as a point that lacks coordinates
      next();
      if (line_.size() == 1 && *announced_ == 3) {
        announced_ = count_of(line_[0]);
        next();
      }
      if (line_.empty() && *announced_ > 0) {
        cursor_.fail("expected " + std::to_string(*announced_) +
                     " points, found the end of the file");
      }
    }
  }

  void name_columns() {
    std::array<std::optional<std::size_t>, 3> found;
    for (std::size_t k = 0; k < line_.size(); ++k) {
      std::string_view name = line_[k];
      while (name.starts_with('/')) name.remove_prefix(1);
      if (name.size() != 1) continue;
      const int axis = (name[0] | 0x20) - 'x';
      if (axis >= 0 && axis < 3 && !found[axis]) found[axis] = k;
    }
    std::string note = "the first line, " + in_quotes(text_) + ", was skipped";
    if (found[0] && found[1] && found[2]) {
      for (int axis = 0; axis < 3; ++axis) columns_[axis] = *found[axis];
      if (columns_ != std::array<std::size_t, 3>{0, 1, 2}) note += ": it names the columns x, y, z";
    }
    mesh_.notes.push_back(note);
    has_names_ = true;
  }

  void read_point() {
    std::array<std::string_view, 3> coordinates;
    for (int k = 0; k < 3; ++k) {
      if (columns_[k] >= line_.size()) {
        cursor_.fail("expected three coordinates, found " +
                     (line_.size() == 1 ? "one field" : std::to_string(line_.size()) + " fields"));
      }
      coordinates[k] = line_[columns_[k]];
    }
    // Without names, what follows the coordinates is numbers, too: intensities, colours.
    for (std::size_t k = 3; k < line_.size() && !has_names_; ++k) {
      if (!is_number(line_[k])) (void)cursor_.to_number(line_[k]);
    }
    try {
      points_.add(coordinates, cursor_);
    } catch (const Error& error) {
      if (!skip_bad_ || error.code() != ErrorCode::NotFinite) throw;
      ++skipped_;
    }
  }

  void finish_notes() {
    const std::size_t found = points_.size() + skipped_;
    if (announced_ && *announced_ != found) {
      mesh_.notes.push_back("the file announces " + std::to_string(*announced_) +
                            " points and has " + std::to_string(found));
    }
    if (skipped_ > 0) mesh_.notes.push_back(skipped_points_note(skipped_));
  }

  TextCursor cursor_;
  PointCollector points_;
  bool skip_bad_;
  Mesh mesh_;
  Fields line_;
  std::string_view text_;  // of the line
  std::array<std::size_t, 3> columns_{0, 1, 2};
  bool has_names_ = false;
  std::optional<std::uint64_t> announced_;
  std::size_t skipped_ = 0;
};

}  // namespace

std::string skipped_points_note(std::size_t count) {
  return counted(count, "point was", "points were") + " skipped: a coordinate is not finite";
}

Mesh read_xyz(std::string_view bytes, const ReadOptions& options) {
  return CloudReader(bytes, options).read();
}

}  // namespace convexact
