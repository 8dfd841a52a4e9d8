"""Run a filter of the package on data, with keyword arguments as properties."""
import typing

import conformalsom
from conformalsom.inputs import point_set
from conformalsom.keywords import apply, keywords_of
from conformalsom.reporting import Progress
from conformalsom.running import run


def updated(class_name: str, data: typing.Iterable[typing.Any], progress: Progress = False,
            properties: typing.Optional[typing.Mapping[str, typing.Any]] = None,
            data_of: typing.Callable[[typing.Any, typing.List[str]], typing.Any] = point_set,
            reworded: typing.Optional[typing.Mapping[str, str]] = None) -> typing.Tuple[typing.Any, typing.List[str]]:
    """Run a filter on the data of its first input port; return the filter, and the warnings of all inputs and its own.

    data_of() converts the data of all inputs, and adds the warnings of an input to a list. reworded has parts of
    warnings of the filter, and the words of Python for them.
    """
    texts: typing.List[str] = []
    class_ = getattr(conformalsom, class_name)
    algorithm = class_()
    apply(algorithm, keywords_of(class_), properties or {}, lambda item: data_of(item, texts))
    for item in data:
        algorithm.AddInputDataObject(0, data_of(item, texts))
    return algorithm, [*texts, *run(algorithm, progress, reworded)]
