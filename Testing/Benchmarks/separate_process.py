"""Runs functions in processes of their own, and measures the processor time and the memory that they need."""
import importlib
import importlib.metadata
import importlib.util
import multiprocessing
import os
import resource
import sys
import time
from concurrent import futures

STATUS, RESET = "/proc/self/status", "/proc/self/clear_refs"  # of Linux


def resident(name):
    """Resident memory of this process in megabytes: VmRSS, now, or VmHWM, the largest since the last reset."""
    if os.path.exists(STATUS):
        with open(STATUS, encoding="ascii") as file:
            return next(int(line.split()[1]) for line in file if line.startswith(name + ":")) / 2**10
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / (2**20 if sys.platform == "darwin" else 2**10)


def result_and_cost(library, function, arguments):
    importlib.import_module(library)
    if os.path.exists(RESET):
        with open(RESET, "w", encoding="ascii") as file:
            file.write("5")
    memory, begin = resident("VmRSS"), time.process_time()
    result = function(*arguments)
    return result, time.process_time() - begin, resident("VmHWM") - memory


def measured(library, function, *arguments, limit=1200):
    """Result of function(*arguments), seconds of the processor on all threads, and megabytes.

    The process imports the library before it is measured. Megabytes are the growth of the largest resident memory.
    function must be known to its module by name. Raises RuntimeError if the function raises an exception, the process
    ends early, or the function has no result after limit seconds.
    """
    with futures.ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        future = pool.submit(result_and_cost, library, function, arguments)
        try:
            return future.result(limit)
        except futures.TimeoutError as error:
            for process in multiprocessing.active_children():
                process.terminate()
            raise RuntimeError(f"no result after {limit} s") from error
        except Exception as error:  # whatever a library raises
            raise RuntimeError(f"{type(error).__name__}: {error}") from error


def missing(libraries):
    """Of importable names, those that are not installed."""
    return [library for library in libraries if importlib.util.find_spec(library) is None]


def versions(libraries):
    """Text with the versions of the libraries that are installed; libraries has the names for import and for pip."""
    found = [f"{package} {importlib.metadata.version(package)}" for library, package in libraries.items()
             if importlib.util.find_spec(library) is not None]
    return ", ".join(found)


def print_row(*values):
    """Print a row of a Markdown table."""
    print("| " + " | ".join(map(str, values)) + " |", flush=True)


def print_header(*titles):
    print()
    print_row(*titles)
    print("|" + "---|" * len(titles), flush=True)


def rounded(value):
    """Text with three significant digits."""
    if abs(value) >= 1000.0:
        return f"{value:,.0f}"
    text = f"{value:.2e}" if 0.0 < abs(value) < 1e-2 else f"{value:#.3g}"
    return text.replace("e-0", "e-").rstrip(".")
