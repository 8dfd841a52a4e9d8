#!/usr/bin/python3
"""class_page.py HEADER: the header for Doxygen, with the picture and the snippet that Filters.md has of its class."""
import os
import re
import sys

GUIDE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "Filters.md")


def section_of(kind):
    """What the guide says of a class; nothing if it has no section."""
    heading = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", kind[len("vtk"):])
    with open(GUIDE, encoding="utf-8") as file:
        found = re.search(rf"^## {heading}$(.*?)(?=^## |\Z)", file.read(), flags=re.M | re.S)
    return found.group(1) if found else ""


def shown(section):
    """Its pictures and snippets, as lines of a class comment."""
    lines = [f'@image html {os.path.basename(path)} "{caption}"'
             for caption, path in re.findall(r"^!\[(.*?)\]\((.*?)\)$", section, flags=re.M)]
    for code in re.findall(r"```python\n(.*?)```", section, flags=re.S):
        lines += ["In Python:", "@code{.py}", *code.splitlines(), "@endcode"]
    return "".join(f" * {line}".rstrip() + "\n" for line in ["", *lines])


def page(text, kind):
    # Before what it sees also, or at the end of the class comment.
    comment = re.search(r"/\*\*\n \* @class.*?\*/", text, flags=re.S)
    escaped = re.sub(r"#(?=[A-Z])", r"\\#", text)
    section = section_of(kind)
    if not comment or not section:
        return escaped
    body = re.sub(r"#(?=[A-Z])", r"\\#", comment.group(0))
    at = body.find(" *\n * @sa")
    at = at if at >= 0 else len(body) - len(" */")
    return escaped.replace(body, body[:at] + shown(section) + body[at:], 1)


def main(path):
    with open(path, encoding="utf-8") as file:
        sys.stdout.write(page(file.read(), os.path.splitext(os.path.basename(path))[0]))


if __name__ == "__main__":
    main(sys.argv[1])
