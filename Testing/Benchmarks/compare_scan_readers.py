"""Compare the readers of E57 and LAS files with the packages pye57 and laspy of PyPI.

    PYTHONPATH=build/dev/python python3 Testing/Benchmarks/compare_scan_readers.py [--points N]

The packages write files with coordinates of a map. Both they and the readers read the files. The script prints the
processor time of each, also that of vtkConformalPLYReader for the same points, colors and intensities. Each is the
smallest of five runs. The script fails unless all points, colors and intensities are equal. The packages must be
installed, for example by pip in a virtual environment with the option --system-site-packages.
"""
import argparse
import os
import sys
import tempfile
import time

import laspy
import numpy as np
import pye57
from pye57 import libe57
from vtkmodules.util.numpy_support import vtk_to_numpy

import conformalsom

ORIGIN = np.array([412345.5, 5318000.25, 512.125])  # m, as UTM coordinates
SCALE = 0.001  # m


def measured(run):
    """The result of a function, and its processor time [s]."""
    times = []
    for _ in range(5):
        start = time.process_time()
        result = run()
        times.append(time.process_time() - start)
    return result, min(times)


def write_e57(path, cloud, is_scaled):
    """Write scaled integers by the functions of the library below pye57, or floats as pye57 does."""
    local, colors, intensity = cloud
    fields = {"cartesian" + axis: local[:, c] for c, axis in enumerate("XYZ")}
    fields.update({"color" + name: colors[:, c] >> 8 for c, name in enumerate(("Red", "Green", "Blue"))})
    fields["intensity"] = intensity / 65535
    rotation = np.array([0.5, 0.5, -0.5, 0.5])
    if not is_scaled:
        file = pye57.E57(path, mode="w")
        fields.update({name: values.astype(np.uint8) for name, values in fields.items() if name.startswith("color")})
        file.write_scan_raw({name: np.ascontiguousarray(values) for name, values in fields.items()},
                            rotation=rotation, translation=ORIGIN)
        file.close()
        return
    file = libe57.ImageFile(path, "w")
    file.extensionsAdd("", "http://www.astm.org/COMMIT/E57/2010-e57-v1.0")
    scans = libe57.VectorNode(file, True)
    file.root().set("data3D", scans)
    scan = libe57.StructureNode(file)
    scans.append(scan)
    pose = libe57.StructureNode(file)
    scan.set("pose", pose)
    for part, axes, values in (("rotation", "wxyz", rotation), ("translation", "xyz", ORIGIN)):
        node = libe57.StructureNode(file)
        pose.set(part, node)
        for axis, value in zip(axes, values):
            node.set(axis, libe57.FloatNode(file, float(value)))
    prototype, buffers, kept = libe57.StructureNode(file), libe57.VectorSourceDestBuffer(), []
    for name, values in fields.items():
        prototype.set(name, libe57.ScaledIntegerNode(file, 0, -200000, 200000, SCALE, 0.0) if name.startswith("cart")
                      else libe57.IntegerNode(file, 0, 0, 255) if name.startswith("color")
                      else libe57.FloatNode(file, 0.0, libe57.E57_SINGLE, 0.0, 1.0))
        kept.append(np.ascontiguousarray(values, dtype=np.float64))
        buffers.append(libe57.SourceDestBuffer(file, name, kept[-1], len(local), True, True))
    points = libe57.CompressedVectorNode(file, prototype, libe57.VectorNode(file, True))
    scan.set("points", points)
    writer = points.writer(buffers)
    writer.write(len(local))
    writer.close()
    file.close()


def write_las(path, cloud):
    local, colors, intensity = cloud
    header = laspy.LasHeader(point_format=7, version="1.4")
    header.scales, header.offsets = [SCALE] * 3, [412000, 5318000, 0]
    data = laspy.LasData(header)
    data.x, data.y, data.z = (local + ORIGIN).T
    data.red, data.green, data.blue = colors.T
    data.intensity = intensity
    data.write(path)


def read_pye57(path):
    scan = pye57.E57(path).read_scan(0, intensity=True, colors=True, transform=True, ignore_missing_fields=True)
    return (np.stack([scan["cartesian" + axis] for axis in "XYZ"], axis=1),
            np.stack([scan["color" + name] for name in ("Red", "Green", "Blue")], axis=1), scan["intensity"])


def read_laspy(path):
    data = laspy.read(path)
    return data.xyz, np.stack([data.red, data.green, data.blue], axis=1) >> 8, np.asarray(data.intensity)


def read_by(reader, path):
    reader.SetFileName(path)
    reader.Modified()
    reader.Update()
    if reader.GetErrorCode():
        sys.exit(f"{path}: not read")
    return reader.GetOutput()


def arrays_of(output):
    points = vtk_to_numpy(output.GetPoints().GetData())
    shift = output.GetFieldData().GetArray("CoordinateShift")
    shift = np.array(shift.GetTuple3(0)) if shift else np.zeros(3)
    data = output.GetPointData()
    return points, shift, vtk_to_numpy(data.GetArray("RGB")), vtk_to_numpy(data.GetArray("Intensity"))


def compare(name, path, reader, package, read_by_package, step):
    output, seconds = measured(lambda: read_by(reader, path))
    (positions, colors, intensity), other = measured(lambda: read_by_package(path))
    points, shift, own_colors, own_intensity = arrays_of(output)
    error = np.abs(points + shift - positions).max()
    if points.dtype != np.float32 or error > step or not np.array_equal(own_colors, colors) \
            or not np.array_equal(own_intensity, intensity.astype(own_intensity.dtype)):
        sys.exit(f"{name}: differs from {package} by up to {error} m")
    writer = conformalsom.vtkConformalPLYWriter()
    writer.SetInputData(output)
    writer.SetFileName(path + ".ply")
    writer.Write()
    ply = conformalsom.vtkConformalPLYReader()
    _, ply_seconds = measured(lambda: read_by(ply, path + ".ply"))
    print(f"| {name} | {os.path.getsize(path) / 2 ** 20:.1f} | {seconds:.3f} | {ply_seconds:.3f} | {other:.3f} ({package}) "
          f"| {1000 * error:.4f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=1_000_000, help="number of points")
    count = parser.parse_args().points
    dice = np.random.default_rng(1)
    cloud = (np.clip(np.round(dice.normal(size=(count, 3)) * 20 / SCALE), -200000, 200000) * SCALE,
             dice.integers(0, 65536, (count, 3)).astype(np.uint16), dice.integers(0, 65536, count).astype(np.uint16))
    print("| file | MiB | reader [s] | PLY [s] | package [s] | largest difference [mm] |\n| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scan")
        write_e57(path, cloud, True)
        compare("E57, scaled integers", path, conformalsom.vtkE57Reader(), "pye57", read_pye57, SCALE / 4)
        write_e57(path + "2", cloud, False)
        compare("E57, floats", path + "2", conformalsom.vtkE57Reader(), "pye57", read_pye57, SCALE / 4)
        write_las(path + "3", cloud)
        compare("LAS", path + "3", conformalsom.vtkConformalLASReader(), "laspy", read_laspy, SCALE / 4)


if __name__ == "__main__":
    main()
