"""Eigenvalues of systems of three and four coordinates whose sizes spread over up to 240 orders of magnitude.

    python tests/data/spread_eigenvalues.py > tests/data/spread_eigenvalues.tsv

needs mpmath. Coordinates have eigenvalues of random sizes; of each second system they are coupled. The eigenvalues are those of the
state matrix at 260 digits, of entries as `f64` has them.
"""

import random

import mpmath as mp

mp.mp.dps = 260
random.seed(3)
print("# Written by spread_eigenvalues.py: eigenvalues at 260 digits, of sizes from 10^-X to 10^X.")
print("# N\tX\tM, C and K, each row by row\tre,im of each eigenvalue")
for reach in [5, 20, 40, 60, 80, 120]:
    for case in range(8):
        n = 3 + case % 2
        m, c, k = ([[0.0] * n for _ in range(n)] for _ in range(3))
        for i in range(n):
            size = 10 ** random.uniform(-reach, reach)
            m[i][i] = random.uniform(1, 3)
            c[i][i] = size * random.uniform(0.1, 3)
            k[i][i] = size * size * random.uniform(0.1, 3)
        if case % 4 >= 2:
            for i in range(n):
                for j in range(n):
                    if i != j:
                        k[i][j] = random.uniform(-0.3, 0.3) * (k[i][i] ** 0.5) * (k[j][j] ** 0.5)
                        c[i][j] = random.uniform(-0.3, 0.3) * (c[i][i] ** 0.5) * (c[j][j] ** 0.5)
        a = mp.matrix(2 * n, 2 * n)
        for i in range(n):
            a[i, n + i] = 1
            for j in range(n):
                a[n + i, j] = -mp.mpf(k[i][j]) / mp.mpf(m[i][i])
                a[n + i, n + j] = -mp.mpf(c[i][j]) / mp.mpf(m[i][i])
        values = mp.eig(a, left=False, right=False)
        entries = " ".join(repr(x) for matrix in (m, c, k) for row in matrix for x in row)
        pairs = " ".join(mp.nstr(mp.re(s), 17) + "," + mp.nstr(mp.im(s), 17) for s in values)
        print(n, reach, entries, pairs, sep="\t")
