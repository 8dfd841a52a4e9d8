"""Keyword arguments of functions: the properties of a filter, by the names of its methods."""
import difflib
import functools
import inspect
import numbers
import re
import textwrap
import types
import typing

import numpy as np

Function = typing.TypeVar("Function", bound=typing.Callable[..., typing.Any])
NUMBERS_AND_TEXT = {"bool": "bool", "int": "int", "float": "float", "str": "str"}
CONSTANT = re.compile(r"\b[A-Z][A-Z0-9_]+\b")


class Keyword:
    """A keyword argument: the property it sets, its type as text, its default, and the numbers of its values."""

    def __init__(self, kind: str, name: str, type_: str, default: typing.Any,
                 values: typing.Mapping[str, int] = types.MappingProxyType({})) -> None:
        self.kind, self.name, self.type, self.default, self.values = kind, name, type_, default, values


def snake_case(name: str) -> str:
    """Return NumberOfNeurons as number_of_neurons."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def argument_types(method: typing.Any) -> typing.List[str]:
    """Return the types of a wrapped method's arguments, of its first signature."""
    signature = re.sub(r"\n +", " ", method.__doc__).partition("\n")[0]
    return re.findall(r"\w+:(\w+)", signature.partition(" -> ")[0])


def keywords_of(class_: type) -> typing.Dict[str, Keyword]:
    """Return the keyword arguments for a filter, by their names, in the sequence of its header."""
    methods = {name: method for base in reversed(class_.__mro__) if base.__module__.startswith("conformalsom.")
               for name, method in vars(base).items() if inspect.isroutine(method)}
    algorithm, found = class_(), {}
    for method_name, method in methods.items():
        start, name = method_name[:3], method_name[3:]
        plural = name + "s"
        if start == "Set" and name.endswith("Data"):
            keyword = Keyword("input", name[:-4], "Optional[MeshLike]", None)
        elif start == "Set" and "Get" + name in methods and set(argument_types(method)) <= set(NUMBERS_AND_TEXT):
            keyword = setting(algorithm, methods, name)
        elif start == "Add" and "RemoveAll" + plural in methods:
            items = [NUMBERS_AND_TEXT[type_] for type_ in argument_types(method)]
            item = items[0] if len(items) == 1 else f"Tuple[{', '.join(items)}]"
            keyword = Keyword("list", name, f"Sequence[{item}]", ())
        else:
            continue
        found[snake_case(plural if keyword.kind == "list" else keyword.name)] = keyword
    return found


def setting(algorithm: typing.Any, methods: typing.Iterable[str], name: str) -> Keyword:
    """Return the keyword for a property with one value."""
    default = getattr(algorithm, "Get" + name)()
    start = f"Set{name}To"
    values = {}
    for method in methods:
        if method.startswith(start):
            getattr(algorithm, method)()
            values[method[len(start):]] = getattr(algorithm, "Get" + name)()
    if values:
        default = next((value for value, number in values.items() if number == default), default)
        return Keyword("choice", name, f"Literal[{', '.join(map(repr, values))}]", default, values)
    if isinstance(default, tuple):
        return Keyword("setting", name, f"Sequence[{type(default[0]).__name__}]", default)
    return Keyword("setting", name, "Optional[str]" if default is None else type(default).__name__, default)


def apply(algorithm: typing.Any, keywords: typing.Mapping[str, Keyword], properties: typing.Mapping[str, typing.Any],
          data_of: typing.Callable[[typing.Any], typing.Any]) -> None:
    """Set properties of a filter by keyword arguments; data_of() converts the data of further inputs.

    Raises TypeError for a wrong type, and ValueError for a value that the property cannot have. Ranges that only the
    filter knows are checked when it runs.
    """
    for word, value in properties.items():
        keyword = keywords[word]
        setter = "Set" + keyword.name
        if keyword.kind == "input":
            if value is not None:
                getattr(algorithm, setter + "Data")(data_of(value))
        elif keyword.kind == "list":
            add_items(algorithm, word, keyword, value)
        elif keyword.kind == "choice":
            if value not in keyword.values:
                raise ValueError(f"{word} is {value!r}, but must be one of {', '.join(map(repr, keyword.values))}")
            getattr(algorithm, f"{setter}To{value}")()
        else:
            set_value(algorithm, word, keyword, value)


def add_items(algorithm: typing.Any, word: str, keyword: Keyword, value: typing.Any) -> None:
    """Add the items of a list. Raise TypeError for a wrong type, and ValueError for a number that is too large."""
    try:
        for item in value:
            getattr(algorithm, "Add" + keyword.name)(*arguments_of(item))
    except (TypeError, OverflowError) as error:
        type_ = TypeError if isinstance(error, TypeError) else ValueError
        raise type_(f"{word} is {value!r}, but must be {keyword.type}: {error}") from None


def arguments_of(item: typing.Any) -> typing.List[typing.Any]:
    """Return the arguments of one call of a method AddX()."""
    items = [item] if isinstance(item, str) else list(item)
    return [value.item() if isinstance(value, np.generic) else value for value in items]


def set_value(algorithm: typing.Any, word: str, keyword: Keyword, value: typing.Any) -> None:
    """Set a property, and raise ValueError if the filter would clamp the value, or if VTK cannot store it."""
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(keyword.default, bool) and not (isinstance(value, (bool, int, float)) and value in (0, 1)):
        raise TypeError(f"{word} is {value!r}, but must be True or False")
    try:
        getattr(algorithm, "Set" + keyword.name)(value)
    except TypeError as error:
        raise TypeError(f"{word} is {value!r}, but must be {keyword.type}: {error}") from None
    except OverflowError:
        is_taken = False
    else:
        is_clamped = hasattr(algorithm, f"Get{keyword.name}MinValue")
        is_taken = not is_clamped or getattr(algorithm, "Get" + keyword.name)() == value
    if not is_taken:
        low, high = range_of(algorithm, keyword)
        raise ValueError(f"{word} is {value!r}, but must be in [{low}, {high}]")


def range_of(algorithm: typing.Any, keyword: Keyword) -> typing.Tuple[float, float]:
    """Return the least and the greatest number of a property: of its declared range, or of its type."""
    least = getattr(algorithm, f"Get{keyword.name}MinValue", None)
    if least is not None:
        return least(), getattr(algorithm, f"Get{keyword.name}MaxValue")()
    limits: typing.Any = np.iinfo(np.intc) if "int" in keyword.type else np.finfo(float)
    return limits.min, limits.max


def expect_number(word: str, value: typing.Any, low: int, high: int,
                  type_: typing.Any = numbers.Integral) -> None:
    """Raise TypeError unless a value is a number of a type, and ValueError unless it is in [low, high]."""
    if not isinstance(value, type_):
        raise TypeError(f"{word} is {value!r}, but must be {'an integer' if type_ is numbers.Integral else 'a number'}")
    if not low <= value <= high:
        raise ValueError(f"{word} is {value!r}, but must be in [{low}, {high}]")


def properties_of(class_name: str, *, without: typing.Sequence[str] = ()) -> typing.Callable[[Function], Function]:
    """Decorate a function whose **properties are the properties of a filter: signature, help text and checks.

    The function gets keyword arguments that exist only; any other raises TypeError. `without` names
    properties that the function sets itself.
    """
    def decorate(function: Function) -> Function:
        import conformalsom  # pylint: disable=import-outside-toplevel
        class_ = vars(conformalsom).get(class_name)
        known = {} if class_ is None else {
            word: keyword for word, keyword in keywords_of(class_).items() if word not in without}

        @functools.wraps(function)
        def checked(*arguments: typing.Any, **named: typing.Any) -> typing.Any:
            if class_ is None:
                getattr(conformalsom, class_name)  # raises the reason why there is no such class
            for word in named:
                if word not in known and word not in own:
                    close = difflib.get_close_matches(word, [*known, *own], 1, 0.5) or [
                        other for other in known if word in other]
                    hint = f"; did you mean {close[0]!r}?" if close else ""
                    raise TypeError(f"{function.__name__}() has no keyword argument {word!r}{hint}")
            return function(*arguments, **named)

        signature = inspect.signature(function)
        own = [name for name, parameter in signature.parameters.items() if parameter.kind != parameter.VAR_KEYWORD]
        parameters = [signature.parameters[name] for name in own]
        parameters += [inspect.Parameter(word, inspect.Parameter.KEYWORD_ONLY, default=keyword.default,
                                         annotation=keyword.type) for word, keyword in known.items()]
        setattr(checked, "__signature__", signature.replace(parameters=parameters))
        values = values_of_constants(class_, known) if known else {}
        texts = "\n".join(textwrap.fill(f"{word}: {text_of(class_, keyword, values)}", 100, initial_indent="    ",
                                        subsequent_indent="        ") for word, keyword in known.items())
        checked.__doc__ = inspect.cleandoc(function.__doc__ or "") + (
            f"\n\nKeyword arguments, the properties of {class_name}:\n\n{texts}\n" if texts else "")
        return typing.cast(Function, checked)
    return decorate


def values_of_constants(class_: typing.Any, keywords: typing.Mapping[str, Keyword]) -> typing.Dict[str, str]:
    """Return the values, such as "Off", of the constants of a class, such as GROUND_OFF of RemoveGround.

    A constant is the value in capitals, or begins or ends with it. Wrapping/Describe does the same.
    """
    constants = {name: member for base in class_.__mro__ if base.__module__.startswith("conformalsom.")
                 for name, member in vars(base).items() if isinstance(member, int) and name.isupper()}
    found = {}
    for keyword in keywords.values():
        for value, number in keyword.values.items():
            capitals = snake_case(value).upper()
            names = [capitals, value.upper(), *(
                name for name, other in constants.items()
                if other == number and (name.startswith(capitals + "_") or name.endswith("_" + capitals)))]
            found.update(dict.fromkeys(names, value))
    return found


def text_of(class_: typing.Any, keyword: Keyword, values: typing.Mapping[str, str]) -> str:
    """Return the header's text of a property in one line: the first paragraph, and others that name further values.

    Constants are replaced by values.
    """
    ends = {"input": ("Connection", "Data")}.get(keyword.kind, ("",))
    start = "Add" if keyword.kind == "list" else "Set"
    methods = [getattr(class_, start + keyword.name + end, None) for end in ends]
    for method in methods:
        paragraphs = ((method.__doc__ if method else "") or "").split("\n\n")
        if len(paragraphs) > 1:
            text = " ".join(naming_values(paragraphs[1:], keyword, values).split())
            return CONSTANT.sub(lambda match: f'"{values[match[0]]}"' if match[0] in values else match[0], text)
    return ""


def naming_values(paragraphs: typing.Sequence[str], keyword: Keyword, values: typing.Mapping[str, str]) -> str:
    """Return the first of paragraphs, and each other one that names a value of a property for the first time."""
    kept: typing.List[str] = []
    named: typing.Set[str] = set()
    for paragraph in paragraphs:
        own = {values.get(constant, "") for constant in CONSTANT.findall(paragraph)} & set(keyword.values)
        if not kept or own - named:
            kept.append(paragraph)
            named |= own
    return "\n".join(kept)
