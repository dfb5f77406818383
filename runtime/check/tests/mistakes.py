"""The matrices of the benchmark bicycle with mistakes that were made in public, at 30 digits: `python3 mistakes.py`.

After Appendix A of Meijaard, Papadopoulos, Ruina & Schwab (2007), with the parameters of its Table 1; needs mpmath.
"""

import sys

from mpmath import cos, mp, mpf, pi, sin

mp.dps = 30

BENCHMARK = dict(
    w="1.02", c="0.08", rR="0.3", mR="2", IRxx="0.0603", IRyy="0.12", xB="0.3", zB="-0.9", mB="85", IBxx="9.2",
    IBzz="2.8", IBxz="2.4", xH="0.9", zH="-0.7", mH="4", IHxx="0.05892", IHzz="0.00708", IHxz="-0.00756", rF="0.35",
    mF="3", IFxx="0.1405", IFyy="0.28",
)  # fmt: skip


def matrices(lower_front=False):
    """M, C1, K0, K2; with the front wheel at +rR for -rF in the height of the centre of mass, as in a public script."""
    w, c, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBzz, IBxz, xH, zH, mH, IHxx, IHzz, IHxz, rF, mF, IFxx, IFyy = (
        mpf(value) for value in BENCHMARK.values()
    )
    lam = pi / 10
    s, k = sin(lam), cos(lam)
    mT = mR + mB + mH + mF
    xT = (xB * mB + xH * mH + w * mF) / mT
    zT = (-rR * mR + zB * mB + zH * mH + (rR if lower_front else -rF) * mF) / mT
    ITxx = IRxx + IBxx + IHxx + IFxx + mR * rR**2 + mB * zB**2 + mH * zH**2 + mF * rF**2
    ITxz = IBxz + IHxz - mB * xB * zB - mH * xH * zH + mF * w * rF
    ITzz = IRxx + IBzz + IHzz + IFxx + mB * xB**2 + mH * xH**2 + mF * w**2
    mA = mH + mF
    xA = (xH * mH + w * mF) / mA
    zA = (zH * mH - rF * mF) / mA
    IAxx = IHxx + IFxx + mH * (zH - zA) ** 2 + mF * (rF + zA) ** 2
    IAxz = IHxz - mH * (xH - xA) * (zH - zA) + mF * (w - xA) * (rF + zA)
    IAzz = IHzz + IFxx + mH * (xH - xA) ** 2 + mF * (w - xA) ** 2
    uA = (xA - w - c) * k - zA * s
    IAll = mA * uA**2 + IAxx * s**2 + 2 * IAxz * s * k + IAzz * k**2
    IAlx = -mA * uA * zA + IAxx * s + IAxz * k
    IAlz = mA * uA * xA + IAxz * s + IAzz * k
    mu = c / w * k
    SR, SF = IRyy / rR, IFyy / rF
    ST = SR + SF
    SA = mA * uA + mu * mT * xT
    off = IAlx + mu * ITxz
    return {
        "M": [[ITxx, off], [off, IAll + 2 * mu * IAlz + mu**2 * ITzz]],
        "C1": [
            [0, mu * ST + SF * k + ITxz / w * k - mu * mT * zT],
            [-(mu * ST + SF * k), IAlz / w * k + mu * (SA + ITzz / w * k)],
        ],
        "K0": [[mT * zT, -SA], [-SA, -SA * s]],
        "K2": [[0, (ST - mT * zT) / w * k], [0, (SA + SF * s) / w * k]],
    }


print("# Written by mistakes.py: zT with +rR*mF in the place of -rF*mF.")
for name, rows in matrices("right" not in sys.argv).items():
    print(f"{name} = [{', '.join('[' + ', '.join(mp.nstr(mpf(entry), 8, strip_zeros=False) for entry in row) + ']' for row in rows)}]")
