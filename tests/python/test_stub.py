"""The stub (__init__.pyi) says of every name what the module says."""

import ast
import pathlib

import pytest
import tractus

STUB = ast.parse((pathlib.Path(__file__).parents[2] / "app" / "python" / "__init__.pyi").read_text())
# What Python gives every class.
EVERYWHERE = set(dir(object)) | {"__module__", "__weakref__", "__dict__"}


def public(names):
    return {name for name in names if not name.startswith("__") or name in ("__len__", "__version__", "__init__")}


def names_of(body):
    names = set()
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            names.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            names.add(node.target.id)
    return names


STUB_CLASSES = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}


def functions():
    """Name, stub and docstring of all functions and methods."""
    for node in STUB.body:
        if isinstance(node, ast.FunctionDef):
            yield node.name, node, getattr(tractus, node.name)
        elif isinstance(node, ast.ClassDef) and node.name != "Error":
            for method in node.body:
                if isinstance(method, ast.FunctionDef) and not is_property(method):
                    yield f"{node.name}.{method.name}", method, getattr(getattr(tractus, node.name), method.name)


def is_property(function):
    return any(isinstance(node, ast.Name) and node.id == "property" for node in function.decorator_list)


def parameters(function):
    """Names, kinds and defaults, in a form that can be compared."""
    arguments = function.args
    positional = [argument.arg for argument in arguments.posonlyargs + arguments.args if argument.arg != "self"]
    return (
        positional,
        [argument.arg for argument in arguments.kwonlyargs],
        [ast.literal_eval(default) for default in arguments.defaults],
        [default and ast.literal_eval(default) for default in arguments.kw_defaults],
        arguments.kwarg and arguments.kwarg.arg,
    )


def test_module_and_stub_have_the_same_names():
    assert public(names_of(STUB.body)) == public(dir(tractus))


@pytest.mark.parametrize("name", STUB_CLASSES)
def test_classes_have_the_same_members(name):
    own = set(vars(getattr(tractus, name)))
    if name == "Error":
        assert "fault" in own
        return
    stub = names_of(STUB_CLASSES[name].body)
    if "__init__" not in stub: # Only functions of the module make its objects.
        with pytest.raises(TypeError, match="No constructor defined"):
            getattr(tractus, name)()
        own.discard("__init__")
    assert public(own) == stub


@pytest.mark.parametrize("name", STUB_CLASSES)
def test_properties_are_properties(name):
    for node in STUB_CLASSES[name].body:
        if isinstance(node, ast.FunctionDef) and is_property(node):
            assert isinstance(getattr(getattr(tractus, name), node.name), property), node.name


@pytest.mark.parametrize("function", [entry[0] for entry in functions()])
def test_functions_have_the_same_parameters(function):
    ((stub, own),) = [(stub, own) for name, stub, own in functions() if name == function]
    signature = own.__doc__.split("\n")[0] # pybind11 writes it there.
    (built,) = ast.parse(f"def {signature}: ...").body
    assert parameters(stub) == parameters(built)


def test_everything_has_a_docstring():
    bare = [name for name, _, own in functions() if len(own.__doc__.split("\n\n")) < 2 and not name.endswith(("__init__", "__len__"))]
    for name in STUB_CLASSES:
        if not getattr(tractus, name).__doc__:
            bare.append(name)
    assert bare == []


def test_the_stub_annotates_everything():
    for name, function, _ in functions():
        assert function.returns, name
        for argument in function.args.args + function.args.kwonlyargs:
            assert argument.annotation or argument.arg == "self", (name, argument.arg)
