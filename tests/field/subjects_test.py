# SPDX-License-Identifier: MIT
"""Every program of ./dev field has an adapter and a pinned version; rows of a page are replaced by name; a run resumes."""
import hashlib
import importlib.util
import json
import re
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))
import programs  # noqa: E402
import real_meshes  # noqa: E402
import subjects  # noqa: E402
import tables  # noqa: E402
import warm  # noqa: E402
from memory import Memory, digest_of, expectation  # noqa: E402


class Subjects(unittest.TestCase):
    def test_every_name_has_an_adapter(self):
        functions = set(re.findall(r"^def (\w+)\(", (HERE / "python_hulls.py").read_text(), re.MULTILINE))
        self.assertLessEqual({name.replace("-", "_") for name in programs.PYTHON_HULLS}, functions)
        functions = set(re.findall(r"^def (\w+)\(", (HERE / "python_boxes.py").read_text(), re.MULTILINE))
        self.assertLessEqual({name.replace("-", "_") for name in programs.PYTHON_BOXES}, functions)
        functions = set(re.findall(r"^def (\w+)\(", (HERE / "python_parts.py").read_text(), re.MULTILINE))
        self.assertLessEqual(set(programs.PYTHON_PARTS), functions)
        arms = set(re.findall(r'^ +"([\w-]+)" => obj_text', (HERE / "crates" / "crates.rs").read_text(), re.MULTILINE))
        self.assertEqual(arms, {*programs.CRATES, *programs.CRATES_PARTS})
        script = (HERE / "programs.mjs").read_text()
        for name in (*programs.NPM, *programs.NPM_LIMITED, *programs.NPM_PARTS):
            self.assertRegex(script, rf'async "?{name}"?\(')

    def test_names_and_kinds(self):
        names = [program.name for program in programs.own_programs("p") + programs.hull_programs() + programs.decomposers("p")]
        self.assertEqual(len(names), len(set(names)))
        self.assertEqual(programs.kind("parry64"), "hulls crates")
        self.assertEqual(programs.kind("coacd"), "decompositions python")
        with self.assertRaisesRegex(SystemExit, "cuacd 0.1.0 needs .*; hulls: .*jolt"):
            programs.kind("cuacd")

    def test_page_names_what_is_not_here(self):
        page = (programs.ROOT / "docs" / "field.md").read_text()
        for name in programs.NOT_HERE:
            subject = name.split("'")[0]
            self.assertTrue(f"| {subject}" in page, name)


class Outputs(unittest.TestCase):
    @unittest.skipUnless(importlib.util.find_spec("numpy"), "the adapters of Python packages need numpy")
    def test_points_that_no_face_uses_are_left_out(self):
        from adapter import used_only  # pylint: disable=import-outside-toplevel
        points = [(0, 0, 0), (9, 9, 9), (1, 0, 0), (0, 1, 0)]
        self.assertEqual(used_only(points, [[3, 0, 2], [2, 0, 3]]),
                         ([(0, 1, 0), (0, 0, 0), (1, 0, 0)], [[0, 1, 2], [2, 1, 0]]))

    def test_the_identity_of_a_program_knows_its_scripts(self):
        with tempfile.TemporaryDirectory() as folder:
            script = Path(folder) / "a.py"
            script.write_text("1")
            program = programs.Program("a", ["python3", str(script), "{input}"])
            before = program.identity()
            self.assertEqual(program.identity(), before)
            script.write_text("2")
            self.assertNotEqual(program.identity(), before)


class Copies(unittest.TestCase):
    ADAPTER = """import os, sys, time
def main(what):
    {"writes": lambda: print("to nowhere"), "dies": os.abort, "waits": lambda: time.sleep(60), "raises": lambda: 1 / 0}[what]()
    return 4 if "decimal" in sys.modules else 3
"""

    def test_each_call_has_a_process_of_its_own(self):
        with tempfile.TemporaryDirectory() as folder:
            script = Path(folder) / "an_adapter.py"
            script.write_text(self.ADAPTER)
            codes = [warm.call(sys.executable, "decimal", [script, what], seconds)
                     for what, seconds in (("writes", 20), ("dies", 20), ("waits", 0.2), ("raises", 20), ("writes", 20))]
        self.assertEqual(codes, [4, -6, None, 1, 4])

    def test_a_package_that_cannot_be_imported(self):
        with self.assertRaises(warm.Dead):
            warm.call(sys.executable, "no_such_package", ["a"], 1)


class Findings(unittest.TestCase):
    PROGRAM = programs.Program("p", ["p", "{input}", "{output}"], promise="1e-9d")
    GOOD = {"solid": True, "contains": True, "planar": True, "convex": True, "relative": None, "outside": 0}

    def finding(self, outcome="exit 0", case="c", **found):
        record = {"case": case, "outcome": outcome, "found": {**self.GOOD, **found} if outcome.startswith("exit") else None}
        return subjects.hull_finding(self.PROGRAM, record, Path("i.obj"), Path("o.obj"), 8)

    def test_refusals_and_right_answers_are_none(self):
        self.assertIsNone(self.finding())
        self.assertIsNone(self.finding("refused 4"))

    def test_the_worst_come_first(self):
        found = [self.finding(case="round", contains=False, relative="1e-12", keeps_promise=True), self.finding(case="bent", convex=False),
                 self.finding(case="near", contains=False, relative="0.1"), self.finding(case="far", contains=False, relative="0.5"),
                 self.finding(case="middle", contains=False, relative="0.3"), self.finding(case="flat", solid=False),
                 self.finding("no file", case="empty"), self.finding("signal 11", case="dead")]
        expected = ["dead", "empty", "flat", "far", "middle"]  # two of a kind, five in all
        self.assertEqual([finding.case for finding in subjects.worst(found)], expected)
        self.assertEqual([finding.case for finding in subjects.worst(found[::-1])], expected)

    def test_what_is_reduced_keeps_the_fault(self):
        self.assertEqual(self.finding(contains=False, relative="0.1").shrink,
                         ["--fails-if", "verdict", "--claims", "contains-input", "--tolerance", "1e-9d"])
        self.assertEqual(self.finding(contains=False, relative="1e-12", keeps_promise=True).shrink,
                         ["--fails-if", "verdict", "--claims", "contains-input"])
        self.assertEqual(self.finding("signal 11").shrink, ["--fails-if", "exit"])

    JUDGED = {"points_outside": 0, "points": 8, "squared_distance": "0", "squared_diameter": "4", "parts_not_solid": [],
              "parts_not_convex": [], "claims": {"covers-solid": None}}

    def parts(self, outcome="output", **judged):
        record = {"case": "c", "outcome": outcome, "judge": {**self.JUDGED, **judged}}
        return subjects.parts_finding(self.PROGRAM, record, Path("i.obj"), Path("o.obj"))

    def test_of_parts_the_deepest_gap_is_the_fault(self):
        for none in (self.parts(), self.parts(uncovered_area_share=0.0), self.parts("refused 4"), self.parts("not started: no file")):
            self.assertIsNone(none)
        gap = self.parts(points_outside=2, squared_distance="1", uncovered_area_share=0.25)
        self.assertEqual((gap.rank, gap.size, gap.sentence),
                         (3, 0.5, "2 of 8 points in no part, the worst by 0.5 of the diameter; 25% of the surface in no part"))
        self.assertEqual(gap.verify[-2:], ["--claims", "covers-points,covers-surface"])
        self.assertEqual(self.parts(uncovered_area_share=0.25).rank, 4)
        self.assertEqual(self.parts(claims={"covers-solid": False}).rank, 5)
        self.assertEqual(self.parts(parts_not_solid=[0, 3]).sentence, "2 parts without a volume")
        self.assertEqual(self.parts("signal 6").sentence, "signal 6 ended the process")


class RealMeshes(unittest.TestCase):
    def test_pinned_files_of_pinned_packages(self):
        listed = json.loads(real_meshes.LIST.read_text())
        for entry in (*listed["meshes"], *listed["packages"].values()):
            self.assertRegex(entry["sha256"], "^[0-9a-f]{64}$")
        for key, count in (("name", 300), ("sha256", 300), ("package", len(listed["packages"]))):
            self.assertEqual(len({entry[key] for entry in listed["meshes"]}), count)
        self.assertEqual(len({entry["package"] for entry in listed["meshes"][:30]}), 5)

    def test_another_file_is_refused(self):
        empty = hashlib.sha256(b"").hexdigest()
        self.assertEqual(real_meshes.checked(b"", {"sha256": empty}, "f"), b"")
        with self.assertRaisesRegex(real_meshes.Missing, "f is another file"):
            real_meshes.checked(b"x", {"sha256": empty}, "f")


class Pages(unittest.TestCase):
    OLD = "| a | b |\n| --- | ---: |\n| `one` | 1 |\n| `two` | 2 |\n| `gone` | 3 |\n"

    def test_rows_are_replaced_by_name(self):
        new = "| a | b |\n| --- | ---: |\n| `two` | 22 |\n| `more` | 4 |"
        self.assertEqual(tables.with_old_rows(new, self.OLD, ["more", "one", "two"]),
                         "| a | b |\n| --- | ---: |\n| `more` | 4 |\n| `one` | 1 |\n| `two` | 22 |")

    def test_rows_of_real_meshes_have_no_columns_of_bunny(self):
        program = programs.Program("p", ["p"], version="p 1")
        found = {**Findings.GOOD, "outward": True, "is_hull": True, "facets": 8, "mesh": False, "seconds": 0.5}
        records = [{"program": "p", "case": "c", "outcome": "exit 0", "found": found}]
        for real, columns in ((0, len(tables.HULL_HEAD)), (30, len(tables.HULL_HEAD) - 2), (300, len(tables.HULL_HEAD) - 2)):
            self.assertEqual({line.count(" | ") + 1 for line in tables.hull_table(records, [program], 1, real).split("\n")}, {columns})

    def test_outputs_too_large_for_the_judge_are_not_judged_twice(self):
        program = programs.Program("p", ["p"], version="p 1")
        found = {**Findings.GOOD, "outward": True, "is_hull": True, "facets": 8, "mesh": False, "seconds": 0.5}
        for outcome, said in (("exit 1", "all"), ("too large for the judge", "1 of 2")):
            records = [{"program": "p", "case": case, "outcome": how, "found": found} for case, how in (("a", "exit 0"), ("b", outcome))]
            row = tables.hull_table(records, [program], 2).split("\n")[2].strip("| ").split(" | ")
            self.assertEqual(dict(zip(tables.HULL_HEAD, row))["judged twice"], said)

    def test_surfaces_too_large_for_the_judge_are_not_judged_twice(self):
        judge = {**Findings.JUDGED, "parts": 1, "facets": [8], "overlapping_pairs": 0, "parts_inner": []}
        for claim, said in ((False, "all"), (None, "1 of 2")):
            records = [{"case": case, "outcome": "output", "seconds": 1.0, "judge": {**judge, "claims": {"covers-surface": covers}}}
                       for case, covers in (("a", True), ("b", claim))]
            records.append({"case": "c", "outcome": "time"})
            row = tables.parts_row(programs.Program("p", ["p"]), records)
            self.assertEqual(len(row), len(tables.PARTS_HEAD))
            self.assertEqual(dict(zip(tables.PARTS_HEAD, row))["judged twice"], said)

    def test_many_meshes_are_one_row(self):
        judge = {**Findings.JUDGED, "parts": 3, "overlapping_pairs": 2, "parts_inner": [], "claims": {"covers-surface": True},
                 "facets": [6, 6, 9]}
        holds = {**judge, "points_outside": 0, "squared_distance": "0", "uncovered_area_share": 0.0}
        records = [{"program": "p", "case": "a", "outcome": "output", "seconds": 1.0, "judge": holds},
                   {"program": "p", "case": "b", "outcome": "output", "seconds": 3.0,
                    "judge": {**judge, "points_outside": 1, "squared_distance": "1/4", "squared_diameter": "1", "uncovered_area_share": 0.25}},
                   {"program": "p", "case": "c", "outcome": "refused 4", "seconds": None}]
        row = tables.real_parts_table(records, [programs.Program("p", ["p"]), programs.Program("q", ["q"])]).split("\n")[2]
        cells = dict(zip(tables.REAL_PARTS_HEAD, row.strip("| ").split(" | ")))
        said = {"outputs": "2 of 3", "hold all points": "1 of 2", "farthest, D": "0.5", "all of the surface": "1 of 2",
                "most surface outside": "25%", "parts": "6", "median time": "2 s", "parts with faults": "4 pairs overlap",
                "no output": "1 refused 4"}
        self.assertEqual({name: cells[name] for name in said}, said)

    def test_each_output_is_counted_once_by_its_worst_point(self):
        worst = [None, "9e-400", "1e-15", "9.9e-13", "2e-12", "1e-9", "0.00099", "0.5"]
        found = [{**Findings.GOOD, "seconds": 1.0, "contains": not distance, "relative": distance} for distance in worst]
        found.append({**Findings.GOOD, "seconds": 1.0, "solid": False, "contains": False})
        records = [{"program": "p", "case": str(k), "outcome": "exit 1", "found": one} for k, one in enumerate(found)]
        self.assertEqual(tables.distance_table(records, [programs.Program("p", ["p"])]).split("\n"), [
            "| program | outputs | 0 | < 1e-15 | < 1e-12 | < 1e-9 | < 1e-6 | < 1e-3 | farther | no volume |",
            "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |", "| `p` | 9 | 1 | 1 | 2 | 1 | 1 | 1 | 1 | 1 |"])

    def test_how_programs_end_without_an_output(self):
        outcomes = ["exit 0", "exit 4", "too large for the judge", "an input beyond binary32", "refused 4", "refused 101", "signal 11",
                    "no file", "time"]
        records = [{"program": "p", "outcome": outcome, "tolerance": None} for outcome in outcomes]
        records.append({"program": "p", "outcome": "exit 0", "tolerance": "1e-9d"})
        self.assertEqual(tables.ends_table(records, [programs.Program("p", ["p"]), programs.Program("q", ["q"])]).split("\n")[2:],
                         ["| `p` | 9 | 1 | 1 | 2 | 1 | 4 |"])

    def test_the_page_has_a_place_for_each_table(self):
        page = tables.PAGE.read_text()
        for name in ("hulls", "ends", "real", "real-distances", "real-300", "real-300-distances", "matrix", "decompositions",
                     "real-parts"):
            self.assertRegex(page, rf"<!-- {name}: (?s:.*)<!-- end of {name} -->")

    def test_an_empty_page_takes_all_rows(self):
        new = "| a | b |\n| --- | ---: |\n| `two` | 22 |"
        self.assertEqual(tables.with_old_rows(new, "\n", ["two"]), new)

    def test_other_columns_are_refused_where_old_rows_stay(self):
        new = "| a | c |\n| --- | ---: |\n| `two` | 22 |"
        with self.assertRaises(ValueError):
            tables.with_old_rows(new, self.OLD, ["one", "two"])
        self.assertEqual(tables.with_old_rows(new, self.OLD, ["two"]), new)


    def test_times_are_replaced_in_the_rows_of_their_names(self):
        head = "| " + " | ".join(tables.PARTS_HEAD) + " |"
        column = tables.PARTS_HEAD.index("its time")
        old, new = (" | ".join(["| `a`", *("x" if k != column else time for k in range(1, len(tables.PARTS_HEAD)))]) + " |"
                    for time in ("-, -", "1 s, 2 s"))
        self.assertEqual(tables.with_times("\n".join([head, old, old.replace("`a`", "`b`")]), {"a": "1 s, 2 s"}),
                         "\n".join([head, new, old.replace("`a`", "`b`")]))


    def test_the_matrix_counts_meshes_and_faults(self):
        cells = {"parts": "2, 3", "points outside": "0, 1e-3%", "surface outside": "0, 0", "volume outside": "-, 0",
                 "beyond, D": "0, 0.031", "parts with faults": "8 flat, 12 pairs overlap"}
        row = "| `a` | " + " | ".join(cells.get(name, "x") for name in tables.PARTS_HEAD[1:]) + " |"
        self.assertEqual(tables.parts_matrix(f"head\nrule\n{row}\n").split("\n")[2],
                         "| `a` | 1 of 2 | all | 1 of 2 | 1 of 2 | 8 | 0 | 12 | 0 | 5 |")

    def test_reach_is_rounded_up_unless_the_claim_holds(self):
        for status, high, shown in (("holds", 0.062, "0.03"), ("holds", 0.0402, "0.021"), ("violated", 0.06001, "0.031"), ("violated", 0.25, "0.13")):
            record = {"judge": {"squared_diameter": "4"},
                      "answer": {"measures": {"union_to_input": {"low": 0.0, "high": high}}, "claims": [{"code": "within-solid", "status": status}]}}
            self.assertEqual(tables.beyond(record), shown)


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
