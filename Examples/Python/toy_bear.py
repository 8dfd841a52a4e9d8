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
    parser.add_argument("--overwrite", action="store_true", help="replace both files if they exist")
    args = parser.parse_args()
    scan, picture = (os.path.join(args.folder, name) for name in ("bear.vtp", "rosette.png"))
    for path in (scan, picture):
        if os.path.lexists(path) and not args.overwrite:
            parser.error(f"{path} already exists; use --overwrite or another folder")
    os.makedirs(args.folder, exist_ok=True)
    for writer, data, path in ((vtkXMLPolyDataWriter(), builtin_figure.figure_cloud(), scan),
                               (vtkPNGWriter(), textures.rosette(), picture)):
        writer.SetInputData(data)
        writer.SetFileName(path)
        writer.Write()


if __name__ == "__main__":
    main()
