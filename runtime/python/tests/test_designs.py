"""Designs from names, files, dicts and keywords, and what is said of mistakes."""

import json
import pickle

import carvallo
import numpy as np
import pytest


def test_a_named_set_and_changes(benchmark):
    assert (benchmark.w, benchmark["c"], benchmark.lam) == (1.02, 0.08, np.pi / 10)
    changed = carvallo.Whipple("benchmark", w=1.1, lam="20 deg", c="9 cm")
    assert changed.w == 1.1 and changed.c == 0.09
    assert changed.lam == pytest.approx(np.radians(20.0), rel=1e-15)
    assert changed.mB == benchmark.mB and len(changed) == len(carvallo.Whipple.parameters)
    assert benchmark.replace() == benchmark and changed != benchmark


# As on the command line: one of the measured bicycles has inertias that no rigid body has.
@pytest.mark.filterwarnings("ignore:no rigid body")
def test_sets_ship_for_every_model():
    for model in carvallo.models().values():
        for name in model.sets:
            design = model(name)
            assert design.model is getattr(carvallo, model.name) and list(design) == list(model)
    assert "pista" in carvallo.Whipple.sets and carvallo.Whipple("pista").source


def test_a_dict_needs_all_parameters(benchmark):
    assert carvallo.Whipple(dict(benchmark)) == benchmark
    assert carvallo.Whipple(**dict(benchmark)) == benchmark
    few = {"w": 1.02, "c": "8 cm"}
    with pytest.raises(ValueError, match="missing: `lam`, `g`"):
        carvallo.Whipple(few)


def test_a_dict_may_have_arrays(benchmark):
    masses = np.array([80.0, 85.0, 90.0])
    designs = carvallo.Whipple(dict(benchmark) | {"mB": masses})
    assert designs.shape == (3,)
    np.testing.assert_array_equal(designs.eigenvalues(5.0)[1], benchmark.eigenvalues(5.0))
    assert carvallo.Whipple(dict(benchmark) | {"mB": np.zeros(0)}).eigenvalues(5.0).shape == (0, 4)


def test_files_in_toml_and_json(benchmark, tmp_path):
    toml = "\n".join(f"{name} = {value!r}" for name, value in benchmark.items() if name != "mB")
    (tmp_path / "mine.toml").write_text(f'name = "mine"\n[parameters]\n{toml}\nmB = "85 +/- 5 kg"\n')
    mine = carvallo.Whipple(tmp_path / "mine.toml")
    assert mine == benchmark and mine.name == "mine" and mine.deviations == {"mB": 5.0}
    assert mine.replace(w=1.1).deviations == {"mB": 5.0}
    (tmp_path / "pendulum.json").write_text(json.dumps({"model": "Pendulum", **dict(carvallo.Pendulum())}))
    assert carvallo.read(tmp_path / "pendulum.json") == carvallo.Pendulum()


def test_a_file_of_matrices(tmp_path):
    (tmp_path / "oscillator.json").write_text('{"M": [[2]], "C": [[0.4]], "K": [[8]]}')
    oscillator = carvallo.read(tmp_path / "oscillator.json")
    np.testing.assert_allclose(oscillator.eigenvalues(), [-0.1 - 1j * np.sqrt(3.99), -0.1 + 1j * np.sqrt(3.99)], rtol=1e-15)


def test_a_bicycle_in_a_model_with_more_parameters():
    pista = carvallo.WhippleSprung(carvallo.Whipple("pista"))
    np.testing.assert_allclose(pista.eigenvalues(5.0), carvallo.Whipple("pista").eigenvalues(5.0), rtol=1e-12)


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        ({"w": -1.0}, r"`w` is -1 m; it must be > 0"),
        ({"w": float("nan")}, r"`w` is NaN m; it must be > 0"),
        ({"lam": "18 m"}, "`lam` is `18 m`; `m` is no unit for it: `lam` is in rad, or in degrees"),
        ({"lamm": 0.3}, "`lamm` is not a parameter of Whipple; did you mean `lam`?"),
        ({"w": "1,02"}, "`w` is `1,02`"),
        ({"w": object()}, "`w` is <object"),
    ],
)
def test_mistakes_in_parameters(benchmark, parameters, message):
    with pytest.raises(ValueError, match=message.replace("?", r"\?")):
        benchmark.replace(**parameters)


def test_mistakes_in_arrays_name_the_design(benchmark):
    designs = benchmark.replace(w=np.array([[1.0, 1.1], [-1.0, 1.2]]))
    with pytest.raises(ValueError, match=r"^design 1, 0: `w` is -1 m; it must be > 0$"):
        designs.eigenvalues(5.0)
    with pytest.raises(ValueError, match=r"^design 1, 0: `w` is -1 m; it must be > 0$"):
        designs.stability()
    with pytest.raises(ValueError, match="there are 4 designs: choose one"):
        designs.critical_speeds()


def test_mistakes_in_sources(tmp_path):
    with pytest.raises(ValueError, match="neither a bicycle nor a file `pistta`; did you mean `pista`?"):
        carvallo.Whipple("pistta")
    with pytest.raises(ValueError, match="there is no file nowhere.toml"):
        carvallo.read("nowhere.toml")
    with pytest.raises(ValueError, match="the parameters are of the type int"):
        carvallo.Whipple(3)
    (tmp_path / "mine.toml").write_text("[parameters]\nw = -1\nc = '8 kg'\n")
    with pytest.raises(ValueError, match=r"mine.toml:2: `w` is -1 m(.|\n)*mine.toml:3: `c` is `8 kg`(.|\n)*missing: `lam`"):
        carvallo.Whipple(tmp_path / "mine.toml")


def test_warnings_of_the_command_line_are_warnings(benchmark):
    with pytest.warns(UserWarning, match="`w`.*"):
        carvallo.Whipple(dict(benchmark) | {"w": 1020.0})


def test_designs_and_models_are_pickled(benchmark):
    designs = benchmark.replace(mB=np.linspace(60.0, 120.0, 3))
    copy = pickle.loads(pickle.dumps(designs))
    assert copy == designs and copy.name == "benchmark" and copy.shape == (3,)
    assert pickle.loads(pickle.dumps(carvallo.Whipple)) is carvallo.Whipple


def test_help_tells_parameters_units_and_domains():
    text = carvallo.Whipple.__doc__
    assert "w: m, > 0. " in text and "Sets: benchmark" in text and "Meijaard" in text
    assert carvallo.__doc__ and all(getattr(carvallo, name).__doc__ for name in carvallo.__all__ if name != "__version__")
    assert set(carvallo.models()) <= set(dir(carvallo))


@pytest.mark.filterwarnings("ignore:.*computed from them")
@pytest.mark.parametrize("name", ["moore", "pydy", "principal", "jbike6", "geometry"])
def test_other_parameterizations_lead_back(benchmark, name):
    given = benchmark.to_dict(name)
    assert not set(given) >= set(benchmark)
    back = carvallo.Whipple(given)
    for parameter in benchmark:
        assert back[parameter] == pytest.approx(benchmark[parameter], rel=1e-14, abs=1e-15)
    assert benchmark.to_dict() == dict(benchmark)


def test_moores_parameters_are_those_of_bicycleparameters(benchmark):
    moore = pytest.importorskip("dtk.bicycle").benchmark_to_moore(benchmark.to_dict())
    for parameter, value in benchmark.to_dict("moore").items():
        assert value == pytest.approx(moore[parameter], rel=1e-13, abs=1e-15)


def test_unknown_parameterizations_are_told(benchmark):
    with pytest.raises(ValueError, match="there is no parameterization `more`; .*did you mean `moore`"):
        benchmark.to_dict("more")
