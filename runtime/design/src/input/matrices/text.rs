//! Matrices in the text of scripts: `[80 2; 2 0.3]` of MATLAB, `np.array([[80, 2], [2, 0.3]])` of Python, and what NumPy prints.

use crate::failure::Place;
use crate::input::names::without_owner;
use crate::input::tables::{Node, Value};
use crate::input::texts::unquoted;
use crate::matrices::MOST;

/// Whether a value begins as a matrix does, perhaps within a call such as `np.array(`; or is `zeros(2)` or `eye(2)`.
pub fn is_list(value: &str) -> bool {
    without_call(value).is_some_and(|text| text.starts_with('[')) || made(value).is_some()
}

/// Whether it has several rows, or one in brackets of its own.
pub fn has_rows(value: &str) -> bool {
    let several = matches!(list(value, &|_| Place::Nowhere), Some(Value::List(rows)) if rows.len() > 1);
    let first = without_call(value).and_then(|text| text.strip_prefix('['));
    several || first.is_some_and(|row| row.trim_start().starts_with('['))
}

/// Whether a list that has begun has no end yet.
pub fn is_open(value: &str) -> bool {
    is_list(value) && depth(value) > 0
}

/// The rows of a matrix, each at the place that belongs to the number of lines before it; `None` if the text is none.
pub fn list(value: &str, place: &dyn Fn(usize) -> Place) -> Option<Value> {
    let value = value.trim();
    if let Some(rows) = made(value) {
        let node = |value: Value| Node { place: place(0), value };
        let row =
            |row: Vec<&str>| node(Value::List(row.into_iter().map(|it| node(Value::Text(it.to_owned()))).collect()));
        return Some(Value::List(rows.into_iter().map(row).collect()));
    }
    let inner = without_call(value)?.strip_prefix('[')?;
    let start = value.len() - inner.len();
    let end = closing(inner)?;
    // A call may be given other things as well.
    let behind = inner[end + 1..].trim_end_matches(';').trim();
    if !(behind.is_empty() || !value.starts_with('[') && behind.ends_with(')')) {
        return None;
    }
    let inner = &inner[..end];
    let rows = if inner.trim_start().starts_with('[') { nested(inner)? } else { separated(inner) };
    let row = |(at, row): (usize, &str)| {
        let indent = row.len() - row.trim_start().len();
        let place = place(value[..start + at + indent].matches('\n').count());
        let entry = |entry: String| Node { place: place.clone(), value: Value::Text(unquoted(&entry).to_owned()) };
        Node { place: place.clone(), value: Value::List(entries(row).into_iter().map(entry).collect()) }
    };
    Some(Value::List(rows.into_iter().map(row).collect()))
}

/// The matrices of zeros and ones that scripts make: `zeros(2)`, `zeros(2, 2)`, `np.zeros((2, 2))`, `eye(2)` and
/// `np.identity(2)`.
fn made(value: &str) -> Option<Vec<Vec<&'static str>>> {
    let (name, sizes) = value.trim().trim_end_matches(';').trim_end().strip_suffix(')')?.split_once('(')?;
    let diagonal = match without_owner(name.trim_end()) {
        "zeros" => "0",
        "eye" | "identity" => "1",
        _ => return None,
    };
    let sizes = sizes.trim().trim_start_matches('(').trim_end_matches(')').split(',').map(str::trim);
    let sizes: Vec<usize> =
        sizes.filter(|size| !size.is_empty()).map(|size| size.parse().ok()).collect::<Option<_>>()?;
    let (rows, columns) = match sizes[..] {
        [size] => (size, size),
        [rows, columns] => (rows, columns),
        _ => return None,
    };
    // One more than there may be is told like any other.
    let (rows, columns) = (rows.min(MOST + 1), columns.min(MOST + 1));
    let row = |row| (0..columns).map(|column| if row == column { diagonal } else { "0" }).collect();
    Some((0..rows).map(row).collect())
}

/// What stands within a call such as `np.array(`, or a value that is in none.
fn without_call(value: &str) -> Option<&str> {
    let value = value.trim_start();
    let name = value.find(|sign: char| !sign.is_alphanumeric() && sign != '.' && sign != '_')?;
    match value[name..].strip_prefix('(') {
        Some(inner) if name > 0 => Some(inner.trim_start()),
        _ => (name == 0).then_some(value),
    }
}

/// How many brackets are open at the end.
fn depth(text: &str) -> i32 {
    text.chars().fold(0, |depth, sign| depth + step(sign))
}

fn step(sign: char) -> i32 {
    match sign {
        '[' | '(' => 1,
        ']' | ')' => -1,
        _ => 0,
    }
}

/// Where the bracket stands that closes a list whose first bracket is not in the text.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 1;
    text.char_indices()
        .find(|&(_, sign)| {
            depth += step(sign);
            depth == 0
        })
        .map(|(at, _)| at)
}

/// Rows in brackets of their own, and where they begin.
fn nested(text: &str) -> Option<Vec<(usize, &str)>> {
    let mut rows = Vec::new();
    let mut at = 0;
    while let Some(open) = text[at..].find('[') {
        let begin = at + open + 1;
        let end = begin + closing(&text[begin..])?;
        rows.push((begin, &text[begin..end]));
        at = end + 1;
    }
    Some(rows)
}

/// Rows that semicolons or ends of lines separate, and where they begin.
fn separated(text: &str) -> Vec<(usize, &str)> {
    let mut at = 0;
    let mut rows = Vec::new();
    for row in text.split([';', '\n']) {
        if !row.trim().is_empty() {
            rows.push((at, row));
        }
        at += row.len() + 1;
    }
    rows
}

/// The entries of a row: commas separate them, or where there is none, spaces, other than around the sign of an expression.
fn entries(row: &str) -> Vec<String> {
    let mut parts = split(row, ',');
    if parts.len() > 1 {
        // Python allows a comma behind the last entry.
        parts.pop_if(|last| last.is_empty());
        return parts;
    }
    let mut entries: Vec<String> = Vec::new();
    let is_operator = |sign: char| matches!(sign, '+' | '-' | '*' | '/' | '^');
    for word in split(row, ' ').into_iter().filter(|word| !word.is_empty()) {
        let goes_on = entries.last().is_some_and(|last| last.ends_with(is_operator))
            || word.chars().all(is_operator)
            || word.starts_with(['*', '/', '^']);
        match entries.last_mut() {
            Some(last) if goes_on => last.push_str(&word),
            _ => entries.push(word),
        }
    }
    entries
}

/// What a sign separates outside of parentheses; a space is any white space.
fn split(row: &str, separator: char) -> Vec<String> {
    let mut depth = 0;
    let mut parts = vec![String::new()];
    for sign in row.chars() {
        depth += step(sign);
        let sign = if sign.is_whitespace() { ' ' } else { sign };
        match parts.last_mut() {
            Some(last) if sign != separator || depth > 0 => last.push(sign),
            _ => parts.push(String::new()),
        }
    }
    parts.iter().map(|part| part.trim().to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::{is_open, list};
    use crate::failure::Place;
    use crate::input::tables::Value;

    fn rows(text: &str) -> Option<Vec<Vec<String>>> {
        let Value::List(rows) = list(text, &|_| Place::Nowhere)? else { return None };
        let entries = |value: Value| match value {
            Value::List(entries) => entries,
            _ => Vec::new(),
        };
        let text = |value: Value| match value {
            Value::Text(text) => text,
            _ => String::new(),
        };
        Some(
            rows.into_iter()
                .map(|row| entries(row.value).into_iter().map(|entry| text(entry.value)).collect())
                .collect(),
        )
    }

    #[test]
    fn matrices_of_matlab_python_and_numpy_are_read() {
        for text in [
            "[1, 2; 3, -4]",
            "[1 2; 3 -4]",
            "[1 2\n 3 -4]",
            "[1, 2;\n 3, -4;]",
            "[[1, 2], [3, -4]]",
            "[[1, 2,], [3, -4],]",
            "[[ 1  2]\n [ 3 -4]]",
            "np.array([[1, 2], [3, -4]])",
            "numpy.array([[1, 2],\n [3, -4]], dtype=float)",
            "array([[ 1, 2],\n       [ 3, -4]])",
            "sym.Matrix([[1, 2], [3, -4]])",
        ] {
            assert_eq!(
                rows(text),
                Some(vec![vec!["1".to_owned(), "2".into()], vec!["3".into(), "-4".into()]]),
                "{text}"
            );
        }
    }

    #[test]
    fn entries_may_be_expressions() {
        let expected = vec![vec!["2*m".to_owned(), "-(a - b)/2".into(), "hypot(3, 4)".into(), "1-2".into()]];
        for text in ["[2*m -(a - b)/2 hypot(3, 4) 1 - 2]", "[2*m, -(a - b)/2, hypot(3, 4), 1-2]"] {
            assert_eq!(rows(text), Some(expected.clone()), "{text}");
        }
    }

    #[test]
    fn matrices_of_zeros_and_ones_are_made() {
        let of =
            |rows: &[&[&str]]| Some(rows.iter().map(|row| row.iter().map(|&it| it.to_owned()).collect()).collect());
        for (text, expected) in [
            ("zeros(2)", of(&[&["0", "0"], &["0", "0"]])),
            ("zeros(1, 2);", of(&[&["0", "0"]])),
            ("np.zeros((2, 1))", of(&[&["0"], &["0"]])),
            ("np.eye(2)", of(&[&["1", "0"], &["0", "1"]])),
            ("numpy.identity(1)", of(&[&["1"]])),
            ("eye(n)", None),
            ("2*eye(2)", None),
        ] {
            assert_eq!(rows(text), expected, "{text}");
        }
    }

    #[test]
    fn what_goes_on_is_told_from_what_is_whole() {
        assert!(["[1 2", "np.array([[1, 2],", "[[1, 2]", "np.array([[1]]"].iter().all(|text| is_open(text)));
        assert!(["[1 2]", "1.02 [m", "hypot(3, [", "m"].iter().all(|text| !is_open(text)));
    }
}
