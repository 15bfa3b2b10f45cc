# SPDX-License-Identifier: MIT
"""The paper's own program, as its package of the Python index has it, on the same doubles as ours.

Run by the Python of an environment: a JSON object on standard input, one on standard output.
Input: {"mesh": OBJ, "counts": [18, 12], "cost": "volume", "folder": where OBJ files go, "order": bool, "rounds": N}
Output: {"facets": of its hull, "made": {"18": {"file", "halfspaces"} or {"error"}}, "seconds": [of each round],
"stages": {name: [of each round]}, "order": planes in the order of removal}
"""
import fractions
import json
import sys
import time

STAGES = ('t_primal_hull', 't_dual_hull', 't_queue_init', 't_last_simplify')


def read_obj(path):
    points, faces = [], []
    with open(path, encoding='utf-8') as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ['v']:
                points.append([float(x) for x in words[1:4]])
            elif words[:1] == ['f']:
                corners = [int(word.split('/')[0]) - 1 for word in words[1:]]
                faces += [[corners[0], corners[k - 1], corners[k]] for k in range(2, len(corners))]
    used = sorted({corner for face in faces for corner in face})
    place = {old: new for new, old in enumerate(used)}
    return [points[k] for k in used], [[place[k] for k in face] for face in faces]


def polygons_of(indices, ends):
    return [indices[ends[k]:ends[k + 1]].tolist() for k in range(len(ends) - 1)]


def plane_through(corners):
    """The halfspace n.x + d <= 0 through three points of the input, in integers, its corners counter-clockwise from outside; none if
    all are on a line."""
    a = corners[0]
    for b, c in zip(corners[1:], corners[2:]):
        u, v = ([q - p for p, q in zip(a, other)] for other in (b, c))
        normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        if any(normal):
            row = [*normal, -sum(x * y for x, y in zip(normal, a))]
            scale = max(x.denominator for x in row)
            return [str(int(x * scale)) for x in row]  # denominators are powers of two
    return None


def planes_by_id(state, points):
    """Facets of its hull as exact planes of the input's points, each corner read as the nearest of these."""
    import numpy as np
    places, indices, ends = state.get_primal_mesh()
    cloud, planes = np.array(points), {}
    nearest = [tuple(map(fractions.Fraction, cloud[np.argmin(((cloud - p) ** 2).sum(axis=1))].tolist())) for p in places]
    for name, polygon in zip(state.dual_vertex_ids().tolist(), polygons_of(indices, ends)):
        corners = []
        for k in polygon:
            if nearest[k] not in corners:
                corners.append(nearest[k])
        planes[name] = plane_through(corners) if len(corners) > 2 else None
    return planes


def write_obj(path, places, polygons):
    with open(path, 'w', encoding='utf-8') as out:
        out.writelines('v ' + ' '.join(map(repr, map(float, place))) + '\n' for place in places)
        out.writelines('f ' + ' '.join(str(k + 1) for k in polygon) + '\n' for polygon in polygons)


def main():
    import numpy as np
    import pchs
    asked = json.load(sys.stdin)
    points, faces = read_obj(asked['mesh'])
    arrays = np.asfortranarray(points, dtype=np.float64), np.asfortranarray(faces, dtype=np.int32)
    cost = getattr(pchs.CostFunction, asked.get('cost', 'volume'))
    told = {'made': {}, 'seconds': [], 'stages': {name: [] for name in STAGES}}
    for _ in range(asked.get('rounds', 1)):
        start = time.perf_counter()
        state = pchs.ConvexHullSimplification(*arrays, cost_function=cost)
        told['facets'] = state.num_dual_vertices()
        planes = planes_by_id(state, points) if asked.get('order') else None
        for count in sorted(asked['counts'], reverse=True):
            state.simplify_to(count)
            if asked.get('folder') is None:
                continue
            places, indices, ends = state.get_primal_mesh()
            path = f'{asked["folder"]}/pchs-{count}.obj'
            write_obj(path, places, polygons_of(indices, ends))
            told['made'][count] = {'file': path, 'halfspaces': state.num_dual_vertices()}
        told['seconds'].append(time.perf_counter() - start)
        for name in STAGES:
            told['stages'][name].append(getattr(state.stats(), name))
        if planes is not None:
            told['order'] = [planes[name] for name in state.popped_dual_vertex_ids().tolist()]
    json.dump(told, sys.stdout)


if __name__ == '__main__':
    main()
