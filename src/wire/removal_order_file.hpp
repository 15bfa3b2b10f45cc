// SPDX-License-Identifier: MIT
// removal_order_file.hpp - reads a removal order: a trace, a list of planes or of ids.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "convexact/io.hpp"
#include "convexact/verify_order.hpp"

namespace convexact {

/// Facets by id: position 0 first. None where the row has normal 0.
using ListedFacets = std::vector<std::optional<Halfspace>>;

/// Reads the list that ids refer to: halfspaces in any of their formats, by the extension of
/// `path`, otherwise by content. Ids count the rows, those with normal 0 too, from 0.
/// @throws Error As read_halfspaces_bytes(); Malformed if it is none of the formats.
[[nodiscard]] ListedFacets read_facet_list(std::string_view bytes, const std::string& path,
                                           Decimal decimal = Decimal::Nearest);

/// Reads an order of one of three kinds, distinguished by the first character and the first row:
/// - JSON, an object with `steps`: our trace (docs/schema/trace.schema.json), or a part of one: a
///   step needs only `removed`; `cost`, as far as it is spelled exactly, `tie` and `left` are
///   claims; ids are positions in `halfspaces` if that is there;
/// - text with four numbers per row: the planes n.x + d = 0 in order of removal;
/// - text with an integer per row: ids in order of removal. Any integer is accepted: one that is
///   out of range becomes an id that names no facet.
/// @param facets     The list that ids refer to; none: `canonical`, the input's own halfspaces.
/// @param measure    The measure by which to judge the order; none: the measure that it states, or
///                   the volume.
/// @throws Error     Malformed or NotFinite with the line or, in JSON, the place; InvalidArgument
///                   if `facets` are given to an order that spells out its planes, or if it states
///                   another measure, or costs of another one.
[[nodiscard]] RemovalOrder read_removal_order(std::string_view bytes,
                                              const std::optional<ListedFacets>& facets,
                                              std::span<const Halfspace> canonical,
                                              Decimal decimal = Decimal::Nearest,
                                              std::optional<CostMeasure> measure = {});

}  // namespace convexact
