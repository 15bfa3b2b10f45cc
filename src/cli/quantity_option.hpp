// SPDX-License-Identifier: MIT
// quantity_option.hpp - counts, sizes in bytes and seconds as options: read strictly, none wraps.
#pragma once
#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace convexact::cli {

/// Inclusive.
struct CountRange {
  std::uint64_t least = 0;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
};

/// ", 1 to 256", or nothing if the range goes on to 2^32 or beyond.
[[nodiscard]] std::string in_words(const CountRange& range);

/// A whole number as the command line spells it: decimal digits and nothing else, so `010` is ten.
/// @param option  Its name, for the message.
/// @throws Error InvalidArgument for a sign, a blank, a fraction, an exponent, and a number outside
///               of the range, however long.
[[nodiscard]] std::uint64_t parse_count(const std::string& option, const std::string& text,
                                        const CountRange& range);

/// A size in bytes: digits, with a fraction if wanted, then nothing, B, KB, MB, GB or TB (powers of
/// 1024; KiB or K mean the same), in either case. A fraction of a byte is dropped.
/// @throws Error InvalidArgument for anything else, and from 2^64 on.
[[nodiscard]] std::uint64_t parse_bytes(const std::string& option, const std::string& text);

/// Seconds: a decimal, more than 0 and at most a million. @throws Error InvalidArgument.
[[nodiscard]] double parse_seconds(const std::string& option, const std::string& text);

/// A decimal as nearest_double() reads it. @throws Error InvalidArgument.
[[nodiscard]] double parse_decimal(const std::string& option, const std::string& text);

/// An option whose text goes to `take`, with the option's name. An Error of `take` is wrong usage.
CLI::Option* add_text(
    CLI::App& command, const std::string& names, const std::string& meaning,
    const std::function<void(const std::string& option, const std::string& text)>& take);

/// An option that takes a count. The help shows the range unless its end is arbitrary, and the
/// default unless it lies outside of the range, like a 0 that stands for "not given". `Number`
/// holds every number of the range.
template <class Number>
CLI::Option* add_count(CLI::App& command, const std::string& names, Number& value,
                       const CountRange& range, const std::string& meaning) {
  CLI::Option* option = add_text(command, names, meaning + in_words(range),
                                 [&value, range](const auto& name, const auto& text) {
                                   value = static_cast<Number>(parse_count(name, text, range));
                                 });
  const auto usual = static_cast<std::uint64_t>(value);
  if (usual >= range.least && usual <= range.most) option->default_str(std::to_string(usual));
  return option->type_name("COUNT");
}
CLI::Option* add_count(CLI::App& command, const std::string& names,
                       std::optional<std::size_t>& value, const CountRange& range,
                       const std::string& meaning);

/// How many halfspaces to keep: 4 to 2^32.
template <class Number>
CLI::Option* add_faces(CLI::App& command, Number& value, const std::string& meaning) {
  return add_count(command, "-k,--faces", value, {4, std::uint64_t(1) << 32}, meaning);
}

/// An option that takes a size in bytes; 0 for no limit.
CLI::Option* add_bytes(CLI::App& command, const std::string& names, std::uint64_t& value,
                       const std::string& meaning);

/// An option that takes seconds; the default is shown.
CLI::Option* add_seconds(CLI::App& command, const std::string& names, double& value,
                         const std::string& meaning);

}  // namespace convexact::cli
