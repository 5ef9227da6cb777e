# SPDX-License-Identifier: MIT
"""A small writer of binary glTF: shared accessors, compact component types, nothing else."""
import json
import struct

import numpy as np

COMPONENT = {"int16": 5122, "uint8": 5121, "uint16": 5123, "uint32": 5125, "float32": 5126}
VERTICES, INDICES = 34962, 34963


class GlbWriter:
    def __init__(self):
        self.binary = bytearray()
        self.document = {"asset": {"version": "2.0", "generator": "Crowdbrush authoring scripts"},
                         "scene": 0, "scenes": [], "nodes": [], "bufferViews": [], "accessors": []}
        self._known = {}

    def add(self, kind, item):
        """Appends to a list of the document and returns the index."""
        self.document.setdefault(kind, []).append(item)
        return len(self.document[kind]) - 1

    def view(self, data, target=None):
        self.binary.extend(b"\0" * (-len(self.binary) % 4))
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        if target:
            view["target"] = target
        self.binary.extend(data)
        return self.add("bufferViews", view)

    def accessor(self, array, kind, target=None, normalized=False, bounds=False):
        """Equal arrays share one accessor."""
        array = np.ascontiguousarray(array)
        key = (array.tobytes(), str(array.dtype), kind, target)
        if key not in self._known:
            item = {"bufferView": self.view(array.tobytes(), target),
                    "componentType": COMPONENT[str(array.dtype)], "count": len(array),
                    "type": kind}
            if normalized:
                item["normalized"] = True
            if bounds:
                table = array.reshape(len(array), -1)
                item["min"] = [float(x) for x in table.min(0)]
                item["max"] = [float(x) for x in table.max(0)]
            self._known[key] = self.add("accessors", item)
        return self._known[key]

    def image(self, data, name):
        return self.add("images", {"name": name, "mimeType": "image/png",
                                   "bufferView": self.view(data)})

    def write(self, path):
        self.binary.extend(b"\0" * (-len(self.binary) % 4))
        self.document["buffers"] = [{"byteLength": len(self.binary)}]
        write_glb(path, self.document, self.binary)


def write_glb(path, document, binary):
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(binary)))
        file.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(binary), 0x004E4942) + binary)


def read_glb(path):
    """(document, binary) of a .glb."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[28 + length:]


def accessor_values(document, binary, index):
    """Array of an accessor, normalised integers as 0..1 or -1..1."""
    item = document["accessors"][index]
    dtype = {code: np.dtype(name) for name, code in COMPONENT.items()}[item["componentType"]]
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[item["type"]]
    start = document["bufferViews"][item["bufferView"]].get("byteOffset", 0)
    values = np.frombuffer(binary, dtype, item["count"] * width, start + item.get("byteOffset", 0))
    values = values.reshape(item["count"], width)
    if item.get("normalized"):
        return np.maximum(values / float(np.iinfo(dtype).max), -1.0)
    return values


def vertex_attributes(writer, positions, normals, colors=None, uv=None):
    """Attributes common to people and stages; colours and uv of 0..1 become integers."""
    attributes = {
        "POSITION": writer.accessor(positions.astype(np.float32), "VEC3", VERTICES, bounds=True),
        "NORMAL": writer.accessor(normals.astype(np.float32), "VEC3", VERTICES)}
    if uv is not None:
        attributes["TEXCOORD_0"] = writer.accessor(
            np.round(np.clip(uv, 0, 1) * 65535).astype(np.uint16), "VEC2", VERTICES, True)
    if colors is not None:
        attributes["COLOR_0"] = writer.accessor(
            np.round(np.clip(colors, 0, 1) * 255).astype(np.uint8), "VEC4", VERTICES, True)
    return attributes
