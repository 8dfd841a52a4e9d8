#!/usr/bin/python3
"""Inputs of the fuzzers: one file for each, in Testing/Fuzz/Corpus, in place of a folder.

    corpus.py unpack FILE FOLDER    for a fuzzer to start from
    corpus.py pack FOLDER FILE      what a fuzzer has left in a folder
    corpus.py check FOLDER CASES    that the files there are few, small, and as pack writes them, and that each class
                                    with a case in the folder CASES that makes surfaces of bytes has one

A file holds one input after the other, shortest first, each behind its number of bytes on a line.
"""
import glob
import hashlib
import os
import sys

MOST_FILES, MOST_BYTES = 60, 450_000


def packed(inputs):
    """The content of a file: every input once."""
    ordered = sorted(set(inputs), key=lambda data: (len(data), data))
    return b"".join(b"%d\n%b" % (len(data), data) for data in ordered)


def unpacked(content):
    """The inputs in the content of a file."""
    inputs, start = [], 0
    while start < len(content):
        first = content.index(b"\n", start) + 1
        end = first + int(content[start:first])
        if end > len(content):
            raise ValueError("it ends in the middle of an input")
        inputs.append(content[first:end])
        start = end
    return inputs


def read(path):
    with open(path, "rb") as file:
        return file.read()


def write(path, content):
    with open(path, "wb") as file:
        file.write(content)


def pack(folder, path):
    write(path, packed(read(entry) for entry in glob.glob(os.path.join(folder, "*"))))


def unpack(path, folder):
    os.makedirs(folder, exist_ok=True)
    for data in unpacked(read(path)):
        write(os.path.join(folder, hashlib.sha1(data).hexdigest()), data)


def check(folder, cases):
    files = sorted(os.listdir(folder))
    contents = [read(os.path.join(folder, name)) for name in files]
    total = sum(map(len, contents))
    print(f"{len(files)} files, {total:,} bytes, {sum(len(unpacked(c)) for c in contents):,} inputs")
    for name, content in zip(files, contents):
        if packed(unpacked(content)) != content:
            raise ValueError(f"{name} is not as pack writes it")
    for case in sorted(glob.glob(os.path.join(cases, "vtk*.cxx"))):
        name = os.path.basename(case)[len("vtk"):-len(".cxx")] + ".inputs"
        if b'"FuzzFilter.h"' in read(case) and name not in files:
            raise ValueError(f"{name} is missing: run the fuzzer on an empty folder, and pack that")
    if not 0 < len(files) <= MOST_FILES or total > MOST_BYTES:
        raise ValueError(f"expected at most {MOST_FILES} files of {MOST_BYTES:,} bytes in all")


if __name__ == "__main__":
    commands = {"pack": pack, "unpack": unpack, "check": check}
    if len(sys.argv) != 4 or sys.argv[1] not in commands:
        sys.exit(__doc__)
    try:
        commands[sys.argv[1]](*sys.argv[2:])
    except (ValueError, OSError) as error:
        sys.exit(f"corpus: {error}")
