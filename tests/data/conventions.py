"""Writes conventions.tsv: parameters of the same bicycles in the names of several programs, as those programs convert them.

    pip install bicycleparameters==1.5.2 dynamicisttoolkit mpmath
    python conventions.py > conventions.tsv

- moore: `dtk.bicycle.benchmark_to_moore`; and the sets `meijaard2007_browser_jasonlegs` and
  `mooreriderlean2012_browser_jason` of BicycleParameters, of the same bicycle by other programs.
- principal: `Moore2019ParameterSet(...).to_parameterization("Meijaard2007")` of all sets that BicycleParameters has.
- pydy: the formulas of sympy/physics/mechanics/tests/test_kane3.py for the benchmark, at 30 digits.
- gyrostats: the benchmark as it is printed in derivation/benchmark_parameters.py of libbicycle (Peterson).
- jbike6: a bicycle of seven bodies, and what JBmck.m of JBike6 makes of it: its matrices, with K0 divided by g, and the steer
  angle positive to the right instead of to the left.
"""

import importlib.metadata
import pathlib

import bicycleparameters as bp
import mpmath as mp
import numpy as np
import yaml
from bicycleparameters import parameter_dicts as sets
from bicycleparameters.parameter_sets import Moore2019ParameterSet
from dtk.bicycle import benchmark_to_moore

PAPER = """w c lam g rR mR IRxx IRyy xB zB mB IBxx IByy IBzz IBxz xH zH mH IHxx IHyy IHzz IHxz rF mF IFxx IFyy""".split()
BENCHMARK = dict(zip(PAPER, [
    1.02, 0.08, np.pi / 10, 9.81, 0.3, 2, 0.0603, 0.12, 0.3, -0.9, 85, 9.2, 11, 2.8, 2.4, 0.9, -0.7, 4, 0.05892, 0.06,
    0.00708, -0.00756, 0.35, 3, 0.1405, 0.28]))


def write(pair, side, values):
    for name, value in values.items():
        print(pair, side, name, repr(float(value)), sep="\t")


def paper(values):
    return {name: values[name] for name in PAPER}


def moore(values):
    zero = {"ic12", "ic23", "ie12", "ie23", "id33", "if33"}
    return {name: value for name, value in values.items() if name not in zero}


def pydy():
    m = mp.mpf
    with mp.workdps(30):
        hta, trail, w, rr, rf = mp.pi / 2 - mp.pi / 10, m("0.08"), m("1.02"), m("0.3"), m("0.35")
        xb, zb, xh, zh = m("0.3"), m("0.9"), m("0.9"), m("0.7")
        rake = -(trail * mp.sin(hta) - rf * mp.cos(hta))
        fork = w * mp.cos(hta) - (rf - rr) * mp.sin(hta)
        a, b = zh - rf, w - xh
        c = mp.sqrt(a**2 + b**2)
        return {
            "WFrad": rf, "WRrad": rr, "htangle": hta, "forkoffset": rake, "forklength": fork,
            "framelength": w * mp.sin(hta) - (rake - (rf - rr) * mp.cos(hta)),
            "forkcg1": c * mp.cos(mp.pi / 2 - hta - mp.acos(a / c)) - fork,
            "forkcg3": rake + c * mp.sin(mp.pi / 2 - hta - mp.acos(a / c)),
            "framecg1": (zb - rr - xb / mp.sin(hta) * mp.cos(hta)) * mp.sin(hta),
            "framecg3": xb / mp.sin(hta) + (zb - rr - xb / mp.sin(hta) * mp.cos(hta)) * mp.cos(hta),
            "Iwr11": 0.0603, "Iwr22": 0.12, "Iwf11": 0.1405, "Iwf22": 0.28, "Ifork11": 0.05892, "Ifork22": 0.06,
            "Ifork33": 0.00708, "Ifork31": 0.00756, "Iframe11": 9.2, "Iframe22": 11, "Iframe33": 2.8, "Iframe31": -2.4,
            "mfork": 4, "mframe": 85, "mwf": 3, "mwr": 2, "g": 9.81}


GYROSTATS = {
    "rr": 0.3, "rf": 0.35, "lr": 0.9534570696121847, "ls": 0.2676445084476887, "lf": 0.0320714267276193, "mr": 87,
    "lrx": 0.4599058376856175, "lrz": -0.4669419422355363, "IDxx": 7.684799791449106, "IDzz": 5.315110553378478,
    "IDxz": 4.262158094617231, "ICyy": 0.12, "mf": 7, "lfx": -0.003411905099535387, "lfz": -0.2114010400161699,
    "IExx": 0.4335379755311007, "IEzz": 0.1481477387546135, "IExz": 0.005332503757935522, "IFyy": 0.28, "g": 9.81}

# Masses, centres (x and y, or u and v), moments about the axes 1, 2 and z, and the angle of axis 1.
BODIES = {
    "frontwheel": (1.84, None, [0.0865427328, 0.0865427328, 0.1730854656], 0.0),
    "fork": (1.5, (0.01, 0.6858), [0.096, 0.0006, 0.096], 0.2967),
    "basket": (2.5, (0.12, 0.95), [0.03, 0.05, 0.04], -0.4),
    "rearwheel": (8.5, None, [0.095625, 0.095625, 0.19125], 0.0),
    "frame": (2.5, (0.4, 0.6), [0.05857864376269, 0.34142135623731, 0.4], 0.39269908169872),
    "rack": (4.0, (-0.1, 0.75), [0.02, 0.03, 0.04], 0.7),
    "rider": (80.0, (0.3, 1.2), [10.53112887414928, 2.46887112585073, 12.0], -0.25957305712326)}
GEOMETRY = {"wheelbase": 1.03, "lambda": 0.2967, "trail": 0.0588, "gravity": 9.80665,
            "Drearwheel": 0.6858, "Dfrontwheel": 0.6858}


def joined(bodies):
    masses = np.array([mass for mass, *_ in bodies])
    centre = sum(mass * x for mass, x, *_ in bodies) / masses.sum()
    total = np.zeros((3, 3))
    for mass, x, moments, angle in bodies:
        s, c = np.sin(angle), np.cos(angle)
        turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        d = np.append(x - centre, 0)
        total += turn @ np.diag(moments) @ turn.T + mass * (d @ d * np.eye(3) - np.outer(d, d))
    return masses.sum(), centre, total


def jbike6():
    w, lam, c, g = (GEOMETRY[name] for name in ("wheelbase", "lambda", "trail", "gravity"))
    sin, cos = np.sin(lam), np.cos(lam)
    steered = lambda u, v: np.array([w + c + cos * u - sin * v, sin * u + cos * v])
    places = {"frontwheel": np.array([w, GEOMETRY["Dfrontwheel"] / 2]), "rearwheel": np.array([0, GEOMETRY["Drearwheel"] / 2])}
    for name, (_, place, *_) in BODIES.items():
        if place is not None:
            places[name] = steered(*place) if name in ("fork", "basket") else np.array(place)
    bodies = {name: (mass, places[name], moments, angle) for name, (mass, _, moments, angle) in BODIES.items()}
    mf, cf, inertia_front = joined([bodies[name] for name in ("frontwheel", "fork", "basket")])
    mt, ct, total = joined(list(bodies.values()))
    centre = np.append(ct, 0)
    total = total + mt * (centre @ centre * np.eye(3) - np.outer(centre, centre))
    d = cos * (cf[0] - w - c) + sin * cf[1]
    axis = np.array([-sin, cos, 0])
    fll = mf * d * d + axis @ inertia_front @ axis
    flx, fly = -mf * cf[1] * d + inertia_front[0] @ axis, mf * cf[0] * d + inertia_front[1] @ axis
    ratio = c * cos / w
    sr, sf = (BODIES[f"{end}wheel"][2][2] / (GEOMETRY[f"D{end}wheel"] / 2) for end in ("rear", "front"))
    st, nu = sr + sf, mf * d + mt * ct[0] * ratio
    m12 = flx + ratio * total[0, 1]
    matrices = {
        "M": [total[0, 0], m12, m12, fll + 2 * ratio * fly + ratio**2 * total[1, 1]],
        "C1": [0, -(sf * cos + ratio * st) + total[0, 1] * cos / w - ratio * mt * ct[1], sf * cos + ratio * st,
               cos / w * fly + ratio * (nu + cos / w * total[1, 1])],
        "K0": [-mt * ct[1], nu, nu, -nu * sin],
        "K2": [0, -cos / w * (st + mt * ct[1]), 0, cos / w * (sin * sf + nu)]}
    right = np.array([1, -1, -1, 1])
    return {f"{name}{row}{column}": value for name, entries in matrices.items()
            for (row, column), value in zip([(1, 1), (1, 2), (2, 1), (2, 2)], np.array(entries) * right)}


def jbike6_names():
    values = dict(GEOMETRY)
    for name, (mass, place, moments, angle) in BODIES.items():
        axes = "uv" if name in ("fork", "basket") else "xy"
        values[f"m{name}"] = mass
        if place is not None:
            values.update({f"{axis}cm{name}": value for axis, value in zip(axes, place)})
        values.update({f"{axis}{name}": value for axis, value in zip(("I11", "I22", "Izz"), moments)})
        values[f"alphaI{name}"] = angle
    return values


if __name__ == "__main__":
    versions = ", ".join(f"{name} {importlib.metadata.version(name)}" for name in ("BicycleParameters", "DynamicistToolKit"))
    print(f"# By conventions.py beside it, with {versions}. Pair, side, name, value.")
    write("moore benchmark", "paper", BENCHMARK)
    write("moore benchmark", "moore", moore(benchmark_to_moore(BENCHMARK)))
    legs, lean = sets.meijaard2007_browser_jasonlegs, sets.mooreriderlean2012_browser_jason
    write("moore legs", "paper", paper(legs))
    write("moore legs", "moore", {name: lean[name] for name in moore(benchmark_to_moore(BENCHMARK))})
    write("pydy benchmark", "paper", BENCHMARK)
    write("pydy benchmark", "pydy", pydy())
    folder = pathlib.Path(bp.__file__).parent / "tests" / "parameter_sets"
    load = lambda name: yaml.safe_load((folder / f"principal-{name}.yml").read_text())
    for name, values in [("browserjason", load("browserjason")["values"]), ("extendedoptf", load("extendedoptf")),
                         ("moore2019", sets.moore2019_browser_jason)]:
        converted = Moore2019ParameterSet(values).to_parameterization("Meijaard2007").parameters
        write(f"principal {name}", "paper", paper(converted))
        write(f"principal {name}", "principal", {key: value for key, value in values.items() if key != "v"})
    write("gyrostats benchmark", "paper", BENCHMARK)
    write("gyrostats benchmark", "gyrostats", GYROSTATS)
    write("jbike6 bodies", "jbike6", jbike6_names())
    write("jbike6 bodies", "matrices", jbike6())
