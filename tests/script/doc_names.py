# SPDX-License-Identifier: BSD-3-Clause
"""doc_names.py SOURCE BUILD: what README and docs name and doc_commands.py does not run is there: the tests that `ctest -R` is given,
presets, scripts, cases, and programs that the build makes."""

import pathlib
import re
import shutil
import subprocess
import sys

source, build = map(pathlib.Path, sys.argv[1:3])
listed = subprocess.run(["ctest", "--test-dir", build, "-N"], capture_output=True, text=True, check=True).stdout
tests = re.findall(r"Test +#\d+: (.+)", listed)
presets = set(re.findall(r'"name": "(\w+)"', (source / "CMakePresets.json").read_text()))
counts, missing = {}, []


def expect(kind, page, what, there):
    counts[kind] = counts.get(kind, 0) + 1
    if not there:
        missing.append(f"{page.relative_to(source)}: {what}")


for page in [source / "README.md", *sorted((source / "docs").rglob("*.md"))]:
    text = page.read_text()
    for match in re.finditer(r"""ctest[^`\n]*?-R\s+(?:'([^']+)'|"([^"]+)"|([^`\s]+))""", text):
        pattern = next(filter(None, match.groups()))
        if pattern == "Valgrind" and not shutil.which("valgrind"):
            continue  # tests that are there where it is
        expect("patterns of tests", page, f"ctest -R {pattern}", any(re.search(pattern, test) for test in tests))
    for preset in re.findall(r"--preset[ =](\w+)", text):
        expect("presets", page, f"--preset {preset}", preset in presets)
    for name in re.findall(r"(?<![\w/.-])((?:script|verification)/[\w/-]+(?:\.\w+)?)(?=[`\s')])", text):
        expect("scripts and cases", page, name, (source / name).exists() or (build / name).exists())
    for name in re.findall(r"build/\w+/((?:cli|examples|verification)/[\w/-]+)(?![\w./-])", text):
        expect("programs", page, f"build/.../{name}", (build / name).exists())
if missing:
    sys.exit("not there:\n  " + "\n  ".join(missing))
if min(counts.get(kind, 0) for kind in ("patterns of tests", "presets", "scripts and cases", "programs")) < 20:
    sys.exit(f"{counts} only: are they still written so?")
print(", ".join(f"{n} {kind}" for kind, n in counts.items()) + " are there")
