#!/usr/bin/python3
"""make_vtk_sdk.py FOLDER: put together the wheel vtk-sdk for a Linux machine that reaches only PyPI and Debian.

Kitware's index has the wheel vtk-sdk for Linux; PyPI has it for macOS only. Without Kitware's index, this script
makes a wheel of the same name and version, for the Python that runs it, from four public sources:

- libraries: the wheel vtk of PyPI, so that the linker finds what users have
- headers, CMake files, programs that wrap classes: Debian's packages of the same version of VTK, which
  some suite of Debian must have
- headers of VTK's own zlib and expat, which Debian leaves out, and the header of the threads, which Debian
  configures with TBB: the wheel vtk-sdk of PyPI for macOS
- the C library of that suite, which runs the programs that wrap classes on older systems

The wheel is only for tests. Its headers come from another build of VTK, so the script compares the sizes of all
virtual tables of Debian's libraries with those of the wheel's libraries, and fails if any differ.
"""
import argparse
import base64
import csv
import glob
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
SUITES = ("forky", "sid", "trixie")
PACKAGES = ("libvtk9-dev", "libvtk9.{minor}", "vtk9", "python3-vtk9", "libc6")
COMPONENTS = ("CommonCore", "CommonDataModel", "CommonExecutionModel", "CommonMath", "FiltersCore", "IOCore",
              "IOImage", "ParallelCore", "zlib", "expat")
TRIPLET = "x86_64-linux-gnu"
PROGRAM = """#!/bin/sh
root=$(dirname "$(readlink -f "$0")")/../programs
exec "$root/ld.so" --library-path "$root" "$root/{name}" "$@"
"""


def run(*command, **options):
    """Run a command and return its output."""
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, **options).stdout


def wanted_version():
    """Return the version of vtk-sdk that pyproject.toml requires."""
    with open(os.path.join(HERE, "..", "..", "pyproject.toml"), encoding="utf-8") as file:
        return re.search(r'"vtk-sdk==([\d.]+)"', file.read())[1]


def download_wheel(folder, requirement, *options):
    """Download a wheel of PyPI and unpack it into the folder."""
    with tempfile.TemporaryDirectory() as place:
        run(sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check", "download", "--no-deps",
            "--only-binary", ":all:", "--dest", place, *options, requirement)
        [wheel] = os.listdir(place)
        with zipfile.ZipFile(os.path.join(place, wheel)) as archive:
            archive.extractall(folder)


def mirror():
    """Return the address of Debian's mirror that this machine uses."""
    for line in run("apt-get", "indextargets", "--format", "$(LABEL) $(REPO_URI)").splitlines():
        if line.startswith("Debian "):
            return line.split()[1]
    return "http://deb.debian.org/debian"


def download_packages(folder, version):
    """Download Debian's packages of this version of VTK, checked by apt, and unpack them into the folder."""
    names = [name.format(minor=version.split(".")[1]) for name in PACKAGES]
    for suite in SUITES:
        place = os.path.join(folder, suite)
        for part in ("lists/partial", "archives/partial", "parts"):
            os.makedirs(os.path.join(place, part))
        with open(os.path.join(place, "sources.list"), "w", encoding="utf-8") as file:
            file.write(f"deb {mirror()} {suite} main\n")
        open(os.path.join(place, "status"), "w").close()
        options = [f"-oDir::State::Lists={place}/lists", f"-oDir::Cache={place}", f"-oDir::State::Status={place}/status",
                   f"-oDir::Etc::SourceList={place}/sources.list", f"-oDir::Etc::SourceParts={place}/parts",
                   "-oAPT::Architecture=amd64", "-oAPT::Architectures=amd64", "-oAPT::Sandbox::User=root",
                   "-oAcquire::Languages=none", "-qq"]
        run("apt-get", *options, "update")
        found = run("apt-cache", *options, "madison", names[0])
        match = re.search(rf"\| *([\d:]*{re.escape(version)}[+~-]\S*)", found)
        if not match:
            print(f"{suite} has another version of VTK: {found.strip() or 'none'}")
            continue
        packages = [name if name == "libc6" else f"{name}={match[1]}" for name in names]
        run("apt-get", *options, "download", *packages, cwd=place)
        for package in glob.glob(os.path.join(place, "*.deb")):
            run("dpkg-deb", "--extract", package, os.path.join(folder, "root"))
        return os.path.join(folder, "root", "usr")
    raise SystemExit(f"No suite of {', '.join(SUITES)} has VTK {version}")


def virtual_tables(library):
    """Return the sizes of the virtual tables that a library exports, by symbol."""
    lines = (line.split() for line in run("nm", "-D", "-S", "--defined-only", library).splitlines())
    return {line[3]: line[1] for line in lines if len(line) == 4 and line[3].startswith("_ZTV")}


def compare(debian, modules):
    """Fail unless classes that both builds of VTK export have virtual tables of the same sizes."""
    compared = 0
    for component in COMPONENTS[:-2]:
        [library] = glob.glob(os.path.join(debian, "lib", TRIPLET, f"libvtk{component}-*.so.*.*"))
        ours, theirs = virtual_tables(library), virtual_tables(os.path.join(modules, f"libvtk{component}.so"))
        common = ours.keys() & theirs.keys()
        different = [name for name in common if ours[name] != theirs[name]]
        if different or not common:
            raise SystemExit(f"{component}: virtual tables differ: {different}")
        compared += len(common)
    print(f"{compared} virtual tables of Debian's VTK have the sizes of those of the wheel vtk")


def needed(library):
    """Return the names of VTK's libraries that a library is linked to."""
    return re.findall(r"NEEDED.*\[(libvtk[^]]+)\]", run("readelf", "-d", library))


def copy_libraries(modules, place):
    """Copy the libraries of the components, and those that they are linked to."""
    os.makedirs(place)
    [wrapping] = glob.glob(os.path.join(modules, "libvtkWrappingPythonCore*.so"))
    left = [f"libvtk{component}.so" for component in COMPONENTS] + [os.path.basename(wrapping)]
    while left:
        name = left.pop()
        if not os.path.exists(os.path.join(place, name)):
            shutil.copy(os.path.join(modules, name), place)
            left += needed(os.path.join(modules, name))


def copy_programs(debian, content):
    """Copy the programs that wrap classes, with the C library that they are run by."""
    programs = os.path.join(content, "programs")
    os.makedirs(programs)
    os.makedirs(os.path.join(content, "bin"))
    for path in glob.glob(os.path.join(debian, "bin", "vtkWrap*")):
        name = os.path.basename(path)
        shutil.copy(path, programs)
        with open(os.path.join(content, "bin", name), "w", encoding="utf-8") as file:
            file.write(PROGRAM.format(name=name))
        os.chmod(os.path.join(content, "bin", name), 0o755)
    libraries = os.path.join(debian, "lib", TRIPLET)
    for target, pattern in (("ld.so", "ld-linux-x86-64.so.2"), ("libc.so.6", "libc.so.6"),
                            ("libvtkWrappingTools-{}.so.1", "libvtkWrappingTools-*.so.1")):
        [path] = glob.glob(os.path.join(libraries, pattern))
        minor = re.search(r"-([\d.]+)\.so", path)
        shutil.copy(os.path.realpath(path), os.path.join(programs, target.format(minor[1] if minor else "")))


def edit(path, *changes):
    """Replace regular expressions in a file; each must occur."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for pattern, replacement in changes:
        text, count = re.subn(pattern, replacement, text)
        if not count:
            raise SystemExit(f"{path} has no {pattern}")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def configure(content, version, modules):
    """Let the CMake files name the libraries of the wheel."""
    minor = version.rpartition(".")[0]
    files = os.path.join(content, "lib", TRIPLET, "cmake", f"vtk-{minor}")
    [wrapping] = glob.glob(os.path.join(modules, "libvtkWrappingPythonCore*.so"))
    edit(os.path.join(files, "VTK-targets-none.cmake"),
         (rf"\$\{{_IMPORT_PREFIX\}}/lib/{TRIPLET}/libvtkWrappingPythonCore[^\"]*",
          "${_IMPORT_PREFIX}/vtkmodules/" + os.path.basename(wrapping)),
         (r'SONAME_NONE "libvtkWrappingPythonCore[^"]*"', f'SONAME_NONE "{os.path.basename(wrapping)}"'),
         (rf"\$\{{_IMPORT_PREFIX\}}/lib/{TRIPLET}/(libvtk\w+)-[\d.]+\.so\.[\d.]+", r"${_IMPORT_PREFIX}/vtkmodules/\1.so"),
         (r'SONAME_NONE "(libvtk\w+)-[\d.]+\.so\.1"', r'SONAME_NONE "\1.so"'))
    # Debian's zlib and expat are the system's; those of the wheel are VTK's own.
    targets = "".join(
        f"add_library(VTK::{name} SHARED IMPORTED)\n"
        f"set_target_properties(VTK::{name} PROPERTIES\n"
        f'  IMPORTED_LOCATION "${{_IMPORT_PREFIX}}/vtkmodules/libvtk{name}.so"\n'
        f'  IMPORTED_SONAME "libvtk{name}.so"\n'
        f'  INTERFACE_INCLUDE_DIRECTORIES "${{_IMPORT_PREFIX}}/include/vtk-{minor}")\n'
        for name in ("zlib", "expat"))
    edit(os.path.join(files, "VTK-targets.cmake"),
         (r"\nadd_library\(VTK::expat INTERFACE IMPORTED\)\n+set_target_properties\(VTK::expat[^)]*\)", ""),
         (r"\nadd_library\(VTK::zlib INTERFACE IMPORTED\)\n+set_target_properties\(VTK::zlib[^)]*\)", "\n" + targets),
         (r"foreach\(_cmake_target IN LISTS _cmake_import_check_targets\)", "foreach(_cmake_target)"),
         (r'foreach\(_target "viskores[^)]*\)', "foreach(_target)"),
         (r'(INTERFACE_LINK_LIBRARIES ")([^"]*)"', without_foreign_targets))
    edit(os.path.join(files, "VTKPython-targets.cmake"),
         (r"foreach\(_cmake_target IN LISTS _cmake_import_check_targets\)", "foreach(_cmake_target)"))
    packages = os.path.join(files, "VTK-vtk-module-find-packages.cmake")
    edit(packages, (r"find_package\(Python3\s+[\d.]+", "find_package(Python3\n"))
    with open(packages, encoding="utf-8") as file:
        wanted = set(re.findall(r"find_package\((\w+)", file.read()))
    print("Packages that the CMake files look for:", " ".join(sorted(wanted)))
    # What the libraries are compiled with does not matter to those who only link to them.
    edit(packages, (r"  find_package\((?!Python3|Threads)[^)]*\)", "  # not needed"),
         (r"if \(NOT (?!Python3|Threads)(\w+)_FOUND AND", r"if (OFF AND NOT \1_FOUND AND"))
    config = os.path.join(files, "vtk-config.cmake")
    edit(config, (r"find_package\(Viskores[^)]*\)", "set(Viskores_FOUND 1)"))


def without_foreign_targets(match):
    """Return a list of what a target is linked to, with targets of VTK, Python and threads only."""
    kept = [item for item in match[2].split(";")
            if not re.search(r"\w::", item) or re.search(r"\b(VTK|Python3|Threads)::", item)]
    return match[1] + ";".join(kept) + '"'


def write_wheel(folder, version, destination):
    """Pack the folder as a wheel of the Python that runs this script."""
    python = sysconfig.get_config_var("py_version_nodot")
    abi = "cp" + python + ("t" if sysconfig.get_config_var("Py_GIL_DISABLED") else "")
    tag = f"cp{python}-{abi}-linux_x86_64"
    info = f"vtk_sdk-{version}.dist-info"
    files = {
        "METADATA": f"Metadata-Version: 2.1\nName: vtk-sdk\nVersion: {version}\n"
                    "Summary: Stand-in for Kitware's vtk-sdk, for tests\n",
        "WHEEL": f"Wheel-Version: 1.0\nGenerator: make_vtk_sdk.py\nRoot-Is-Purelib: false\nTag: {tag}\n",
        "entry_points.txt": "[cmake.prefix]\nany = vtk_sdk.cmake\n"}
    os.makedirs(os.path.join(folder, info))
    for name, text in files.items():
        with open(os.path.join(folder, info, name), "w", encoding="utf-8") as file:
            file.write(text)
    rows = io.StringIO()
    path = os.path.join(destination, f"vtk_sdk-{version}-{tag}.whl")
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for root, _, names in os.walk(folder):
            for name in sorted(names):
                file = os.path.join(root, name)
                relative = os.path.relpath(file, folder)
                with open(file, "rb") as data:
                    digest = hashlib.sha256(data.read()).digest()
                code = base64.urlsafe_b64encode(digest).rstrip(b"=").decode()
                csv.writer(rows, lineterminator="\n").writerow([relative, f"sha256={code}", os.path.getsize(file)])
                archive.write(file, relative)
        archive.writestr(f"{info}/RECORD", rows.getvalue() + f"{info}/RECORD,,\n")
    print(path)


def main():
    """Make the wheel."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="of the wheel")
    destination = os.path.abspath(parser.parse_args().folder)
    os.makedirs(destination, exist_ok=True)
    version = wanted_version()
    minor = version.rpartition(".")[0]
    with tempfile.TemporaryDirectory() as work:
        runtime, macos, packages = (os.path.join(work, name) for name in ("runtime", "macos", "packages"))
        download_wheel(runtime, f"vtk=={version}")
        download_wheel(macos, "vtk-sdk", "--platform", "macosx_11_0_arm64", "--python-version", "3.10")
        debian = download_packages(packages, version)
        modules = os.path.join(runtime, "vtkmodules")
        compare(debian, modules)

        folder = os.path.join(work, "wheel")
        content = os.path.join(folder, "vtk_sdk", "content")
        headers = os.path.join(content, "include", f"vtk-{minor}")
        shutil.copytree(os.path.join(debian, "include", f"vtk-{minor}"), headers)
        for part in (f"cmake/vtk-{minor}", f"vtk-{minor}"):
            shutil.copytree(os.path.join(debian, "lib", TRIPLET, part), os.path.join(content, "lib", TRIPLET, part))
        [others] = glob.glob(os.path.join(macos, "vtk_sdk", "content", "vtk-*.data", "headers", "vtk-*.*"))
        for name in ("vtkzlib", "vtkexpat"):
            shutil.copytree(os.path.join(others, name), os.path.join(headers, name))
        for name in ("vtk_zlib.h", "vtk_expat.h", "vtkSMP.h"):
            shutil.copy(os.path.join(others, name), headers)
        copy_libraries(modules, os.path.join(content, "vtkmodules"))
        copy_programs(debian, content)
        configure(content, version, modules)
        place = os.path.join(folder, "vtk_sdk", "cmake")
        os.makedirs(place)
        for file in (os.path.join(folder, "vtk_sdk", "__init__.py"), os.path.join(place, "__init__.py")):
            open(file, "w").close()
        for name in ("vtk-config", "vtk-config-version"):
            with open(os.path.join(place, name + ".cmake"), "w", encoding="utf-8") as file:
                file.write("include(${CMAKE_CURRENT_LIST_DIR}/../content/lib/"
                           f"{TRIPLET}/cmake/vtk-{minor}/{name}.cmake)\n")
        write_wheel(folder, version, destination)


if __name__ == "__main__":
    main()
