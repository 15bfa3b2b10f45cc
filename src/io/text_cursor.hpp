// SPDX-License-Identifier: MIT
// text_cursor.hpp - walks a text line by line and token by token, and knows where it is.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// How one format cuts its lines.
struct TextRules {
  char comment = '\0';        ///< A token that starts with it ends the line; '\0': no comments.
  bool continuation = false;  ///< A backslash at the end of a line joins it with the next, if any.
};

/// Lines end at "\n", "\r\n" or "\r". Tokens are separated by blanks. Views point into the
/// text. Every error carries the 1-based number of the line that the cursor is in.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text, TextRules rules = {});

  /// Goes to the next line that has a token (at first: the first one); false at the end.
  bool next_line();
  /// The next token of this line; empty if there is none.
  std::string_view token();
  /// Takes the next token of this line if it is one to nine digits, not only zeros, and nothing is
  /// in its way but blanks. Otherwise it is 0, and the cursor stays before the token.
  std::uint32_t take_plain_index();
  /// The rest of this line without blanks around it, taken literally: no comment, no continuation.
  std::string_view rest();

  /// From the next line on, another comment character.
  void set_comment(char comment) { rules_.comment = comment; }

  std::size_t line() const { return line_; }
  /// Bytes from the cursor to the end.
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - position_); }
  std::size_t offset() const { return static_cast<std::size_t>(position_ - begin_); }

  /// Goes to the next line and its first token.
  /// @throws Error Malformed at the end: "expected `what` [number], found the end of the file".
  std::string_view expect_line(std::string_view what, std::optional<std::size_t> number = {});
  /// The next token. @throws Error Malformed if the line has none.
  std::string_view expect_token(std::string_view what);
  /// @throws Error Malformed unless the line is used up.
  void expect_line_end();
  /// @throws Error Malformed unless no line with a token follows.
  void expect_end();
  /// `token` as a count or index. @throws Error Malformed unless it is one below 2^32.
  std::uint32_t to_count(std::string_view token, std::string_view what) const;
  /// `token` as the nearest binary32 number if `decimal` says so, else as the nearest double.
  /// @throws Error as nearest_float and nearest_double.
  double to_number(std::string_view token, Decimal decimal = Decimal::Nearest) const;

  /// @throws Error Malformed: "expected `what`, found `token`" (empty: the end of the line).
  [[noreturn]] void fail_expected(std::string_view what, std::string_view token) const;
  [[noreturn]] void fail(const std::string& message, ErrorCode code = ErrorCode::Malformed) const {
    throw Error(code, message, line_);
  }

 private:
  enum class ByteKind : unsigned char { Other, Blank, LineEnd, Backslash };
  static const std::array<ByteKind, 256> kByteKinds;

  static ByteKind kind_of(char c) { return kByteKinds[static_cast<unsigned char>(c)]; }
  static bool is_blank(char c) { return kind_of(c) == ByteKind::Blank; }
  static bool is_line_end(char c) { return kind_of(c) == ByteKind::LineEnd; }
  void skip_blanks();
  bool at_line_end() const;
  bool is_continuation() const;
  void step_over_line_end();

  const char* begin_;
  const char* position_;
  const char* end_;
  TextRules rules_;
  std::size_t line_ = 1;
  bool started_ = false;
};

// Inline is what every byte of a large file passes through.

// By table, since every byte is asked.
inline constexpr std::array<TextCursor::ByteKind, 256> TextCursor::kByteKinds = [] {
  std::array<ByteKind, 256> kinds{};
  for (const char c : {' ', '\t', '\v', '\f'}) {
    kinds[static_cast<unsigned char>(c)] = ByteKind::Blank;
  }
  for (const char c : {'\n', '\r'}) kinds[static_cast<unsigned char>(c)] = ByteKind::LineEnd;
  kinds['\\'] = ByteKind::Backslash;
  return kinds;
}();

inline void TextCursor::skip_blanks() {
  while (position_ < end_) {
    const ByteKind kind = kind_of(*position_);
    if (kind == ByteKind::Blank) {
      ++position_;
    } else if (kind == ByteKind::Backslash && is_continuation()) {
      ++position_;
      if (position_ < end_) step_over_line_end();
    } else {
      return;
    }
  }
}

inline bool TextCursor::at_line_end() const {
  return position_ == end_ || is_line_end(*position_) ||
         (rules_.comment != '\0' && *position_ == rules_.comment);
}

inline std::string_view TextCursor::token() {
  skip_blanks();
  if (at_line_end()) return {};
  const char* const first = position_;
  const char* next = first;
  for (; next < end_; ++next) {
    const ByteKind kind = kind_of(*next);
    if (kind == ByteKind::Other) continue;
    position_ = next;
    if (kind != ByteKind::Backslash || is_continuation()) break;
  }
  position_ = next;
  return {first, static_cast<std::size_t>(next - first)};
}

inline std::uint32_t TextCursor::take_plain_index() {
  skip_blanks();
  std::uint32_t index = 0;
  const char* next = position_;
  for (; next < end_ && '0' <= *next && *next <= '9'; ++next) {
    index = 10 * index + static_cast<std::uint32_t>(*next - '0');
  }
  const bool is_token = next == end_ || is_blank(*next) || is_line_end(*next);
  if (!is_token || next - position_ > 9 || index == 0) return 0;
  position_ = next;
  return index;
}

inline std::string_view TextCursor::expect_token(std::string_view what) {
  const std::string_view found = token();
  if (found.empty()) fail_expected(what, found);
  return found;
}

}  // namespace convexact
