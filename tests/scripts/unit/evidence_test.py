# SPDX-License-Identifier: Apache-2.0
"""Kept results: when one holds, when a check runs again, and what a check depends on."""

import os
import re
import subprocess
import sys
from unittest import mock

from scratch import Scratch, call
from trammel_tools import machines, tools
from trammel_tools.check import coverage_cpp, rtl_counts
from trammel_tools.evidence import evidence, kinds, record, sources
from trammel_tools.paths import ROOT

NAME = "formal.math.toy"


class Kept(Scratch):
    """A repository with two files and without kept results."""

    def setUp(self):
        super().setUp()
        self.init()
        self.write("rtl/math/toy.sv", "module toy;\nendmodule\n")
        self.write("rtl/math/toy_props.sv", "// none\n")
        self.write("said", "all of it\n")
        self.patch(sources, ROOT=self.folder)
        self.patch(record, ROOT=self.folder, KEPT=self.folder / "evidence")
        self.patch(evidence, ROOT=self.folder)
        environment = mock.patch.dict(os.environ)
        environment.start()
        self.addCleanup(environment.stop)
        for name in [one for one in os.environ if one == "CI" or one.startswith("TRAMMEL_")]:
            del os.environ[name]
        evidence.forget()
        self.addCleanup(evidence.forget)


class EvidenceTest(Kept):
    """One check, whose command prints a file and counts its runs."""

    def check(self):
        """(exit code, whether the command ran, what the tool said) of the check."""
        evidence.forget()
        ran = self.folder / "ran"
        ran.unlink(missing_ok=True)
        script = (f"import pathlib; pathlib.Path({str(ran)!r}).touch(); "
                  f"print(open({str(self.folder / 'said')!r}).read(), end='')")
        code, _, error = call(evidence.main, NAME, "--", sys.executable, "-c", script)
        return code, ran.exists(), error

    def test_a_result_that_holds_is_not_made_again(self):
        self.assertEqual(self.check()[:2], (0, True))
        self.assertEqual(self.check(), (0, False, ""))

    def test_a_change_of_any_input_makes_it_again_and_says_so(self):
        for path in ("rtl/math/toy.sv", "rtl/math/toy_props.sv"):
            self.check()
            self.write(path, "module toy;  // another\nendmodule\n")
            code, ran, said = self.check()
            self.assertEqual((code, ran), (0, True))
            self.assertRegex(said, "^evidence: .* its inputs have changed since .*\n$")
            self.assertFalse(self.check()[1])

    def test_mutants_of_a_block_depend_on_the_floor_of_that_block_alone(self):
        kind, match = kinds.of("campaign.mutants.math.toy")
        found = []
        for floors in ('"math/toy" = 95', '"math/toy" = 95\n"math/top" = 99', '"math/toy" = 96'):
            self.write("tests/mutants.toml", f"[floor]\n{floors}\n")
            found.append(record.digest_of(kind.files(match)))
        self.assertEqual([found.index(one) for one in found], [0, 0, 2])

    def test_a_result_of_another_tool_or_architecture_does_not_count(self):
        self.check()
        with mock.patch.object(kinds, "version", lambda tool: "0.1"):
            code, ran, said = self.check()
        self.assertEqual((code, ran), (0, True))
        self.assertIn("it was made with pyosys", said)
        with mock.patch.object(kinds, "version", lambda tool: "0.1" * (tool == "pyosys")):
            self.assertRegex(self.check()[2], r"it was made with debian/berkeley-abc 0\.1; here is")
        compiled, _ = kinds.of("coverage.math.toy")
        before = kinds.made_with(compiled)
        with mock.patch.object(kinds, "processor", lambda: "pdp11"):
            self.assertNotEqual(kinds.made_with(compiled), before)

    def test_every_byte_of_a_record_is_covered(self):
        self.check()
        path = record.path_of(NAME)
        whole = path.read_bytes()
        for n in range(len(whole)):
            path.write_bytes(whole[:n] + bytes([whole[n] ^ 1]) + whole[n + 1:])
            with self.assertRaises(record.Damaged):
                record.read(NAME)
            path.write_bytes(whole[:n])
            with self.assertRaises(record.Damaged):
                record.read(NAME)
        for other in (whole + b"\n", whole[:-1] + b" \n", whole.replace(b"\n", b"\r\n")):
            path.write_bytes(other)
            with self.assertRaises(record.Damaged):
                record.read(NAME)
        code, ran, said = self.check()
        self.assertEqual((code, ran, said.count("\n")), (0, True, 1))
        self.assertIn("is damaged", said)
        self.assertEqual(path.read_bytes(), whole)

    def test_a_result_that_is_made_again_must_be_the_same(self):
        self.check()
        os.environ["TRAMMEL_FRESH"] = "1"
        self.assertEqual(self.check()[:2], (0, True))
        self.write("said", "nothing\n")
        code, ran, said = self.check()
        self.assertEqual((code, ran), (1, True))
        self.assertIn("-all of it\n+nothing\n", said)

    def test_ci_draws_some_by_its_commit_and_no_other_run_does(self):
        self.check()
        self.assertFalse(evidence.drawn(NAME))
        os.environ["CI"] = "true"
        with mock.patch.object(evidence, "commit") as commit:
            drawn = 0
            for n in range(1000):
                commit.return_value = f"{n:040x}"
                drawn += evidence.drawn(NAME)
        self.assertTrue(70 < drawn < 130, drawn)

    def test_a_check_that_fails_keeps_nothing(self):
        self.write("said", "")
        code, _, _ = call(lambda: evidence.run(NAME, ["false"]))
        self.assertEqual(code, 1)
        self.assertFalse(record.KEPT.exists())

    def test_a_result_of_inputs_that_changed_while_it_was_made_is_not_kept(self):
        changes = f"open({str(self.folder / 'rtl/math/toy.sv')!r}, 'a').write('// late')"
        code, _, said = call(lambda: evidence.run(NAME, [sys.executable, "-c", changes]))
        self.assertEqual(code, 0)
        self.assertIn("its inputs changed while it ran", said)
        self.assertFalse(record.KEPT.exists())

    def test_a_result_under_a_variable_that_tests_read_neither_counts_nor_is_kept(self):
        self.check()
        kept = record.path_of(NAME).read_bytes()
        os.environ["TRAMMEL_TEST_SEED"] = "5"
        self.write("said", "another\n")
        code, ran, said = self.check()
        self.assertEqual((code, ran), (0, True))
        self.assertIn("not kept: TRAMMEL_TEST_SEED", said)
        self.assertEqual(record.path_of(NAME).read_bytes(), kept)

    def test_what_passes_on_a_full_disk_is_neither_kept_nor_compared(self):
        usage = mock.Mock(return_value=mock.Mock(free=0))
        with mock.patch.object(evidence.shutil, "disk_usage", usage):
            code, ran, said = self.check()
            self.assertEqual((code, ran, said.count("\n")), (1, True, 2))
            self.assertIn(f"the result of {NAME} does not count: the disk of", said)
            self.assertFalse(record.KEPT.exists())
        self.check()
        os.environ["TRAMMEL_FRESH"] = "1"
        self.write("said", "")
        with mock.patch.object(evidence.shutil, "disk_usage", usage):
            self.assertNotIn("differs", self.check()[2])

    def test_what_cannot_be_kept_is_said_in_one_line(self):
        self.write("evidence", "no folder")
        code, ran, said = self.check()
        self.assertEqual((code, ran, said.count("\n")), (0, True, 2))
        self.assertIn(f"{NAME} is not kept", said)

    def test_links_without_a_file_do_not_count(self):
        before = record.digest_of(sources.matching("rtl/**"))
        (self.folder / "rtl/math/.#toy.sv").symlink_to("user@host.1")
        (self.folder / "rtl/math/linked.sv").symlink_to(self.folder)
        evidence.forget()
        self.assertEqual(record.digest_of(sources.matching("rtl/**")), before)

    def test_an_archive_in_a_repository_that_ignores_it_has_inputs(self):
        self.patch(sources, ROOT=self.folder / "unpacked")
        self.write("unpacked/rtl/math/toy.sv", "module toy;\nendmodule\n")
        self.write(".gitignore", "unpacked\n")
        evidence.forget()
        self.assertEqual(sources.every(), ["rtl/math/toy.sv"])

    def test_a_record_of_a_block_that_is_gone_and_a_name_without_check_are_said_in_one_line(self):
        self.check()
        (self.folder / "rtl/math/toy.sv").unlink()
        evidence.forget()
        self.assertIn("there is no such check", evidence.stale(NAME))
        for words in ((NAME, "--", "true"), ("--inputs", NAME), ("none", "--", "true"), (),
                      ("--list", NAME), ("--needed", NAME), ("--inputs", NAME, NAME),
                      ("--list", "--needed")):
            code, _, said = call(evidence.main, *words)
            self.assertEqual((code, said.count("\n")), (2, 1), words)

    def test_a_check_whose_output_another_needs_runs_with_it(self):
        with mock.patch.object(evidence, "stale", lambda name: "old" * (name == "synth.gates_off")):
            self.assertEqual(evidence.why("synth.board.ulx3s"), "synth.gates_off needs it")
            self.assertEqual(evidence.why("synth.budget"), "")


class CampaignTest(Kept):
    """The age of a whole campaign's result, in a repository with its commits."""

    name = "campaign.mutants.math.toy"

    def setUp(self):
        super().setUp()
        self.patch(evidence, checks=lambda: [self.name], BEGUN=self.commits(1))

    def git(self, *words, folder=None):
        return subprocess.run(
            ["git", "-c", "user.name=a", "-c", "user.email=b", *words], check=True,
            cwd=folder or self.folder, capture_output=True, text=True).stdout.strip()

    def commits(self, count, *more):
        for _ in range(count):
            self.git("commit", "-q", "--allow-empty", "-m", "more", *more)
        evidence.forget()
        return self.git("rev-parse", "HEAD")

    def campaign(self):
        return call(evidence.main, self.name, "--", "true")[0]

    def aged(self):
        code, out, said = call(evidence.main, "--campaigns")
        return code, int(out.split()[-4].replace("?", "-1")), said

    def test_a_campaign_of_more_than_200_commits_is_an_error_until_it_holds_again(self):
        self.patch(evidence, AGE=4)
        self.commits(4)
        self.assertEqual(self.aged(), (0, 4, ""))
        self.commits(1)
        code, count, said = self.aged()
        self.assertEqual((code, count, said.count("\n")), (1, 5, 1))
        self.campaign()
        self.assertEqual(record.read(self.name).commit, self.git("rev-parse", "HEAD"))
        self.commits(2)
        before = record.path_of(self.name).read_bytes()
        self.campaign()  # it holds and is young
        self.assertEqual(record.path_of(self.name).read_bytes(), before)
        self.commits(3)
        self.assertEqual(self.aged()[:2], (1, 5))
        self.campaign()
        self.assertEqual(self.aged(), (0, 0, ""))
        self.assertEqual(record.read(self.name).result, "passed\n")

    def test_a_commit_that_a_rebase_replaced_is_as_old_as_the_record(self):
        self.campaign()
        self.git("add", "evidence")
        self.commits(3)
        kept = record.read(self.name)
        with mock.patch.object(record, "read", lambda name: evidence.dataclasses.replace(
                kept, commit="0" * 40)):
            self.assertEqual(self.aged(), (0, 2, ""))

    def test_a_clone_without_its_commits_says_how_to_get_them_and_is_no_error(self):
        self.campaign()
        self.git("add", "evidence")
        self.commits(3)
        shallow = self.folder / "shallow"
        self.git("clone", "-q", "--depth=2", f"file://{self.folder}", shallow)
        self.patch(evidence, ROOT=shallow)
        evidence.forget()
        code, count, said = self.aged()
        self.assertEqual((code, count, said.count("\n")), (0, -1, 1))
        self.assertIn("git fetch --unshallow", said)
        self.git("fetch", "-q", "--unshallow", folder=shallow)
        evidence.forget()
        self.assertEqual(self.aged(), (0, 3, ""))

    def test_ci_has_all_commits(self):
        steps = (ROOT / ".github/workflows/ci.yml").read_text(encoding="utf-8")
        self.assertRegex(steps, r"actions/checkout@.*\n +with:\n +fetch-depth: 0\b")


class TrackedTest(Scratch):
    def test_no_tracked_record_has_been_edited(self):
        for path in sorted(record.KEPT.glob("*.txt")):
            self.assertEqual(record.read(path.stem).check, path.stem)


def compiled(pattern):
    """(match, files that the compiler read) of each object in build/ whose name matches."""
    asked = subprocess.run(["ninja", "-C", ROOT / "build", "-t", "deps"], capture_output=True,
                           text=True, check=False).stdout
    for part in asked.split("\n\n"):
        name, _, rest = part.partition(": #deps")
        if found := re.fullmatch(pattern, name):
            yield found, {line.strip() for line in rest.split("\n")[1:]}


def of_repository(files):
    """Those of files named from build/ that Git has or may have."""
    read = {os.path.relpath((ROOT / "build" / one).resolve(), ROOT) for one in files}
    return {one for one in read if (ROOT / one).is_file()
            and not one.startswith(("build", "..", ".venv"))}


class SourcesTest(Scratch):
    def test_what_verilator_and_the_compiler_read_is_among_the_inputs(self):
        """Of each unit test that is built here: the files of its model and of its objects."""
        objects = {}
        for found, files in compiled(r"tests/CMakeFiles/(\w+)_test\.dir/(\w+)/\w+_test\.cpp\.o"):
            objects.setdefault(f"{found[2]}.{found[1]}", set()).update(files)
        for name, files in objects.items():
            try:
                kind, found = kinds.of(f"coverage.{name}")
            except KeyError:
                continue
            layer, block = name.split(".")
            if not (ROOT / "rtl" / layer / f"{block}.sv").exists():
                continue
            for model in (ROOT / "build" / "verilated" / f"rtl_{block}").glob("*.d"):
                files |= set(model.read_text(encoding="utf-8").replace("\\\n", " ").split())
            read = of_repository(files)
            # All packages are read, and for a chip the properties of every block with that block.
            unused = {one for one in read if one.endswith("_pkg.sv")
                      or (layer == "chips" and one.startswith("rtl/"))}
            self.assertEqual(read - unused - kind.files(found), set(), name)

    def test_what_the_compiler_reads_is_among_the_inputs_of_sanitized_tests(self):
        groups = {}
        for found, files in compiled(
                r"tests/CMakeFiles/\w+\.dir/(?:__/machines/)?(\w+)/\S+_test\.cpp\.o"):
            groups.setdefault(found[1], set()).update(files)
        for group, files in groups.items():
            kind, found = kinds.of(f"sanitize.{group}")
            self.assertEqual(of_repository(files) - kind.files(found), set(), group)

    def test_laboratory_and_machines_are_no_input_of_what_depends_on_a_block(self):
        for name in ("coverage.drive.pwm", "campaign.mutants.drive.pwm", "formal.drive.pwm"):
            kind, found = kinds.of(name)
            self.assertEqual([one for one in kind.files(found) if one.endswith((".cpp", ".hpp"))
                              and one.startswith(("lab/", "machines/"))], [], name)

    def test_sanitized_tests_depend_on_models_and_not_on_rtl(self):
        own = {name: f"{folder.relative_to(ROOT)}/" for name, folder in machines.folders().items()}
        for group, model in {"drive": "models/exact/drive/", **own}.items():
            kind, found = kinds.of(f"sanitize.{group}")
            files = kind.files(found)
            self.assertEqual([one for one in files if one.startswith("rtl/") and
                              one.endswith(".sv")], [], group)
            self.assertTrue([one for one in files if one.startswith(model)], group)

    def test_what_the_script_of_a_check_names_is_among_the_inputs(self):
        """Modules that it imports, and files that it finds by ROOT / "folder" / "file"."""
        own, called = "scripts/trammel_tools", tools.every()
        scripts = {name: f"{called[tool].relative_to(ROOT)}" for name, tool in (
            ("synth.fusesoc", "gen-core"), ("synth.budget", "synth"),
            ("sanitize.drive", "sanitize"), ("synth.equivalence", "equivalence"),
            ("mutants.sample", "verify"), ("keys", "verify"),
            ("fuzz.short", "fuzz"), ("precision.rows", "precision-rows"), ("perf.rows", "perf"),
            ("docs.precision", "gen-precision"), ("docs.machine", "machine-lesson"),
            ("campaign.mutants.drive.pwm", "verify"), ("campaign.acceptance", "precision-rows"),
            ("campaign.fuzz.disks", "fuzz"), ("verilators", "verilators"))}
        scripts |= {f"{kind}.{path.stem.removesuffix('_test')}": f"{path.relative_to(ROOT)}"
                    for kind, folder in (("python", "python/tests"), ("package", "packaging"))
                    for path in (ROOT / folder).glob("*_test.py")}
        there = set(sources.every())
        for name, script in scripts.items():
            kind, found = kinds.of(name)
            text = (ROOT / script).read_text(encoding="utf-8")
            needed = {script} | {"/".join(re.findall('"(.+?)"', one))
                                 for one in re.findall(r'ROOT((?: / "[^"]+")+)', text)}
            for package, names in re.findall(r"from trammel_tools\b(\S*) import ([\w, ]+)", text):
                folder = own + package.replace(".", "/")
                needed |= {f"{folder}.py", *(f"{folder}/{one}.py" for one in names.split(", "))}
            self.assertEqual((needed & there) - kind.files(found), set(), name)
        floors = {one for one in there if one.endswith("mutants.toml")}
        self.assertEqual(floors - kinds.MUTANTS(None), set())

    def test_counts_survive_their_short_form(self):
        block = rtl_counts.Block()
        block.lines.update({(3, 7, "elsif"): 2, (9, 1, "block"): 0})
        block.toggles.update({(4, "a[0]"): 5, (4, "b"): 1, (5, "c"): 0})
        block.covers.update({"reaches_far": 0, "reaches_near": 8})
        text = "\n".join(rtl_counts.short({"math/toy": block}))
        again = rtl_counts.read_short(text)["math/toy"]
        for kind in rtl_counts.KINDS:
            before, after = getattr(block, kind), getattr(again, kind)
            self.assertEqual(block.share(before), block.share(after))
            self.assertEqual({one for one in before if before[one] == 0},
                             {one for one in after if after[one] == 0})
        more = text.replace("reaches_near\n", "reaches_near reaches_far\n")
        both = rtl_counts.read_short(text, more)
        self.assertEqual(both["math/toy"].covers["reaches_far"], 1)

    def test_lines_survive_their_short_form(self):
        lines = {1: 3, 2: 1, 3: 0, 5: 0, 9: 7}
        text = "\n".join(coverage_cpp.short({"lab/toy.cpp": lines, "lab/toy.hpp": {4: 0}}))
        self.assertEqual(coverage_cpp.read_short(f"2 unit tests passed\n{text}", text),
                         {"lab/toy.cpp": {line: 2 * (n > 0) for line, n in lines.items()},
                          "lab/toy.hpp": {4: 0}})
