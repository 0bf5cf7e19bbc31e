# SPDX-License-Identifier: Apache-2.0
"""The table of all promises in docs/proofs.md: names and controls from the properties files,
sentences from the blocks' pages; a promise without one is its own, for its name is a sentence."""

import sys

import properties

PAGE = properties.ROOT / "docs" / "proofs.md"
MARK = "<!-- The rest is written by scripts/prove.py --table. -->\n"


def block_rows(block):
    """Lines of the table; raises when the page names a promise that is none."""
    props = properties.read(block)
    said = properties.sentences(block)
    for name in said:
        if name not in props.promises:
            raise properties.PropertiesError(f"rtl/{block}.md: {name} is not promised")
    yield f"\n### {block}\n\n| promise | sentence | controls |\n|---|---|---|\n"
    for name in props.promises:
        controls = sum(name in control.promises for control in props.controls)
        sentence = said.get(name, f"{name.replace('_', ' ')}.")
        yield f"| `{name}` | {sentence} | {controls} |\n"


def run(check):
    """Writes the table, or with `check` only compares it; the exit code."""
    try:
        blocks = properties.blocks()
        rows = [row for block in blocks for row in block_rows(block)]
    except properties.PropertiesError as error:
        print(f"prove: {error}", file=sys.stderr)
        return 1
    promises = sum(len(properties.read(block).promises) for block in blocks)
    text = PAGE.read_text(encoding="utf-8")
    head, mark, _ = text.partition(MARK)
    if not mark:
        print(f"prove: docs/proofs.md: no line {MARK.strip()}", file=sys.stderr)
        return 1
    fresh = f"{head}{MARK}\n## {promises} promises of {len(blocks)} blocks\n{''.join(rows)}"
    if check:
        if text != fresh:
            print("prove: docs/proofs.md is stale: scripts/prove.py --table", file=sys.stderr)
        return int(text != fresh)
    PAGE.write_text(fresh, encoding="utf-8")
    print("docs/proofs.md")
    return 0
