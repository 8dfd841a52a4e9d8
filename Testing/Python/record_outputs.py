#!/usr/bin/python3
"""Record checksums of everything that the classes of the package write, to find what a change changes.

    PYTHONPATH=build/dev/python /usr/bin/python3 Testing/Python/record_outputs.py --output before.txt
    PYTHONPATH=build/dev/python /usr/bin/python3 Testing/Python/record_outputs.py --compare before.txt

Print a line `NAME CHECKSUM` (16 hexadecimal digits of SHA-256) for each part of each output of each run in
output_cases.py:

    vtkConformalSOM/default/port0/points                      coordinates
    vtkConformalSOM/default/port0/cells                       connectivity and offsets of all kinds of cells
    vtkConformalSOM/default/port0/point data/SpherePosition   type, components and values of an array
    vtkConformalSOM/default/port0/point data                  checksums of its arrays, in their order
    vtkConformalSOM/default/warnings                          number of warnings
    vtkTexturedSurfaceWriter/surface.obj/surface.mtl          bytes of a file

A run `default` has the defaults of all properties but those that a class does not work without. Nothing is
left out: no array and no file of the package holds a date, a duration, or a version of the package. Checksums
depend on the compiler, on libm, on NumPy, on VTK and on the libraries that compress (zlib in .gii, .png and
.html, JPEG in .html), so compare records of one machine only.

With --mpi, the classes that process points of all ranks: vtkConformalSOM and vtkGenusZeroHull. Rank 0 prints.
Rows must equal those of one process; only runs with DistributeOutput have rows for each rank instead:

    mpiexec -n 3 /usr/bin/python3 Testing/Python/record_outputs.py --mpi --output ranks3.txt
    mpiexec -n 1 /usr/bin/python3 Testing/Python/record_outputs.py --mpi --compare ranks3.txt \\
      --classes '^(?!.*DistributeOutput)'

With --renames, a file of names that were changed, in lines `old -> new`. The old name is a whole word of the names
of rows, or several: `Lattice -> MeshType`, or `vtkSurfaceMismatch/small/port0 -> vtkSurfaceMismatch/small/port1`.
Bytes of files and texts in arrays that hold a name differ all the same.

Exit status: 0; 1 if a row differs, is missing or new; 2 if a class has no case or a case fails.
"""
import argparse
import hashlib
import re
import sys
import tempfile

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject, vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkTable)
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import output_cases

FAILED = 2
PIECE_TAG = 3141


def checksum(*parts):
    """Of bytes, or of what can be printed; where one part ends counts."""
    digest = hashlib.sha256()
    for part in parts:
        part = part if isinstance(part, bytes) else repr(part).encode()
        digest.update(str(len(part)).encode() + b":" + part)
    return digest.hexdigest()[:16]


def array_parts(array):
    """Type, size and values of an array, without its name."""
    if array is None:
        return ("none",)
    size = (array.GetDataTypeAsString(), array.GetNumberOfComponents(), array.GetNumberOfTuples())
    components = [array.GetComponentName(i) for i in range(array.GetNumberOfComponents())]
    if isinstance(array, vtkStringArray):
        return (*size, components, [array.GetValue(i) for i in range(array.GetNumberOfValues())])
    return (*size, components, vtk_to_numpy(array).tobytes())


def attribute_names(data, index):
    """What an array is besides: scalars, normals, texture coordinates ..."""
    if not isinstance(data, vtkDataSetAttributes):
        return []
    array = data.GetAbstractArray(index)
    return [vtkDataSetAttributes.GetAttributeTypeAsString(kind)
            for kind in range(vtkDataSetAttributes.NUM_ATTRIBUTES)
            if data.GetAbstractAttribute(kind) is not None and array is data.GetAbstractAttribute(kind)]


def rows_of_arrays(name, data):
    """A row for each array, and one for all in their order."""
    found, all_sums = {}, []
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        row = f"{name}/{array.GetName() or '(no name)'}"
        while row in found:
            row += "'"
        found[row] = checksum(*array_parts(array), attribute_names(data, i))
        all_sums.append(found[row])
    yield name, checksum(all_sums)
    yield from found.items()


def rows_of_data(name, data):
    """Rows of a data object, of any type that the package writes."""
    if data is None:
        raise TypeError(f"{name} has no data object")
    yield f"{name}/type", checksum(data.GetClassName(), time_step(data))
    if isinstance(data, vtkMultiBlockDataSet):
        blocks = [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())]
        names = [data.HasMetaData(i) and data.GetMetaData(i).Get(vtkMultiBlockDataSet.NAME())
                 for i in range(len(blocks))]
        yield f"{name}/blocks", checksum([block is not None for block in blocks], names)
        for i, block in enumerate(blocks):
            if block is not None:
                yield from rows_of_data(f"{name}/block{i}", block)
    elif isinstance(data, vtkPolyData):
        yield f"{name}/points", checksum(*array_parts(data.GetPoints() and data.GetPoints().GetData()))
        yield f"{name}/cells", checksum(*(
            part for cells in (data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips())
            for array in (cells.GetOffsetsArray(), cells.GetConnectivityArray()) for part in array_parts(array)))
    elif isinstance(data, vtkImageData):
        directions = data.GetDirectionMatrix()
        yield f"{name}/pixels", checksum(
            data.GetExtent(), data.GetOrigin(), data.GetSpacing(),
            [directions.GetElement(i, j) for i in range(3) for j in range(3)])
    elif isinstance(data, vtkTable):
        yield from rows_of_arrays(f"{name}/columns", data.GetRowData())
    else:
        raise TypeError(f"{name} is a {data.GetClassName()}, of which record_outputs.py makes no rows yet")
    if isinstance(data, (vtkPolyData, vtkImageData)):
        yield from rows_of_arrays(f"{name}/point data", data.GetPointData())
        yield from rows_of_arrays(f"{name}/cell data", data.GetCellData())
    yield from rows_of_arrays(f"{name}/field data", data.GetFieldData())


def time_step(data):
    """The time that a source of time steps gave this output, not one of the day."""
    information, key = data.GetInformation(), vtkDataObject.DATA_TIME_STEP()
    return information.Get(key) if information.Has(key) else None


def rows_of_outputs(name, outputs):
    for part, made in outputs.made.items():
        if isinstance(made, bytes):
            yield f"{name}/{part}", checksum(made)
        else:
            yield from rows_of_data(f"{name}/{part}", made)
    yield f"{name}/warnings", checksum(outputs.warnings)


def gathered(outputs, is_distributed):
    """The outputs for which rank 0 has rows: its own, or with DistributeOutput those of all ranks."""
    rank, number = output_cases.ranks()
    controller = vtkMultiProcessController.GetGlobalController()
    if not controller:
        return outputs
    if not is_distributed:
        if rank > 0 and any(isinstance(data, vtkPolyData) and data.GetNumberOfPoints() > 0
                            for data in outputs.made.values()):
            raise output_cases.CaseFailed(f"rank {rank} has a surface, which only rank 0 should have")
        return outputs
    made = {}
    for part, data in outputs.made.items():
        for other in range(number):
            piece = data
            if other > 0 and rank == other:
                controller.Send(data, 0, PIECE_TAG)
            elif other > 0 and rank == 0:
                piece = data.NewInstance()
                controller.Receive(piece, other, PIECE_TAG)
            made[f"rank{other}of{number}/{part}"] = piece
    return output_cases.Outputs(made, outputs.warnings)


def record(wanted, is_mpi):
    """Rows of all runs whose names hold the regular expression, and messages of what failed."""
    rows, failures = {}, []
    classes = output_cases.concrete_classes()
    failures += [f"{name} has no case; add one to output_cases.py" for name in classes
                 if name not in output_cases.CASES and name not in output_cases.UNTRIED_READERS]
    failures += [f"{name} has a case and is not in the package" for name in output_cases.CASES
                 if name not in classes]
    for name, case in sorted(output_cases.CASES.items()):
        if name not in classes or (is_mpi and not case.on_ranks):
            continue
        for run, make in case.runs(classes[name]).items():
            full_name = f"{name}/{run}"
            if wanted.search(full_name):
                try:
                    rows.update(rows_of_run(full_name, make, "DistributeOutput" in run))
                except (output_cases.CaseFailed, AttributeError, TypeError, ValueError) as failure:
                    failures.append(f"{full_name}: {failure}")
    failures += [f"{name}/{run} has settings in output_cases.py and is no run: is the property renamed?"
                 for name, case in output_cases.CASES.items() if name in classes
                 for run in case.settings_of_no_run(classes[name])]
    return rows, failures


def rows_of_run(name, make, is_distributed):
    with tempfile.TemporaryDirectory(prefix="outputs") as folder:
        outputs = gathered(make(folder=folder), is_distributed)
        return dict(rows_of_outputs(name, outputs)) if output_cases.ranks()[0] == 0 else {}


def read_rows(path):
    """Checksums by name, of a file of a record."""
    with open(path, encoding="utf-8") as file:
        return dict(line.rstrip("\n").rsplit(" ", 1) for line in file if line.strip())


def read_renames(path):
    with open(path, encoding="utf-8") as file:
        lines = [line.strip() for line in file if line.strip() and not line.startswith("#")]
    pairs = [tuple(part.strip() for part in line.split("->")) for line in lines]
    if any(len(pair) != 2 for pair in pairs):
        raise ValueError(f"{path}: each line must be `old -> new`")
    return pairs


def renamed(rows, pairs):
    """Rows under the new names. Raises ValueError for a name that there is not, or for two rows of one name."""
    for old, new in pairs:
        word = re.compile(rf"(?<!\w){re.escape(old)}(?!\w)")
        if not any(word.search(name) for name in rows):
            raise ValueError(f"no row has the name {old}")
        changed = {word.sub(lambda _, text=new: text, name): sum_ for name, sum_ in rows.items()}
        if len(changed) != len(rows):
            raise ValueError(f"{old} -> {new} gives two rows one name")
        rows = changed
    return rows


def differences(before, now):
    """Lines for rows that differ, are missing or new."""
    for name in sorted({*before, *now}):
        if name not in now:
            yield f"missing  {name}"
        elif name not in before:
            yield f"new      {name}"
        elif before[name] != now[name]:
            yield f"differs  {name}"


def set_threads(number):
    """Run on that many threads: STDThread has at most one for each core, TBB more."""
    for backend in ("STDThread", "TBB"):
        if vtkSMPTools.SetBackend(backend):
            vtkSMPTools.Initialize(number)
            if vtkSMPTools.GetEstimatedNumberOfThreads() == number:
                return
    raise SystemExit(f"VTK has no backend that runs on {number} threads here")


def start_mpi():
    # mpi4py starts MPI, as Documentation/Clusters.md describes.
    from mpi4py import MPI  # noqa: F401 pylint: disable=import-outside-toplevel,unused-import
    from vtkmodules.vtkParallelMPI import vtkMPIController  # pylint: disable=import-outside-toplevel
    controller = vtkMPIController()
    controller.Initialize()
    vtkMultiProcessController.SetGlobalController(controller)
    return controller


def arguments(given):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--threads", type=int, metavar="N", help="run on N threads; default: as VTK chooses")
    parser.add_argument("--classes", type=re.compile, default=re.compile(""), metavar="REGEX",
                        help="runs whose names, as vtkConformalSOM/default, hold this expression")
    parser.add_argument("--output", metavar="FILE", help="write the rows to a file instead of printing them")
    parser.add_argument("--compare", metavar="FILE", help="print what differs from this record instead of the rows")
    parser.add_argument("--renames", metavar="FILE", help="with --compare: names that were changed since")
    parser.add_argument("--mpi", action="store_true", help="one of the processes of an MPI job")
    return parser.parse_args(given)


def report(options, rows, failures):
    """Print or write the rows, or what differs; return the exit status."""
    lines = [f"{name} {sum_}" for name, sum_ in rows.items()]
    if options.output:
        with open(options.output, "w", encoding="utf-8") as file:
            file.writelines(line + "\n" for line in lines)
    status = 0
    if options.compare:
        before = renamed(read_rows(options.compare), read_renames(options.renames) if options.renames else [])
        before = {name: sum_ for name, sum_ in before.items()
                  if options.classes.search("/".join(name.split("/")[:2]))}
        found = list(differences(before, rows))
        print("\n".join([*found, f"{len(rows)} rows, {len(found)} of them not as in {options.compare}"]))
        status = 1 if found else 0
    elif not options.output:
        print("\n".join(lines))
    for failure in failures:
        print(failure, file=sys.stderr)
    return FAILED if failures else status


def main(given=None):
    options = arguments(given)
    if options.threads:
        set_threads(options.threads)
    controller = start_mpi() if options.mpi else None
    rows, failures = record(options.classes, options.mpi)
    status = 0
    if not controller or controller.GetLocalProcessId() == 0:
        status = report(options, rows, failures)
    elif failures:
        print("\n".join(failures), file=sys.stderr)
        status = FAILED
    if controller:
        vtkMultiProcessController.SetGlobalController(None)
        controller.Finalize()
    return status


if __name__ == "__main__":
    sys.exit(main())
