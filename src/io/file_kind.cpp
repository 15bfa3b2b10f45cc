// SPDX-License-Identifier: MIT
#include "io/file_kind.hpp"

#include <algorithm>
#include <array>

#include "convexact/error.hpp"
#include "io/halfspace_formats.hpp"
#include "io/mesh_readers.hpp"
#include "io/text_cursor.hpp"

namespace convexact {
namespace {

constexpr std::string_view kExport =
    "export it as OBJ, PLY or STL (in Blender: File, Export), or convert it, as "
    "trimesh.load('FILE').export('out.obj') does in Python";

// A format that is not read: how it begins, its extensions, and what to do.
struct Foreign {
  std::string_view name;
  std::string_view start;  // its first bytes; empty: known by its extension only
  std::string_view extensions;
  std::string_view advice;
};

constexpr std::array kForeign = {
    Foreign{"an FBX file, which is not read", "Kaydara FBX Binary", ".fbx", kExport},
    Foreign{"a 3D Studio file, which is not read", "", ".3ds .max", kExport},
    Foreign{"a Blender file, which is not read", "BLENDER", ".blend", kExport},
    Foreign{"a USD crate, which is not read", "PXR-USDC", ".usdc .usd .usdz", kExport},
    Foreign{"a STEP file, of curved surfaces", "ISO-10303-21", ".step .stp .igs .iges",
            "mesh it in a CAD program and export STL"},
    Foreign{"a 3MF file, which is not read", "", ".3mf", kExport},
    Foreign{"a VTK file, which is not read", "# vtk DataFile", ".vtk .vtu .vtp", kExport},
    Foreign{"a mesh of Gmsh or Ansys, which is not read", "$MeshFormat", ".msh", kExport},
    Foreign{"a VRML file, which is not read", "#VRML", ".wrl .x3d", kExport},
    Foreign{"an OpenCTM file, which is not read", "OCTM", ".ctm", kExport},
    Foreign{"a Git LFS pointer, not the file itself", "version https://git-lfs.github.com/spec/",
            "", "git lfs pull fetches that"},
    Foreign{"gzip data", "\x1F\x8B", ".gz .tgz", "unpack it first: gunzip"},
    Foreign{"a zip archive", "PK\x03\x04", ".zip", "unpack it first: unzip"},
    Foreign{"a PNG image", "\x89PNG", ".png", "a mesh is expected"},
    Foreign{"a JPEG image", "\xFF\xD8\xFF", ".jpg .jpeg", "a mesh is expected"},
    Foreign{"a PDF document", "%PDF", ".pdf", "a mesh is expected"},
    Foreign{"UTF-16 text", "\xFF\xFE", "", "save it as UTF-8: iconv -f UTF-16 -t UTF-8"},
    Foreign{"UTF-16 text", "\xFE\xFF", "", "save it as UTF-8: iconv -f UTF-16 -t UTF-8"}};

// ".obj", in small letters; empty if the name has none.
std::string extension_of(const std::string& path) {
  const std::size_t name = path.find_last_of('/') + 1;  // npos + 1 is 0
  const std::size_t point = path.find_last_of('.');
  return point == path.npos || point < name ? "" : lower_case(path.substr(point));
}

[[noreturn]] void refuse(std::string_view name, std::string_view advice) {
  throw Error(ErrorCode::Unreadable, "this is " + std::string(name) + ": " + std::string(advice));
}

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != words.npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool is_first = at == 0 || words[at - 1] == ' ';
    if (is_first && (end == words.size() || words[end] == ' ')) return !word.empty();
  }
  return false;
}

// Text formats without a fixed first word.
void refuse_markup(std::string_view bytes) {
  if (is_collada(bytes)) return;
  const std::string start = lower_case(bytes.substr(0, 4096));
  const std::size_t first = start.find_first_not_of(" \t\r\n");
  if (first == start.npos || start[first] != '<') return;
  if (start.find("<robot") != start.npos) {
    refuse("a robot model (URDF)",
           "convexact decompose NAME.urdf -o FOLDER/ takes whole robots; other commands take the "
           "meshes "
           "in it, and verify --union the models that convexact wrote");
  }
  if (start.find("<mujoco") != start.npos) {
    refuse("a MuJoCo model", "name the meshes in it; verify --union reads those of convexact");
  }
  if (start.find("<html") != start.npos || start.find("<!doctype html") != start.npos) {
    refuse("an HTML page", "a download may have saved the page of a file in the place of the file");
  }
  refuse("XML, which is not read", kExport);
}

// By content alone: a file named .obj may be anything.
void refuse_foreign(std::string_view bytes, const std::string& extension) {
  for (const Foreign& foreign : kForeign) {
    if (foreign.start.empty() || !bytes.starts_with(foreign.start)) continue;
    const bool is_3mf = foreign.start.starts_with("PK") &&
                        (extension == ".3mf" || bytes.find("3D/3dmodel.model") != bytes.npos);
    refuse(is_3mf ? "a 3MF file, which is not read" : foreign.name,
           is_3mf ? kExport : foreign.advice);
  }
  refuse_markup(bytes);
  if (extension.empty()) return;
  for (const Foreign& foreign : kForeign) {
    if (has_word(foreign.extensions, extension)) refuse(foreign.name, foreign.advice);
  }
}

// Whether a text begins as those of qhull and rbox: the dimension, 3, then how many points there
// are, each with a line of its own; a comment may follow the dimension.
bool is_cloud_of_qhull(std::string_view bytes) {
  TextCursor cursor(bytes.substr(0, 4096), {.comment = '#'});
  if (!cursor.next_line() || cursor.token() != "3" || !cursor.next_line()) return false;
  const std::string_view count = cursor.token();
  return !count.empty() && count.find_first_not_of("0123456789") == count.npos &&
         cursor.token().empty();
}

// Statements of OBJ begin with such words.
bool begins_as_obj(std::string_view bytes) {
  TextCursor cursor(bytes, {.comment = '#'});
  if (!cursor.next_line()) return true;
  const std::string_view token = cursor.token();
  constexpr std::string_view kWords = "v vt vn vp f fo g o s l p mg usemtl mtllib cstype deg";
  return has_word(kWords, token);
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::optional<MeshFormat> readable_mesh_format(const std::string& path) {
  if (const auto format = mesh_format_of_path(path)) return format;
  const std::string extension = extension_of(path);
  if (has_word(".pts .csv .xyzn .xyzrgb", extension)) return MeshFormat::Xyz;
  if (extension == ".pcd") return MeshFormat::Pcd;
  if (extension == ".ext") return MeshFormat::Ext;
  if (extension == ".gltf") return MeshFormat::Gltf;
  if (extension == ".dae") return MeshFormat::Collada;
  return {};
}

Error fault_of_candidate(const Error& error, const std::string& path) {
  const std::string name = display_name(path);
  if (error.code() == ErrorCode::NoInterior) {
    return Error(ErrorCode::Malformed, error.what()).in_file(name);
  }
  const bool is_fault =
      error.code() == ErrorCode::Malformed || error.code() == ErrorCode::NotFinite;
  if (!is_fault) throw error.in_file(name);
  return error.in_file(name);
}

FileKind kind_of_file(std::string_view bytes, const std::string& path) {
  refuse_foreign(bytes, extension_of(path));
  const std::optional<MeshFormat> mesh = readable_mesh_format(path);
  const std::optional<HalfspaceFormat> halfspaces = halfspace_format_of_path(path);
  if (is_off_of_qhull(bytes)) return {MeshFormat::Off, {}};
  if (bytes.starts_with("glTF")) return {MeshFormat::Gltf, {}};
  if (is_collada(bytes)) return {MeshFormat::Collada, {}};
  if (mesh == MeshFormat::Ext && !is_v_representation(bytes)) return {{}, HalfspaceFormat::Ine};
  if (mesh) return {mesh, {}};
  if (halfspaces == HalfspaceFormat::Rows && is_cloud_of_qhull(bytes)) {
    return {MeshFormat::Xyz, {}};
  }
  if (halfspaces) return {{}, halfspaces};
  if (is_v_representation(bytes)) return {MeshFormat::Ext, {}};
  if (const auto found = halfspace_format_of_content(bytes)) return {{}, found};
  const MeshFormat found = mesh_format_of_content(bytes);
  if (found == MeshFormat::Obj && !begins_as_obj(bytes)) {
    throw Error(
        ErrorCode::Unreadable,
        "this is no file that is read: expected OBJ, OFF, PLY, STL, glTF (.glb, .gltf), COLLADA "
        "(.dae), a point cloud (.xyz, .pts, .csv, .pcd) or halfspaces (.json, .ine, .txt); an "
        "extension names the format");
  }
  return {found, {}};
}

}  // namespace convexact
