#!/usr/bin/python3
"""describe.py: print as JSON what every class of the package is, as its header and an object of it state.

The module returns the same as dataclasses. It reads the modules that VTK's wrapper makes of the headers:
texts, signatures and constants come from there, defaults, ranges and ports from an object. ParaView's
proxies (proxies.py) and the tables of the documentation (tables.py) are made of it.
"""
import ast
import dataclasses
import importlib
import inspect
import json
import pkgutil
import re
import sys
from typing import Any, List, Optional

from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkTrivialProducer

from wrapped import is_ours, signatures_of, texts_of

UNLIMITED_INTEGER = 2**31 - 1
UNLIMITED_DOUBLE = 1e299
NUMBERS_AND_TEXT = {"bool": bool, "int": int, "float": float, "str": str}


class Undescribed(Exception):
    """A header from which no description can be made, with what is missing."""


@dataclasses.dataclass
class Port:
    """An input or output of a class."""
    index: int
    name: str
    types: List[str]
    optional: bool
    repeatable: bool
    text: str


@dataclasses.dataclass
class Value:
    """A value of an enumeration: the word of its method SetPropertyToWord(), its label, and its constants."""
    word: str
    label: str
    value: int
    constants: List[str]


@dataclasses.dataclass
class Property:
    """What can be set: one value, a tuple of them, or, if repeated, any number of tuples."""
    name: str
    types: List[str]
    default: Any
    minimum: Optional[float]
    maximum: Optional[float]
    values: List[Value]
    text: str
    add: Optional[str] = None
    remove_all: Optional[str] = None

    @property
    def repeated(self):
        """Whether the property is a list that AddX() extends."""
        return self.add is not None


@dataclasses.dataclass
class Class:
    """A class, with inputs and properties in the header's order."""
    name: str
    brief: str
    text: str
    inputs: List[Port]
    outputs: List[Port]
    properties: List[Property]
    order: List[str]
    extensions: List[str]
    file_type: Optional[str]

    @property
    def unit(self):
        """The name without the prefix."""
        return self.name[len("vtk"):]

    @property
    def is_reader(self):
        """Whether it reads files of some extensions."""
        return bool(self.extensions)

    @property
    def is_writer(self):
        """Whether it writes files."""
        return self.name.endswith("Writer")


def words_of(name):
    """Separate the words of a name, as ParaView does for labels: NumberOfNeurons is Number Of Neurons."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name)


def label_of(name):
    """Separate the words of a value and write all but the first small: WindingNumbers is Winding numbers."""
    first, *others = words_of(name).split()
    return " ".join([first, *(word if word.isupper() else word.lower() for word in others)])


def paragraphs_of(text):
    """Separate a comment at its empty lines, and join the lines of each paragraph but for items of lists."""
    found = []
    for block in re.split(r"\n\s*\n", inspect.cleandoc(text or "")):
        items = re.split(r"\n\s*- ", block.strip())
        found.append("\n- ".join(" ".join(item.split()) for item in items))
    return [paragraph for paragraph in found if paragraph]


def before_list(text):
    """Return the sentences of a paragraph that are before its list, without the one that the list continues."""
    text, dash, _ = text.partition("\n- ")
    end = text.rfind(". ") + 1
    return text[:end] if dash and end and not text.endswith(".") else text


class Reader:
    """The description of one class, in the making."""

    def __init__(self, class_):
        self.class_ = class_
        self.object = class_()
        self.bases = [base for base in class_.__mro__ if is_ours(base)]
        self.methods, self.texts = {}, {}
        for base in reversed(self.bases):
            self.texts.update(texts_of(base))
            self.methods.update({name: member for name, member in vars(base).items() if inspect.isroutine(member)})
        self.constants = {name: member for base in self.bases for name, member in vars(base).items()
                          if isinstance(member, int) and not name.startswith("__")}

    def argument_types(self, method):
        """Return the types of a method's arguments, by its first signature."""
        line = signatures_of(method, self.methods[method])[0]
        annotations = [argument.annotation for argument in ast.parse(f"def {line}: ...").body[0].args.args[1:]]
        return [ast.unparse(annotation) if annotation is not None else "Any" for annotation in annotations]

    def settings(self):
        """Return the names of properties with a single value, without those that are objects or ports."""
        found = []
        for method in self.methods:
            name = method[len("Set"):]
            if not method.startswith("Set") or self.is_choice(name):
                continue
            if all(type_ in NUMBERS_AND_TEXT for type_ in self.argument_types(method)):
                found.append(name)
        return found

    def is_choice(self, name):
        """Whether a name is PropertyToValue of a property with an enumeration."""
        return any(name.startswith(property_ + "To") for property_ in self.enumerations())

    def enumerations(self):
        """Return the names of properties that have methods SetPropertyToValue()."""
        setters = [method[len("Set"):] for method in self.methods if method.startswith("Set")]
        return [name for name in setters if any(other.startswith(name + "To") for other in setters)]

    def values_of(self, name):
        """Return the enumeration of a property, in the order of its methods; an empty list if it has none."""
        found = []
        if name not in self.enumerations():
            return found
        before = getattr(self.object, "Get" + name)()
        for method in self.methods:
            word = method[len("Set" + name + "To"):]
            if method.startswith("Set" + name + "To") and word:
                getattr(self.object, method)()
                value = getattr(self.object, "Get" + name)()
                found.append(Value(word, label_of(word), value, self.constants_of(word, value)))
        getattr(self.object, "Set" + name)(before)
        return found

    def constants_of(self, word, value):
        """Return the constants of a value: its word in capitals, and those that begin or end with it."""
        capitals = words_of(word).upper().replace(" ", "_")
        return [capitals, word.upper(), *(
            constant for constant, number in self.constants.items()
            if int(number) == value and (constant.startswith(capitals + "_") or constant.endswith("_" + capitals)))]

    def limit(self, name, which):
        """Return the bound to which a property is clamped; None if there is none."""
        method = getattr(self.object, f"Get{name}{which}Value", None)
        limit = method() if method else None
        unlimited = UNLIMITED_INTEGER if isinstance(limit, int) else UNLIMITED_DOUBLE
        return None if limit is None or abs(limit) >= unlimited else limit

    def setting(self, name):
        """Describe a property with a single value."""
        if "Get" + name not in self.methods:
            raise Undescribed(f"{self.class_.__name__} has Set{name}() and no Get{name}()")
        default = getattr(self.object, "Get" + name)()
        default = "" if default is None else default
        tuple_ = default if isinstance(default, tuple) else (default,)
        return Property(name, [type(value).__name__ for value in tuple_], default, self.limit(name, "Min"),
                        self.limit(name, "Max"), self.values_of(name), self.text(name, "Set" + name))

    def text(self, name, method):
        """Return the text of a property, which must have one."""
        if not self.texts.get(method):
            raise Undescribed(f"{self.class_.__name__}::{method}() has no comment in the header, from which "
                              f"ParaView's panel and help() get the text of {name}")
        return "\n\n".join(paragraphs_of(self.texts[method]))

    def repeated(self):
        """Describe the properties that AddX() extends and RemoveAllXs() clears."""
        for method in self.methods:
            plural = method[len("RemoveAll"):]
            if method.startswith("RemoveAll") and "Add" + plural[:-1] in self.methods:
                add = "Add" + plural[:-1]
                yield Property(plural, self.argument_types(add), None, None, None, [], self.text(plural, add),
                               add, method)

    def inputs(self, texts):
        """Describe the input ports.

        All but the first are named as SetNameConnection() or AddNameConnection(), the comment of which is their text;
        that of the first is the class comment's, up to the list of arrays that the input has.
        """
        names = {0: "Input"}
        texts = {0: before_list(texts.get(("Input", 0), ""))}
        for method in self.methods:
            if re.fullmatch("(Set|Add)[A-Z].*Connection", method) and method != "AddInputConnection":
                producer = vtkTrivialProducer()
                getattr(self.object, method)(producer.GetOutputPort())
                [port] = [port for port in range(1, self.object.GetNumberOfInputPorts())
                          if self.object.GetNumberOfInputConnections(port)
                          and self.object.GetInputAlgorithm(port, 0) is producer]
                self.object.SetInputConnection(port, None)
                names[port] = method[len("Set"):-len("Connection")]  # as long as Add
                texts[port] = self.text(names[port], method)
        for port in range(self.object.GetNumberOfInputPorts()):
            if port not in names:
                raise Undescribed(f"{self.class_.__name__} has no method Set...Connection() for input port {port}")
            needed = self.object.GetInputPortInformation(port)
            types = [needed.Get(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), i)
                     for i in range(needed.Length(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()))]
            yield Port(port, names[port], types, bool(needed.Get(vtkAlgorithm.INPUT_IS_OPTIONAL())),
                       bool(needed.Get(vtkAlgorithm.INPUT_IS_REPEATABLE())), texts.get(port, ""))

    def outputs(self, texts):
        """Describe the output ports."""
        for port in range(self.object.GetNumberOfOutputPorts()):
            type_ = self.object.GetOutputPortInformation(port).Get(vtkDataObject.DATA_TYPE_NAME())
            yield Port(port, "", [type_] if type_ else [], False, False, texts.get(("Output", port), ""))

    def order(self, inputs, properties):
        """Return the names of inputs and properties in the header's order.

        Inputs of AddNameConnection() are left out: ParaView's panels select one source for each input.
        """
        known = {**{f"Set{port.name}Connection": port.name for port in inputs if port.index},
                 **{property_.add or "Set" + property_.name: property_.name for property_ in properties}}
        return ["Input"] * bool(inputs) + [known[method] for method in self.methods if method in known]

    def description(self):
        """Describe the class."""
        brief, text, ports = class_comment(self.class_)
        inputs = list(self.inputs(ports))
        properties = [*map(self.setting, self.settings()), *self.repeated()]
        reads = hasattr(self.object, "GetFileExtensions")
        return Class(
            self.class_.__name__, brief, text, inputs, list(self.outputs(ports)), properties,
            self.order(inputs, properties),
            self.object.GetFileExtensions().replace(".", " ").split() if reads else [],
            self.object.GetDescriptiveName() if reads else None)


def class_comment(class_):
    """Return the brief, the description and the texts of the ports, by (kind, index), of a class.

    The description is what stands between the brief and the first port; a port begins a paragraph with
    "Input port 0:", "Output port 1:", "Input port 1 (optional):".
    """
    head, *others = paragraphs_of(class_.__doc__)
    others = [paragraph for paragraph in others if not paragraph.startswith("Superclass:")]
    text, ports = [], {}
    for paragraph in others:
        start = re.match(r"(Input|Output) port (\d)(?:,? \(?(?:optional|repeatable)\)?)?: ", paragraph)
        if start:
            ports[start[1], int(start[2])] = paragraph[start.end():]
        elif not ports:
            text.append(paragraph)
    return head.partition(" - ")[2], "\n\n".join(text), ports


def modules():
    """Import the wrapped modules of the package."""
    names = [module.name for module in pkgutil.iter_modules(importlib.import_module("conformalsom").__path__)]
    return [importlib.import_module("conformalsom." + name) for name in sorted(names) if name.startswith("vtk")]


def classes():
    """Describe all classes of which users make objects for a pipeline, by their names."""
    found = {}
    for module in modules():
        for name, class_ in vars(module).items():
            if inspect.isclass(class_) and issubclass(class_, vtkAlgorithm) and not inspect.isabstract(class_):
                try:
                    class_()
                except (NotImplementedError, TypeError):
                    continue  # a base of others
                found[name] = Reader(class_).description()
    return found


if __name__ == "__main__":
    json.dump({name: dataclasses.asdict(class_) for name, class_ in classes().items()}, sys.stdout, indent=1)
