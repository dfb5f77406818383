"""Modes, sensitivities, steady turns, and pictures."""

import xml.etree.ElementTree as xml

import carvallo
import numpy as np
import pytest


def test_modes_are_named(benchmark):
    modes = benchmark.modes([5.0, 6.0])
    # Table 2 of the paper: castering, capsize and weave at 5 m/s.
    assert modes.names[0].tolist() == ["castering", "capsize", "weave", "weave"] and modes.values.shape == (2, 4)
    expected = [-14.07838969279822, -0.32286642900409, -0.77534188219585 + 4.46486771378823j]
    found = modes.values[0]
    np.testing.assert_allclose([found[0], found[1], max(found[2:], key=lambda value: value.imag)], expected, rtol=1e-12)
    assert set(carvallo.Motorcycle().modes(30.0).names) >= {"weave", "wobble"}
    assert carvallo.JeffcottRotor().modes(5.0).values.shape == (4,)


def test_derivatives_are_those_of_differences(benchmark):
    sensitivity = benchmark.sensitivity()
    for name in ("w", "mB", "lam", "g"):
        step = 1e-4 * benchmark[name]
        speeds = [benchmark.replace(**{name: benchmark[name] + sign * step}).critical_speeds() for sign in (-1, 1)]
        for place, critical in enumerate(sensitivity.critical_speeds):
            difference = (speeds[1][place].speed - speeds[0][place].speed) / (2 * step)
            assert critical.by[name] == pytest.approx(difference, rel=1e-5, abs=1e-8)
    assert sensitivity.steps["w"] == 0.0102 and sensitivity.matrix_deviations is None
    assert sensitivity.critical_speeds[1].name == "weave" and sensitivity.critical_speeds[1].reason is None


def test_deviations_propagate():
    pista = carvallo.Whipple("pista")
    sensitivity = pista.sensitivity()
    for critical in sensitivity.critical_speeds:
        terms = np.array([critical.by[name] * deviation for name, deviation in pista.deviations.items()])
        assert critical.deviation == pytest.approx(np.sqrt(np.sum(terms**2)), rel=1e-12)
        assert sum(critical.shares.values()) == pytest.approx(1.0)
    # K0 of the frames: the deviation of a sum of independent terms.
    assert sensitivity.matrix_deviations["M"].shape == (2, 2) and (sensitivity.matrix_deviations["M"] > 0).all()


def test_turns_are_in_balance(benchmark):
    curves = benchmark.turns()
    assert curves[0].capsize == benchmark.critical_speeds()[-1].speed and "rest" in curves[0].end
    (curve,) = benchmark.turns(steer=0.1)[:1]
    assert curve.positions["delta"] == pytest.approx(0.1) and not curve.radius.mask.any()
    np.testing.assert_allclose(curve.speed, np.abs(curve.radius * curve.rates["psi"]), rtol=1e-9)
    with pytest.raises(ValueError, match="has no nonlinear equations"):
        carvallo.Car().turns()


def test_pictures_are_svg(benchmark, tmp_path):
    pictures = [benchmark.plot(), benchmark.plot(v=(2.0, 8.0), values=(-5.0, 5.0)), benchmark.side_view(), benchmark.sensitivity(),
                benchmark.turns(), carvallo.Car("oversteering").plot()]
    for picture in pictures:
        assert xml.fromstring(picture._repr_svg_()).tag == "{http://www.w3.org/2000/svg}svg"
    assert benchmark._repr_svg_() == benchmark.plot().svg
    assert benchmark.replace(w=np.array([1.0, 1.1]))._repr_svg_() is None
    pictures[0].save(tmp_path / "eigenvalues.svg")
    assert "Eigenvalues of benchmark against forward speed" in (tmp_path / "eigenvalues.svg").read_text()
    with pytest.raises(ValueError, match="`v` is from 8 to 2"):
        benchmark.plot(v=(8.0, 2.0))
    with pytest.raises(ValueError, match="Pendulum .*has no side view"):
        carvallo.Pendulum().side_view()
