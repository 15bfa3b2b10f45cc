/* SPDX-License-Identifier: MIT */
/* convexact.h - the C interface: does this enclose that? exactly; and enclose it in few halfspaces.
 *
 * Link with -lconvexact_c. A halfspace is n1 x + n2 y + n3 z + d <= 0, with n pointing outward, so
 * rows of planes are n1, n2, n3, d. Points and planes are arrays of doubles, taken exactly as they
 * are; a count is a number of points or planes, not of doubles.
 *
 * Ownership: arrays that you pass in are only read during the call. A result belongs to you until
 * you free it with the function of its name; what its functions return belongs to the result and
 * lives as long. Functions of a result do not fail; freeing NULL does nothing.
 *
 * Threads: there is no global state. Any functions may run at the same time, also on one result,
 * as long as no thread frees it meanwhile.
 *
 * Errors: a function that can fail returns a status and sets its result to NULL unless it succeeds.
 * No exception passes. Only if GMP, which the numbers are made of, finds no memory does it end the
 * process; elsewhere that is CONVEXACT_OUT_OF_MEMORY. */
#ifndef CONVEXACT_H
#define CONVEXACT_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define CONVEXACT_API __attribute__((visibility("default")))
#else
#define CONVEXACT_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum convexact_status {
  CONVEXACT_OK = 0,
  CONVEXACT_INVALID_ARGUMENT = 2, /* A null pointer, a count of 0, fewer than 4 planes wanted, a
                                     face that is none, a tolerance that is none, a measure or
                                     a number of bits that is none. */
  CONVEXACT_NOT_FINITE = 3,       /* A number is NaN or infinite. */
  CONVEXACT_NO_INTERIOR = 4,      /* Points lie in one plane where a solid is needed. */
  CONVEXACT_UNREPRESENTABLE = 5,  /* Doubles cannot hold the result; ask for fewer planes. */
  CONVEXACT_OUT_OF_MEMORY = 6,
  CONVEXACT_INTERNAL = 70 /* A verification of convexact failed: a bug, please report it. */
} convexact_status;

/* One sentence about a status, or about a number that is none; static. */
CONVEXACT_API const char* convexact_status_text(int status);

/* The version of the library, such as "0.1.0"; static. */
CONVEXACT_API const char* convexact_version(void);

/* ---- Does every point lie in a solid? ------------------------------------------------------- */

typedef struct convexact_containment convexact_containment;

/* In the intersection of halfspaces. A row with n = 0 holds everywhere if d <= 0, else nowhere. */
CONVEXACT_API convexact_status convexact_verify_planes(const double* points, size_t point_count,
                                                       const double* planes, size_t plane_count,
                                                       convexact_containment** result);

/* In the convex hull of vertices. CONVEXACT_NO_INTERIOR if these lie in one plane. */
CONVEXACT_API convexact_status convexact_verify_vertices(const double* points, size_t point_count,
                                                         const double* vertices,
                                                         size_t vertex_count,
                                                         convexact_containment** result);

/* 1 if no point is outside, else 0. The functions below tell the worst violation: of all points and
 * planes the pair of largest distance. If nothing is violated they return 0, or "0". */
CONVEXACT_API int convexact_containment_holds(const convexact_containment* result);
/* How many points are outside. */
CONVEXACT_API size_t convexact_containment_outside(const convexact_containment* result);
/* Which point is worst, counted from 0. */
CONVEXACT_API size_t convexact_containment_point(const convexact_containment* result);
/* Which plane it violates: the row, counted from 0, of planes; a facet of the hull of vertices. */
CONVEXACT_API size_t convexact_containment_plane(const convexact_containment* result);
/* That plane as four coprime integers "n1 n2 n3 d"; "0 0 0 1" if n = 0. */
CONVEXACT_API const char* convexact_containment_plane_text(const convexact_containment* result);
/* The squared distance of that point to that plane, exactly: "p" or "p/q". "inf" if n = 0. */
CONVEXACT_API const char* convexact_containment_squared_distance(
    const convexact_containment* result);
/* The distance, rounded up; infinity if n = 0. */
CONVEXACT_API double convexact_containment_distance(const convexact_containment* result);

CONVEXACT_API void convexact_containment_free(convexact_containment* result);

/* ---- Is it a solid that encloses the points? Every claim of the oracle ----------------------- */

typedef struct convexact_verdict convexact_verdict;

/* What `convexact verify` decides, with its claims and its tolerance; docs/verdicts.md#CODE
 * describes each claim. Budgets are not asked. CONVEXACT_NO_INTERIOR if the *points* lie in one
 * plane; any fault of the candidate is a violated claim.
 *
 * tolerance: as the option of the program, "1e-6" for a length or "1e-9d" for a share of the
 * points' diameter, taken as spelled; NULL for none. Other text is CONVEXACT_INVALID_ARGUMENT. */

/* The candidate is the intersection of halfspaces. */
CONVEXACT_API convexact_status convexact_judge_planes(const double* points, size_t point_count,
                                                      const double* planes, size_t plane_count,
                                                      const char* tolerance,
                                                      convexact_verdict** result);

/* The candidate is a mesh. Face f has face_sizes[f] >= 3 corners, indices of vertices from 0,
 * counter-clockwise from outside; corners holds those of all faces, one after another. Without
 * faces (face_count 0; corners and face_sizes may be NULL) the vertices stand for their convex
 * hull. */
CONVEXACT_API convexact_status convexact_judge_mesh(const double* points, size_t point_count,
                                                    const double* vertices, size_t vertex_count,
                                                    const uint32_t* corners,
                                                    const size_t* face_sizes, size_t face_count,
                                                    const char* tolerance,
                                                    convexact_verdict** result);

/* 1 if no claim is violated, else 0. */
CONVEXACT_API int convexact_verdict_holds(const convexact_verdict* result);
CONVEXACT_API size_t convexact_verdict_claim_count(const convexact_verdict* result);
/* Of claim i < claim count: its name, such as "contains-input"; */
CONVEXACT_API const char* convexact_verdict_claim_name(const convexact_verdict* result, size_t i);
/* "holds", "violated", "not-asked" or "not-applicable"; */
CONVEXACT_API const char* convexact_verdict_claim_status(const convexact_verdict* result, size_t i);
/* and what was found, for people. Points, faces and rows in it count from 0. */
CONVEXACT_API const char* convexact_verdict_claim_sentence(const convexact_verdict* result,
                                                           size_t i);

CONVEXACT_API void convexact_verdict_free(convexact_verdict* result);

/* ---- Few halfspaces that enclose points ------------------------------------------------------ */

typedef struct convexact_solid convexact_solid;

/* Removes halfspaces of the points' hull, each time the one that adds the least volume, until
 * plane_count >= 4 are left or every further removal would leave the solid unbounded. All steps are
 * verified exactly. */
CONVEXACT_API convexact_status convexact_simplify(const double* points, size_t point_count,
                                                  size_t plane_count, convexact_solid** result);

/* What the solid gains least of. The values stay what they are; further ones may follow. */
typedef enum convexact_cost {
  CONVEXACT_COST_VOLUME = 0,
  CONVEXACT_COST_AREA = 1,      /* Of the surface. */
  CONVEXACT_COST_MEAN_WIDTH = 2 /* Of the distances of parallel planes around the solid. */
} convexact_cost;

/* The same, where each removal adds the least to the measure `cost`, a convexact_cost. Volumes and
 * areas are compared exactly. Mean widths that enclosures of tie_bits bits do not tell apart, and
 * no proof shows to be equal, count as equal: 128 to 1048576, 0 for 4096. Where several removals
 * cost the same, the first in canonical order goes. */
CONVEXACT_API convexact_status convexact_simplify_by(const double* points, size_t point_count,
                                                     size_t plane_count, int cost, long tie_bits,
                                                     convexact_solid** result);

/* In how many steps several removals cost the same, or were not told apart. */
CONVEXACT_API size_t convexact_solid_tie_count(const convexact_solid* result);
/* Of how many of these it is not proven that the costs are equal; 0 unless by mean width. */
CONVEXACT_API size_t convexact_solid_undecided_count(const convexact_solid* result);
/* The most bits that did not tell such costs apart; 0 if there are none. */
CONVEXACT_API long convexact_solid_undecided_bits(const convexact_solid* result);

CONVEXACT_API size_t convexact_solid_plane_count(const convexact_solid* result);
/* Plane i < plane count as doubles, rounded outward: all planes together are proven to be bounded
 * and to hold every input point. The largest |n| component is between 1/2 and 1. */
CONVEXACT_API void convexact_solid_plane(const convexact_solid* result, size_t i, double plane[4]);
/* The same plane before rounding: four coprime integers "n1 n2 n3 d". */
CONVEXACT_API const char* convexact_solid_plane_text(const convexact_solid* result, size_t i);

CONVEXACT_API void convexact_solid_free(convexact_solid* result);

#ifdef __cplusplus
}
#endif

#endif /* CONVEXACT_H */
