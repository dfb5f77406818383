//! Eigenvalues as people write them: `-0.775+4.465i`, `(-0.775 ± 4.465j)`, `[-0.775, 4.465]`, `{ re = …, im = … }`.

use carvallo_design::Problem;
use carvallo_design::input::{Named, Node, Value};

use super::numbers::{of_text, problem, reading};
use crate::given::{Reading, level};

type Parts = (Reading, Option<Reading>);

/// The eigenvalues of a list, and how many of them are not known.
///
/// # Errors
/// Everything in it that is none.
pub fn values(node: &Node) -> Result<(Vec<Parts>, usize), Vec<Problem>> {
    let nodes = match &node.value {
        Value::List(nodes) => nodes.as_slice(),
        _ => std::slice::from_ref(node),
    };
    let mut values = Vec::new();
    let mut unknown = 0;
    let mut problems = Vec::new();
    for node in nodes {
        match value(node) {
            Ok(found) => {
                unknown += usize::from(found.is_empty());
                values.extend(found);
            }
            Err(found) => problems.push(found),
        }
    }
    // Among complex numbers those without an imaginary part are real; where there are none, real parts alone are known.
    if values.iter().any(|(_, im)| im.is_some()) {
        for (re, im) in &mut values {
            im.get_or_insert_with(|| Reading { value: 0.0, digits: 0, written: "0".to_owned(), ..re.clone() });
        }
    }
    if problems.is_empty() { Ok((values, unknown)) } else { Err(problems) }
}

/// One, a conjugate pair, or none where it is not known.
fn value(node: &Node) -> Result<Vec<Parts>, Problem> {
    let no_value = |found: &str| {
        problem(&node.place, format!("an eigenvalue is {found}; expected a number such as -0.775 or \"-0.775+4.465i\""))
    };
    match &node.value {
        Value::Number(text) | Value::Text(text) => complex(text).ok_or_else(|| no_value(&format!("`{text}`"))),
        Value::List(parts) => match &parts[..] {
            [re, im] => parts_of(re, im),
            _ => Err(no_value(&format!("a list of {}", parts.len()))),
        },
        Value::Table(members) => {
            let member = |names: [&str; 2]| {
                members.iter().find(|Named { name, .. }| names.contains(&name.as_str())).map(|own| &own.node)
            };
            match (member(["re", "real"]), member(["im", "imag"])) {
                (Some(re), Some(im)) => parts_of(re, im),
                _ => Err(no_value("a table without `re` and `im`")),
            }
        }
        Value::Other("null") => Ok(Vec::new()),
        Value::Other(other) => Err(no_value(other)),
    }
}

fn parts_of(re: &Node, im: &Node) -> Result<Vec<Parts>, Problem> {
    let mut re = reading(re, "the real part of an eigenvalue")?;
    let mut im = reading(im, "the imaginary part of an eigenvalue")?;
    level(re.iter_mut().chain(&mut im));
    Ok(re.map(|re| (re, im)).into_iter().collect())
}

/// A number by its text, or the pair of `a ± b i`.
fn complex(text: &str) -> Option<Vec<Parts>> {
    let text: String = text.replace('−', "-").replace("+/-", "±").replace("+-", "±");
    let text: String = text.chars().filter(|c| !c.is_whitespace() && *c != '(' && *c != ')' && *c != '*').collect();
    let of = |text: &str| of_text(text).ok().flatten();
    let is_unit = |c: char| matches!(c, 'i' | 'j' | 'I');
    let imaginary = text.strip_suffix(is_unit);
    let Some(imaginary) = imaginary else {
        return if text.contains('±') { None } else { Some(vec![(of(&text)?, None)]) };
    };
    if let Some((re, im)) = imaginary.split_once('±') {
        let im = of(im)?;
        let conjugate = Reading { value: -im.value, written: format!("-{}", im.written), ..im.clone() };
        let re = if re.is_empty() { Reading { value: 0.0, ..im.clone() } } else { of(re)? };
        return Some(vec![(re.clone(), Some(im)), (re, Some(conjugate))]);
    }
    // The last sign that is not at the start and not of an exponent.
    let mut signs = imaginary
        .char_indices()
        .filter(|&(at, c)| at > 0 && matches!(c, '+' | '-') && !imaginary[..at].ends_with(['e', 'E']));
    let part = |text: &str| match text {
        "" | "+" => of("1"),
        "-" => of("-1"),
        text => of(text.trim_start_matches('+')),
    };
    match signs.next_back() {
        Some((at, _)) => Some(vec![(of(&imaginary[..at])?, Some(part(&imaginary[at..])?))]),
        None => {
            let im = part(imaginary)?;
            let re = Reading { value: 0.0, digits: 0, written: "0".to_owned(), ..im.clone() };
            Some(vec![(re, Some(im))])
        }
    }
}

#[cfg(test)]
mod tests {
    use carvallo_design::Place;
    use carvallo_design::input::{Node, Value};

    use super::{complex, values};

    /// A zero has the decimals of the other part.
    #[test]
    fn an_imaginary_part_that_is_zero_is_known_as_well_as_the_real_one() {
        let place = Place::File("mine.toml".to_owned());
        let node = |value: Value| Node { place: place.clone(), value };
        let parts = ["-18.97821", "0"].map(|text| node(Value::Number(text.to_owned())));
        let (found, _) = values(&node(Value::List(vec![node(Value::List(parts.into()))]))).expect("one value");
        assert_eq!(found[0].1.as_ref().map(|im| im.tolerance), Some(0.000_005));
    }

    #[test]
    fn complex_numbers_are_read_as_people_write_them() {
        let parts_of = |text: &str| {
            let parts = complex(text)?;
            Some(parts.into_iter().map(|(re, im)| (re.value, im.map(|im| im.value))).collect::<Vec<_>>())
        };
        let one = |re: f64, im: f64| Some(vec![(re, Some(im))]);
        for text in ["-0.775+4.465i", "(-0.775 + 4.465j)", "-0.775 + 4.465*i", "-7.75e-1+4.465e+0j", "−0.775+4.465i"]
        {
            assert_eq!(parts_of(text), one(-0.775, 4.465), "{text}");
        }
        let pair = Some(vec![(-0.775, Some(4.465)), (-0.775, Some(-4.465))]);
        for text in ["-0.775 ± 4.465i", "-0.775 +/- 4.465 j", "-0.775+-4.465i"] {
            assert_eq!(parts_of(text), pair, "{text}");
        }
        assert_eq!(parts_of("-14.1"), Some(vec![(-14.1, None)]));
        assert_eq!(parts_of("-4.3i"), one(0.0, -4.3));
        assert_eq!(parts_of("2 - i"), one(2.0, -1.0));
        for text in ["weave", "1 + 2k", "1 ± 2", "i + 1 + x"] {
            assert_eq!(parts_of(text), None, "{text}");
        }
    }
}
