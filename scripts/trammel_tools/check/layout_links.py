# SPDX-License-Identifier: Apache-2.0
"""Which target may link which: build/links.txt, that CMake writes, has every link line.

A target may link those of its own room and of the rooms below it, and no target needs itself.
"""

from pathlib import Path

from trammel_tools.check.rooms import ROOMS

LINKS = Path("build", "links.txt")
ORDER = [".", *ROOMS]  # a folder that is not named is above all of them


def level(room):
    return ORDER.index(room) if room in ORDER else len(ORDER)


def read(text):
    """Room of each target, and the targets that it links."""
    rooms, links = {}, {}
    for line in text.splitlines():
        room, target, *linked = line.split()
        rooms[target] = room
        links[target] = linked
    return rooms, {target: [name for name in dict.fromkeys(linked) if name in rooms]
                   for target, linked in links.items()}


def circles(links):
    """Each circle once, as the targets along it; the first one is there twice."""
    done, path = set(), []

    def visit(target):
        if target in path:
            yield [*path[path.index(target):], target]
            return
        if target in done:
            return
        path.append(target)
        for name in links[target]:
            yield from visit(name)
        done.add(path.pop())

    for target in links:
        yield from visit(target)


def check(root):
    """Nothing where nothing has been configured yet."""
    if not (root / LINKS).is_file():
        return
    rooms, links = read((root / LINKS).read_text(encoding="utf-8"))
    for target, linked in links.items():
        for name in linked:
            if level(rooms[name]) > level(rooms[target]):
                yield (f"{rooms[target]}/CMakeLists.txt: {target} may not link {name}, "
                       f"which is of {rooms[name]}/")
    for circle in circles(links):
        yield f"{rooms[circle[0]]}/CMakeLists.txt: a circle of links: {' -> '.join(circle)}"
