// SPDX-License-Identifier: MIT
// shipped_files.hpp - finds the files that come with the program.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>

namespace convexact::cli {

/// The first place that `is_it` accepts for "vectors", "data/bunny.obj", "profiles.json" and the
/// like: beside the installed program, in the source of one that runs where it was built, or where
/// it was to be installed.
[[nodiscard]] std::optional<std::filesystem::path> find_shipped(
    const std::filesystem::path& name,
    const std::function<bool(const std::filesystem::path&)>& is_it);

}  // namespace convexact::cli
