"""Scans in processes of their own: one that crashes ends no other, and results do not depend on their number."""
import errno
import json
import os
import pty
import signal
import subprocess
import tempfile
import time
import unittest
from unittest import mock

import conformalsom
from conformalsom.command import jobs, main, outputs, surfaces
from test_command import COARSE, COMMAND, command, egg, files_in, read_terminal, write

LONG = ("--neurons", "40000")  # which learns until it is stopped


def children_of(process):
    """Ids of a process's children, as Linux lists them."""
    with open(f"/proc/{process.pid}/task/{process.pid}/children", encoding="ascii") as file:
        return [int(word) for word in file.read().split()]


class Scans(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="scans of ")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name
        for name in "a", "b", "c":
            write(conformalsom.vtkConformalPLYWriter(), egg(), self.folder, name + ".ply")

    def entries(self, name="r.json"):
        with open(os.path.join(self.folder, name), encoding="utf-8") as file:
            return json.load(file)["Surfaces"]

    def run_here(self, make_surface, *arguments):
        """The command in this process, whose forked processes make surfaces by another function; its status."""
        before, handlers = os.getcwd(), {number: signal.getsignal(number) for number in jobs.SIGNALS}
        os.chdir(self.folder)
        try:
            with mock.patch.object(surfaces, "make_surface", make_surface):
                return main.main(["a.ply", "b.ply", "c.ply", *COARSE, "--report", "r.json", *arguments])
        finally:
            os.chdir(before)
            for number, handler in handlers.items():
                signal.signal(number, handler)


@unittest.skipUnless(jobs.CONTEXT.get_start_method() == "fork", "processes start anew here")
class TestCrashes(Scans):
    def test_scan_that_crashes_ends_no_other(self):
        make_surface = surfaces.make_surface

        def crash(task, *others):
            if task.scan == "b.ply":
                with outputs.whole(task.paths.surfaces[0], task.token) as part:
                    with open(part, "wb") as file:
                        file.write(b"half")
                    os.write(2, b"what(): out of ideas\n")
                    os.abort()
            return make_surface(task, *others)
        for number in "1", "3":
            with self.subTest(number):
                self.assertEqual(self.run_here(crash, "-o", "out/", "--jobs", number, "--overwrite"), 1)
                good, bad, other = self.entries()
                self.assertEqual((good["Files"], other["Files"]), (["out/a.glb"], ["out/c.glb"]))
                self.assertEqual(bad, {"Scan": "b.ply", "Error": "b.ply: Start: the process crashed by signal 6 "
                                       "(SIGABRT): what(): out of ideas"})
                self.assertEqual(sorted(os.listdir(os.path.join(self.folder, "out"))), ["a.glb", "c.glb"])

    def test_every_way_to_end(self):
        def leave(status):
            os._exit(status)

        def fail(error):
            raise error
        for work, message in ((lambda: leave(0), "b.ply: Start: the process ended with status 0"),
                              (lambda: leave(3), "b.ply: Start: the process ended with status 3"),
                              (lambda: fail(KeyError("color")), "the process ended with status 1: KeyError: 'color'"),
                              (lambda: fail(MemoryError()), "b.ply: there is not enough memory"),
                              (lambda: fail(OSError(errno.ENOSPC, "No space left on device")), "No space left on device"),
                              (lambda: os.kill(os.getpid(), signal.SIGKILL), "crashed by signal 9 (SIGKILL)"),
                              (lambda: os.kill(os.getpid(), signal.SIGTERM), "crashed by signal 15 (SIGTERM)")):
            def make_surface(task, _, __, steps, work=work):
                if task.scan == "b.ply":
                    work()
                return {"Scan": task.scan, "Seconds": {}, "Surface": {"NumberOfPoints": 1}}, ()
            with self.subTest(message):
                self.assertEqual(self.run_here(make_surface, "--overwrite"), 1)
                first, bad, last = self.entries()
                self.assertIn(message, bad["Error"])
                self.assertEqual((first["Scan"], last["Scan"]), ("a.ply", "c.ply"))


class TestJobs(Scans):
    def test_results_are_the_same_for_any_number(self):
        made = {}
        for number in "1", "2", "5":
            run = command(self.folder, "a.ply", "missing.ply", "b.ply", "c.ply", *COARSE, "-o", f"of {number}/", "-o",
                          f"of {number}/{{}}.vtp", "--report", f"of {number}/r.json", "--jobs", number, "--measure")
            self.assertEqual((run.returncode, run.stderr), (1, "conformalsom: missing.ply: no such file\n"))
            files = files_in(os.path.join(self.folder, "of " + number))
            entries = json.loads(files.pop("r.json"))["Surfaces"]
            self.assertEqual([entry["Scan"] for entry in entries], ["a.ply", "missing.ply", "b.ply", "c.ply"])
            for entry in entries:
                entry.pop("Seconds", None)
                entry.pop("Files", None)
            lines = [line for line in run.stdout.splitlines() if line.startswith(("learned", "smooth"))]
            made[number] = files, entries, lines
        self.assertEqual(len(made["1"][0]), 6)
        self.assertEqual(len(made["1"][2]), 6)
        self.assertTrue(made["1"] == made["2"] == made["5"])

    def test_number_must_be_one(self):
        for wrong in "0", "-1", "two":
            run = command(self.folder, "a.ply", "-o", "x.glb", "--jobs", wrong)
            self.assertEqual(run.returncode, 2)

    def test_signals_stop_all_scans_and_leave_nothing(self):
        for number in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
            terminal, end = pty.openpty()
            with self.subTest(number):
                before = files_in(self.folder)
                process = subprocess.Popen(
                    [COMMAND, "a.ply", "b.ply", "c.ply", "-o", "{}.vtp", "--jobs", "2", *LONG], cwd=self.folder,
                    stderr=end, env={**os.environ, "TERM": "xterm"},
                    preexec_fn=lambda: [signal.signal(each, signal.SIG_DFL) for each in jobs.SIGNALS])
                os.close(end)
                shown = b""
                while b"Learn the mesh" not in shown:
                    shown += os.read(terminal, 4096)
                children = children_of(process) if os.path.exists("/proc/self/task") else []
                process.send_signal(number)
                while read_terminal(terminal):
                    pass
                self.assertEqual(process.wait(), -number)
                self.assertEqual(files_in(self.folder), before)
                for child in children:
                    with self.assertRaises(ProcessLookupError):
                        os.kill(child, 0)
            os.close(terminal)

    def test_hangup_that_is_ignored_stops_nothing(self):
        process = subprocess.Popen([COMMAND, "a.ply", "-o", "x.glb", "--neurons", "642"], cwd=self.folder,
                                   preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        while process.poll() is None:
            process.send_signal(signal.SIGHUP)
            time.sleep(0.01)
        self.assertEqual(process.returncode, 0)

    @unittest.skipUnless(os.path.exists("/proc/self/task"), "processes are not listed here")
    def test_scan_whose_process_is_killed(self):
        terminal, end = pty.openpty()
        process = subprocess.Popen([COMMAND, "a.ply", "-o", "x.vtp", "--report", "r.json", *LONG], cwd=self.folder,
                                   stderr=end, env={**os.environ, "TERM": "xterm"})
        os.close(end)
        shown = b""
        while b"Learn the mesh" not in shown:
            shown += os.read(terminal, 4096)
        [child] = children_of(process)
        os.kill(child, signal.SIGKILL)
        while read_terminal(terminal):
            pass
        os.close(terminal)
        self.assertEqual(process.wait(), 1)
        self.assertEqual(self.entries()[0]["Error"],
                         "a.ply: Learn the mesh: the process crashed by signal 9 (SIGKILL)")
        self.assertNotIn("x.vtp", os.listdir(self.folder))


if __name__ == "__main__":
    unittest.main()
