// SPDX-License-Identifier: MIT
// mesh_file.hpp - the points of a mesh, its faces where they are asked for, or the rows of a list
// of halfspaces, as docs/formats.md has them. Colours and normals are skipped: a misread point
// would be a difference to the proof, and so would a missing one.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>

#include "text.hpp"

namespace check {

// In the order of the file, repeats included.
struct MeshFile {
  bool is_mesh = true;       // points; or else halfspaces
  std::vector<Row> rows{};   // points as scaled(), halfspaces as primitive()
  std::vector<Ids> faces{};  // if asked for: their corners, as positions in rows
};

// Bytes, line by line: a line ends with LF, CR LF or CR.
class Lines {
 public:
  // A word that starts with `comment` ends its line. With `continued` a backslash at the end joins
  // a line with the next, except that a name after o or g is taken literally.
  explicit Lines(const std::string& bytes, char comment = '\0', bool continued = false)
      : bytes_(bytes), comment_(comment), continued_(continued) {
    if (bytes_.starts_with("\xEF\xBB\xBF")) offset_ = 3;
  }
  std::size_t offset() const { return offset_; }  // behind the line
  std::size_t number() const { return number_; }

  // The words of the next line that has any; none at the end.
  WordList next() {
    WordList words;
    bool goes_on = false;
    while ((words.empty() || goes_on) && offset_ < bytes_.size()) goes_on = append_line(words);
    return words;
  }

 private:
  bool append_line(WordList& words) {  // whether the line goes on
    const std::size_t end = std::min(bytes_.find_first_of("\r\n", offset_), bytes_.size());
    std::string text = bytes_.substr(offset_, end - offset_);
    offset_ = std::min(end + (bytes_.compare(end, 2, "\r\n") == 0 ? 2 : 1), bytes_.size());
    ++number_;
    const bool goes_on = continued_ && text.ends_with('\\');
    if (goes_on) text.back() = ' ';
    for (std::size_t from = 0; (from = text.find_first_not_of(kBlanks, from)) < text.size();) {
      if (comment_ != '\0' && text[from] == comment_) return false;
      const std::size_t to = std::min(text.find_first_of(kBlanks, from), text.size());
      words.push_back(text.substr(from, to - from));
      from = to;
    }
    return goes_on && (words.empty() || !is_one_of(words[0], {"o", "g"}));
  }

  static constexpr const char* kBlanks = " \t\v\f";
  const std::string& bytes_;
  const char comment_;
  const bool continued_;
  std::size_t offset_ = 0, number_ = 0;
};

// How a binary file stores a number.
struct BinaryType {
  std::size_t size;  // in bytes
  enum Kind { Real, Signed, Unsigned } kind;
};
inline BinaryType ply_type(const std::string& name) {
  if (is_one_of(name, {"float", "float32"})) return {4, BinaryType::Real};
  if (is_one_of(name, {"double", "float64"})) return {8, BinaryType::Real};
  if (is_one_of(name, {"char", "int8"})) return {1, BinaryType::Signed};
  if (is_one_of(name, {"uchar", "uint8"})) return {1, BinaryType::Unsigned};
  if (is_one_of(name, {"short", "int16"})) return {2, BinaryType::Signed};
  if (is_one_of(name, {"ushort", "uint16"})) return {2, BinaryType::Unsigned};
  if (is_one_of(name, {"int", "int32"})) return {4, BinaryType::Signed};
  expect(is_one_of(name, {"uint", "uint32"}), "a type such as float, found '" + name + "'");
  return {4, BinaryType::Unsigned};
}

class Binary {
 public:
  Binary(const std::string& bytes, std::size_t offset, bool is_big_endian)
      : bytes_(bytes), offset_(offset), is_big_endian_(is_big_endian) {}

  bool at_end() const { return offset_ == bytes_.size(); }
  std::string take(std::size_t size) {
    expect(size <= bytes_.size() - offset_, "more bytes");
    offset_ += size;
    return bytes_.substr(offset_ - size, size);
  }
  Rational number(const BinaryType& type) {
    std::string word = take(type.size);
    if (!is_big_endian_) std::reverse(word.begin(), word.end());
    std::uint64_t bits = 0;
    for (const char byte : word) bits = bits << 8 | static_cast<unsigned char>(byte);
    if (type.kind == BinaryType::Real) {
      const double value = type.size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                                          : std::bit_cast<double>(bits);
      expect(std::isfinite(value), "a finite number");
      return value;
    }
    const Rational value = static_cast<std::uint32_t>(bits),  // there are no longer integers
        range = power_of_two(8 * long(type.size));
    const bool is_negative = type.kind == BinaryType::Signed && 2 * value >= range;
    return is_negative ? Rational(value - range) : value;
  }

 private:
  const std::string& bytes_;
  std::size_t offset_;
  const bool is_big_endian_;
};

struct PlyElement {
  std::string name;
  std::size_t count;
  std::vector<WordList> properties;  // type name, or list type type name
};

class MeshReader {
 public:
  MeshReader(const std::string& bytes, Decimals decimals, bool with_faces)
      : bytes_(bytes), decimals_(decimals), with_faces_(with_faces) {}

  void read(const std::string& extension) {
    read_rows_of(extension);
    for (const Ids& face : file.faces) {
      for (const std::size_t corner : face) expect(corner < file.rows.size(), "corners of faces");
    }
    // They bound nothing, and no program that writes proofs is to name them.
    std::erase_if(file.faces, [](const Ids& face) { return face.size() < 3; });
  }
  MeshFile file;
  std::string where = "";  // the place of a failure

 private:
  void read_rows_of(const std::string& extension) {
    file.is_mesh = !is_one_of(extension, {".txt", ".ine"});
    if (extension == ".obj") return read_obj();
    if (extension == ".off") return read_off();
    if (extension == ".ply") return read_ply();
    if (extension == ".stl") return read_stl();
    if (extension == ".xyz") return read_xyz();
    if (extension == ".txt") return read_rows();
    expect(extension == ".ine", "a name that ends in .obj, .off, .ply, .stl, .xyz, .ine or .txt");
    read_ine();
  }
  WordList next(Lines& lines) {
    WordList words = lines.next();
    where = "line " + std::to_string(lines.number());
    return words;
  }
  void add_point(const Rational& x, const Rational& y, const Rational& z) {
    file.rows.push_back(scaled({x, y, z, 1}));
  }
  void add_point(const WordList& words, std::size_t first) {
    expect(words.size() >= first + 3, "three coordinates");
    const auto x = [&](std::size_t k) { return decimal(words[first + k], decimals_); };
    add_point(x(0), x(1), x(2));
  }

  // v x y z, with a weight (4 numbers), a colour (6) or both (7), which are not looked at.
  void read_obj() {
    const WordList others = {"f",  "fo", "o",  "g",      "s",      "l", "p",
                             "vt", "vn", "vp", "usemtl", "mtllib", "mg"};
    Lines lines(bytes_, '#', true);
    for (WordList words; !(words = next(lines)).empty();) {
      if (words[0] == "v") {
        expect(words.size() != 6 && words.size() <= 8, "x y z and a colour");
        add_point(words, 1);
      } else if (with_faces_ && (words[0] == "f" || words[0] == "fo")) {
        add_obj_face(words);
      } else {
        expect(is_one_of(words[0], others), "a statement such as v or f, found '" + words[0] + "'");
      }
    }
  }

  // For each corner the point, before a slash: from 1, or negative and counted back from the last
  // one.
  void add_obj_face(const WordList& words) {
    file.faces.emplace_back();
    for (std::size_t k = 1; k < words.size(); ++k) {
      std::string index = words[k].substr(0, words[k].find('/'));
      const bool is_back = index.starts_with('-');
      if (is_back) index.erase(0, 1);
      expect(is_count(index), "the index of a point");
      const std::size_t number = std::stoul(index);  // 0 is no index, nor is one before the first
      file.faces.back().push_back(is_back ? file.rows.size() - number : number - 1);
    }
  }

  // A header such as OFF or COFF, the counts after it or on the next line, a point on each line,
  // and a face on each line: the number of its corners, then the corners.
  void read_off() {
    Lines lines(bytes_, '#');
    WordList words = next(lines);
    expect(!words.empty() && words[0].ends_with("OFF") && has_only(words[0], "STCNOF"),
           "a header such as OFF");
    words.erase(words.begin());
    if (words.empty()) words = next(lines);
    expect(!words.empty() && is_count(words[0]), "the number of points");
    for (std::size_t count = std::stoul(words[0]); count > 0; --count) add_point(next(lines), 0);
    if (!with_faces_) return;
    const std::string faces = words.size() > 1 ? words[1] : "";
    expect(is_count(faces), "the number of faces");
    for (std::size_t count = std::stoul(faces); count > 0; --count) {
      words = next(lines);
      expect(!words.empty() && is_count(words[0]) && std::stoul(words[0]) < words.size(),
             "as many corners as announced");
      file.faces.emplace_back();
      for (std::size_t k = 1; k <= std::stoul(words[0]); ++k) {
        expect(is_count(words[k]), "the index of a point");
        file.faces.back().push_back(std::stoul(words[k]));
      }
    }
  }

  // x y z on each line; further numbers are not looked at. A line with anything else has names of
  // columns to the program, or numbers that are separated otherwise.
  void read_xyz() {
    Lines lines(bytes_, '#');
    for (WordList words; !(words = next(lines)).empty();) {
      add_point(words, 0);
      for (std::size_t k = 3; k < words.size(); ++k) (void)decimal(words[k], decimals_);
    }
  }

  // Binary if it has 84 + 50 n bytes, where bytes 80 to 83 hold n; or more, if there is a byte 0,
  // which text has not: what stands behind the last triangle is not looked at then. A file with
  // such a byte that begins as text does is refused: which of the two it is depends on all of it.
  void read_stl() {
    const BinaryType count{4, BinaryType::Unsigned};
    const bool has_header = bytes_.size() >= 84;
    const Rational triangles = has_header ? Binary(bytes_, 80, false).number(count) : Rational(0);
    const Rational size = 84 + 50 * triangles;
    const bool is_exact = has_header && size == bytes_.size();
    if (!is_exact && bytes_.find('\0') == std::string::npos) {
      read_text_stl();
    } else {
      expect(size <= bytes_.size(), "as many bytes as its triangles take");
      expect(is_exact || !begins_as_text(), "text or bytes, not both");
      read_binary_stl(triangles.get_num().get_ui());
    }
    add_stl_faces();
  }
  bool begins_as_text() const {
    const std::string text = lower_case(bytes_);
    const WordList words = Lines(text).next();
    return !words.empty() && words[0] == "solid";
  }
  void read_binary_stl(std::size_t triangles) {
    const BinaryType real{4, BinaryType::Real};
    Binary in(bytes_, 84, false);
    for (std::size_t triangle = 1; triangle <= triangles; ++triangle) {
      where = "triangle " + std::to_string(triangle);
      in.take(12);
      for (int corner = 0; corner < 3; ++corner) {
        const Rational x = in.number(real), y = in.number(real), z = in.number(real);
        add_point(x, y, z);
      }
      in.take(2);
    }
  }
  void add_stl_faces() {
    for (std::size_t p = 0; with_faces_ && p < file.rows.size(); p += 3) {
      file.faces.push_back({p, p + 1, p + 2});
    }
  }
  void read_text_stl() {
    const std::string text = lower_case(bytes_);
    Lines lines(text);
    for (WordList words; !(words = next(lines)).empty();) {
      if (words[0] == "vertex") add_point(words, 1);
    }
  }

  void read_ply() {
    Lines lines(bytes_);
    expect(next(lines) == WordList{"ply"}, "ply");
    const WordList format = next(lines);
    const bool is_text = format == WordList{"format", "ascii", "1.0"};
    const bool is_big_endian = format == WordList{"format", "binary_big_endian", "1.0"};
    expect(is_text || is_big_endian || format == WordList{"format", "binary_little_endian", "1.0"},
           "ascii or a byte order");
    const std::vector<PlyElement> elements = read_ply_header(lines);
    // If lines end with CR alone, an LF after the header is the first byte of the body.
    const bool is_dos = bytes_.compare(bytes_.find_first_of("\r\n"), 2, "\r\n") == 0;
    const bool ends_so = bytes_.compare(lines.offset() - 2, 2, "\r\n") == 0;
    Binary binary(bytes_, lines.offset() - (ends_so && !is_dos), is_big_endian);
    for (const PlyElement& element : elements) {
      for (std::size_t k = 0; k < element.count && !element.properties.empty(); ++k) {
        const WordList words = is_text ? next(lines) : WordList{};
        where = element.name + " " + std::to_string(k + 1);
        read_ply_row(element, is_text ? nullptr : &binary, words);
      }
    }
    expect(is_text ? next(lines).empty() : binary.at_end(), "the end of the file");
  }
  std::vector<PlyElement> read_ply_header(Lines& lines) {
    std::vector<PlyElement> elements;
    for (WordList words; (words = next(lines)) != WordList{"end_header"};) {
      expect(!words.empty(), "end_header");
      if (words[0] == "element") {
        expect(words.size() == 3 && is_count(words[2]), "an element, its name and number");
        elements.push_back({words[1], std::stoul(words[2]), {}});
      } else if (words[0] == "property") {
        expect(words.size() == 3 || (words.size() == 5 && words[1] == "list"), "a property");
        expect(!elements.empty(), "an element before its properties");
        elements.back().properties.emplace_back(words.begin() + 1, words.end());
      } else {
        expect(words[0] == "comment" || words[0] == "obj_info", "an element or a property");
      }
    }
    return elements;
  }
  // One value after another: words of a line, or bytes. Only the coordinates of a vertex are kept.
  void read_ply_row(const PlyElement& element, Binary* binary, const WordList& words) {
    std::size_t place = 0;
    const auto word = [&] {
      expect(place < words.size(), "a value per property");
      return words[place++];
    };
    const auto number = [&](const std::string& type) {
      return binary != nullptr ? binary->number(ply_type(type)) : decimal(word(), decimals_);
    };
    const auto skip = [&](const std::string& type) {
      return binary != nullptr ? binary->take(ply_type(type).size) : word();
    };
    std::map<std::string, Rational> axes;
    for (const WordList& property : element.properties) {
      if (property[0] == "list") {
        const Rational length = number(property[1]);
        expect(length >= 0 && length.get_den() == 1, "the length of a list");
        const bool is_face = with_faces_ && element.name == "face" &&
                             is_one_of(property[3], {"vertex_indices", "vertex_index"});
        if (is_face) file.faces.emplace_back();
        for (Rational k = 0; k < length; k += 1) {
          if (is_face) {
            file.faces.back().push_back(index_of(number(property[2])));
          } else {
            skip(property[2]);
          }
        }
      } else if (element.name == "vertex" && is_one_of(property[1], {"x", "y", "z"})) {
        axes[property[1]] = number(property[0]);
      } else {
        skip(property[0]);
      }
    }
    expect(place == words.size(), "no value without a property");
    if (element.name != "vertex") return;
    expect(axes.size() == 3, "a vertex with x, y and z");
    add_point(axes["x"], axes["y"], axes["z"]);
  }

  static std::size_t index_of(const Rational& number) {
    expect(number.get_den() == 1 && number.get_num().fits_uint_p(), "the index of a point");
    return number.get_num().get_ui();
  }

  // n1 n2 n3 d on each line.
  void read_rows() {
    Lines lines(bytes_, '#');
    for (WordList words; !(words = next(lines)).empty();) add_halfspace(words, 1);
  }

  // begin, m 4 type, m rows b a1 a2 a3 that mean b + a.x >= 0, and end.
  void read_ine() {
    const WordList refused = {"V-representation", "linearity", "equality", "strict_inequality",
                              "partial_enumeration"};
    Lines lines(bytes_, '*');
    WordList words;
    while ((words = next(lines)) != WordList{"begin"}) {
      expect(!words.empty() && !is_one_of(words[0], refused), "begin, and inequalities only");
    }
    words = next(lines);
    expect(words.size() == 3 && is_count(words[0]) && words[1] == "4",
           "the number of rows, 4 and their type");
    for (std::size_t count = std::stoul(words[0]); count > 0; --count) {
      words = next(lines);
      if (!words.empty()) std::rotate(words.begin(), words.begin() + 1, words.end());
      add_halfspace(words, -1);
    }
    expect(next(lines) == WordList{"end"}, "end");
    while (!(words = next(lines)).empty()) {
      expect(!is_one_of(words[0], refused), "inequalities only");
    }
  }
  // A row without a normal that holds everywhere is ignored.
  void add_halfspace(const WordList& words, int sign) {
    expect(words.size() == 4, "a row of four numbers");
    Numbers row;
    for (std::size_t k = 0; k < 4; ++k) row[k] = sign * number_of_row(words[k], decimals_);
    const bool has_normal = row[0] != 0 || row[1] != 0 || row[2] != 0;
    expect(has_normal || row[3] <= 0, "halfspaces that hold somewhere");
    if (has_normal) file.rows.push_back(primitive(scaled(row)));
  }

  const std::string& bytes_;
  const Decimals decimals_;
  const bool with_faces_;
};

// The end of the file's name determines its format.
// @throws Failure of exit code 3, with the place.
inline MeshFile parse_mesh_file(const std::string& bytes, const std::string& path,
                                Decimals decimals, bool with_faces = false) {
  MeshReader reader(bytes, decimals, with_faces);
  try {
    reader.read(lower_case(path.substr(std::min(path.rfind('.'), path.size()))));
    return reader.file;
  } catch (Failure failure) {
    failure.where = path + (reader.where.empty() ? "" : ": " + reader.where);
    throw failure;
  }
}

inline std::string bytes_of_file(const std::string& path) {
  try {
    std::ifstream in(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (in.is_open()) return bytes;
  } catch (const std::ios_base::failure&) {
    // A folder can be opened, but not read.
  }
  throw Failure{3, "expected a file that can be read", path.empty() ? "''" : path};
}

}  // namespace check
