"""Pictures to paint with, from files."""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import typing

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

CLAY = (204, 158, 117)
EXTENSIONS = (".png", ".jpg", ".jpeg")
MAXIMUM_PIXELS = 2**28  # as decoding.py has it
MAXIMUM_SECONDS = 300  # of the clock; decoding.py limits its processor time to less
DECODER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "decoding.py")
# A program's own name is not among the modules then, and the modules are those of this process.
START = "import runpy, sys; sys.path[:] = sys.argv[3:]; runpy.run_path(sys.argv.pop(1), run_name='__main__')"


def interpreter():
    """The Python to start other processes by; sys.executable may be a program that Python is a part of."""
    own = sys.executable or ""
    if re.match(r"(python|pypy)[0-9.]*(\.exe)?$", os.path.basename(own)):
        return own
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    beside = os.path.join(sys.base_exec_prefix, "bin", version)
    found = beside if os.access(beside, os.X_OK) else shutil.which(version) or shutil.which("python3")
    if found is None:
        raise ValueError(f"pictures are decoded in a process of its own, but there is no {version} to start for it: "
                         "add the folder of one to PATH")
    return found


def read_picture(path):
    """Decode a PNG or JPEG file in a process of its own: an array of rows x columns x 3 or 4 bytes, lowest row first.

    Raises ValueError for a file that is none, is broken, or has more than 2^28 pixels.
    """
    if not os.path.isfile(path):
        raise ValueError(f"{path}: not a file" if os.path.exists(path) else f"{path}: no such file")
    if os.path.splitext(path)[1].lower() not in EXTENSIONS:
        raise ValueError(f"{path}: expected a file of type {' '.join(EXTENSIONS)}")
    with open(path, "rb"):  # or an error that names the reason
        pass
    try:
        return decoded(path)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None


def decoded(path):
    """The pixels that decoding.py puts out; raises ValueError with what is wrong."""
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "PYTHONDONTWRITEBYTECODE": "1"}
    command = [interpreter(), "-c", START, DECODER, os.path.abspath(path), *sys.path]
    with tempfile.TemporaryFile() as log:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=log,
                                   env=environment)
        pixels_pipe = typing.cast(typing.BinaryIO, process.stdout)
        watch = threading.Timer(MAXIMUM_SECONDS, process.kill)
        watch.daemon = True
        watch.start()
        try:
            told, pixels = received(pixels_pipe)
            process.wait()
        finally:
            process.kill()
            pixels_pipe.close()
            process.wait()
            watch.cancel()
            watch.join()  # no thread is left
        log.seek(0)
        lines = log.read().decode(errors="replace").splitlines()
    said = [line.strip() for line in lines if line.startswith(("libpng error", "Python error", "libjpeg error"))]
    if "error" in told:
        raise ValueError(told["error"])
    if process.returncode > 0 and not said and not told:
        last = [line.strip() for line in lines if line.strip()][-1:]
        raise ValueError(f"the process that decodes pictures ended with status {process.returncode}"
                         + "".join(f": {line}" for line in last))
    if process.returncode or said or pixels is None:
        raise ValueError("the picture is broken" + reason(process.returncode, said))
    return pixels


def reason(status, said):
    """What is known about the end of a process that did not decode its picture."""
    if said:
        return ": " + said[-1].partition(": ")[2]
    if status in (-getattr(signal, "SIGXCPU", 0), -getattr(signal, "SIGKILL", 0)) and status:
        return " or too large: decoding it took more time than its number of pixels allows"
    return f": decoding it crashed by {name_of(-status)}" if status < 0 else ""


def name_of(number):
    """A signal by its number and name."""
    try:
        return f"signal {number} ({signal.Signals(number).name})"
    except ValueError:
        return f"signal {number}"


def received(stream):
    """What decoding.py puts out: its line, and the pixels if they are all there; else {} or None."""
    line = stream.readline(2**16)
    if not line.endswith(b"\n"):
        return {}, None
    told = json.loads(line)
    if "error" in told:
        return told, None
    pixels = np.empty((told["rows"], told["columns"], told["channels"]), np.uint8)
    place, bytes_of = 0, pixels.data.cast("B")
    while place < len(bytes_of):
        count = stream.readinto(bytes_of[place:])
        if not count:
            return told, None
        place += count
    return told, pixels


def image_of(pixels):
    """An array of rows x columns x channels, lowest row first, as VTK's image."""
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, pixels.shape[2]), deep=True))
    return image


def one_pixel():
    """A picture of one pixel, as VTK's image."""
    return image_of(np.array([[CLAY]], np.uint8))
