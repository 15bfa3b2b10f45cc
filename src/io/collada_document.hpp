// SPDX-License-Identifier: MIT
// collada_document.hpp - the elements of a COLLADA file, by id and with the lines on which they
// begin; numbers in their texts.
#pragma once
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// The text in an element, without blanks around it taken away.
[[nodiscard]] std::string_view text_of(const pugi::xml_node& element);
/// Empty if the element lacks it.
[[nodiscard]] std::string_view attribute_of(const pugi::xml_node& element, const char* name);

/// Words between white space.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}
  /// Empty at the end.
  std::string_view next();

 private:
  std::string_view rest_;
};

class ColladaDocument {
 public:
  /// @throws Error Malformed for XML that does not parse; Unreadable for a document type.
  explicit ColladaDocument(std::string_view bytes);

  /// The element COLLADA; null if there is none.
  pugi::xml_node root() const { return document_.child("COLLADA"); }

  /// @throws Error always: "expected `expected`", with the line of the element.
  [[noreturn]] void fail(const pugi::xml_node& element, const std::string& expected,
                         ErrorCode code = ErrorCode::Malformed) const;

  /// The element of this name that an attribute such as source="#id" refers to.
  /// @throws Error Malformed if there is none; Unreadable for a reference to another file.
  pugi::xml_node referred(const pugi::xml_node& from, const char* attribute,
                          const char* name) const;

  /// The integers >= 0 in the text of an element. @throws Error Malformed for anything else.
  std::vector<std::size_t> counts(const pugi::xml_node& element) const;
  /// Of an attribute that may be missing.
  std::size_t count_or(const pugi::xml_node& element, const char* attribute,
                       std::size_t missing) const;
  /// A decimal in an element, as its nearest number or as spelled.
  /// @throws Error as nearest_double, with the line.
  Rational number(const pugi::xml_node& element, std::string_view word, Decimal decimal) const;
  /// All of them. @throws Error Malformed unless there are so many.
  std::vector<Rational> numbers(const pugi::xml_node& element, std::size_t count,
                                Decimal decimal) const;

 private:
  std::size_t count(const pugi::xml_node& element, std::string_view word) const;
  std::size_t line_at(std::ptrdiff_t offset) const;
  [[noreturn]] void fail_at(std::ptrdiff_t offset, const std::string& expected,
                            ErrorCode code = ErrorCode::Malformed) const;

  std::string_view bytes_;
  pugi::xml_document document_;
  std::map<std::pair<std::string_view, std::string_view>, pugi::xml_node> by_id_;
};

}  // namespace convexact
