"""Rules of the glTF 2.0 specification that a binary file with one textured mesh has to keep.

Written from the specification's text, not from the writer: each entry of the list that faults()
returns names the rule that is broken.
"""
import json
import struct

import numpy as np

COMPONENTS = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32,
              5126: np.float32}
SIZES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
WRAPS, MAG, MIN = {33071, 33648, 10497}, {9728, 9729}, {9728, 9729, 9984, 9985, 9986, 9987}


def chunks(data, found):
    """The JSON document and the binary buffer of a GLB container."""
    if len(data) < 12 or data[:4] != b"glTF":
        found.append("a GLB file starts with the magic glTF")
        return {}, b""
    version, length = struct.unpack("<II", data[4:12])
    if version != 2:
        found.append("the container's version is 2")
    if length != len(data) or length % 4:
        found.append("the length in the header is that of the file, a multiple of 4")
    parts, at = [], 12
    while at + 8 <= len(data):
        size, kind = struct.unpack("<I4s", data[at:at + 8])
        if size % 4 or at + 8 + size > len(data):
            found.append("chunks end on multiples of 4, within the file")
            return {}, b""
        parts.append((kind, data[at + 8:at + 8 + size]))
        at += 8 + size
    if [kind for kind, _ in parts] != [b"JSON", b"BIN\0"]:
        found.append("a JSON chunk comes first, a BIN chunk second")
        return {}, b""
    document = parts[0][1]
    if document[:1] != b"{" or document.rstrip(b" ")[-1:] != b"}":
        found.append("the JSON chunk is padded by blanks at its end")
    return json.loads(document.decode("utf-8")), parts[1][1]


def accessor_values(gltf, binary, index, found):
    """What an accessor points at, as an array of rows; None where it points nowhere."""
    if not 0 <= index < len(gltf["accessors"]):
        found.append("an accessor that is referred to exists")
        return None
    accessor = gltf["accessors"][index]
    view = gltf["bufferViews"][accessor["bufferView"]]
    kind = np.dtype(COMPONENTS[accessor["componentType"]]).newbyteorder("<")
    width = SIZES[accessor["type"]]
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    size = kind.itemsize * width * accessor["count"]
    if accessor["count"] < 1:
        found.append("an accessor has at least one element")
    if start % kind.itemsize or (accessor.get("byteOffset", 0) + size > view["byteLength"]):
        found.append("an accessor is aligned and lies within its view")
        return None
    values = np.frombuffer(binary, kind, width * accessor["count"], start).reshape(-1, width)
    if not np.isfinite(values.astype(float)).all():
        found.append("values are finite")
    for key, extreme in (("min", values.min(axis=0)), ("max", values.max(axis=0))):
        if key in accessor and accessor[key] != [float(v) for v in extreme]:
            found.append(f"an accessor's {key} is that of its values")
    return values


def check_geometry(gltf, binary, found):
    """Meshes: what their attributes and indices are like."""
    for mesh in gltf["meshes"]:
        for primitive in mesh["primitives"]:
            values = {name: accessor_values(gltf, binary, index, found)
                      for name, index in primitive["attributes"].items()}
            if any(v is None for v in values.values()):
                continue
            position = gltf["accessors"][primitive["attributes"]["POSITION"]]
            if not {"min", "max"} <= set(position):
                found.append("the positions' accessor has min and max")
            if len({len(v) for v in values.values()}) != 1:
                found.append("all attributes have the same number of elements")
            for name, shape in (("POSITION", 3), ("NORMAL", 3), ("TEXCOORD_0", 2)):
                if name in values and (values[name].shape[1] != shape or values[name].dtype != "<f4"):
                    found.append(f"{name} has {shape} floats")
            if "NORMAL" in values:
                lengths = np.linalg.norm(values["NORMAL"].astype(float), axis=1)
                if np.abs(lengths - 1.0).max() > 5e-4:
                    found.append("normals have unit length")
            indices = accessor_values(gltf, binary, primitive["indices"], found)
            if indices is None or indices.dtype.kind != "u" or indices.shape[1] != 1:
                found.append("indices are unsigned scalars")
            elif indices.max() >= len(values["POSITION"]) or len(indices) % 3:
                found.append("indices come in threes, each of a vertex")
            elif (indices == np.iinfo(indices.dtype).max).any():
                found.append("the largest index of a type is not used")
            targets = [gltf["bufferViews"][gltf["accessors"][i]["bufferView"]].get("target")
                       for i in (*primitive["attributes"].values(), primitive["indices"])]
            if targets != [34962] * len(values) + [34963]:
                found.append("views are bound to the targets of vertices and of indices")


def check_material(gltf, binary, found):
    """Materials, textures, samplers and images."""
    for primitive in (p for mesh in gltf["meshes"] for p in mesh["primitives"]):
        material = gltf["materials"][primitive["material"]]
        texture = gltf["textures"][material["pbrMetallicRoughness"]["baseColorTexture"]["index"]]
        sampler = gltf["samplers"][texture["sampler"]]
        if not (sampler["wrapS"] in WRAPS and sampler["wrapT"] in WRAPS
                and sampler["magFilter"] in MAG and sampler["minFilter"] in MIN):
            found.append("a sampler's numbers are those of the list")
        image = gltf["images"][texture["source"]]
        view = gltf["bufferViews"][image["bufferView"]]
        start = view.get("byteOffset", 0)
        if image.get("mimeType") != "image/png" or binary[start:start + 8] != b"\x89PNG\r\n\x1a\n":
            found.append("an image in the buffer has a type, which its first bytes bear out")
        if "target" in view:
            found.append("an image's view has no target")


def faults(data):
    """Rules that the bytes of a GLB file break; an empty list for a good one."""
    found = []
    gltf, binary = chunks(data, found)
    if not gltf:
        return found
    if gltf.get("asset", {}).get("version") != "2.0":
        found.append("asset.version is 2.0")
    buffer = gltf["buffers"][0]
    if "uri" in buffer or not buffer["byteLength"] <= len(binary) <= buffer["byteLength"] + 3:
        found.append("the first buffer is the BIN chunk, but for its padding")
    for view in gltf["bufferViews"]:
        if view["byteLength"] < 1 or view.get("byteOffset", 0) + view["byteLength"] > buffer["byteLength"]:
            found.append("a view lies within its buffer")
    nodes = gltf["scenes"][gltf["scene"]]["nodes"]
    if any(gltf["nodes"][node]["mesh"] >= len(gltf["meshes"]) for node in nodes):
        found.append("the scene's nodes have meshes that exist")
    check_geometry(gltf, binary, found)
    check_material(gltf, binary, found)
    return found
