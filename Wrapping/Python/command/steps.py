"""Runs filters one after the other, hears of their progress, and ends at the first error."""
import sys
import time

from conformalsom.locales import same_locale
from conformalsom.messages import FilterFailed, heard, in_words

from .progress import printable


class StepFailed(FilterFailed):
    """The text begins with the step's name."""


class Interrupted(BaseException):
    """A signal asked to stop; the argument is its number."""


def message_of(error, scan=""):
    """What an exception says, with the file it is about: that of an OSError, or the scan."""
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename}: {error.strerror}" if error.filename else error.strerror
    text = "there is not enough memory" if isinstance(error, MemoryError) else str(error)
    return f"{scan}: {text}" if scan and isinstance(error, (MemoryError, StepFailed)) else text


class Steps:
    """The steps of a run, in order, with the seconds each took and the warnings there were.

    Prints a line for each step. Derived classes show it otherwise.
    """

    def __init__(self):
        self.seconds = {}
        self.warnings = []
        self.running = None
        self.signal = None

    def run(self, label, algorithm, work=None, known=None, reworded=None):
        """Update the algorithm, or do work() that uses it, as the step called label.

        known(text) returns whether a warning has been reported before in other words, and is to be dropped. reworded
        has parts of messages, and the words of the command for them.
        """
        def advance(caller, _):
            self.advanced(label, caller.GetProgress())

        # Python sees signals only while it runs, which it does here at least.
        tag = algorithm.AddObserver("ProgressEvent", advance)
        start = time.perf_counter()
        self.began(label)
        self.running = algorithm
        try:
            with same_locale(algorithm), heard(algorithm) as messages:
                (work or algorithm.Update)()
        finally:
            self.running = None
            algorithm.RemoveObserver(tag)
        self.seconds[label] = time.perf_counter() - start
        if self.signal is not None:
            raise Interrupted(self.signal)
        if messages.errors:
            raise StepFailed(f"{label}: {in_words(messages.errors, reworded)[0]}")
        warnings = [text for text in in_words(messages.warnings, reworded) if known is None or not known(text)]
        self.warnings += [f"{label}: {text}" for text in warnings]
        self.ended(label, warnings)

    def note(self, label, text):
        """Show a warning that is not of a filter."""
        self.warnings.append(f"{label}: {text}")
        self.ended(label, [text])

    def interrupt(self, number, _):
        """A signal handler: abort the filter that runs, or stop at once if none does."""
        self.signal = number
        if self.running is None:
            raise Interrupted(number)
        self.running.AbortExecuteOn()

    def began(self, label):
        """Show that a step begins."""

    def advanced(self, label, fraction):
        """Show how much of the step is done."""
        if sys.stdout is not None and sys.stdout.isatty():
            print(f"\r{printable(label):<28}{100 * fraction:6.0f} %", end="", flush=True)

    def ended(self, label, warnings):
        """Show that the step is done."""
        if sys.stdout is None:
            return
        shown = printable(label)
        print(f"\r{shown:<34}" if sys.stdout.isatty() else shown, flush=True)
        for text in warnings:
            print(f"  note: {printable(text)}", flush=True)


class BarSteps(Steps):
    """Steps that a bar shows on a terminal. Notes are lines on the standard error, after the name of the input."""

    def __init__(self, bar, name):
        super().__init__()
        self.bar, self.name = bar, name

    def began(self, label):
        self.bar.show(self.name, label, 0)

    def advanced(self, label, fraction):
        self.bar.show(self.name, label, int(100 * min(max(fraction, 0.0), 1.0)))

    def ended(self, label, warnings):
        for text in warnings:
            self.bar.note(f"conformalsom: {self.name}: note: {label}: {text}")
