# SPDX-License-Identifier: MIT
"""Finds the definitions of functions and constants in the sources, as clang-format lays them out, by name:
what is to be broken is named by the function it is in, so that it is found wherever that moves."""
import functools
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
_NAME = re.compile(r'([A-Za-z_~][\w:~]*(?:<[\w, :]*>)?(?:::~?\w+)?|operator\S{1,3})\s*\($')
_NO_FUNCTION = re.compile(r'\s*(?:template\s*<[^{]*>\s*)?(?:namespace|class|struct|enum|union|extern "C")\b[^()]*$')
_CONSTANT = re.compile(r'\b(k[A-Z]\w*)\b[^;(){}]*=')


def blank(text):
    """The text with comments and quoted text blanked out, so that only braces of code remain."""
    def blank(match):
        return re.sub(r'[^\n]', ' ', match.group(0))
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', blank, text, flags=re.S)


def _name_of(head):
    """The name of the function whose definition begins with `head`; '' if it is none."""
    if _NO_FUNCTION.match(head) or '(' not in head:
        return ''
    depth = 0
    for at, char in enumerate(head):  # the first parenthesis outside of template arguments
        depth += (char == '<') - (char == '>' and head[at - 1] != '-')
        if char == '(' and (depth <= 0 or 'operator' in head[:at]):
            found = _NAME.search(head[:at + 1])
            return found.group(1) if found else ''
    return ''


def _end(code, start):
    """Behind the brace that closes the one at `start`."""
    depth = 0
    for at in range(start, len(code)):
        depth += (code[at] == '{') - (code[at] == '}')
        if depth == 0:
            return at + 1
    return len(code)


def _inside(code, start, end, scope):
    """(name, start, end) of the functions between two places of a scope, those of its classes included."""
    begun = start
    at = start
    while at < end:
        char = code[at]
        if char == ';' or char == '}':
            begun = at + 1
        elif char == '{' and code.count('(', begun, at) > code.count(')', begun, at):
            at = _end(code, at) - 1  # of a default argument
        elif char == '{':
            head = code[begun:at].strip()
            head = re.sub(r'^(?:#[^\n]*\n|\s|public:|private:|protected:)+', '', head)
            close = _end(code, at)
            name = _name_of(head)
            if name:
                yield '::'.join([*scope, name]), begun, close
            elif _NO_FUNCTION.match(head):
                kind = re.search(r'\b(class|struct|union)\s+(?:\w+\s+)*?(\w+)(?:\s+final)?\s*(?::[^:]|$)', head)
                yield from _inside(code, at + 1, close - 1, scope + ([kind.group(2)] if kind else []))
            at = close - 1
            if name or code[at + 1:at + 2] != ';':
                begun = close
        at += 1


def definitions(path):
    """(name, start, end) of each function in a file, then of each constant k... with its statement."""
    code = blank(path.read_text(encoding='utf-8'))
    yield from _inside(code, 0, len(code), [])
    for match in _CONSTANT.finditer(code):
        yield match.group(1), code.rfind('\n', 0, match.start()) + 1, code.find(';', match.end()) + 1


def sources(folders=('src', 'include')):
    for folder in folders:
        yield from sorted(path for path in (ROOT / folder).rglob('*') if path.suffix in ('.cpp', '.hpp'))


@functools.cache
def _of_room(room):
    """(file, name, start, end) of every definition in a room."""
    return [(path, *found) for path in sources() if room in ('', path.relative_to(ROOT).parts[1])
            for found in definitions(path)]


def places(anchor):
    """Where an anchor, room/name, is: (file, start, end) for each definition of that name in the room."""
    room, _, name = anchor.rpartition('/')
    return [(path, start, end) for path, found, start, end in _of_room(room)
            if found == name or found.endswith('::' + name)]
