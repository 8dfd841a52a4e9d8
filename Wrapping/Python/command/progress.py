"""Progress on a terminal: one line with a bar; elsewhere nothing."""
import os
import shutil
import sys
import unicodedata

BAR = 24  # characters
UNPRINTABLE = ("Cc", "Cf", "Cs", "Zl", "Zp")  # controls, directions of writing, parts of letters, line ends


def printable(text):
    """A text in one line that does nothing to a terminal."""
    return "".join(ascii(character)[1:-1] if unicodedata.category(character) in UNPRINTABLE else character
                   for character in text)


class Bar:
    """A single line of the terminal, if there is one, that shows what is done."""

    def __init__(self):
        self.shown = None
        self.terminal = sys.stderr is not None and sys.stderr.isatty() and os.environ.get("TERM") != "dumb"

    def show(self, name, label, percent):
        """Show how much is done of a step in what is called name."""
        if self.terminal and (name, label, percent) != self.shown:
            bar = "#" * (BAR * percent // 100)
            line = f"{percent:3} % [{bar:<{BAR}}] {printable(name)}: {printable(label)}"
            self.clear()
            sys.stderr.write(line[:shutil.get_terminal_size().columns - 1])
            sys.stderr.flush()
            self.shown = name, label, percent

    def clear(self):
        """Wipe the line."""
        if self.terminal and self.shown:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()
            self.shown = None

    def note(self, text):
        """Print a line above the bar."""
        self.clear()
        if sys.stderr is not None:
            print(printable(text), file=sys.stderr)
