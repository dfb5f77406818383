//! Numbers with their digits, as files have them.

use carvallo_design::input::{Named, Node, Value, list};
use carvallo_design::quantity::{Context, Measured, Mistake, Reason, measured, no_names, number};
use carvallo_design::{Place, Problem, speeds};

use crate::given::{Reading, Rows, level};

/// In m/s: what is faster is no machine's, and its powers soon are no numbers.
const FASTEST: f64 = 1e9;

/// What is wrong, and where.
pub fn problem(place: &Place, message: impl Into<String>) -> Problem {
    Problem { place: place.clone(), message: message.into() }
}

/// A number; `None` where it is said that it is not known.
///
/// # Errors
/// That it is none.
pub fn reading(node: &Node, what: &str) -> Result<Option<Reading>, Problem> {
    match &node.value {
        Value::Number(text) | Value::Text(text) => of_text(text).map_err(|why| {
            problem(
                &node.place,
                format!("{what} is `{text}`; expected a number such as 2.320 or `2.32 +/- 0.01`: {why}"),
            )
        }),
        Value::Other("null") => Ok(None),
        Value::Table(members) => of_members(members, node, what).map(Some),
        Value::List(_) => Err(problem(&node.place, format!("{what} is a list; expected a number"))),
        Value::Other(other) => Err(problem(&node.place, format!("{what} is {other}; expected a number"))),
    }
}

/// A number of a text; `None` where the text says that it is not known.
///
/// # Errors
/// Why it is none, as the end of a sentence.
pub fn of_text(text: &str) -> Result<Option<Reading>, String> {
    let text = text.trim();
    if matches!(text, "" | "-" | "?" | "…" | "...") {
        return Ok(None);
    }
    let context = Context { unit: "1", names: &no_names };
    let Measured { mean, deviation } = measured(text, context).map_err(reason)?;
    Ok(Some(match deviation {
        Some(deviation) if deviation.value < 0.0 => {
            return Err(format!("the tolerance is {}; expected one >= 0", deviation.value));
        }
        Some(deviation) => Reading { written: text.to_owned(), ..Reading::within(mean.value, deviation.value) },
        None => Reading::printed(text.to_owned(), mean.value),
    }))
}

fn reason(mistake: Mistake) -> String {
    match mistake.reason {
        Reason::Unit(unit) => format!("`{unit}` is no unit for it; numbers are in SI units"),
        Reason::Other(reason) => reason,
    }
}

/// `{ value = 2.32, tolerance = 0.01 }`
fn of_members(members: &[Named], node: &Node, what: &str) -> Result<Reading, Problem> {
    let (mut value, mut tolerance) = (None, None);
    for Named { name, node } in members {
        match name.as_str() {
            "value" => value = reading(node, what)?,
            "tolerance" | "std" => {
                tolerance = reading(node, &format!("the {name} of {what}"))?;
                if let Some(own) = tolerance.as_ref().filter(|own| own.value < 0.0) {
                    let message = format!("the {name} of {what} is {}; expected one >= 0", own.written);
                    return Err(problem(&node.place, message));
                }
            }
            other => {
                let message = format!("{what} has a member `{other}`; expected `value` and `tolerance`");
                return Err(problem(&node.place, message));
            }
        }
    }
    let value = value.ok_or_else(|| problem(&node.place, format!("{what} has no `value`")))?;
    Ok(match tolerance {
        Some(Reading { value: tolerance, .. }) => Reading { tolerance, ..value },
        None => value,
    })
}

/// A speed in m/s, or in another unit behind it.
///
/// # Errors
/// That it is none.
pub fn speed(node: &Node) -> Result<f64, Problem> {
    match &node.value {
        Value::Number(text) | Value::Text(text) => {
            speed_of(text).map_err(|why| problem(&node.place, format!("`speed` is `{text}`: {why}")))
        }
        _ => Err(problem(&node.place, "`speed` is no number; expected one in m/s, such as 5 or \"18 km/h\"")),
    }
}

/// The same of a text.
///
/// # Errors
/// That it is none, as the end of a sentence.
pub fn speed_of(text: &str) -> Result<f64, String> {
    let speed = number(text, speeds::CONTEXT).map_err(reason)?;
    match speed {
        _ if speed < 0.0 => Err("expected a speed >= 0 in m/s".to_owned()),
        _ if speed > FASTEST => Err(format!("expected a speed of at most {FASTEST} m/s")),
        _ => Ok(speed),
    }
}

/// The rows of a matrix, as lists or as the text of MATLAB and Python.
///
/// # Errors
/// That it has none, and everything that is no number.
pub fn rows(name: &str, node: &Node) -> Result<Rows, Vec<Problem>> {
    let of_text = match &node.value {
        Value::Text(text) => list(text, &|_| node.place.clone()),
        _ => None,
    };
    let value = of_text.as_ref().unwrap_or(&node.value);
    let none =
        || problem(&node.place, format!("`{name}` has no rows; expected a list of rows, such as [[1, 0], [0, 1]]"));
    // Of one coordinate the number alone will do.
    if let Value::Number(_) | Value::Text(_) = value {
        let entry = reading(node, &format!("`{name}`")).map_err(|problem| vec![problem])?;
        return Ok(vec![vec![entry]]);
    }
    let Value::List(rows) = value else { return Err(vec![none()]) };
    let mut problems = Vec::new();
    let mut found: Rows = Vec::new();
    for (row, node) in rows.iter().enumerate() {
        let entries = match &node.value {
            Value::List(entries) => entries.as_slice(),
            _ if rows.len() == 1 => std::slice::from_ref(node),
            _ => return Err(vec![none()]),
        };
        let mut entry = |(column, node): (usize, &Node)| {
            let what = format!("`{name}` in row {}, column {}", row + 1, column + 1);
            reading(node, &what).unwrap_or_else(|problem| {
                problems.push(problem);
                None
            })
        };
        found.push(entries.iter().enumerate().map(&mut entry).collect());
    }
    level(found.iter_mut().flatten().flatten());
    if problems.is_empty() { Ok(found) } else { Err(problems) }
}
