# SPDX-License-Identifier: Apache-2.0
"""Pictures of the documentation: small, and the same at page size."""

import random
import re
import unittest

from trammel_tools import picture
from trammel_tools.paths import ROOT

DRAWN = """<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
 xmlns:o="http://other.example/" viewBox="0 0 99.12345 9">
<title>Plotter</title><o:notes><o:by>someone</o:by></o:notes>
<defs><path id="used" d="M 0 0
L 100.5 0
L 201.125 0
z" transform="scale(0.5)"/><path id="unused" d="M0,0 1,1"/></defs>
<style>.a { fill: none;
 stroke: #000; } .b { fill: red; }</style>
<g id="layer"><g fill="none"><path class="a" d="M0,0 L1.0000,0.001 L2,0 L3,5.6789"/></g>
<g fill="none"></g><g fill="none"><use xlink:href="#used" x="1.236"/></g></g>
<text>12.3456 &lt; <tspan>20</tspan> mm</text></svg>
"""
SLIM = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" \
viewBox="0 0 99.12 9">
<defs><path id="used" d="M 0 0 L 50.25 0 L 100.56 0 z"/></defs>
<style>.a {fill:none;stroke:#000}</style>
<g fill="none"><path class="a" d="M0,0 2,0 3,5.68"/><use xlink:href="#used" x="1.24"/></g>
<text>12.3456 &lt; <tspan>20</tspan> mm</text>
</svg>
"""


class PictureTest(unittest.TestCase):
    def test_a_picture_keeps_what_is_seen(self):
        self.assertEqual(picture.slim(DRAWN), SLIM)

    def test_a_simplified_line_is_near_the_curve(self):
        draw = random.Random(7)
        for _ in range(5):
            points = [(0.0, 0.0)]
            for _ in range(300):
                x, y = points[-1]
                points.append((x + draw.choice((-0.3, 0.3, 1)), y + draw.gauss(0, 0.1)))
            kept = picture.simplified(points)
            self.assertLess(len(kept), len(points))
            self.assertEqual((kept[0], kept[-1]), (points[0], points[-1]))
            for point in points:
                self.assertLessEqual(min(map(lambda a, b, p=point: picture.distance(p, a, b),
                                             kept, kept[1:])), picture.NEAR)

    def test_a_line_that_turns_back_reaches_as_far_as_the_curve(self):
        self.assertEqual(picture.simplified([(0, 0), (9, 0), (1, 0)]), [(0, 0), (9, 0), (1, 0)])

    def test_the_pictures_of_the_documentation_are_small(self):
        for file in sorted((ROOT / "docs" / "pictures").glob("*.svg")):
            with self.subTest(file.name):
                self.assertIsNone(re.search(r"[ ,\"MLQ-]\d*\.\d{3}", file.read_text("utf-8")))
