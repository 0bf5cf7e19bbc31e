# SPDX-License-Identifier: Apache-2.0
"""A file that the user names replaces regular files only, and none of a run's record."""

import json
import os
from unittest import mock

from scratch import Scratch
from trammel_tools import output_file
from trammel_tools.output_file import Refused


class ReplaceTest(Scratch):
    def refused(self, path, why):
        """Nothing changes there, and nothing is left behind."""
        before = sorted(self.folder.rglob("*"))
        with self.assertRaisesRegex(Refused, f"^{path}: {why}"):
            output_file.replace(path, "new")
        self.assertEqual(sorted(self.folder.rglob("*")), before)

    def test_a_regular_file_is_replaced_by_a_whole_one(self):
        file = self.write("a.svg", "mine")
        other = self.folder / "b.svg"
        os.link(file, other)
        output_file.replace(file, "new")
        self.assertEqual((file.read_text(), other.read_text()), ("new", "mine"))
        mask = os.umask(0)
        os.umask(mask)
        self.assertEqual(file.stat().st_mode & 0o777, 0o666 & ~mask)
        self.assertEqual(len(list(self.folder.iterdir())), 2)

    def test_no_link_is_followed_and_nothing_is_written_to_what_is_no_file(self):
        victim = self.write("victim", "mine")
        (self.folder / "link").symlink_to(victim)
        (self.folder / "dangling").symlink_to("nowhere")
        (self.folder / "folder").mkdir()
        os.mkfifo(self.folder / "fifo")
        for name in "link", "dangling", "folder", "fifo":
            with self.subTest(name):
                self.refused(self.folder / name, "cannot be written: not a regular file")
        with self.assertRaisesRegex(Refused, "not a regular file"):
            output_file.check("/dev/null")  # not replace(): without the check root would lose it
        self.assertEqual(victim.read_text(), "mine")

    def test_a_place_that_is_none_is_told(self):
        file = self.write("file", "")
        self.refused(self.folder / "no" / "a", "cannot be written: No such file or directory")
        self.refused(file / "a", "cannot be written: .*[Nn]ot a (directory|folder)")
        self.refused(self.folder / ("a" * 300), "cannot be written: File name too long")

    def test_what_fails_leaves_the_old_file_and_nothing_else(self):
        file = self.write("a.svg", "mine")
        with self.assertRaisesRegex(KeyError, "body"), output_file.replacing(file) as scratch:
            scratch.write_text("half")
            raise KeyError("body")
        with mock.patch("os.replace", side_effect=OSError(28, "No space left on device")):
            self.refused(file, "cannot be written: No space")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["a.svg"])
        self.assertEqual(file.read_text(), "mine")

    def test_a_name_of_255_characters_is_one(self):
        output_file.replace(self.folder / ("a" * 255), "new")

    def test_files_that_a_record_lists_stay(self):
        self.write("run.json", json.dumps({"trammel": "1", "files": {"path.svg": {}, "report.html":
                                                                     {}}}))
        self.write("path.svg", "run's")
        for name in "path.svg", "run.json":
            self.refused(self.folder / name, "is a file of a run's record")
        (self.folder / "path.svg").unlink()
        self.refused(self.folder / "path.svg", "is a file of a run's record")
        for name in "report.html", "metrics.json", "own.svg":
            output_file.replace(self.folder / name, "new")

    def test_without_a_list_names_of_a_record_stay(self):
        for text in None, "no JSON", "[]", '{"trammel": 1, "files": []}', "[" * 100000:
            if text is not None:
                self.write("run.json", text)
            for name in output_file.RECORD:
                output_file.replace(self.folder / name, "new")
                self.refused(self.folder / name, "is a file of a run's record")
                (self.folder / name).unlink()
            output_file.replace(self.folder / "path.svg", "new")


class CreateTest(Scratch):
    def refused(self, texts, why):
        before = sorted(path for path in self.folder.rglob("*") if not path.is_dir())
        with self.assertRaisesRegex(Refused, why):
            output_file.create(self.folder, texts)
        self.assertEqual(sorted(path for path in self.folder.rglob("*") if not path.is_dir()),
                         before)

    def test_files_are_made_with_their_folders(self):
        output_file.create(self.folder, {"a/b": "one", "c": "two"})
        self.assertEqual((self.folder / "a" / "b").read_text(), "one")

    def test_all_are_made_or_none(self):
        self.write("c", "mine")
        self.refused({"a/b": "one", "c": "two"}, "^c exists$")
        self.refused({"a/b": "one", "a" * 300: "two"}, "cannot be written: File name too long")
        (self.folder / "link").symlink_to("nowhere")
        self.refused({"a/b": "one", "link": "two"}, "^link exists$")

    def test_what_comes_in_between_is_not_written_through(self):
        victim = self.write("victim", "mine")
        (self.folder / "link").symlink_to(victim)
        with mock.patch.object(output_file, "is_there", return_value=False):
            self.refused({"a/b": "one", "link": "two"}, "cannot be written: File exists")
        self.assertEqual(victim.read_text(), "mine")
