"""Type stubs of modules in Python whose functions have keyword arguments for the properties of a filter."""
import ast
import importlib
import inspect

import conformalsom
from conformalsom.keywords import keywords_of

HEADER = '"""Made by generate_stubs.py."""\nfrom typing import Literal, Optional, Sequence, Tuple\n'
PUBLIC = ("_repr_html_",)


class Outline(ast.NodeTransformer):
    """Reduce a module to signatures and texts, with the keyword arguments of decorated functions."""

    def __init__(self, module):
        self.scope = [module]

    def visit_ClassDef(self, node):  # pylint: disable=invalid-name
        """Keep a class, with the outlines of its methods."""
        self.scope.append(getattr(self.scope[-1], node.name))
        self.generic_visit(node)
        self.scope.pop()
        return node

    def visit_ImportFrom(self, node):  # pylint: disable=invalid-name
        """Leave out imports that are of no use in a stub."""
        return None if node.module == "__future__" else node

    def visit_FunctionDef(self, node):  # pylint: disable=invalid-name
        """Keep the signature and the text of a public function."""
        if node.name.startswith("_") and not node.name.startswith("__") and node.name not in PUBLIC:
            return None
        for decorator in node.decorator_list:
            if isinstance(decorator, ast.Call):
                add_keywords(node.args, *ast.literal_eval(decorator.args[0]).split(),
                             {word.arg: ast.literal_eval(word.value) for word in decorator.keywords})
        node.decorator_list = [decorator for decorator in node.decorator_list if not isinstance(decorator, ast.Call)]
        text = ast.get_docstring(node) and inspect.getdoc(getattr(self.scope[-1], node.name))
        indented = (text or "").replace("\n", "\n" + "    " * len(self.scope))
        node.body = [ast.Expr(ast.Constant(indented if text else ...))]
        return node


def add_keywords(arguments, class_name, options):
    """Replace **properties by the keyword arguments of a filter."""
    arguments.kwarg = None
    for word, keyword in keywords_of(getattr(conformalsom, class_name)).items():
        if word not in options.get("without", ()):
            arguments.kwonlyargs.append(ast.arg(word, ast.parse(keyword.type, mode="eval").body))
            arguments.kw_defaults.append(ast.parse(repr(keyword.default), mode="eval").body)


def stub_of(name):
    """Return the stub of a module of the package."""
    module = importlib.import_module("conformalsom." + name)
    outline = Outline(module).visit(ast.parse(inspect.getsource(module)))
    if isinstance(outline.body[0], ast.Expr):
        del outline.body[0]  # the module's text
    return HEADER + ast.unparse(ast.fix_missing_locations(outline)) + "\n"
