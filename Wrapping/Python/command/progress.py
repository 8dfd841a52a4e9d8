"""Progress on a terminal: one line with a bar; elsewhere nothing."""
import os
import shutil
import sys

from .steps import Steps

BAR = 24  # characters


class Bar(Steps):
    """Steps that show the one that runs in a single line of the terminal, if there is one."""

    def __init__(self):
        super().__init__()
        self.name = ""
        self.shown = None
        self.terminal = sys.stderr.isatty() and os.environ.get("TERM") != "dumb"

    def begin(self, name):
        """Start anew, with what is called name."""
        self.name, self.seconds, self.warnings = name, {}, []

    def advanced(self, label, fraction):
        percent = int(100 * min(max(fraction, 0.0), 1.0))
        if self.terminal and (label, percent) != self.shown:
            bar = "#" * (BAR * percent // 100)
            line = f"{percent:3} % [{bar:<{BAR}}] {self.name}: {label}"
            self.clear()
            sys.stderr.write(line[:shutil.get_terminal_size().columns - 1])
            sys.stderr.flush()
            self.shown = label, percent

    def ended(self, label, warnings):
        self.clear()
        for text in warnings:
            print(f"conformalsom: {self.name}: note: {label}: {text}", file=sys.stderr)

    def clear(self):
        """Wipe the line."""
        if self.terminal and self.shown:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()
            self.shown = None

    def summarize(self, files, number_of_points):
        """Say on the terminal what was made."""
        if self.terminal:
            print(f"{self.name}: {', '.join(files) or 'measured'} ({number_of_points:,} points, "
                  f"{sum(self.seconds.values()):.1f} s)", file=sys.stderr)
