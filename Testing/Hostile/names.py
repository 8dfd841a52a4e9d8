"""Hostile names of files for the command conformalsom: inputs of every reader against every name of an output.

    python3 names.py [--number N] [--seed S] [--whole-every K] [--check]

Each case is a folder with a scan of one of the readers, with all files that this reads, and other files; and a call that
writes surfaces, a picture or a report under a name made of one of these: another spelling, a symbolic link, a chain or a
hard link, a linked folder, another case, blanks, no-break spaces, letters with accents in two forms, the name that lies
beside an .obj file, {} and folders, dangling links, read-only files, directories, pipes, control characters. What the
checks let through is written as the command writes it, by files of one line; each K-th case runs the whole command. Bad is
an input that is changed, replaced or made, a file that is changed without --overwrite, a name that is refused as an input
and is none, and any exception but wrong usage and errors of the system. The exit status is 1 then. With --check inputs are looked for
as if every scan were a single file, and the status is 0 only if that is found to be bad.
"""
import argparse
import contextlib
import os
import random
import shutil
import stat
import subprocess
import sys
import tempfile
import unicodedata

import numpy as np
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import conformalsom
from conformalsom.command import outputs, plan, scan_files

MOTION = " 0 0 0 0 0 0 1\n"
ODD = ("a scan", "a\u00a0scan", "gr\u00fc\u00df", unicodedata.normalize("NFD", "gr\u00fc\u00df"), "-o", "{}", "a.b", "A", "'")


def scans_of(folder):
    """Files of one small closed mesh in every format, by extension, and the names of their readers."""
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(12)
    sphere.SetPhiResolution(9)
    sphere.Update()
    for extension, writer in ((".ply", conformalsom.vtkConformalPLYWriter()), (".off", conformalsom.vtkConformalOFFWriter()),
                              (".m", conformalsom.vtkGuMeshWriter()), (".surf.gii", conformalsom.vtkGIFTIWriter()),
                              (".white", conformalsom.vtkFreeSurferWriter()), (".obj", vtkOBJWriter()),
                              (".stl", vtkSTLWriter()), (".vtp", vtkXMLPolyDataWriter()), (".vtk", vtkPolyDataWriter())):
        writer.SetInputConnection(sphere.GetOutputPort())
        writer.SetFileName(os.path.join(folder, "scan" + extension))
        writer.Write()
    points = np.random.RandomState(1).standard_normal((100, 3))
    lines = [" ".join(f"{number:.4f}" for number in point) for point in points]
    for extension, text in ((".xyz", lines), (".csv", ["x,y,z"] + [line.replace(" ", ",") for line in lines]),
                            (".pts", ["100"] + lines),
                            (".pcd", ["VERSION 0.7", "FIELDS x y z", "SIZE 4 4 4", "TYPE F F F", "COUNT 1 1 1", "WIDTH 100",
                                      "HEIGHT 1", "POINTS 100", "DATA ascii"] + lines)):
        with open(os.path.join(folder, "scan" + extension), "w", encoding="ascii") as file:
            file.write("\n".join(text) + "\n")
    return sorted(name[4:] for name in os.listdir(folder))


class Case:
    """A folder, a call, and which files the call reads."""

    def __init__(self, dice, samples, extensions):
        self.dice, self.samples = dice, samples
        self.inputs = []  # names of files that are read, or would be if they were there
        os.mkdir("sub")
        self.scan = self.made_scan(extensions)
        self.texture = "picture.png" if dice.random() < 0.5 else None
        for name in ("picture.png", "other.txt", "other.ply", "sub/other.glb"):
            self.put(name, "old " + name)
        if self.texture:
            self.inputs.append(self.texture)

    @staticmethod
    def put(name, text):
        """Write a text."""
        with open(name, "w", encoding="utf-8") as file:
            file.write(text)

    def made_scan(self, extensions):
        """Make a scan for one of the readers; its name."""
        dice, stem = self.dice, self.dice.choice(("scan",) + ODD)
        kind = dice.choice(extensions + [".conf"] * 5 + ["_surf.vtk"] * 3)
        if kind == ".conf":
            name = stem + dice.choice((".conf", ".txt", ".list", ".ply", ""))
            parts = [dice.choice(("c", "sub/d", "gr\u00fc\u00df", "a\u00a0b", "missing")) + f"{i}.ply" for i in range(3)]
            for part in parts:
                if not part.startswith("missing") or part == parts[0]:
                    shutil.copy(os.path.join(self.samples, "scan.ply"), part)
            blank = dice.choice((" ", "\t", "  ", "\v"))
            self.put(name, "camera" + MOTION + "".join(
                dice.choice(("mesh", "bmesh")) + blank + part + MOTION for part in parts))
            self.inputs += [name, *parts]
            return name
        if kind == "_surf.vtk":
            for end in "_surf.vtk", "_para.vtk":
                shutil.copy(os.path.join(self.samples, "scan.vtk"), stem + end)
                self.inputs.append(stem + end)
            return stem + kind
        name = stem + kind
        shutil.copy(os.path.join(self.samples, "scan" + kind), name)
        if kind == ".vtk" and os.path.exists(stem + "_para.vtk"):
            raise AssertionError("a scan of another reader")
        self.inputs.append(name)
        return name

    def output(self):
        """A name to write to."""
        dice = self.dice
        near = [*self.inputs, *self.inputs, "picture.png", "other.txt", "other.ply", "new.glb", "sub/other.glb"]
        name = dice.choice(near)
        folder, base = os.path.split(name)
        kind = dice.randrange(17)
        if kind == 0:
            return os.path.join(".", folder, ".", base)
        if kind == 1:
            return os.path.join("sub", "..", name)
        if kind == 2:
            return os.path.abspath(name).replace("/", "//")
        if kind in (3, 4):
            link = "link" + os.path.splitext(base)[1]
            os.symlink(name if kind == 3 else os.path.abspath(name), link)
            if dice.random() < 0.3:
                os.symlink(link, "chain" + os.path.splitext(base)[1])
                return "chain" + os.path.splitext(base)[1]
            return link
        if kind == 5 and os.path.exists(name):
            os.link(name, "sub/hard" + os.path.splitext(base)[1])
            return "sub/hard" + os.path.splitext(base)[1]
        if kind == 6:
            os.symlink(folder or ".", "linked")
            return os.path.join("linked", base)
        if kind == 7:
            return os.path.join(folder, dice.choice((base.upper(), base.lower(), base.swapcase())))
        if kind == 8:
            form = dice.choice(("NFC", "NFD", "NFKC"))
            return unicodedata.normalize(form, name)
        if kind == 9:
            return os.path.splitext(name)[0] + dice.choice((".obj", ".ply", ".png", ".mtl", ".vtk", ".jpg"))
        if kind == 10:
            return dice.choice(("{}", "sub/../{}", "./{}", "{}_para")) + dice.choice(
                (os.path.splitext(name)[1], ".vtk", ".ply", ".obj"))
        if kind == 11:
            return dice.choice(("sub", "sub/", ".", "./", "new folder/", "sub/{}/x.glb"))
        if kind == 12:
            os.symlink(dice.choice(("nowhere/x.glb", "new.vtp", "loop.glb")), "loop.glb")
            return "loop.glb"
        if kind == 13:
            return name + dice.choice((" ", "\n", "\u00a0", "\t", "\x7f", "/", "/.", "\u202e")) + dice.choice(("", ".glb"))
        if kind == 14:
            os.mkfifo("pipe.vtp")
            os.mkdir("folder.vtp")
            return dice.choice(("pipe.vtp", "folder.vtp", "/dev/null", "pipe.vtp/x.vtp"))
        if kind == 15 and os.path.exists(name):
            os.chmod(name, dice.choice((0o444, 0o000, 0o640)))
        return name

    def call(self):
        """Options of the command for it, as argparse gives them."""
        options = argparse.Namespace(
            scans=[self.scan], output=[], picture=None, report=None, texture=self.texture,
            folder_type=".glb", overwrite=self.dice.random() < 0.8)
        for _ in range(self.dice.choice((1, 1, 2))):
            try:
                name = self.output()
            except FileExistsError:  # a second link of one name
                continue
            extension = outputs.extension_of(name)
            if extension in outputs.PICTURES and self.dice.random() < 0.7:
                options.picture = name
            elif name.endswith(("/", ".")) or (extension in outputs.SURFACES and self.dice.random() < 0.8):
                options.output.append(name)
            else:
                options.report = name
        return options


def state_of(path):
    """What must not change of a file: its place, mode, time and content, if it may be read; nothing if there is none."""
    try:
        status = os.stat(path)
    except OSError:
        return None
    content = b""
    if stat.S_ISREG(status.st_mode):
        with contextlib.suppress(PermissionError), open(path, "rb") as file:
            content = file.read()
    return status.st_ino, status.st_mode, status.st_mtime_ns, content


def everything():
    """The states of all files."""
    return {os.path.join(folder, name): state_of(os.path.join(folder, name))
            for folder, _, names in os.walk(".") for name in names}


def is_input(path, inputs):
    """Whether a file is one of the inputs, found out in another way than the command does."""
    for name in inputs:
        if os.path.realpath(path) == os.path.realpath(name):
            return True
        if os.path.exists(path) and os.path.exists(name) and os.path.samefile(path, name):
            return True
    return False


def do(options):
    """Check the call, and write what it may write, by a line each; what was refused."""
    try:
        [paths] = plan.paths_of(options)
    except plan.WrongUsage as error:
        return str(error)
    token = outputs.new_token()
    for path in paths.all():
        try:
            with outputs.whole(path, token, overwrite=options.overwrite) as part:
                names = {os.path.basename(file): file for file in outputs.files_of(path)}
                for name in names:
                    Case.put(os.path.join(os.path.dirname(part), name), "new")
        except OSError as error:
            return f"failed: {error.strerror}"
    if options.report:
        with outputs.whole(options.report, token, [options.report], options.overwrite) as part:
            Case.put(part, "new")
    return ""


def run_whole(options):
    """The same by the command itself."""
    words = [word for name in options.output for word in ("--output=" + name,)]
    words += ["--" + key + "=" + getattr(options, key) for key in ("picture", "report", "texture") if getattr(options, key)]
    words += ["--overwrite"] if options.overwrite else []
    run = subprocess.run([sys.executable, "-m", "conformalsom", "--neurons=42", "--points=42", *words, "--", *options.scans],
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, check=False)
    text = run.stderr.decode(errors="replace")
    if "Traceback" in text or run.returncode not in (0, 1, 2):
        raise RuntimeError(f"status {run.returncode}: {text}")
    return text.partition(": error: ")[2].strip() if run.returncode == 2 else ""


def faults_of(case, whole):
    """Run a case; a word for its outcome, and what is bad about it."""
    options = case.call()
    before = everything()
    inputs = {name: state_of(name) for name in case.inputs}
    if not (options.output or options.picture or options.report):
        return "nothing to write", []
    try:
        refused = (run_whole if whole else do)(options)
    except Exception as error:  # whatever it is, it should not be
        return "exception", [f"{vars(options)}: {error!r}"]
    faults = [f"{vars(options)}: the input {name!r} was changed" for name, state in inputs.items()
              if state_of(name) != state]
    if not options.overwrite or refused and not refused.startswith("failed"):
        faults += [f"{vars(options)}: {name!r} was changed" for name, state in before.items()
                   if state and state_of(name) != state]  # nothing is behind a dangling link
    if refused.endswith(" is an input and would be replaced"):
        name = refused[:-len(" is an input and would be replaced")]
        if not whole and not is_input(name, case.inputs):
            faults.append(f"{vars(options)}: {refused}, but it is none")
        return "refused as an input", faults
    left = [name for name in everything() if outputs.PREFIX in name]
    faults += [f"{vars(options)}: {name!r} is left" for name in left]
    return "refused" if refused else "written", faults


def main():
    """Try all, print a table, and return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--number", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--whole-every", type=int, default=200)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.check:
        scan_files.inputs_of = lambda path: [path]
    counts, bad = {}, 0
    with tempfile.TemporaryDirectory() as samples, tempfile.TemporaryDirectory(prefix="names ") as around:
        extensions = scans_of(samples)
        for number in range(options.seed, options.seed + options.number):
            folder = os.path.join(around, str(number))
            os.mkdir(folder)
            os.chdir(folder)
            word, faults = faults_of(Case(random.Random(number), samples, extensions), number % options.whole_every == 0)
            os.chdir(around)
            shutil.rmtree(folder)
            counts[word] = counts.get(word, 0) + 1
            bad += bool(faults)
            for text in faults:
                print(f"case {number}: {text}", flush=True)
        os.chdir(samples)
    for word, count in sorted(counts.items()):
        print(f"{count:8} {word}")
    print(f"{bad:8} bad")
    few = options.number >= 100 and min(counts.get(word, 0) for word in ("refused as an input", "refused", "written")) < 10
    if few:
        print("too few of one kind for a trial")
    return int(bad == 0) if options.check else int(bad > 0 or few)


if __name__ == "__main__":
    sys.exit(main())
