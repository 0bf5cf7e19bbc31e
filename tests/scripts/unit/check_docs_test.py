# SPDX-License-Identifier: Apache-2.0
"""What the documentation check finds in pages, and how it executes their commands."""

import subprocess

from scratch import Scratch
from trammel_tools.check import check_docs


class CheckDocsTest(Scratch):
    def setUp(self):
        super().setUp()
        self.init()
        self.patch(check_docs, ROOT=self.folder)

    def test_a_link_leads_to_a_file_a_heading_or_a_line(self):
        self.write("docs/other.md", "# The first: `heading`\n\n## 2. It's here\n")
        for link, told in (("other.md", None), ("other.md#the-first-heading", None),
                           ("other.md#2-its-here", None), ("other.md#L3", None),
                           ("https://nowhere.example/x", None), ("../docs/other.md", None),
                           ("none.md", "no file none.md"),
                           ("other.md#second", "no heading #second in other.md"),
                           ("other.md#L9", "other.md has no line 9"),
                           ("#here", "no heading #here in page.md")):
            with self.subTest(link):
                self.write("docs/page.md", f"# Page\n\n[text]({link})\n")
                self.assertEqual(list(check_docs.check_links()),
                                 [f"docs/page.md:3: {told}"] if told else [])

    def test_a_link_in_a_block_of_code_is_none(self):
        self.write("page.md", "```sh\na[0](x)\n```\n")
        self.assertEqual(list(check_docs.check_links()), [])

    def test_a_default_in_the_text_is_that_of_a_machine(self):
        keys = {"gains.kp": ["1", "2"], "plant.mass": ["3"]}
        self.write("page.md", "`gains.kp = 2`, `plant.mass = 4`,\n"
                              "`gains.ki = 1`, `other.key = 1`\n")
        self.assertEqual(list(check_docs.check_defaults(keys)),
                         ["page.md:1: the default of plant.mass is 3, not 4",
                          "page.md:2: gains.ki is no key"])

    def executed(self, block):
        """Exit code of a block of a lesson, and what it prints."""
        done = subprocess.run(["bash"], input=check_docs.script_of(block), text=True, check=False,
                              capture_output=True, cwd=self.folder)
        return done.returncode, done.stdout

    def test_every_line_must_succeed(self):
        self.assertEqual(self.executed("echo a\necho b\n"), (0, "a\nb\n"))
        self.assertEqual(self.executed("echo a\nfalse\necho b\n"), (1, "a\n"))

    def test_a_line_that_says_how_it_fails_must_fail_so(self):
        line = "sh -c 'echo a; exit 5'  # exit code "
        self.assertEqual(self.executed(f"{line}5\necho b"), (0, "a\nb\n"))
        self.assertEqual(self.executed(f"{line}4\necho b"), (1, "a\n"))
        self.assertEqual(self.executed("true  # exit code 2"), (1, ""))
