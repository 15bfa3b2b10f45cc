// SPDX-License-Identifier: MIT
#include "io/text_cursor.hpp"

#include <charconv>

#include "number/text.hpp"

namespace convexact {
TextCursor::TextCursor(std::string_view text, TextRules rules)
    : begin_(text.data()), position_(begin_), end_(begin_ + text.size()), rules_(rules) {
  // Some editors put a byte order mark before UTF-8.
  if (text.substr(0, 3) == "\xEF\xBB\xBF") position_ += 3;
}

// At a backslash: whether it joins this line with the next.
bool TextCursor::is_continuation() const {
  return rules_.continuation && (position_ + 1 == end_ || is_line_end(position_[1]));
}

void TextCursor::step_over_line_end() {
  const bool two = *position_ == '\r' && position_ + 1 < end_ && position_[1] == '\n';
  position_ += two ? 2 : 1;
  ++line_;
}

bool TextCursor::next_line() {
  if (!started_) {
    started_ = true;
    skip_blanks();
    if (!at_line_end()) return true;
  }
  while (position_ < end_) {
    if (is_line_end(*position_)) {
      step_over_line_end();
      skip_blanks();
      if (!at_line_end()) return true;
    } else {
      ++position_;
    }
  }
  return false;
}

std::string_view TextCursor::rest() {
  while (position_ < end_ && is_blank(*position_)) ++position_;
  const char* first = position_;
  while (position_ < end_ && !is_line_end(*position_)) ++position_;
  const char* last = position_;
  while (last > first && is_blank(last[-1])) --last;
  return {first, static_cast<std::size_t>(last - first)};
}

std::string_view TextCursor::expect_line(std::string_view what, std::optional<std::size_t> number) {
  if (next_line()) return token();
  const std::string numbered = number ? " " + std::to_string(*number) : "";
  fail("expected " + std::string(what) + numbered + ", found the end of the file");
}

void TextCursor::expect_line_end() {
  const std::string_view found = token();
  if (!found.empty()) fail_expected("the end of the line", found);
}

void TextCursor::expect_end() {
  if (next_line()) fail_expected("the end of the file", token());
}

std::uint32_t TextCursor::to_count(std::string_view token, std::string_view what) const {
  std::uint32_t value = 0;
  const auto [end, status] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (status != std::errc() || end != token.data() + token.size()) fail_expected(what, token);
  return value;
}

double TextCursor::to_number(std::string_view token, Decimal decimal) const {
  try {
    return decimal == Decimal::Nearest32 ? nearest_float(token) : nearest_double(token);
  } catch (const Error& error) {
    fail(error.what(), error.code());
  }
}

void TextCursor::fail_expected(std::string_view what, std::string_view token) const {
  fail("expected " + std::string(what) + ", found " +
       (token.empty() ? "the end of the line" : in_quotes(token)));
}

}  // namespace convexact
