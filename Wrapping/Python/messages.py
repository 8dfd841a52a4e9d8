"""Collect the errors and warnings of filters."""
import contextlib
import threading
import typing

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow


EXECUTIVE = " returned failure for request: "
FAILURES = ("Error", "File operation failed")  # beginnings of warnings by readers of .vtk and raw volumes
UNREADABLE = "the error message is not in UTF-8, since it quotes bytes of a file that is broken or of another type"
COLLECTING = threading.RLock()  # since VTK has one output window for all threads


class FilterFailed(RuntimeError):
    """A filter reported an error; the text is the filter's own."""


class FilterWarning(UserWarning):
    """A filter reported a warning; the text is the filter's own."""


class Messages:
    """Texts of errors and warnings, in order, without file, line and address."""

    def __init__(self) -> None:
        self.errors: typing.List[str] = []
        self.warnings: typing.List[str] = []


def text_of(message: typing.Union[str, bytes, None]) -> str:
    """Return the text of a message: "ERROR: In <file>, line <n>\\n<class> (<address>): <text>\\n\\n".

    VTK gives a message that is not in UTF-8 as bytes, and as None to observers.
    """
    if message is None:
        return UNREADABLE
    return decoded(message).split("): ", 1)[-1].strip().partition("\n")[0]


def decoded(text: typing.Union[str, bytes]) -> str:
    """Return a text of VTK, which is bytes if it is not in UTF-8."""
    return text.decode(errors="replace") if isinstance(text, bytes) else text


def own_errors(errors: typing.Sequence[str], class_name: str) -> typing.List[str]:
    """Return the texts of errors without those of the executive, which reports each failure again.

    If a class failed without a message, one text states this.
    """
    own = [text for text in errors if EXECUTIVE not in text]
    return own or [f"{class_name} failed without a message; its input may be broken"][:len(errors)]


def in_words(texts: typing.Iterable[str], words: typing.Optional[typing.Mapping[str, str]]) -> typing.List[str]:
    """Return texts with parts replaced by the words of a host for them, such as options for properties."""
    replaced = list(texts)
    for part, word in (words or {}).items():
        replaced = [text.replace(part, word) for text in replaced]
    return replaced


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


@contextlib.contextmanager
def errors_outside() -> typing.Iterator[typing.List[str]]:
    """Collect the errors that VTK reports outside of any algorithm during the block, instead of printing them.

    Yields a list, which is filled at the end of the block. In this way, VTK's readers of .vtk and .nrrd files report a
    file that ends early. It is a warning for VTK, but the values that are missing are arbitrary.
    """
    errors: typing.List[str] = []
    with COLLECTING:
        before, window = vtkOutputWindow.GetInstance(), vtkStringOutputWindow()
        verbosity = vtkLogger.GetCurrentVerbosityCutoff()
        vtkOutputWindow.SetInstance(window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        try:
            yield errors
        finally:
            vtkLogger.SetStderrVerbosity(verbosity)
            vtkOutputWindow.SetInstance(before)
            errors += [line for line in decoded(window.GetOutput()).splitlines() if line.startswith(FAILURES)]
