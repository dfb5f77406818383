"""What parameters contribute to the difference of the critical speeds of two bicycles, with mpmath (1.4.1, 40 digits).

The formulas are those of Meijaard, Papadopoulos, Ruina & Schwab (2007), appendix A; the critical speeds are roots of det K
and of the Hurwitz determinant, found by Newton's method, their derivatives are differences of 40 digits, and the integrals
along the straight path are mpmath's quad. Run with the contents of two shipped files, `generated/bicycles/NAME.toml`:

    python contributions.py benchmark.toml pista.toml
"""

import sys
import tomllib

import mpmath as mp

mp.mp.dps = 40


def read(path):
    with open(path, "rb") as file:
        parameters = tomllib.load(file)["parameters"]
    value = lambda v: v["value"] if isinstance(v, dict) else v
    number = lambda v: eval(v, {"pi": mp.pi}) if isinstance(v, str) else mp.mpf(repr(v))
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
    sin, cos = mp.sin(lam), mp.cos(lam)
    uA = (xA - w - c) * cos - zA * sin
    IAll = mA * uA**2 + IAxx * sin**2 + 2 * IAxz * sin * cos + IAzz * cos**2
    IAlx = -mA * uA * zA + IAxx * sin + IAxz * cos
    IAlz = mA * uA * xA + IAxz * sin + IAzz * cos
    mu = c / w * cos
    SR, SF = p["IRyy"] / rR, p["IFyy"] / rF
    ST, SA = SR + SF, mA * uA + mu * mT * xT
    M = (ITxx, IAlx + mu * ITxz, IAll + 2 * mu * IAlz + mu**2 * ITzz)
    K0 = (mT * zT, -SA, -SA * sin)
    K2 = ((ST - mT * zT) / w * cos, (SA + SF * sin) / w * cos)
    C1 = (
        mu * ST + SF * cos + ITxz / w * cos - mu * mT * zT,
        -(mu * ST + SF * cos),
        IAlz / w * cos + mu * (SA + ITzz / w * cos),
    )
    return M, C1, K0, K2


def quartic(p, v):
    M, C1, K0, K2 = matrices(p)
    g = p["g"]
    m11, m12, m22 = M
    c12, c21, c22 = (v * entry for entry in C1)
    k11, k12, k21, k22 = g * K0[0], g * K0[1] + v**2 * K2[0], g * K0[1], g * K0[2] + v**2 * K2[1]
    return (
        k11 * k22 - k12 * k21,
        k11 * c22 - k12 * c21 - c12 * k21,
        m11 * k22 + k11 * m22 - m12 * (k12 + k21) - c12 * c21,
        m11 * c22 - m12 * (c12 + c21),
        m11 * m22 - m12**2,
    )


def capsize(p, v):
    return quartic(p, v)[0]


def weave(p, v):
    p0, p1, p2, p3, p4 = quartic(p, v)
    return p1 * p2 * p3 - p1**2 * p4 - p0 * p3**2


def main(first, second):
    a, b = read(first), read(second)
    at = lambda t: {name: a[name] + t * (b[name] - a[name]) for name in a}
    for name, condition, start in [("weave", weave, 4.3), ("capsize", capsize, 6.0)]:
        # Followed in steps, so that the root is the same one everywhere.
        steps, roots = 64, [mp.findroot(lambda v: condition(a, v), start)]
        for k in range(1, steps + 1):
            roots.append(mp.findroot(lambda v: condition(at(mp.mpf(k) / steps), v), roots[-1]))

        def root(t):
            return mp.findroot(lambda v: condition(at(t), v), roots[int(t * steps)])

        def term(parameter, t):
            p, v, h = at(t), root(t), mp.mpf(10) ** -15
            changed = lambda s: condition({**p, parameter: p[parameter] + s * h}, v)
            by_parameter = (changed(1) - changed(-1)) / (2 * h)
            by_speed = (condition(p, v + h) - condition(p, v - h)) / (2 * h)
            return -by_parameter / by_speed * (b[parameter] - a[parameter])

        print(name, mp.nstr(roots[0], 17), mp.nstr(roots[-1], 17))
        total = mp.mpf(0)
        for parameter in a:
            if a[parameter] != b[parameter]:
                contribution = mp.quad(lambda t: term(parameter, t), mp.linspace(0, 1, 5), maxdegree=5)
                total += contribution
                print(f'    ("{parameter}", {mp.nstr(contribution, 15)}),')
        print("    sum misses by", mp.nstr(total - (roots[-1] - roots[0]), 3))


main(*sys.argv[1:])
