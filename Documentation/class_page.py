#!/usr/bin/python3
"""class_page.py HEADER: the header for Doxygen, with what the guides have of its class: picture, snippet, properties."""
import os
import re
import sys

GUIDES = [os.path.join(os.path.dirname(os.path.abspath(__file__)), name) for name in ("Filters.md", "Readers.md")]


def section_of(kind):
    """Return the section of a class in the guides; nothing if it has none."""
    heading = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", kind[len("vtk"):])
    for guide in GUIDES:
        with open(guide, encoding="utf-8") as file:
            found = re.search(rf"^(##+) {heading}$(.*)", file.read(), flags=re.M | re.S)
        if found:
            return re.split(rf"^#{{2,{len(found[1])}}} ", found[2], maxsplit=1, flags=re.M)[0]
    return ""


def shown(section):
    """Return its pictures, snippets and properties, as lines of a class comment."""
    lines = [f'@image html {os.path.basename(path)} "{caption}"'
             for caption, path in re.findall(r"^!\[(.*?)\]\((.*?)\)$", section, flags=re.M)]
    for code in re.findall(r"```python\n(.*?)```", section, flags=re.S):
        lines += ["In Python:", "@code{.py}", *code.splitlines(), "@endcode"]
    lines += ["\n" + table for table in re.findall(r"^<!-- Properties.*\n((?:\|.*\n)+)", section, flags=re.M)]
    return "".join(f" * {line}".rstrip() + "\n" for line in "\n".join(["", *lines]).splitlines())


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
