# SPDX-License-Identifier: MIT
"""Every program of ./dev field has an adapter and a pinned version; rows of a page are replaced by name; a run resumes."""
import re
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))
import programs  # noqa: E402
import tables  # noqa: E402
from memory import Memory, digest_of, expectation  # noqa: E402


class Subjects(unittest.TestCase):
    def test_every_name_has_an_adapter(self):
        functions = set(re.findall(r"^def (\w+)\(", (HERE / "python_hulls.py").read_text(), re.MULTILINE))
        self.assertLessEqual({name.replace("-", "_") for name in programs.PYTHON_HULLS}, functions)
        functions = set(re.findall(r"^def (\w+)\(", (HERE / "python_parts.py").read_text(), re.MULTILINE))
        self.assertLessEqual(set(programs.PYTHON_PARTS), functions)
        arms = set(re.findall(r'^ +"([\w-]+)" => obj_text', (HERE / "crates" / "crates.rs").read_text(), re.MULTILINE))
        self.assertEqual(arms, {*programs.CRATES, *programs.CRATES_PARTS})
        script = (HERE / "programs.mjs").read_text()
        for name in (*programs.NPM, *programs.NPM_PARTS):
            self.assertRegex(script, rf'async "?{name}"?\(')

    def test_names_and_kinds(self):
        names = [program.name for program in programs.own_programs("p") + programs.hull_programs() + programs.decomposers("p")]
        self.assertEqual(len(names), len(set(names)))
        self.assertEqual(programs.kind("parry64"), "hulls crates")
        self.assertEqual(programs.kind("coacd"), "decompositions python")
        with self.assertRaisesRegex(SystemExit, "cuacd 0.1.0 needs .*; hulls: .*jolt"):
            programs.kind("cuacd")

    def test_page_names_what_is_not_here(self):
        page = tables.PAGE.read_text()
        for name in programs.NOT_HERE:
            subject = name.split("'")[0]
            self.assertTrue(f"| {subject}" in page, name)


class Pages(unittest.TestCase):
    OLD = "| a | b |\n| --- | ---: |\n| `one` | 1 |\n| `two` | 2 |\n| `gone` | 3 |\n"

    def test_rows_are_replaced_by_name(self):
        new = "| a | b |\n| --- | ---: |\n| `two` | 22 |\n| `more` | 4 |"
        self.assertEqual(tables.with_old_rows(new, self.OLD, ["more", "one", "two"]),
                         "| a | b |\n| --- | ---: |\n| `more` | 4 |\n| `one` | 1 |\n| `two` | 22 |")

    def test_an_empty_page_takes_all_rows(self):
        new = "| a | b |\n| --- | ---: |\n| `two` | 22 |"
        self.assertEqual(tables.with_old_rows(new, "\n", ["two"]), new)

    def test_other_columns_are_refused(self):
        with self.assertRaises(ValueError):
            tables.with_old_rows("| a | c |\n| --- | ---: |\n| `two` | 22 |", self.OLD, ["two"])


class Memories(unittest.TestCase):
    def test_only_the_same_digest_counts(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "verdicts.json"
            first, second = Memory(path), Memory(path)
            first.keep("p", digest_of("a", b"b"), [1], 2.0)
            second.keep("q", digest_of("a"), [2], 6.0)
            self.assertEqual(Memory(path).recall("p", digest_of("a", b"b")), [1])
            self.assertIsNone(Memory(path).recall("p", digest_of("a", b"c")))
            self.assertIsNone(Memory(path, fresh=True).recall("p", digest_of("a", b"b")))
            self.assertEqual([Memory(path).seconds(name) for name in ("p", "new")], [2.0, 6.0])
        self.assertNotEqual(digest_of("ab", "c"), digest_of("a", "bc"))

    def test_expectation(self):
        self.assertEqual(expectation([30.0], [50.0], 1), "expected: 80 s, 1 of 2 guessed")
        self.assertEqual(expectation([600.0, 600.0], [], 2), "expected: 10 min")


if __name__ == "__main__":
    unittest.main()
