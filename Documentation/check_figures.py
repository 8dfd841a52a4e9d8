#!/usr/bin/python3
"""Run the commands that print the tables of the guides, and report rows that differ from what is printed.

    PYTHONPATH=build/dev/python:Examples/Python Documentation/check_figures.py [--renew | --stamp] [GUIDE ...]
    Documentation/check_figures.py --age [GUIDE ...]

A comment on the line before a table of a guide names the command, and the commit at which its rows were last printed:

    <!-- figures at 20020753: Testing/Benchmarks/measure_geodesics.py SCANS/spot.ply -->
    | surface | points | ...

SCANS stands for the folder of scans. The script runs from the folder of the project, and prints Markdown tables or
columns that are at least two spaces apart. "&&" joins commands that print rows of one table. The printed table is the
one that has most of the titles of the guide's table, and as many rows. Other columns of the guide, such as those of an
earlier version, are not compared. Two numbers agree if they differ by at most TOLERANCE of the larger one, or by one
unit of the last printed digit. Names of rows are not compared, and no columns of times and memory, since they depend on
the machine: those whose titles contain CPU, seconds, time, ms, MB or MiB. Exit status 1 if a row differs.

--renew     replace tables by the printed ones, with the commit; of the code, the last commit that changed it
--stamp     write the commit before the tables that agree with the printed ones, and keep their rows
--only      run only commands that contain this text
--age       run nothing: list the tables, and how many commits have changed the code since each was printed, or
            where no commit is named, since its rows were last edited
"""
import argparse
import glob
import os
import re
import shlex
import subprocess
import sys
from typing import NamedTuple

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
CODE = ["CMakeLists.txt", "Filters", "IO"]  # what is measured
MARK = re.compile(r"(\s*)<!-- figures(?: at ([0-9a-f]+))?: (.*?) -->\s*$")
OF_THE_MACHINE = re.compile(r"\b(CPU|seconds|time|ms|s|MB|MiB)\b")
ROUNDING = 1e-11  # smaller differences are not compared
SEPARATOR = re.compile(r"\s*\|(\s*:?-{2,}:?\s*\|)+\s*$")  # line after the titles of a table
NUMBER = re.compile(r"[-+]?\d[\d,]*\.?\d*(?:e[-+]?\d+)?")


class Table(NamedTuple):
    """A table of a guide: lines [begin, end) without the comment."""
    guide: str
    indent: str
    commit: str  # of the last run, or None
    command: str
    begin: int
    end: int
    lines: list


def tables_in(lines):
    """Begin and end of each Markdown table. A table can begin on the line after another one."""
    begin = None
    for number, (line, following) in enumerate(zip([*lines, ""], [*lines[1:], "", ""])):
        inside = line.strip().startswith("|")
        if begin is not None and (not inside or SEPARATOR.match(following)):
            yield begin, number
            begin = None
        if inside and begin is None:
            begin = number


def marked_tables(guide):
    """Tables of a guide whose command is known."""
    with open(guide, encoding="utf-8") as file:
        lines = file.read().split("\n")
    for begin, end in tables_in(lines):
        mark = MARK.match(lines[begin - 1]) if begin else None
        if mark:
            yield Table(guide, *mark.groups(), begin, end, lines[begin:end])


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def columns_of(line):
    """Texts that are two spaces or more apart."""
    return re.split(r" {2,}", line.strip())


def printed_tables(text):
    """Rows of each printed table, by its titles."""
    lines = text.split("\n")
    found = {}
    for begin, end in tables_in(lines):
        rows = [cells(line) for line in lines[begin:end]]
        found.setdefault(tuple(rows[0]), []).extend(rows[2:])
    titles = None
    for line in lines:
        row = columns_of(line)
        if "|" in line or len(row) < 3:
            continue
        if 2 * sum(bool(NUMBER.fullmatch(cell)) for cell in row) < len(row):
            titles = tuple(row)
        elif titles and len(titles) == len(row):
            found.setdefault(titles, []).append(row)
    return found


def numbered(titles):
    """Titles with how often each one came before: a table can have several columns of one title."""
    return [(title, titles[:column].count(title)) for column, title in enumerate(titles)]


def printed_columns(table, printed):
    """Columns of the printed table that suits best, by numbered titles; None if two columns are not found."""
    titles = set(numbered(cells(table.lines[0])))
    best = max(printed, key=lambda others: len(titles & set(numbered(others))), default=())
    if len(titles & set(numbered(best))) < 2:
        return None
    return {title: [row[column] for row in printed[best]]
            for column, title in enumerate(numbered(best)) if title in titles}


def step(number):
    """A unit of the last printed digit."""
    mantissa, _, exponent = number.partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def agree(one, other, tolerance):
    """Whether the texts of two cells are equal but for small differences of their numbers."""
    if NUMBER.sub("#", one.replace("*", "")) != NUMBER.sub("#", other.replace("*", "")):
        return False
    for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)):
        a, b = a.replace(",", ""), b.replace(",", "")
        difference = abs(float(a) - float(b))
        if difference > max(ROUNDING, tolerance * max(abs(float(a)), abs(float(b))), 1.001 * max(step(a), step(b))):
            return False
    return True


def differences(table, printed, tolerance):
    """What differs between a table and what is printed."""
    titles, _, *rows = (cells(line) for line in table.lines)
    columns = printed_columns(table, printed)
    if columns is None:
        yield "nothing is printed with these titles"
        return
    count = len(next(iter(columns.values())))
    if count != len(rows):
        yield f"{len(rows)} rows, but {count} are printed"
        return
    for number, row in enumerate(rows):
        for title, cell in zip(numbered(titles)[1:], row[1:]):
            if title in columns and re.search(r"\d", cell) and not OF_THE_MACHINE.search(title[0]):
                if not agree(cell, columns[title][number], tolerance):
                    yield f"{row[0]}, {title[0]}: {cell}, but {columns[title][number]} is printed"


def run(command, scans):
    text = ""
    for part in command.split("&&"):
        words = [word.replace("SCANS", scans) for word in shlex.split(part)]
        result = subprocess.run([sys.executable, *words], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=False)
        if result.returncode:
            raise RuntimeError(f"exit status {result.returncode}")
        text += result.stdout
    return printed_tables(text)


def renewed(table, printed):
    """Lines of the table with what is printed, indented as before; None if it does not suit."""
    columns = printed_columns(table, printed)
    titles, _, *rows = (cells(line) for line in table.lines)
    titles = numbered(titles)
    if columns is None:
        return None
    count = len(next(iter(columns.values())))
    if set(titles) - set(columns) and count != len(rows):
        return None
    short = "e-0" not in "".join(table.lines)
    new = [f"{table.indent}| " + " | ".join(columns[title][number] if title in columns else rows[number][column]
                                            for column, title in enumerate(titles)) + " |" for number in range(count)]
    return [*table.lines[:2], *(re.sub(r"(?<=\de[-+])0(?=\d)", "", row) if short else row for row in new)]


def renew(guide, outputs, tolerance=None):
    """
    Replace tables of a guide by printed ones, or with a tolerance, keep those that agree; name the commit. The guide is
    read again: it may have changed while commands ran.
    """
    with open(guide, encoding="utf-8") as file:
        lines = file.read().split("\n")
    commit = git("log", "-1", "--format=%h", "--", *CODE).strip()
    for table in reversed(list(marked_tables(guide))):
        printed = outputs.get(table.command)
        if printed is None:
            continue
        if tolerance is None:
            rows = renewed(table, printed)
        else:
            rows = None if any(differences(table, printed, tolerance)) else table.lines
        if rows is not None:
            mark = f"{table.indent}<!-- figures at {commit}: {table.command} -->"
            lines[table.begin - 1:table.end] = [mark, *rows]
    with open(guide, "w", encoding="utf-8") as file:
        file.write("\n".join(lines))


def git(*words):
    return subprocess.run(["git", *words], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True).stdout


def print_ages(tables):
    for table in tables:
        if table.commit:
            since = [f"{table.commit}..HEAD"]
        else:
            blame = git("blame", "--line-porcelain", "-L", f"{table.begin + 1},{table.end}", "--", table.guide)
            last = max(int(time) for time in re.findall(r"^committer-time (\d+)", blame, re.M))
            since = [f"--since={last}", "HEAD"]
        commits = git("rev-list", "--count", *since, "--", *CODE).strip()
        place = f"{os.path.basename(table.guide)}:{table.begin + 1}"
        print(f"{place}: {commits} commits to the code since, {table.command}")


def check(tables, options):
    """Run the commands and print differences. Return printed tables, by command, and the number of stale tables."""
    outputs, stale = {}, 0
    for table in tables:
        if table.command not in outputs:
            print(f"running {table.command}", file=sys.stderr, flush=True)
            try:
                outputs[table.command] = run(table.command, options.scans)
            except RuntimeError as error:
                print(f"{table.command}: {error}", flush=True)
                outputs[table.command] = {}
        found = list(differences(table, outputs[table.command], options.tolerance))
        stale += bool(found)
        for difference in found:
            print(f"{os.path.basename(table.guide)}:{table.begin + 1}: {difference}", flush=True)
    print(f"{len(tables)} tables, {stale} differ")
    return outputs, stale


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("guides", nargs="*", default=sorted(glob.glob(os.path.join(ROOT, "Documentation", "*.md"))))
    parser.add_argument("--scans", default="../shared/data", help="folder of scans, default %(default)s")
    parser.add_argument("--tolerance", type=float, default=0.05, help="default %(default)s")
    parser.add_argument("--only", default="", metavar="TEXT")
    modes = parser.add_mutually_exclusive_group()
    for mode in ("--renew", "--stamp", "--age"):
        modes.add_argument(mode, action="store_true")
    options = parser.parse_args()
    tables = [table for guide in options.guides for table in marked_tables(guide) if options.only in table.command]
    if options.age:
        print_ages(tables)
        return 0
    outputs, stale = check(tables, options)
    if options.renew or options.stamp:
        for guide in dict.fromkeys(table.guide for table in tables):
            renew(guide, outputs, None if options.renew else options.tolerance)
    return 1 if stale and not options.renew else 0


if __name__ == "__main__":
    sys.exit(main())
