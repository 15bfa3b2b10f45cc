#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes docs/reference/COMMAND.md from what `convexact COMMAND --help-all` prints, a page for each command.

  reference.py PROGRAM           writes the pages
  reference.py PROGRAM --check   exit 1 if a page is not what the program says, or if an option is
                                 explained nowhere in the manual"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMANDS = ['simplify', 'hull', 'decompose', 'bvh', 'query overlap', 'query rays', 'query false-positives', 'verify',
            'conform', 'shrink', 'generate', 'teach']
# Pages that explain options, with the manual.
MANUAL = ['usage', 'conform', 'generate', 'queries', 'teaching']
WIDTH = 30  # of the column of names
NEVER_EXPLAINED = {'--help', '--help-all'}


def help_of(program, command):
    words = command.split()
    text = subprocess.run([program, *words, '--help-all'], capture_output=True, text=True).stdout
    if not text:  # of commands that show everything at once
        text = subprocess.run([program, *words, '--help'], capture_output=True, text=True, check=True).stdout
    return text


def entries(lines):
    """(names and values, meaning) of each positional or option."""
    found = []
    for line in lines:
        if line.startswith(' ' * WIDTH):
            found[-1][1] = (found[-1][1] + ' ' + line.strip()).strip()
        elif len(line) > WIDTH and line[WIDTH - 1] == ' ':
            found.append([line[:WIDTH].strip(), line[WIDTH:].strip()])
        else:
            found.append([line.strip(), ''])
    return found


def sentence(text):
    return text[0].upper() + text[1:] + '.'


def cell(text):
    return text.replace('|', '\\|')


def row(name, meaning):
    name, *needs = re.split(r' (?=(?:Needs|Excludes|REQUIRED):?)', name)
    words = name.split(' ', 1)
    values = words[1] if len(words) > 1 else ''
    default = re.search(r'=([^ =]+)$', values)
    if default:
        values = values[:default.start()]
    marked = re.search(r'(?:^|\|)([\w.-]+)\*', values)
    usual = default.group(1) if default else marked.group(1) if marked else ''
    said = re.search(r' \(default: ([^()]*)\)$', meaning)
    if said:
        usual, meaning = said.group(1), meaning[:said.start()]
    meaning = meaning.replace(' (* is the default)', '')
    values = values.replace('*', '')
    values = re.sub(r'^INT:INT in \[(\d+) - (\d+)\]$', r'\1 to \2', values)
    values = re.sub(r'^TEXT:\{(.*)\}$', lambda m: m.group(1).replace(',', '|'), values)
    for need in needs:
        meaning += '; ' + need.strip().lower() if need else ''
    option = ', '.join(words[0].split(','))
    return f'| `{cell((option + " " + values).strip())}` | {cell(meaning)} | {cell(usual)} |'


def page(program, command):
    lines = help_of(program, command).rstrip('\n').split('\n')
    usage = next(i for i, line in enumerate(lines) if line.startswith('Usage: '))
    out = [f'# convexact {command}', '', sentence(' '.join(lines[:usage]).strip()), '',
           '```', lines[usage].removeprefix('Usage: ').replace(program, 'convexact'), '```', '']
    section, taken, rest = None, {}, []
    for line in lines[usage + 1:]:
        if line in ('Positionals:', 'Options:', 'Further options:'):
            section = taken.setdefault(line, [])
        elif section is not None and line.startswith('  ') and not rest:
            section.append(line)
        elif line or rest:
            rest.append(line)
    for title, heading in [('Positionals:', 'argument'), ('Options:', 'option'), ('Further options:', 'further option')]:
        rows = [row(*entry) for entry in entries(taken.get(title, [])) if '--help' not in entry[0]]
        if rows:
            out += [f'| {heading} | meaning | default |', '|---|---|---|', *rows, '']
    out += ['```text', *rest, '```', ''] if rest else []
    out += [f'Written by `./dev docs` from what `convexact {command} --help-all` prints; the '
            f'[manual](../usage.md) explains more.']
    return '\n'.join(out) + '\n'


def unexplained(text, manual):
    options = set(re.findall(r'^  (?:-\w,)?(--[\w-]+)', text, re.MULTILINE))
    return sorted(o for o in options - NEVER_EXPLAINED if not re.search(re.escape(o) + r'(?![\w-])', manual))


def main():
    program, checks = sys.argv[1], '--check' in sys.argv
    manual = '\n'.join((ROOT / 'docs' / f'{name}.md').read_text(encoding='utf-8') for name in MANUAL)
    wrong = []
    folder = ROOT / 'docs' / 'reference'
    folder.mkdir(exist_ok=True)
    for command in COMMANDS:
        path = folder / (command.replace(' ', '-') + '.md')
        text = page(program, command)
        wrong += [f'convexact {command} {option} is explained on no page of the manual'
                  for option in unexplained(help_of(program, command), manual)]
        if not checks:
            path.write_text(text, encoding='utf-8')
        elif not path.exists() or path.read_text(encoding='utf-8') != text:
            wrong.append(f'{path.relative_to(ROOT)} is not what the program says; ./dev docs writes it')
    print('\n'.join(wrong) if wrong else f'{len(COMMANDS)} pages are what the program says, and every option is explained')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
