"""Runs filters one after the other: a line for each, and an end at the first error."""
import sys
import time

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING


class StepFailed(Exception):
    """A filter reported an error; the text is the filter's own."""


class Steps:
    """The steps of a run, in order, with the seconds each took."""

    def __init__(self):
        self.seconds = {}

    def run(self, label, algorithm, work=None):
        """Update the algorithm, or do work() that uses it, as the step called label."""
        messages = {"ErrorEvent": [], "WarningEvent": []}

        @calldata_type(VTK_STRING)
        def keep(_, event, text):
            # "ERROR: In <file>, line <n>\n<class> (<address>): <message>\n\n"
            messages[event].append(text.split("): ", 1)[-1].strip().partition("\n")[0])

        def show(caller, _):
            if sys.stdout.isatty():
                print(f"\r{label:<28}{100 * caller.GetProgress():6.0f} %", end="", flush=True)

        observed = [(algorithm, algorithm.AddObserver("ProgressEvent", show))]
        for source in (algorithm, algorithm.GetExecutive()):
            for event in messages:
                observed.append((source, source.AddObserver(event, keep)))
        start = time.perf_counter()
        try:
            (work or algorithm.Update)()
        finally:
            for source, tag in observed:
                source.RemoveObserver(tag)
        self.seconds[label] = time.perf_counter() - start
        if messages["ErrorEvent"]:
            raise StepFailed(f"{label}: {messages['ErrorEvent'][0]}")
        print(f"\r{label:<34}" if sys.stdout.isatty() else label, flush=True)
        for text in messages["WarningEvent"]:
            print(f"  note: {text}", flush=True)
