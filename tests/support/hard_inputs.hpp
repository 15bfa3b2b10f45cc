// SPDX-License-Identifier: MIT
// hard_inputs.hpp - thousands of small point sets on which floating point goes wrong, numbered, so
// that engines and filters can all be judged on the same ones.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "convexact/geometry.hpp"

namespace hard {

/// One kind of hard inputs. Some members may span no volume.
struct Inputs {
  std::string_view name;
  std::uint32_t count;
  /// Member i, 0 <= i < count: the same doubles on every platform.
  std::vector<convexact::Point> (*make)(std::uint32_t i);
};

[[nodiscard]] std::span<const Inputs> inputs();

/// Calls visit(i, points) for the members of one kind. The environment variable CONVEXACT_STRIDE
/// = s takes every s-th only, for a quick look.
/// @throws std::out_of_range if there is no kind of that name.
template <class Visit>
void for_each(std::string_view name, Visit&& visit);

[[nodiscard]] const Inputs& named(std::string_view name);
[[nodiscard]] std::uint32_t stride();

template <class Visit>
void for_each(std::string_view name, Visit&& visit) {
  const Inputs& kind = named(name);
  for (std::uint32_t i = 0; i < kind.count; i += stride()) visit(i, kind.make(i));
}

}  // namespace hard
