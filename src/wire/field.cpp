// SPDX-License-Identifier: MIT
#include "wire/field.hpp"

#include <fmt/format.h>

#include <charconv>
#include <set>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
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

double parse_decimal(const std::string& option, const std::string& text) {
  try {
    return nearest_double(text);
  } catch (const Error&) {
    reject_argument(option + ": expected a number, found " + in_quotes(text));
  }
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ',') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
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

const BoundField& field_of(const std::string& name, const BoundFields& fields) {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const BoundField& known) {
    return known.info->name == name;
  });
  if (field != fields.end()) return *field;
  std::vector<std::string> names;
  for (const BoundField& known : fields) names.push_back(known.info->name);
  reject_argument(fmt::format("there is no option {}: expected options out of {}", in_quotes(name),
                              fmt::join(names, ", ")));
}

namespace {

void read_value(const BoundField& field, const std::string& value) {
  const std::string& name = field.info->name;
  if (field.info->kind == FieldKind::Flag && value != "true" && value != "false") {
    reject_word(name, {"false", "true"}, value);
  }
  try {
    field.read(name, value);
  } catch (const Error& error) {
    const std::string why = error.what();
    if (why.starts_with(name + ":")) throw;
    throw Error(error.code(), name + ": " + why);
  }
}

}  // namespace

void read_options(const char* given_text, const BoundFields& fields) {
  const std::string_view text = given_text == nullptr ? "" : given_text;
  constexpr std::string_view kBlanks = " \t\r\n";
  std::set<std::string> given;
  std::size_t end = 0;
  for (std::size_t at = 0; (at = text.find_first_not_of(kBlanks, end)) != text.npos;) {
    end = std::min(text.find_first_of(kBlanks, at), text.size());
    const std::string_view option = text.substr(at, end - at);
    const std::size_t equals = option.find('=');
    const std::string name(option.substr(0, equals));
    const BoundField& field = field_of(name, fields);
    if (!given.insert(name).second) reject_argument(name + ": given twice");
    const bool is_alone = equals == option.npos && field.info->kind == FieldKind::Flag;
    read_value(field, is_alone                ? "true"
                      : equals == option.npos ? ""
                                              : std::string(option.substr(equals + 1)));
  }
}

}  // namespace convexact
