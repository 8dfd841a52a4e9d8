"""The manual pages of the command: they say what --help says, and man and mandoc show them without a warning."""
import os
import re
import shutil
import subprocess
import unittest

COMMAND = os.environ["CONFORMALSOM_COMMAND"]
PAGES = os.path.join(os.path.dirname(os.path.dirname(COMMAND)), "share", "man", "man1")
SUBCOMMANDS = ("shapes", "map", "movie")


def page_of(*subcommand):
    """The file of a page."""
    return os.path.join(PAGES, "-".join(("conformalsom", *subcommand)) + ".1")


def said(*subcommand):
    """What --help prints."""
    return subprocess.run([COMMAND, *subcommand, "--help"], stdout=subprocess.PIPE, text=True, check=True,
                          env={**os.environ, "COLUMNS": "80"}).stdout


def plain(*subcommand):
    """A page without the marks of roff."""
    with open(page_of(*subcommand), encoding="ascii") as file:
        text = re.sub(r"\\f[BRI]|\\&", "", file.read()).replace("\\-", "-")
    return re.sub(r"^\.[A-Z]+ ", "", text, flags=re.MULTILINE)


def words(text):
    """Letters and digits, whatever the layout."""
    return " ".join(re.findall(r"[a-z0-9]+", text.lower()))


class TestManual(unittest.TestCase):
    def test_every_command_has_a_page(self):
        self.assertEqual(sorted(os.listdir(PAGES)),
                         sorted(os.path.basename(page_of(*names)) for names in [(), *zip(SUBCOMMANDS)]))

    def test_pages_say_what_help_says(self):
        option = re.compile(r"(?<![\w-])--[a-z][a-z-]*[a-z]")
        for names in [(), *zip(SUBCOMMANDS)]:
            with self.subTest(names):
                told, page = said(*names), plain(*names)
                self.assertEqual(set(option.findall(page)), set(option.findall(told)))
                text = words(page)
                for paragraph in re.split(r"\n\s*\n|\n  (?=\S)|\n(?= {0,4}\S)", told.partition("\n\n")[2]):
                    paragraph = re.sub(r"^ *-.*?(  |\n|$)", "", paragraph)  # the option itself
                    self.assertIn(words(paragraph.replace("positional arguments:", "").replace("options:", "")), text)

    def test_pages_have_the_version(self):
        version = subprocess.run([COMMAND, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout
        for names in [(), *zip(SUBCOMMANDS)]:
            self.assertIn('"' + version.partition(",")[0] + '"', plain(*names))

    @unittest.skipUnless(shutil.which("mandoc"), "mandoc is not installed")
    def test_mandoc_finds_nothing(self):
        for names in [(), *zip(SUBCOMMANDS)]:
            found = subprocess.run(["mandoc", "-Tlint", "-Wstyle", page_of(*names)], stdout=subprocess.PIPE, text=True,
                                   check=False).stdout
            self.assertEqual([line for line in found.splitlines() if "missing date" not in line], [])

    @unittest.skipUnless(shutil.which("man"), "man is not installed")
    def test_man_warns_of_nothing(self):
        for names in [(), *zip(SUBCOMMANDS)]:
            run = subprocess.run(["man", "--warnings", "--local-file", page_of(*names)], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True, check=False, env={**os.environ, "LC_ALL": "C.UTF-8"})
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertIn("OPTIONS", re.sub(".\b", "", run.stdout))


if __name__ == "__main__":
    unittest.main()
