/* SPDX-License-Identifier: MIT */
#include <convexact.h>
#include <stdio.h>
#include <stdlib.h>

/* An L, one high: its outline at the bottom, then at the top. */
static const double points[][3] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0},
                                   {1, 2, 0}, {0, 2, 0}, {0, 0, 1}, {2, 0, 1},
                                   {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};
static const uint32_t triangles[][3] = {{3, 5, 4},  {3, 0, 5},  {3, 1, 0},   {3, 2, 1}, {9, 10, 11},
                                        {9, 11, 6}, {9, 6, 7},  {9, 7, 8},   {0, 1, 7}, {0, 7, 6},
                                        {1, 2, 8},  {1, 8, 7},  {2, 3, 9},   {2, 9, 8}, {3, 4, 10},
                                        {3, 10, 9}, {4, 5, 11}, {4, 11, 10}, {5, 0, 6}, {5, 6, 11}};

static void require(convexact_status status) {
  if (status == CONVEXACT_OK) return;
  fprintf(stderr, "convexact: %s\n", convexact_message());
  exit(EXIT_FAILURE);
}

int main(void) {
  convexact_decomposition* parts;
  require(convexact_decompose(&points[0][0], 12, &triangles[0][0], 20, "concavity=5%", &parts));
  double solid[2], both[2];
  convexact_decomposition_volume(parts, CONVEXACT_VOLUME_SOLID, solid);
  convexact_decomposition_volume(parts, CONVEXACT_VOLUME_UNION, both);
  printf("%zu parts for a solid of volume %g; their union has %g\n",
         convexact_decomposition_part_count(parts), solid[0], both[0]);
  for (size_t k = 0; k < convexact_decomposition_part_count(parts); ++k) {
    printf("part %zu: %zu vertices, %zu faces, concavity %g\n", k,
           convexact_decomposition_vertex_count(parts, k),
           convexact_decomposition_face_count(parts, k),
           convexact_decomposition_concavity(parts, k));
  }

  /* Does the first part alone hold the L? */
  const size_t count = convexact_decomposition_vertex_count(parts, 0);
  convexact_verdict* verdict;
  require(convexact_verify_parts(&points[0][0], 12, &triangles[0][0], 20,
                                 convexact_decomposition_vertices(parts, 0), &count, 1, NULL, NULL,
                                 NULL, NULL, &verdict));
  for (size_t i = 0; i < convexact_verdict_claim_count(verdict); ++i) {
    if (convexact_verdict_claim_status(verdict, i)[0] == 'v') {
      printf("%s: %s\n", convexact_verdict_claim_name(verdict, i),
             convexact_verdict_claim_sentence(verdict, i));
    }
  }
  convexact_verdict_free(verdict);
  convexact_decomposition_free(parts);
  return EXIT_SUCCESS;
}
