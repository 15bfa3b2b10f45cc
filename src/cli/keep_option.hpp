// SPDX-License-Identifier: MIT
// keep_option.hpp - --keep: facets that a run must not remove, as users name them.
#pragma once
#include <string>
#include <vector>

#include "cli/parser.hpp"
#include "convexact/run.hpp"
#include "convexact/scene.hpp"

namespace convexact::cli {

/// Adds --keep, which may be repeated. @param texts  Receives what was given.
Option add_keep_option(Command& command, std::vector<std::string>& texts);

/// The selectors of each object: id:12,13 and plane:nx,ny,nz,d and normal:x,y,z[:degrees] and
/// group:NAME; in a scene of several objects each after the name of a part and a slash.
/// @throws Error InvalidArgument, with the text, for anything else, for a part or a group that does
///               not exist, and for one of several objects without its name.
[[nodiscard]] std::vector<std::vector<KeepSelector>> keep_selectors(
    const std::vector<std::string>& texts, const std::vector<SceneObject>& scene);

}  // namespace convexact::cli
