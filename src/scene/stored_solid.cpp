// SPDX-License-Identifier: MIT
#include "convexact/scene.hpp"
#include "scene/solid.hpp"

namespace convexact {

Stored store(Polytope exact, const PointSet& points, std::span<const PointId> extreme,
             const StoreRequest& request, StageLog& log) {
  Stored solid{std::move(exact), points, {}, {}};
  if (request.planes) {
    solid.planes = log.run("store planes", [&] {
      return store_planes(solid.exact, points, extreme, *request.planes);
    });
  } else {
    log.skip("store planes", "exact integers need no rounding");
  }
  if (request.mesh) {
    solid.mesh = log.run("store mesh",
                         [&] { return store_mesh(solid.exact, points, extreme, *request.mesh); });
  } else {
    log.skip("store mesh", "no mesh was requested");
  }
  return solid;
}

}  // namespace convexact
