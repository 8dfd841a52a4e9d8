"""Scans, each in a process of its own: one that crashes or is killed ends no other."""
import contextlib
import io
import json
import multiprocessing
import os
import signal
import sys
import time
import typing
from multiprocessing import connection

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkSMPTools, vtkStringOutputWindow
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

from . import outputs, report, surfaces, textures
from .steps import Interrupted, StepFailed, Steps, message_of

# A forked process has loaded VTK and the picture already. Elsewhere the libraries of the system cannot be forked.
CONTEXT: typing.Any = multiprocessing.get_context("fork" if sys.platform == "linux" else "spawn")
SIGNALS = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
SECONDS_TO_STOP = 10  # before a process that was asked to stop is killed
LONGEST_MESSAGE = 2**28
KEPT_LOG = 2**12  # bytes


def processors():
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def silence():
    """Let VTK print nothing; what matters is heard by steps."""
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    vtkOutputWindow.SetInstance(vtkStringOutputWindow())


class TellingSteps(Steps):
    """Steps of a process that tells another one what it does."""

    def __init__(self, told, shows):
        super().__init__()
        self.told = told
        self.shows = shows
        self.parent = os.getppid()
        self.last = None

    def tell(self, kind, *values):
        """Send a message."""
        self.told.send_bytes(json.dumps([kind, *values]).encode())

    def began(self, label):
        self.tell("began", label)

    def advanced(self, label, fraction):
        percent = int(100 * min(max(fraction, 0.0), 1.0))
        if os.getppid() != self.parent:  # which has been killed
            self.interrupt(signal.SIGTERM, None)
        elif self.shows and percent != self.last:
            self.last = percent
            self.tell("advanced", label, percent)

    def ended(self, label, warnings):
        self.tell("ended", label, warnings)


def work(make, task, options, pixels, told, log, shows, threads):
    """Do one task by make() in a process of its own, and tell how it went."""
    os.dup2(log.fileno(), 1)
    os.dup2(log.fileno(), 2)
    steps = TellingSteps(told, shows)
    handle_signals(steps.interrupt)
    try:
        if hasattr(signal, "pthread_sigmask"):
            signal.pthread_sigmask(signal.SIG_UNBLOCK, SIGNALS)
        silence()
        if threads:
            vtkSMPTools.Initialize(threads)
        steps.tell("made", *make(task, options, pixels, steps))
    except Interrupted as interrupted:
        outputs.discard(task.paths.files(), task.token)
        signal.signal(interrupted.args[0], signal.SIG_DFL)
        os.kill(os.getpid(), interrupted.args[0])
    except (StepFailed, MemoryError, ValueError, OSError) as error:
        steps.tell("failed", message_of(error, task.scan))


def made(task, options, pixels, steps):
    """The figures of a scan's surface, and the table that --measure prints."""
    texture = None
    if pixels is not None:
        texture = vtkTrivialProducer()
        texture.SetOutput(textures.image_of(pixels))
    entry, stages = surfaces.make_surface(task, texture, options, steps)
    table = io.StringIO()
    if options.measure:
        with contextlib.redirect_stdout(table):
            scan, mesh, surface = stages
            report.print_table(scan, mesh, surface, steps.seconds)
    return entry, table.getvalue()


class Job:
    """A scan at work in another process, and what is known about it."""

    def __init__(self, make, task, options, pixels, shows, threads):
        self.task = task
        self.label, self.percent = "Start", 0
        self.log, self.entry, self.crashed = b"", None, False
        self.lines = []  # what to print: pairs of "out", "note" or "terminal", and a text
        self.told, told = CONTEXT.Pipe(duplex=False)
        self.printed, printed = CONTEXT.Pipe(duplex=False)
        self.process = CONTEXT.Process(
            target=work, args=(make, task, options, pixels, told, printed, shows, threads), daemon=True)
        with blocked_signals():  # until the process has its own handlers
            self.process.start()
        told.close()
        printed.close()

    def channels(self):
        """The ends of pipes that still have something."""
        return [end for end in (self.told, self.printed) if not end.closed]

    def read(self, end):
        """Take what has come, and close the end if that was all."""
        try:
            if end is self.told:
                self.take(*json.loads(end.recv_bytes(LONGEST_MESSAGE)))
            else:
                text = os.read(end.fileno(), 2**16)
                self.log = (self.log + text)[-KEPT_LOG:]
                if not text:
                    end.close()
        except (EOFError, OSError, ValueError):
            end.close()

    def take(self, kind, *values):
        """Take a message."""
        if kind == "began":
            self.label, self.percent = values[0], 0
        elif kind == "advanced":
            self.label, self.percent = values
        elif kind == "ended":
            label, warnings = values
            self.lines += [("note", f"{self.task.scan}: note: {label}: {text}") for text in warnings]
        elif kind == "failed":
            self.fail(values[0])
        elif kind == "made":
            self.entry, table = values
            seconds, points = sum(self.entry["Seconds"].values()), self.entry["Surface"]["NumberOfPoints"]
            self.lines += [("note", text) for text in self.entry.get("Error", "").splitlines()]
            self.lines += [("out", table)] if table else []
            files = ", ".join(self.entry.get("Files", self.task.paths.all()))
            done = files or ("no file" if "Error" in self.entry else "measured")
            self.lines.append(("terminal", f"{self.task.scan}: {done} "
                               f"({points:,} points, {seconds:.1f} s)"))

    def fail(self, text):
        """Note an error."""
        self.entry = {"Scan": self.task.scan, "Error": text}
        self.lines.append(("note", text))

    def finish(self):
        """Wait for the end of the process, and remove what it left if it told nothing."""
        self.process.join()
        if self.entry is None:
            outputs.discard(self.task.paths.files(), self.task.token)
            self.fail(f"{self.task.scan}: {self.label}: {self.end()}{self.last_words()}")

    def end(self):
        """How the process ended."""
        code = self.process.exitcode
        if code < 0:
            return f"the process crashed by {textures.name_of(-code)}"
        return f"the process ended with status {code}"

    def last_words(self):
        """The last line that the process printed, which may say why."""
        lines = [line.strip() for line in self.log.decode(errors="replace").splitlines() if line.strip()]
        return "".join(f": {line[:200]}" for line in lines[-1:])


def handle_signals(handler):
    """Call a handler for signals that ask to stop, unless the command was started to ignore them."""
    for number in SIGNALS:
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, handler)


@contextlib.contextmanager
def blocked_signals():
    """Let signals wait that ask to stop."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


class Jobs:
    """All scans, so many at a time; lines are printed in the order of the scans.

    make(task, options, pixels, steps) does the work for a scan, and returns its entry of the report and a table.
    """

    def __init__(self, tasks, options, pixels, bar, make=made):
        self.make = make
        self.waiting = list(reversed(tasks))
        self.options, self.pixels, self.bar = options, pixels, bar
        self.number = min(options.jobs, len(tasks))
        self.threads = max(processors() // self.number, 1) if self.number > 1 else 0
        self.running, self.all = [], []

    def run(self):
        """Make all surfaces; returns the figures of each, or its error."""
        printed = 0
        try:
            while self.waiting or self.running:
                while self.waiting and len(self.running) < self.number:
                    self.start(self.waiting.pop())
                self.listen()
                while printed < len(self.all):
                    self.print_lines(self.all[printed])
                    if self.all[printed] in self.running:
                        break
                    printed += 1
                for first in [job for job in self.running if job.entry is None][:1]:
                    self.bar.show(first.task.scan, first.label, first.percent)
            self.bar.clear()
        finally:
            self.stop()
        return [job.entry for job in self.all]

    def start(self, task):
        """Start a scan."""
        job = Job(self.make, task, self.options, self.pixels, self.bar.terminal, self.threads)
        self.running.append(job)
        self.all.append(job)

    def listen(self):
        """Wait for messages, and for the end of processes."""
        ends = {end: job for job in self.running for end in job.channels()}
        for end in connection.wait(list(ends)):
            ends[end].read(end)
        for job in [job for job in self.running if not job.channels()]:
            job.finish()
            self.running.remove(job)

    def print_lines(self, job):
        """Print what a job has to say."""
        for kind, text in job.lines:
            self.bar.clear()
            if kind == "out":
                name = "stderr" if self.options.report == "-" else "stdout"
                with outputs.named_errors({"stderr": "the standard error", "stdout": "the standard output"}[name]):
                    print(text, end="", flush=True, file=getattr(sys, name))
            elif kind == "note":
                self.bar.note(f"conformalsom: {text}")
            elif self.bar.terminal:
                self.bar.note(text)
        job.lines.clear()

    def stop(self):
        """End all processes that still run, and remove what they leave."""
        for job in self.running:
            job.process.terminate()
        deadline = time.monotonic() + SECONDS_TO_STOP
        for job in self.running:
            job.process.join(max(deadline - time.monotonic(), 0.0))
            job.process.kill()
            job.process.join()
            outputs.discard(job.task.paths.files(), job.task.token)
