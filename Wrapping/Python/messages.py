"""Collect the errors and warnings of filters."""
import contextlib
import typing

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING


EXECUTIVE = " returned failure for request: "


class FilterFailed(RuntimeError):
    """A filter reported an error; the text is the filter's own."""


class FilterWarning(UserWarning):
    """A filter reported a warning; the text is the filter's own."""


class Messages:
    """Texts of errors and warnings, in order, without file, line and address."""

    def __init__(self) -> None:
        self.errors: typing.List[str] = []
        self.warnings: typing.List[str] = []


def text_of(message: str) -> str:
    """Return the text of a message: "ERROR: In <file>, line <n>\\n<class> (<address>): <text>\\n\\n"."""
    return message.split("): ", 1)[-1].strip().partition("\n")[0]


def own_errors(errors: typing.Sequence[str], class_name: str) -> typing.List[str]:
    """Return the texts of errors without those of the executive, which reports each failure again.

    If a class failed without a message, one text states this.
    """
    own = [text for text in errors if EXECUTIVE not in text]
    return own or [f"{class_name} failed without a message; its input may be broken"][:len(errors)]


@contextlib.contextmanager
def heard(algorithm) -> typing.Iterator[Messages]:
    """Collect the messages of an algorithm during the block, instead of printing them; yields a Messages."""
    messages = Messages()

    @calldata_type(VTK_STRING)
    def keep(_, event, text):
        (messages.errors if event == "ErrorEvent" else messages.warnings).append(text_of(text))

    sources = (algorithm, algorithm.GetExecutive())
    observed = [(source, source.AddObserver(event, keep))
                for source in sources for event in ("ErrorEvent", "WarningEvent")]
    try:
        yield messages
    finally:
        for source, tag in observed:
            source.RemoveObserver(tag)
        messages.errors[:] = own_errors(messages.errors, algorithm.GetClassName())
