#!/usr/bin/python3
"""generate_stubs.py FOLDER: write type stubs (.pyi) of the wrapped modules into the package's folder.

Stubs have the signatures of each method in Python, and the header's text, which editors show. Methods of
one group share one text in a header; a stub gives it to all.

Functions in Python whose keyword arguments are the properties of a filter have stubs with these keywords.

Where vtkmodules comes without stubs, as Debian's does, the classes ours are derived from are written
too, into _types.pyi: otherwise a checker would take any method for one that they may have.
"""
import ast
import inspect
import os
import re
import sys

from vtkmodules.vtkCommonCore import vtkVersion

# The package that stubs are made of. PYTHONPATH stays: pip sets it to where it has put VTK.
sys.path.insert(0, os.path.dirname(os.path.abspath(sys.argv[1])))
import conformalsom

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Describe"))
import functions
from wrapped import signatures_of, texts_of

INHERITED = ("IsA", "IsTypeOf", "GetNumberOfGenerationsFromBase", "GetNumberOfGenerationsFromBaseType")
BUILTIN = ("None", "bool", "bytes", "float", "int", "str", "Any")
PYTHONIC = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) >= (9, 4)
HEADER = '"""Made by generate_stubs.py."""\nfrom typing import Any, Callable, List, MutableSequence, Optional, Tuple, Union, overload\n'
VALUES = '''# mypy: disable-error-code="misc"
# since VTK's own overloads overlap
from typing import Protocol, TypeVar

Value = TypeVar("Value", covariant=True)

class Values(Protocol[Value]):
    """What a method takes for several numbers: a tuple, a list, an array."""
    def __len__(self) -> int: ...
    def __getitem__(self, index: int, /) -> Value: ...
'''


def has_stubs(module):
    """Whether a package of VTK's comes with stubs that checkers read."""
    folder = os.path.dirname(os.path.abspath(sys.modules[module.partition(".")[0]].__file__))
    names = (module.partition(".")[2] + ".pyi", "py.typed")
    return all(os.path.exists(os.path.join(folder, name)) for name in names)


class Stub:
    """The stub of one module, in the making."""

    def __init__(self, classes):
        self.classes = classes
        self.imports = set()

    def type_named(self, name):
        """A class of VTK or ours, with its module; Any if there is none of the name."""
        class_ = getattr(conformalsom, name, None)
        for module in list(sys.modules.values()):
            if class_ is None and getattr(module, "__name__", "").startswith("vtkmodules.vtk"):
                class_ = vars(module).get(name)
        if not inspect.isclass(class_):
            return "Any"
        if class_ in self.classes:
            return name
        self.imports.add(class_.__module__)
        return f"{class_.__module__}.{name}"

    def annotation(self, node, of_argument, optional=False):
        """A type that the wrapper names, as a checker understands it."""
        if isinstance(node, (ast.Tuple, ast.List)):
            items = [self.annotation(item, of_argument) for item in node.elts]
            if isinstance(node, ast.Tuple):
                return f"Values[{items[0]}]" if of_argument else f"Tuple[{', '.join(items)}]"
            return f"{'MutableSequence' if of_argument else 'List'}[{items[0]}]"
        name = ast.unparse(node) if node is not None else "Any"
        if name == "Callback":
            return "Callable[..., Any]"
        if name not in BUILTIN:
            name = self.type_named(name)
        takes_none = optional and (name == "str" or name not in BUILTIN)
        return f"Optional[{name}]" if takes_none else name

    def definition(self, signature):
        """A line of the wrapper as that of a stub; the method is static if it has no self."""
        function = ast.parse(f"def {signature}: ...").body[0]
        arguments, defaults = function.args.args, function.args.defaults
        static = not arguments or arguments[0].arg != "self"
        words = [] if static else ["self"]
        for place, argument in enumerate(arguments[len(words):], len(words)):
            name = re.sub(r"^_+(arg)?", lambda m: "value" if m[1] else "", argument.arg) or "value"
            type_ = self.annotation(argument.annotation, True, function.name.startswith("Set"))
            if function.name == "AddObserver" and name == "event":
                type_ = "Union[int, str]"  # the wrapper names the first of them only
            text = f"{name}: {type_}"
            words.append(text + " = ..." * (place >= len(arguments) - len(defaults)))
        if len(words) > (not static):
            words.append("/")  # VTK takes them by place only
        returned = self.annotation(function.returns, False)
        return static, f"def {function.name}({', '.join(words)}) -> {returned}:"

    def method(self, name, method, text):
        """A method, once for each of its signatures, with its text."""
        definitions = list(dict.fromkeys(map(self.definition, signatures_of(name, method))))
        for place, (static, line) in enumerate(definitions):
            yield from ["@overload"] * (len(definitions) > 1) + ["@staticmethod"] * static
            yield from documented(line, text if place == 0 else "")

    def class_(self, class_):
        """A class with its enumerations, constants, properties and methods."""
        [base] = class_.__bases__
        yield from documented(f"class {class_.__name__}({self.base(base)}):", class_.__doc__)
        texts = texts_of(class_)
        if PYTHONIC:
            yield "    def __init__(self, **properties: Any) -> None: ..."
        for name, member in vars(class_).items():
            lines = []
            if name in INHERITED and base is not object:
                continue
            if inspect.isclass(member):
                lines = [f"class {name}(int): ..."]
            elif isinstance(member, int):
                lines = [f"{name}: int"]
            elif inspect.isgetsetdescriptor(member) and not name.startswith("__"):
                lines = self.property(name, member, class_, texts)
            elif inspect.isroutine(member) and not name.startswith("__"):
                lines = self.method(name, member, texts[name])
            elif name in ("__rshift__", "__rrshift__", "__call__"):
                lines = [f"def {name}(self, *inputs: Any, **named: Any) -> Any: ..."]
            yield from ("    " + line if line else "" for line in lines)

    def property(self, name, member, class_, texts):
        """A property in snake case, with the type and the text of the methods that it calls."""
        methods = [method for method in re.findall(r"\b[GS]et\w+", member.__doc__ or "") if method in texts]
        types = [self.definition(line)[1].rpartition("-> ")[2][:-1] for method in methods if method.startswith("Get")
                 for line in signatures_of(method, vars(class_)[method])]
        type_ = types[0] if types and types[0] in BUILTIN else "Any"
        text = "\n\n".join([(member.__doc__ or "").strip(), *(texts[method] for method in methods[:1])])
        return ["@property", *documented(f"def {name}(self) -> {type_}:", text),
                f"@{name}.setter", f"def {name}(self, value: {type_}, /) -> None: ..."]

    def base(self, class_):
        """The name of a class to derive from."""
        if class_ is object or class_ in self.classes:
            return class_.__name__
        if class_.__module__.startswith("vtkmodules") and not has_stubs(class_.__module__):
            self.imports.add("conformalsom._types")
            return "conformalsom._types." + class_.__name__
        return self.type_named(class_.__name__)

    def text(self, head):
        """All of it."""
        body = [line for class_ in self.classes for line in ("", *self.class_(class_))]
        imports = [f"import {module}" for module in sorted(self.imports)]
        return "\n".join([HEADER + head, *imports, *body]) + "\n"


def documented(line, text):
    """A definition whose body is its text."""
    lines = inspect.cleandoc(text or "").replace("\\", "\\\\").replace('"""', "'''").splitlines()
    if not lines:
        return [line + " ..."]
    lines[0] = '"""' + lines[0]
    end = '"""' if len(lines) == 1 and not lines[0].endswith('"') else '\n"""'
    return [line, *("    " * bool(text) + text for text in "\n".join([*lines[:-1], lines[-1] + end]).split("\n"))]


def main():
    """Write the stubs."""
    # Of the wrapped modules, since the package derives some classes for the errors of old names.
    modules = [module for name, module in vars(conformalsom).items()
               if name.startswith("vtk") and inspect.ismodule(module)]
    classes = {module.__name__: [class_ for class_ in vars(module).values() if inspect.isclass(class_)]
               for module in modules}
    bases = dict.fromkeys(base for module in classes.values() for class_ in module for base in class_.__mro__)
    foreign = [base for base in bases if base.__module__.startswith("vtkmodules.") and not has_stubs(base.__module__)]
    stubs = {name: Stub(module).text("from conformalsom._types import Values\n")
             for name, module in classes.items()}
    package = ["__version__: str", "CLASSES_LEFT_OUT: list[str]", "RENAMED: dict[str, dict[str, str]]", "FUNCTIONS: list[str]",
               *(f"from {name} import *" for name in stubs),
               *(f"from {getattr(conformalsom, name).__module__} import {name} as {name}"
                 for name in conformalsom.FUNCTIONS)]
    stubs.update({f"conformalsom.{name}": functions.stub_of(name) for name in ("functions", "surface")})
    stubs["conformalsom._types"] = Stub(foreign).text(VALUES)
    stubs["conformalsom.__init__"] = "\n".join([f'"""{conformalsom.__doc__}"""', *package]) + "\n"
    for name, text in stubs.items():
        with open(os.path.join(sys.argv[1], name.split(".")[1] + ".pyi"), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
