# SPDX-License-Identifier: MIT
"""Conditions that no input fails alone, each with the reason; see conditions.py."""
IMPLIED = {
    ('src/stored/stored_planes.cpp', '!std::visit([&](const auto& proof) { return check(cone, proof); }, outcome)'):
        'find_recession() proves its answers, so no input fails this: it refuses a defect of the solver.',
    ('src/check/decomposition.hpp', 'words_.take_if("convexact-proof")'):
        'prove_by_kind() hands over only proofs that begin with this word: it is read again, to get past it.',
    ('src/check/decomposition.hpp', 'words_.take_if("4")'):
        'prove_by_kind() hands over only proofs of this version: it is read again, to get past it.',
    ('src/check/partition.hpp', 'words_.take_if("convexact-proof")'):
        'prove_by_kind() hands over only proofs that begin with this word: it is read again, to get past it.',
    ('src/check/partition.hpp', 'words_.take_if("6")'):
        'prove_by_kind() hands over only proofs of this version: it is read again, to get past it.',
    ('src/check/partition.hpp', 'both.size() == 2'):
        'A region is convex, as planes cut it from a box: each corner of a cut has two sides. It refuses a defect.',
    ('src/check/partition.hpp', 'cut.corners.size() <= beside.size()'):
        'As above: the sides of a cut are one cycle. It keeps a defect from walking for ever.',
    ('src/check/mesh_file.hpp', 'size <= bytes_.size()'):
        'A file that is too short ends while its triangles are read, which refuses it: kept for what it says.',
    ('src/check/surface.hpp', '!file.is_mesh'):
        'A file without faces has fewer than the proof, which has a triangle: kept for what it says.',
}
