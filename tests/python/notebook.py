# SPDX-License-Identifier: BSD-3-Clause
"""notebook.py FILE.ipynb: its cells run from the first to the last, each prints what stands below it, and each picture
has its curves. It keeps no outputs, so that a change of it is a change of words."""

import ast
import contextlib
import io
import json
import pathlib
import re
import sys

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


def run(source, names):
    """What the cell prints, and the value of its last line, as notebooks show both."""
    body = ast.parse(source).body
    last = body.pop() if isinstance(body[-1], ast.Expr) and not isinstance(body[-1].value, ast.Constant) else None
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(ast.Module(body, []), "cell", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "cell", "eval"), names) if last else None
    return printed.getvalue().strip(), value


def same(said, printed):
    """The same words, and numbers within 0.2 %: instruction sets differ in the last digits."""
    numbers = [[float(each) for each in NUMBER.findall(text)] for text in (said, printed)]
    return NUMBER.sub("#", said) == NUMBER.sub("#", printed) and all(
        abs(a - b) <= 2e-3 * max(abs(a), abs(b)) for a, b in zip(*numbers))


notebook = json.loads(pathlib.Path(sys.argv[1]).read_text())
assert notebook["nbformat"] == 4
cells = [(each["cell_type"], "".join(each["source"]), each) for each in notebook["cells"]]
assert len({each["id"] for _, _, each in cells}) == len(cells), "two cells have one id"
names, pictures = {}, 0
for (kind, source, cell), after in zip(cells, cells[1:] + [("", "", {})]):
    if kind != "code":
        continue
    assert cell["outputs"] == [] and cell["execution_count"] is None, "outputs are kept: clear them"
    printed, value = run(source, names)
    below = re.match(r"```\n(.*?)\n```", after[1], re.DOTALL)
    said = below[1] if below else ""
    assert same(said, printed), f"below\n{source}\nstands\n{said}\nit prints\n{printed}"
    if value is not None:
        picture = value._repr_svg_()
        assert picture.startswith("<?xml") and "</svg>" in picture
        assert re.search(r'<g id="gnuplot_plot_1".*?<path [^>]*d=\'M[\d.,]+ L', picture, re.DOTALL), picture
        pathlib.Path(f"picture_{pictures}.svg").write_text(picture)
        pictures += 1
assert pictures == 5, pictures
