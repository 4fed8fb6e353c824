#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The p-y curves of a pile that is pushed sideways: py_curves.py CASE.toml HISTORY.csv [--friction-angle DEG] [--to PICTURE.svg]

CASE: of grit mpm in space, half of a rigid pile with a table of velocity_x and a profile in its history; HISTORY: what it left.
Prints p, the force on the whole pile by its length, at some ways y, beside p of API RP 2GEO (2011) and ISO 19901-4 for sand; gnuplot
draws the curves."""
import math
import pathlib

from in_sand import InSand, block, gnuplot, options_of

WAYS = (0.01, 0.02, 0.05, 0.095)  # diameters
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#AA4499")


class Pile(InSand):
    def __init__(self, case, history):
        super().__init__(case, history)
        self.diameter = 2.0 * self.body["cylinder"][0]["radius_m"]
        low, high = self.history["profile_z_m"]
        self.parts = self.history.get("profile_parts", 10)
        self.height = (high - low) / self.parts
        self.depth = [-(low + (k + 0.5) * self.height) for k in range(self.parts)]  # of the middle of each part
        begin = min(row["t"] for row in self.rows if row["stage"] == 2)
        table = self.body["rigid"]
        self.way, self.force = [], []  # [m]; along x, per length, of each part [kN/m]
        for row in self.rows:
            if row["t"] <= begin:
                before = [row[f"profile_x_{k + 1}"] for k in range(self.parts)]  # at rest: half a pile, pressed from all sides
                continue
            self.way.append(way_of(table["time_s"], table["velocity_x_m_per_s"], row["t"] - begin))
            self.force.append([-2.0 * (row[f"profile_x_{k + 1}"] - before[k]) / self.height for k in range(self.parts)])

    def at(self, part, way):
        """p, linear between rows; None where the pile has not come that far."""
        for i in range(1, len(self.way)):
            if self.way[i - 1] <= way <= self.way[i]:
                share = (way - self.way[i - 1]) / (self.way[i] - self.way[i - 1])
                return (1.0 - share) * self.force[i - 1][part] + share * self.force[i][part]
        return None


def way_of(times, velocities, until):
    """Integral of a table, which goes on with its last value."""
    way = 0.0
    for k, begin in enumerate(times):
        end = min(times[k + 1], until) if k + 1 < len(times) else until
        if end <= begin:
            break
        slope = (velocities[k + 1] - velocities[k]) / (times[k + 1] - begin) if k + 1 < len(times) else 0.0
        way += (velocities[k] + 0.5 * slope * (end - begin)) * (end - begin)
    return way


def api_sand(z, y, diameter, weight, angle):
    """p of a monotonic push [kN/m]; weight: of the sand, angle: of friction [rad]."""
    k_0, alpha, beta = 0.4, 0.5 * angle, 0.25 * math.pi + 0.5 * angle
    k_a = math.tan(0.25 * math.pi - 0.5 * angle) ** 2
    tan_b, tan_bf = math.tan(beta), math.tan(beta - angle)
    c_1 = (tan_b ** 2 * math.tan(alpha) / tan_bf
           + k_0 * (math.tan(angle) * math.sin(beta) / (math.cos(alpha) * tan_bf)
                    + tan_b * (math.tan(angle) * math.sin(beta) - math.tan(alpha))))
    c_2 = tan_b / tan_bf - k_a
    c_3 = k_a * (tan_b ** 8 - 1.0) + k_0 * math.tan(angle) * tan_b ** 4
    ultimate = min((c_1 * z + c_2 * diameter) * weight * z, c_3 * diameter * weight * z)
    share = max(3.0 - 0.8 * z / diameter, 0.9)
    degrees = math.degrees(angle)  # initial modulus above the water table, a chart of both [kN/m3]
    chart = ((29.0, 6.8e3), (30.0, 11e3), (33.0, 25e3), (35.0, 38e3), (37.5, 55e3), (40.0, 73e3))
    modulus = chart[-1][1]
    for (low, at_low), (high, at_high) in zip(chart, chart[1:]):
        if degrees <= high:
            modulus = at_low + (max(degrees, low) - low) / (high - low) * (at_high - at_low)
            break
    return share * ultimate * math.tanh(modulus * z * y / (share * ultimate))


def draw(pile, angle, target):
    data, plots = "", []
    shown = range(pile.parts - 1, -1, -max(pile.parts // 4, 1))
    for colour, part in zip(COLOURS, shown):
        z = pile.depth[part]
        data += block(f"mpm{part}", [f"{y / pile.diameter:.5f} {force[part]:.4f}" for y, force in zip(pile.way, pile.force)])
        data += block(f"api{part}", [f"{s:.4f} {api_sand(z, s * pile.diameter, pile.diameter, pile.weight, angle):.4f}"
                                     for s in (0.0025 * k for k in range(41))])
        plots.append(f"$mpm{part} with lines lw 2 lc rgb '{colour}' title '{z:.2f} m'")
        plots.append(f"$api{part} with lines lw 1.5 dt 2 lc rgb '{colour}' notitle")
    gnuplot(data + "set xlabel 'y / D'; set ylabel 'p [kN/m]'; set key top left samplen 2; set grid lc rgb '#dddddd'\n"
            "set xrange [0:0.1]; set yrange [0:*]\n"
            f"set title 'Lines: material points; dashed: API, friction angle {math.degrees(angle):.0f}°' noenhanced\n"
            "plot " + ", ".join(plots), pathlib.Path(target), 640, 460)


def main():
    options = options_of(__doc__)
    pile, angle = Pile(options.case, options.history), math.radians(options.friction_angle)
    ways = [share * pile.diameter for share in WAYS]
    print("| depth [m] | " + " | ".join(f"p [kN/m] at y = {share:g} D | API" for share in WAYS) + " |")
    print("|---|" + "---|---|" * len(WAYS))
    for part in reversed(range(pile.parts)):
        cells = [f"{pile.depth[part]:.2f}"]
        for y in ways:
            p = pile.at(part, y)
            cells += [f"{p:.0f}" if p is not None else "", f"{api_sand(pile.depth[part], y, pile.diameter, pile.weight, angle):.0f}"]
        print("| " + " | ".join(cells) + " |")
    cells = ["whole [kN]"]
    for y in ways:
        of_parts = [pile.at(part, y) for part in range(pile.parts)]
        cells += [f"{pile.height * sum(of_parts):.0f}" if None not in of_parts else "",
                  f"{pile.height * sum(api_sand(z, y, pile.diameter, pile.weight, angle) for z in pile.depth):.0f}"]
    print("| " + " | ".join(cells) + " |")
    if options.to:
        draw(pile, angle, options.to)


if __name__ == "__main__":
    main()
