// SPDX-License-Identifier: MIT
// text.hpp - the words of a proof, and every way to spell a number.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "exact.hpp"

namespace check {

using Ids = std::vector<std::size_t>;
using WordList = std::vector<std::string>;

constexpr const char* kDigits = "0123456789";
constexpr const char* kHexDigits = "0123456789abcdef";

inline bool has_only(const std::string& text, const char* characters) {
  return text.find_first_not_of(characters) == text.npos;
}
inline bool is_digits(const std::string& text) { return !text.empty() && has_only(text, kDigits); }
inline bool is_count(const std::string& text) { return is_digits(text) && text.size() < 10; }
inline bool is_one_of(const std::string& word, const WordList& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

inline std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return text;
}

// The parts of a number in text: its digits without the point, how many of them are after the
// point, and the exponent after a marker such as e.
struct SpeltNumber {
  bool is_negative;
  std::string digits;
  long places = 0;
  Integer exponent = 0;

  SpeltNumber(const std::string& word, const char* markers, const char* alphabet)
      : is_negative(word.starts_with('-')) {
    const std::string shape = "a number, found '" + word.substr(0, 40) + "'";
    const std::size_t start = is_negative || word.starts_with('+') ? 1 : 0;
    const std::size_t marker = std::min(word.find_first_of(markers), word.size());
    digits = word.substr(start, marker - start);
    const std::size_t point = digits.find('.');
    if (point != digits.npos) {
      places = long(digits.size() - point) - 1;
      digits.erase(point, 1);
    }
    expect(!digits.empty() && has_only(digits, alphabet), shape);
    if (marker == word.size()) return;
    std::string power = word.substr(marker + 1);
    const bool is_small = power.starts_with('-');
    if (is_small || power.starts_with('+')) power.erase(0, 1);
    expect(is_digits(power), shape);
    exponent = Integer(power, 10);
    if (is_small) exponent = -exponent;
  }
};

// In a proof: "p", "p/q", or a double in hexadecimal such as -0x1.8p-3. Nothing is rounded.
inline Rational number_of_proof(const std::string& word) {
  if (word.starts_with("-0x")) return -number_of_proof(word.substr(1));
  if (word.starts_with("0x")) {
    const SpeltNumber spelt(word.substr(2), "p", kHexDigits);
    expect(has_only(word.substr(2, 1), kHexDigits) && word.find('p') != word.npos &&
               abs(spelt.exponent) < 2000,
           "hexadecimal digits and an exponent of two");
    return Integer(spelt.digits, 16) * power_of_two(spelt.exponent.get_si() - 4 * spelt.places);
  }
  Rational value;
  // (GMP stops at a byte 0, and takes blanks.)
  expect(has_only(word, "-0123456789/") && value.set_str(word, 10) == 0 && value.get_den() != 0,
         "a number");
  value.canonicalize();
  return value;
}

// The meaning of a decimal in a mesh file: the nearest double, with ties to even; or the rational
// spelt.
enum class Decimals { Nearest, Spelt };

// A double has 53 bits, or fewer if the last one would be below 2^-1074: |x| is cut into steps of
// 2^e, and the whole number of steps is rounded.
inline Rational nearest_double(const Rational& x) {
  const Rational size = abs(x);
  long e = long(mpz_sizeinbase(size.get_num_mpz_t(), 2)) -
           long(mpz_sizeinbase(size.get_den_mpz_t(), 2)) - 53;  // 2^52 < size / 2^e < 2^54
  if (size >= power_of_two(e + 53)) ++e;
  e = std::max(e, -1074L);
  const Rational steps = size / power_of_two(e);
  Integer whole = steps.get_num() / steps.get_den();
  const int beyond_half = cmp(Rational(steps - whole), Rational(1, 2));
  if (beyond_half > 0 || (beyond_half == 0 && mpz_odd_p(whole.get_mpz_t()))) ++whole;
  const Rational value = whole * power_of_two(e);
  expect(value < power_of_two(1024), "a number below 2^1024");
  return sgn(x) < 0 ? Rational(-value) : value;
}

// A decimal such as -12, +1.5, 5. or .5e-3.
inline Rational decimal(const std::string& word, Decimals decimals) {
  SpeltNumber spelt(word, "eE", kDigits);
  spelt.digits.erase(0, std::min(spelt.digits.find_first_not_of('0'), spelt.digits.size()));
  if (spelt.digits.empty()) return 0;
  // The value is below 10^magnitude. A size far beyond every double, or below half the smallest
  // one, is decided before it needs memory.
  const Integer count = spelt.digits.size(), shift = spelt.exponent - spelt.places;
  const Integer magnitude = shift + count;
  expect(magnitude <= 309, "a number below 2^1024");
  if (decimals == Decimals::Nearest && magnitude < -330) return 0;
  expect(shift >= -100000 - count, "an exponent within the limits");
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, Integer(abs(shift)).get_ui());
  const Integer digits(spelt.digits, 10);
  Rational value = shift < 0 ? quotient(digits, power) : Rational(digits * power);
  if (spelt.is_negative) value = -value;
  return decimals == Decimals::Nearest ? nearest_double(value) : value;
}

// In lists of halfspaces integers and p/q are exact, for every meaning of decimals.
inline Rational number_of_row(const std::string& word, Decimals decimals) {
  if (word.find_first_of(".eE") != word.npos) return decimal(word, decimals);
  const std::size_t slash = std::min(word.find('/'), word.size());
  Rational above = decimal(word.substr(0, slash), Decimals::Spelt);
  if (slash == word.size()) return above;
  const std::string below = word.substr(slash + 1);
  expect(is_digits(below) && !has_only(below, "0"), "a fraction p/q");
  return above / Rational(Integer(below, 10));
}

// The words of a proof, each taken once. A line break is a blank, but lines are counted.
class Words {
 public:
  explicit Words(const std::string& bytes) : bytes_(bytes) { take(); }
  std::size_t line() const { return line_; }  // of the word taken last

  // The next word; empty at the end.
  std::string take() {
    std::string taken = next_;
    line_ = next_line_;
    const std::size_t start = std::min(bytes_.find_first_not_of(kBlanks, place_), bytes_.size());
    next_line_ += std::count(bytes_.begin() + place_, bytes_.begin() + start, '\n');
    place_ = std::min(bytes_.find_first_of(kBlanks, start), bytes_.size());
    next_ = bytes_.substr(start, place_ - start);
    return taken;
  }
  bool take_if(const std::string& word) {
    const bool is_next = next_ == word;
    if (is_next) take();
    return is_next;
  }
  bool at_number() const { return !next_.empty() && next_[0] <= '9'; }
  std::size_t id(std::size_t limit) {
    const std::string text = take();
    expect(is_count(text) && std::stoul(text) < limit, "a number below " + std::to_string(limit));
    return std::stoul(text);
  }
  Ids ids(std::size_t limit) {
    Ids list;
    while (at_number()) list.push_back(id(limit));
    return list;
  }
  // Requires the number of this line, so that none is missing, and nothing after it.
  void end() {
    expect(take_if("end"), "end and its line number");
    const std::size_t number = id(line() + 1);
    expect(number == line(), "end and its line number");
    expect(take().empty(), "nothing after the end");
  }
  Rational rational() { return number_of_proof(take()); }
  Row point() { return scaled({rational(), rational(), rational(), 1}); }
  Row direction() { return scaled({rational(), rational(), rational(), 0}); }
  Numbers halfspace() {
    Numbers x{rational(), rational(), rational(), rational()};
    expect(x[0] != 0 || x[1] != 0 || x[2] != 0, "a normal that is not zero");
    return x;
  }

 private:
  static constexpr const char* kBlanks = " \t\v\f\r\n";
  const std::string& bytes_;
  std::size_t place_ = 0, line_ = 1, next_line_ = 1;
  std::string next_;
};

// What `prove` returns; a failure gets the line of the word that was taken last.
template <class Prove>
std::string with_line(const Words& words, const Prove& prove) {
  try {
    return prove();
  } catch (Failure failure) {
    failure.where = "line " + std::to_string(words.line());
    throw failure;
  }
}

}  // namespace check
