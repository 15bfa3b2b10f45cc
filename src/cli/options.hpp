// SPDX-License-Identifier: MIT
// options.hpp - options of the command line: words, lists, numbers, sizes and seconds, read
// strictly.
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/parser.hpp"
#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/number.hpp"
#include "io/names.hpp"
#include "number/text.hpp"
#include "wire/field.hpp"

namespace convexact::cli {

/// Seconds: a decimal, more than 0 and at most a million. @throws Error InvalidArgument.
[[nodiscard]] double parse_seconds(const std::string& option, const std::string& text);

/// Without blanks and ends of lines around it.
[[nodiscard]] std::string trimmed(const std::string& text);

/// "; did you mean 'icosahedron'?" with the word nearest to a mistyped one, the first of several;
/// empty if none is near: a third of its letters may be left out, added, changed or swapped with
/// their neighbour.
[[nodiscard]] std::string did_you_mean(const std::string& word,
                                       const std::vector<std::string>& known);

/// The values of words such as "exact,float"; a comma may follow the last one.
/// @param others  Other values that the option takes, for the message.
/// @throws Error InvalidArgument, listing the words, for any other word, even an empty one.
template <class Value, std::size_t N>
[[nodiscard]] std::vector<Value> parse_words(const std::string& option, const std::string& text,
                                             const NameTable<Value, N>& table,
                                             const std::string& others = {}) {
  std::vector<Value> values;
  for (const std::string& word : split(text, ',')) {
    const std::optional<Value> value = value_in(table, word);
    if (!value) {
      std::string names;
      for (const auto& [each, name] : table)
        names += (names.empty() ? "" : ",") + std::string(name);
      throw Error(ErrorCode::InvalidArgument, option + ": expected names out of " + names + others +
                                                  ", found " + in_quotes(word));
    }
    values.push_back(*value);
  }
  return values;
}

/// An option of a request, as its table says; an Error of its reader is wrong usage. The help shows
/// the value that the request has now.
/// @param note  Follows the meaning in the help.
Option add_field(Command& command, const BoundField& field, const std::string& note = {});
inline void add_fields(Command& command, const BoundFields& fields) {
  for (const BoundField& field : fields) add_field(command, field);
}

/// An option whose text goes to `take`, with the option's name. An Error of `take` is wrong usage.
Option add_text(
    Command& command, const std::string& names, const std::string& meaning,
    const std::function<void(const std::string& option, const std::string& text)>& take);

/// An option that takes a count. The help shows the range unless its end is arbitrary, and the
/// default unless there is none or it lies outside of the range, like a 0 that stands for "not
/// given".
Option add_count(Command& command, const std::string& names, const CountRange& range,
                 const std::string& meaning, std::optional<std::uint64_t> usual,
                 const std::function<void(std::uint64_t)>& take);

template <class Number>
Option add_count(Command& command, const std::string& names, Number& value, const CountRange& range,
                 const std::string& meaning) {
  return add_count(command, names, range, meaning, static_cast<std::uint64_t>(value),
                   [&value](std::uint64_t count) { assign_count(value, count); });
}

inline Option add_count(Command& command, const std::string& names,
                        std::optional<std::size_t>& value, const CountRange& range,
                        const std::string& meaning) {
  return add_count(command, names, range, meaning, std::nullopt,
                   [&value](std::uint64_t count) { assign_count(value, count); });
}

/// The number of halfspaces to keep: 4 to 2^32.
template <class Number>
Option add_faces(Command& command, Number& value, const std::string& meaning) {
  return add_count(command, "-k,--faces", value, {4, std::uint64_t(1) << 32}, meaning);
}

/// --jobs, threads of a command; none given means all cores.
inline Option add_jobs_option(Command& command, std::optional<std::size_t>& jobs) {
  return add_count(command, "--jobs", jobs, {1, 256},
                   "threads, by default as many as there are cores; no result depends on them");
}

/// An option that takes a size in bytes; 0 for no limit. A size is digits, with a fraction if
/// wanted, then nothing, B, KB, MB, GB or TB (powers of 1024; KiB or K mean the same), in either
/// case. A fraction of a byte is dropped; anything else, and 2^64 and more, is wrong usage.
Option add_bytes(Command& command, const std::string& names, std::uint64_t& value,
                 const std::string& meaning);

/// An option that takes seconds; the default is shown.
Option add_seconds(Command& command, const std::string& names, double& value,
                   const std::string& meaning);

/// The same without a default.
Option add_seconds(Command& command, const std::string& names, std::optional<double>& value,
                   const std::string& meaning);

/// --tie-bits, the precision up to which mean widths are compared; the default is shown.
Option add_tie_bits(Command& command, long& bits, const std::string& meaning);

/// --keep: facets that a run must not remove (keep_selectors()); it may be repeated.
Option add_keep_option(Command& command, std::vector<std::string>& texts);

/// --center, of the polar dual; the default is shown.
Option add_center_option(Command& command, std::string& text);

/// An option that takes one of a few words, in upper or lower case; the help shows them and the
/// default, if there is one. @param value  A `Value`, or an optional one.
template <class Value, class Target>
Option add_choice(Command& command, const std::string& name, Target& value,
                  const std::map<std::string, Value>& words, const std::string& meaning) {
  std::string list, marked;
  for (const auto& [word, meant] : words) {
    list += (list.empty() ? "" : ", ") + word;
    marked += (marked.empty() ? "" : "|") + word + (value == meant ? "*" : "");
  }
  const std::string note = marked.find('*') == marked.npos ? "" : " (* is the default)";
  return add_text(command, name, meaning + note,
                  [&value, words, list](const auto& option, const auto& text) {
                    const auto found = words.find(to_lower(text));
                    if (found == words.end()) {
                      throw Error(ErrorCode::InvalidArgument, option + ": expected one of " + list +
                                                                  ", found " + in_quotes(text));
                    }
                    value = found->second;
                  })
      ->type_name(marked);
}

template <class Value, std::size_t N, class Target>
Option add_choice(Command& command, const std::string& name, Target& value,
                  const NameTable<Value, N>& table, const std::string& meaning) {
  std::map<std::string, Value> words;
  for (const auto& [meant, word] : table) words.emplace(word, meant);
  return add_choice<Value>(command, name, value, words, meaning);
}

}  // namespace convexact::cli
