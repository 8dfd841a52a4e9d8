#!/usr/bin/python3
"""make_site.py FOLDER [--reference HTML]: the project's web site: a home page, the guides, and the reference.

The home page is Site/home.html. The guides are the Markdown files of the project. The reference is a folder of pages
that Doxygen made (target docs). Every local link and every picture is checked; dead ones are an error, and FOLDER then
stays as it was. Needs Debian's package python3-markdown.
"""
import argparse
import html
import os
import re
import shutil
import sys
import tempfile
import urllib.parse

import markdown

import check_pages

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SITE = os.path.join(ROOT, "Documentation", "Site")
GUIDES = [  # in the order of the menu
    ("Start", ["README.md", "Documentation/Tutorials.md", "Documentation/HowItWorks.md", "Documentation/Gallery.md",
               "Examples/README.md"]),
    ("Use", ["Documentation/Command.md", "Documentation/Python.md", "Documentation/ParaView.md",
             "Documentation/Scans.md", "Documentation/Tissue.md", "Documentation/Cortex.md",
             "Documentation/Clusters.md"]),
    ("Look up", ["Documentation/Filters.md", "Documentation/Pipeline.md", "Documentation/Readers.md",
                 "Documentation/Fit.md", "Documentation/CurvedSeamlessSurface.md",
                 "Documentation/GlobalConformalMap.md", "Documentation/Correspondence.md",
                 "Documentation/SphericalCoordinates.md", "Documentation/Errata.md"]),
    ("Project", ["CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "Documentation/Roadmap.md",
                 "Documentation/Release.md"]),
]
LINK = re.compile(r'(href|src)="([^"]+)"')


def page_name(path):
    """The page of a Markdown file; paths are those in the project."""
    name = os.path.splitext(os.path.basename(path))[0]
    return {"README.md": "ReadMe", "Examples/README.md": "Examples"}.get(path, name) + ".html"


PAGES = {path: page_name(path) for _, paths in GUIDES for path in paths}


def anchor(text, separator):
    """The id of a heading, as GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", separator)


def title_of(text):
    """The first heading."""
    return re.search(r"^# (.+)$", text, re.M).group(1)


class Site:
    """Pages and pictures in a folder."""

    def __init__(self, folder):
        self.folder = folder
        with open(os.path.join(SITE, "frame.html"), encoding="utf-8") as file:
            self.frame = file.read()
        self.menu = "".join(f"<h2>{group}</h2><ul>{''.join(self.menu_entry(path) for path in paths)}</ul>"
                            for group, paths in GUIDES)

    @staticmethod
    def menu_entry(path):
        """An entry of the menu."""
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            return f'<li><a href="{PAGES[path]}">{html.escape(title_of(file.read()))}</a></li>'

    def write(self, name, title, body):
        """Write a page."""
        text = self.frame.replace("{{title}}", html.escape(title)).replace("{{menu}}", self.menu)
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text.replace("{{body}}", body))

    def picture(self, path):
        """Copy a file of the project; returns its place in the site."""
        name = os.path.join("files", path.replace("/", "-"))
        os.makedirs(os.path.join(self.folder, "files"), exist_ok=True)
        shutil.copyfile(os.path.join(ROOT, path), os.path.join(self.folder, name))
        return name

    def linked(self, page, kind, link):
        """What a link of a file of the project becomes; raises ValueError if there is no such file."""
        if re.match(r"[a-z]+:|#", link):
            return link
        file, hash_, place = link.partition("#")
        path = os.path.normpath(os.path.join(os.path.dirname(page), urllib.parse.unquote(file)))
        if path in PAGES:
            return PAGES[path] + hash_ + place
        if path.startswith("..") or not os.path.exists(os.path.join(ROOT, path)):
            raise ValueError(f"{page}: no file {link}")
        if os.path.isdir(os.path.join(ROOT, path)):
            return PAGES.get(os.path.join(path, "README.md"), "ReadMe.html")
        return self.picture(path)

    def page(self, path):
        """Write the page of a Markdown file."""
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            text = file.read()
        body = markdown.markdown(text, extensions=["tables", "fenced_code", "sane_lists", "toc"], extension_configs={
            "toc": {"slugify": anchor}}, output_format="html")
        body = LINK.sub(lambda match: f'{match[1]}="{self.linked(path, match[1], html.unescape(match[2]))}"', body)
        body = re.sub(r'(<img [^>]*src="([^"]+)"[^>]*>)', r'<a href="\2">\1</a>', body)  # a click shows it in full size
        body = re.sub(r"(<table>.*?</table>)", r'<div class="wide">\1</div>', body, flags=re.S)
        self.write(PAGES[path], title_of(text), body)

    def home(self, has_reference):
        """Write the home page."""
        with open(os.path.join(SITE, "home.html"), encoding="utf-8") as file:
            body = file.read()
        body = LINK.sub(lambda match: match[0] if match[2].endswith(".html") or ".html#" in match[2] else
                        f'{match[1]}="{self.linked("Documentation/Site/home.html", match[1], match[2])}"', body)
        if not has_reference:
            body = re.sub(r"<!--reference-->.*?<!--/reference-->", "", body, flags=re.S)
        self.write("index.html", "ConformalSOM", body)

    def faults(self):
        """Dead links of all pages outside the reference."""
        pages = {}
        for name in sorted(os.listdir(self.folder)):
            if name.endswith(".html"):
                with open(os.path.join(self.folder, name), encoding="utf-8") as file:
                    pages[name] = file.read()
        return check_pages.dead_links(pages, self.folder)


def make(folder, reference):
    """Write all pages into an empty folder; returns the number of pages. Raises ValueError for dead links."""
    site = Site(folder)
    for name, source in (("base.css", "IO/Formats/Page/base.css"), ("site.css", "Documentation/Site/site.css")):
        shutil.copyfile(os.path.join(ROOT, source), os.path.join(folder, name))
    if reference:
        shutil.copytree(reference, os.path.join(folder, "reference"))
    site.home(bool(reference))
    for path in PAGES:
        site.page(path)
    faults = list(site.faults())
    if faults:
        raise ValueError("\n".join(faults))
    return 1 + len(PAGES)


def main():
    """Make the site beside FOLDER, and put it there as a whole."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="FOLDER", help="folder to write; an earlier site there is replaced")
    parser.add_argument("--reference", metavar="HTML", help="folder of Doxygen's pages, copied to FOLDER/reference")
    options = parser.parse_args()
    folder = os.path.realpath(options.folder)
    if os.path.lexists(folder) and os.listdir(folder) and not os.path.exists(os.path.join(folder, "site.css")):
        parser.error(f"{options.folder} has files that are not of a site; use another folder")
    if options.reference and not os.path.exists(os.path.join(options.reference, "index.html")):
        parser.error(f"{options.reference} has no index.html; build the target docs first")
    os.makedirs(os.path.dirname(folder), exist_ok=True)
    with tempfile.TemporaryDirectory(dir=os.path.dirname(folder)) as made:
        try:
            number = make(made, options.reference)
        except ValueError as error:
            sys.exit(f"make_site: {error}")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(made, folder)
    print(f"{number} pages, the first is {os.path.join(options.folder, 'index.html')}")


if __name__ == "__main__":
    main()
