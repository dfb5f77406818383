"""Matrices, state space and eigenvalues, against print and numpy."""

import carvallo
import numpy as np
import pytest

MODELS = [model for model in carvallo.models().values() if model.sets]


def test_benchmark_has_the_published_matrices(benchmark):
    # Meijaard, Papadopoulos, Ruina & Schwab (2007), section 6.
    matrices = benchmark.matrices()
    np.testing.assert_allclose(matrices["M"], [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]], rtol=1e-13)
    np.testing.assert_allclose(matrices["C1"], [[0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]], rtol=1e-13)
    np.testing.assert_allclose(matrices["K0"], [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]], rtol=1e-13)
    np.testing.assert_allclose(matrices["K2"], [[0, 76.59734589573222], [0, 2.65431523794604]], rtol=1e-13)


def test_benchmark_has_the_published_eigenvalues(benchmark):
    # Table 2 of the paper, at 5 m/s.
    expected = [-14.07838969279822, -0.77534188219585 - 4.46486771378823j, -0.77534188219585 + 4.46486771378823j, -0.32286642900409]
    np.testing.assert_allclose(benchmark.eigenvalues(5.0), expected, rtol=1e-12)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.name)
def test_eigenvalues_are_those_of_the_state_matrix(model):
    design = model()
    for speed in (0.5, 3.0, 20.0):
        a, b = design.state_space(speed)
        values = design.eigenvalues(speed)
        assert a.shape == (len(model.states),) * 2 and b.shape == (len(model.states), len(model.coordinates))
        expected = list(np.linalg.eigvals(a))
        for value in values:
            nearest = min(expected, key=lambda other: abs(other - value))
            # numpy loses half of the digits where two eigenvalues meet, as at zero.
            assert abs(nearest - value) < 1e-7 * np.abs(values).max()
            expected.remove(nearest)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.name)
def test_eigenvectors_solve_the_equations(model):
    if not all(coordinate.has_position and coordinate.has_rate for coordinate in model.coordinates):
        pytest.skip(f"of {model.name} not all positions and rates are states")
    design = model()
    values, right, left = design.eigenvectors([3.0, 7.0])
    m, c, k = design.system([3.0, 7.0])
    for speed in range(2):
        for s, x, y in zip(values[speed], right[speed], left[speed]):
            q = s * s * m[speed] + s * c[speed] + k[speed]
            size = np.abs(q).max() + np.abs(k[speed]).max()
            np.testing.assert_allclose(q @ x, 0, atol=1e-10 * size)
            np.testing.assert_allclose(y.conj() @ q, 0, atol=1e-10 * size * np.abs(y).max())
            assert abs(x).max() == pytest.approx(1.0)


def test_shapes_are_those_of_designs_then_speeds(benchmark):
    designs = benchmark.replace(w=np.linspace(1.0, 1.1, 3)[:, np.newaxis], mB=np.linspace(60.0, 120.0, 5))
    assert designs.shape == (3, 5) and designs.size == 15
    speeds = np.linspace(0.0, 10.0, 8).reshape(2, 4)
    assert designs.eigenvalues(speeds).shape == (3, 5, 2, 4, 4)
    assert designs.eigenvalues(5.0).shape == (3, 5, 4)
    assert designs.state_space(speeds).A.shape == (3, 5, 2, 4, 4, 4)
    assert designs.state_space(speeds).B.shape == (3, 5, 2, 4, 4, 2)
    assert designs.matrices()["M"].shape == (3, 5, 2, 2)
    assert designs.eigenvectors(speeds).right.shape == (3, 5, 2, 4, 4, 2)
    one = designs.at(1, 2)
    assert one.w == 1.05 and one.mB == 90.0
    np.testing.assert_array_equal(designs.eigenvalues(speeds)[1, 2], one.eigenvalues(speeds))


def test_paired_speeds_are_of_one_design_each(benchmark):
    masses, speeds = np.linspace(60.0, 120.0, 7), np.linspace(1.0, 7.0, 7)
    designs = benchmark.replace(mB=masses)
    paired = designs.eigenvalues(speeds, paired=True)
    np.testing.assert_array_equal(paired, designs.eigenvalues(speeds)[np.arange(7), np.arange(7)])
    with pytest.raises(ValueError, match=r"paired speeds have the shape of the designs: \[7\]; theirs is \[6\]"):
        designs.eigenvalues(speeds[1:], paired=True)


def test_threads_change_nothing(benchmark):
    designs = benchmark.replace(mB=np.linspace(60.0, 120.0, 10_000))
    np.testing.assert_array_equal(designs.eigenvalues([3.0, 5.0], threads=1), designs.eigenvalues([3.0, 5.0], threads=4))
    for threads in 0, -1, -2**70:
        with pytest.raises(ValueError, match=f"`threads` is {threads}; it must be >= 1"):
            designs.eigenvalues(3.0, threads=threads)


def test_columns_are_not_copied(benchmark):
    masses = np.linspace(60.0, 120.0, 1000)
    designs = benchmark.replace(mB=masses)
    assert np.shares_memory(designs.mB, masses)
