#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every figure of [Jacobson2026] with something to measure, one after another, as the page docs/reproduction.md.

Usage: all.py --convexact PROGRAM [--meshes FOLDER] [--json FOLDER] [--page FILE]

Nothing on the page is typed: it is made of the records that the experiments write (--json, by default into
build/reproduce). An experiment whose record is there already is not run again, unless --again is given.
"""
import argparse
import json
import pathlib
import subprocess
import sys

from support.experiment import AS_CLAIMED, DIFFERS, ROOT, markdown

# In the order of the figures. Others have papers or records of their own: icosahedron (figure 16), capsule (figure 8).
FIGURES = ('teaser', 'parts', 'teapot12', 'extreme', 'patch', 'timing', 'violin', 'costs12', 'lines', 'stability', 'inner',
           'kept')
HEAD = """# The figures of the paper, measured

Made by `./dev reproduce all` from the output of each experiment; nothing here is typed. *The paper* is
[Jacobson2026]. Most of its models are not at hand; [reproduce.md](reproduce.md) tells what stands in, and
has figures 8 (`capsule`) and 16 (`icosahedron`).

"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--convexact', required=True)
    parser.add_argument('--meshes', type=pathlib.Path)
    parser.add_argument('--json', type=pathlib.Path, default=ROOT / 'build' / 'reproduce')
    parser.add_argument('--page', type=pathlib.Path, default=ROOT / 'docs' / 'reproduction.md')
    parser.add_argument('--again', action='store_true', help='run experiments whose records are there already')
    options = parser.parse_args()
    records = []
    for name in FIGURES:
        script, file = pathlib.Path(__file__).with_name(name + '.py'), options.json / f'{name}.json'
        if not script.is_file():
            continue
        if options.again or not file.is_file():
            print(f'{name} ...', file=sys.stderr, flush=True)
            meshes = ['--meshes', options.meshes] if options.meshes else []
            subprocess.run([sys.executable, script, '--convexact', options.convexact, '--json', file, *meshes],
                           stdout=subprocess.DEVNULL, check=True)
        records.append(json.loads(file.read_text(encoding='utf-8')))
    verdicts = [claim['verdict'] for record in records for claim in record['claims']]
    summary = (f'{len(verdicts)} claims: {verdicts.count(AS_CLAIMED)} as claimed, {verdicts.count(DIFFERS)} differ, '
               f'{len(verdicts) - verdicts.count(AS_CLAIMED) - verdicts.count(DIFFERS)} cannot be compared.\n\n')
    page = HEAD + summary + '\n'.join(markdown(record) for record in records) + '\n[Jacobson2026]: references.md\n'
    options.page.write_text(page, encoding='utf-8')
    print(summary, end='')
    return 0


if __name__ == '__main__':
    sys.exit(main())
