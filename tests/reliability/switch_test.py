#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""switch.py on statements of each kind, and on every fault of the list: without its switch, the text is the source
with or without the fault."""
import re
import unittest

from fault_list import FAULTS
from faults import ROOT, place_of
from switch import switched


def put(text, old, new):
    return switched(text, text.index(old), old, new, 7)


class Statements(unittest.TestCase):
    def test_a_condition_becomes_a_choice_between_two(self):
        self.assertEqual(put('void f() {\n  if (a(x) <= b[0]) g();\n}\n', '<= b', '< b'),
                         'void f() {\n  if (campaign::condition(7, [&] { return bool(a(x) <= b[0]); }, '
                         '[&] { return bool(a(x) < b[0]); })) g();\n}\n')
        self.assertIn('while (campaign::condition(7,', put('void f() { while (a < b) g(); }', 'a < b', 'a <= b'))
        self.assertIn('else if (campaign::condition(7,', put('void f() { if (c) { h(); } else if (a) { g(); } }', 'if (a) {', 'if (!a) {'))

    def test_a_number_becomes_a_choice_between_two(self):
        self.assertEqual(put('void f() { const double e = 4 * u + v; g(e); }', '4 * u', '2 * u'),
                         'void f() { const double e = campaign::value<double>(7, [&] { return double(4 * u + v); }, '
                         '[&] { return double(2 * u + v); }); g(e); }')

    def test_other_statements_become_two(self):
        self.assertEqual(put('int f() { g(); return a - b; }', 'a - b', 'b - a'),
                         'int f() { g(); if (campaign::is(7)) { return b - a; } else { return a - b; } }')
        self.assertEqual(put('void f() {\n  g();\n  h(1);\n}\n', '  h(1);\n', ''),
                         'void f() {\n  g();\n  if (campaign::is(7)) {  } else { h(1); }\n}\n')
        self.assertIn('if (campaign::is(7)) { return x < 0; } else { return x <= 0; }',
                      put('bool f() { return any(v, [&](int x) { return x <= 0; }); }', '<= 0; })', '< 0; })'))

    def test_what_is_no_statement_is_left_alone(self):
        self.assertIsNone(put('constexpr double kError = 4 * u;\n', '4 * u', '2 * u'))
        self.assertIsNone(put('void f() { const auto a = g(1); h(a); }', 'g(1)', 'g(2)'))
        self.assertIsNone(put('void f() { if (const auto a = g(1)) h(*a); }', 'g(1)', 'g(2)'))

    def test_braces_and_quotes_in_texts_are_no_code(self):
        self.assertIn('campaign::is(7)', put('void f() { say("; } {"); g(1); }', 'g(1)', 'g(2)'))


class Faults(unittest.TestCase):
    def test_most_faults_of_the_list_can_stand_behind_a_switch(self):
        count = 0
        for number, fault in enumerate(FAULTS):
            name, at = place_of(fault)
            text = (ROOT / name).read_text()
            made = switched(text, at, fault[2], fault[3], number)
            if made is None:
                continue
            count += 1
            self.assertEqual(len(re.findall(r'campaign::\w+(?:<[^>]*>)?\(%d\b' % number, made)), 1, fault)
        self.assertGreater(count, len(FAULTS) * 3 // 4)


if __name__ == '__main__':
    unittest.main()
