"""Designs as files, equations as text, and arrays of designs as maps and samples."""

import warnings
import xml.etree.ElementTree as xml

import numpy as np
import pytest

import carvallo

UNITS = {"toml": "mm,deg", "json": "imperial", "yaml": "si", "csv": "cm,deg", "python": "si", "matlab": "si", "text": "si"}


@pytest.mark.parametrize(("form", "ending"), [("toml", "toml"), ("json", "json"), ("yaml", "yaml"), ("csv", "csv"), ("python", "py"),
                                              ("matlab", "m"), ("text", "txt")])
def test_files_are_read_again(form, ending, tmp_path):
    pista = carvallo.Whipple("pista")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore" if form in ("python", "matlab") else "error")
        text = pista.to_text(form, units=UNITS[form])
    path = tmp_path / f"pista.{ending}"
    path.write_text(text, encoding="utf-8")
    again = carvallo.Whipple(path)
    for name, value in pista.items():
        assert again[name] == pytest.approx(value, rel=1e-15 if UNITS[form] != "si" else 0.0, abs=0.0)


def test_what_has_no_place_is_told():
    with pytest.warns(UserWarning, match="a script has no place for standard deviations: left out"):
        carvallo.Whipple("pista").to_text("python", "moore")
    law = "Tdelta = phi_rate"
    assert law in carvallo.Whipple("benchmark").with_feedback(law).to_text()
    assert "d1" in carvallo.Whipple("benchmark").to_text("json", "moore")
    assert "model = \"Pendulum\"" in carvallo.Pendulum().to_text()
    for arguments, message in [
        (("tml",), "`form` is `tml`; expected one of toml, json"),
        (("json", "foo"), "there is no parameterization `foo`"),
    ]:
        with pytest.raises(ValueError, match=message):
            carvallo.Whipple("pista").to_text(*arguments)
    with pytest.raises(ValueError, match="this form has no place for `units`"):
        carvallo.Whipple("pista").to_text("text", units="mm")


def test_equations_are_written():
    assert "M_11 = m*l^2 [kg*m^2]" in carvallo.Pendulum.equations()
    assert r"\begin{align" in carvallo.Pendulum.equations("latex")
    with pytest.raises(ValueError, match="`notation` is `word`"):
        carvallo.Pendulum.equations("word")


def test_examples_are_read(tmp_path):
    for of in ("measure", "rider"):
        (tmp_path / f"{of}.toml").write_text(carvallo.example(of), encoding="utf-8")
    with pytest.warns(UserWarning, match="no rigid body has the inertias"):
        measured = carvallo.measure(tmp_path / "measure.toml")
    assert measured.deviations and "mass" in carvallo.rider(tmp_path / "rider.toml")
    with pytest.raises(ValueError, match="there is no example of 'bike'"):
        carvallo.example("bike")


def test_samples_are_drawn_from_what_was_measured(tmp_path):
    (tmp_path / "measured.toml").write_text(carvallo.example("measure"), encoding="utf-8")
    with pytest.warns(UserWarning, match="no rigid body has the inertias"):
        measured = carvallo.measure(tmp_path / "measured.toml")
    samples = measured.samples(20_000, seed=1)
    assert samples.shape == (20_000,) and samples == measured.samples(20_000, seed=1)
    for name, deviation in measured.deviations.items():
        assert np.mean(samples[name]) == pytest.approx(measured[name], abs=5 * deviation / np.sqrt(20_000))
        assert np.std(samples[name]) == pytest.approx(deviation, rel=0.03)
    assert any(abs(value) > 0.3 for value in measured.correlations.values())
    for (first, second), value in measured.correlations.items():
        assert np.corrcoef(samples[first], samples[second])[0, 1] == pytest.approx(value, abs=0.04)
    with pytest.raises(ValueError, match="no parameter with a standard deviation"):
        carvallo.Whipple("benchmark").samples(10)


def test_maps_show_two_parameters(benchmark):
    w, c = np.linspace(0.9, 1.2, 7), np.linspace(0.0, 0.16, 9)
    designs = benchmark.replace(w=w[:, np.newaxis], c=c)
    svg = designs.map(benchmark).svg
    assert "Stability of benchmark over two parameters" in "".join(xml.fromstring(svg).itertext())
    # Without the cross of the base.
    assert len(designs.map(threads=1).svg) < len(svg)
    # The parameter of the second axis is to the right: the other way round it is another picture.
    assert benchmark.replace(w=w, c=c[:, np.newaxis]).map(benchmark).svg != svg
    for wrong, message in [
        (benchmark, "a map needs two axes"),
        (benchmark.replace(w=w[:, np.newaxis], mB=w[:, np.newaxis], c=c), "2 parameters vary along axis 0"),
        (benchmark.replace(w=w[:, np.newaxis] + 0.0 * c), "a map needs two axes|0 parameters vary along axis 1"),
        (benchmark.replace(w=w[:, np.newaxis] + c, c=c), "a parameter varies along both axes"),
    ]:
        with pytest.raises(ValueError, match=message):
            wrong.map()
    with pytest.raises(ValueError, match="the base is of the model Pendulum"):
        designs.map(carvallo.Pendulum())


@pytest.mark.parametrize(("call", "message"), [
    (lambda: carvallo.optimize(carvallo.Whipple(), {}, minimize="weave-speed"), r'such as \{"w": \(0.9, 1.2\)\} for `vary`$'),
    (lambda: carvallo.optimize(carvallo.Whipple(), {"w": (0.9, 1.2)}, minimize="weave-speed", seed=-1), "`seed` is -1"),
    (lambda: carvallo.Pendulum({}), r"`carvallo.Pendulum\(\).to_text\(\)` is a file to start from$"),
    (lambda: carvallo.measure("/dev/null"), r'`carvallo.example\("measure"\)` is a file to start from$'),
    (lambda: carvallo.check({}), "^there are no numbers to check"),
    (lambda: carvallo.check({"eigenvalues": [1]}), "^`eigenvalues` has no speed"),
    (lambda: carvallo.Pendulum("benchmark"), "it belongs to `carvallo"),
])
def test_messages_speak_of_python(call, message):
    with pytest.raises(ValueError, match=message) as raised:
        call()
    assert "--" not in str(raised.value) and "`carvallo show" not in str(raised.value)
