// SPDX-License-Identifier: MIT
// json_text.hpp - the only parser of JSON text, with a limit to its depth; points, planes
// and polygons in its rows.
#pragma once
#include <functional>
#include <initializer_list>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "convexact/geometry.hpp"

// Exact numbers, ids and planes as Json spells them.
template <>
struct nlohmann::adl_serializer<convexact::Rational> {
  static convexact::Rational from_json(const nlohmann::json& json);
};

template <class Tag>
struct nlohmann::adl_serializer<convexact::Id<Tag>> {
  static convexact::Id<Tag> from_json(const nlohmann::json& json) {
    return convexact::Id<Tag>(json.get<std::size_t>());
  }
};

template <>
struct nlohmann::adl_serializer<convexact::Halfspace> {
  static convexact::Halfspace from_json(const nlohmann::json& json);
};

namespace convexact {

/// How deep lists and objects of a JSON text may lie within each other. Our formats need 6; the
/// JSON library needs stack for each level to copy, compare and print documents.
inline constexpr std::size_t kMaxJsonDepth = 64;

/// Walks over bytes and counts the lines begun.
struct LineCounter {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* position;
  std::size_t* line;

  reference operator*() const { return *position; }
  LineCounter& operator++() {
    if (*position == '\n') ++*line;
    ++position;
    return *this;
  }
  bool operator==(const LineCounter& other) const { return position == other.position; }
};

/// The common part of all receivers of the parser's events: the line, the depth, and the errors.
class JsonEvents {
 public:
  /// @throws Error Malformed with the line; NotFinite for a number beyond the largest double.
  bool parse_error(std::size_t byte, const std::string& token,
                   const nlohmann::json::exception& why);

 protected:
  /// @throws Error Malformed with the line, beyond kMaxJsonDepth.
  void open();
  void close() { --depth_; }

  std::size_t line_ = 1;
  std::size_t depth_ = 0;  // open objects and arrays

 private:
  template <typename Events>
  friend void parse_json_events(std::string_view bytes, Events& events);
};

/// Parses a JSON text into the events of nlohmann's SAX interface; Events derives from JsonEvents.
/// @throws Error as JsonEvents, and what the events throw.
template <typename Events>
void parse_json_events(std::string_view bytes, Events& events) {
  const char* first = bytes.data();
  (void)nlohmann::json::sax_parse(LineCounter{first, &events.line_},
                                  LineCounter{first + bytes.size(), &events.line_}, &events);
}

/// Builds the document of a JSON text. If the parser throws, `document` holds the part before the
/// error. An object with the same key twice is malformed: its meaning would depend on the reader.
class JsonDocument : public JsonEvents {
 public:
  /// @param spelled  Keys below which a number is kept as its text, see spelling_of().
  explicit JsonDocument(std::initializer_list<std::string_view> spelled = {}) : spelled_(spelled) {}

  nlohmann::json document;

  bool null() { return take(nullptr); }
  bool boolean(bool value) { return take(value); }
  bool string(std::string& value) { return take(std::move(value)); }
  bool binary(std::vector<std::uint8_t>&) { return false; }  // not in text
  bool number_integer(std::int64_t value);
  bool number_unsigned(std::uint64_t value);
  bool number_float(double value, const std::string& spelling);
  bool start_object(std::size_t) { return open_with(nlohmann::json::object()); }
  bool start_array(std::size_t) { return open_with(nlohmann::json::array()); }
  bool end_object() { return close_last(); }
  bool end_array() { return close_last(); }
  bool key(std::string& name);

 private:
  nlohmann::json& put(nlohmann::json value);
  bool take(nlohmann::json value) { return put(std::move(value)), true; }
  bool take_spelled(std::string_view text);
  bool open_with(nlohmann::json container);
  bool close_last();

  std::vector<std::string_view> spelled_;
  std::size_t spelled_depth_ = 0;  // of the enclosing object with a spelled key; 0: none
  std::vector<nlohmann::json*> open_;
  std::string key_;  // of the next value, if the last container is an object
};

/// The same for documents, compiled once.
void parse_json_events(std::string_view bytes, JsonDocument& events);

/// The document of a JSON text. @throws Error as JsonDocument.
[[nodiscard]] nlohmann::json parse_json(std::string_view bytes);

/// The text of a value that was read, on one line, for errors that quote it.
[[nodiscard]] std::string dump_json(const nlohmann::json& value);

/// The text of a number below a spelled key of JsonDocument, or of a string; empty for any other
/// value (and for the empty string).
[[nodiscard]] std::string_view spelling_of(const nlohmann::json& value);

/// The meaning of a number in a row: each format has different rules.
using JsonNumber = std::function<Rational(const nlohmann::json&)>;

/// Points from rows of three numbers. @param what  The name of a row in errors: "point".
/// @throws Error Malformed for other rows; as `number`.
[[nodiscard]] PointSet points_of_json(const nlohmann::json& rows, const char* what,
                                      const JsonNumber& number);
/// Halfspaces from rows of four numbers. @throws Error as points_of_json().
[[nodiscard]] HalfspaceList halfspaces_of_json(const nlohmann::json& rows,
                                               const JsonNumber& number);
/// Polygons from rows of three or more indices below `points`.
/// @throws Error Malformed for other rows.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> polygons_of_json(const nlohmann::json& rows,
                                                                       std::size_t points);

}  // namespace convexact
