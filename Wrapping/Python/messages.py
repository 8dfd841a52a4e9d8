"""Collect the errors and warnings of filters."""
import contextlib
import typing

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING


EXECUTIVE = " returned failure for request: "


class FilterFailed(RuntimeError):
    """A filter reported an error; the text is the filter's own."""


class Messages:
    """Texts of errors and warnings, in order, without file, line and address."""

    def __init__(self) -> None:
        self.errors: typing.List[str] = []
        self.warnings: typing.List[str] = []


@contextlib.contextmanager
def heard(algorithm) -> typing.Iterator[Messages]:
    """Collect the messages of an algorithm during the block, instead of printing them; yields a Messages."""
    messages = Messages()

    @calldata_type(VTK_STRING)
    def keep(_, event, text):
        # "ERROR: In <file>, line <n>\n<class> (<address>): <message>\n\n"
        said = text.split("): ", 1)[-1].strip().partition("\n")[0]
        (messages.errors if event == "ErrorEvent" else messages.warnings).append(said)

    sources = (algorithm, algorithm.GetExecutive())
    observed = [(source, source.AddObserver(event, keep))
                for source in sources for event in ("ErrorEvent", "WarningEvent")]
    try:
        yield messages
    finally:
        for source, tag in observed:
            source.RemoveObserver(tag)
        # The executive reports the failure again; this is of use only if the algorithm gave no message.
        own = [text for text in messages.errors if EXECUTIVE not in text]
        if messages.errors:
            silent = f"{algorithm.GetClassName()} failed without a message; its input may be broken"
            messages.errors[:] = own or [silent]
