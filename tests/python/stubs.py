# SPDX-License-Identifier: BSD-3-Clause
"""The stubs say what the module is: every name, and every argument with its default, in the order and of the kind that
inspect.signature() tells. And help(grit) teaches what is true: its examples run."""

import ast
import doctest
import inspect
import pathlib
import pydoc

import grit

package = pathlib.Path(grit.__file__).parent


def parsed(name):
    return ast.parse((package / name).read_text()).body


def functions(body):
    return {each.name: each for each in body if isinstance(each, ast.FunctionDef)}


def told(function):
    """Arguments as (name, kind, default or "..."); of self the name alone."""
    arguments = function.args
    missing = len(arguments.args) - len(arguments.defaults)
    positional = [None] * missing + arguments.defaults
    out = [(each.arg, "positional", default) for each, default in zip(arguments.args, positional)]
    out += [(each.arg, "keyword", default) for each, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return [(name, kind, default and ast.unparse(default)) for name, kind, default in out]


def read(signature):
    """The same of what Python tells."""
    kinds = {"POSITIONAL_ONLY": "positional", "POSITIONAL_OR_KEYWORD": "positional", "KEYWORD_ONLY": "keyword"}
    return [(each.name, kinds[each.kind.name], None if each.default is each.empty else repr(each.default))
            for each in signature.parameters.values() if each.kind.name in kinds]


def same(stub, real, where):
    assert [each[:2] for each in stub] == [each[:2] for each in real], f"{where}: {stub} is not {real}"
    for (name, _, said), (_, _, is_) in zip(stub, real):
        assert (said is None) == (is_ is None), f"{where}: {name}"
        if said not in (None, "..."):
            assert ast.literal_eval(said) == ast.literal_eval(is_), f"{where}: {name} = {said}, is {is_}"


def compare(stubs, owner, where):
    count = 0
    for name, stub in functions(stubs).items():
        real = getattr(owner, name)
        if any(ast.unparse(each) == "property" for each in stub.decorator_list):
            assert isinstance(getattr(owner, name), property), name
            continue
        same(told(stub), read(inspect.signature(real)), f"{where}.{name}")
        count += 1
    return count


def names_of(body):
    for each in body:
        if isinstance(each, ast.AnnAssign):
            yield each.target.id
        elif isinstance(each, (ast.FunctionDef, ast.ClassDef)):
            yield each.name


top = parsed("__init__.pyi")
assert set(names_of(top)) | {"stage"} == set(grit.__all__), set(names_of(top)) ^ set(grit.__all__)
stage = parsed("stage.pyi")
public = {name for name in vars(grit.stage) if not name.startswith("_")}
assert set(names_of(stage)) == public, set(names_of(stage)) ^ public
count = compare(top, grit, "grit") + compare(stage, grit.stage, "grit.stage")
for kind in (grit.Sand, grit.ContactSurfaces):
    (stub,) = [each for each in top if isinstance(each, ast.ClassDef) and each.name == kind.__name__]
    public = {name for name in vars(kind) if not name.startswith("_")} | {"__init__"}
    assert set(names_of(stub.body)) == public, set(names_of(stub.body)) ^ public
    count += compare(stub.body, kind, f"grit.{kind.__name__}")
assert count > 35, count
failed, tried = doctest.testmod(grit)
assert failed == 0 and tried >= 18, (failed, tried)
screen = "\n".join(pydoc.plain(pydoc.render_doc(grit)).splitlines()[:30])  # the first one
assert "array([-406.3" in screen and "contact_correct" in screen, screen
print(f"{count} signatures, {tried} examples")
