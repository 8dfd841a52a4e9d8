"""Run one filter on another thread, with progress, Ctrl-C, errors as exceptions and warnings of Python."""
import os
import sys
import time
import typing
import warnings

from vtkmodules.vtkCommonDataModel import vtkPointSet

import conformalsom
from conformalsom.locales import same_locale
from conformalsom.messages import FilterFailed, FilterWarning, in_words, own_errors, text_of
from conformalsom.reporting import Progress, reporter

FIRST_PAUSE, LONGEST_PAUSE = 0.0002, 0.02  # seconds between two looks at a filter that runs
PACKAGE = os.path.dirname(os.path.abspath(__file__)) + os.sep


def run(algorithm: typing.Any, progress: Progress = False,
        reworded: typing.Optional[typing.Mapping[str, str]] = None) -> typing.List[str]:
    """Update a filter, reader or writer; return its warnings, which are also issued as FilterWarning.

    Other threads of Python run meanwhile. An exception of this thread, such as KeyboardInterrupt, aborts the
    filter. Raises FilterFailed if the filter reports an error, or makes an empty surface with a warning. reworded has
    parts of warnings, and what replaces them.
    """
    name = algorithm.GetClassName()
    with same_locale(algorithm), reporter(progress, name) as report:
        update = conformalsom.vtkBackgroundUpdate()
        update.Start(algorithm)
        try:
            wait(update, report)
        except BaseException:
            update.Abort()
            wait(update, lambda fraction: None)
            raise
        finally:
            update.Wait()
        errors = [text_of(update.GetError(i)) for i in range(update.GetNumberOfErrors())]
        texts = [text_of(update.GetWarning(i)) for i in range(update.GetNumberOfWarnings())]
        failures = own_errors(errors, name)
        if not failures and texts and is_empty(algorithm):
            failures = ["; ".join(texts)]
        if failures:
            raise FilterFailed(f"{name}: {failures[0]}")
    texts = [f"{name}: {text}" for text in in_words(texts, reworded)]
    warn(texts)
    return texts


def warn(texts: typing.Iterable[str]) -> None:
    """Issue warnings as FilterWarning, at the line that called the package."""
    for text in texts:
        warnings.warn(text, FilterWarning, stacklevel=level_of_caller())


def is_empty(algorithm: typing.Any) -> bool:
    """Return whether a filter made a surface without points; its warnings then state the reason."""
    output: typing.Any = algorithm.GetOutputDataObject(0) if algorithm.GetNumberOfOutputPorts() else None
    return isinstance(output, vtkPointSet) and output.GetNumberOfPoints() == 0


def wait(update: typing.Any, report: typing.Callable[[float], object]) -> None:
    """Wait for the end of an update without holding the interpreter, and report its progress."""
    pause = FIRST_PAUSE
    while update.IsRunning():
        time.sleep(pause)
        pause = min(1.5 * pause, LONGEST_PAUSE)
        report(update.GetProgress())


def level_of_caller() -> int:
    """Return the stack level of the code that called the package, for warnings.warn() in the calling function."""
    level, frame = 1, sys._getframe(1)  # pylint: disable=protected-access
    while frame.f_back is not None and os.path.abspath(frame.f_code.co_filename).startswith(PACKAGE):
        level, frame = level + 1, frame.f_back
    return level
