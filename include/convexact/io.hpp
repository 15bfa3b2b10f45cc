// SPDX-License-Identifier: MIT
// io.hpp - meshes and halfspaces from files and to files.
//
// Readers name the line (in binary files the byte) that they cannot read, round numbers only as
// asked, and allocate no more than the size of the input allows. Writers spell numbers so that
// reading them gives the same numbers again. AtomicOutput puts several files into place together,
// or none.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/number.hpp"

namespace convexact {

// ---- The contents of a mesh file, and the formats.

/// A named part of a file: the polygons [first, last) under one `o` or `g` line of an OBJ, of one
/// `solid` of an STL, or of one mesh that a glTF or COLLADA file places. Other formats have a
/// single part with an empty name. A part is the points of its polygons and its loose points.
struct MeshPart {
  std::string name;
  std::size_t first_polygon;
  std::size_t last_polygon;
  /// Of an OBJ with `o` or `g`: the points under that line which no polygon of the file uses,
  /// ascending. A part may have nothing else.
  std::vector<std::uint32_t> loose = {};
};

/// Points and polygons as the file gives them; polygons index points from 0.
struct Mesh {
  PointSet points;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<MeshPart> parts;
  /// What the reader left out, or read otherwise than the format says, for people: "2 faces of
  /// fewer than 3 corners were skipped; their points count".
  std::vector<std::string> notes = {};
};

/// Which points of a mesh count.
enum class MeshPoints {
  All,
  Used,  ///< Those that some polygon has as a corner. Without polygons, a mesh is its points.
};

/// For each of so many points, whether some polygon has it as a corner.
[[nodiscard]] std::vector<bool> used_points(std::size_t count,
                                            std::span<const std::vector<std::uint32_t>> polygons);

/// Leaves out the points that no polygon uses, and numbers the others anew, in their order. A mesh
/// without polygons stays as it is.
void drop_unused_points(Mesh& mesh);

enum class MeshFormat {
  Obj,
  Off,
  Ply,
  Stl,
  Xyz,      ///< Points only: x y z per line, with blanks, commas or semicolons between; .pts, .csv.
  Pcd,      ///< Points only, of the Point Cloud Library; as text or binary.
  Ext,      ///< The V-representation of cdd and lrs: points.
  Gltf,     ///< glTF 2.0: .glb, which is also written, and .gltf. Each node with a mesh is a part.
  Collada,  ///< .dae; each instance of a geometry is a part.
};

/// Of the formats that are written, too: by the extension .obj, .off, .ply, .stl, .xyz or .glb in
/// any case; nothing for any other path.
[[nodiscard]] std::optional<MeshFormat> mesh_format_of_path(const std::string& path);

/// Whether files of the format, as the program writes them, hold binary32 numbers only.
[[nodiscard]] constexpr bool holds_binary32_only(MeshFormat format) {
  return format == MeshFormat::Stl || format == MeshFormat::Gltf;
}

/// By the first bytes, and for a binary STL by its size; OBJ if no other format matches.
[[nodiscard]] MeshFormat mesh_format_of_content(std::string_view bytes);

/// All bytes of the file at `path`; "-" is standard input.
/// @throws Error Unreadable if it does not exist, is a directory or cannot be read.
[[nodiscard]] std::string read_bytes(const std::string& path);

/// The name of the file in errors: the path, or "standard input" for "-".
[[nodiscard]] std::string display_name(const std::string& path);

struct ReadOptions {
  /// The meaning of decimals in text formats; Nearest32 rounds the numbers of binary formats too.
  Decimal decimal = Decimal::Nearest;
  /// Unset: by the path's extension if it is a known one, otherwise by content.
  std::optional<MeshFormat> format = {};
  /// Leave out numbers that are not finite: points of clouds, and corners of STL facets, whose
  /// other corners stay as points. A note counts them. Otherwise they are an error.
  bool skip_bad = false;
  /// Faces of one or two corners are an error, as in outputs that are judged. Otherwise a note
  /// counts them; their points count in any case.
  bool strict = false;
  /// Check polygons as ever, but leave them and the parts out: for a caller that needs the points
  /// alone. Most of the memory of a large mesh is its polygons.
  bool points_only = false;
  /// Where the files lie that a glTF or COLLADA names; empty: naming one is an error. read_mesh()
  /// takes the folder of the file.
  std::string folder = {};
};

/// The mesh that the bytes of a file spell.
/// @throws Error Malformed, naming line (binary: byte offset) and what was expected; NotFinite for
///         NaN, infinity and numbers beyond the largest double or, if asked, binary32 number.
/// @par Cost  Linear. A declared count is compared with the size of the input before anything is
///            allocated for it, so memory is linear in the bytes too.
[[nodiscard]] Mesh read_mesh_bytes(std::string_view bytes, const ReadOptions& options = {});

/// The mesh in a file; "-" is standard input.
/// @throws Error as read_mesh_bytes, with the path in front; Unreadable as read_bytes.
[[nodiscard]] Mesh read_mesh(const std::string& path, const ReadOptions& options = {});

enum class Encoding {
  Text,    ///< Shortest decimals whose nearest double is the coordinate.
  Binary,  ///< PLY: little-endian, float or double by the precision. STL: always float.
};

struct MeshWriteOptions {
  Precision precision = Precision::Binary64;  ///< Every coordinate must be a number of it already.
  Encoding encoding = Encoding::Text;         ///< OBJ and OFF know text only.
};

/// The bytes of a file that read_mesh_bytes reads as the same points, polygons and, for OBJ and STL
/// as text, parts. STL keeps triangles and the points that they use: a polygon becomes a fan from
/// its first corner, and equal points become one. GLB does the same, with parts, and is binary32
/// whatever the options say. XYZ keeps the points alone.
/// @param mesh   Binary points; polygons of at least 3 valid indices; parts that follow each other
///               and hold every polygon (or none at all).
/// @throws Error Unrepresentable if a coordinate is no number of the precision (STL in binary: of
///               binary32), if the points are rationals, or if there are 2^31 points or more;
///               InvalidArgument for OBJ or OFF in binary and for names with line ends.
[[nodiscard]] std::string write_mesh(const Mesh& mesh, MeshFormat format,
                                     const MeshWriteOptions& options = {});

/// A halfspace in binary64 or binary32: n1, n2, n3, d.
using BinaryHalfspace = std::array<double, 4>;

enum class HalfspaceFormat {
  Json,  ///< {"halfspaces": [[n1, n2, n3, d], ...]}, docs/formats.md
  Ine,   ///< The format of cdd and lrs.
  Rows,  ///< Lines "n1 n2 n3 d".
};

/// By the extension .json, .ine or .txt in any case; nothing for any other path.
[[nodiscard]] std::optional<HalfspaceFormat> halfspace_format_of_path(const std::string& path);

/// JSON if the first character opens an object or array; .ine if a line says so; rows if the first
/// line that is not a comment has four numbers; otherwise nothing.
[[nodiscard]] std::optional<HalfspaceFormat> halfspace_format_of_content(std::string_view bytes);

/// @throws Error as read_halfspaces_json, read_ine and read_halfspace_rows.
[[nodiscard]] HalfspaceList read_halfspaces_bytes(std::string_view bytes, HalfspaceFormat format,
                                                  Decimal decimal = Decimal::Nearest);

/// @throws Error as read_halfspaces_bytes, with the path in front; Unreadable as read_bytes.
[[nodiscard]] HalfspaceList read_halfspaces(const std::string& path, HalfspaceFormat format,
                                            Decimal decimal = Decimal::Nearest);

/// The bytes from which the same halfspaces are read.
[[nodiscard]] std::string write_halfspaces(std::span<const Halfspace> halfspaces,
                                           HalfspaceFormat format);
/// The same for finite doubles, as shortest decimals: to be read with Decimal::Nearest.
[[nodiscard]] std::string write_halfspaces(std::span<const BinaryHalfspace> halfspaces,
                                           HalfspaceFormat format);

/// Each file is written beside its target under another name; commit() moves all into place.
/// Unless that succeeds, every target stays as it was and no new file remains.
class AtomicOutput {
 public:
  AtomicOutput() = default;
  ~AtomicOutput();
  AtomicOutput(const AtomicOutput&) = delete;
  AtomicOutput& operator=(const AtomicOutput&) = delete;

  /// Whether add() would find a place for the file, as far as one can tell before: so that nobody
  /// learns after hours that the folder of an output does not exist.
  /// @throws Error Unwritable, as add().
  static void require_writable(const std::string& path);

  /// Writes `bytes` to the disk, for `path` to hold after commit(). A symbolic link stays one: the
  /// file that it points to is replaced. A file that exists keeps its permissions.
  /// After an error every file added so far is forgotten, and removed.
  /// @throws Error Unwritable if the folder does not exist or cannot be written to, or if the
  ///               target is a folder or another thing that is no regular file;
  ///               InvalidArgument if `path` was added before.
  void add(const std::string& path, std::string_view bytes);

  /// Moves all files into place and then calls `last`, if there is one: a step that must succeed
  /// together with them, such as printing the summary.
  /// @throws Error Unwritable, or what `last` throws, after undoing the moves made so far.
  void commit(const std::function<void()>& last = {});

 private:
  struct File {
    std::string path;       // as the caller gave it, for messages
    std::string target;     // without symbolic links
    std::string temporary;  // empty once it has been moved
    std::string backup;     // another name of the file that was replaced; empty: there was none
    bool moved = false;
  };

  static void write_temporary(File& file, std::string_view bytes);
  static void keep_replaced(File& file);
  void undo() noexcept;
  std::vector<File> files_;
};

}  // namespace convexact
