// SPDX-License-Identifier: MIT
// json_document.hpp - the documents that the program writes: values in the order of writing, and
// their text.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/number.hpp"

namespace convexact {

class Halfspace;

/// A value to be written as JSON; an object keeps the order of its keys. Constructed from braces as
/// nlohmann::ordered_json is: a list of pairs whose first halves are strings is an object, any
/// other list an array. Documents that are *read* are nlohmann::json, see json_text.hpp; this type
/// has templates for sequences only, so that sources which describe results compile quickly.
class Json {
 public:
  Json();  ///< null
  Json(std::nullptr_t);
  Json(bool value);
  Json(int value);
  Json(long value);
  Json(long long value);
  Json(unsigned value);
  Json(unsigned long value);
  Json(unsigned long long value);
  Json(double value);  ///< Written as null unless finite.
  Json(const char* text);
  Json(std::string text);
  Json(std::string_view text);
  Json(const void*) = delete;  // not a truth value
  /// Exact numbers are strings, "p/q" or an integer; a plane is its four integers; ids are numbers.
  Json(const Rational& value);
  Json(const Halfspace& plane);
  template <class Tag>
  Json(Id<Tag> id) : Json(id.index()) {}
  /// @param items  Taken out of the list: it has no values afterwards.
  Json(std::initializer_list<Json> items);
  template <class T>
  Json(std::span<T> items) : Json(array()) {
    for (const auto& item : items) push_back(item);
  }
  template <class T, std::size_t n>
  Json(const std::array<T, n>& items) : Json(std::span<const T>(items)) {}
  template <class T>
  Json(const std::vector<T>& items) : Json(std::span<const T>(items)) {}
  template <class First, class Second>
  Json(const std::pair<First, Second>& pair) : Json({Json(pair.first), Json(pair.second)}) {}

  Json(const Json& other);
  Json(Json&& other) noexcept;
  Json& operator=(const Json& other);
  Json& operator=(Json&& other) noexcept;
  ~Json();

  static Json array();
  static Json array(std::initializer_list<Json> items);
  static Json object();

  // ---- Lists: a null becomes an empty one.
  void push_back(Json item);
  Json& emplace_back(Json item = {});
  Json& back();
  const Json& back() const;
  const Json& operator[](std::size_t place) const;
  Json& operator[](std::size_t place);
  const Json* begin() const;
  const Json* end() const;

  // ---- Objects: a null becomes an empty one.
  Json& operator[](std::string_view key);              ///< Appended as null if it is new.
  const Json& operator[](std::string_view key) const;  ///< `key` is present.
  const Json& at(std::string_view key) const { return (*this)[key]; }
  const Json* find(std::string_view key) const;  ///< nullptr if absent, or if this is no object.
  bool contains(std::string_view key) const { return find(key) != nullptr; }
  void update(Json object);  ///< Appends its members, or overwrites those that are present.
  void erase(std::string_view key);

  std::size_t size() const;  ///< How many items or members; 0 of null, 1 of anything else.
  bool empty() const { return size() == 0; }
  bool is_null() const;
  bool is_string() const;
  bool is_array() const;
  bool is_object() const;
  bool is_double() const;           ///< Given as a double, even if it is integral.
  const std::string& text() const;  ///< Of a string.
  double number() const;            ///< Of a number, to the nearest.
  std::size_t count() const;        ///< Of an integer >= 0.

  /// The same members in the same order, and numbers of the same value.
  friend bool operator==(const Json& a, const Json& b);

 private:
  friend class JsonWriter;
  using Items = std::vector<Json>;
  using Members = std::vector<std::pair<std::string, Json>>;

  bool is_structured() const { return is_array() || is_object(); }
  Items& items();
  const Items& items() const;
  Members& members();
  const Members& members() const;
  void take_branches(Items& into);

  // Mutable since the items of an initializer list are constants, out of which a document is built.
  mutable std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double,
                       std::unique_ptr<std::string>, std::unique_ptr<Items>,
                       std::unique_ptr<Members>>
      value_;
};

/// The text of a document, without a newline at its end. File names, option values and names of
/// objects are bytes: any part of them that is not UTF-8 becomes U+FFFD, since JSON allows nothing
/// else. A double has the fewest digits that tell it from all others.
/// @param indent  Spaces for each level; -1 for all on one line.
[[nodiscard]] std::string write_json(const Json& document, int indent = -1);

/// The same of an object with an entry of each top-level list, and every other value, on a line of
/// its own, and a newline at the end.
[[nodiscard]] std::string write_lines(const Json& document);

/// `text` as write_json() would spell it, for pages and tables.
[[nodiscard]] std::string as_utf8(std::string_view text);

}  // namespace convexact
