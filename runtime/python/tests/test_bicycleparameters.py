"""`Meijaard2007Model` against that of BicycleParameters."""

import numpy as np
import pytest
from carvallo.bicycleparameters import Meijaard2007Model, follow

pytestmark = pytest.mark.filterwarnings("ignore")
bicycleparameters = pytest.importorskip("bicycleparameters", reason="BicycleParameters is not installed")
matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")

VARIED = {
    "nothing": {},
    "a number": {"mB": 100.0, "v": 6.0},
    "the speed": {"v": np.linspace(0.0, 10.0, 21)},
    "gravity": {"g": np.linspace(1.0, 10.0, 4)},
    "a parameter": {"w": np.linspace(1.0, 1.2, 5)},
    "a parameter and the speed": {"lam": np.linspace(0.1, 0.4, 5), "v": np.linspace(1.0, 9.0, 5)},
}


@pytest.fixture
def both():
    from bicycleparameters.models import Meijaard2007Model as Theirs
    from bicycleparameters.parameter_dicts import meijaard2007_browser_jason
    from bicycleparameters.parameter_sets import Meijaard2007ParameterSet

    parameters = Meijaard2007ParameterSet(meijaard2007_browser_jason, True)
    return Theirs(parameters), Meijaard2007Model(parameters)


@pytest.mark.parametrize("varied", VARIED.values(), ids=VARIED)
def test_matrices_are_theirs(both, varied):
    theirs, ours = both
    for name in ("form_reduced_canonical_matrices", "form_state_space_matrices"):
        for expected, found in zip(getattr(theirs, name)(**varied), getattr(ours, name)(**varied), strict=True):
            assert found.shape == expected.shape
            np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("left", [False, True])
@pytest.mark.parametrize("varied", VARIED.values(), ids=VARIED)
def test_eigenvalues_and_eigenvectors_are_theirs(both, varied, left):
    theirs, ours = both
    (expected, expected_vectors), (found, vectors) = theirs.calc_eigen(left=left, **varied), ours.calc_eigen(left=left, **varied)
    assert found.shape == expected.shape and vectors.shape == expected_vectors.shape
    rows = zip(*(array.reshape(-1, *array.shape[array.ndim - rank :]) for array, rank in
                 ((expected, 1), (expected_vectors, 2), (found, 1), (vectors, 2))), strict=True)
    for their_values, their_vectors, our_values, our_vectors in rows:
        for place, value in enumerate(our_values):
            index = np.abs(their_values - value).argmin()
            assert abs(their_values[index] - value) < 1e-10
            # Up to the sign, which is nobody's.
            ours_of, theirs_of = our_vectors[:, place], their_vectors[:, index]
            np.testing.assert_allclose(ours_of * np.sign(np.vdot(ours_of, theirs_of).real), theirs_of, atol=1e-8)


def test_a_mapping_serves_as_a_parameter_set(both):
    theirs, ours = both
    plain = Meijaard2007Model(theirs.parameter_set.parameters)
    np.testing.assert_array_equal(plain.calc_eigen()[0], ours.calc_eigen()[0])
    assert ours.state_vars == theirs.state_vars and ours.input_units == theirs.input_units


def test_motions_are_theirs(both):
    theirs, ours = both
    times, start = np.linspace(0.0, 2.0, 21), [0.1, 0.0, 0.0, 0.05]
    expected, _ = theirs.simulate(times, start, v=5.0)
    found, inputs = ours.simulate(times, start, v=5.0)
    # Theirs are integrated with the tolerance of SciPy, 1e-3.
    np.testing.assert_allclose(found, expected, atol=2e-3)
    assert inputs.shape == (21, 2)

    def steer(_, x):
        return [0.0, -2.0 * x[2]]

    expected, expected_inputs = theirs.simulate(times, start, input_func=steer, v=5.0)
    found, inputs = ours.simulate(times, start, input_func=steer, v=5.0)
    np.testing.assert_allclose(found, expected, atol=2e-3)
    np.testing.assert_allclose(inputs, expected_inputs, atol=4e-3)
    assert ours.simulate_modes(times, v=5.0).shape == theirs.simulate_modes(times, v=5.0).shape
    with pytest.raises(ValueError, match="Can only simulate with fixed parameters."):
        ours.simulate(times, start, v=times)


def test_mistakes_are_theirs(both):
    for model in both:
        with pytest.raises(ValueError, match="All array valued parameters must have the same length."):
            model.calc_eigen(v=[1.0, 2.0], w=[1.0, 1.1, 1.2])
        with pytest.warns(UserWarning, match="wheelbase is not a valid parameter, ignoring"):
            model.calc_eigen(wheelbase=1.0)


def test_plots_have_their_shapes(both):
    theirs, ours = both
    speeds, times = np.linspace(0.0, 10.0, 21), np.linspace(0.0, 1.0, 11)
    expected, found = theirs.plot_eigenvalue_parts(v=speeds), ours.plot_eigenvalue_parts(v=speeds)
    assert found.get_xlabel() == expected.get_xlabel() and found.get_ylabel() == expected.get_ylabel()
    assert len(found.lines) == len(expected.lines) == 8
    assert ours.plot_eigenvectors(v=[1.0, 3.0]).shape == theirs.plot_eigenvectors(v=[1.0, 3.0]).shape
    assert ours.plot_mode_simulations(times, v=6.0).shape == theirs.plot_mode_simulations(times, v=6.0).shape
    assert len(ours.plot_simulation(times, [0.1, 0, 0, 0], v=6.0)) == len(theirs.plot_simulation(times, [0.1, 0, 0, 0], v=6.0))


def test_lines_are_continuous_and_lose_no_eigenvalue(both):
    _, ours = both
    evals, _ = ours.calc_eigen(v=np.linspace(0.0, 10.0, 1001))
    followed = follow(evals)
    np.testing.assert_allclose(np.sort_complex(followed), np.sort_complex(evals), atol=0)
    assert np.abs(np.diff(followed, axis=0)).max() < 0.5
