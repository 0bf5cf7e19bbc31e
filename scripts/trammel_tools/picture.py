# SPDX-License-Identifier: Apache-2.0
"""SVG pictures for the documentation: small, and one element a line for reviewers."""

import math
import re
from xml.etree import ElementTree
from xml.sax.saxutils import escape, quoteattr

DECIMALS = 2
NEAR = 0.1  # [px] between a curve and its simplified line
NAMESPACES = {"http://www.w3.org/2000/svg": "", "http://www.w3.org/1999/xlink": "xlink:",
              "http://www.w3.org/XML/1998/namespace": "xml:"}
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
POINT = re.compile(rf"({NUMBER})[\s,]+({NUMBER})")
SCALED = re.compile(rf"scale\(({NUMBER})\)")
INHERITED = {"fill", "color", "stroke", "stroke-width", "stroke-linecap", "stroke-linejoin"}
UNSEEN = {"metadata", "desc", "title"}
NAMES = {"id", "class", "href", "version", "baseProfile"}
TEXT = {"text", "tspan", "style"}


def rounded(number):
    """A number with at most two decimals: "1.50" is 1.5, "-0.001" is 0."""
    text = f"{float(number):.{DECIMALS}f}".rstrip("0").rstrip(".") if "." in number or (
        "e" in number.lower()) else number
    return "0" if text in ("-0", "") else text


def distance(point, one, two):
    """From a point to the line between two others."""
    x, y = point[0] - one[0], point[1] - one[1]
    dx, dy = two[0] - one[0], two[1] - one[1]
    square = dx * dx + dy * dy
    along = min(1, max(0, (x * dx + y * dy) / square)) if square else 0
    return math.hypot(x - along * dx, y - along * dy)


def simplified(points):
    """The points without those that are nearer than NEAR to the line between their neighbours."""
    keep = {0, len(points) - 1}
    spans = [(0, len(points) - 1)]
    while spans:
        first, last = spans.pop()
        far, where = max(((distance(points[i], points[first], points[last]), i)
                          for i in range(first + 1, last)), default=(0, first))
        if far > NEAR:
            keep.add(where)
            spans += [(first, where), (where, last)]
    return [points[i] for i in sorted(keep)]


def path(text, scale):
    """The `d` of a path; one of straight lines is simplified."""
    def line(match):
        points = simplified([(float(x) * scale, float(y) * scale)
                             for x, y in POINT.findall(match[0])])
        return "M" + " ".join(f"{rounded(f'{x:f}')},{rounded(f'{y:f}')}" for x, y in points)
    text = re.sub(r"\s+", " ", text).strip()
    if scale == 1:
        text = re.sub(rf"M ?{POINT.pattern}(?: ?L ?{POINT.pattern})+", line, text)
    return re.sub(NUMBER, lambda match: rounded(f"{float(match[0]) * scale:f}"), text)


def name_of(name):
    space, _, short = name[1:].rpartition("}") if name.startswith("{") else ("", "", name)
    return NAMESPACES.get(space, None if space else ""), short


def attributes(element, scale):
    """The attributes as they are written: those of other programs go, numbers are rounded."""
    found = {}
    for name, value in element.attrib.items():
        prefix, short = name_of(name)
        if prefix is None:
            continue
        found[prefix + short] = (
            path(value, scale) if short == "d" else value if short in NAMES else
            re.sub(rf"(?<![#\w.]){NUMBER}", lambda match: rounded(match[0]),
                   re.sub(r"\s+", " ", value).strip().rstrip(";")))
    return found


class Picture:
    def __init__(self, text):
        self.root = ElementTree.fromstring(text)
        self.scales = {}  # of glyphs, which are written in the size they are drawn in
        for element in self.root.iter():
            scale = SCALED.fullmatch(element.get("transform", ""))
            if name_of(element.tag)[1] == "path" and scale:
                self.scales[element] = float(scale[1])
                del element.attrib["transform"]
        while self.cleaned():
            pass

    def used(self):
        """Names that the picture refers to: of elements, and of rules of its style sheet."""
        ids, classes = set(), set()
        for element in self.root.iter():
            for name, value in element.attrib.items():
                if name.endswith("href"):
                    ids.add(value.lstrip("#"))
                ids.update(re.findall(r"url\(#([^)]+)\)", value))
            classes.update(element.get("class", "").split())
        return ids, classes

    def cleaned(self):
        """Drops what is not seen, and says whether there was any."""
        before = sum(1 + len(element.attrib) for element in self.root.iter())
        self.clean(self.root, *self.used())
        return sum(1 + len(element.attrib) for element in self.root.iter()) < before

    def clean(self, parent, ids, classes):
        kept = []
        in_defs = name_of(parent.tag)[1] == "defs"
        for child in parent:
            self.clean(child, ids, classes)
            prefix, tag = name_of(child.tag)
            if child.get("id") not in ids:
                child.attrib.pop("id", None)
            if tag == "style":
                child.text = rules(child.text or "", classes)
            unused = in_defs and tag != "style" and "id" not in child.attrib
            empty = tag in ("g", "defs") and not len(child)
            if prefix is None or tag in UNSEEN or unused or empty:
                continue
            if tag == "g" and not child.attrib:
                kept += child
            elif tag == "g" and kept and set(child.attrib) <= INHERITED and (
                    child.tag, child.attrib) == (kept[-1].tag, kept[-1].attrib):
                kept[-1].extend(child)
            else:
                kept.append(child)
        parent[:] = kept

    def lines(self, element, inside=False):
        """The lines of an element; one that holds text, or no groups, is one line."""
        _, tag = name_of(element.tag)
        words = "".join(f" {name}={quoteattr(value)}" for name, value in
                        attributes(element, self.scales.get(element, 1)).items())
        if element is self.root:
            words = f' xmlns="{next(iter(NAMESPACES))}"' + (
                ' xmlns:xlink="http://www.w3.org/1999/xlink"' if any(
                    name.startswith("{http://www.w3.org/1999/xlink}") for one in self.root.iter()
                    for name in one.attrib) else "") + words
        text = tag in TEXT or inside
        own = escape(element.text or "") if text else ""
        children = [self.lines(child, text) for child in element]
        if text:
            tails = [escape(child.tail or "") for child in element]
            body = own + "".join("".join(lines) + tail for lines, tail in
                                 zip(children, tails, strict=True))
            return [f"<{tag}{words}>{body}</{tag}>" if body else f"<{tag}{words}/>"]
        if not children:
            return [f"<{tag}{words}/>"]
        lines = [f"<{tag}{words}>", *(line for lines in children for line in lines), f"</{tag}>"]
        flat = not any(len(one) for child in element for one in child)
        return ["".join(lines)] if flat and element is not self.root else lines


def rules(sheet, classes):
    """One rule a line, and only those of classes and elements that are there."""
    kept = []
    for selector, body in re.findall(r"([^{}]+)\{([^{}]*)\}", sheet):
        names = re.findall(r"\.([\w-]+)", selector)
        if not names or any(name in classes for name in names):
            short = re.sub(r"\s*([:;])\s*", r"\1", re.sub(r"\s+", " ", body)).strip(" ;")
            kept.append(f"{selector.strip()} {{{short}}}")
    return "\n".join(kept)


def slim(text):
    """The same picture at page size: two decimals, simplified lines, and nothing unseen."""
    picture = Picture(text)
    return "\n".join(picture.lines(picture.root)) + "\n"
