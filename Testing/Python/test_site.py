"""The web site: all pages are made, dead links are errors, and pages fit phones. Skipped without python3-markdown."""
import os
import subprocess
import sys
import tempfile
import unittest

from browser import CHROMIUM, Browser

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "Documentation"))
try:
    import make_site
except ImportError:
    make_site = None


@unittest.skipUnless(make_site, "python3-markdown is not installed")
class TestSite(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="site f\u00fcr ")
        cls.folder = os.path.join(cls.temporary.name, "site")
        run = subprocess.run([sys.executable, make_site.__file__, cls.folder], capture_output=True, text=True)
        assert run.returncode == 0, run.stderr

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def text(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8") as file:
            return file.read()

    def test_every_guide_is_a_page(self):
        for folder in ("", "Documentation", "Examples"):
            for name in os.listdir(os.path.join(ROOT, folder)):
                if name.endswith(".md"):
                    self.assertIn(os.path.join(folder, name), make_site.PAGES)
        self.assertEqual(len(set(make_site.PAGES.values())), len(make_site.PAGES))
        for page in make_site.PAGES.values():
            self.assertIn('href="index.html"', self.text(page))

    def test_pictures_are_clickable_and_nothing_is_loaded_from_elsewhere(self):
        for page in ("index.html", "HowItWorks.html"):
            text = self.text(page)
            self.assertGreater(text.count("<img"), 3)
            self.assertNotRegex(text, r'(src|rel="stylesheet" href)="https?:')
        self.assertEqual(self.text("HowItWorks.html").count("<img"),
                         len([part for part in self.text("HowItWorks.html").split("<img")[:-1]
                              if part.rstrip().endswith(">") and '<a href="files/' in part[-200:]]))

    def test_dead_links_are_errors(self):
        site = make_site.Site(self.folder)
        with self.assertRaisesRegex(ValueError, "README.md: no file nowhere.md"):
            site.linked("README.md", "href", "nowhere.md")
        site.write("broken.html", "Broken", '<a href="index.html#nowhere">a</a> <a href="gone.html">b</a>')
        self.assertEqual(list(site.faults()), ["broken.html: no place index.html#nowhere",
                                               "broken.html: no file gone.html"])
        os.unlink(os.path.join(self.folder, "broken.html"))
        self.assertEqual(list(site.faults()), [])

    def test_replaces_no_other_folder(self):
        run = subprocess.run([sys.executable, make_site.__file__, self.temporary.name], capture_output=True, text=True)
        self.assertEqual(run.returncode, 2)
        self.assertIn("has files that are not of a site", run.stderr)

    @unittest.skipUnless(CHROMIUM, "chromium is not installed")
    def test_pages_fit_their_screens(self):
        with Browser() as browser:
            for width in (390, 820, 1280):
                browser.resize(width, 900)
                for page in ("index.html", "Command.html", "Filters.html"):
                    browser.open(os.path.join(self.folder, page))
                    self.assertLessEqual(browser.evaluate("document.documentElement.scrollWidth"), width, page)
                browser.evaluate("document.getElementById('menu').open = true")
                left, right = browser.evaluate(
                    "(({left, right}) => [left, right])(document.querySelector('nav').getBoundingClientRect())")
                self.assertGreaterEqual(left, 0)
                self.assertLessEqual(right, width)
            self.assertEqual(browser.messages, [])
            self.assertEqual([url for url in browser.requests if not url.startswith("file:")], [])


if __name__ == "__main__":
    unittest.main()
