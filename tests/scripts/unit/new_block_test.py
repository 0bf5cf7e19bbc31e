# SPDX-License-Identifier: Apache-2.0
"""A new block keeps the rules of the layout, and nothing is overwritten."""

from scratch import Scratch, call
from trammel_tools.check import check_layout
from trammel_tools.generate import new_block


class NewBlockTest(Scratch):
    def setUp(self):
        super().setUp()
        self.init()
        self.patch(new_block, ROOT=self.folder)

    def test_a_new_block_has_all_that_the_layout_asks_for(self):
        code, out, err = call(new_block.main, "drive/soft_start")
        self.assertEqual((code, err), (0, "next: write them, then ./trammel test "
                                          "drive/soft_start\n"))
        self.assertEqual(out.splitlines(), [
            "rtl/drive/soft_start.sv", "rtl/drive/soft_start_props.sv", "rtl/drive/soft_start.md",
            "models/exact/drive/soft_start.hpp", "tests/drive/soft_start_test.cpp"])
        self.assertEqual(list(check_layout.findings(self.folder)), [])
        self.assertIn("struct SoftStart {",
                      (self.folder / "models/exact/drive/soft_start.hpp").read_text())

    def test_a_file_that_exists_stays(self):
        page = self.write("rtl/drive/soft_start.md", "mine\n")
        self.assertEqual(call(new_block.main, "drive/soft_start"),
                         (2, "", "new-block: rtl/drive/soft_start.md exists\n"))
        self.assertEqual(list(self.folder.rglob("*soft_start*")), [page])

    def test_a_link_that_leads_nowhere_is_not_written_through(self):
        (self.folder / "rtl" / "drive").mkdir(parents=True)
        (self.folder / "rtl" / "drive" / "zzz.md").symlink_to(self.folder / "victim")
        self.assertEqual(call(new_block.main, "drive/zzz"),
                         (2, "", "new-block: rtl/drive/zzz.md exists\n"))
        self.assertEqual([path.name for path in self.folder.rglob("*zzz*")], ["zzz.md"])
        self.assertFalse((self.folder / "victim").exists())

    def test_a_name_that_is_too_long_for_one_of_the_files_makes_none(self):
        for length in 300, 248:
            code, out, err = call(new_block.main, "drive/" + "a" * length)
            self.assertEqual((code, out, err.count("\n")), (2, "", 1))
            self.assertIn("File name too long", err)
            self.assertEqual(list(self.folder.rglob("aaa*")), [])

    def test_names_that_are_none_are_refused_with_the_layers(self):
        for name in ("soft_start", "chips/soft", "drive/Soft", "drive/2soft", "drive/../x",
                     "drive/a__b", "drive/"):
            with self.subTest(name):
                code, out, err = call(new_block.main, name)
                self.assertEqual((code, out, err.count("\n")), (2, "", 1))
                self.assertIn("layers: math, sense, drive, control, motion, bus", err)
