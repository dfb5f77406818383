//! What names mean in files that give matrices.

use carvallo::MatrixName;

use crate::input::names::without_owner;
use crate::matrices::MOST;
use crate::nearest::nearest;

pub const COORDINATES: &str = "coordinates";

/// What else than matrices such a file may have.
const OTHERS: [&str; 5] = ["g", COORDINATES, "name", "kind", "source"];

/// The matrix of a name: `C1` by `C1`, `C_1` and `C₁`, `C-1` also by `Cm1` and `Cminus1`; `Kc` by `K` and `C0` by `C` and `D`.
pub fn matrix(name: &str) -> Option<MatrixName> {
    let digit = |sign: char| match sign {
        '₀' => '0',
        '₁' => '1',
        '₂' => '2',
        '₋' | '−' | '⁻' => '-',
        other => other,
    };
    let short: String = without_owner(name).chars().filter(|sign| !"_^{}() ".contains(*sign)).map(digit).collect();
    let usual = match short.as_str() {
        "Cm1" | "Cminus1" => "C-1",
        "C" | "D" => "C0",
        "K" => "Kc",
        short => short,
    };
    MatrixName::ALL.into_iter().find(|matrix| matrix.name() == usual)
}

/// The matrix of a name that has rows behind it, in letters of either case.
pub fn matrix_of_rows(name: &str) -> Option<MatrixName> {
    let capitalized = || {
        let name = without_owner(name);
        let first = name.chars().next()?;
        matrix(&format!("{}{}", first.to_ascii_uppercase(), &name[first.len_utf8()..]))
    };
    matrix(name).or_else(capitalized)
}

/// Whether a name is that of damping or of stiffness without a word on the speed and gravity.
pub fn is_plain(name: &str) -> bool {
    ["C", "D", "K"].iter().any(|plain| plain.eq_ignore_ascii_case(without_owner(name)))
}

/// The entry of a matrix that a parameter is: `M_12`, or `M_1_12`; its row and its column, from one.
pub fn entry(name: &str) -> Option<(MatrixName, usize, usize)> {
    let (start, end) = name.rsplit_once('_')?;
    let (of, row, column) = match matrix(start) {
        Some(of) => (of, end.get(..1)?, end.get(1..)?),
        None => {
            let (start, row) = start.rsplit_once('_')?;
            (matrix(start)?, row, end)
        }
    };
    let index = |text: &str| text.parse::<usize>().ok().filter(|number| (1..=MOST).contains(number));
    Some((of, index(row)?, index(column)?))
}

/// That a name is none of those that are known beside matrices, and what was meant.
pub fn unknown(name: &str) -> String {
    let names = MatrixName::ALL.map(MatrixName::name).into_iter().chain(OTHERS);
    let expected: Vec<String> = names.clone().map(|name| format!("`{name}`")).collect();
    let hint = hint(name, names.chain(["gravity"]));
    format!("`{name}` is not known beside matrices; expected {}{hint}", expected.join(", "))
}

/// That a name is no matrix, and which was meant.
pub fn no_matrix(name: &str) -> String {
    let names = MatrixName::ALL.map(MatrixName::name);
    format!("`{name}` is no matrix; expected `{}`{}", names.join("`, `"), hint(name, names))
}

fn hint<'a>(name: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, names).map(|name| format!("; did you mean `{name}`?")).unwrap_or_default()
}
