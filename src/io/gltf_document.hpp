// SPDX-License-Identifier: MIT
// gltf_document.hpp - the containers of glTF 2.0: a .gltf or a .glb, its buffers, and the lists of
// numbers in them. Every offset is compared with the bytes that are there.
//
// "Section" means the glTF 2.0 Specification of the Khronos Group, 2.0.1.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "convexact/error.hpp"
#include "io/json_text.hpp"

namespace convexact {

/// "nodes[3]".
[[nodiscard]] std::string gltf_place(const std::string& list, std::size_t index);

/// @throws Error always: "`where`: expected `expected`".
[[noreturn]] void gltf_fail(const std::string& where, const std::string& expected,
                            ErrorCode code = ErrorCode::Malformed);

/// A number of a glTF: a spelled decimal, or an integer.
/// @param where  For messages: "nodes[3].scale".
/// @throws Error Malformed for anything but an integer >= 0 below `limit`.
[[nodiscard]] std::uint64_t gltf_unsigned(const nlohmann::json& value, std::uint64_t limit,
                                          const std::string& where);

/// A list of vectors of 1 to 3 components. (Section 3.6.2.)
class GltfAccessor {
 public:
  /// The component as it is stored: an integer, or a binary32 number.
  double stored(std::size_t element, std::size_t component) const;
  /// What a stored integer is divided by: 1 unless the accessor is normalized. (Section 3.11.)
  long divisor() const;

  std::size_t count = 0;
  std::size_t components = 1;
  unsigned type = 0;  ///< 5120 and so on: of a component.
  bool is_normalized = false;
  std::string where;

 private:
  friend class GltfDocument;
  std::size_t component_size() const;

  std::string_view bytes_;  // from the first element on; empty: all are zero
  std::size_t stride_ = 0;
  std::map<std::size_t, std::string_view> replaced_;  // of a sparse accessor, by element
};

class GltfDocument {
 public:
  /// @param folder  Where the files of buffers lie; empty: they are refused.
  /// @throws Error Malformed, naming what was expected where; Unreadable for glTF 1.0, and for
  ///               extensions that a reader must know and this one does not.
  GltfDocument(std::string_view bytes, std::string folder);

  const nlohmann::json& root() const { return root_; }
  /// The items of a list at the top; none if it is missing.
  const nlohmann::json& list(const char* name) const;
  /// The index of an item, and the item.
  std::size_t index(const nlohmann::json& value, const char* list, const std::string& where) const;

  /// @throws Error as the constructor; Unreadable, too, for a file that cannot be read or lies
  ///               outside of the folder, and for compressed buffers.
  GltfAccessor accessor(std::size_t index);

  /// Bytes behind the end that the header of a .glb gives.
  std::size_t trailing() const { return trailing_; }

 private:
  void read_container(std::string_view bytes);
  void require_known_extensions() const;
  std::string_view buffer(std::size_t index);
  std::string_view view(const nlohmann::json& index, const std::string& where,
                        std::uint64_t* stride);
  void read_sparse(const nlohmann::json& sparse, GltfAccessor& accessor);

  std::string folder_;
  nlohmann::json root_;
  std::optional<std::string_view> binary_chunk_;
  std::size_t trailing_ = 0;
  std::size_t total_bytes_ = 0;  // of the file and its buffers
  std::map<std::size_t, std::string> loaded_;
};

}  // namespace convexact
