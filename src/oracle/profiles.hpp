// SPDX-License-Identifier: MIT
// profiles.hpp - named promises from JSON (docs/schema/profiles.schema.json).
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "convexact/conform.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kAsksNames = name_table<Asks>({{Asks::Enclosure, "enclosure"},
                                                     {Asks::Hull, "hull"},
                                                     {Asks::Inner, "inner"},
                                                     {Asks::Simplify, "simplify"}});

/// The profiles of a file, by name.
/// @throws Error Malformed, naming the profile.
[[nodiscard]] std::vector<Profile> read_profiles_bytes(std::string_view bytes);

/// The profile of that name. @throws Error InvalidArgument with the names that there are.
[[nodiscard]] const Profile& profile_of_name(const std::vector<Profile>& profiles,
                                             const std::string& name);

}  // namespace convexact
