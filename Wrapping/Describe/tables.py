#!/usr/bin/python3
"""tables.py [--renew]: compare tables in the README and the guides with the classes, or write them anew.

The README has a row for each class, with its brief; the rows stay in the order that they have, and new classes
come last. A section of Filters.md or Readers.md that is named as a class ends with a table of its properties.
"""
import difflib
import inspect
import os
import re
import sys

from describe import class_comment, classes, modules, words_of

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
GUIDES = (os.path.join("Documentation", "Filters.md"), os.path.join("Documentation", "Readers.md"))
RENEW = "PYTHONPATH=build/dev/python /usr/bin/python3 Wrapping/Describe/tables.py --renew"
CLASS_TABLE = re.compile(r"(?<=^\| class \| what it does \|\n\| --- \| --- \|\n)(?:\|.*\n)+", re.M)
MARK = "<!-- Properties, written by Wrapping/Describe/tables.py -->\n"
PROPERTY_TABLE = re.compile(re.escape("\n" + MARK) + r"(?:\|.*\n)+")


def briefs():
    """Return the briefs of all classes of which users make objects, by name."""
    found = {}
    for module in modules():
        for name, class_ in vars(module).items():
            if inspect.isclass(class_) and name.startswith("vtk"):
                try:
                    class_()
                except (NotImplementedError, TypeError):
                    continue  # a base of others
                found[name] = class_comment(class_)[0]
    return found


def class_rows(old, texts):
    """Return a row for each class, in the order of the old ones."""
    names = [name for name in re.findall(r"`(vtk\w+)`", old) if name in texts]
    names += [name for name in texts if name not in names]
    return "".join(f"| `{name}` | {texts[name]} |\n" for name in dict.fromkeys(names))


def number(value):
    """Write a number as people do: 64,002 and 0.01."""
    return f"{int(value):,}" if value == int(value) else repr(value)


def default_of(property_):
    """Write the default of a property."""
    if property_.repeated or property_.default == "":
        return "none"
    if property_.values:
        [word] = [value.word for value in property_.values if value.value == property_.default]
        return word
    if isinstance(property_.default, bool):
        return "on" if property_.default else "off"
    if isinstance(property_.default, str):
        return property_.default
    if isinstance(property_.default, tuple):
        return f"({', '.join(number(value).replace(',', '') for value in property_.default)})"
    return number(property_.default)


def values_of(property_):
    """Write what values a property may have: a range, a choice, or the types."""
    if property_.values:
        return ", ".join(value.word for value in property_.values)
    if property_.types == ["bool"]:
        return "on, off"
    if property_.minimum is not None and property_.maximum is not None:
        return f"{number(property_.minimum)} to {number(property_.maximum)}"
    if property_.minimum is not None:
        return f"at least {number(property_.minimum)}"
    kinds = {"int": "integer", "float": "number", "str": "text"}
    kind = ", ".join(dict.fromkeys(kinds[type_] for type_ in property_.types))
    count = len(property_.types)
    text = kind if count == 1 or "," in kind else f"{count} {kind}s"
    return f"any number of ({text})" if property_.repeated else text


def property_table(class_):
    """Write the table of a class's properties; nothing if it has none of its own."""
    rows = [f"| `{property_.name}` | {default_of(property_)} | {values_of(property_)} |\n"
            for property_ in class_.properties if property_.name != "FileName"]
    return "\n" + MARK + "| property | default | values |\n| --- | --- | --- |\n" + "".join(rows) if rows else ""


def renewed_guide(text, described):
    """Return a guide with a table of properties at the end of each section of a class."""
    tables = {words_of(class_.unit): property_table(class_) for class_ in described.values()}
    pieces = re.split(r"(?m)^(?=##+ )", PROPERTY_TABLE.sub("", text))
    for i, piece in enumerate(pieces):
        heading = re.match(r"##+ (.*)\n", piece)
        if heading and tables.get(heading[1]):
            pieces[i] = piece.rstrip("\n") + "\n" + tables[heading[1]] + "\n" * (i + 1 < len(pieces))
    return "".join(pieces)


def renewed(path, text, described, texts):
    """Return a document with tables as they are to be."""
    if path == "README.md":
        return CLASS_TABLE.sub(lambda old: class_rows(old[0], texts), text)
    return renewed_guide(text, described)


def differences():
    """Return path, new text and the difference to the old one, of all documents that are not as they are to be."""
    described, texts = classes(), briefs()
    for path in ("README.md", *GUIDES):
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            old = file.read()
        new = renewed(path, old, described, texts)
        if new != old:
            lines = difflib.unified_diff(old.splitlines(), new.splitlines(), path, path + ", renewed", lineterm="", n=0)
            yield path, new, "\n".join(lines)


def main(arguments):
    """Write the documents, or print what differs; then the exit status is 1."""
    found = list(differences())
    for path, new, difference in found:
        if arguments == ["--renew"]:
            with open(os.path.join(ROOT, path), "w", encoding="utf-8") as file:
                file.write(new)
        else:
            print(difference)
    if found and arguments != ["--renew"]:
        sys.exit("Tables differ from the classes. Write them anew by\n  " + RENEW)


if __name__ == "__main__":
    main(sys.argv[1:])
