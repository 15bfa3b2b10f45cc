# SPDX-License-Identifier: MIT
"""The mutants of a C++ source: one token changed, or one statement left out, at a time.

Works on text as clang-format prints it: binary operators stand between blanks, template brackets do not."""
import re

SWAPS = {' < ': [' <= ', ' >= '], ' <= ': [' < '], ' > ': [' >= ', ' <= '], ' >= ': [' > '], ' == ': [' != '],
         ' != ': [' == '], ' + ': [' - '], ' - ': [' + '], ' * ': [' + '], ' / ': [' * '], ' % ': [' / '],
         ' && ': [' || '], ' || ': [' && '], ' & ': [' | '], ' | ': [' & '], ' << ': [' >> '], ' >> ': [' << '],
         ' += ': [' -= '], ' -= ': [' += '], ' &= ': [' |= '], ' |= ': [' &= ']}
WORDS = {'true': ['false'], 'false': ['true'], 'min': ['max'], 'max': ['min'], 'Positive': ['Negative', 'Zero'],
         'Negative': ['Positive', 'Zero'], 'Zero': ['Positive'], 'Up': ['Down'], 'Down': ['Up'],
         'Nearest': ['Down'], 'break': ['continue'], 'continue': ['break']}
_PASSED_OVER = re.compile(r'^\s*(#|//|using |namespace |template|static_assert|constexpr auto )')
_NUMBER = re.compile(r'(?<![\w.])(0x[0-9a-f.]+p[+-]?\d+|0x[0-9a-fA-F]+|\d+\.\d+|\d+)(?![\w.])')
_STATEMENT = re.compile(r'^\s+(?!return|const |constexpr|static|friend|struct|class|using|throw|else|case|explicit|'
                        r'public|private|goto|typename|inline|auto )[\w\[*:(].*[)\w\]}]\)?;$')
_DECLARATION = re.compile(r'^\s+(?!if |for |while |do |delete )[\w:]+(<.*>)?[&*]? [\w*&]+( = |;|\(|\{|, )')


def _numbers(text):
    if 'p' in text or '.' in text:
        return [f'(2 * {text})', f'({text} / 2)']
    return [f'({text} + 1)', f'({text} - 1)'] if text != '0' else ['1']


def _blank_comments(line):
    """The line with comments and strings blanked, so that places stay the same."""
    line = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])\'', lambda m: '"' * len(m.group()), line)
    start = line.find('//')
    return line if start < 0 else line[:start] + ' ' * (len(line) - start)


def mutants_of(text):
    """All mutants as (line from 1, column, what stood there, what stands there now)."""
    found = []
    lines = text.split('\n')
    in_assert = False
    for number, line in enumerate(lines, 1):
        in_assert = in_assert or line.lstrip().startswith('static_assert')
        if in_assert or _PASSED_OVER.match(line):
            in_assert = in_assert and not line.rstrip().endswith(';')
            continue
        code = _blank_comments(line)

        def add(start, end, new):
            if not found or found[-1][:2] != (number, start) or found[-1][3] != new:
                found.append((number, start, line[start:end], new))

        padded = code + ' '  # an operator at the end of a line has its blank there
        for old, news in SWAPS.items():
            for match in re.finditer(re.escape(old), padded):
                if code[:match.start()].strip() or number > 1:
                    for new in news:
                        add(match.start() + 1, match.end() - 1, new[1:-1])
        for match in re.finditer(r'\b[A-Za-z]+\b', code):
            for new in WORDS.get(match.group(), []):
                add(match.start(), match.end(), new)
        for match in _NUMBER.finditer(code):
            for new in _numbers(match.group()):
                add(match.start(), match.end(), new)
        for match in re.finditer(r'(?<=[(, ])(!|-)(?=[\w(])|\+\+|--', code):
            new = {'!': '', '-': '', '++': '--', '--': '++'}[match.group()]
            add(match.start(), match.end(), new)
        if match := re.match(r'^(.*\b(?:if|while) \()([^;]*)(\) (?:\{|return|continue|break|throw).*)$', code):
            if match.group(2).count('(') == match.group(2).count(')') and ' = ' not in match.group(2):
                add(match.end(1), match.end(2), f'!({line[match.end(1):match.end(2)]})')
        if match := re.match(r'^(\s*(?:.*\) |.*: )?return )([^{}]+);$', code):
            if match.group(2).count('(') == match.group(2).count(')'):
                add(match.end(1), match.end(2), f'!({line[match.end(1):match.end(2)]})')
        before = lines[number - 2].rstrip() if number > 1 else ''
        if _STATEMENT.match(code) and not _DECLARATION.match(code) and (
                before == '' or before[-1] in ';{}:' or before.lstrip().startswith('//')):
            start = len(line) - len(line.lstrip())
            add(start, len(line.rstrip()), ';')
    return found


def apply(text, mutant):
    number, start, old, new = mutant
    lines = text.split('\n')
    line = lines[number - 1]
    assert line[start:start + len(old)] == old
    lines[number - 1] = line[:start] + new + line[start + len(old):]
    return '\n'.join(lines)
