#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""figures.py RESULTS [--to DIR] [--group GROUP]: the pictures of docs/pile.md from the members of an ensemble, which lie in
RESULTS; gnuplot draws them. A figure whose runs are missing is left out, and said so."""
import argparse
import math
import pathlib
import statistics
import subprocess
import sys

from ensemble import CONTACTS, SANDS
from measures import BIN, DIAMETER, PEAK, RADIUS, level_of_tip, sets
from results import Run, Unusable
from whole_file import whole_file

INK = "#222222"
COLOURS = {"fca": "#D55E00", "gca": "#0072B2", "pca": "#009E73", "surface": "#AA4499"}
NAMES = {"fca": "FCA", "gca": "GCA", "pca": "PCA", "surface": "surface contact"}
ORDER = ("fca", "gca", "pca", "surface")
HEAD = f"""set encoding utf8
set border 15 lw 1 lc rgb '#444444'
set tics nomirror out scale 0.6 textcolor rgb '{INK}'
"""
PALETTES = {  # light to dark; and, as in the paper, red where sand is denser, blue where it is looser
    "stress": "set palette defined (0 '#fcfdbf', 0.25 '#fe9f6d', 0.5 '#de4968', 0.75 '#8c2981', 1 '#150e37')",
    "change": "set palette defined (-1 '#b2182b', -0.4 '#f4a582', 0 '#f7f7f7', 0.4 '#92c5de', 1 '#2166ac')",
}
SAMPLES = (0.125, 0.375, 0.625, 0.875)  # of the sides of a particle


def gnuplot(script, target, width, height):
    """PNG for fields, SVG for curves; there whole or not at all."""
    terminal = (f"pngcairo size {2 * width},{2 * height} fontscale 2 linewidth 2 pointscale 2 font 'sans,10'"
                if target.suffix == ".png" else f"svg size {width},{height} font 'sans,12' background rgb 'white'")
    with whole_file(target) as path:
        text = f"set terminal {terminal}\nset output '{path}'\n" + HEAD + script + "\nunset output\n"
        done = subprocess.run(["gnuplot"], input=text, text=True, capture_output=True)
        if done.returncode != 0 or path.stat().st_size == 0:
            raise Unusable(f"{target.name}: gnuplot failed: {done.stderr.strip()}")
    print(f"figures.py: {target}")


def block(name, rows):
    return f"${name} << EOD\n" + "\n".join(rows) + "\nEOD\n"


class Members:
    """The runs of each case of a group that are done."""

    def __init__(self, folder, group):
        self.folder, self.group, self.have = folder, group, {}

    def __call__(self, case):
        if case not in self.have:
            names = sorted(p.stem for p in self.folder.glob(f"{self.group}_{case}-*.csv")
                           if not p.with_suffix(".checkpoint").exists())
            if not names:
                raise Unusable(f"{self.folder}: no run of {self.group}_{case}")
            self.have[case] = [Run(self.folder, name) for name in names]
        return self.have[case]

    def sands(self):
        """Those that every contact has a run with."""
        return [sand for sand in SANDS
                if all(any(self.folder.glob(f"{self.group}_{sand}_{contact}-*.csv")) for contact in CONTACTS)]


def raster(run, index, values, window):
    """{(i, j): [weight, weight x value]} over squares of BIN in axes from the tip: each square takes what of a particle's
    area lies in it."""
    frame, tip = run.frame(index), level_of_tip(run, index)
    r0, r1, z0, z1 = window
    out = {}
    for quad, value, area in zip(frame.corners, values, frame.areas()):
        if not (r0 - BIN <= min(r for r, _ in quad) and max(r for r, _ in quad) <= r1 + 0.5
                and z0 - 0.5 <= quad[0][1] - tip <= z1 + 0.5):
            continue
        (ar, az), (br, bz), (cr, cz), (dr, dz) = quad
        for s in SAMPLES:
            for t in SAMPLES:
                a, b, c, d = (1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t
                r, z = a * ar + b * br + c * cr + d * dr, a * az + b * bz + c * cz + d * dz - tip
                if r0 <= r < r1 and z0 <= z < z1:
                    cell = out.setdefault((math.floor(r / BIN), math.floor(z / BIN)), [0.0, 0.0])
                    cell[0] += area * r
                    cell[1] += area * r * value
    return out


def mean_field(runs, index_of, values_of, window):
    """Rows "r z value" of the means over all runs."""
    total = {}
    for run in runs:
        index = index_of(run)
        for at, (weight, value) in raster(run, index, values_of(run, index), window).items():
            cell = total.setdefault(at, [0.0, 0.0])
            cell[0] += weight
            cell[1] += value
        run.forget()
    r0, r1, z0, z1 = window
    rows = []
    for j in range(round(z0 / BIN), round(z1 / BIN)):
        for i in range(round(r0 / BIN), round(r1 / BIN)):
            weight, value = total.get((i, j), (0.0, 0.0))
            inside = (i + 1) * BIN <= RADIUS + 1e-9 and j >= 0
            rows.append(f"{(i + 0.5) * BIN:.4g} {(j + 0.5) * BIN:.4g} "
                        f"{value / weight if weight > 0.0 and not inside else math.nan:.5g}")
        rows.append("")
    return rows


def fields(members, target, title, index_of, values_of, window, contours, colours, marks=""):
    """A row of panels for each sand, a panel for each contact: squares in colour and contours."""
    sands = members.sands()
    if not sands:
        raise Unusable(f"{members.folder}: a sand has runs of {members.group} with each contact")
    data, script = "", "unset key\n"
    height = 0.84 / len(sands)
    r0, r1, z0, z1 = window
    for row, sand in enumerate(sands):
        for column, contact in enumerate(ORDER):
            name, runs = f"{sand}_{contact}", members(f"{sand}_{contact}")
            data += block(name, mean_field(runs, index_of, values_of, window))
            data += (f"set contour base; unset surface; set cntrparam levels discrete {', '.join(map(str, contours))}\n"
                     f"set table ${name}_lines; splot ${name}; unset table; unset contour; set surface\n")
            left, top = 0.07 + 0.205 * column, 0.94 - (height + 0.02) * row
            script += f"""set lmargin at screen {left}; set rmargin at screen {left + 0.19}
set tmargin at screen {top}; set bmargin at screen {top - height + 0.06}
set xrange [{r0}:{r1}]; set yrange [{z0}:{z1}]
set title "{title}{sand}, {NAMES[contact]}, {len(runs)} run{'s' * (len(runs) > 1)}" offset 0,-0.7
set xlabel "{'r [m]' if row == len(sands) - 1 else ''}" offset 0,0.6
set ylabel "{'z − tip [m]' if column == 0 else ''}" offset 1,0
set format y '{'%g' if column == 0 else ''}'; set xtics 0,0.3,{r1 - 0.1} offset 0,0.3; set ytics 0.3
set object 1 rectangle from 0,0 to {RADIUS},{z1} fillcolor rgb '#b8b8b8' fillstyle solid noborder behind
{marks}
{'unset colorbox' if row or column < 3 else f'set colorbox user origin screen 0.9,{0.94 - 0.86:.3f} size screen 0.014,0.84'}
plot ${name} using 1:2:3 with image, ${name}_lines using 1:2 with lines lw 0.8 lc rgb '#111111'
"""
    gnuplot(data + colours + "set multiplot\n" + script + "unset multiplot", target, 1100, 90 + 330 * len(sands))


def peak_of_last_blow(run):
    first, _ = run.history.blows()[-1]
    return run.frame_near(run.history["t"][first] + PEAK)


def draw_radial_stress(members, to):
    levels = (20, 50, 100, 200)
    fields(members, to / "radial_stress.png", "", peak_of_last_blow,
           lambda run, index: [-s for s in run.frame(index)["stress_rr"]], (0.0, 1.2, -0.9, 0.9), levels,
           f"{PALETTES['stress']}\nset cbrange [0:300]\n"
           f"set cbtics ({', '.join(f'{chr(39)}{v}{chr(39)} {v}' for v in (0, *levels))}, '≥ 300' 300)\n"
           "set cblabel '-σ_{rr} at the peak of the last blow [kPa]' offset 0.5,0\n")


def draw_void_ratio(members, to):
    def change(run, index):
        return [a - b for a, b in zip(run.frame(index)["void_ratio"], run.frame(0)["void_ratio"])]
    reach = RADIUS + 3.0 * DIAMETER
    fields(members, to / "void_ratio.png", "", lambda run: len(run.files) - 1, change, (0.0, 1.5, -0.9, 0.9), (-0.01, 0.01),
           f"{PALETTES['change']}\nset cbrange [-0.1:0.1]\nset cbtics ('≤ −0.1' -0.1, '−0.05' -0.05, '−0.01' -0.01, '0.01' 0.01, "
           "'0.05' 0.05, '≥ 0.1' 0.1)\nset cblabel 'change of void ratio at the end [-]' offset 0.5,0\n",
           f"set arrow 1 from {reach},-0.9 to {reach},0.9 nohead dt 2 lw 1 lc rgb '#444444' front\n"
           f"set arrow 2 from 0,{-0.5 * DIAMETER} to 0.5,{-0.5 * DIAMETER} nohead dt 2 lw 1 lc rgb '#444444' front\n"
           f"set label 1 '3 D' at {reach + 0.03},-0.8 textcolor rgb '#444444' front\n"
           f"set label 2 '½ D' at 0.52,{-0.5 * DIAMETER} textcolor rgb '#444444' front")


def outlines(frame, window):
    r0, r1, z0, z1 = window
    out = []
    for quad in frame.corners:
        r, z = sum(c[0] for c in quad) / 4, sum(c[1] for c in quad) / 4
        if r0 - 0.1 <= r <= r1 + 0.1 and z0 - 0.1 <= z <= z1 + 0.1:
            out += [f"{x:.5g} {y:.5g}" for x, y in (*quad, quad[0])] + [""]
    return out


def draw_setup(members, to):
    run = members("dense_gca")[0]
    h = run.history
    first = h.drive()
    area = math.pi * RADIUS**2
    load = [f"{h['t'][i] - h['t'][first]:.4f} {h['hammer_force'][i] / area:.3f}"
            for i in range(first, len(h)) if h["t"][i] - h["t"][first] < 1.25]
    near = (0.0, 0.6, -1.1, 0.2)
    data = block("load", load) + "".join(block(body, outlines(run.frame(0, body), near)) for body in ("sand", "pile"))
    rollers = [f"5.12 {z:.3f}" for z in (-0.5 - 0.9 * k for k in range(11))]
    ground = [f"{r:.3f} -10.05\n{r - 0.25:.3f} -10.4\n" for r in (0.25 + 0.25 * k for k in range(20))]
    data += block("rollers", rollers) + block("ground", ground)

    def dimension(x0, y0, x1, y1, text, at):
        return (f"set arrow from {x0},{y0} to {x1},{y1} heads size 0.12,20 lw 0.7 lc rgb '#444444' front\n"
                f"set label '{text}' at {at[0]},{at[1]} {at[2]} textcolor rgb '#444444' front\n")

    whole = (dimension(0, -10.9, 5, -10.9, "5 m", (2.5, -11.5, "center")) + dimension(4.3, -10, 4.3, 0, "10 m", (4.2, -5, "right"))
             + dimension(0.75, -0.5, 0.75, 4.5, "5 m", (0.9, 2.4, "left")) + dimension(1.3, -0.5, 1.3, 0, "0.5 m", (1.45, -0.28, "left"))
             + "".join(f"set arrow from {x},5.3 to {x},4.55 head size 0.1,25 lw 1 lc rgb '#D55E00' front\n" for x in (0.03, 0.13))
             + "set label 'σ(t)' at 0.3,5.1 textcolor rgb '#D55E00'\n"
             "set label 'axis' at -0.12,-5 rotate center textcolor rgb '#444444'\n"
             "set label 'no velocity across (roller)' at 5.5,-5 rotate center textcolor rgb '#444444'\n"
             "set label 'no velocity at all' at 2.5,-9.6 center textcolor rgb '#444444'\n"
             "set label 'sand' at 2.2,-3 textcolor rgb '#6b4d10'\nset label 'pile, radius 0.15 m' at 0.9,3.9 textcolor rgb '#333333'\n")
    gnuplot(data + "unset key\nset multiplot\n"
            "set lmargin at screen 0.01; set rmargin at screen 0.33; set bmargin at screen 0.01; set tmargin at screen 0.93\n"
            "unset border; unset tics; set xrange [-0.5:5.8]; set yrange [-11.9:5.6]\nset title 'Supports, load, dimensions'\n"
            "set object 1 rectangle from 0,-10 to 5,0 fillcolor rgb '#ecdcb8' fillstyle solid border lc rgb '#b08030' behind\n"
            "set object 2 rectangle from 0,-0.5 to 0.15,4.5 fillcolor rgb '#888888' fillstyle solid border lc rgb '#333333' front\n"
            "set arrow from 0,-10 to 0,5.4 nohead dt 4 lw 0.8 lc rgb '#444444' front\n" + whole +
            "plot $rollers with points pt 6 ps 0.7 lc rgb '#444444', $ground with lines lw 0.8 lc rgb '#444444'\n"
            "unset arrow; unset label; unset object\nset border 15; set tics\n"
            "set lmargin at screen 0.42; set rmargin at screen 0.66; set bmargin at screen 0.12; set tmargin at screen 0.93\n"
            f"set xrange [{near[0]}:{near[1]}]; set yrange [{near[2]}:{near[3]}]; set xtics 0.2; set ytics 0.2\n"
            f"set title 'Around the tip: {run.frame(0).count} + {run.frame(0, 'pile').count} particles'\n"
            "set xlabel 'r [m]'; set ylabel 'z [m]' offset 1,0\n"
            "plot $sand with lines lw 0.4 lc rgb '#b08030', $pile with lines lw 0.6 lc rgb '#333333'\n"
            "set lmargin at screen 0.76; set rmargin at screen 0.98; set bmargin at screen 0.3; set tmargin at screen 0.75\n"
            "set title 'Load on the head'; set xlabel 't since the drive began [s]'; set ylabel 'σ [kPa]' offset 1,0\n"
            "set xrange [0:1.2]; set yrange [0:1100]; set xtics 0.4; set ytics 500\n"
            f"plot $load using 1:2 with lines lw 1.5 lc rgb '{COLOURS['fca']}'\nunset multiplot",
            to / "setup.png", 1000, 560)


def two_panels(members, sands, target, x_label, y_label, lines, extra=""):
    """A panel for each sand; lines(sand, contact): data rows and what follows "plot" for them."""
    data, script = "", ""
    for k, sand in enumerate(sands):
        plots = []
        for contact in ORDER:
            rows, how = lines(sand, contact)
            data += block(f"{sand}_{contact}", rows)
            plots += [part.replace("$D", f"${sand}_{contact}") for part in how]
        deepest = max(run.history["depth"][-1] for contact in ORDER for run in members(f"{sand}_{contact}"))
        script += f"set yrange [{1.05 * deepest:.3f}:0]\n"
        script += f"set title '{sand}, e = {SANDS[sand]:g}'; set xlabel '{x_label}'; set ylabel '{y_label if k == 0 else ''}'\n{extra}"
        script += "plot " + ", ".join(plots) + "\n"
    gnuplot(data + f"set multiplot layout 1,{len(sands)} margins {0.18 / len(sands):.3f},0.97,0.14,0.9 spacing 0.1\n"
            "set grid lc rgb '#dddddd'\nset key top right samplen 2\n" + script + "unset multiplot", target, 450 * len(sands), 440)


def mean_and_deviation(values):
    return statistics.fmean(values), statistics.stdev(values) if len(values) > 1 else 0.0


def draw_penetration(members, to):
    """Depth after each blow, mean and band of a standard deviation."""
    def lines(sand, contact):
        depths = []
        for run in members(f"{sand}_{contact}"):
            own, each, _ = sets(run.history)
            depths.append([own + sum(each[:k]) for k in range(len(each) + 1)])
        rows = []
        for k in range(min(map(len, depths))):
            mean, deviation = mean_and_deviation([d[k] for d in depths])
            rows.append(f"{k} {mean:.5f} {mean - deviation:.5f} {mean + deviation:.5f}")
        colour = COLOURS[contact]
        return rows, [f"$D using 1:3:4 with filledcurves fillcolor rgb '{colour}' fillstyle transparent solid 0.25 notitle",
                      f"$D using 1:2 with linespoints pt 7 ps 0.4 lw 1.5 lc rgb '{colour}' title '{NAMES[contact]}'"]
    two_panels(members, members.sands(), to / "penetration.svg", "blows", "penetration since the start [m]", lines,
               "set xtics 1\n")


def draw_forces(members, to):
    """Tip and shaft where the reaction of a blow is largest, over depth."""
    def lines(sand, contact):
        found = []
        for run in members(f"{sand}_{contact}"):
            h, rows = run.history, []
            for first, last in h.blows():
                top = max(range(first, last + 1), key=lambda i: h["tip_force"][i] + h["shaft_force"][i])
                rows.append((h["depth"][top], h["tip_force"][top], h["shaft_force"][top]))
            found.append(rows)
        rows = []
        for blow in range(min(map(len, found))):
            (depth, _), (tip, of_tip), (shaft, of_shaft) = (mean_and_deviation([rows[blow][k] for rows in found]) for k in range(3))
            rows.append(f"{depth:.5f} {tip:.3f} {of_tip:.3f} {shaft:.3f} {of_shaft:.3f}")
        colour = COLOURS[contact]
        return rows, [f"$D using 2:1:3 with xerrorbars pt 7 ps 0.4 lc rgb '{colour}' notitle",
                      f"$D using 2:1 with lines lw 1.5 lc rgb '{colour}' title '{NAMES[contact]}'",
                      f"$D using 4:1:5 with xerrorbars pt 6 ps 0.4 lc rgb '{colour}' notitle",
                      f"$D using 4:1 with lines dt 2 lw 1.5 lc rgb '{colour}' notitle"]
    two_panels(members, members.sands(), to / "forces.svg", "at the largest R of a blow [kN]: shaft - -, tip —",
               "penetration since the start [m]", lines, "set key top center\n")


def draw_reaction(members, to, blow=3):
    """R(t) of one blow in dense sand, all runs."""
    data, script = "", ""
    for k, contact in enumerate(ORDER):
        plots = []
        for number, run in enumerate(members(f"dense_{contact}")):
            h = run.history
            first, last = h.blows()[blow - 1]
            data += block(f"{contact}{number}", [f"{h['t'][i] - h['t'][first]:.4f} {h['tip_force'][i] + h['shaft_force'][i]:.3f} "
                                                 f"{h['hammer_force'][i]:.3f}" for i in range(first, last + 1)])
            plots.append(f"${contact}{number} using 1:2 with lines lw 0.8 lc rgb '{COLOURS[contact]}'")
        weight = run.history.mass * 9.81e-3
        plots.append(f"${contact}0 using 1:3 with lines lw 1.2 dt 2 lc rgb '#444444'")
        plots.append(f"{weight:.2f} with lines lw 0.8 dt 3 lc rgb '#888888'")
        script += (f"set title '{NAMES[contact]}'; set xlabel 't since the blow began [s]'\n"
                   f"set ylabel '{'R, hammer - -, weight ··· [kN]' if k == 0 else ''}'\nplot " + ", ".join(plots) + "\n")
    gnuplot(data + "set multiplot layout 1,4 margins 0.07,0.98,0.17,0.89 spacing 0.045\nset grid lc rgb '#dddddd'\nunset key\n"
            "set xrange [0:0.4]; set xtics 0.1; set yrange [-5:110]; set ytics 20\n" + script + "unset multiplot", to / "reaction.svg", 1100, 330)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--to", type=pathlib.Path, help="folder of the pictures; default: that of the results")
    parser.add_argument("--group", default="coarse", help="of ensemble.py; default: coarse")
    options = parser.parse_args()
    to = options.to or options.results
    to.mkdir(parents=True, exist_ok=True)
    members = Members(options.results, options.group)
    for draw in (draw_setup, draw_radial_stress, draw_void_ratio, draw_penetration, draw_forces, draw_reaction):
        try:
            draw(members, to)
        except Unusable as problem:
            print(f"figures.py: left out: {problem}", file=sys.stderr)


if __name__ == "__main__":
    main()
