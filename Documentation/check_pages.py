#!/usr/bin/python3
"""check_pages.py FOLDER: fail where a page has a dead local link or a citation that stands raw."""
import glob
import html
import os
import re
import sys
import urllib.parse

MADE_BY_DOXYGEN = {"#nested-classes"}  # of summaries that it leaves out


def dead_links(pages, folder="."):
    """Local links of pages in a folder to a file that is not there, or to a place that no page has."""
    places = {name: set(re.findall(r'(?:id|name)="([^"]+)"', text)) for name, text in pages.items()}
    for name, text in sorted(pages.items()):
        for link in dict.fromkeys(re.findall(r'(?:href|src)="([^"]+)"', text)):
            link = html.unescape(link)
            if link in MADE_BY_DOXYGEN or re.match(r"[a-z]+:|//", link):
                continue
            file, _, place = link.partition("#")
            file = urllib.parse.unquote(file) or name
            if not os.path.exists(os.path.join(folder, file)):
                yield f"{name}: no file {link}"
            elif place and file in places and place not in places[file]:
                yield f"{name}: no place {link}"


def faults(pages):
    """What is wrong on each page: a dead link, or a raw command."""
    yield from dead_links(pages)
    for name, text in sorted(pages.items()):
        if re.search(r"[\\@]cite\b|<b>\[[A-Z][a-z]+\d{4}\]</b>", text):
            yield f"{name}: a citation is not resolved"


def main():
    os.chdir(sys.argv[1])
    pages = {name: open(name, encoding="utf-8").read() for name in glob.glob("*.html")}
    found = list(faults(pages))
    if not pages:
        found = ["no pages"]
    print("\n".join(found) if found else f"{len(pages)} pages without a dead link")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
