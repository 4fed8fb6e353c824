#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reference curves of triaxial extension, from the equations alone.

von Wolffersdorff (1996) with the intergranular strain of Niemunis & Herle (1997) for principal
stresses and strains (axis 1, radial 2 = 3), integrated by the Dormand-Prince 5(4) pair with error
control. Shares no code with Grit. Run in this folder:

    python3 make_extension.py            writes c_txe_*.csv, d_txe_*.csv, e_cycd_lausitz_a1e-05.csv
    python3 make_extension.py --check    repeats a compression curve of this folder and compares
"""
import math
import sys

PHI, HS, N, ED0, EC0, EI0, ALPHA, BETA = math.radians(33.0), 1.6e6, 0.19, 0.44, 0.85, 1.0, 0.25, 1.0
MR, MT, R, BETAR, CHI = 5.0, 2.0, 1e-4, 0.5, 6.0
S = math.sin(PHI)
A = math.sqrt(3.0) * (3.0 - S) / (2.0 * math.sqrt(2.0) * S)

# Dormand & Prince (1980)
C = [[], [1 / 5], [3 / 40, 9 / 40], [44 / 45, -56 / 15, 32 / 9],
     [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
     [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
     [35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84]]
E5 = [71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40]


def stiffness(T, e, h):
    """M of (G1) as a function of D, h over its length, rho; components (axial, radial)."""
    trace = T[0] + 2 * T[1]
    That = (T[0] / trace, T[1] / trace)
    dev = (That[0] - 1 / 3, That[1] - 1 / 3)
    norm = math.sqrt(dev[0] ** 2 + 2 * dev[1] ** 2)
    F = 1.0
    if norm > 1e-14:
        tan = math.sqrt(3.0) * norm
        cos3 = -math.sqrt(6.0) * (dev[0] ** 3 + 2 * dev[1] ** 3) / norm ** 3
        F = math.sqrt(tan * tan / 8 + (2 - tan * tan) / (2 + math.sqrt(2.0) * tan * cos3)) \
            - tan / (2 * math.sqrt(2.0))
    p = -trace / 3
    x = math.exp(-(3 * p / HS) ** N)
    ei, ec, ed = EI0 * x, EC0 * x, ED0 * x
    fd = ((e - ed) / (ec - ed)) ** ALPHA
    fb = HS / N * (EI0 / EC0) ** BETA * (1 + ei) / ei * (3 * p / HS) ** (1 - N) \
        / (3 + A * A - math.sqrt(3.0) * A * ((EI0 - ED0) / (EC0 - ED0)) ** ALPHA)
    fs = fb * (ec / e) ** BETA
    c = fs / (That[0] ** 2 + 2 * That[1] ** 2)

    def L(D):
        t = That[0] * D[0] + 2 * That[1] * D[1]
        return (c * (F * F * D[0] + A * A * That[0] * t), c * (F * F * D[1] + A * A * That[1] * t))

    Nn = (c * fd * A * F * (That[0] + dev[0]), c * fd * A * F * (That[1] + dev[1]))
    length = math.sqrt(h[0] ** 2 + 2 * h[1] ** 2)
    rho = length / R
    hhat = (h[0] / length, h[1] / length) if length > 0 else (0.0, 0.0)

    def M(D):
        hD = hhat[0] * D[0] + 2 * hhat[1] * D[1]
        w = rho ** CHI
        LD, Lh = L(D), L(hhat)
        m = w * MT + (1 - w) * MR
        if hD > 0:
            return tuple(m * LD[i] + w * ((1 - MT) * Lh[i] + Nn[i]) * hD for i in (0, 1))
        return tuple(m * LD[i] + w * (MR - MT) * Lh[i] * hD for i in (0, 1))

    return M, hhat, rho


def strain_rate(M, d1, drained):
    """(D1, D2) for the axial rate d1: radial stress constant, or constant volume."""
    if not drained:
        return (d1, -0.5 * d1)
    # Radial stress rate is piecewise linear in D2 with a kink where h:D changes sign: bisect.
    def f(D2):
        return M((d1, D2))[1]
    low, high = -20 * abs(d1), 20 * abs(d1)
    if f(low) > f(high):
        low, high = high, low
    D2 = 0.0
    for _ in range(4):  # regula falsi finds a piece, the rest is exact on it
        fl, fh = f(low), f(high)
        D2 = low - fl * (high - low) / (fh - fl)
        v = f(D2)
        if v > 0:
            high = D2
        else:
            low = D2
    # polish with the secant of the piece that D2 lies on
    for _ in range(3):
        delta = 1e-6 * abs(d1)
        slope = (f(D2 + delta) - f(D2 - delta)) / (2 * delta)
        D2 -= f(D2) / slope
    return (d1, D2)


def rate(y, d1, drained):
    T, e, h = (y[0], y[1]), y[2], (y[3], y[4])
    M, hhat, rho = stiffness(T, e, h)
    D = strain_rate(M, d1, drained)
    dT = M(D)
    hD = hhat[0] * D[0] + 2 * hhat[1] * D[1]
    if hD > 0:
        dh = tuple(D[i] - hhat[i] * rho ** BETAR * hD for i in (0, 1))
    else:
        dh = D
    return [dT[0], dT[1] if not drained else 0.0, (1 + e) * (D[0] + 2 * D[1]), dh[0], dh[1], D[1]]


def integrate(y, length, d1, drained, tolerance):
    """From y over the axial path length; the step is kept between calls in integrate.step."""
    t, step = 0.0, min(integrate.step, length)
    scale = [max(abs(y[0]), abs(y[1])), max(abs(y[0]), abs(y[1])), 1.0, R, R, 1.0]
    while length - t > 1e-15 * length:
        step = min(step, length - t)
        k = []
        for row in C:
            yi = [y[j] + step * sum(a * ki[j] for a, ki in zip(row, k)) for j in range(6)]
            k.append(rate(yi, d1, drained))
        err = max(abs(step * sum(b * ki[j] for b, ki in zip(E5, k))) / scale[j] for j in range(6))
        if err <= tolerance:
            t += step
            y = [y[j] + step * sum(a * ki[j] for a, ki in zip(C[6], k)) for j in range(6)]
        if length - t > step or err > tolerance:
            step *= min(4.0, max(0.2, 0.9 * (tolerance / max(err, 1e-30)) ** 0.2))
            integrate.step = step
    return y


def path(p0, e0, points, drained, tolerance):
    """points: axial strains to be reached in turn."""
    y = [-p0, -p0, e0, -R / math.sqrt(3.0), -R / math.sqrt(3.0), 0.0]
    rows, at, integrate.step = [(0.0, 0.0, y)], 0.0, 1e-6
    travelled = 0.0
    for point in points:
        direction = 1.0 if point > at else -1.0
        y = integrate(y, abs(point - at), direction, drained, tolerance)
        travelled += abs(point - at)
        at = point
        rows.append((travelled, at, y))
    return rows


def graded(end):
    out = [2.5e-5 * i for i in range(1, 41)] + [1e-3 + 2.5e-4 * i for i in range(1, 37)]
    while out[-1] < end - 1e-9:
        out.append(min(out[-1] + 1e-3, end))
    return out


def write(name, what, rows, loose):
    error = max(max(abs(a[2][i] - b[2][i]) for i in (0, 1)) for a, b in zip(rows, loose))
    largest = max(abs(r[2][i]) for r in rows for i in (0, 1))
    with open(name, 'w') as f:
        f.write(f"# reference (von Wolffersdorff 1996 + Niemunis&Herle 1997, Dormand-Prince 5(4), "
                f"make_extension.py). lausitz: {what}, |h| = R isotropic. est. error (tolerance "
                f"1e-10 vs 1e-12 a step): stress {error / largest:.1e} rel\n")
        f.write("# tension/extension positive; stress kPa; eps = integral of D dt\n")
        f.write("t,eps11,eps22,eps33,s11,s22,s33,e,d11,d22,d33\n")
        for t, eps, y in rows:
            f.write(",".join(f"{v:.12g}" for v in (t, eps, y[5], y[5], y[0], y[1], y[1], y[2],
                                                   y[3], y[4], y[4])) + "\n")
    print(f"{name}: s11 {rows[-1][2][0]:.3f} s22 {rows[-1][2][1]:.3f} e {rows[-1][2][2]:.6f}, "
          f"error {error / largest:.1e}")


def check():
    with open("c_txd_lausitz_p100_e0.55.csv") as f:
        lines = [line.split(",") for line in f if line[0] not in "#t"]
    want = [(float(c[1]), float(c[7]), float(c[13])) for c in lines][1::20]
    rows = path(100.0, 0.55, [w[0] for w in want], True, 1e-12)[1:]
    print("drained compression, largest difference of s11:",
          max(abs(r[2][0] - w[1]) / abs(want[-1][1]) for r, w in zip(rows, want)),
          "of e:", max(abs(r[2][2] - w[2]) for r, w in zip(rows, want)))


def main():
    for p0, e0 in ((100, 0.55), (100, 0.80), (400, 0.55), (400, 0.75)):
        for drained, letter, word, end in ((True, "c", "drained", 0.10), (False, "d", "undrained", 0.10)):
            runs = [path(p0, e0, graded(end), drained, tol) for tol in (1e-12, 1e-10)]
            write(f"{letter}_txe_lausitz_p{p0}_e{e0:.2f}.csv",
                  f"{word} triaxial extension p0={p0} e0={e0:.2f} to eps11=+{end}", *runs)
    amplitude, points = 1e-5, []
    for turn in range(11):
        start, goal = (0.0 if turn == 0 else points[-1]), amplitude * (-1) ** (turn + 1)
        count = 25 if turn == 0 else 50
        points += [start + (goal - start) * (i + 1) / count for i in range(count)]
    runs = [path(100, 0.60, points, True, tol) for tol in (1e-12, 1e-10)]
    write("e_cycd_lausitz_a1e-05.csv", "drained triaxial strain cycles eps11 = -+1e-5, p0=100 "
          "e0=0.60, 5 cycles", *runs)


if __name__ == "__main__":
    check() if "--check" in sys.argv else main()
