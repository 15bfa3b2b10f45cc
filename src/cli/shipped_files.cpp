// SPDX-License-Identifier: MIT
#include "cli/shipped_files.hpp"

#include <vector>

namespace convexact::cli {

namespace fs = std::filesystem;

std::optional<fs::path> find_shipped(const fs::path& name,
                                     const std::function<bool(const fs::path&)>& is_it) {
  std::error_code failed;
  const fs::path folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  std::vector<fs::path> places = {folder / "../share/convexact" / name};
  for (fs::path above = folder; above != above.parent_path(); above = above.parent_path()) {
    places.push_back(above / "tests" / name);
    places.push_back(above / "share/convexact" / name);
  }
  places.push_back(fs::path(CONVEXACT_DATADIR) / name);
  for (const fs::path& place : places) {
    if (is_it(place)) return place.lexically_normal();
  }
  return std::nullopt;
}

}  // namespace convexact::cli
