// SPDX-License-Identifier: MIT
#include "wire/field.hpp"

#include <fmt/format.h>

#include <charconv>

#include "convexact/error.hpp"
#include "number/text.hpp"

namespace convexact {

std::uint64_t parse_count(const std::string& option, const std::string& text,
                          const CountRange& range) {
  std::uint64_t count = 0;
  // from_chars accepts neither blanks nor octal numbers, but it accepts a minus sign.
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool is_digits = !text.empty() && text.find_first_not_of("0123456789") == text.npos;
  if (!is_digits || failure != std::errc() || end != text.data() + text.size() ||
      count < range.least || count > range.most) {
    throw Error(ErrorCode::InvalidArgument,
                fmt::format("{}: expected a whole number from {} to {}, found {}", option,
                            range.least, range.most, in_quotes(text)));
  }
  return count;
}

std::string option_of(const FieldInfo& field) {
  std::string option = "--" + field.name;
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

void reject_word(const std::string& option, const std::vector<std::string>& words,
                 const std::string& found) {
  throw Error(ErrorCode::InvalidArgument, fmt::format("{}: expected one of {}, found {}", option,
                                                      fmt::join(words, ", "), in_quotes(found)));
}

}  // namespace convexact
