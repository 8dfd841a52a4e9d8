#!/usr/bin/python3
"""Tests of Documentation/check_figures.py, and that the commands of the guides' tables exist."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "Documentation", "check_figures.py")
sys.path.insert(0, os.path.dirname(SCRIPT))
import check_figures  # noqa: E402 pylint: disable=wrong-import-position


def has_history():
    """Whether git names the commit of this folder, as it does not for an archive."""
    return shutil.which("git") is not None and subprocess.run(
        ["git", "log", "-1"], cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode == 0


with_history = unittest.skipUnless(has_history(), "there is no history of git")

GUIDE = """Text.

  <!-- figures: PRINTER -->
  | name | error | CPU s |
  | --- | --- | --- |
  | one | 1.02e-5 | 3.0 |
  | two | **2.0 %** | 1.0 |

| name | error | CPU s |
| --- | --- | --- |
| other | 5 | 6 |
"""
PRINTED = "| name | error | CPU s |\n|---|---|---|\n| one | 1.00e-5 | 9.0 |\n| two | {} | 1.0 |\nThe end."

GUIDE_OF_COLUMNS = """<!-- figures: PRINTER && PRINTER -->
| name | error | before |
|---|---|---|
| one | 1.00e-5 | 5 |
| two | 2.00e-5 | 6 |
| one | 1.01e-5 | 7 |
| two | 2.51e-5 | 8 |
"""


class Figures(unittest.TestCase):
    def run_script(self, printed, *words, guide=GUIDE, before=""):
        with tempfile.TemporaryDirectory() as folder:
            printer, path = os.path.join(folder, "printer.py"), os.path.join(folder, "guide.md")
            with open(printer, "w", encoding="utf-8") as file:
                file.write(before.replace("GUIDE", repr(path)) + f"\nprint({printed!r})")
            with open(path, "w", encoding="utf-8") as file:
                file.write(guide.replace("PRINTER", printer))
            result = subprocess.run([sys.executable, SCRIPT, path, *words], stdout=subprocess.PIPE,
                                    stderr=subprocess.DEVNULL, text=True, check=False)
            with open(path, encoding="utf-8") as file:
                return result.returncode, result.stdout, file.read().replace(printer, "PRINTER")

    def run_stamping(self, *words, **named):
        """As run_script, and whether the comment names the commit, which is taken away."""
        code, text, guide = self.run_script(*words, **named)
        unnamed = re.sub(r"figures at [0-9a-f]{7,}:", "figures:", guide)
        return code, unnamed, unnamed != guide

    def test_equal_numbers_and_other_times_are_accepted(self):
        self.assertEqual(self.run_script(PRINTED.format("2.1 %")), (0, "1 tables, 0 differ\n", GUIDE))

    def test_other_numbers_are_reported(self):
        code, text, guide = self.run_script(PRINTED.format("2.5 %"))
        self.assertEqual((code, guide), (1, GUIDE))
        self.assertIn("guide.md:4: two, error: **2.0 %**, but 2.5 % is printed", text)

    def test_other_texts_and_failures_are_reported(self):
        self.assertIn("but 2.0 mm is printed", self.run_script(PRINTED.format("2.0 mm"))[1])
        self.assertIn("2 rows, but 3 are printed", self.run_script(PRINTED.format("2.0 % | 1.0 |\n| three | 1"))[1])

    @with_history
    def test_tables_are_renewed(self):
        code, guide, stamped = self.run_stamping(PRINTED.format("2.5 %"), "--renew")
        self.assertEqual((code, stamped), (0, True))
        self.assertEqual(guide, GUIDE.replace("1.02e-5 | 3.0", "1.00e-5 | 9.0").replace("**2.0 %**", "2.5 %"))

    @with_history
    def test_the_commit_is_named_before_tables_that_agree(self):
        self.assertEqual(self.run_stamping(PRINTED.format("2.1 %"), "--stamp"), (0, GUIDE, True))
        self.assertEqual(self.run_stamping(PRINTED.format("2.5 %"), "--stamp"), (1, GUIDE, False))
        stamped = GUIDE.replace("figures:", "figures at 0123abcd:")
        self.assertEqual(self.run_script(PRINTED.format("2.5 %"), "--stamp", guide=stamped)[2], stamped)
        renewed = self.run_script(PRINTED.format("2.1 %"), "--stamp", guide=stamped)[2]
        self.assertEqual(renewed, self.run_script(PRINTED.format("2.1 %"), "--stamp")[2])

    def test_a_guide_that_changes_meanwhile_keeps_its_changes(self):
        edit = "text = open(GUIDE).read()\nopen(GUIDE, 'w').write('# New\\n' + text)"
        _, _, guide = self.run_script(PRINTED.format("2.5 %"), "--renew", before=edit)
        self.assertEqual(guide, "# New\n" + self.run_script(PRINTED.format("2.5 %"), "--renew")[2])

    @with_history
    def test_columns_of_several_commands_are_compared_with_those_of_the_guide(self):
        columns = "name  error  time\none  1.00e-05  3.0\nTwo lines of text.\ntwo  2.50e-05  4.0\n"
        code, text, _ = self.run_script(columns, guide=GUIDE_OF_COLUMNS)
        self.assertEqual((code, text.count("is printed")), (1, 1))
        self.assertIn("two, error: 2.00e-5, but 2.50e-05 is printed", text)
        renewed = self.run_stamping(columns, "--renew", guide=GUIDE_OF_COLUMNS)[1]
        expected = GUIDE_OF_COLUMNS.replace("2.00e-5", "2.50e-5").replace("1.01e-5", "1.00e-5")
        self.assertEqual(renewed, expected.replace("2.51e-5", "2.50e-5"))

    def test_tables_that_commands_print_one_after_the_other_are_joined(self):
        table = "| name | error |\n|---|---|\n| one | 1.00e-5 |\n| two | 2.00e-5 |"
        _, text, _ = self.run_script(table, guide=GUIDE_OF_COLUMNS)
        self.assertEqual(text.count("is printed"), 1)
        self.assertIn("two, error: 2.51e-5, but 2.00e-5 is printed", text)

    @with_history
    def test_columns_of_one_title_are_compared_in_their_order(self):
        guide = "<!-- figures: PRINTER -->\n| name | mean | largest | mean | largest |\n|---|---|---|---|---|\n" \
            "| one | 1.0 | 2.0 | 3.0 | 4.0 |\n"
        printed = "| name | mean | largest | mean | largest |\n|---|---|---|---|---|\n| one | 1.0 | 2.0 | 3.0 | {} |"
        self.assertEqual(self.run_script(printed.format("4.0"), guide=guide)[:2], (0, "1 tables, 0 differ\n"))
        self.assertIn("one, largest: 4.0, but 9.0 is printed", self.run_script(printed.format("9.0"), guide=guide)[1])
        renewed = self.run_stamping(printed.format("9.0"), "--renew", guide=guide)[1]
        self.assertEqual(renewed, guide.replace("4.0", "9.0"))

    def test_commands_of_guides_exist(self):
        folder = os.path.join(ROOT, "Documentation")
        guides = [os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".md")]
        tables = [table for guide in guides for table in check_figures.marked_tables(guide)]
        self.assertTrue(tables)
        for table in tables:
            self.assertTrue(os.path.exists(os.path.join(ROOT, table.command.split()[0])), table.command)


if __name__ == "__main__":
    unittest.main()
