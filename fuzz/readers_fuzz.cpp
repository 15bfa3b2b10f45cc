// SPDX-License-Identifier: MIT
// Property: every reader takes any bytes and either reads them or refuses them with an Error of
// exit code 3. What was read can be written and is then read as the same; decimals taken as spelled
// round to the doubles that they are read as otherwise.
#include <optional>

#include "convexact/error.hpp"
#include "convexact/format/halfspace_file.hpp"
#include "convexact/io/read_mesh.hpp"
#include "convexact/io/write_mesh.hpp"
#include "fuzz_check.hpp"
#include "same_mesh.hpp"

using namespace convexact;

namespace {

// The result, or nothing if it was refused as documented.
template <class Action>
auto unless_refused(Action&& action) -> std::optional<decltype(action())> {
  try {
    return action();
  } catch (const Error& error) {
    FUZZ_CHECK(exit_code(error.code()) == 3);
    FUZZ_CHECK(error.what()[0] != '\0');
    return {};
  }
}

void check_round_trip(const Mesh& mesh, MeshFormat format, const MeshWriteOptions& options) {
  const Mesh back = read_mesh_bytes(write_mesh(mesh, format, options), {.format = format});
  FUZZ_CHECK(same_points(back.points, mesh.points));
  FUZZ_CHECK(back.polygons == mesh.polygons);
  if (options.encoding == Encoding::Text) FUZZ_CHECK(same_parts(back, mesh));
}

void check_mesh(std::string_view bytes, MeshFormat format) {
  const auto mesh = unless_refused([&] { return read_mesh_bytes(bytes, {.format = format}); });
  if (!mesh) return;
  for (const auto& polygon : mesh->polygons) {
    FUZZ_CHECK(polygon.size() >= 3);
    for (const std::uint32_t corner : polygon) FUZZ_CHECK(corner < mesh->points.size());
  }
  check_round_trip(*mesh, format, {});
  if (format == MeshFormat::Ply) check_round_trip(*mesh, format, {.encoding = Encoding::Binary});
  const auto exact = unless_refused(
      [&] { return read_mesh_bytes(bytes, {.decimal = Decimal::Exact, .format = format}); });
  // STL may keep points apart that are equal only as doubles.
  if (!exact || format == MeshFormat::Stl) return;
  FUZZ_CHECK(exact->polygons == mesh->polygons);
  FUZZ_CHECK(std::equal(exact->points.doubles().begin(), exact->points.doubles().end(),
                        mesh->points.doubles().begin(), mesh->points.doubles().end()));
}

constexpr HalfspaceFormat kHalfspaceFormats[] = {HalfspaceFormat::Json, HalfspaceFormat::Ine,
                                                 HalfspaceFormat::Rows};

void check_halfspaces(std::string_view bytes, HalfspaceFormat format) {
  for (const Decimal decimal : {Decimal::Nearest, Decimal::Exact}) {
    const auto list = unless_refused([&] { return read_halfspaces_bytes(bytes, format, decimal); });
    if (!list) continue;
    FUZZ_CHECK(list->rows.size() == list->halfspaces.size());
    for (const HalfspaceFormat other : kHalfspaceFormats) {
      // A text without a row is refused, since it looks like the output of a program that died.
      if (list->halfspaces.empty() && other == HalfspaceFormat::Rows) continue;
      const std::string written =
          write_halfspaces(std::span<const Halfspace>(list->halfspaces), other);
      FUZZ_CHECK(read_halfspaces_bytes(written, other).halfspaces == list->halfspaces);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const MeshFormat format :
       {MeshFormat::Obj, MeshFormat::Off, MeshFormat::Ply, MeshFormat::Stl, MeshFormat::Xyz}) {
    check_mesh(bytes, format);
  }
  for (const HalfspaceFormat format : kHalfspaceFormats) {
    check_halfspaces(bytes, format);
  }
  (void)mesh_format_of_content(bytes);
  (void)halfspace_format_of_content(bytes);
  return 0;
}
