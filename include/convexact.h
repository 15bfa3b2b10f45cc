/* SPDX-License-Identifier: MIT */
/* convexact.h - the C interface: exact tests of enclosure, and enclosures by few halfspaces or by
 * few convex parts.
 *
 * Link with -lconvexact_c. A halfspace is n1 x + n2 y + n3 z + d <= 0, with n pointing outward, so
 * rows of planes are n1, n2, n3, d. Points and planes are arrays of doubles, taken exactly as they
 * are; a count is a number of points or planes, not of doubles.
 *
 * Ownership: arrays that you pass in are only read during the call. A result belongs to you until
 * you free it with the function of its name; pointers that its functions return belong to the
 * result and are valid until then. Functions of a result do not fail; freeing NULL does nothing.
 *
 * Threads: a message per thread, convexact_message(), is the only state outside of results. Any
 * functions may run at the same time, even on one result, as long as no thread frees it meanwhile.
 *
 * Options: one text of names and values with blanks between them; NULL or "" for all defaults:
 *     "method=cut distance=3% max_parts=8 disjoint"
 * They are those of the program, with its defaults, so docs/reference/ describes each: what
 * is --max-parts there is max_parts here. A flag is its name alone, or disjoint=true or
 * disjoint=false. A name that the function does not know, or that is given twice, and a value out
 * of its range are CONVEXACT_INVALID_ARGUMENT; the message names the option, and says what there
 * is. Names are lower case, and so are words.
 *
 * Errors: a function that can fail returns a status and sets its result to NULL unless it succeeds.
 * No exception leaves a function. If GMP, which computes with the numbers, finds no memory, it ends
 * the process; any other lack of memory is CONVEXACT_OUT_OF_MEMORY. */
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
  CONVEXACT_INVALID_ARGUMENT = 2, /* A null pointer, a count of 0, an invalid face, or an option
                                     that does not exist or has no such value. */
  CONVEXACT_NOT_FINITE = 3,       /* A number is NaN or infinite. */
  CONVEXACT_NO_INTERIOR = 4,      /* Points lie in one plane where a solid is needed. */
  CONVEXACT_UNREPRESENTABLE = 5,  /* Doubles cannot hold the result; ask for fewer planes. */
  CONVEXACT_OUT_OF_MEMORY = 6,
  CONVEXACT_INTERNAL = 70 /* A verification of convexact failed: a bug, please report it. */
} convexact_status;

/* One sentence about a status, or about a number that is none; static. */
CONVEXACT_API const char* convexact_status_text(int status);

/* One sentence about the last call of this thread that failed: what was wrong, and what would be
 * right; "" if none did. Valid until the next call of this thread. */
CONVEXACT_API const char* convexact_message(void);

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

/* 1 if no point is outside, else 0. The functions below describe the worst violation: the pair of a
 * point and a plane with the largest distance. If nothing is violated they return 0, or "0". */
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

/* What `convexact verify` decides, with its claims; docs/verdicts.md#CODE describes each claim.
 * An input may have triangles, three indices of points from 0 for each, or none: NULL and 0.
 * CONVEXACT_NO_INTERIOR if the *points* lie in one plane; any fault of the candidate is a violated
 * claim.
 *
 * Options: asks, tolerance, claims, max_facets, max_vertices, max_facet_vertices and exact_facets
 * of the program; and its --points, judge_points=used, to ask only about points that triangles use.
 * Numbers beside the claims are not kept, so `tightness` only takes time. */

/* The candidate is the intersection of halfspaces. */
CONVEXACT_API convexact_status convexact_judge_planes(const double* points, size_t point_count,
                                                      const uint32_t* triangles,
                                                      size_t triangle_count, const double* planes,
                                                      size_t plane_count, const char* options,
                                                      convexact_verdict** result);

/* The candidate is a mesh. Face f has face_sizes[f] >= 3 corners, indices of vertices from 0,
 * counter-clockwise from outside; corners holds those of all faces, one after another. Without
 * faces (face_count 0; corners and face_sizes may be NULL) the vertices stand for their convex
 * hull. */
CONVEXACT_API convexact_status convexact_judge_mesh(
    const double* points, size_t point_count, const uint32_t* triangles, size_t triangle_count,
    const double* vertices, size_t vertex_count, const uint32_t* corners, const size_t* face_sizes,
    size_t face_count, const char* options, convexact_verdict** result);

/* 1 if no claim is violated, else 0. */
CONVEXACT_API int convexact_verdict_holds(const convexact_verdict* result);
CONVEXACT_API size_t convexact_verdict_claim_count(const convexact_verdict* result);
/* Of claim i < claim count: its name, such as "contains-input"; */
CONVEXACT_API const char* convexact_verdict_claim_name(const convexact_verdict* result, size_t i);
/* "holds", "violated", "not-asked", "not-applicable" or "undecided"; */
CONVEXACT_API const char* convexact_verdict_claim_status(const convexact_verdict* result, size_t i);
/* and what was found, for people. Points, faces and rows in it count from 0. */
CONVEXACT_API const char* convexact_verdict_claim_sentence(const convexact_verdict* result,
                                                           size_t i);

CONVEXACT_API void convexact_verdict_free(convexact_verdict* result);

/* ---- Few halfspaces that enclose points ------------------------------------------------------ */

typedef struct convexact_solid convexact_solid;

/* Removes halfspaces of the points' hull, each time the one that adds the least to a measure, then
 * searches for a smaller one if that is asked for. All steps are verified exactly. Options: those
 * of `convexact simplify`, from faces to center, and seed; faces or max_growth is needed:
 *     "faces=18 cost=mean-width search=local moves=500 seed=7"
 * A solid keeps more than so many faces if every further removal would leave it unbounded. Mean
 * widths that enclosures of tie_bits bits cannot tell apart count as equal even without a proof. If
 * several removals cost the same, the first in canonical order is made. */
CONVEXACT_API convexact_status convexact_simplify(const double* points, size_t point_count,
                                                  const char* options, convexact_solid** result);

/* How many exchanges a search made after the removals. */
CONVEXACT_API size_t convexact_solid_move_count(const convexact_solid* result);

/* The number of steps in which several removals cost the same, or could not be told apart. */
CONVEXACT_API size_t convexact_solid_tie_count(const convexact_solid* result);
/* The number of these in which the costs are not proven to be equal; 0 unless by mean width. */
CONVEXACT_API size_t convexact_solid_undecided_count(const convexact_solid* result);
/* The most bits with which such costs could not be told apart; 0 if there are none. */
CONVEXACT_API long convexact_solid_undecided_bits(const convexact_solid* result);

CONVEXACT_API size_t convexact_solid_plane_count(const convexact_solid* result);
/* Plane i < plane count as doubles, rounded outward: all planes together are proven to be bounded
 * and to hold every input point. The largest |n| component is between 1/2 and 1. */
CONVEXACT_API void convexact_solid_plane(const convexact_solid* result, size_t i, double plane[4]);
/* The same plane before rounding: four coprime integers "n1 n2 n3 d". */
CONVEXACT_API const char* convexact_solid_plane_text(const convexact_solid* result, size_t i);

CONVEXACT_API void convexact_solid_free(convexact_solid* result);

/* ---- A mesh as few convex parts -------------------------------------------------------------- */

typedef struct convexact_decomposition convexact_decomposition;

/* Triangle t has the corners triangles[3 t] to [3 t + 2], indices of points from 0, counter-
 * clockwise from outside; triangles are turned where the solid needs it. Every triangle gets an
 * owner, a part that holds it: proven on the numbers of the part as they are. So the parts cover
 * the surface, but need not cover the solid. A point that no triangle uses goes to the part that is
 * nearest to it. CONVEXACT_NO_INTERIOR if all triangles lie in one plane, unless `flat` is thicken
 * or keep; CONVEXACT_UNREPRESENTABLE if the precision cannot hold a part.
 *
 * Options: those of `convexact decompose`, from method to precision, and
 *   no_measures    do not measure volumes, which may take most of the time;
 *   exact_volumes  measure them as fractions, too, which may be very long;
 *   tree           find the merges that would come next, for convexact_decomposition_tree();
 *   seed           of random orders; no result depends on it.
 * As in the program the method is auto: cut for closed surfaces, whose parts hold the solid, none
 * farther from it than the distance. Before there were texts of options it was hacd, whose parts
 * are hulls of clusters of triangles: say method=hacd. */
CONVEXACT_API convexact_status convexact_decompose(const double* points, size_t point_count,
                                                   const uint32_t* triangles, size_t triangle_count,
                                                   const char* options,
                                                   convexact_decomposition** result);

CONVEXACT_API size_t convexact_decomposition_part_count(const convexact_decomposition* result);
/* 1 if the concavity of every part is within the limit, else 0: max_parts, flat triangles that were
 * merged, and notches that cannot be split may lead beyond it. */
CONVEXACT_API int convexact_decomposition_eps_holds(const convexact_decomposition* result);
/* With the method cut, guard=reach or merge=reach: 1 if no point of a part is farther from the
 * solid than the distance, proven; else 0. */
CONVEXACT_API int convexact_decomposition_reach_holds(const convexact_decomposition* result);
/* For each triangle the part that owns it; UINT32_MAX of a triangle that several parts of the
 * method cut hold together. */
CONVEXACT_API const uint32_t* convexact_decomposition_owners(const convexact_decomposition* result);

typedef enum convexact_volume {
  CONVEXACT_VOLUME_SOLID = 0,     /* Of the mesh. */
  CONVEXACT_VOLUME_UNION = 1,     /* Of the union of the parts. */
  CONVEXACT_VOLUME_UNCOVERED = 2, /* Of the solid outside of the union. */
  CONVEXACT_VOLUME_EXCESS = 3,    /* Of the union outside of the solid. */
  CONVEXACT_VOLUME_OVERLAP = 4    /* The sum of the parts' volumes, less the union's. */
} convexact_volume;

/* Two doubles between which a convexact_volume lies: from 128 bits, or from the fraction if that
 * was asked for; they are then equal if it is a double. NaN if it was not measured; for solid,
 * uncovered and excess also if the mesh encloses no solid. */
CONVEXACT_API void convexact_decomposition_volume(const convexact_decomposition* result, int volume,
                                                  double bounds[2]);
/* "p" or "p/q" if exact_volumes asked for it and it was measured; else "". */
CONVEXACT_API const char* convexact_decomposition_exact_volume(
    const convexact_decomposition* result, int volume);

/* Of part k < part count: its corners, three doubles each; it is the hull of these. */
CONVEXACT_API size_t convexact_decomposition_vertex_count(const convexact_decomposition* result,
                                                          size_t k);
CONVEXACT_API const double* convexact_decomposition_vertices(const convexact_decomposition* result,
                                                             size_t k);
/* Its faces, convex polygons, as convexact_judge_mesh takes them: corners are indices of its
 * vertices from 0. A part that is flat has one, or none if it is a segment or a point. */
CONVEXACT_API size_t convexact_decomposition_face_count(const convexact_decomposition* result,
                                                        size_t k);
CONVEXACT_API const size_t* convexact_decomposition_face_sizes(
    const convexact_decomposition* result, size_t k);
CONVEXACT_API const uint32_t* convexact_decomposition_corners(const convexact_decomposition* result,
                                                              size_t k);
/* Its planes: for a part that is not flat one for each face, in the same order. */
CONVEXACT_API size_t convexact_decomposition_plane_count(const convexact_decomposition* result,
                                                         size_t k);
/* Plane i < plane count, exactly: four coprime integers "n1 n2 n3 d". */
CONVEXACT_API const char* convexact_decomposition_plane_text(const convexact_decomposition* result,
                                                             size_t k, size_t i);
/* Writes all planes of the part, rounded outward to numbers of the precision: proven to be bounded
 * and to hold the part. This takes some time, and may fail: CONVEXACT_NO_INTERIOR if the part is
 * flat, CONVEXACT_UNREPRESENTABLE if no rounding that was tried is bounded. */
CONVEXACT_API convexact_status convexact_decomposition_planes(const convexact_decomposition* result,
                                                              size_t k, double* planes);

/* How the part came from the hull of its triangles. */
typedef enum convexact_form {
  CONVEXACT_FORM_HULL = 0,       /* It is the hull: every vertex is a point of the mesh. */
  CONVEXACT_FORM_ROUNDED = 1,    /* The hull rounded outward; a box if it is too small for that. */
  CONVEXACT_FORM_SIMPLIFIED = 2, /* Fewer planes around it. */
  CONVEXACT_FORM_THICKENED = 3,  /* A flat hull made solid. */
  CONVEXACT_FORM_FLAT = 4        /* A flat hull. */
} convexact_form;

/* A convexact_form; further values may follow. */
CONVEXACT_API int convexact_decomposition_form(const convexact_decomposition* result, size_t k);
/* How concave its triangles are: the length, rounded up, and its square exactly, "p" or "p/q". */
CONVEXACT_API double convexact_decomposition_concavity(const convexact_decomposition* result,
                                                       size_t k);
CONVEXACT_API const char* convexact_decomposition_squared_concavity(
    const convexact_decomposition* result, size_t k);
/* 1 if that is within the limit, else 0. */
CONVEXACT_API int convexact_decomposition_within_limit(const convexact_decomposition* result,
                                                       size_t k);

CONVEXACT_API void convexact_decomposition_free(convexact_decomposition* result);

/* ---- Does the union of convex parts hold a mesh? Every claim of the oracle --------------------
 */

/* A mesh as convexact_decompose takes it; without triangles (triangle_count 0; triangles may be
 * NULL) its points are to be covered. Part k has vertex_counts[k] >= 1 vertices, and is their hull;
 * vertices holds those of all parts, one after another. It may have faces: face_counts[k] of them,
 * whose sizes and corners, indices of the vertices of part k from 0, follow those of the parts
 * before, as in convexact_judge_mesh. Without any, face_counts is NULL, and so may be the others.
 *
 * The mesh may be flat. Any fault of the parts' shape is a violated claim, whose sentence calls
 * part 3 part_3.
 *
 * Options: those of convexact_judge_planes but for asks, where max_facets, max_vertices and
 * max_facet_vertices are budgets of each part; and distance, max_parts, close, orient and
 * exact_volumes of `convexact verify --union`. "claims=covers-surface,parts-disjoint" decides these
 * claims only. Otherwise all are decided but parts-disjoint, parts-needed and, without a distance,
 * covers-solid. */
CONVEXACT_API convexact_status
convexact_verify_parts(const double* points, size_t point_count, const uint32_t* triangles,
                       size_t triangle_count, const double* vertices, const size_t* vertex_counts,
                       size_t part_count, const uint32_t* corners, const size_t* face_sizes,
                       const size_t* face_counts, const char* options, convexact_verdict** result);

/* ---- Parts under a tree of hulls ------------------------------------------------------------- */

typedef struct convexact_tree convexact_tree;

/* Where there is no such node or part. */
#define CONVEXACT_NONE SIZE_MAX

/* A binary tree whose leaves are the parts: by the splits of the method acd, by the merges that
 * hacd would make next if `tree` asked for them, and by the least common hull where neither joins
 * parts. Each hull holds the hulls of its children: proven on their numbers as they are. Parts that
 * are flat are made solid. Options: faces, leaf_faces and precision of `convexact bvh`;
 * docs/hull-trees.md describes each. */
CONVEXACT_API convexact_status convexact_decomposition_tree(const convexact_decomposition* parts,
                                                            const char* options,
                                                            convexact_tree** result);

/* Nodes are in the order of their levels, the root first. */
CONVEXACT_API size_t convexact_tree_node_count(const convexact_tree* result);
/* Of node i < node count: its parent, CONVEXACT_NONE for the root; */
CONVEXACT_API size_t convexact_tree_parent(const convexact_tree* result, size_t i);
/* its children, two for a branch and none for a leaf; */
CONVEXACT_API size_t convexact_tree_child_count(const convexact_tree* result, size_t i);
CONVEXACT_API const size_t* convexact_tree_children(const convexact_tree* result, size_t i);
/* its part of the decomposition for a leaf, CONVEXACT_NONE for a branch; */
CONVEXACT_API size_t convexact_tree_part(const convexact_tree* result, size_t i);
/* and the corners and faces of its hull, as those of a part. */
CONVEXACT_API size_t convexact_tree_vertex_count(const convexact_tree* result, size_t i);
CONVEXACT_API const double* convexact_tree_vertices(const convexact_tree* result, size_t i);
CONVEXACT_API size_t convexact_tree_face_count(const convexact_tree* result, size_t i);
CONVEXACT_API const size_t* convexact_tree_face_sizes(const convexact_tree* result, size_t i);
CONVEXACT_API const uint32_t* convexact_tree_corners(const convexact_tree* result, size_t i);

CONVEXACT_API void convexact_tree_free(convexact_tree* result);

/* Judges the leaves, the nodes that are no parent, as convexact_verify_parts does parts, which are
 * numbered in their order; and whether the nodes are a tree whose hulls hold their children, the
 * claim tree-nested. Node i has the parent parents[i], a node or CONVEXACT_NONE, and is the hull of
 * vertex_counts[i] >= 1 vertices, which follow those of the nodes before. */
CONVEXACT_API convexact_status convexact_verify_tree(
    const double* points, size_t point_count, const uint32_t* triangles, size_t triangle_count,
    const double* vertices, const size_t* vertex_counts, const size_t* parents, size_t node_count,
    const char* options, convexact_verdict** result);

#ifdef __cplusplus
}
#endif

#endif /* CONVEXACT_H */
