// SPDX-License-Identifier: MIT
#include "io/collada_document.hpp"

#include <algorithm>

#include "number/text.hpp"

namespace convexact {

using pugi::xml_node;

std::string_view text_of(const xml_node& element) { return element.text().get(); }

std::string_view attribute_of(const xml_node& element, const char* name) {
  return element.attribute(name).value();
}

std::string_view Words::next() {
  constexpr std::string_view kBlanks = " \t\r\n";
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
  const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
  rest_.remove_prefix(word.size());
  return word;
}

ColladaDocument::ColladaDocument(std::string_view bytes) : bytes_(bytes) {
  const auto parsed =
      document_.load_buffer(bytes.data(), bytes.size(), pugi::parse_default | pugi::parse_doctype);
  if (!parsed) fail_at(parsed.offset, "XML, " + std::string(parsed.description()));
  for (const xml_node& child : document_.children()) {
    if (child.type() == pugi::node_doctype) {
      fail(child, "no document type, whose entities are not read", ErrorCode::Unreadable);
    }
  }
  struct Collect : pugi::xml_tree_walker {
    std::map<std::pair<std::string_view, std::string_view>, xml_node> found;
    bool for_each(xml_node& node) override {
      const std::string_view id = attribute_of(node, "id");
      if (!id.empty()) found.emplace(std::pair{node.name(), id}, node);
      return true;
    }
  } collect;
  document_.traverse(collect);
  by_id_ = std::move(collect.found);
}

void ColladaDocument::fail(const xml_node& element, const std::string& expected,
                           ErrorCode code) const {
  fail_at(element.offset_debug(), expected, code);
}

xml_node ColladaDocument::referred(const xml_node& from, const char* attribute,
                                   const char* name) const {
  const std::string_view reference = attribute_of(from, attribute);
  if (!reference.starts_with('#')) {
    fail(from, "a reference such as #id in this file, found " + in_quotes(reference),
         reference.empty() ? ErrorCode::Malformed : ErrorCode::Unreadable);
  }
  const auto found = by_id_.find(std::pair{std::string_view(name), reference.substr(1)});
  if (found == by_id_.end()) {
    fail(from, "an element " + std::string(name) + " of the id " + in_quotes(reference.substr(1)));
  }
  return found->second;
}

std::size_t ColladaDocument::count(const xml_node& element, std::string_view word) const {
  std::size_t value = 0;
  for (const char c : word) {
    if (c < '0' || c > '9' || value > 400'000'000) word = {};
    value = 10 * value + static_cast<std::size_t>(c - '0');
    if (word.empty()) break;
  }
  if (word.empty()) fail(element, "an integer from 0 on");
  return value;
}

std::vector<std::size_t> ColladaDocument::counts(const xml_node& element) const {
  std::vector<std::size_t> list;
  Words words(text_of(element));
  for (auto word = words.next(); !word.empty(); word = words.next()) {
    list.push_back(count(element, word));
  }
  return list;
}

std::size_t ColladaDocument::count_or(const xml_node& element, const char* attribute,
                                      std::size_t missing) const {
  const std::string_view value = attribute_of(element, attribute);
  return value.empty() ? missing : count(element, value);
}

Rational ColladaDocument::number(const xml_node& element, std::string_view word,
                                 Decimal decimal) const {
  try {
    if (decimal == Decimal::Exact) return (void)nearest_double(word), parse_rational(word);
    return to_rational(decimal == Decimal::Nearest32 ? double(nearest_float(word))
                                                     : nearest_double(word));
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), line_at(element.offset_debug()));
  }
}

std::vector<Rational> ColladaDocument::numbers(const xml_node& element, std::size_t count,
                                               Decimal decimal) const {
  std::vector<Rational> list;
  Words words(text_of(element));
  for (auto word = words.next(); !word.empty() && list.size() <= count; word = words.next()) {
    list.push_back(number(element, word, decimal));
  }
  if (list.size() != count) fail(element, std::to_string(count) + " numbers");
  return list;
}

std::size_t ColladaDocument::line_at(std::ptrdiff_t offset) const {
  const std::string_view before =
      bytes_.substr(0, static_cast<std::size_t>(std::max(offset, std::ptrdiff_t{0})));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

void ColladaDocument::fail_at(std::ptrdiff_t offset, const std::string& expected,
                              ErrorCode code) const {
  throw Error(code, "expected " + expected, line_at(offset));
}

}  // namespace convexact
