#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""examples.py PREFIX - builds and runs every C++ block of README.md and docs/ against an installed library.

A block with main() is a program of its own and runs in a folder with the shipped meshes. The other
blocks are bodies of functions; those of one page are built as one program. A block that is followed
by a ```text block must print exactly that text. Blocks that belong to a file of tests/ (named in a
comment above them) are built there.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BLOCK = re.compile(r'(<!-- (\S+) -->\n)?```cpp\n(.*?)```\n(?:\n```text\n(.*?)```\n)?', re.S)
SEPARATOR = '----\n'


def blocks(page):
    """Source and expected output (None if the page does not say) of each block that is built here."""
    for match in BLOCK.finditer(page.read_text(encoding='utf-8')):
        if match.group(2) is None:
            yield match.group(3), match.group(4)


def flags(prefix):
    config = next(pathlib.Path(prefix).rglob('convexact.pc'))
    environment = dict(os.environ, PKG_CONFIG_PATH=str(config.parent))
    return subprocess.run(['pkg-config', '--cflags', '--libs', '--static', 'convexact'], env=environment, check=True,
                          capture_output=True, text=True).stdout.split()


def run(source, folder, link):
    """What the program prints. Its folder holds the shipped meshes."""
    (folder / 'example.cpp').write_text(source, encoding='utf-8')
    compiler = os.environ.get('CXX', 'c++').split()
    subprocess.run(compiler + ['-std=c++20', 'example.cpp', '-o', 'example'] + link, cwd=folder, check=True)
    return subprocess.run(['./example'], cwd=folder, check=True, capture_output=True, text=True).stdout


def joined(bodies):
    """One program that runs the bodies, with a line between what each prints."""
    source = '#include <convexact/convexact.hpp>\n\n#include <algorithm>\n#include <iostream>\n\nusing namespace convexact;\n\n'
    for number, body in enumerate(bodies):
        source += f'static void example_{number}() {{\n{body}}}\n\n'
    calls = f'std::cout << "{SEPARATOR[:-1]}\\n";\n'.join(f'  example_{number}();\n' for number in range(len(bodies)))
    return source + 'int main() {\n' + calls + '}\n'


def check_page(page, link):
    """Returns how many blocks were run; raises where one does not build, fails or prints otherwise."""
    whole, bodies = [], []
    for source, expected in blocks(page):
        (whole if 'int main(' in source else bodies).append((source, expected))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for mesh in (ROOT / 'tests' / 'data').glob('*.obj'):
            (folder / mesh.name).symlink_to(mesh)
        printed = [run(source, folder, link) for source, _ in whole]
        if bodies:
            printed += run(joined([source for source, _ in bodies]), folder, link).split(SEPARATOR)
    for (source, expected), text in zip(whole + bodies, printed, strict=True):
        if expected is not None and expected != text:
            sys.exit(f'{page.relative_to(ROOT)}: this block prints\n{text}and not\n{expected}{source}')
    return len(printed)


def main():
    link = flags(sys.argv[1])
    count = 0
    for page in [ROOT / 'README.md'] + sorted((ROOT / 'docs').rglob('*.md')):
        count += check_page(page, link)
    if count < 2:
        sys.exit('no C++ blocks were found')
    print(f'{count} C++ blocks of the documents: build, run, print what the pages say')


if __name__ == '__main__':
    main()
