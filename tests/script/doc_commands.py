# SPDX-License-Identifier: BSD-3-Clause
"""doc_commands.py GRIT SOURCE WORK: commands of the program grit in the blocks of README and docs do what they are there
for: each ends with 0, in the order of the page, in a folder that looks like the source tree. Those that compute for minutes
are told, not run."""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

grit, source, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
shutil.rmtree(work, ignore_errors=True)
long = re.compile(r"^\S*grit (mpm|calibrate) ")
done, left = 0, []
for page in [source / "README.md", *sorted((source / "docs").glob("*.md"))]:
    place = work / page.stem
    place.mkdir(parents=True)
    for folder in ("verification", "examples", "docs", "README.md"):
        os.symlink(source / folder, place / folder)
    for language, block in re.findall(r"^```(\w*)\n(.*?)^```", page.read_text(), flags=re.DOTALL | re.MULTILINE):
        for line in ("" if language else block).replace("\\\n", " ").splitlines():
            if not re.match(r"(build/\w+/cli/)?grit ", line):
                continue
            if long.match(line):
                left.append(line)
                continue
            words = shlex.split(line, comments=True)
            if page.stem == "element-tests" and words[1] == "plot":  # of a run that the page does not repeat
                subprocess.run([grit, "element", "verification/cases/karlsruhe_drained_triaxial.toml", "--no-plot", "--quiet",
                                "--out", "results"], cwd=place, check=True, capture_output=True)
            run = subprocess.run([grit, *words[1:]], cwd=place, capture_output=True, text=True)
            if run.returncode != 0:
                sys.exit(f"{page}: {line}\nended with {run.returncode}:\n{run.stdout}{run.stderr}")
            done += 1
if done < 6:
    sys.exit(f"{done} commands only: are they still written as blocks?")
print(f"{done} commands run, {len(left)} not: {left}")
