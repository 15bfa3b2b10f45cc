#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every figure of [Jacobson2026] with something to measure, one after another, as the page
docs/results/reproduction.md.

Usage: all.py --convexact PROGRAM [--meshes FOLDER] [--json FOLDER] [--page FILE] [--again]

Nothing on the page is typed but the sentences at its top: it is made of the records that the experiments write (--json,
by default into build/reproduce). Their tables, the figures and the numbers of these go beside it, into
reproduction/. An experiment whose record is there already is not run again, unless --again is given.
"""
import argparse
import json
import pathlib
import subprocess
import sys

from support.experiment import AS_CLAIMED, CLAIM_HEAD, DIFFERS, ROOT, SAME_ORDER, markdown, table_lines
from support.peer_environment import Skipped, environment, require

# In the order of the figures. Others have papers or records of their own: icosahedron (figure 16), capsule (figure 8).
IDS = ('pchs', 'teaser', 'parts', 'teapot12', 'extreme', 'patch', 'timing', 'violin', 'corpus', 'costs12', 'lines', 'stability',
       'inner', 'kept')
MATPLOTLIB = '3.11.2'
HEAD = """# The figures of the paper, measured

Made by `./dev reproduce all`. *The paper* is [Jacobson2026], *its program* is `pchs` 0.1.0 of the Python index, on the
same doubles in the same run. Most of the paper's models are not at hand, so a number of other models is *as claimed*
only within the interval that is named, *of the same order* within a wider one, and *differs* otherwise.
[reproduce.md](../reproduce.md) tells what each experiment does, those of figures 8 (`capsule`) and 16 (`icosahedron`) included.

"""
FIGURES = (('violin.svg', 'corpus.csv', 'What is added to the volume of the hull: each violin is a method, its line the median.'),
           ('tightness.svg', 'corpus.csv', 'What is added to the volume of the hull, over the number of halfspaces.'),
           ('growth.svg', 'timing.csv', 'Time of the removals over the size of the hull.'))
OPEN = """## Open

- `tlg` adds 13% here and 44% in the paper. Its program has no collapses, so the two cannot be run side by side. Ours
  moves each plane inward until it touches the hull ([compare.md](../compare.md)). Tried: without that move the hulls of its
  vertices have a median of 1.15 (spot 1.147, teapot 1.220, bunny 1.181, suzanne 1.140, cow 1.145, homer 1.150, fandisk
  1.070, rocker-arm 1.293), so the move is not the reason. Fewer vertices for the same planes, or other models, may be.
- Dropping vertices keeps less than collapses onto ends in a few runs of `inner`; the paper prints no number, and its
  program has no inner hulls.
- No useful lower bound is known here for few halfspaces around a hull of hundreds: branch and bound proves the least volume
  for hulls of up to about 40 facets; in all 27 runs that it ended, the local search had found it (`corpus`).
"""


def run(name, options):
    """The record of an experiment: that of an earlier run, or a new one."""
    file = options.json / f'{name}.json'
    if options.again or not file.is_file():
        print(f'{name} ...', file=sys.stderr, flush=True)
        meshes = ['--meshes', options.meshes] if options.meshes else []
        script = pathlib.Path(__file__).with_name(name + '.py')
        subprocess.run([sys.executable, script, '--convexact', options.convexact, '--json', file, *meshes],
                       stdout=subprocess.DEVNULL, check=True)
    return json.loads(file.read_text(encoding='utf-8'))


def figures(options, target):
    """Draws them; @return their lines of the page."""
    try:
        python = environment()
        require(python, 'matplotlib', MATPLOTLIB)
    except Skipped as reason:
        return [f'No figures: {reason}', '']
    script = pathlib.Path(__file__).parent / 'support' / 'figures.py'
    subprocess.run([python, script, options.json, target], check=True)
    lines = []
    for image, numbers, words in FIGURES:
        if (target / image).is_file():
            lines += [f'![{words}]({target.name}/{image})', '', f'{words} Its [numbers]({target.name}/{numbers}).', '']
    return lines


def claims(records):
    """One table of all claims, by experiment."""
    return table_lines(['experiment', *CLAIM_HEAD.values()],
                       [[f'[{record["id"]}](reproduction/{record["id"]}.md)', *(claim[key] for key in CLAIM_HEAD)]
                        for record in records for claim in record['claims']])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--convexact', required=True)
    parser.add_argument('--meshes', type=pathlib.Path)
    parser.add_argument('--json', type=pathlib.Path, default=ROOT / 'build' / 'reproduce')
    parser.add_argument('--page', type=pathlib.Path, default=ROOT / 'docs' / 'results' / 'reproduction.md')
    parser.add_argument('--again', action='store_true', help='run experiments whose records are there already')
    options = parser.parse_args()
    target = options.page.parent / 'reproduction'
    target.mkdir(parents=True, exist_ok=True)
    records = [run(name, options) for name in IDS]
    for record in records:
        # A file links to the list of references from its own folder.
        text = markdown(record, '#').replace('[Jacobson2026]', '[Jacobson2026](../../references.md)')
        (target / f'{record["id"]}.md').write_text(text.rstrip() + '\n', encoding='utf-8')
    verdicts = [claim['verdict'] for record in records for claim in record['claims']]
    counts = {word: verdicts.count(word) for word in (AS_CLAIMED, SAME_ORDER, DIFFERS)}
    summary = f'{len(verdicts)} claims: ' + ', '.join(f'{count} {word}' for word, count in counts.items())
    summary += f', {len(verdicts) - sum(counts.values())} not comparable.'
    options.page.write_text('\n'.join([HEAD + summary, '', *figures(options, target), '## Claims', '', *claims(records), '', OPEN])
                            + '\n[Jacobson2026]: ../references.md\n', encoding='utf-8')
    print(summary)
    return 0


if __name__ == '__main__':
    sys.exit(main())
