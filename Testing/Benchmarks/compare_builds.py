#!/usr/bin/python3
"""Compare the processor time and the closeness of results of two builds.

    PYTHONPATH=Examples/Python /usr/bin/python3 Testing/Benchmarks/compare_builds.py \
      ../main/build/dev/python build/dev/python --scans FOLDER

BEFORE and AFTER are the folders python of two builds of the same type. Each case runs in a process of its own, by
turns with one build and with the other. Other programs then slow both builds equally. For each case, prints

    CPU        seconds of all threads with the build BEFORE, and with AFTER: the smallest of all rounds
    ratio      AFTER / BEFORE
    us/neuron  microseconds of CPU with AFTER for each vertex of the learned mesh
    MiB        largest resident memory of the process, with both builds
    p2s, s2p   mean square distance from the object to the result and back, with both builds. Points are learned at
               random positions on the object's triangles, and distances are measured to the object itself.

The largest radius of the object is 1. Cases of learning are OBJECT/POINTS/NEURONS.
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import time

ANIMALS = {"animal1": "quadrupeds/381.off", "animal2": "quadrupeds/385.off"}
CASES = ("surface", "geodesic", "adaptive", "quickstart", "armadillo/40000/13000", "armadillo/200000/40000",
         "armadillo/1000000/100000")


def learning(case, scans):
    """The object, and the filter that learns it."""
    import conformalsom
    from helpers import builtin_figure
    from helpers.clouds import cloud_of
    import known_objects

    known_objects.SCANS.update(ANIMALS)
    name, points, neurons = case.split("/") if "/" in case else ("igea", 40000, 0)
    if name == "bear":
        thing, cloud = None, builtin_figure.figure_cloud(int(points))
    else:
        thing = known_objects.known_object(name, scans, int(points))
        cloud = cloud_of(thing.points / known_objects.largest_radius(thing.points))
    network = conformalsom.vtkConformalSOM()
    network.SetInputData(cloud)
    network.SetNumberOfNeurons(int(neurons))
    if case == "geodesic":
        network.SetMeshTypeToGeodesic()
    elif case == "adaptive":
        network.SetNumberOfNeurons(12962)
    return thing, network


def cost_of(case, scans):
    """Seconds of the case, and the closeness of its result."""
    import known_objects
    from helpers.clouds import points_of, vtk_points

    thing, network = learning(case, scans)
    begin = time.process_time()
    network.Update()
    if case == "surface":
        begin = time.process_time()
    result = known_objects.smooth_surface(network.GetOutput()) if case in ("surface", "quickstart") \
        else network.GetOutput()
    cost = {"seconds": time.process_time() - begin, "neurons": network.GetOutput().GetNumberOfPoints(),
            "memory": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024, "p2s": 0.0, "s2p": 0.0}
    if thing:
        mesh = thing.mesh()
        mesh.SetPoints(vtk_points(points_of(mesh) / known_objects.largest_radius(thing.points)))
        off, cost["p2s"], _ = known_objects.mismatch(result, mesh)
        cost["s2p"] = off**2
    return cost


def run_with(build, case, scans):
    paths = [build, *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]
    text = subprocess.run([sys.executable, __file__, "--run", case, build, build, "--scans", scans], check=True,
                          stdout=subprocess.PIPE, env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)}).stdout
    return json.loads(text.splitlines()[-1])


def compare(builds, case, scans, rounds):
    costs = [[], []]
    for number in range(rounds):
        for which in (0, 1) if number % 2 == 0 else (1, 0):
            costs[which].append(run_with(builds[which], case, scans))
    before, after = (min(runs, key=lambda cost: cost["seconds"]) for runs in costs)
    print(f"| {case} | {before['seconds']:.2f} | {after['seconds']:.2f} | {after['seconds'] / before['seconds']:.2f} | "
          f"{1e6 * after['seconds'] / after['neurons']:.0f} | {before['memory']:.0f}, {after['memory']:.0f} | "
          f"{before['p2s']:.3e}, {after['p2s']:.3e} | {before['s2p']:.3e}, {after['s2p']:.3e} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", help="folder python of a build")
    parser.add_argument("after", help="folder python of another build")
    parser.add_argument("--cases", default=",".join(CASES), help="default %(default)s")
    parser.add_argument("--rounds", type=int, default=2, help="runs of each case with each build, default %(default)s")
    parser.add_argument("--scans", default="../shared/data", help="folder of the objects' files")
    parser.add_argument("--run", help=argparse.SUPPRESS)  # case to run in this process
    options = parser.parse_args()
    if options.run:
        print(json.dumps(cost_of(options.run, options.scans)))
        return
    print("| case | CPU before | after | ratio | us/neuron | MiB | p2s | s2p |\n|---|---|---|---|---|---|---|---|")
    for case in options.cases.split(","):
        compare([os.path.abspath(build) for build in (options.before, options.after)], case, options.scans,
                options.rounds)


if __name__ == "__main__":
    main()
