# SPDX-License-Identifier: BSD-3-Clause
"""What the blocks of a page mean. Without a language: commands. `text`: what the commands before it print. A language whose first
line is a comment with a name: that file. `usage`: how a program is called, not a call. Anything else is a fragment, for which
doc_worlds.py has what is around it. doc_commands.py does them beside a build, script/try_pages on a bare system."""

import re
import sys

FENCE = re.compile(r"^```([\w-]*)\n(.*?)^```$", flags=re.DOTALL | re.MULTILINE)


def blocks_of(page):
    """(language, block), in order. All are fenced: an indented one is refused, so that none is passed over."""
    text = page.read_text()
    for paragraph in re.split(r"\n\s*\n", FENCE.sub("\n", text)):
        if all(line.startswith("    ") for line in paragraph.strip("\n").splitlines()) and paragraph.strip():
            sys.exit(f"{page}: an indented block, which no test would find: between ``` instead:\n{paragraph}")
    return FENCE.findall(text)


def name_of_file(block):
    """None of a fragment."""
    name = re.match(r"(?:/\*|//|!|#) (\S+\.\w+)(?: \*/)?\n", block)
    return name and name[1]


def lines_of(block):
    """Commands of a block."""
    return [line for line in block.replace("\\\n", " ").splitlines() if line.strip()]


def near(told, printed, share=1e-6):
    """The same words, and numbers as near as two instruction sets are."""
    a, b = told.split(), printed.split()
    try:
        return len(a) == len(b) and all(x == y or abs(float(x) - float(y)) <= 2e-6 + share * abs(float(y)) for x, y in zip(a, b))
    except ValueError:
        return False


def as_promised(page, promised, printed, share=1e-6):
    """Lines of promised in printed, in their order; between them only where it says so."""
    rest, gap = printed.splitlines(), False
    for line in promised.splitlines():
        if line == "...":
            gap = True
            continue
        at = next((i for i, other in enumerate(rest if gap else rest[:1]) if near(line, other, share)), None)
        if at is None:
            sys.exit(f"{page} promises\n{line}\nits commands printed\n{printed}")
        rest, gap = rest[at + 1:], False
    if rest and not gap or not promised.strip():
        sys.exit(f"{page} does not tell that its commands print\n" + "\n".join(rest))
