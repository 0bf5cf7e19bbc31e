# SPDX-License-Identifier: Apache-2.0
"""What a module is made of."""

import re


def modules(top, files):
    """{name: text without comments} of a module and of all that it contains, of these files."""
    texts = {path.stem: re.sub(r"//.*", "", path.read_text(encoding="utf-8")) for path in files}
    found, left = {}, [top]
    while left:
        name = left.pop()
        if name in texts and name not in found:
            found[name] = texts[name]
            left += re.findall(r"^\s*(\w+)\s+(?:#\s*\(|\w+\s*\()", texts[name], re.M)
    return found
