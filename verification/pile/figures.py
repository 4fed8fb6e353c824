#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""figures.py RESULTS [--to DIR]: the paper's figures from the runs of verification/pile, and a strip of frames; gnuplot
draws them. A figure whose runs are missing is left out, and said so."""
import argparse
import math
import pathlib
import subprocess
import sys

from measures import PEAK, level_of_tip, sets
from results import Run, Unusable
from whole_file import whole_file

INK = "#222222"
BLUE, ORANGE, GREEN, GREY = "#0072B2", "#D55E00", "#009E73", "#888888"
HEAD = f"""set encoding utf8
set border 15 lw 1 lc rgb '#444444'
set tics nomirror out scale 0.6 textcolor rgb '{INK}'
"""
NEARER = "offset 0,1.2; set xlabel offset 0,1.8"  # to the axis of a tall panel, whose labels hang low
PALETTES = {  # light to dark; and, as in the paper, red where sand is denser, blue where it is looser
    "stress": "set palette defined (0 '#fcfdbf', 0.25 '#fe9f6d', 0.5 '#de4968', 0.75 '#8c2981', 1 '#150e37')",
    "change": "set palette defined (-1 '#b2182b', -0.4 '#f4a582', 0 '#f7f7f7', 0.4 '#92c5de', 1 '#2166ac')",
}


def gnuplot(script, target, width, height):
    """PNG for fields, SVG for curves; there whole or not at all."""
    terminal = (f"pngcairo size {2 * width},{2 * height} fontscale 2 linewidth 2 pointscale 2 font 'sans,11'"
                if target.suffix == ".png" else f"svg size {width},{height} font 'sans,12' background rgb 'white'")
    with whole_file(target) as path:
        text = f"set terminal {terminal}\nset output '{path}'\n" + HEAD + script + "\nunset output\n"
        done = subprocess.run(["gnuplot"], input=text, text=True, capture_output=True)
        if done.returncode != 0 or path.stat().st_size == 0:
            raise Unusable(f"{target.name}: gnuplot failed: {done.stderr.strip()}")
    print(f"figures.py: {target}")


def block(name, rows):
    return f"${name} << EOD\n" + "\n".join(rows) + "\nEOD\n"


def surfaces(frame, values, window, sides=(1.0,)):
    """A pm3d surface for each particle in sight."""
    r0, r1, z0, z1 = window
    out = []
    for quad, value in zip(frame.corners, values):
        for side in sides:
            r = side * sum(c[0] for c in quad) / 4
            z = sum(c[1] for c in quad) / 4
            if not (r0 <= r <= r1 and z0 <= z <= z1):
                continue
            a, b, c, d = [f"{side * x:.5g} {y:.5g} {value:.5g}" for x, y in quad]
            out += [a, b, "", d, c, "", ""]
    return out


def outlines(frame, window, sides=(1.0,)):
    r0, r1, z0, z1 = window
    out = []
    for quad in frame.corners:
        for side in sides:
            r, z = side * sum(c[0] for c in quad) / 4, sum(c[1] for c in quad) / 4
            if r0 <= r <= r1 and z0 <= z <= z1:
                out += [f"{side * x:.5g} {y:.5g} 0" for x, y in (*quad, quad[0])] + ["", ""]
    return out


def field(name, run, index, values, window, sides=(1.0,), lines=False):
    """Data of a panel: the pile grey, and the sand in colour over it; and the splot that shows them."""
    sand, pile = run.frame(index), run.frame(index, "pile")
    text = block(name, surfaces(sand, values, window, sides))
    text += block(name + "_pile", surfaces(pile, [0.0] * pile.count, window, sides))
    plots = [f"${name}_pile using 1:2:3:(0xb8b8b8) with pm3d fillcolor rgb variable", f"${name} using 1:2:3 with pm3d"]
    if lines:
        text += block(name + "_lines", outlines(sand, window, sides))
        plots.append(f"${name}_lines using 1:2:3 with lines lw 0.4 lc rgb '#666666'")
    return text, "splot " + ", ".join(plots)


def stress_scale(top, screen):
    """Colours from 0 to top, which also stands for more."""
    steps = ", ".join(f"'{v}' {v}" for v in range(0, top, 100))
    return (f"set colorbox user origin screen {screen[0]},{screen[1]} size screen {screen[2]},{screen[3]}\n"
            f"set cbtics ({steps}, '≥ {top}' {top}); set cblabel 'total -σ_{{rr}} [kPa]' offset 1,0\n")


def panel(window, screen, title, x_label="r [m]", y_label="z [m]"):
    left, right, bottom, top = screen
    return f"""set lmargin at screen {left}; set rmargin at screen {right}
set bmargin at screen {bottom}; set tmargin at screen {top}
set xrange [{window[0]}:{window[1]}]; set yrange [{window[2]}:{window[3]}]
set title "{title}" offset 0,-0.5
set xlabel "{x_label}" offset 0,1.0; set ylabel "{y_label}" offset -0.4,0
set xtics offset 0,0.5
"""


def draw_setup(runs, to):
    run = runs("dense_gca")
    whole, near = (0, 5, -10, 4.6), (0, 0.6, -1.1, 0.2)
    t = run.history["t"]
    first = run.history.drive()
    load = [f"{t[i] - t[first]:.4f} {run.history['hammer_force'][i] / (math.pi * 0.15**2):.3f}"
            for i in range(first, len(t)) if t[i] - t[first] < 1.25]
    data = block("load", load)
    plots = []
    for name, window in (("whole", whole), ("near", near)):
        for body, colour in (("sand", "#b08030"), ("pile", "#555555")):
            data += block(f"{name}_{body}", outlines(run.frame(0, body), window))
        plots.append(f"splot $ {name}_sand using 1:2:3 with lines lw 0.4 lc rgb '#b08030', "
                     f"${name}_pile using 1:2:3 with lines lw 0.4 lc rgb '#555555'".replace("$ ", "$"))
    sand, pile = run.frame(0).count, run.frame(0, "pile").count
    gnuplot(data + "unset key; set view map; set multiplot\n"
            + panel(whole, (0.09, 0.34, 0.12, 0.92), f"{sand} sand, {pile} pile particles") + f"set xtics 1 {NEARER}\n"
            + plots[0] + "\n"
            + panel(near, (0.44, 0.67, 0.12, 0.92), "around the tip") + f"set xtics 0.2 {NEARER}\n" + plots[1] + "\n"
            + "unset view\nset lmargin at screen 0.78; set rmargin at screen 0.98; set bmargin at screen 0.12\n"
              "set tmargin at screen 0.5; set format x '%g'; set xtics offset 0,0; set title 'Traction on the head'; set xlabel 't [s]' offset 0,0; "
              "set ylabel 'stress [kPa]' offset 0.5,0\nset xrange [0:1.2]; set yrange [0:1100]; set xtics 0.4\n"
              f"plot $load using 1:2 with lines lw 1.5 lc rgb '{BLUE}'\nunset multiplot",
            to / "setup.png", 900, 620)


def peak_of_blow(run, blow):
    first, _ = run.history.blows()[blow - 1]
    return run.frame_near(run.history["t"][first] + PEAK)


def draw_radial_stress(runs, to):
    pair = [("frictional (FCA)", runs("dense_fca")), ("Geo-contact (GCA)", runs("dense_gca"))]
    blow = min(len(run.history.blows()) for _, run in pair)
    data, plots, tops = "", [], []
    low = min(level_of_tip(run, peak_of_blow(run, blow)) for _, run in pair) - 1.6
    window = (-1.2, 1.2, low, 0.4)
    for i, (_, run) in enumerate(pair):
        index = peak_of_blow(run, blow)
        values = [-s for s in run.frame(index)["stress_rr"]]
        tops.append(sorted(values)[int(0.998 * len(values))])
        text, plot = field(f"p{i}", run, index, values, window, (1.0, -1.0))
        data, plots = data + text, plots + [plot]
    top = 100 * math.ceil(max(tops) / 100.0)
    script = data + f"unset key; set pm3d map corners2color c1\n{PALETTES['stress']}\nset cbrange [0:{top}]\nset multiplot\n"
    for i, plot in enumerate(plots):
        left = 0.08 + 0.43 * i
        script += panel(window, (left, left + 0.35, 0.12, 0.92), f"{pair[i][0]}, peak of blow {blow}",
                        y_label="z [m]" if i == 0 else "")
        script += "unset colorbox\n" if i == 0 else \
            stress_scale(top, (0.88, 0.12, 0.02, 0.8))
        script += plot + "\n"
    gnuplot(script + "unset multiplot", to / "radial_stress.png", 900, 560)


def depth_rows(run):
    h = run.history
    return [f"{t:.4f} {d:.5f}" for t, d in list(zip(h["t"], h["depth"]))[::3]]


def draw_penetration(name, pair, to, close_up):
    """Depth against time; below each other: whole, and blows close_up."""
    data, plots = "", []
    for i, (label, colour, run) in enumerate(pair):
        data += block(f"d{i}", depth_rows(run))
        plots.append(f"$d{i} using 1:2 with lines lw 1.5 lc rgb '{colour}' title '{label}'")
    blows = pair[0][2].history.blows()
    t = pair[0][2].history["t"]
    close_up = [min(k, len(blows)) for k in close_up]
    first, last = (blows[k - 1] for k in close_up)
    t0, t1 = t[first[0]], t[last[1]]
    near = [d for _, _, run in pair for s, d in zip(run.history["t"], run.history["depth"]) if t0 <= s <= t1]
    end = max(run.history["t"][-1] for _, _, run in pair)
    gnuplot(data + "set multiplot layout 1,2 margins 0.11,0.97,0.14,0.9 spacing 0.11\nset key bottom left samplen 2\n"
            "set grid lc rgb '#dddddd'; set xlabel 'time [s]'; set ylabel 'penetration since the start [m]'\n"
            f"set xrange [0:{end:.2f}]; set yrange [0:*] reverse\nset title 'Self-weight and blows'\n"
            "plot " + ", ".join(plots) + "\n"
            f"unset key; set xrange [{t0}:{t1}]; set yrange [{max(near) + 0.01:.3f}:{min(near) - 0.01:.3f}] noreverse\n"
            f"set title 'Blows {close_up[0]} to {close_up[1]}'\nunset ylabel\nplot " + ", ".join(plots) + "\nunset multiplot",
            to / f"{name}.svg", 900, 420)


def draw_close_up(runs, to):
    """Particles beside the pile, where the paper's FCA oscillates."""
    pair = [("frictional (FCA)", runs("dense_fca")), ("Geo-contact (GCA)", runs("dense_gca"))]
    blow = min(len(run.history.blows()) for _, run in pair)
    data, plots = "", []
    for i, (_, run) in enumerate(pair):
        index = peak_of_blow(run, blow)
        tip = level_of_tip(run, index)
        window = (0.0, 0.5, tip - 0.35, tip + 0.55)
        text, plot = field(f"p{i}", run, index, [-s for s in run.frame(index)["stress_rr"]], window, lines=True)
        data, plots = data + text, plots + [(window, plot)]
    script = data + f"unset key; set pm3d map corners2color c1\n{PALETTES['stress']}\nset cbrange [0:600]\nset multiplot\n"
    for i, (window, plot) in enumerate(plots):
        left = 0.09 + 0.43 * i
        script += panel(window, (left, left + 0.32, 0.12, 0.92), f"{pair[i][0]}, peak of blow {blow}",
                        y_label="z [m]" if i == 0 else "")
        script += "unset colorbox\n" if i == 0 else \
            stress_scale(600, (0.86, 0.12, 0.02, 0.8))
        script += "set xtics 0.1\n" + plot + "\n"
    gnuplot(script + "unset multiplot", to / "close_up.png", 820, 620)


def draw_void_ratio(runs, to):
    run = runs("loose_gca")
    last, start = run.frame(-1), run.frame(0)
    values = [a - b for a, b in zip(last["void_ratio"], start["void_ratio"])]
    tip = level_of_tip(run, len(run.files) - 1)
    window = (-1.8, 1.8, tip - 1.2, 0.5)
    loaded = sorted(abs(v) for v, s in zip(values, last["stress_zz"]) if s < 0.0)
    most = 0.05 * math.ceil(20.0 * loaded[int(0.98 * len(loaded))])  # not of the sand that flies about
    text, plot = field("e", run, -1, values, window, (1.0, -1.0))
    gnuplot(text + f"unset key; set pm3d map corners2color c1\n{PALETTES['change']}\nset cbrange [{-most}:{most}]\n"
            f"set cbtics add ('≤ {-most:g}' {-most}, '≥ {most:g}' {most})\n"
            "set colorbox user origin screen 0.83,0.12 size screen 0.025,0.8; set cblabel 'change of void ratio [-]' offset 1,0\n"
            + panel(window, (0.12, 0.80, 0.12, 0.92), "Loose sand, Geo-contact, end of the drive") + plot,
            to / "void_ratio.png", 640, 680)


def draw_strip(runs, to, name="dense_gca"):
    run = runs(name)
    h = run.history
    blows = h.blows()
    wanted = [0, len(blows) // 5, 2 * len(blows) // 5, 3 * len(blows) // 5, 4 * len(blows) // 5, len(blows)]
    low = level_of_tip(run, len(run.files) - 1) - 0.6
    data, script = "", ""
    for k, blow in enumerate(dict.fromkeys(wanted)):
        index = 0 if blow == 0 else peak_of_blow(run, blow)
        window = (0.0, 0.9, low, 0.6)
        text, plot = field(f"f{k}", run, index, [-s for s in run.frame(index)["stress_rr"]], window)
        data += text
        left = 0.07 + 0.136 * k
        script += panel(window, (left, left + 0.113, 0.17, 0.92), "start" if blow == 0 else f"blow {blow}",
                        y_label="z [m]" if k == 0 else "")
        script += ("set format y '%g'\n" if k == 0 else "set format y ''\n") + f"set xtics 0.4 {NEARER}; set ytics offset -0.7,0\n"
        script += "unset colorbox\n" if k == 0 else \
            stress_scale(600, (0.9, 0.17, 0.012, 0.75))
        script += plot + "\n"
        run.forget()
    gnuplot(data + f"unset key; set pm3d map corners2color c1\n{PALETTES['stress']}\nset cbrange [0:600]\nset multiplot\n"
            + script + "unset multiplot", to / f"strip_{name}.png", 1100, 560)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--to", type=pathlib.Path, help="folder of the pictures; default: that of the results")
    options = parser.parse_args()
    to = options.to or options.results
    to.mkdir(parents=True, exist_ok=True)
    have = {}

    def runs(name):
        if name not in have:
            have[name] = Run(options.results, name)
            sets(have[name].history)
        return have[name]

    def dense(to):
        draw_penetration("penetration_dense", [("GCA", BLUE, runs("dense_gca")), ("FCA", ORANGE, runs("dense_fca"))], to, (1, 3))

    def loose(to):
        draw_penetration("penetration_loose", [("GCA", BLUE, runs("loose_gca")), ("FCA", ORANGE, runs("loose_fca")),
                                               ("PCA", GREEN, runs("loose_pca")),
                                               ("PCA, no friction", GREY, runs("loose_pca_smooth"))], to, (1, 3))

    for draw in (lambda: draw_setup(runs, to), lambda: draw_radial_stress(runs, to), lambda: dense(to),
                 lambda: draw_close_up(runs, to), lambda: loose(to), lambda: draw_void_ratio(runs, to),
                 lambda: draw_strip(runs, to), lambda: draw_strip(runs, to, "loose_gca")):
        try:
            draw()
        except Unusable as problem:
            print(f"figures.py: left out: {problem}", file=sys.stderr)


if __name__ == "__main__":
    main()
