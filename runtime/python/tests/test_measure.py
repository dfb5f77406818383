"""Bicycles from measurements, and bodies joined, against BicycleParameters."""

from pathlib import Path

import carvallo
import numpy as np
import pytest

# Two orientations of the Pista's frame were near each other, which is told; `uncertainties` makes matrices of numpy's old class.
pytestmark = pytest.mark.filterwarnings("ignore:.*°.apart:UserWarning", "ignore::PendingDeprecationWarning")

MEASURED = Path(__file__).parents[2] / "measure" / "tests" / "data" / "PistaMeasured.txt"
RIDER = {"mB": 72.0, "xB": 0.2909, "yB": 0.0, "zB": -1.1091, "IBxx": 7.9985, "IBxz": -1.9272, "IByy": 8.0689, "IBzz": 2.3624}


def test_measurements_are_what_bicycle_parameters_makes_of_them():
    main = pytest.importorskip("bicycleparameters.main")
    from bicycleparameters.io import load_parameter_text_file
    from uncertainties import correlation_matrix

    expected, _ = main.calculate_benchmark_from_measured(load_parameter_text_file(MEASURED))
    pista = carvallo.measure(MEASURED)
    assert pista.name == "Pista"
    for name, value in pista.items():
        np.testing.assert_allclose(value, expected[name].nominal_value, rtol=1e-12)
        np.testing.assert_allclose(pista.deviations[name], expected[name].std_dev, rtol=1e-11)
    for (first, second), correlation in pista.correlations.items():
        found = correlation_matrix([expected[first], expected[second]])[0, 1]
        np.testing.assert_allclose(correlation, found, atol=1e-11)


def test_bodies_are_joined_as_bicycle_parameters_does():
    inertia = pytest.importorskip("bicycleparameters.inertia")
    expected = inertia.combine_bike_rider(dict(carvallo.Whipple("pista")), dict(RIDER))
    body = ", ".join(f"{name}={value}" for name, value in RIDER.items())
    ridden = carvallo.Whipple("pista").add(body)
    for name in ["mB", "xB", "zB", "IBxx", "IByy", "IBzz", "IBxz"]:
        np.testing.assert_allclose(ridden[name], float(expected[name]), rtol=1e-13)
    assert ridden.name == "pista + 72 kg" and ridden.critical_speeds()


def test_deviations_take_account_of_correlations(tmp_path):
    pista = carvallo.measure(MEASURED)
    sensitivity = pista.sensitivity()
    names = list(pista)
    covariance = np.diag([pista.deviations.get(name, 0.0) ** 2 for name in names])
    for (first, second), correlation in pista.correlations.items():
        i, j = names.index(first), names.index(second)
        covariance[i, j] = covariance[j, i] = correlation * pista.deviations[first] * pista.deviations[second]
    smooth = [critical for critical in sensitivity.critical_speeds if critical.by]
    assert smooth
    for critical in smooth:
        by = np.array([critical.by[name] for name in names])
        np.testing.assert_allclose(critical.deviation, np.sqrt(by @ covariance @ by), rtol=1e-9)


def test_mistakes_have_the_words_of_the_command_line(tmp_path):
    with pytest.raises(ValueError, match="a body needs its `mass`"):
        carvallo.Whipple("pista").add("at=(0, 0, -1)")
    with pytest.raises(ValueError, match="there is no file"):
        carvallo.measure(tmp_path / "absent.txt")
    file = tmp_path / "me.toml"
    file.write_text("mass = 72\n")
    with pytest.raises(ValueError, match="missing: lean"):
        carvallo.rider(file)
