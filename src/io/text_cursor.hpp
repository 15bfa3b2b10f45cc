// SPDX-License-Identifier: MIT
// text_cursor.hpp - walks a text line by line and token by token, and knows where it is.
#pragma once
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

}  // namespace convexact
