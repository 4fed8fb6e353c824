# SPDX-License-Identifier: BSD-3-Clause
"""What the blocks of a page mean: files, whose first line is a comment with their name, commands, and, as `text`, what the
commands before it print. doc_commands.py does them beside a build, script/try_pages on a bare system."""

import re
import sys

FENCE = re.compile(r"^```([\w-]*)\n(.*?)^```$", flags=re.DOTALL | re.MULTILINE)


def name_of_file(page, language, block):
    """Of a block of a language."""
    name = re.match(r"(?:/\*|//|!|#) (\S+\.\w+)", block)
    if not name:
        sys.exit(f"{page}: a block of {language} without the name of its file:\n{block}")
    return name[1]


def lines_of(block):
    """Commands of a block."""
    return [line for line in block.replace("\\\n", " ").splitlines() if line.strip()]


def near(told, printed):
    """The same words, and numbers as near as two instruction sets are."""
    a, b = told.split(), printed.split()
    try:
        return len(a) == len(b) and all(x == y or abs(float(x) - float(y)) <= 2e-6 + 1e-6 * abs(float(y)) for x, y in zip(a, b))
    except ValueError:
        return False


def as_promised(page, promised, printed):
    """Lines of promised in printed, in their order; between them only where it says so."""
    rest, gap = printed.splitlines(), False
    for line in promised.splitlines():
        if line == "...":
            gap = True
            continue
        at = next((i for i, other in enumerate(rest if gap else rest[:1]) if near(line, other)), None)
        if at is None:
            sys.exit(f"{page} promises\n{line}\nits commands printed\n{printed}")
        rest, gap = rest[at + 1:], False
    if rest and not gap or not promised.strip():
        sys.exit(f"{page} does not tell that its commands print\n" + "\n".join(rest))
