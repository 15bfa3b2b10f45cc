#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The teaser of [Jacobson2026]: a hull of over 2,000 faces, at 18 faces, and at 6 against an oriented box.

Usage: teaser.py --convexact PROGRAM [--meshes FOLDER] [--json FILE]

The paper's model is not at hand; the bunny stands in.
"""
import sys

from support.experiment import Experiment, compared, ratio


def main():
    experiment = Experiment(__file__, 'the teaser', __doc__)
    for name, mesh in experiment.meshes(('bunny',)):
        many = experiment.run('simplify', mesh, '--faces', 18)
        few = compared(experiment, mesh, 6, ('greedy', 'obb'))
        ours, box = few['greedy']['volume']['value'], few['obb']['volume']['value']
        facets = many['input']['halfspaces']
        experiment.claim('a hull of over 2,000 faces', f'{facets:,} of the {name}', facets > 2000)
        experiment.claim('at 18 faces its volume grows by less than 5%', f'by {100 * (ratio(many) - 1):.3f}%',
                         ratio(many) < 1.05)
        experiment.claim('at 6 faces 1.61 times the volume, less than the 1.72 of an oriented box',
                         f'{ours:.5f} and {box:.5f}', ours < box)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
