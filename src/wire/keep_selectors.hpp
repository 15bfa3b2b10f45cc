// SPDX-License-Identifier: MIT
// keep_selectors.hpp - facets that a run must not remove, as users name them: on the command line
// and in requests.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "convexact/run.hpp"
#include "convexact/scene.hpp"

namespace convexact {

/// "1217,33" as ids, each below 2^32. @throws Error InvalidArgument as parse_count().
[[nodiscard]] std::vector<HalfspaceId> parse_ids(const std::string& option,
                                                 const std::string& text);

/// The selectors of each object: id:12,13 and plane:nx,ny,nz,d and normal:x,y,z[:degrees] and
/// group:NAME; in a scene of several objects each after the name of a part and a slash.
/// @param option  Its name, for messages: "--keep".
/// @throws Error  InvalidArgument, with the text, for anything else, for a part or a group that
///                does not exist, and for one of several objects without its name.
[[nodiscard]] std::vector<std::vector<KeepSelector>> keep_selectors(
    const std::string& option, const std::vector<std::string>& texts,
    std::span<const SceneObject> scene);

}  // namespace convexact
