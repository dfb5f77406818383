"""The optima of three problems with constraints, by SciPy, for optima.rs.

The matrices are those of Meijaard, Papadopoulos, Ruina & Schwab (2007), appendix A; the speeds of weave and capsize are roots
of the Hurwitz determinant and of det K, quadratics in the square of the speed. Each problem is searched by differential
evolution, of which 4 are run with other seeds and where what is missed counts a thousandfold; the best of each is polished by
SLSQP with differences, and of those that keep everything the best counts. Run with the contents of two shipped files,
`generated/bicycles/NAME.toml`:

    python optima.py benchmark.toml pista.toml    # SciPy 1.17.1
"""

import sys
import tomllib
from math import cos, inf, pi, radians, sin, sqrt

import numpy as np
from scipy.optimize import differential_evolution, minimize


def read(path):
    with open(path, "rb") as file:
        parameters = tomllib.load(file)["parameters"]
    value = lambda v: v["value"] if isinstance(v, dict) else v
    number = lambda v: eval(v, {"pi": pi}) if isinstance(v, str) else float(v)
    return {name: number(value(v)) for name, v in parameters.items()}


def matrices(p):
    w, c, lam, rR, rF = p["w"], p["c"], p["lam"], p["rR"], p["rF"]
    mR, mB, mH, mF, xB, zB, xH, zH = (p[n] for n in "mR mB mH mF xB zB xH zH".split())
    mT = mR + mB + mH + mF
    xT = (xB * mB + xH * mH + w * mF) / mT
    zT = (-rR * mR + zB * mB + zH * mH - rF * mF) / mT
    ITxx = p["IRxx"] + p["IBxx"] + p["IHxx"] + p["IFxx"] + mR * rR**2 + mB * zB**2 + mH * zH**2 + mF * rF**2
    ITxz = p["IBxz"] + p["IHxz"] - mB * xB * zB - mH * xH * zH + mF * w * rF
    ITzz = p["IRxx"] + p["IBzz"] + p["IHzz"] + p["IFxx"] + mB * xB**2 + mH * xH**2 + mF * w**2
    mA = mH + mF
    xA, zA = (xH * mH + w * mF) / mA, (zH * mH - rF * mF) / mA
    IAxx = p["IHxx"] + p["IFxx"] + mH * (zH - zA) ** 2 + mF * (rF + zA) ** 2
    IAxz = p["IHxz"] - mH * (xH - xA) * (zH - zA) + mF * (w - xA) * (rF + zA)
    IAzz = p["IHzz"] + p["IFxx"] + mH * (xH - xA) ** 2 + mF * (w - xA) ** 2
    s, k = sin(lam), cos(lam)
    uA = (xA - w - c) * k - zA * s
    IAll = mA * uA**2 + IAxx * s**2 + 2 * IAxz * s * k + IAzz * k**2
    IAlx = -mA * uA * zA + IAxx * s + IAxz * k
    IAlz = mA * uA * xA + IAxz * s + IAzz * k
    mu = c / w * k
    SR, SF = p["IRyy"] / rR, p["IFyy"] / rF
    ST, SA = SR + SF, mA * uA + mu * mT * xT
    M01 = IAlx + mu * ITxz
    M = [[ITxx, M01], [M01, IAll + 2 * mu * IAlz + mu**2 * ITzz]]
    K0 = [[mT * zT, -SA], [-SA, -SA * s]]
    K2 = [[0, (ST - mT * zT) / w * k], [0, (SA + SF * s) / w * k]]
    C1 = [
        [0, mu * ST + SF * k + ITxz / w * k - mu * mT * zT],
        [-(mu * ST + SF * k), IAlz / w * k + mu * (SA + ITzz / w * k)],
    ]
    return (np.array(matrix) for matrix in (M, C1, K0, K2))


def mixed(a, b):
    return a[0, 0] * b[1, 1] + a[1, 1] * b[0, 0] - a[0, 1] * b[1, 0] - a[1, 0] * b[0, 1]


def conditions(p):
    """The coefficients of the characteristic polynomial and the Hurwitz determinant, as polynomials in u = v^2 for v > 0."""
    M, C1, K0, K2 = matrices(p)
    poly = np.polynomial.Polynomial
    K0 = p["g"] * K0
    p0, p1 = mixed(M, M) / 2, mixed(M, C1)
    p2 = poly([mixed(M, K0), mixed(M, K2) + mixed(C1, C1) / 2])
    p3 = poly([mixed(C1, K0), mixed(C1, K2)])
    p4 = poly([mixed(K0, K0) / 2, mixed(K0, K2), mixed(K2, K2) / 2])
    return poly([p1]), p2, p3, p4, p1 * p2 * p3 - p0 * p3**2 - p1**2 * p4


def roots(polynomial):
    found = [u.real for u in polynomial.roots() if abs(u.imag) < 1e-12 * abs(u) and u.real > 0]
    return sorted(sqrt(u) for u in found)


def stable(p):
    """The ranges of speeds in which every condition is positive; the last may have no end."""
    all_of = conditions(p)
    ends = [0.0, *sorted(v for polynomial in all_of[1:] for v in roots(polynomial)), inf]
    ranges = []
    for low, high in zip(ends, ends[1:]):
        middle = (low + high) / 2 if high < inf else 2 * low + 1
        if all(polynomial(middle**2) > 0 for polynomial in all_of):
            if ranges and ranges[-1][1] == low:
                ranges[-1][1] = high
            else:
                ranges.append([low, high])
    return ranges


def weave(p):
    """The highest speed at which an oscillation becomes stable: the Hurwitz determinant rises through zero there."""
    *others, hurwitz = conditions(p)
    rising = [v for v in roots(hurwitz) if hurwitz.deriv()(v**2) > 0 and others[1](v**2) > 0 and others[2](v**2) > 0]
    return max(rising, default=1e3)


def capsize(p):
    """The lowest speed at which det K falls through zero, where all else is stable; 0 where there is none."""
    *others, det, hurwitz = conditions(p)
    falling = [v for v in roots(det) if det.deriv()(v**2) < 0 and hurwitz(v**2) > 0]
    return min(falling, default=0.0)


def width(p, low, high):
    return max((min(b, high) - max(a, low) for a, b in stable(p)), default=-1.0)


def solve(base, ranges, goal, keep):
    names = list(ranges)
    bounds = list(ranges.values())
    design = lambda x: {**base, **dict(zip(names, (float(value) for value in x)))}
    missed = lambda x: [max(0.0, -excess(design(x))) for excess in keep]
    penalized = lambda x: goal(design(x)) + 1e3 * sum(missed(x))
    best = None
    for seed in range(4):
        found = differential_evolution(penalized, bounds, seed=seed, tol=1e-9, maxiter=300, polish=False)
        constraints = [{"type": "ineq", "fun": lambda x, excess=excess: excess(design(x))} for excess in keep]
        polished = minimize(
            lambda x: goal(design(x)), found.x, bounds=bounds, constraints=constraints, method="SLSQP",
            options={"ftol": 1e-14, "maxiter": 500},
        )
        for x in (found.x, polished.x):
            x = np.clip(x, *np.array(bounds).T)
            if sum(missed(x)) < 1e-9 and (best is None or goal(design(x)) < best[0]):
                best = goal(design(x)), x
    value, x = best
    print(f"{value:.12g}", dict(zip(names, (float(f"{entry:.9g}") for entry in x))), flush=True)


benchmark, pista = (read(path) for path in sys.argv[1:3])
angle = (radians(5), radians(35))

solve(
    benchmark,
    {"lam": angle, "c": (0.0, 0.15), "w": (0.9, 1.3)},
    weave,
    [lambda p: capsize(p) - 6.0, lambda p: p["c"] - 0.03, lambda p: p["w"] - 1.0],
)
solve(
    pista,
    {"w": (0.9, 1.2), "c": (0.0, 0.15), "xH": (0.7, 1.1)},
    lambda p: -width(p, 0.0, 10.0),
    [lambda p: p["w"] - 0.1 - p["xH"], lambda p: 4.0 - weave(p)],
)
solve(
    benchmark,
    {"mB": (60.0, 100.0), "zB": (-1.2, -0.6), "lam": angle, "c": (0.02, 0.12)},
    lambda p: -p["mB"],
    [lambda p: width(p, 0.0, 20.0) - 2.5, lambda p: 4.2 - weave(p), lambda p: p["c"] - 0.1 * p["lam"], lambda p: -0.8 - p["zB"]],
)
