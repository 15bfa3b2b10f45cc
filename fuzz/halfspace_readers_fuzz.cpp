// SPDX-License-Identifier: MIT
// Property of halfspaces_json, ine, rows: the reader takes any bytes and either reads them or
// refuses them with an Error of exit code 3, whether numbers are rounded or taken as spelled. A
// list that was read can be written in every format, and reading it back gives the same list.
#include "convexact/io.hpp"
#include "fuzz_target.hpp"
#include "unless_refused.hpp"

using namespace convexact;

namespace {

constexpr HalfspaceFormat kFormats[] = {HalfspaceFormat::Json, HalfspaceFormat::Ine,
                                        HalfspaceFormat::Rows};

template <HalfspaceFormat format>
void hold(FuzzInput& in) {
  const std::string_view bytes = in.rest();
  (void)halfspace_format_of_content(bytes);
  for (const Decimal decimal : {Decimal::Nearest, Decimal::Exact}) {
    const auto list = unless_refused([&] { return read_halfspaces_bytes(bytes, format, decimal); });
    if (!list) continue;
    FUZZ_CHECK(list->rows.size() == list->halfspaces.size());
    // A list without a row is refused, since it looks like the output of a program that died, and
    // rows that bound nothing are not written.
    if (list->halfspaces.empty()) continue;
    for (const HalfspaceFormat other : kFormats) {
      const std::string written =
          write_halfspaces(std::span<const Halfspace>(list->halfspaces), other);
      FUZZ_CHECK(read_halfspaces_bytes(written, other).halfspaces == list->halfspaces);
    }
  }
}

const FuzzTarget kJson("halfspaces_json", hold<HalfspaceFormat::Json>);
const FuzzTarget kIne("ine", hold<HalfspaceFormat::Ine>);
const FuzzTarget kRows("rows", hold<HalfspaceFormat::Rows>);

}  // namespace
