# SPDX-License-Identifier: BSD-3-Clause
"""What `grit mpm` leaves of a run: history (CSV), frames (.vtu), log. SI units but for kN and kPa as the files have
them. Standard library only."""
import array
import base64
import collections
import csv
import math
import pathlib
import re
import sys
import xml.etree.ElementTree as ET


class Unusable(Exception):
    """A result that is missing, cut short or of another kind."""


class History:
    """Columns by name, without their units; blows from 1."""

    def __init__(self, path):
        if not path.exists():
            raise Unusable(f"{path}: no such result: has the run ended?")
        text = path.read_text().splitlines()
        self.comments = [line[1:].strip() for line in text if line.startswith("#")]
        rows = list(csv.reader(line for line in text if not line.startswith("#")))
        self.names = [name.split(" ")[0] for name in rows[0]]
        try:
            table = [[float(x) for x in row] for row in rows[1:]]
        except ValueError as error:
            raise Unusable(f"{path}: {error}") from None
        if not table or any(len(row) != len(self.names) for row in table):
            raise Unusable(f"{path}: no rows, or rows of different lengths")
        self.columns = {name: [row[i] for row in table] for i, name in enumerate(self.names)}
        self.stopped = next((c for c in self.comments if c.startswith("STOPPED EARLY")), None)
        mass = re.search(r"driven body: \S+, (?:([\d.e+]+) kg|rigid)", " ".join(self.comments))
        if not mass:
            raise Unusable(f"{path}: its comments do not tell the mass of the driven body")
        self.mass = float(mass[1] or "nan")  # [kg]; a rigid body has none
        self.particles = int(re.search(r"(\d+) particles", " ".join(self.comments))[1])

    def __getitem__(self, name):
        return self.columns[name]

    def __len__(self):
        return len(self.columns["t"])

    def drive(self):
        """Index of the row at which the hammer's stage begins."""
        return next((i for i, s in enumerate(self["stage"]) if s == 2), len(self) - 1)

    def blows(self):
        """[(first row, last row)] of each blow that is over: from its begin to that of the next."""
        first = self.drive()
        starts = collections.OrderedDict()
        for i in range(first, len(self)):
            starts.setdefault(int(self["blow"][i]), i)
        starts.pop(0, None)
        begins = list(starts.values())
        if not begins:
            return []
        begins[0] = first
        # The last row is where the last blow ended: its number is that of the next one.
        return list(zip(begins, begins[1:] + ([] if begins[-1] == len(self) - 1 else [len(self) - 1])))


class Frame:
    """A body at one time: corner coordinates and variables, by particle."""

    def __init__(self, path):
        root = ET.parse(path).getroot()
        piece = root.find("UnstructuredGrid/Piece")
        points = self._read(piece.find("Points/DataArray"))
        self.count = int(piece.get("NumberOfCells"))
        self.corners = [tuple((points[12 * i + 3 * k], points[12 * i + 3 * k + 1]) for k in range(4))
                        for i in range(self.count)]
        self.values = {a.get("Name").split(" ")[0]: self._read(a)
                       for a in piece.findall("CellData/DataArray")}

    @staticmethod
    def _read(element):
        kinds = {"Float64": "d", "Float32": "f", "Int64": "q"}
        out = array.array(kinds[element.get("type")])
        out.frombytes(base64.b64decode(element.text.strip())[8:])  # after their length
        if sys.byteorder == "big":
            out.byteswap()
        return out

    def __getitem__(self, name):
        return self.values[name]

    def centres(self):
        return [(sum(c[0] for c in q) / 4, sum(c[1] for c in q) / 4) for q in self.corners]

    def areas(self):
        """In the r-z plane [m2]."""
        def area(q):
            (ax, ay), (bx, by), (cx, cy), (dx, dy) = q
            return 0.5 * abs((cx - ax) * (dy - by) - (dx - bx) * (cy - ay))
        return [area(q) for q in self.corners]


K0 = 1.0 - math.sin(math.radians(33.0))  # of Lausitz sand at rest
RINGS = ((0.0, 0.25), (0.25, 0.5), (0.5, 1.0))  # beside a pile's shaft, from it outwards [diameters]


def rings(sand, radius, low, high):
    """Of the sand beside a shaft between two levels, for each ring: mean -sigma_rr [kPa], mean void ratio, share of it
    without stress; NaN where there is none."""
    places, areas = sand.centres(), sand.areas()
    out = []
    for inner, outer in RINGS:
        inside = [i for i, (r, z) in enumerate(places)
                  if radius * (1 + 2 * inner) <= r < radius * (1 + 2 * outer) and low <= z < high]
        weights = [areas[i] * places[i][0] for i in inside]
        volume = sum(weights)
        columns = ([-sand["stress_rr"][i] for i in inside], [sand["void_ratio"][i] for i in inside],
                   [float(sand["stress_rr"][i] == 0.0) for i in inside])
        out.append(tuple(sum(w * x for w, x in zip(weights, column)) / volume if volume else math.nan for column in columns))
    return out


class Run:
    """All that is there of a run called name."""

    def __init__(self, folder, name):
        self.name, self.folder = name, pathlib.Path(folder)
        self.history = History(self.folder / f"{name}.csv")
        pvd = ET.parse(self.folder / f"{name}.pvd").getroot()
        self.times, self.files = [], []
        for data in pvd.iter("DataSet"):
            body = data.get("file").rsplit("_", 1)[1].removesuffix(".vtu")
            if body == "sand":
                self.times.append(float(data.get("timestep")))
                self.files.append(data.get("file").removesuffix("sand.vtu"))
        self._frames = {}

    def frame(self, index, body="sand"):
        index = index % len(self.files)
        key = (index, body)
        if key not in self._frames:
            self._frames[key] = Frame(self.folder / (self.files[index] + body + ".vtu"))
        return self._frames[key]

    def forget(self, index=None):
        """Frames take memory: those of an index, or all."""
        self._frames = {key: frame for key, frame in self._frames.items() if index is not None and key[0] != index}

    def frame_near(self, time):
        """Index of the frame of that time; no farther than a few rows."""
        index = min(range(len(self.times)), key=lambda i: abs(self.times[i] - time))
        if abs(self.times[index] - time) > 5e-3:
            raise Unusable(f"{self.name}: no frame at {time:g} s, the nearest is at {self.times[index]:g} s")
        return index

    def cost(self):
        """(particle-steps/s, {part: %}), of the sessions that the log tells of weighted by their time."""
        log = self.folder / f"{self.name}.log"
        text = log.read_text() if log.exists() else ""
        sessions = re.findall(r"([\d.]+) s of computing.*\n.*?([\d.e+]+) particle-steps/s; (.*)", text)
        total = sum(float(seconds) for seconds, _, _ in sessions)
        rate, parts = 0.0, collections.defaultdict(float)
        for seconds, per_second, line in sessions:
            weight = float(seconds) / total
            rate += weight * float(per_second)
            for what, share in re.findall(r"([a-z ]+?) (\d+) %", line):
                parts[what.strip()] += weight * float(share)
        return rate, dict(parts)

    def penalty_vertices(self):
        log = self.folder / f"{self.name}.log"
        found = re.findall(r"(\d+) and (\d+) vertices", log.read_text() if log.exists() else "")
        return sum(map(int, found[-1])) if found else 0
