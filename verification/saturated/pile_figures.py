#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pile_figures.py [--out DIR] [--to DIR]: the pictures of docs/saturated.md from what piles.py left in DIR (gnuplot)."""
import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from figures import block, gnuplot, mean_field  # noqa: E402
from measures import PEAK, RADIUS  # noqa: E402
from results import Run  # noqa: E402
from piles import SHOWN  # noqa: E402

SANDS = {"dense": 0.55, "loose": 0.65}
KINDS = {"dry": ("dry", "#222222"), "flow_1e3": ("k = 1e-3 m/s", "#D55E00"), "flow_1e5": ("k = 1e-5 m/s", "#009E73"),
         "flow_1e7": ("k = 1e-7 m/s", "#0072B2"), "undrained": ("undrained", "#AA4499")}
WINDOW = (0.0, 0.9, -0.9, 0.6)  # r and z from the tip [m]


def draw_penetration(runs, target):
    data, script = "", ""
    for k, (sand, e) in enumerate(SANDS.items()):
        plots = []
        for kind, (name, colour) in KINDS.items():
            history = runs[sand, kind].history
            ends = [history.drive()] + [last for _, last in history.blows()]
            data += block(f"{sand}_{kind}", [f"{n} {history['depth'][i]:.4f}" for n, i in enumerate(ends)])
            plots.append(f"${sand}_{kind} with linespoints pt 7 ps 0.3 lw 1.5 lc rgb '{colour}' title '{name}'")
        script += (f"set title '{sand}, e = {e:g}'; set xlabel 'blows'; set ylabel '{'' if k else 'penetration [m]'}'\n"
                   "set yrange [2.6:0]; set xrange [0:20]\nplot " + ", ".join(plots) + "\n")
    gnuplot(data + "set multiplot layout 1,2 margins 0.09,0.97,0.14,0.9 spacing 0.1\nset grid lc rgb '#dddddd'\n"
            "set key bottom left samplen 2\n" + script + "unset multiplot", target, 900, 440)


def draw_excess(runs, target):
    """At the peak of a blow, means of squares."""
    r0, r1, z0, z1 = WINDOW
    data, script = "", "unset key; set tics font ',7'\n"
    for row, sand in enumerate(SANDS):
        for column, kind in enumerate(k for k in KINDS if k != "dry"):
            run, name = runs[sand, kind], f"{sand}_{kind}"
            first, _ = run.history.blows()[SHOWN - 1]
            index = run.frame_near(run.history["t"][first] + PEAK)
            frame = run.frame(index)
            values = [p - 9.81 * max(0.0, -z) for p, (_, z) in zip(frame["pore_pressure"], frame.centres())]
            data += block(name, mean_field([run], lambda _: index, lambda _, i: values, WINDOW))
            left, top = 0.07 + 0.205 * column, 0.95 - 0.47 * row
            script += f"""set lmargin at screen {left}; set rmargin at screen {left + 0.19}
set tmargin at screen {top}; set bmargin at screen {top - 0.39}
set xrange [{r0}:{r1}]; set yrange [{z0}:{z1}]
set title "{sand}, {KINDS[kind][0]}" offset 0,-0.9 font ',7.5'
set xlabel "{'r [m]' if row else ''}" offset 0,1 font ',7'
set ylabel "{'' if column else 'z − tip [m]'}" offset 1,0 font ',7'
set format y '{'' if column else '%g'}'; set xtics 0,0.3,{r1 - 0.1} offset 0,0.4; set ytics 0.3
set object 1 rectangle from 0,0 to {RADIUS},{z1} fillcolor rgb '#b8b8b8' fillstyle solid noborder behind
{'unset colorbox' if row or column < 3 else 'set colorbox user origin screen 0.895,0.09 size screen 0.014,0.86'}
plot ${name} using 1:2:3 with image
"""
    gnuplot(data + "set palette defined (-1 '#2166ac', -0.4 '#92c5de', 0 '#f7f7f7', 0.4 '#f4a582', 1 '#b2182b')\n"
            "set cbrange [-100:100]; set cblabel 'excess pore pressure [kPa]' offset -0.5,0 font ',7'\nset multiplot\n" + script
            + "unset multiplot", target, 560, 430)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, default=HERE.parents[1] / "results/saturated")
    parser.add_argument("--to", type=pathlib.Path, default=HERE.parents[1] / "docs/images/saturated")
    args = parser.parse_args()
    args.to.mkdir(parents=True, exist_ok=True)
    runs = {(sand, kind): Run(args.out, f"pile_{sand}_{kind}") for sand in SANDS for kind in KINDS}
    draw_penetration(runs, args.to / "pile_penetration.svg")
    draw_excess(runs, args.to / "pile_pore_pressure.png")


if __name__ == "__main__":
    main()
