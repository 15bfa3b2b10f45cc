// SPDX-License-Identifier: MIT
// Files of rays.
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/query.hpp"
#include "io/text_cursor.hpp"

namespace convexact {

std::vector<Ray> read_rays_bytes(std::string_view bytes, Decimal decimal) {
  constexpr const char* kRow = "a ray ox oy oz ux uy uz";
  TextCursor cursor(bytes, {.comment = '#'});
  std::vector<Ray> rays;
  while (cursor.next_line()) {
    Ray ray;
    for (RationalVector3* part : {&ray.origin, &ray.direction}) {
      for (Rational& x : *part) {
        const std::string_view token = cursor.expect_token(kRow);
        try {
          x = parse_number(token, decimal);
        } catch (const Error& error) {
          cursor.fail(error.what(), error.code());
        }
      }
    }
    cursor.expect_line_end();
    if (ray.direction.isZero(0)) cursor.fail("the direction of the ray is zero");
    rays.push_back(std::move(ray));
  }
  if (rays.empty()) cursor.fail("expected rays ox oy oz ux uy uz, found none");
  return rays;
}

std::vector<Ray> read_rays(const std::string& path, Decimal decimal) {
  const std::string bytes = read_bytes(path);
  try {
    return read_rays_bytes(bytes, decimal);
  } catch (const Error& error) {
    throw error.in_file(display_name(path));
  }
}

}  // namespace convexact
