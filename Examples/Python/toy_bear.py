#!/usr/bin/python3
"""Writes a scan to try things with, a toy bear made by code, and a picture to paint it with.

FOLDER gets bear.vtp, 60,000 points as a scanner sees them, and rosette.png.
"""
import argparse
import os

from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from helpers import builtin_figure, textures


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="FOLDER", help="is made if it is missing")
    folder = parser.parse_args().folder
    os.makedirs(folder, exist_ok=True)
    for writer, data, name in ((vtkXMLPolyDataWriter(), builtin_figure.figure_cloud(), "bear.vtp"),
                               (vtkPNGWriter(), textures.rosette(), "rosette.png")):
        writer.SetInputData(data)
        writer.SetFileName(os.path.join(folder, name))
        writer.Write()


if __name__ == "__main__":
    main()
