// SPDX-License-Identifier: MIT
// Mesh files, read as docs/formats.md says and with nothing of convexact: every number as an exact
// rational, rounded to a double in integers. What is not understood is refused.
#include "mesh_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iterator>
#include <string_view>

#include "words.hpp"

namespace check {
namespace {

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return text;
}

// Bytes as numbers, in either order.
class Binary {
 public:
  Binary(const std::string& bytes, std::size_t offset, bool is_big)
      : bytes_(bytes), offset_(offset), is_big_(is_big) {}

  bool at_end() const { return offset_ >= bytes_.size(); }
  void skip(std::uint64_t size) {
    expect(size <= bytes_.size() - offset_, "more bytes");
    offset_ += size;
  }
  std::uint64_t take(std::size_t size) {
    const std::size_t first = offset_;
    skip(size);
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < size; ++k) {
      value =
          value << 8 | static_cast<unsigned char>(bytes_[is_big_ ? first + k : offset_ - 1 - k]);
    }
    return value;
  }
  double take_real(std::size_t size) {
    const double value = size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(take(4)))
                                   : std::bit_cast<double>(take(8));
    expect(std::isfinite(value), "a finite number");
    return value;
  }

 private:
  const std::string& bytes_;
  std::size_t offset_;
  const bool is_big_;
};

// Of a property: its size as binary, and whether it is real (r), signed (i) or unsigned (u).
struct PlyType {
  std::size_t size;
  char kind;
};
PlyType ply_type(const std::string& name) {
  if (is_one_of(name, {"float", "float32"})) return {4, 'r'};
  if (is_one_of(name, {"double", "float64"})) return {8, 'r'};
  if (is_one_of(name, {"char", "int8"})) return {1, 'i'};
  if (is_one_of(name, {"uchar", "uint8"})) return {1, 'u'};
  if (is_one_of(name, {"short", "int16"})) return {2, 'i'};
  if (is_one_of(name, {"ushort", "uint16"})) return {2, 'u'};
  if (is_one_of(name, {"int", "int32"})) return {4, 'i'};
  expect(is_one_of(name, {"uint", "uint32"}), "a type such as float, found '" + name + "'");
  return {4, 'u'};
}
struct PlyElement {
  std::string name;
  std::size_t count;
  std::vector<WordList> properties;  // type name, or list type type name
};

// The values of a row, one after another: words of a line, or bytes.
class PlyRow {
 public:
  PlyRow(WordList words, Decimals decimals) : words_(std::move(words)), decimals_(decimals) {}
  explicit PlyRow(Binary& binary) : binary_(&binary) {}

  Rational take(const std::string& type_name) {
    if (binary_ == nullptr) return decimal(word(), decimals_);
    const PlyType type = ply_type(type_name);
    if (type.kind == 'r') return binary_->take_real(type.size);
    const std::uint64_t value = binary_->take(type.size);
    const bool is_negative = type.kind == 'i' && (value >> (8 * type.size - 1)) != 0;
    const Rational whole(Integer(static_cast<unsigned long>(value)));
    return is_negative ? Rational(whole - power_of_two(long(8 * type.size))) : whole;
  }
  void skip(const std::string& type_name) {
    if (binary_ == nullptr) {
      (void)word();
    } else {
      binary_->skip(ply_type(type_name).size);
    }
  }
  bool at_end() const { return binary_ != nullptr || next_ == words_.size(); }

 private:
  const std::string& word() {
    expect(next_ < words_.size(), "a value per property");
    return words_[next_++];
  }
  Binary* binary_ = nullptr;
  WordList words_{};
  std::size_t next_ = 0;
  Decimals decimals_ = Decimals::Nearest;
};

bool is_axis(const WordList& property) {
  return property.size() == 2 && is_one_of(property[1], {"x", "y", "z"});
}

class Reader {
 public:
  Reader(const std::string& bytes, Decimals decimals) : bytes_(bytes), decimals_(decimals) {}

  MeshFile read(const std::string& extension);
  std::string where = "";  // the place of a failure

 private:
  WordList next(Lines& lines) {
    const WordList words = lines.next();
    where = "line " + std::to_string(lines.line());
    return words;
  }
  void add_point(const Rational& x, const Rational& y, const Rational& z) {
    file_.rows.push_back(scaled({x, y, z, 1}));
  }
  void add_point(const WordList& words, std::size_t first) {
    expect(words.size() >= first + 3, "three coordinates");
    const auto x = [&](std::size_t k) { return decimal(words[first + k], decimals_); };
    add_point(x(0), x(1), x(2));
  }
  void add_halfspace(const Numbers& row);

  void read_obj();
  void read_off();
  void read_ply();
  void read_ply_row(const PlyElement& element, PlyRow& row);
  void read_stl();
  void read_text_stl();
  void read_xyz();
  void read_rows();
  void read_ine();

  const std::string& bytes_;
  const Decimals decimals_;
  MeshFile file_;
};

// v x y z, with a weight (4 numbers), a colour (6) or both (7), which are not looked at.
void Reader::read_obj() {
  const WordList others = {"f",  "fo", "o",  "g",      "s",      "l", "p",
                           "vt", "vn", "vp", "usemtl", "mtllib", "mg"};
  Lines lines(bytes_, '#', true);
  for (WordList words; !(words = next(lines)).empty();) {
    if (words[0] != "v") {
      expect(is_one_of(words[0], others), "a statement such as v or f, found '" + words[0] + "'");
      continue;
    }
    const std::size_t extra = words.size() - 4;
    expect(words.size() >= 4 && (extra <= 1 || extra == 3 || extra == 4), "x y z and a colour");
    add_point(words, 1);
  }
}

// A header such as OFF or COFF, the counts behind it or on the next line, a point on each line.
void Reader::read_off() {
  Lines lines(bytes_, '#');
  WordList words = next(lines);
  expect(!words.empty() && words[0].ends_with("OFF") &&
             words[0].find_first_not_of("STCNOF") == words[0].npos,
         "a header such as OFF");
  words.erase(words.begin());
  if (words.empty()) words = next(lines);
  expect(words.size() >= 2 && is_digits(words[0]) && words[0].size() < 10, "the number of points");
  for (std::size_t count = std::stoul(words[0]); count > 0; --count) add_point(next(lines), 0);
}

// x y z on each line; further numbers are not looked at.
void Reader::read_xyz() {
  Lines lines(bytes_, '#');
  for (WordList words; !(words = next(lines)).empty();) add_point(words, 0);
}

// The elements that a header declares, to its end.
std::vector<PlyElement> read_ply_elements(const std::function<WordList()>& next) {
  std::vector<PlyElement> elements;
  for (WordList words; (words = next()) != WordList{"end_header"};) {
    expect(!words.empty(), "end_header");
    if (words.size() == 3 && words[0] == "element" && is_digits(words[2]) && words[2].size() < 10) {
      elements.push_back({words[1], std::stoul(words[2]), {}});
    } else if (words[0] == "property" && words.size() >= 3 && !elements.empty()) {
      expect(words.size() == (words[1] == "list" ? 5 : 3), "a property");
      for (std::size_t k = 1; k + 1 < words.size(); ++k) {
        if (words[k] != "list") (void)ply_type(words[k]);
      }
      elements.back().properties.emplace_back(words.begin() + 1, words.end());
    } else {
      expect(words[0] == "comment" || words[0] == "obj_info", "an element or a property");
    }
  }
  for (const PlyElement& element : elements) {
    const auto axes = std::count_if(element.properties.begin(), element.properties.end(), is_axis);
    expect(element.name != "vertex" || axes == 3, "a vertex with x, y and z");
  }
  return elements;
}

// The element vertex; rows of all others are stepped over by the sizes that they declare.
void Reader::read_ply() {
  Lines lines(bytes_);
  expect(next(lines) == WordList{"ply"}, "ply");
  const WordList format = next(lines);
  expect(format.size() == 3 && format[0] == "format", "format");
  const bool is_text = format[1] == "ascii", is_big = format[1] == "binary_big_endian";
  expect(is_text || is_big || format[1] == "binary_little_endian", "ascii or a byte order");
  const auto elements = read_ply_elements([&] { return next(lines); });
  // Where lines end with CR alone, an LF behind the header is the first byte of the body.
  const bool is_dos = bytes_.compare(bytes_.find_first_of("\r\n"), 2, "\r\n") == 0;
  const bool ends_so = bytes_.compare(lines.offset() - 2, 2, "\r\n") == 0;
  Binary binary(bytes_, lines.offset() - (ends_so && !is_dos), is_big);
  for (const PlyElement& element : elements) {
    for (std::size_t k = 0; k < element.count && !element.properties.empty(); ++k) {
      PlyRow row = is_text ? PlyRow(next(lines), decimals_) : PlyRow(binary);
      where = element.name + " " + std::to_string(k + 1);
      read_ply_row(element, row);
    }
  }
  expect(is_text ? next(lines).empty() : binary.at_end(), "the end of the file");
}

void Reader::read_ply_row(const PlyElement& element, PlyRow& row) {
  std::array<Rational, 3> point;
  for (const WordList& property : element.properties) {
    if (property.size() == 4) {
      const Rational length = row.take(property[1]);
      expect(length >= 0 && length.get_den() == 1, "the length of a list");
      for (Rational k = 0; k < length; k += 1) row.skip(property[2]);
    } else if (is_axis(property)) {
      point[std::size_t(property[1][0] - 'x')] = row.take(property[0]);
    } else {
      row.skip(property[0]);
    }
  }
  expect(row.at_end(), "no value without a property");
  if (element.name == "vertex") add_point(point[0], point[1], point[2]);
}

// Binary if and only if it has 84 + 50 n bytes, where bytes 80 to 83 hold n.
void Reader::read_stl() {
  const bool is_binary = bytes_.size() >= 84 && (bytes_.size() - 84) % 50 == 0 &&
                         Binary(bytes_, 80, false).take(4) == (bytes_.size() - 84) / 50;
  if (!is_binary) return read_text_stl();
  for (Binary in(bytes_, 84, false); !in.at_end(); in.skip(2)) {
    where = "triangle " + std::to_string(file_.rows.size() / 3 + 1);
    in.skip(12);
    for (int corner = 0; corner < 3; ++corner) {
      const Rational x = in.take_real(4), y = in.take_real(4), z = in.take_real(4);
      add_point(x, y, z);
    }
  }
}

void Reader::read_text_stl() {
  Lines lines(bytes_);
  for (WordList words; !(words = next(lines)).empty();) {
    const std::string word = lower_case(words[0]);
    expect(
        is_one_of(word, {"solid", "facet", "outer", "vertex", "endloop", "endfacet", "endsolid"}),
        "a word of STL, found '" + words[0] + "'");
    if (word != "vertex") continue;
    expect(words.size() == 4, "vertex x y z");
    add_point(words, 1);
  }
}

// A row without a normal is none; one that holds nowhere leaves no solid to prove anything of.
void Reader::add_halfspace(const Numbers& row) {
  const bool has_normal = row[0] != 0 || row[1] != 0 || row[2] != 0;
  expect(has_normal || row[3] <= 0, "halfspaces that hold somewhere");
  if (has_normal) file_.rows.push_back(primitive(scaled(row)));
}

void Reader::read_rows() {
  Lines lines(bytes_, '#');
  for (WordList words; !(words = next(lines)).empty();) {
    expect(words.size() == 4, "a row n1 n2 n3 d");
    Numbers row;
    for (std::size_t k = 0; k < 4; ++k) row[k] = number_of_row(words[k], decimals_);
    add_halfspace(row);
  }
}

// m 4 type, and m rows b a1 a2 a3 that mean b + a.x >= 0.
void Reader::read_ine() {
  Lines lines(bytes_, '*');
  const auto is_refused = [](const WordList& words) {
    return is_one_of(words[0], {"V-representation", "linearity", "equality", "strict_inequality",
                                "partial_enumeration"});
  };
  WordList words;
  for (words = next(lines); words != WordList{"begin"}; words = next(lines)) {
    expect(!words.empty() && !is_refused(words), "begin, and inequalities only");
  }
  words = next(lines);
  expect(words.size() == 3 && is_digits(words[0]) && words[0].size() < 10 && words[1] == "4",
         "the number of rows, 4 and their type");
  for (std::size_t count = std::stoul(words[0]); count > 0; --count) {
    words = next(lines);
    expect(words.size() == 4, "a row of four numbers");
    Numbers row;
    for (std::size_t k = 0; k < 4; ++k) {
      row[(k + 3) % 4] = -number_of_row(words[k], decimals_);
    }
    add_halfspace(row);
  }
  expect(next(lines) == WordList{"end"}, "end");
  while (!(words = next(lines)).empty()) expect(!is_refused(words), "inequalities only");
}

MeshFile Reader::read(const std::string& extension) {
  file_.is_mesh = !is_one_of(extension, {".txt", ".ine"});
  if (extension == ".obj") {
    read_obj();
  } else if (extension == ".off") {
    read_off();
  } else if (extension == ".ply") {
    read_ply();
  } else if (extension == ".stl") {
    read_stl();
  } else if (extension == ".xyz") {
    read_xyz();
  } else if (extension == ".txt") {
    read_rows();
  } else {
    expect(extension == ".ine", "a name that ends in .obj, .off, .ply, .stl, .xyz, .ine or .txt");
    read_ine();
  }
  return std::move(file_);
}

}  // namespace

MeshFile parse_mesh_file(const std::string& bytes, const std::string& path, Decimals decimals) {
  Reader reader(bytes, decimals);
  try {
    return reader.read(lower_case(path.substr(std::min(path.rfind('.'), path.size()))));
  } catch (Failure failure) {
    failure.where = path + (reader.where.empty() ? "" : ": " + reader.where);
    throw failure;
  }
}

MeshFile read_mesh_file(const std::string& path, Decimals decimals) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) throw Failure{3, "expected a file that can be read", path};
  return parse_mesh_file(bytes, path, decimals);
}

}  // namespace check
