// SPDX-License-Identifier: MIT
// names.hpp - enumerations by name: one table for each, for JSON, tables and the command line.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "convexact/error.hpp"

namespace convexact {

template <class E, std::size_t N>
using NameTable = std::array<std::pair<E, const char*>, N>;

/// constexpr auto kColorNames = name_table<Color>({{Color::Red, "red"}, {Color::Blue, "blue"}});
template <class E, std::size_t N>
constexpr NameTable<E, N> name_table(const std::pair<E, const char*> (&table)[N]) {
  return std::to_array(table);
}

/// @throws Error Internal if the table has no such value.
template <class E, std::size_t N>
constexpr const char* name_in(const NameTable<E, N>& table, E value) {
  for (const auto& [known, name] : table) {
    if (known == value) return name;
  }
  throw Error(ErrorCode::Internal, "a value without a name");
}

/// The value of that name, if there is one.
template <class E, std::size_t N>
constexpr std::optional<E> value_in(const NameTable<E, N>& table, std::string_view name) {
  for (const auto& [value, known] : table) {
    if (known == name) return value;
  }
  return std::nullopt;
}

}  // namespace convexact
