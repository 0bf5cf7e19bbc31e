# SPDX-License-Identifier: Apache-2.0
"""Texts of others as a terminal, a message or a picture can show them."""

import unicodedata

UNSEEN = {"Cc", "Cf", "Cs", "Zl", "Zp"}  # control, format, half characters, separators of lines


def character(code):
    """What is seen of a character that has no shape of its own, or of a byte that is no UTF-8."""
    if 0xDC80 <= code <= 0xDCFF:
        return f"\\x{code - 0xDC00:02x}"
    return f"\\U{code:08x}" if code > 0xFFFF else f"\\u{code:04x}"


def is_unseen(c):
    return unicodedata.category(c) in UNSEEN or ord(c) & 0xFFFE == 0xFFFE  # the latter is none


def shown(text, kept="\n\t"):
    """The text as a terminal can show it: lines and tabs stay."""
    if text.isascii() and text.replace("\n", "").replace("\t", "").isprintable() \
            and (kept or text.isprintable()):
        return text
    return "".join(character(ord(c)) if c not in kept and is_unseen(c) else c for c in text)


def one_line(text):
    """The same for a message or a label: the ends of lines in it are seen too."""
    return shown(text, kept="")
