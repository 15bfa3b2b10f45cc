/* SPDX-License-Identifier: MIT */
/* example.c - the C interface from end to end:
 *
 *     cc example.c -lconvexact_c -o example && ./example
 *
 * encloses some points in few halfspaces of little area, asks whether these enclose the points, and
 * asks the same of a box that does not; then it judges the faces of that box, and lets a quarter
 * pass. */
#include <convexact.h>
#include <stdio.h>
#include <stdlib.h>

/* The corners of a cube with one corner cut off. */
static const double points[][3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {0, 0, 4},
                                   {4, 0, 4}, {0, 4, 4}, {3, 4, 4}, {4, 3, 4}, {4, 4, 3}};
static const size_t point_count = sizeof points / sizeof points[0];

static void require(convexact_status status) {
  if (status == CONVEXACT_OK) return;
  fprintf(stderr, "convexact: %s\n", convexact_message());
  exit(EXIT_FAILURE);
}

/* Prints the verdict; returns whether all points are inside. */
static int report(const convexact_containment* verdict) {
  if (convexact_containment_holds(verdict)) {
    printf("  all points are inside\n");
    return 1;
  }
  printf("  %zu points are outside; point %zu is worst, beyond plane %zu (%s)\n",
         convexact_containment_outside(verdict), convexact_containment_point(verdict),
         convexact_containment_plane(verdict), convexact_containment_plane_text(verdict));
  printf("  by %.17g; the square of that is exactly %s\n", convexact_containment_distance(verdict),
         convexact_containment_squared_distance(verdict));
  return 0;
}

/* Six halfspaces around the points. */
static int enclose(void) {
  convexact_solid* solid;
  require(convexact_simplify(&points[0][0], point_count, "faces=6 cost=area", &solid));
  const size_t plane_count = convexact_solid_plane_count(solid);
  double* planes = malloc(4 * plane_count * sizeof *planes);
  if (planes == NULL) exit(EXIT_FAILURE);
  printf("%zu points in %zu halfspaces, by area, with %zu ties:\n", point_count, plane_count,
         convexact_solid_tie_count(solid));
  for (size_t i = 0; i < plane_count; ++i) {
    double* plane = planes + 4 * i;
    convexact_solid_plane(solid, i, plane);
    printf("  %g x + %g y + %g z + %g <= 0, exactly %s\n", plane[0], plane[1], plane[2], plane[3],
           convexact_solid_plane_text(solid, i));
  }
  convexact_solid_free(solid);

  convexact_containment* verdict;
  require(convexact_verify_planes(&points[0][0], point_count, planes, plane_count, &verdict));
  free(planes);
  const int holds = report(verdict);
  convexact_containment_free(verdict);
  return holds;
}

/* A box that another program wrote: its top is at 3.75. */
static int verify_box(void) {
  const double box[][3] = {{0, 0, 0},    {4, 0, 0},    {0, 4, 0},    {4, 4, 0},
                           {0, 0, 3.75}, {4, 0, 3.75}, {0, 4, 3.75}, {4, 4, 3.75}};
  convexact_containment* verdict;
  require(convexact_verify_vertices(&points[0][0], point_count, &box[0][0], 8, &verdict));
  printf("the box that ends at 3.75:\n");
  const int holds = report(verdict);
  convexact_containment_free(verdict);
  return holds;
}

/* The same box as a mesh, with its sides, where a quarter may be missing. Prints every claim. */
static int judge_box(void) {
  const double box[][3] = {{0, 0, 0},    {4, 0, 0},    {0, 4, 0},    {4, 4, 0},
                           {0, 0, 3.75}, {4, 0, 3.75}, {0, 4, 3.75}, {4, 4, 3.75}};
  const uint32_t sides[] = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
  const size_t sizes[] = {4, 4, 4, 4, 4, 4};
  convexact_verdict* verdict;
  require(convexact_judge_mesh(&points[0][0], point_count, NULL, 0, &box[0][0], 8, sides, sizes, 6,
                               "tolerance=0.25", &verdict));
  printf("the same box as a mesh, with a tolerance of 0.25:\n");
  for (size_t i = 0; i < convexact_verdict_claim_count(verdict); ++i) {
    printf("  %-20s %-15s %s\n", convexact_verdict_claim_name(verdict, i),
           convexact_verdict_claim_status(verdict, i),
           convexact_verdict_claim_sentence(verdict, i));
  }
  const int holds = convexact_verdict_holds(verdict);
  convexact_verdict_free(verdict);
  return holds;
}

int main(void) {
  printf("convexact %s\n", convexact_version());
  return enclose() && !verify_box() && judge_box() ? EXIT_SUCCESS : EXIT_FAILURE;
}
