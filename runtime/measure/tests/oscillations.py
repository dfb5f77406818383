"""Writes recorded oscillations with noise, and what SciPy's curve_fit makes of them, for oscillations.rs. What it finds is
polished by some steps of Gauss and Newton in extended precision, since it ends a few 1e-10 from the least sum.

    python oscillations.py    # NumPy, SciPy 1.17.1
"""

from pathlib import Path

import numpy as np
from scipy.optimize import curve_fit

DATA = Path(__file__).parent / "data" / "oscillations"


def model(t, a, b, c, d, w):
    return a + np.exp(-d * t) * (b * np.sin(w * t) + c * np.cos(w * t))


def slopes(t, a, b, c, d, w):
    envelope, sine, cosine = np.exp(-d * t), np.sin(w * t), np.cos(w * t)
    swing = envelope * (b * sine + c * cosine)
    return np.array([np.ones_like(t), envelope * sine, envelope * cosine, -t * swing, t * envelope * (b * cosine - c * sine)]).T


# Name, samples, samples a second, offset, sine, cosine, decay, frequency, noise.
SIGNALS = [
    ("gyro", 400, 20.0, 2.5, -0.75, -0.75, 0.005, 3.93, 0.01),
    ("torsion", 300, 10.0, 1.35, 0.2, 1.1, 0.02, 4.3, 0.05),
    ("short", 120, 30.0, -3.0, 5.0, 0.1, 0.3, 5.5, 0.2),
    ("clean", 200, 25.0, 0.0, 0.3, -0.1, 0.0, 8.0, 1e-6),
    ("slow", 150, 8.0, 40.0, 12.0, 3.0, 0.15, 1.9, 1.0),
]

generator = np.random.default_rng(16)
rows = []
for name, count, rate, a, b, c, d, w, noise in SIGNALS:
    # Times that are neither even nor begin at zero, as loggers have them, but for the first signal.
    t = np.arange(count) / rate
    if name != "gyro":
        t = np.round(3.0 + t + generator.uniform(-0.2, 0.2, count) / rate, 4)
    y = np.round(model(t - t[0], a, b, c, d, w) + generator.normal(0.0, noise, count), 8)
    found, covariance = curve_fit(
        model, t - t[0], y, p0=[a, b, c, d, w], jac=slopes, method="lm", ftol=1e-15, xtol=1e-15, gtol=1e-15, maxfev=10000
    )
    exact, x, z = np.longdouble(found), np.longdouble(t) - np.longdouble(t[0]), np.longdouble(y)
    for _ in range(30):
        jacobian = slopes(x, *exact)
        exact = exact + np.linalg.solve((jacobian.T @ jacobian).astype(float), (jacobian.T @ (z - model(x, *exact))).astype(float))
    assert np.allclose(exact.astype(float), found, rtol=1e-7, atol=1e-8)
    found = exact.astype(float)
    period = 2.0 * np.pi / found[4]
    deviation = period / found[4] * np.sqrt(covariance[4, 4])
    rows.append([name, period, deviation, found[3], found[0], np.hypot(found[1], found[2])])
    lines = [f"{value!r}" for value in y.tolist()] if name == "gyro" else [
        f"{time!r},{value!r}" for time, value in zip(t.tolist(), y.tolist())
    ]
    (DATA / f"{name}.csv").write_text("\n".join(lines) + "\n")

# The same with a zero that drifts, of which the rate is the last unknown.
def drifting(t, a, b, c, d, w, e):
    return model(t, a, b, c, d, w) + e * t


def drifting_slopes(t, *unknowns):
    return np.column_stack([slopes(t, *unknowns[:5]), t])


drifts = []
for name, count, rate, start, noise in [
    ("drift", 400, 20.0, [2.5, -0.75, -0.75, 0.005, 3.93, 0.02], 0.01),
    ("sinking", 250, 12.0, [0.1, 0.2, 1.1, 0.05, 5.1, -0.1], 0.03),
]:
    t = np.round(1.0 + (np.arange(count) + generator.uniform(-0.2, 0.2, count)) / rate, 4)
    y = np.round(drifting(t - t[0], *start) + generator.normal(0.0, noise, count), 8)
    found, covariance = curve_fit(
        drifting, t - t[0], y, p0=start, jac=drifting_slopes, method="lm", ftol=1e-15, xtol=1e-15, gtol=1e-15, maxfev=10000
    )
    period = 2.0 * np.pi / found[4]
    drifts.append([name, period, period / found[4] * np.sqrt(covariance[4, 4]), found[3], found[0], np.hypot(found[1], found[2]), found[5]])
    (DATA / f"{name}.csv").write_text("".join(f"{time!r},{value!r}\n" for time, value in zip(t.tolist(), y.tolist())))
(DATA / "drifts.tsv").write_text("\n".join("\t".join([row[0]] + [repr(float(v)) for v in row[1:]]) for row in drifts) + "\n")
(DATA / "fits.tsv").write_text("\n".join("\t".join([row[0]] + [repr(float(v)) for v in row[1:]]) for row in rows) + "\n")
