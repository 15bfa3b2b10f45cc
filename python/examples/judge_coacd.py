# SPDX-License-Identifier: MIT
"""judge_coacd.py MESH - do the parts of CoACD hold the mesh? Needs the package coacd."""
import sys

import coacd  # type: ignore[import-not-found, import-untyped, unused-ignore]

import convexact as cx


def main() -> int:
    vertices, faces = cx.read_mesh(sys.argv[1], triangles=True)
    parts = coacd.run_coacd(coacd.Mesh(vertices, faces), threshold=0.05)
    verdict = cx.verify_parts((vertices, faces), parts)
    print(verdict)
    ours = cx.decompose((vertices, faces), distance="3%")
    print(f"{len(parts)} parts of CoACD; {len(ours)} of convexact, which hold the {ours.covers}")
    return 0 if verdict.ok else 1


if __name__ == "__main__":
    sys.exit(main())
