"""Broken pictures for --texture and paint: mutates PNG and JPEG files by their structure, and decodes each.

    python3 pictures.py [--number N] [--seed S] [--keep FOLDER] [--slow-every K] [--check]

Chunks of PNG files have right checksums after a mutation, most of the time, so that what is behind these is tried: fields
of the header, zlib streams, filter bytes, palettes, order, duplicates, lengths. Of JPEG files the markers, their lengths,
frames, tables and scans are changed. Every picture is decoded as the command does it, in a process of its own; to save
the start of Python that process is forked here, but for each K-th, which starts as it does for users. Bad is an
exception other than a ValueError in one line that begins with the file, a result of another size than the header's
limits, and more than 10 s of processor time. What is bad is kept in FOLDER. The exit status is 1 then. With --check the
pixels are wrong, and the status is 0 only if that is found to be bad.
"""
import argparse
import os
import random
import re
import resource
import shutil
import signal
import struct
import sys
import tempfile
import time
import zlib
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGWriter

from conformalsom.command import decoding, textures

SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
BITS = {0: (1, 2, 4, 8, 16), 2: (8, 16), 3: (1, 2, 4, 8), 4: (8, 16), 6: (8, 16)}
KINDS = [b"IHDR", b"PLTE", b"IDAT", b"IEND", b"tRNS", b"gAMA", b"cHRM", b"sRGB", b"iCCP", b"tEXt", b"zTXt", b"iTXt",
         b"bKGD", b"pHYs", b"sBIT", b"sPLT", b"hIST", b"tIME", b"acTL", b"IDOT", b"abcd", b"ABCD", b"\0\0\0\0"]
SIZES = (0, 1, 2, 3, 5, 8, 16, 17, 255, 1000, 2**15, 65500, 65535, 2**16, 2**20, 2**31 - 1, 2**31, 2**32 - 1)
SECONDS = 10


class Forked:
    """What textures.py uses of a subprocess.Popen, for a process that has its modules already."""
    last_seconds = 0.0  # of a processor

    def __init__(self, command, stdin, stdout, stderr, env):
        del stdin, stdout, env
        path = command[command.index(textures.DECODER) + 1]
        here, there = os.pipe()
        self.returncode = None
        self.number = os.fork()
        if self.number == 0:
            status = 1
            try:
                os.dup2(there, 1)
                os.dup2(stderr.fileno(), 2)
                decoding.main(path)
                status = 0
            finally:
                os._exit(status)
        os.close(there)
        self.stdout = os.fdopen(here, "rb")

    def wait(self):
        """Wait for its end."""
        if self.returncode is None:
            _, status, used = os.wait4(self.number, 0)
            self.returncode = -os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status)
            Forked.last_seconds = used.ru_utime + used.ru_stime
        return self.returncode

    def kill(self):
        """End it."""
        if self.returncode is None:
            os.kill(self.number, signal.SIGKILL)


def png_sample(dice):
    """Chunks of a valid PNG file, and the bytes of its rows."""
    color = dice.choice(list(CHANNELS))
    bits, interlaced = dice.choice(BITS[color]), dice.randrange(2)
    columns, rows = dice.randrange(1, 40), dice.randrange(1, 40)
    passes = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]
    data = b""
    for x, y, across, down in passes if interlaced else [(0, 0, 1, 1)]:
        width, height = len(range(x, columns, across)), len(range(y, rows, down))
        for _ in range(height if width else 0):
            data += bytes([dice.randrange(5)]) + dice.randbytes((width * CHANNELS[color] * bits + 7) // 8)
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", columns, rows, bits, color, 0, 0, interlaced))]
    if color == 3:
        chunks.append((b"PLTE", dice.randbytes(3 * 2**bits)))
    if dice.random() < 0.3 and color in (0, 2, 3):
        chunks.append((b"tRNS", dice.randbytes({0: 2, 2: 6, 3: 2}[color])))
    return chunks + [(b"IDAT", data), (b"IEND", b"")]


def changed_bytes(dice, data):
    """Bytes with a few changes."""
    data = bytearray(data)
    for _ in range(dice.choice((1, 1, 2, 8))):
        place, kind = dice.randrange(len(data) + 1), dice.randrange(4)
        if kind == 0:
            data[place:place + 1] = dice.randbytes(1)
        elif kind == 1:
            del data[place:place + dice.choice((1, 4, 50))]
        elif kind == 2:
            data[place:place] = dice.randbytes(dice.choice((1, 3, 200)))
        else:
            del data[place:]
    return bytes(data)


def changed_header(dice, data):
    """An IHDR chunk with another field, or of another length."""
    fields = list(struct.unpack(">IIBBBBB", data))
    which = dice.randrange(8)
    if which < 2:
        fields[which] = dice.choice(SIZES)
    elif which < 7:
        fields[which] = dice.choice((0, 1, 2, 3, 4, 5, 6, 7, 8, 16, 32, 255))
    data = struct.pack(">IIBBBBB", *fields)
    return changed_bytes(dice, data) if which == 7 else data


def packed(dice, data):
    """An IDAT chunk's zlib stream, which may be wrong."""
    kind = dice.randrange(12)
    if kind == 0:
        return changed_bytes(dice, zlib.compress(data))
    if kind == 1:
        return zlib.compress(data) + dice.randbytes(20)
    if kind == 2:
        return zlib.compress(data * 3)
    if kind == 3:
        return zlib.compress(bytes(dice.choice((0, 10**5, 10**7))))
    if kind == 4:
        return zlib.compress(data)[2:]
    return zlib.compress(data, dice.randrange(10))


def mutated_png(dice):
    """A PNG file with one or several wrong things in it."""
    chunks = png_sample(dice)
    for _ in range(dice.choice((1, 1, 1, 2, 3))):
        kind, place = dice.randrange(10), dice.randrange(len(chunks))
        name, data = chunks[place]
        if kind <= 2 and chunks[0][0] == b"IHDR" and len(chunks[0][1]) == 13:
            chunks[0] = (b"IHDR", changed_header(dice, chunks[0][1]))
        elif kind == 3:
            chunks[place] = (name, changed_bytes(dice, data))
        elif kind == 4:
            chunks.insert(dice.randrange(len(chunks) + 1), (name, data))
        elif kind == 5 and len(chunks) > 1:
            del chunks[place]
        elif kind == 6:
            dice.shuffle(chunks)
        elif kind == 7:
            chunks.insert(place, (dice.choice(KINDS), dice.randbytes(dice.choice((0, 1, 2, 4, 32, 900)))))
        elif kind == 8:
            chunks[place] = (dice.choice(KINDS), data)
        else:
            rows = bytearray(next((data for name, data in chunks if name == b"IDAT"), b"?") or b"?")
            rows[dice.choice((0, dice.randrange(len(rows))))] = dice.randrange(256)  # the first filter, or any byte
            chunks = [(name, bytes(rows) if name == b"IDAT" else data) for name, data in chunks]
    content = SIGNATURE
    for name, data in chunks:
        for part in parts_of(dice, packed(dice, data)) if name == b"IDAT" else [data]:
            length = len(part) if dice.random() < 0.99 else dice.choice((0, 1, 2**31 - 1, 2**32 - 1))
            checksum = zlib.crc32(name + part) ^ (dice.random() < 0.01)
            content += struct.pack(">I", length) + name + part + struct.pack(">I", checksum)
    return content if dice.random() < 0.97 else content[:dice.randrange(len(content))]


def parts_of(dice, data):
    """Bytes, perhaps in two parts."""
    cut = dice.randrange(len(data) + 1) if dice.random() < 0.2 else 0
    return [data[:cut], data[cut:]] if cut else [data]


def jpeg_samples(folder):
    """Valid JPEG files: gray and RGB, baseline and progressive."""
    samples = []
    values = np.random.RandomState(1).randint(0, 256, (33 * 20, 3)).astype(np.uint8)
    for channels in 1, 3:
        for progressive in 0, 1:
            image = vtkImageData()
            image.SetDimensions(33, 20, 1)
            image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values[:, :channels]), deep=True))
            writer = vtkJPEGWriter()
            writer.SetInputData(image)
            writer.SetProgressive(progressive)
            writer.SetFileName(os.path.join(folder, "sample.jpg"))
            writer.Write()
            with open(writer.GetFileName(), "rb") as file:
                samples.append(file.read())
    return samples


def segments_of(data):
    """A JPEG file cut at its markers."""
    return [b"\xff" + part for part in re.split(rb"\xff(?=[\x01-\xfe])", data)[1:]]


def changed_frame(dice, segment):
    """A frame or scan header with another field."""
    segment = bytearray(segment)
    kind = dice.randrange(5)
    if kind == 0 and len(segment) > 9:
        segment[5:9] = struct.pack(">HH", dice.choice((0, 1, 8, 20, 33, 2000, 65500, 65535)),
                                   dice.choice((0, 1, 8, 20, 33, 2000, 65535)))
    elif kind == 1:
        segment[1] = dice.choice((0xc0, 0xc1, 0xc2, 0xc3, 0xc5, 0xc9, 0xca, 0xcb, 0xcc))
    elif len(segment) > 4:
        segment[dice.randrange(2, len(segment))] = dice.choice((0, 1, 2, 3, 4, 8, 12, 16, 17, 34, 68, 255))
    return bytes(segment)


def mutated_jpeg(dice, sample):
    """A JPEG file with one or several wrong things in it."""
    segments = segments_of(sample)
    for _ in range(dice.choice((1, 1, 2, 3))):
        kind, place = dice.randrange(8), dice.randrange(len(segments))
        if kind <= 1:
            frames = [i for i, part in enumerate(segments) if 0xc0 <= part[1] <= 0xcf or part[1] == 0xda] or [place]
            place = dice.choice(frames)
            segments[place] = changed_frame(dice, segments[place])
        elif kind == 2:
            segments.insert(dice.randrange(len(segments) + 1), segments[place])
        elif kind == 3 and len(segments) > 1:
            del segments[place]
        elif kind == 4:
            other = dice.randrange(len(segments))
            segments[place], segments[other] = segments[other], segments[place]
        elif kind == 5:
            segments.insert(place, bytes([0xff, dice.randrange(1, 255)]) + dice.randbytes(dice.choice((0, 2, 20))))
        else:
            segments[place] = segments[place][:2] + changed_bytes(dice, segments[place][2:])
    data = b"".join(segments)
    return data if dice.random() < 0.9 else data[:dice.randrange(len(data) + 1)]


def outcome_of(path):
    """A word for what became of the picture; bad ones begin with BAD."""
    try:
        pixels = textures.read_picture(path)
    except ValueError as error:
        text = str(error)
        if not text.startswith(path + ": ") or "\n" in text:
            return f"BAD message: {text}"
        return "refused after a crash" if "crashed by" in text else "refused"
    except Exception as error:  # whatever it is, it should not be
        return f"BAD exception: {error!r}"
    right = pixels.dtype == np.uint8 and pixels.ndim == 3 and pixels.shape[2] in (3, 4)
    return "decoded" if right and 0 < pixels[..., 0].size <= textures.MAXIMUM_PIXELS else f"BAD array: {pixels.shape}"


def main():
    """Try all, print a table, and return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--number", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", default="bad-pictures")
    parser.add_argument("--slow-every", type=int, default=100)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.check:
        textures.received = lambda stream: ({}, np.zeros((1, 1, len(stream.read()) % 5)))
    counts, bad, slowest = {}, 0, 0.0
    with tempfile.TemporaryDirectory() as folder:
        samples = jpeg_samples(folder)
        for number in range(options.seed, options.seed + options.number):
            dice = random.Random(number)
            is_jpeg = number % 3 == 0
            content = mutated_jpeg(dice, dice.choice(samples)) if is_jpeg else mutated_png(dice)
            path = os.path.join(folder, "a.jpg" if is_jpeg else "a.png")
            with open(path, "wb") as file:
                file.write(content)
            Forked.last_seconds, start = 0.0, time.monotonic()
            if number % options.slow_every:
                with mock.patch.object(textures.subprocess, "Popen", Forked):
                    outcome = outcome_of(path)
                seconds = Forked.last_seconds
            else:
                outcome, seconds = outcome_of(path), time.monotonic() - start
            slowest = max(slowest, seconds)
            if seconds > SECONDS:
                outcome = f"BAD time: {seconds:.1f} s"
            if outcome.startswith("BAD"):
                bad += 1
                print(f"picture {number}: {outcome}", flush=True)
                if not options.check:
                    os.makedirs(options.keep, exist_ok=True)
                    shutil.copy(path, os.path.join(options.keep, f"{number}{os.path.splitext(path)[1]}"))
            word = " ".join(outcome.split(":")[0].split())
            counts[word] = counts.get(word, 0) + 1
    for word, count in sorted(counts.items()):
        print(f"{count:8} {word}")
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024
    print(f"{bad:8} bad; the longest took {slowest:.2f} s of a processor, the largest process {memory} MiB")
    few = options.number >= 100 and min(counts.get("decoded", 0), counts.get("refused", 0)) < options.number // 20
    if few:
        print("too few were decoded or refused for a trial")
    return int(bad == 0) if options.check else int(bad > 0 or few)


if __name__ == "__main__":
    sys.exit(main())
