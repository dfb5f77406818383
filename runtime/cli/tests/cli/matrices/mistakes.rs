//! What is wrong with files that give matrices.

use super::chain;
use crate::Directory;

#[test]
fn mistakes_are_told_at_their_place() {
    let directory = Directory::new("matrices-mistakes");
    let rows = "expected a list of rows, such as [[1, 0], [0, 1]]";
    let known = "expected `M`, `C-1`, `C0`, `C1`, `Kc`, `K0`, `K1`, `K2`, `g`, `coordinates`, `name`, `kind`, `source`";
    let both = r#""M": [[1, 0], [0, 1]], "Kc": [[1, 0], [0, 1]]"#;
    let number = "expected a number, or an expression such as `pi/10`";
    for (text, message) in [
        ("\"M\": [1, 2]".to_owned(), format!("1: `M` is one list of 2; {rows}")),
        ("\"M\": []".to_owned(), format!("1: `M` is empty; {rows}")),
        (
            "\"M\": [[1, 2]]".to_owned(),
            "1: row 1 of `M` has 2 numbers; expected 1, as many as there are rows".to_owned(),
        ),
        (
            "\"M\": [[1, 2],\n [3]]".to_owned(),
            "2: row 2 of `M` has 1 number; expected 2, as many as there are rows".to_owned(),
        ),
        (
            "\"M\": [[1, 0], [0, 1]],\n\"K0\": [[1]]".to_owned(),
            "2: `K0` has 1 row; expected 2 rows of 2 numbers, as `M` has".to_owned(),
        ),
        ("\"K0\": [[1]]".to_owned(), "1: `M` is not given; expected 1 row of 1 number".to_owned()),
        ("\"M\": [[1,\n NaN], [0, 1]]".to_owned(), "2: `M_12` is `NaN`; expected a finite number".to_owned()),
        ("\"M\": [[1, 0],\n [null, 1]]".to_owned(), format!("2: `M_21` is null; {number}")),
        (format!("{both}, \"Q\": 4"), format!("1: `Q` is not known beside matrices; {known}")),
        (
            format!("{both}, \"gravty\": 4"),
            format!("1: `gravty` is not known beside matrices; {known}; did you mean `gravity`?"),
        ),
        (format!("{both},\n \"g\": -9.81"), "2: `g` is -9.81 N/kg; it must be >= 0".to_owned()),
        (
            format!("{both},\n \"K\": [[1, 0], [0, 1]]"),
            "2: `K` is `Kc`, which is given twice; first at a.json:1".to_owned(),
        ),
        (format!("{both},\n \"Kc\": [[1, 0], [0, 1]]"), "2: `Kc` is given twice; first at a.json:1".to_owned()),
        (
            format!("{both}, \"coordinates\": [\"a\"]"),
            "1: `coordinates` has 1 name; expected 2, one for each row of `M`".to_owned(),
        ),
        (format!("{both}, \"coordinates\": [\"a\", \"a\"]"), "1: two of the `coordinates` are called `a`".to_owned()),
        (
            format!("{both}, \"coordinates\": {{\"a\": \"rate\", \"b\": \"speed\"}}"),
            "1: what is `only` a state is `speed`; expected \"rate\", \"position\" or \"both\"".to_owned(),
        ),
    ] {
        directory.write("a.json", format!("{{{text}}}"));
        directory.run(&["analyze", "a.json"]).fails(2, &format!("error: a.json:{message}\n"));
    }
}

#[test]
fn what_cannot_be_inverted_is_told_by_its_coordinate() {
    let directory = Directory::new("matrices-singular");
    let singular = "`M` is singular, and it must be invertible:";
    for (m, coordinates, message) in [
        (
            "[[1, 2, 3], [2, 4, 5], [1, 2, 9]]",
            "[\"x\", \"phi\", \"delta\"]",
            "its column of `phi` depends on those before it",
        ),
        ("[[1, 2, 3], [0, 0, 0], [1, 2, 9]]", "[\"x\", \"phi\", \"delta\"]", "its row of `phi` is zero"),
        (
            "[[1, 2, 0], [2, 1, 0], [1, 2, 0]]",
            "[\"x\", \"phi\", \"F\"]",
            "its column of `F` is zero; where only the position of `F` is a state, `coordinates` says so by \
             `only = \"position\"`",
        ),
    ] {
        directory.write("a.toml", format!("coordinates = {coordinates}\nM = {m}\n"));
        directory.run(&["analyze", "a.toml"]).fails(2, &format!("error: a.toml: {singular} {message}\n"));
    }
    let states = "coordinates = { y = \"rate\", F = \"position\" }\nM = [[1, 0], [0, 0]]\nKc = [[0, 1], [0, 1]]\n";
    for (other, message) in [
        (
            "",
            "of `F` only the position is a state, but no damping matrix has its rate: its column of `C-1`, `C0` or `C1` \
             must not be zero",
        ),
        (
            "C0 = [[0, 0], [0, 1]]\nK2 = [[0, 0], [3, 0]]",
            "`K2_21` is 3, but of `y` only the rate is a state: its column of every stiffness matrix must be zero",
        ),
    ] {
        directory.write("a.toml", format!("{states}{other}"));
        directory.run(&["analyze", "a.toml"]).fails(2, &format!("error: a.toml: {message}\n"));
    }
    directory.write("a.toml", "coordinates = { F = \"position\" }\nM = [[1]]\nC0 = [[1]]\n");
    let message = "`M_11` is 1, but of `F` only the position is a state: its column of `M` must be zero";
    directory.run(&["analyze", "a.toml"]).fails(2, &format!("error: a.toml: {message}\n"));
}

#[test]
fn matrices_and_models_do_not_mix() {
    let directory = Directory::new("matrices-mix");
    directory.write("a.json", chain(2));
    let message = "error: a.json: the parameters are for the model `Matrices`, but --model is Pendulum\n";
    directory.run(&["analyze", "a.json", "--model", "Pendulum"]).fails(2, message);
    let plain = directory.run(&["analyze", "a.json"]).ok();
    assert_eq!(directory.run(&["analyze", "a.json", "--model", "matrices"]).ok(), plain);
    directory.write("b.json", chain(2).replacen('{', "{\"model\": \"Pendulum\", ", 1));
    let message = "error: b.json: there are matrices in the place of parameters of the model `Pendulum`\n";
    directory.run(&["analyze", "b.json"]).fails(2, message);
    directory.write("c.toml", "w = 1\n");
    let message = "error: c.toml: there are no matrices; expected `M` and others, in JSON or TOML\n";
    directory.run(&["analyze", "c.toml", "--model", "Matrices"]).fails(2, message);
}
