# SPDX-License-Identifier: MIT
"""Turns files into C++: embed.py OUTPUT HEADER NAME=FILE[+FILE...]... defines the std::string_views that the header
declares, each a file or several in a row."""
import pathlib
import sys


def definition(name, paths):
    contents = b''.join(pathlib.Path(path).read_bytes() for path in paths.split('+'))
    numbers = [str(byte - 256 if byte > 127 else byte) for byte in contents]
    lines = [','.join(numbers[i:i + 24]) for i in range(0, len(numbers), 24)]
    return (f'namespace {{\nconstexpr signed char k{name}Bytes[] = {{\n' + ',\n'.join(lines) + '};\n}\n'
            f'const std::string_view {name}(reinterpret_cast<const char*>(k{name}Bytes), '
            f'sizeof(k{name}Bytes));\n')


with open(sys.argv[1], 'w', encoding='ascii') as output:
    output.write(f'// Made by embed.py.\n#include "{sys.argv[2]}"\n\nnamespace convexact {{\n')
    for argument in sys.argv[3:]:
        output.write(definition(*argument.split('=', 1)))
    output.write('}  // namespace convexact\n')
