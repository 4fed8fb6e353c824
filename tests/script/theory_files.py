# SPDX-License-Identifier: BSD-3-Clause
"""theory_files.py SOURCE: the files that docs/theory.md names for an equation are there and cite it, and it knows every
equation that the source cites."""

import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1])
page = (source / "docs/theory.md").read_text()
cited = re.compile(r"\(([HGCSVAWD])(\d+)\)(?:[-–]\(?\1(\d+)\)?)?|\(([HGCSVAWD])(\d+)[-–]\4(\d+)\)|\b([HGCSVAWD])(\d+)[-–]\7?(\d+)\b")


def equations(text):
    """(H7); (A1)-(A3), G1-G2 and (C1-C6) are all that they span."""
    for letter, first, last, *others in cited.findall(text):
        while not letter:
            letter, first, last, *others = others
        for number in range(int(first), int(last or first) + 1):
            yield f"{letter}{number}"


known, wrong, pairs = set(), [], 0
for row in re.findall(r"^\| \(([A-Z]\d+)\) \|(.*)\|$", page, flags=re.MULTILINE):
    name, cells = row[0], row[1]
    known.add(name)
    for file in re.findall(r"\]\(\.\./([^)#]+)\)", cells):
        if name == "D2" or file.endswith("dense_operators.hpp") and name == "H2" or "regression" in file:
            continue  # explained in words
        pairs += 1
        if not (source / file).is_file():
            wrong.append(f"{name}: there is no {file}")
        elif name not in equations((source / file).read_text()):
            wrong.append(f"{name}: {file} does not cite it")
for folder in ("include", "umat", "contact", "adapters", "element", "support"):
    for file in (source / folder).rglob("*"):
        if file.suffix in (".h", ".hpp", ".cpp"):
            for name in set(equations(file.read_text())) - known:
                wrong.append(f"{name}: cited by {file.relative_to(source)}, not in docs/theory.md")
if wrong or pairs < 50:
    sys.exit("\n".join(wrong) or f"{pairs} files only: are they still rows of tables?")
print(f"{len(known)} equations, {pairs} files")
