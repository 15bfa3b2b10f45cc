// SPDX-License-Identifier: MIT
// stored_file.hpp - a parser of the mesh files that convexact writes, for tests that judge bytes.
// Shares no code with the library: strtod and memcpy only. Accepts what we write, nothing more.
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace stored_file {

struct Solid {
  std::vector<std::array<double, 3>> vertices;  // equal ones merged
  std::vector<std::vector<std::size_t>> polygons;
};

inline double number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') throw std::runtime_error("not a number: " + text);
  return value;
}

inline std::size_t add_vertex(Solid& solid, std::map<std::array<double, 3>, std::size_t>& known,
                              std::array<double, 3> p) {
  for (double& x : p) x += 0.0;  // -0 is 0
  const auto [place, is_new] = known.try_emplace(p, solid.vertices.size());
  if (is_new) solid.vertices.push_back(p);
  return place->second;
}

inline Solid parse_obj(std::istream& in) {
  Solid solid;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string kind, word;
    words >> kind;
    if (kind == "v") {
      std::array<double, 3> p{};
      for (double& x : p) words >> word, x = number(word);
      solid.vertices.push_back(p);
    } else if (kind == "f") {
      solid.polygons.emplace_back();
      while (words >> word) solid.polygons.back().push_back(std::stoul(word) - 1);
    }
  }
  return solid;
}

inline Solid parse_off(std::istream& in) {
  std::string word;
  in >> word;
  if (word != "OFF") throw std::runtime_error("no OFF header");
  std::size_t vertices = 0, faces = 0, edges = 0;
  in >> vertices >> faces >> edges;
  Solid solid;
  solid.vertices.resize(vertices);
  for (auto& p : solid.vertices) {
    for (double& x : p) in >> word, x = number(word);
  }
  solid.polygons.resize(faces);
  for (auto& polygon : solid.polygons) {
    std::size_t count = 0;
    in >> count;
    polygon.resize(count);
    for (std::size_t& corner : polygon) in >> corner;
  }
  if (!in) throw std::runtime_error("OFF ends early");
  return solid;
}

/// Fixed-size numbers from bytes.
class Bytes {
 public:
  Bytes(const std::string& bytes, std::size_t at, bool big) : bytes_(bytes), at_(at), big_(big) {}
  template <class T>
  T take() {
    if (at_ + sizeof(T) > bytes_.size()) throw std::runtime_error("the file ends early");
    std::array<char, sizeof(T)> raw;
    for (std::size_t k = 0; k < sizeof(T); ++k) {
      const bool mirrored = big_ == (std::endian::native == std::endian::little);
      raw[mirrored ? sizeof(T) - 1 - k : k] = bytes_[at_ + k];
    }
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }
  bool at_end() const { return at_ == bytes_.size(); }
  void skip(std::size_t count) { at_ += count; }

 private:
  const std::string& bytes_;
  std::size_t at_;
  bool big_;
};

// One number of a PLY, of the type its header names.
inline double take_ply(Bytes& in, const std::string& type) {
  if (type == "double" || type == "float64") return in.take<double>();
  if (type == "float" || type == "float32") return in.take<float>();
  if (type == "int" || type == "int32") return in.take<std::int32_t>();
  if (type == "uint" || type == "uint32") return in.take<std::uint32_t>();
  if (type == "uchar" || type == "uint8") return in.take<std::uint8_t>();
  throw std::runtime_error("unexpected PLY type " + type);
}

inline Solid parse_ply(const std::string& bytes) {
  std::istringstream in(bytes);
  std::string line, format, element, coordinate, count_type, index_type;
  std::size_t vertices = 0, faces = 0;
  while (std::getline(in, line) && line != "end_header") {
    std::istringstream words(line);
    std::string key, word;
    words >> key;
    if (key == "format") words >> format;
    if (key == "element") words >> element >> (element == "vertex" ? vertices : faces);
    if (key == "property" && element == "vertex") words >> coordinate;
    if (key == "property" && element == "face") words >> word >> count_type >> index_type;
  }
  Bytes binary(bytes, static_cast<std::size_t>(in.tellg()), format == "binary_big_endian");
  const auto next = [&](const std::string& type) {
    if (format != "ascii") return take_ply(binary, type);
    std::string word;
    in >> word;
    // A float property means the nearest float.
    return type == "float" || type == "float32" ? std::strtof(word.c_str(), nullptr) : number(word);
  };
  Solid solid;
  solid.vertices.resize(vertices);
  for (auto& p : solid.vertices) {
    for (double& x : p) x = next(coordinate);
  }
  solid.polygons.resize(faces);
  for (auto& polygon : solid.polygons) {
    polygon.resize(static_cast<std::size_t>(next(count_type)));
    for (std::size_t& corner : polygon) corner = static_cast<std::size_t>(next(index_type));
  }
  if (format != "ascii" && !binary.at_end()) throw std::runtime_error("bytes after the last face");
  return solid;
}

inline Solid parse_binary_stl(const std::string& bytes) {
  Solid solid;
  std::map<std::array<double, 3>, std::size_t> known;
  Bytes in(bytes, 80, false);
  const auto count = in.take<std::uint32_t>();
  for (std::uint32_t t = 0; t < count; ++t) {
    in.skip(12);  // the normal
    solid.polygons.emplace_back();
    for (int corner = 0; corner < 3; ++corner) {
      std::array<double, 3> p{};
      for (double& x : p) x = in.take<float>();
      solid.polygons.back().push_back(add_vertex(solid, known, p));
    }
    in.skip(2);
  }
  if (!in.at_end()) throw std::runtime_error("bytes after the last triangle");
  return solid;
}

inline Solid parse_ascii_stl(std::istream& in) {
  Solid solid;
  std::map<std::array<double, 3>, std::size_t> known;
  std::string word;
  while (in >> word) {
    if (word == "outer") solid.polygons.emplace_back();
    if (word != "vertex") continue;
    std::array<double, 3> p{};
    for (double& x : p) in >> word, x = number(word);
    solid.polygons.back().push_back(add_vertex(solid, known, p));
  }
  return solid;
}

/// `extension` without the dot.
inline Solid parse(const std::string& bytes, const std::string& extension) {
  std::istringstream in(bytes);
  if (extension == "obj") return parse_obj(in);
  if (extension == "off") return parse_off(in);
  if (extension == "ply") return parse_ply(bytes);
  if (bytes.rfind("solid", 0) == 0) return parse_ascii_stl(in);
  return parse_binary_stl(bytes);
}

}  // namespace stored_file
