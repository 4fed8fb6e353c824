# SPDX-License-Identifier: BSD-3-Clause
# A tour of the Python module, cell by cell (# %%, as notebooks and most editors run them): laboratory
# tests, a batch of points, contact at nodes. Pictures sand_tour_*.svg by gnuplot.

# %% Set-up: a sand with published parameters [kPa], and a way to plot
import subprocess

import numpy as np

import grit

sand = grit.Sand("lausitz")
isotropic = np.array([-1.0, -1, -1, 0, 0, 0])  # compression is negative


def plot(name, x_label, y_label, curves):
    """curves: title -> (x, y); writes sand_tour_NAME.svg."""
    lines = [f"set terminal svg size 640, 420; set output 'sand_tour_{name}.svg'",
             f"set xlabel '{x_label}'; set ylabel '{y_label}'; set grid; set key below",
             "plot " + ", ".join(f"'-' with lines lw 2 title '{title}'" for title in curves)]
    for x, y in curves.values():
        lines += [f"{a:.9g} {b:.9g}" for a, b in zip(x, y)] + ["e"]
    subprocess.run(["gnuplot"], input="\n".join(lines), text=True, check=True)


# %% Drained triaxial tests of loose and dense sand at 100 kPa
def triaxial(void_ratio):
    test = grit.element_test(sand, [grit.stage.triaxial_drained(-0.15, increments=200)],
                             100 * isotropic, void_ratio, direction=isotropic)
    return -100 * test["strain"][:, 0], test["stress"][:, 1] - test["stress"][:, 0]


ends = {f"e = {e:.2f}": triaxial(e) for e in (0.55, 0.65, 0.80)}
plot("triaxial", "axial shortening [%]", "q [kPa]", ends)
for title, (_, q) in ends.items():
    print(f"{title}: largest q {q.max():.1f} kPa, at the end {q[-1]:.1f} kPa")

# %% Undrained cycles: the effective pressure wanders towards zero
turns = [-5e-4] + 8 * [1e-3, -1e-3]
cycles = grit.element_test(sand, [grit.stage.triaxial_undrained(x, 100, 1e-3) for x in turns],
                           100 * isotropic, 0.75, direction=isotropic)
stress = cycles["stress"]
p, q = -stress[:, :3].mean(axis=1), stress[:, 1] - stress[:, 0]
plot("cycles", "p [kPa]", "q [kPa]", {"undrained, strain amplitude 5e-4": (p, q)})
print(f"after {len(turns) // 2} cycles p = {p[-1]:.2f} kPa, "
      f"excess pore pressure {cycles['pore_pressure'][-1]:.2f} kPa")

# %% A batch: 1000 points of a column, sheared; arrays are changed in place
depth = np.linspace(0.1, 100, 1000)  # m
stress = np.array([sand.stress_at_rest(9.0, z) for z in depth])
state = np.array([sand.state(sand.void_ratio_at_pressure(0.75, -s[:3].mean())) for s in stress])
strain = np.tile([0, 0, 0, 0, 0, 1e-4], (depth.size, 1))  # 23, engineering
for _ in range(50):
    reports = sand.update(strain, stress, state)
print(f"sigma_23 at 100 m after 0.5 % shear: {stress[-1, 5]:.2f} kPa; "
      f"{reports['evaluations'].mean():.1f} evaluations per point in the last step")

# %% Contact: what is left of an approach, by the distance of the surface from the node
s = np.linspace(-0.2, 1.2, 141)  # in cells
velocity_a, velocity_b = np.tile([1.0, 0], (s.size, 1)), np.zeros((s.size, 2))
curves = {}
for k in (1.0, 6.0, 20.0):
    a, b = velocity_a.copy(), velocity_b.copy()
    grit.contact_correct(np.ones(s.size), np.ones(s.size), np.tile([1.0, 0], (s.size, 1)), a, b,
                         distance=s, cell_size=np.ones(s.size), penalty_power=k)
    curves[f"k = {k:g}"] = (s, a[:, 0] - b[:, 0])
plot("contact", "distance / cell [-]", "approach left [-]", curves)
