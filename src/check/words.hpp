// SPDX-License-Identifier: MIT
// words.hpp - the words of a proof and of other texts, and every way to spell a number.
#pragma once
#include <algorithm>
#include <istream>
#include <string>
#include <vector>

#include "exact.hpp"

namespace check {

using Ids = std::vector<std::size_t>;

// The words of a proof, each taken once.
struct Words {
  explicit Words(std::istream& in) : in_(in) { take(); }
  std::string take() {
    std::string taken = next_;
    line = next_line_;
    for (; std::isspace(in_.peek()); in_.get()) next_line_ += in_.peek() == '\n';
    if (!(in_ >> next_)) next_.clear();
    return taken;
  }
  bool at(const std::string& word) const { return next_ == word; }
  bool take_if(const std::string& word) { return at(word) && (take(), true); }
  bool at_number() const { return !next_.empty() && next_[0] <= '9'; }
  std::size_t id(std::size_t limit) {
    const std::string text = take();
    expect(!text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == text.npos &&
               std::stoul(text) < limit,
           "a number below " + std::to_string(limit));
    return std::stoul(text);
  }
  Ids ids(std::size_t limit) {
    Ids list;
    while (at_number()) list.push_back(id(limit));
    return list;
  }
  // "p", "p/q", or a double in hexadecimal such as -0x1.8p-3: exactly what is spelt, never rounded.
  Rational rational() {
    std::string text = take();
    const std::size_t x = text.find("0x"), p = std::min(text.find('p'), text.size());
    const bool is_hex = x < 2 && p + 1 < text.size() && std::isxdigit(text[x + 2]);
    char* end = text.data() + text.size();
    long shift = is_hex ? std::strtol(&text[p] + 1, &end, 10) : 0;
    expect(*end == 0 && shift > -2000 && shift < 2000, "an exponent of two");
    const std::size_t point = std::min(text.find('.'), p);
    if (is_hex) shift -= long(4 * (text.erase(p).erase(point, 1).size() - point));
    Rational value;
    expect(text.find_first_not_of(is_hex ? "-0123456789abcdefx" : "-0123456789/") == text.npos &&
               value.set_str(text, is_hex ? 0 : 10) == 0 && value.get_den() != 0,
           "a number");
    value.canonicalize();
    return shift < 0 ? Rational(value >> -shift) : Rational(value << shift);
  }
  Row point() { return scaled({rational(), rational(), rational(), 1}); }
  Numbers halfspace() {
    const Numbers x{rational(), rational(), rational(), rational()};
    expect(x[0] != 0 || x[1] != 0 || x[2] != 0, "a normal that is not zero");
    return x;
  }

  std::istream& in_;
  std::string next_;
  std::size_t line = 1, next_line_ = 1;  // of the word taken last, and of the next
};

// What a decimal in a text means. Binary numbers, integers and fractions are what they are.
enum class Decimals { Nearest, Spelt };  // the nearest double, a tie to even; or the rational spelt

inline bool is_digits(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

// With 53 bits, or fewer where the last would be below 2^-1074: |x| is cut into steps of 2^e.
inline Rational nearest_double(const Rational& x) {
  if (x == 0) return x;
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
  const std::string shape = "a number, found '" + word.substr(0, 40) + "'";
  const bool is_signed = !word.empty() && (word[0] == '-' || word[0] == '+');
  const std::size_t e = std::min(word.find_first_of("eE"), word.size());
  std::string digits = word.substr(is_signed, e - is_signed);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const long places = point < digits.size() ? long(digits.size() - point) - 1 : 0;
  digits.erase(point, 1);
  std::string exponent = e < word.size() ? word.substr(e + 1) : "0";
  const bool is_small = exponent.starts_with('-');
  if (is_small || exponent.starts_with('+')) exponent.erase(0, 1);
  expect(is_digits(digits) && is_digits(exponent), shape);
  // What is far beyond every double, or below half the smallest, is told before it takes memory.
  const Integer shift = Integer(is_small ? "-" + exponent : exponent, 10) - places;
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  if (digits.empty()) return 0;
  const Integer magnitude = shift + digits.size();  // the value is below 10^magnitude
  expect(magnitude <= 309, "a number below 2^1024");
  if (decimals == Decimals::Nearest && magnitude < -330) return 0;
  expect(shift >= -100000 - Integer(digits.size()), "an exponent that is not absurd");
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, Integer(abs(shift)).get_ui());
  Rational value(Integer(digits, 10), shift < 0 ? power : Integer(1));
  value.canonicalize();
  if (shift > 0) value *= power;
  if (word[0] == '-') value = -value;
  return decimals == Decimals::Nearest ? nearest_double(value) : value;
}

// In lists of halfspaces integers and p/q are exact whatever decimals are.
inline Rational number_of_row(const std::string& word, Decimals decimals) {
  if (word.find_first_not_of("+-0123456789/") != word.npos) return decimal(word, decimals);
  const std::size_t slash = std::min(word.find('/'), word.size());
  const Rational above = decimal(word.substr(0, slash), Decimals::Spelt);
  if (slash == word.size()) return above;
  expect(is_digits(word.substr(slash + 1)), "a fraction p/q");
  const Rational below(Integer(word.substr(slash + 1), 10));
  expect(below != 0, "a fraction p/q");
  return above / below;
}

using WordList = std::vector<std::string>;

inline bool is_one_of(const std::string& word, const WordList& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// Bytes, line by line: a line ends with LF, CR LF or CR.
class Lines {
 public:
  // A word that starts with `comment` ends its line. With `continued` a backslash at the end joins
  // a line with the next, but for a name after o or g, which is taken to the letter.
  explicit Lines(const std::string& bytes, char comment = '\0', bool continued = false)
      : bytes_(bytes), comment_(comment), continued_(continued) {
    if (bytes_.starts_with("\xEF\xBB\xBF")) offset_ = 3;
  }
  std::size_t offset() const { return offset_; }  // behind the line
  std::size_t line() const { return line_; }

  // The words of the next line that has any; none at the end.
  WordList next() {
    WordList words;
    while (words.empty() && offset_ < bytes_.size()) {
      while (append(words) && offset_ < bytes_.size()) continue;
    }
    return words;
  }

 private:
  bool append(WordList& words) {  // whether the line goes on
    const std::size_t end = std::min(bytes_.find_first_of("\r\n", offset_), bytes_.size());
    std::string text = bytes_.substr(offset_, end - offset_);
    offset_ = std::min(end + (bytes_.compare(end, 2, "\r\n") == 0 ? 2 : 1), bytes_.size());
    ++line_;
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
  std::size_t offset_ = 0, line_ = 0;
};

}  // namespace check
