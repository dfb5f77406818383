"""Checks of somebody's numbers; the matrices are those that the paper prints, rounded."""

import carvallo
import numpy as np
import pytest

MATRICES = {
    "M": [[80.817, 2.3194], [2.3194, 0.29784]],
    "C1": [[0, 33.866], [-0.85036, 1.6854]],
    "K0": [[-80.95, -2.5995], [-2.5995, -0.80329]],
    "K2": [[0, 76.597], [0, 2.6543]],
}


def test_numbers_that_agree():
    report = carvallo.check(MATRICES)
    assert report.agrees and report.explanations == () and len(report.numbers) == 16
    assert report.numbers[1] == ("M_12", "kg*m^2", "2.3194", pytest.approx(2.31941332208709), 5, True, None)
    assert "All 16 numbers agree" in str(report)


def test_a_slip_is_named():
    report = carvallo.check({**MATRICES, "K2": np.array([[0, 0], [0, 2.6543]])})
    assert not report.agrees
    assert report.explanations[0].causes == ("K2 was filled row by column: K2_12 has the value of K2_21",)
    assert {number.name for number in report.numbers if not number.agrees} == {"K2_12"}


def test_eigenvalues_of_numpy_agree():
    pista = carvallo.Whipple("pista")
    a = pista.state_space(5.0).A
    eigenvalues = np.linalg.eigvals(a)
    assert carvallo.check({"speed": 5.0, "A": a, "eigenvalues": eigenvalues}, "pista").agrees
    assert not carvallo.check({"speed": 5.0, "eigenvalues": {5.0: eigenvalues}}, "benchmark").agrees


def test_a_file_and_what_is_not_understood(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text("critical_speeds = { weave = 4.2924 }\n")
    assert carvallo.check(path).agrees
    with pytest.raises(ValueError, match="did you mean `eigenvalues`"):
        carvallo.check({"eigenvalue": [1.0]})
    with pytest.raises(ValueError, match="no model `Wipple`"):
        carvallo.check(MATRICES, model="Wipple")
    with pytest.raises(TypeError, match="set is no number"):
        carvallo.check({"M": {1, 2}})


def test_a_closed_loop_in_other_units():
    """What is fed back takes -10 from C0_21; 4.29238253634111 m/s times 3.6 is 15.4526 km/h."""
    law = "Tdelta = -10*phi_rate"
    assert carvallo.check({"C0": [[0, 0], [10, 0]]}, feedback=law).agrees
    report = carvallo.check({"C0": [[0, 0], [-10, 0]]}, feedback=[law])
    assert report.explanations[0].causes == ("the feedback has the other sign",)
    number = carvallo.check({"critical_speeds": {"weave": 4.2924}}, units="km/h").numbers[0]
    assert (number.unit, number.yours, number.ours) == ("km/h", "15.453", pytest.approx(4.29238253634111 * 3.6))
    with pytest.raises(ValueError, match="expected units such as mm,deg,km/h"):
        carvallo.check(MATRICES, units="")
    with pytest.raises(ValueError, match="feedback 'Tdelta=x'"):
        carvallo.check(MATRICES, feedback="Tdelta=x")
