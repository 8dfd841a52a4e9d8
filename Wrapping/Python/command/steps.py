"""Runs filters one after the other, hears of their progress, and ends at the first error."""
import sys
import time

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING


class StepFailed(Exception):
    """A filter reported an error; the text is the filter's own."""


class Interrupted(BaseException):
    """A signal asked to stop; the argument is its number."""


class Steps:
    """The steps of a run, in order, with the seconds each took and the warnings there were.

    Prints a line for each step. Derived classes show it otherwise.
    """

    def __init__(self):
        self.seconds = {}
        self.warnings = []
        self.running = None
        self.signal = None

    def run(self, label, algorithm, work=None):
        """Update the algorithm, or do work() that uses it, as the step called label."""
        messages = {"ErrorEvent": [], "WarningEvent": []}

        @calldata_type(VTK_STRING)
        def keep(_, event, text):
            # "ERROR: In <file>, line <n>\n<class> (<address>): <message>\n\n"
            messages[event].append(text.split("): ", 1)[-1].strip().partition("\n")[0])

        def advance(caller, _):
            self.advanced(label, caller.GetProgress())

        # Python sees signals only while it runs, which it does here at least.
        observed = [(algorithm, algorithm.AddObserver("ProgressEvent", advance))]
        for source in (algorithm, algorithm.GetExecutive()):
            for event in messages:
                observed.append((source, source.AddObserver(event, keep)))
        start = time.perf_counter()
        self.running = algorithm
        try:
            (work or algorithm.Update)()
        finally:
            self.running = None
            for source, tag in observed:
                source.RemoveObserver(tag)
        self.seconds[label] = time.perf_counter() - start
        if self.signal is not None:
            raise Interrupted(self.signal)
        if messages["ErrorEvent"]:
            raise StepFailed(f"{label}: {messages['ErrorEvent'][0]}")
        self.warnings += [f"{label}: {text}" for text in messages["WarningEvent"]]
        self.ended(label, messages["WarningEvent"])

    def interrupt(self, number, _):
        """A signal handler: abort the filter that runs, or stop at once if none does."""
        self.signal = number
        if self.running is None:
            raise Interrupted(number)
        self.running.AbortExecuteOn()

    def advanced(self, label, fraction):
        """Show how much of the step is done."""
        if sys.stdout.isatty():
            print(f"\r{label:<28}{100 * fraction:6.0f} %", end="", flush=True)

    def ended(self, label, warnings):
        """Show that the step is done."""
        print(f"\r{label:<34}" if sys.stdout.isatty() else label, flush=True)
        for text in warnings:
            print(f"  note: {text}", flush=True)
