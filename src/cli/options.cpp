// SPDX-License-Identifier: MIT
#include "cli/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "wire/simplify_options.hpp"

namespace convexact::cli {
namespace {

constexpr double kLongest = 1e6;  // seconds

[[noreturn]] void expected(const std::string& option, const std::string& what,
                           const std::string& found) {
  throw Error(ErrorCode::InvalidArgument,
              option + ": expected " + what + ", found " + in_quotes(found));
}

// The fewest letters to leave out, add, change, or swap with their neighbour, each at most once:
// row by row over the prefixes of `a`, with the two rows before.
std::size_t changes_between(const std::string& a, const std::string& b) {
  std::vector<std::size_t> above_last, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    above_last = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], above_last[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

// Digits, or digits, a point and digits.
bool is_plain_decimal(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == text.npos) return is_digits(text);
  return is_digits(text.substr(0, point)) && is_digits(text.substr(point + 1));
}

// 1024 to the power that the unit's first letter stands for; nothing if it is no unit.
std::optional<Integer> bytes_of_unit(std::string unit) {
  std::transform(unit.begin(), unit.end(), unit.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  constexpr std::string_view kLetters = "bkmgt";
  if (unit.empty()) return 1;
  const std::size_t power = kLetters.find(unit[0]);
  const std::string rest = unit.substr(1);
  if (power == kLetters.npos || !(rest.empty() || (power > 0 && (rest == "b" || rest == "ib")))) {
    return std::nullopt;
  }
  return Integer(1) << (10 * power);
}

std::uint64_t parse_bytes(const std::string& option, const std::string& text) {
  const std::string number = text.substr(0, text.find_first_not_of("0123456789."));
  const std::optional<Integer> unit = bytes_of_unit(text.substr(number.size()));
  if (unit && is_plain_decimal(number)) {
    const Rational bytes = parse_rational(number) * Rational(*unit);
    const Integer whole = numerator(bytes) / denominator(bytes);
    if (whole <= std::numeric_limits<std::uint64_t>::max()) {
      return whole.convert_to<std::uint64_t>();
    }
  }
  expected(option, "a size such as 512MB or 1.5GB, below 2^64 bytes", text);
}

}  // namespace

double parse_seconds(const std::string& option, const std::string& text) {
  try {
    const double seconds = nearest_double(text);
    if (seconds > 0 && seconds <= kLongest) return seconds;
  } catch (const Error&) {  // told below
  }
  expected(option, fmt::format("seconds, more than 0 and at most {:.0f}", kLongest), text);
}

std::string trimmed(const std::string& text) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string* nearest = nullptr;
  std::size_t least = word.size() / 3 + 1;
  for (const std::string& other : known) {
    const std::size_t changes = changes_between(word, other);
    if (changes >= least) continue;
    least = changes;
    nearest = &other;
  }
  return nearest == nullptr ? "" : "; did you mean " + in_quotes(*nearest) + "?";
}

Option add_text(
    Command& command, const std::string& names, const std::string& meaning,
    const std::function<void(const std::string& option, const std::string& text)>& take) {
  const std::string name = names.substr(names.rfind(',') + 1);
  return command.add_option_function(
      names, [name, take](const std::string& text) { take(name, text); }, meaning);
}

namespace {

// The words of a choice in the help, the default with an asterisk.
std::string marked(const FieldInfo& field, const std::string& present) {
  std::string text;
  for (const std::string& word : field.words) {
    text += (text.empty() ? "" : "|") + word + (word == present ? "*" : "");
  }
  return text;
}

}  // namespace

Option add_field(Command& command, const BoundField& field, const std::string& note) {
  const auto& [info, read, present] = field;
  const std::string option = option_of(*info);
  const std::string names =
      info->letter != 0 ? std::string("-") + info->letter + "," + option : option;
  const std::string meaning = info->meaning + note;
  switch (info->kind) {
    case FieldKind::Flag:
      return command.add_flag_function(
          names, [read = read, option] { read(option, "true"); }, meaning);
    case FieldKind::Count: {
      const auto usual = present.empty() ? std::nullopt : std::optional(std::stoull(present));
      return add_count(
          command, names, info->range, meaning, usual,
          [read = read, option](std::uint64_t count) { read(option, std::to_string(count)); });
    }
    case FieldKind::Choice:
      return add_text(
                 command, names, meaning + (present.empty() ? "" : " (* is the default)"),
                 [read = read](const auto& name, const auto& text) { read(name, to_lower(text)); })
          ->type_name(marked(*info, present));
    case FieldKind::Text:
      break;
  }
  Option added = add_text(command, names, meaning, read);
  return present.empty() ? added : added->default_str(present);
}

Option add_count(Command& command, const std::string& names, const CountRange& range,
                 const std::string& meaning, std::optional<std::uint64_t> usual,
                 const std::function<void(std::uint64_t)>& take) {
  const bool is_endless = range.most >> 32 != 0;
  const std::string limits = is_endless ? "" : fmt::format(", {} to {}", range.least, range.most);
  Option option = add_text(
      command, names, meaning + limits,
      [take, range](const auto& name, const auto& text) { take(parse_count(name, text, range)); });
  if (usual && *usual >= range.least && *usual <= range.most) {
    option->default_str(std::to_string(*usual));
  }
  return option->type_name("COUNT");
}

Option add_bytes(Command& command, const std::string& names, std::uint64_t& value,
                 const std::string& meaning) {
  return add_text(command, names, meaning,
                  [&value](const auto& name, const auto& text) { value = parse_bytes(name, text); })
      ->type_name("SIZE");
}

Option add_tie_bits(Command& command, long& bits, const std::string& meaning) {
  return add_count(command, "--tie-bits", bits, kTieBits, meaning);
}

Option add_seconds(Command& command, const std::string& names, double& value,
                   const std::string& meaning) {
  return add_text(
             command, names, meaning,
             [&value](const auto& name, const auto& text) { value = parse_seconds(name, text); })
      ->type_name("SECONDS")
      ->default_str(fmt::format("{}", value));
}

Option add_seconds(Command& command, const std::string& names, std::optional<double>& value,
                   const std::string& meaning) {
  return add_text(
             command, names, meaning,
             [&value](const auto& name, const auto& text) { value = parse_seconds(name, text); })
      ->type_name("SECONDS");
}

Option add_keep_option(Command& command, std::vector<std::string>& texts) {
  return command
      .add_option("--keep", texts,
                  "facets that stay, by id:N,..., plane:NX,NY,NZ,D, normal:X,Y,Z[:DEGREES] or "
                  "group:NAME; with several objects PART/id:N; may be repeated")
      ->expected(1)
      ->allow_extra_args(false)  // an INPUT that need not be there may follow
      ->take_all()
      ->type_name("SELECTOR");
}

Option add_center_option(Command& command, std::string& text) {
  return command
      .add_option(
          "--center", text,
          "center of the polar dual: chebyshev, or X,Y,Z strictly inside; the answer does not "
          "depend on it")
      ->capture_default_str();
}

}  // namespace convexact::cli
