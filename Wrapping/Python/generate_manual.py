"""generate_manual.py FOLDER: manual pages of the command conformalsom and its subcommands, from their parsers.

A page has what --help prints: a paragraph of the epilog that begins with a word in lower case and a colon begins
a section. A subcommand whose classes were left out of the build gets no page. If the environment variable
SOURCE_DATE_EPOCH is set, pages have its date.
"""
import argparse
import importlib
import os
import re
import sys
import textwrap
import time

import conformalsom

COMMANDS = {"conformalsom": "main", "conformalsom-shapes": "shapes", "conformalsom-map": "maps",
            "conformalsom-movie": "movie"}


def escaped(text):
    """Text for roff: hyphens are those that users type, and no line is taken for a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^(?=[.'])", r"\\&", text, flags=re.MULTILINE)


def filled(text):
    """Text for roff in short lines, which are filled anew."""
    return escaped(textwrap.fill(text, 70, break_long_words=False, break_on_hyphens=False))


def value_of(action):
    """How the value of an option or an argument is written: names that users replace are in italics."""
    if action.nargs == 0:
        return ""
    if action.choices is not None and not action.metavar:
        return " {" + ",".join(rf"\fB{escaped(str(choice))}\fR" for choice in action.choices) + "}"
    names = action.metavar if isinstance(action.metavar, tuple) else (action.metavar,)
    return "".join(rf" \fI{escaped(name)}\fR" for name in names) + ("..." if action.nargs == "+" else "")


def synopsis(parser):
    """The command with its arguments, and with the options that must be given."""
    words = [rf"\fB{parser.prog}\fR", r"[\fIOPTION\fR]..."]
    for action in parser._actions:  # argparse has no public list
        if not action.option_strings:
            words.append(value_of(action).strip())
        elif action.required:
            words.append(rf"\fB{escaped(action.option_strings[0])}\fR{value_of(action)}")
    return " ".join(words)


def options(parser):
    """What each argument and option is, those that --help hides left out."""
    expand = parser.formatter_class(parser.prog)._expand_help
    for action in parser._actions:
        if action.help == argparse.SUPPRESS:
            continue
        names = [rf"\fB{escaped(name)}\fR{value_of(action)}" for name in action.option_strings]
        help_text = expand(action)
        yield f".TP\n{', '.join(names) or value_of(action).strip()}"
        yield filled(help_text[0].upper() + help_text[1:])


def paragraphs(text):
    """Lines of a description or an epilog: text that is filled, and indented lines that are kept."""
    for number, paragraph in enumerate(text.strip("\n").split("\n\n")):
        heading = re.match(r"([a-z][A-Za-z ]*):\s*", paragraph)
        if heading:
            yield f".SH {heading[1].upper()}"
            paragraph = paragraph[heading.end(1) + 1:].strip("\n")
        elif number:
            yield ".PP"
        kept = False
        for line in paragraph.split("\n"):
            if line.startswith("  ") != kept:
                kept = not kept
                yield ".nf" if kept else ".fi"
            yield escaped(line) if kept else filled(line)
        if kept:
            yield ".fi"


def page(name, module):
    """The manual page of a command: its lines, in ASCII."""
    parser = module.make_parser()
    brief = re.search(r": ([^,.\n]+)", module.__doc__)[1]
    others = [other for other in COMMANDS if other != name]
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    date = time.strftime("%Y-%m-%d", time.gmtime(int(epoch))) if epoch else ""
    return "\n".join([
        '.\\" Made from the options of the command by generate_manual.py.',
        f'.TH {escaped(name.upper())} 1 "{date}" "ConformalSOM {conformalsom.__version__}" "User Commands"',
        f".SH NAME\n{escaped(name)} \\- {escaped(brief)}", f".SH SYNOPSIS\n{synopsis(parser)}",
        ".SH DESCRIPTION", *paragraphs(parser.description), ".SH OPTIONS", *options(parser),
        *paragraphs(parser.epilog),
        ".SH SEE ALSO", ",\n".join(rf".BR {escaped(other)} (1)" for other in others), ""])


def main(folder):
    """Write the page of each command that this build has."""
    os.makedirs(folder, exist_ok=True)
    for name, module_name in COMMANDS.items():
        try:
            module = importlib.import_module(f"conformalsom.command.{module_name}")
        except ImportError as error:
            print(f"{name}: no manual page: {error}")
            continue
        with open(os.path.join(folder, name + ".1"), "w", encoding="ascii") as file:
            file.write(page(name, module))


if __name__ == "__main__":
    main(sys.argv[1])
