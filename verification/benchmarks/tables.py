#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""tables.py FOLDER [DOCUMENT.md]: tables of what script/benchmark has left in FOLDER, as Markdown on the screen
and in tables.md, as JSON in tables.json, and what the pictures need as CSV. In the document they take the place
of what stands between <!-- table: KEY --> and <!-- end -->, where there is a table of this key. A time is the
shortest of all passes of all repetitions; "exp" is one dependent std::exp of the same run of the same program."""
import json
import math
import pathlib
import re
import statistics
import sys

PERCENTILES = ("p50", "p90", "max")


class Runs:
    """Benchmarks of one program: the shortest best_ns of those of one name and request."""

    def __init__(self, path):
        content = json.loads(path.read_text())
        self.mhz = content["context"]["mhz_per_cpu"]
        self.caches = {c["level"]: c["size"] for c in content["context"]["caches"]
                       if c["type"] != "Instruction"}
        self.repetitions = [run for run in content["benchmarks"] if run["run_type"] == "iteration"]
        shortest = {}
        for run in self.repetitions:
            run["family"] = run["name"].split("/")[0]
            known = shortest.setdefault(run["name"], run)
            if run["best_ns"] < known["best_ns"]:
                shortest[run["name"]] = run
        self.all = sorted(shortest.values(),  # as registered; they ran in another order
                          key=lambda run: (run["family_index"], run["per_family_instance_index"]))
        self.exp = min(run["best_ns"] for run in self.all if run["family"] == "exp")

    def find(self, family, among=None, **wanted):
        return [run for run in among or self.all if run["family"] == family and all(
            run.get(key) == value for key, value in wanted.items())]

    def ns(self, family, **wanted):
        found = self.find(family, **wanted)
        return found[0]["best_ns"] if found else None

    def faster_by(self, **wanted):
        """Of two threads, the middle one of all repetitions."""
        return statistics.median(run["faster_by"] for run in self.find("threads", self.repetitions, **wanted))

    def families(self):
        return list(dict.fromkeys(run["family"] for run in self.all))


def number(x):
    """Three digits, as people write them."""
    if x is None:
        return "–"
    if isinstance(x, str):
        return x
    if x == round(x) and abs(x) < 1e5:
        return f"{x:.0f}"
    if 1e-2 <= abs(x) < 1e5:
        return f"{x:.{max(0, 2 - math.floor(math.log10(abs(x))))}f}"
    return f"{x:.1e}"


class Report:
    def __init__(self):
        self.text, self.tables = {}, {}

    def table(self, key, title, columns, rows):
        if not rows:
            return
        self.tables[key] = {"title": title, "rows": [dict(zip(columns, row, strict=True)) for row in rows]}
        cells = [columns] + [[number(x) for x in row] for row in rows]
        width = [max(len(row[i]) for row in cells) for i in range(len(columns))]
        lines = ["| " + " | ".join(x.ljust(w) for x, w in zip(row, width)) + " |" for row in cells]
        lines.insert(1, "|" + "|".join("-" * (w + 2) for w in width) + "|")
        self.text[key] = f"{title}\n\n" + "\n".join(lines) + "\n"

    def write(self, folder):
        text = "\n".join(self.text.values())
        print(text, end="")
        (folder / "tables.md").write_text(text)
        (folder / "tables.json").write_text(json.dumps(self.tables, indent=1, ensure_ascii=False))


    def put_into(self, document):
        def fresh(match):
            return f"{match[1]}\n{self.text[match[2]]}{match[4]}" if match[2] in self.text else match[0]

        text = document.read_text()
        document.write_text(re.sub(r"(<!-- table: (.*?) -->)\n(.*?)(<!-- end -->)", fresh, text, flags=re.S))


def write_csv(path, columns, rows):
    lines = [",".join(columns)] + [",".join(f"{x:.6g}" for x in row) for row in rows]
    path.write_text("\n".join(lines) + "\n")


def power(x):
    return f"1e{round(math.log10(x))}"


def single_calls(report, runs, folder):
    def table(key, title, found):
        rows = [[power(r["increment"]), r["best_ns"] / 1e3, r["best_ns"] / runs.exp,
                 *(r.get(f"evaluations_{p}") for p in PERCENTILES),
                 *(r.get(f"error_{p}") for p in PERCENTILES), f"{100 * r['failures']:.3g} %"]
                for r in found]
        report.table(key, title, ["increment", "µs", "exp", *(f"{what} {p}" for what in ("evaluations", "error")
                                                          for p in PERCENTILES), "failures"], rows)

    default = runs.find("c_abi", default_tolerance=1, tangent=0)
    table("single", f"Single calls, C ABI, default tolerance {default[0]['tolerance']:.0e}", default)
    table("single 1e-6", "Single calls, C ABI, tolerance 1e-6", runs.find("c_abi", tolerance=1e-6, default_tolerance=0))
    table("single tangent", "Single calls, C ABI, default tolerance, consistent tangent",
          runs.find("c_abi", default_tolerance=1, tangent=2))
    umats = [f for f in runs.families() if f not in ("exp", "c_abi")]
    for name in umats:
        for tangent, words in ((0, ""), (2, ", with its tangent")):
            table(f"{name}{words}", f"Single calls, {name}{words}", runs.find(name, tangent=tangent))
    rows = []
    for r in default:
        at = {"increment": r["increment"]}
        row = [power(r["increment"]), runs.ns("c_abi", default_tolerance=1, tangent=2, **at) / r["best_ns"]]
        for name in umats:
            alone, tangent = (runs.ns(name, tangent=t, **at) for t in (0, 2))
            row += [alone and (alone - r["best_ns"]) / 1e3, tangent / r["best_ns"]]
        rows.append(row)
    columns = ["increment", "C ABI with tangent"]
    for name in umats:
        columns += [f"{name}: µs on top", f"{name} with tangent"]
    report.table("multiples", "Beside the C ABI without tangent: its time with the consistent tangent, and of UMATs, as "
                 "multiples; and what umat_ adds", columns, rows)
    write_csv(folder / "work_precision.csv", ["increment", "tolerance", "exp", "error_p50", "error_max"],
              [[r["increment"], r["tolerance"], r["best_ns"] / runs.exp, r["error_p50"], r["error_max"]]
               for r in runs.find("c_abi", default_tolerance=0)])
    fastest = {(name, r["increment"]): r for name in umats for t in (2, 0)
               for r in runs.find(name, tangent=t) if "error_p50" in r}
    write_csv(folder / "work_precision_umat.csv", ["umat", "increment", "exp", "error_p50"],
              [[umats.index(name) + 1, r["increment"], r["best_ns"] / runs.exp, r["error_p50"]]
               for (name, _), r in fastest.items()])
    return umats


def batches(report, runs, folder):
    names = {1: "baseline", 2: "AVX2", 3: "AVX-512"}
    used = sorted({r["instruction_set"] for r in runs.find("batch")})
    rows = []
    for increment in dict.fromkeys(r["increment"] for r in runs.find("batch")):
        ns = [runs.ns("batch", increment=increment, instruction_set=i) for i in used]
        rows.append([power(increment), *(x / 1e3 for x in ns), *(x / runs.exp for x in ns),
                     runs.ns("structures", increment=increment) / runs.exp,
                     runs.faster_by(increment=increment)])
    report.table("batches", "Batches of 10^4 points, per point, default tolerance",
                 ["increment", *(f"{names[i]} µs" for i in used), *(f"{names[i]} exp" for i in used),
                  f"{names[used[-1]]} exp, structures", "two threads: faster by"],
                 [*rows, ["std::exp", *[None] * (2 * len(used) + 1), runs.faster_by(increment=None)]])
    report.table("wave moduli", "Wave moduli, per point", ["", "ns"],
                 [["one point per call", runs.ns("wave_moduli", together=0)],
                  ["320 points per call", runs.ns("wave_moduli", together=1)]])
    growth = runs.find("growth")
    write_csv(folder / "growth_sand.csv", ["increment", "points", "ns"],
              sorted([r["increment"], r["per_call"], r["best_ns"]] for r in growth))


def contact(report, runs):
    triad = min(runs.find("triad"), key=lambda run: run["best_ns"])
    per_byte = triad["best_ns"] / triad["bytes"]
    report.table("contact", "Contact, 10^6 nodes, beside the triad a = b + s c",
                 ["", "ns per node", "bytes per node", "ns of the bytes", "ratio"],
                 [[f"triad: {1 / per_byte:.1f} GB/s", triad["best_ns"], triad["bytes"], triad["best_ns"], 1.0]]
                 + [[r["family"], r["best_ns"], r["bytes"], r["bytes"] * per_byte,
                     r["best_ns"] / (r["bytes"] * per_byte)]
                    for r in runs.all if r["family"] not in ("exp", "triad")])


def surfaces(report, runs):
    sizes = sorted({run["vertices"] for run in runs.all if "vertices" in run and run["family"].startswith("surface")})
    families = [name for name in runs.families() if name != "exp"]
    report.table("surface contact", "Contact along lines, per vertex [ns]; free edges of 100, 1024 and 10^4 domains",
                 ["", *(f"{size:.0f} vertices" for size in sizes), "exp"],
                 [[name, *times, times[0] / runs.exp] for name in families
                  for times in [[run["best_ns"] for run in runs.find(name)]]])


def pushes(report, runs):
    gated = runs.ns("GCA, gated")
    report.table("contact in a push", "A step of a pile push with each contact, one thread",
                 ["", "ms per step", "of gated GCA"],
                 [[run["family"], 1e-6 * run["best_ns"], run["best_ns"] / gated] for run in runs.all if "steps" in run])


def particles(report, runs, folder):
    report.table("particles", "Material points, 6400 particles, per particle and step", ["", "threads", "ns", "exp"],
                 [[r["family"], r["threads_used"], r["best_ns"], r["best_ns"] / runs.exp]
                  for r in runs.all if "particles" in r and r["family"] != "growth"])
    write_csv(folder / "growth_mpm.csv", ["sand", "particles", "ns"],
              sorted([r["sand"], r["particles"], r["best_ns"]] for r in runs.find("growth")))


def lines_of(path):
    return path.read_text().splitlines() if path.exists() else []


def for_pictures(path, parts, memory, umats):
    """Variables of gnuplot: cache sizes and memory per particle [bytes], names of UMATs."""
    lines = [f"L{level} = {size}.0" for level, size in next(iter(parts.values())).caches.items()]
    lines += [f"particle_{m['material']} = {m['resident_bytes_per_particle']}.0" for m in memory]
    lines += [f"umats = {len(umats)}", "array umat[16]"]
    lines += [f"umat[{i + 1}] = '{name}'" for i, name in enumerate(umats)]
    path.write_text("\n".join(lines) + "\n")


def machine(report, parts):
    """The processor, and one dependent exp in the runs of each program."""
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
    processor = next((line.split(": ", 1)[1] for line in lines if line.startswith("model name")), "?")
    runs = next(iter(parts.values()))
    sizes = ", ".join(f"L{level} {size / 1024:.0f} KiB" for level, size in runs.caches.items())
    report.table("machine", "The machine", ["", ""], [
        ["processor", processor], ["clock that the system tells", f"{runs.mhz} MHz"], ["caches", sizes],
        *([f"a dependent std::exp in {name}", f"{r.exp:.2f} ns"] for name, r in parts.items())])


def main(folder, document=None):
    report, umats = Report(), []
    names = [name for name in ("sand_calls", "sand_batches", "contact_cost", "surface_cost", "mpm_step", "contact_push")
             if (folder / f"{name}.json").exists()]
    parts = {name: Runs(folder / f"{name}.json") for name in names}
    if parts:
        machine(report, parts)
    if "sand_calls" in parts:
        umats = single_calls(report, parts["sand_calls"], folder)
    if "sand_batches" in parts:
        batches(report, parts["sand_batches"], folder)
    if "contact_cost" in parts:
        contact(report, parts["contact_cost"])
    if "surface_cost" in parts:
        surfaces(report, parts["surface_cost"])
    if "contact_push" in parts:
        pushes(report, parts["contact_push"])
    if "mpm_step" in parts:
        particles(report, parts["mpm_step"], folder)
    memory = [json.loads(line) for line in lines_of(folder / "mpm_memory.txt")]
    report.table("memory", "Memory per particle, nodes included", ["", "bytes", "bytes at most"],
                 [[m["material"], m["resident_bytes_per_particle"], m["peak_bytes_per_particle"]]
                  for m in memory])
    report.table("pile push", "A pile push of 6570 particles",
                 ["threads", "steps", "simulated s", "s of computing", "s per simulated s",
                  "ns per particle and step"],
                 [[*line.split()] for line in lines_of(folder / "pile_push.txt")])
    report.table("instructions", "Instructions per point (callgrind)", ["increment", "", "baseline", "AVX2"],
                 [line.split("\t") for line in lines_of(folder / "instructions.txt")])
    report.write(folder)
    if document:
        report.put_into(document)
    if parts:
        for_pictures(folder / "pictures.gp", parts, memory, umats)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*map(pathlib.Path, sys.argv[1:]))
