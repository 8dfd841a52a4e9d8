"""draw_guide.py FOLDER [SCAN]: draw the pictures of Documentation/ParaView.md into a folder.

A ParaView of its own is started for each of them and led through its menus to where the picture is
taken. Without SCAN the built-in bear is opened.
"""
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGWriter

import scenes

FOLDER = os.path.dirname(os.path.abspath(__file__))
EVENTS = ("one_click.xml", "guide.xml")
DISPLAY, WINDOW = ":87", (1152, 762)  # the size that ParaView's window has at first
PATIENCE = 300  # seconds until a ParaView must have got there


def events_before_each_picture():
    """The name of every picture and the events that lead to it."""
    for name in EVENTS:
        with open(os.path.join(FOLDER, name), encoding="ascii") as file:
            parts = file.read().split("<!-- picture: ")
        for i, part in enumerate(parts[1:], 1):
            yield part.partition(" ")[0], "<!-- ".join(parts[:i]) + "</pqevents>\n"


def screen(path):
    """The whole display, which Xvfb keeps in a file of xwd's format."""
    with open(path, "rb") as file:
        content = file.read()
    header = struct.unpack(">25I", content[:100])
    start, width, height, row, colors = (header[i] for i in (0, 4, 5, 12, 19))
    pixels = np.frombuffer(content, np.uint8, count=row * height, offset=start + 12 * colors)
    return pixels.reshape(height, row // 4, 4)[::-1, :width, 2::-1]


def write_jpeg(pixels, path):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
    writer = vtkJPEGWriter()
    writer.SetQuality(90)
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def draw(events, path, data, framebuffer):
    """Start a ParaView, wait for the end of the events, and save what is on the display."""
    script = os.path.join(data, "events.xml")
    with open(script, "w", encoding="ascii") as file:
        file.write(events)
    environment = dict(os.environ, DISPLAY=DISPLAY, HOME=data, XDG_RUNTIME_DIR=data,
                       PARAVIEW_DATA_ROOT=data, PARAVIEW_TEST_DIR=data)
    log_path = os.path.join(data, "log")
    with open(log_path, "w", encoding="utf-8") as log:
        paraview = subprocess.Popen(["paraview", "--disable-registry", "--test-script=" + script],
                                    env=environment, stdout=log, stderr=subprocess.STDOUT)
        start, still, last, said = time.monotonic(), 0, None, ""
        # Seconds without a change; a dialog keeps the events from ending.
        while still < (3 if "is finished" in said else 20):
            time.sleep(1)
            now = screen(framebuffer)
            still = still + 1 if last is not None and (now == last).all() else 0
            last = now
            with open(log_path, encoding="utf-8") as written:
                said = written.read()
            if (paraview.poll() is not None or "critical" in said
                    or time.monotonic() - start > PATIENCE):
                raise RuntimeError("ParaView does not get there:\n" + said)
        write_jpeg(last, path)
        paraview.terminate()
        paraview.wait()


def main(folder, scan=""):
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="scans-") as data:
        scenes.write_picture(data)
        scenes.write_scan(data, 60000, colored=True)
        name = "bear.ply"
        if scan:
            name = os.path.basename(scan)
            shutil.copy(scan, data)
        else:
            scenes.write_scan(data, 60000)
        server = subprocess.Popen(
            ["Xvfb", DISPLAY, "-screen", "0", f"{WINDOW[0]}x{WINDOW[1]}x24", "-fbdir", data])
        try:
            for picture, events in events_before_each_picture():
                draw(events.replace("bear.ply", name), os.path.join(folder, picture + ".jpg"), data,
                     os.path.join(data, "Xvfb_screen0"))
        finally:
            server.terminate()
            server.wait()


if __name__ == "__main__":
    main(*sys.argv[1:])
