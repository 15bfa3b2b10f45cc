// SPDX-License-Identifier: MIT
// proof_lines.hpp - the lines of a proof, as docs/proof-format.md writes them.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/geometry.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/number.hpp"
#include "number/text.hpp"

namespace convexact {

/// A keyword and its fields to a line; doubles in hexadecimal, exact numbers as fractions.
class ProofLines {
 public:
  template <class... Fields>
  void line(const std::string& keyword, const Fields&... fields) {
    text_ += keyword;
    (add(fields), ...);
    text_ += '\n';
  }

  /// A line for each point, exactly.
  void points(const char* keyword, const PointSet& points) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (points.is_binary()) {
        line(keyword, points.doubles()[p]);
      } else {
        line(keyword, points[PointId(p)]);
      }
    }
  }

  void append(const ProofLines& others) { text_ += others.text_; }

  /// The text, with its last line, which counts all of them.
  std::string finish() {
    line("end", static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '\n')) + 1);
    return std::move(text_);
  }

 private:
  void add(const char* word) { text_ += std::string(" ") + word; }
  void add(const std::string& word) { text_ += ' ' + word; }
  // A template, as std::size_t and std::uint32_t are one type on 32-bit machines.
  template <std::unsigned_integral Number>
  void add(Number number) {
    text_ += fmt::format(" {}", number);
  }
  void add(double number) { add(hex_float(number)); }
  void add(const Rational& number) { add(to_string(number)); }
  void add(const Integer& number) { add(to_string(number)); }
  template <class Tag>
  void add(Id<Tag> id) {
    add(id.value);
  }
  template <class Number>
  void add(const Vector3<Number>& v) {
    for (int k = 0; k < 3; ++k) add(v[k]);
  }
  template <class Item>
  void add(const std::vector<Item>& items) {
    for (const Item& item : items) add(item);
  }
  template <class Item, std::size_t size>
  void add(const std::array<Item, size>& items) {
    for (const Item& item : items) add(item);
  }
  void add(const Halfspace& halfspace) {
    add(halfspace.normal());
    add(halfspace.offset());
  }
  void add(const RootSum& sum) {
    for (const RootTerm& term : sum.terms()) {
      add(term.factor);
      add(term.radicand);
    }
  }
  template <class First, class Second>
  void add(const std::pair<First, Second>& fields) {
    add(fields.first);
    add(fields.second);
  }
  void add(const Multiplier& weight) {
    add(weight.row);
    add(weight.value);
  }

  std::string text_;
};

}  // namespace convexact
