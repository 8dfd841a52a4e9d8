"""Keep the locale of the process, which VTK's readers and writers of .vtk files set to "C"."""
import contextlib
import locale
import threading
import typing

from vtkmodules.vtkIOLegacy import vtkDataReader, vtkDataWriter

LOCK = threading.Lock()
RUNNING: typing.List[str] = []  # for each of these filters that runs, the locale before the first one


@contextlib.contextmanager
def same_locale(algorithm: typing.Any) -> typing.Iterator[None]:
    """Restore the locale after an algorithm has run: in "C", Python takes text files for ASCII.

    If several threads run such algorithms, the last one restores the locale.
    """
    if not isinstance(algorithm, (vtkDataReader, vtkDataWriter)):
        yield
        return
    with LOCK:
        RUNNING.append(RUNNING[0] if RUNNING else locale.setlocale(locale.LC_ALL))
    try:
        yield
    finally:
        with LOCK:
            before = RUNNING.pop()
            if not RUNNING:
                locale.setlocale(locale.LC_ALL, before)
