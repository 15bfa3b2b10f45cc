// SPDX-License-Identifier: MIT
// ply_header.hpp - what the header of a PLY file declares.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "io/binary_cursor.hpp"
#include "io/text_cursor.hpp"

namespace convexact {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

constexpr bool is_integer(PlyType type) { return type < PlyType::Float32; }
/// Size in bytes in the binary forms.
constexpr std::size_t size_of(PlyType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<int>(type)];
}

struct PlyProperty {
  std::string_view name;
  PlyType type;                       ///< Of the value, or of each entry of the list.
  std::optional<PlyType> count_type;  ///< Set for a list; an integer type.
};

struct PlyElement {
  std::string_view name;
  std::uint32_t count;
  std::vector<PlyProperty> properties;
};

/// Views point into the text.
struct PlyHeader {
  std::optional<ByteOrder> binary;  ///< Unset: the body is text.
  std::vector<PlyElement> elements;
  std::size_t body;  ///< Offset of the first byte after the header.

  const PlyElement* find(std::string_view element) const;
};

/// Leaves `cursor` on the line of end_header.
/// @throws Error Malformed
PlyHeader read_ply_header(std::string_view bytes, TextCursor& cursor);

}  // namespace convexact
