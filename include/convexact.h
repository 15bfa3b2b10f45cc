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
 * Threads: there is no global state. Any functions may run at the same time, even on one result,
 * as long as no thread frees it meanwhile.
 *
 * Options: a struct whose first field is its size, as sizeof gives it, so that later versions can
 * have more fields. Every other field that is 0 or NULL stands for its default, and NULL in the
 * place of the struct for all defaults:
 *     convexact_decompose_options options = {.size = sizeof options, .max_parts = 8};
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
  CONVEXACT_INVALID_ARGUMENT = 2, /* A null pointer, a count of 0, fewer than 4 planes wanted, an
                                     invalid face, tolerance, measure or number of bits, or an
                                     option out of its range. */
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

/* What is asked; options may be NULL, and so may each of its pointers. Other texts than these are
 * CONVEXACT_INVALID_ARGUMENT. */
typedef struct convexact_judge_options {
  size_t size;           /* sizeof(convexact_judge_options). */
  const char* asks;      /* What the candidate was to be: "enclosure" (NULL), "hull", which has the
                            claim is-hull besides, or "inner", which has inside-input in the place of
                            contains-input. */
  const char* tolerance; /* As the option of the program: "1e-6" for a length, "1e-9d" for a share
                            of the points' diameter, taken as spelled. NULL for none. */
  const uint32_t* triangles; /* Of the input: three indices of points from 0 for each. */
  size_t triangle_count;     /* 0: the input has no faces, it is its points. */
  const char* points; /* Which points of an input with faces are asked: "all" (NULL), or "used" for
                         those that triangles use. */
} convexact_judge_options;

/* What `convexact verify` decides, with its claims; docs/verdicts.md#CODE describes each claim.
 * Budgets are not asked. CONVEXACT_NO_INTERIOR if the *points* lie in one plane; any fault of the
 * candidate is a violated claim. */

/* The candidate is the intersection of halfspaces. */
CONVEXACT_API convexact_status convexact_judge_planes(const double* points, size_t point_count,
                                                      const double* planes, size_t plane_count,
                                                      const convexact_judge_options* options,
                                                      convexact_verdict** result);

/* The candidate is a mesh. Face f has face_sizes[f] >= 3 corners, indices of vertices from 0,
 * counter-clockwise from outside; corners holds those of all faces, one after another. Without
 * faces (face_count 0; corners and face_sizes may be NULL) the vertices stand for their convex
 * hull. */
CONVEXACT_API convexact_status convexact_judge_mesh(const double* points, size_t point_count,
                                                    const double* vertices, size_t vertex_count,
                                                    const uint32_t* corners,
                                                    const size_t* face_sizes, size_t face_count,
                                                    const convexact_judge_options* options,
                                                    convexact_verdict** result);

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

/* Removes halfspaces of the points' hull, each time the one that adds the least volume, until
 * plane_count >= 4 are left or every further removal would leave the solid unbounded. All steps are
 * verified exactly. */
CONVEXACT_API convexact_status convexact_simplify(const double* points, size_t point_count,
                                                  size_t plane_count, convexact_solid** result);

/* The measure to which each removal adds the least. Values do not change; more may be added. */
typedef enum convexact_cost {
  CONVEXACT_COST_VOLUME = 0,
  CONVEXACT_COST_AREA = 1,      /* Of the surface. */
  CONVEXACT_COST_MEAN_WIDTH = 2 /* Of the distances of parallel planes around the solid. */
} convexact_cost;

/* The same, where each removal adds the least to the measure `cost`, a convexact_cost. Volumes and
 * areas are compared exactly. Mean widths that enclosures of tie_bits bits cannot tell apart count
 * as equal even without a proof; tie_bits is 128 to 1048576, or 0 for 4096. If several removals
 * cost the same, the first in canonical order is made. */
CONVEXACT_API convexact_status convexact_simplify_by(const double* points, size_t point_count,
                                                     size_t plane_count, int cost, long tie_bits,
                                                     convexact_solid** result);

/* The search after the removals for a smaller measure with as many planes. */
typedef enum convexact_search {
  CONVEXACT_SEARCH_NONE = 0,
  CONVEXACT_SEARCH_WALK = 1, /* Exchanges of a plane for that of a facet next to it. */
  CONVEXACT_SEARCH_LOCAL = 2 /* The same, then random exchanges, each with a walk after it. */
} convexact_search;

typedef struct convexact_simplify_options {
  size_t size;   /* sizeof(convexact_simplify_options). */
  int cost;      /* A convexact_cost. */
  long tie_bits; /* As of convexact_simplify_by. */
  int search;    /* A convexact_search. Every exchange is proven to make the measure smaller. */
  size_t kicks;  /* Of CONVEXACT_SEARCH_LOCAL: how many random exchanges. 0 for 200. */
  uint64_t seed; /* Of these; the same one leads to the same planes everywhere. 0 for 1. */
} convexact_simplify_options;

/* The same with options. */
CONVEXACT_API convexact_status convexact_simplify_with(const double* points, size_t point_count,
                                                       size_t plane_count,
                                                       const convexact_simplify_options* options,
                                                       convexact_solid** result);

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

/* Where the parts come from: of the first two they are the hulls of clusters of triangles. */
typedef enum convexact_method {
  CONVEXACT_HACD = 0, /* Neighbouring triangles are merged. */
  CONVEXACT_ACD = 1,  /* The surface is split at notches. */
  CONVEXACT_CUT = 2,  /* The solid is cut by planes: the parts hold it, and none is farther from it
                         than `distance`, proven. Reads no `concavity`, `measure` or guard. */
  CONVEXACT_AUTO = 3  /* CUT for closed surfaces; for open ones HACD with a guard and merging; and
                         HACD if `concavity`, `measure`, guard_reach or merge_reach is given. */
} convexact_method;

/* Of CONVEXACT_HACD: where concavity is measured. */
typedef enum convexact_concavity {
  CONVEXACT_CONCAVITY_SURFACE = 0, /* At every point of the triangles. */
  CONVEXACT_CONCAVITY_VERTICES = 1 /* At their corners only. */
} convexact_concavity;

/* What becomes of clusters that lie in a plane. */
typedef enum convexact_flat {
  CONVEXACT_FLAT_AUTO = 0,    /* As thicken; but a mesh in one plane is CONVEXACT_NO_INTERIOR. */
  CONVEXACT_FLAT_THICKEN = 1, /* They are made solid, by about 2^-20 of the diameter. */
  CONVEXACT_FLAT_KEEP = 2,    /* A polygon, a segment or a point. */
  CONVEXACT_FLAT_MERGE = 3    /* They join the neighbour with which they are least concave; a mesh
                                 in one plane is CONVEXACT_NO_INTERIOR. */
} convexact_flat;

/* The options of `convexact decompose`, with its defaults; docs/usage.md describes each. */
typedef struct convexact_decompose_options {
  size_t size;           /* sizeof(convexact_decompose_options). */
  int method;            /* A convexact_method. */
  const char* concavity; /* The largest one allowed, taken as spelled: "3%" or "0.03d" for a share
                            of the diameter, from 0 to 1; "0.05" for a length. NULL for "3%". */
  size_t max_parts;      /* May lead beyond that concavity. 0 for no limit; as few as the mesh has
                            components, or CONVEXACT_INVALID_ARGUMENT. */
  int measure;           /* A convexact_concavity. */
  size_t faces;          /* Planes to keep in each part, >= 4; 0 for all. */
  size_t total_faces;    /* Instead of `faces`: in all parts together, >= 4 for each; 0 for all. */
  int flat;              /* A convexact_flat. */
  int precision;         /* The numbers of the parts: 64 for doubles, 32 for doubles that are
                            floats. 0 for 64. */
  int no_volumes;        /* Not 0: do not measure volumes, which may take most of the time. */
  int exact_volumes;     /* Not 0: measure them as fractions, too, which may be very long. */
  uint64_t seed;         /* Of random orders. No result depends on it. */
  int for_tree;          /* Not 0: find the merges that would come next, for a tree of the parts. */
  int guard_reach;      /* Not 0: no part is made that is farther from the solid than `distance`. */
  int merge_reach;      /* Not 0: parts are merged in the end as long as they are not farther. */
  const char* distance; /* For these two and CUT, spelled like `concavity`, and above 0. NULL for
                           "3%". */
  const char* max_excess;   /* Of CUT: how much larger the parts' volumes together may be than the
                               solid's, "20%". NULL for no limit. */
  int effort;               /* Of CUT: 0 normal, 1 low, 2 high. */
  size_t max_part_vertices; /* Corners that a part may have, >= 4; 0 for any number. */
  int disjoint;             /* Of CUT, not 0: parts have no common interior, but for roundings. */
} convexact_decompose_options;

typedef struct convexact_decomposition convexact_decomposition;

/* Triangle t has the corners triangles[3 t] to [3 t + 2], indices of points from 0, counter-
 * clockwise from outside; triangles are turned where the solid needs it. Every triangle gets an
 * owner, a part that holds it: proven on the numbers of the part as they are. So the parts cover
 * the surface, but need not cover the solid. A point that no triangle uses goes to the part that is
 * nearest to it. CONVEXACT_NO_INTERIOR if all triangles lie in one plane, unless `flat` is thicken
 * or keep; CONVEXACT_UNREPRESENTABLE if the precision cannot hold a part. */
CONVEXACT_API convexact_status convexact_decompose(const double* points, size_t point_count,
                                                   const uint32_t* triangles, size_t triangle_count,
                                                   const convexact_decompose_options* options,
                                                   convexact_decomposition** result);

CONVEXACT_API size_t convexact_decomposition_part_count(const convexact_decomposition* result);
/* 1 if the concavity of every part is within the limit, else 0: max_parts, flat triangles that were
 * merged, and notches that cannot be split may lead beyond it. */
CONVEXACT_API int convexact_decomposition_eps_holds(const convexact_decomposition* result);
/* With CUT, guard_reach or merge_reach: 1 if no point of a part is farther from the solid than the
 * distance, proven; else 0. */
CONVEXACT_API int convexact_decomposition_reach_holds(const convexact_decomposition* result);
/* For each triangle the part that owns it; UINT32_MAX of a triangle that several parts of CUT hold
 * together. */
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

/* The options of `convexact verify --union`; docs/verdicts.md#CODE describes each claim. */
typedef struct convexact_parts_options {
  size_t size;               /* sizeof(convexact_parts_options). */
  const char* claims;        /* The claims to decide, "covers-surface,parts-disjoint". NULL for all
                                but covers-solid, parts-disjoint and parts-needed. */
  const char* tolerance;     /* As in convexact_judge_options. */
  size_t max_parts;          /* 0: not asked. The limits below are for each part. */
  size_t max_facets;         /* As meant: coplanar up to rounding. 0: not asked. */
  size_t max_vertices;       /* 0: not asked. */
  size_t max_facet_vertices; /* 0: not asked. */
  const char* points;        /* As in convexact_judge_options. */
  const char* distance;      /* Asks whether no point of a part is farther from the solid, and
                                whether they hold it: "3%" of the diameter, or a length. NULL: not
                                asked. */
} convexact_parts_options;

/* A mesh as convexact_decompose takes it; without triangles (triangle_count 0; triangles may be
 * NULL) its points are to be covered. Part k has vertex_counts[k] >= 1 vertices, and is their hull;
 * vertices holds those of all parts, one after another. It may have faces: face_counts[k] of them,
 * whose sizes and corners, indices of the vertices of part k from 0, follow those of the parts
 * before, as in convexact_judge_mesh. Without any, face_counts is NULL, and so may be the others.
 *
 * The mesh may be flat. Any fault of the parts' shape is a violated claim, whose sentence calls
 * part 3 part_3. */
CONVEXACT_API convexact_status convexact_verify_parts(
    const double* points, size_t point_count, const uint32_t* triangles, size_t triangle_count,
    const double* vertices, const size_t* vertex_counts, size_t part_count, const uint32_t* corners,
    const size_t* face_sizes, const size_t* face_counts, const convexact_parts_options* options,
    convexact_verdict** result);

/* ---- Parts under a tree of hulls ------------------------------------------------------------- */

/* The options of `convexact bvh`; docs/hull-trees.md describes each. */
typedef struct convexact_tree_options {
  size_t size;       /* sizeof(convexact_tree_options). */
  size_t faces;      /* Planes to keep of each branch, >= 4; 0 for all. */
  size_t leaf_faces; /* Planes to keep of each part, >= 4; 0 for all. */
  int precision;     /* As in convexact_decompose_options. */
} convexact_tree_options;

typedef struct convexact_tree convexact_tree;

/* Where there is no such node or part. */
#define CONVEXACT_NONE SIZE_MAX

/* A binary tree whose leaves are the parts: by the splits of CONVEXACT_ACD, by the merges that
 * CONVEXACT_HACD would make next if `for_tree` asked for them, and by the least common hull where
 * neither joins parts. Each hull holds the hulls of its children: proven on their numbers as they
 * are. Parts that are flat are made solid. */
CONVEXACT_API convexact_status convexact_decomposition_tree(const convexact_decomposition* parts,
                                                            const convexact_tree_options* options,
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
    const convexact_parts_options* options, convexact_verdict** result);

#ifdef __cplusplus
}
#endif

#endif /* CONVEXACT_H */
