// SPDX-License-Identifier: MIT
// field.hpp - the options of a request, each declared once: the command line, lines of JSON,
// texts of options in C, profiles, their schemas and the manual read the same table.
#pragma once
#include <algorithm>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/names.hpp"
#include "task/parallel.hpp"

namespace convexact {

/// Inclusive.
struct CountRange {
  std::uint64_t least = 0;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
};

/// A whole number as users spell it: decimal digits and nothing else, so `010` is ten.
/// @param option  Its name, for the message.
/// @throws Error InvalidArgument for a sign, a blank, a fraction, an exponent, and a number outside
///               of the range, however long.
[[nodiscard]] std::uint64_t parse_count(const std::string& option, const std::string& text,
                                        const CountRange& range);

/// A decimal that is read by nearest_double(). @throws Error InvalidArgument.
[[nodiscard]] double parse_decimal(const std::string& option, const std::string& text);

/// The words between commas; an empty last one counts, too, so that "1," is no list of numbers.
[[nodiscard]] std::vector<std::string> words_of(const std::string& text);

/// A count as a number that may have fewer bits, as std::size_t on 32-bit machines. Its largest one
/// stands for all beyond it: a machine never holds more.
template <std::integral Number>
[[nodiscard]] Number narrowed(std::uint64_t count) {
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<Number>::max());
  return static_cast<Number>(std::min(count, kMost));
}
template <std::integral Number>
void assign_count(Number& target, std::uint64_t count) {
  target = narrowed<Number>(count);
}
inline void assign_count(double& target, std::uint64_t count) {
  target = static_cast<double>(count);
}
template <class Number>
void assign_count(std::optional<Number>& target, std::uint64_t count) {
  target = narrowed<Number>(count);
}

enum class FieldKind {
  Flag,    ///< "true" or "false"; on the command line it is given or not.
  Count,   ///< A whole number.
  Choice,  ///< One of a few words.
  Text,    ///< Anything else: a distance, a share.
};

/// What is said about an option, whatever request it belongs to.
struct FieldInfo {
  std::string name;  ///< "max_parts": on the command line --max-parts.
  FieldKind kind;
  std::string meaning;             ///< For people: begins small, ends without a full stop.
  CountRange range = {};           ///< Of a count.
  std::vector<std::string> words;  ///< Of a choice, in the order of the alphabet.
  char letter = 0;                 ///< -k, if the command line has a short name.
};

/// An option of a `Request`, as a member of it.
template <class Request>
struct Field : FieldInfo {
  /// Takes a value as users spell it. @throws Error InvalidArgument, naming `option`.
  std::function<void(Request& request, const std::string& option, const std::string& text)> read;
  /// The value, so spelled; empty if there is none.
  std::function<std::string(const Request& request)> write;
};
template <class Request>
using Fields = std::vector<Field<Request>>;

/// An option of a request at hand, which must outlive it, like the table.
struct BoundField {
  const FieldInfo* info;
  std::function<void(const std::string& option, const std::string& text)> read;
  std::string present;  ///< The value when it was bound: the default.
};
using BoundFields = std::vector<BoundField>;

/// Whether a table is asked for a field: for those of some names, or for all.
[[nodiscard]] inline bool is_wanted(const FieldInfo& field,
                                    const std::vector<std::string_view>& names) {
  return names.empty() || std::find(names.begin(), names.end(), field.name) != names.end();
}

/// All options of a table, or those of some names, in the order of the table.
template <class Request>
[[nodiscard]] BoundFields bound_fields(const Fields<Request>& fields, Request& request,
                                       const std::vector<std::string_view>& names = {}) {
  BoundFields bound;
  for (const Field<Request>& field : fields) {
    if (!is_wanted(field, names)) continue;
    bound.push_back({&field,
                     [&](const std::string& option, const std::string& text) {
                       field.read(request, option, text);
                     },
                     field.write(request)});
  }
  return bound;
}

/// Gives each field that a text of options names its value, spelled as on the command line:
/// "method=cut max_parts=8 disjoint". A flag is its name alone, or true or false; blanks are
/// between options.
/// @param text  May be null: no option.
/// @throws Error InvalidArgument, naming the option, for one that is not among the fields, which it
///               lists, for one that is given twice, and as Field::read.
void read_options(const char* text, const BoundFields& fields);

/// The option of a name. @throws Error InvalidArgument with all names if there is none.
[[nodiscard]] const BoundField& field_of(const std::string& name, const BoundFields& fields);

/// Options as they were given, for a request that is yet to be made.
class GivenFields {
 public:
  /// Options that are checked and kept when they are read.
  /// @param defaults  Has the values of those that are not given; null if that is open.
  template <class Request>
  [[nodiscard]] BoundFields bound(const Fields<Request>& fields,
                                  const std::vector<std::string_view>& names = {},
                                  const Request* defaults = nullptr) {
    BoundFields bound;
    for (const Field<Request>& field : fields) {
      if (!is_wanted(field, names)) continue;
      const auto keep = [this, &field](const std::string& option, const std::string& text) {
        Request unused;
        field.read(unused, option, text);
        given_.emplace_back(&field, text);
      };
      bound.push_back({&field, keep, defaults == nullptr ? "" : field.write(*defaults)});
    }
    return bound;
  }
  /// @param fields  The table that was bound, or one with the same names.
  template <class Request>
  void apply_to(Request& request, const Fields<Request>& fields) const {
    for (const auto& [info, text] : given_) {
      for (const Field<Request>& field : fields) {
        if (field.name == info->name) field.read(request, field.name, text);
      }
    }
  }
  bool has(std::string_view name) const {
    return std::any_of(given_.begin(), given_.end(),
                       [&](const auto& given) { return given.first->name == name; });
  }
  const std::vector<std::pair<const FieldInfo*, std::string>>& all() const { return given_; }

 private:
  std::vector<std::pair<const FieldInfo*, std::string>> given_;
};

/// "--max-parts".
[[nodiscard]] std::string option_of(const FieldInfo& field);

template <class Request>
Field<Request> flag_field(std::string name, bool Request::*member, std::string meaning) {
  return {{std::move(name), FieldKind::Flag, std::move(meaning), {}, {}, 0},
          [member](Request& request, const std::string&, const std::string& text) {
            request.*member = text == "true";
          },
          [member](const Request& request) { return request.*member ? "true" : ""; }};
}

/// @param member  A number that holds the range, or an optional one.
template <class Request, class Member>
Field<Request> count_field(std::string name, Member member, CountRange range, std::string meaning) {
  return {{std::move(name), FieldKind::Count, std::move(meaning), range, {}, 0},
          [member, range](Request& request, const std::string& option, const std::string& text) {
            assign_count(request.*member, parse_count(option, text, range));
          },
          [member](const Request& request) -> std::string {
            const auto& value = request.*member;
            if constexpr (requires { value.has_value(); }) {
              return value ? std::to_string(*value) : "";
            } else {
              return std::to_string(value);
            }
          }};
}

/// Threads of a request that uses all cores where it does not say.
template <class Request>
Field<Request> jobs_field(std::string meaning) {
  return count_field<Request>("jobs", &Request::jobs, {1, kMostThreads}, std::move(meaning));
}

/// @throws Error InvalidArgument, listing the words.
[[noreturn]] void reject_word(const std::string& option, const std::vector<std::string>& words,
                              const std::string& found);

/// @param member  A `Value`, or an optional one.
template <class Request, class Member, class Value, std::size_t N>
Field<Request> choice_field(std::string name, Member member, const NameTable<Value, N>& table,
                            std::string meaning) {
  std::vector<std::string> words;
  for (const auto& entry : table) words.emplace_back(entry.second);
  std::sort(words.begin(), words.end());
  return {
      {std::move(name), FieldKind::Choice, std::move(meaning), {}, words, 0},
      [member, table, words](Request& request, const std::string& option, const std::string& text) {
        const std::optional<Value> value = value_in(table, text);
        if (!value) reject_word(option, words, text);
        request.*member = *value;
      },
      [member, table](const Request& request) -> std::string {
        const auto& value = request.*member;
        if constexpr (requires { value.has_value(); }) {
          return value ? name_in(table, *value) : "";
        } else {
          return name_in(table, value);
        }
      }};
}

/// @param parse   Gives the value of a text: (option, text).
/// @param spell   Its inverse, or how the default is shown.
template <class Request, class Member, class Parse, class Spell>
Field<Request> text_field(std::string name, Member member, Parse parse, Spell spell,
                          std::string meaning) {
  return {{std::move(name), FieldKind::Text, std::move(meaning), {}, {}, 0},
          [member, parse](Request& request, const std::string& option, const std::string& text) {
            request.*member = parse(option, text);
          },
          [member, spell](const Request& request) { return spell(request.*member); }};
}

}  // namespace convexact
