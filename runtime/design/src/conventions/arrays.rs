//! Lists of three moments of inertia, as scripts for JBike6 have them: `Irider = [10.5 2.5 12]`.

use super::jbike6::BODIES;
use crate::failure::Problem;
use crate::input::{Entry, Written};

/// The moments in a list, in its order.
const AXES: [&str; 3] = ["I11", "I22", "Izz"];

/// Puts an entry for each moment in the place of each list, and of what replaces some of a list.
pub fn spread(entries: &mut Vec<Entry>, problems: &mut Vec<Problem>) {
    let mut spread = Vec::with_capacity(entries.len());
    for entry in entries.drain(..) {
        let body = BODIES.iter().find(|body| entry.name.strip_prefix('I') == Some(**body));
        let refuse = |message: String| Problem { place: entry.place.clone(), message };
        match (body, &entry.value) {
            (None, _) if entry.name.contains('(') => {
                if let Err(message) = replace(&entry, &mut spread) {
                    problems.push(refuse(message));
                }
            }
            (Some(body), Written::Text(text)) => match moments(text) {
                Some(moments) => {
                    let names = AXES.map(|axis| format!("{axis}{body}"));
                    let entry = |(name, text): (String, &String)| Entry::from_text(&name, entry.place.clone(), text);
                    spread.extend(names.into_iter().zip(&moments).map(entry));
                }
                None => problems.push(refuse(format!(
                    "`{}` is `{text}`; expected the moments about its axes 1 and 2 and about z: `[I11 I22 Izz]`",
                    entry.name
                ))),
            },
            _ => spread.push(entry),
        }
    }
    *entries = spread;
}

/// Puts the value of `Ifork(1:2:3) = 0.1` in the place of some moments of a list that stands before it.
fn replace(Entry { name, value, .. }: &Entry, spread: &mut [Entry]) -> Result<(), String> {
    let (list, places) = name.split_once('(').unwrap_or((name, ""));
    let body = list.trim().strip_prefix('I').and_then(|own| BODIES.iter().find(|body| **body == own));
    let Some(body) = body else { return Err(format!("`{name}` is a part of a list that is none of moments")) };
    let places = places.trim_end().strip_suffix(')').and_then(indices);
    let places =
        places.ok_or_else(|| format!("`{name}` is no part of a list of three: expected places such as 1:2"))?;
    if let Written::Text(text) = value
        && text.contains('[')
    {
        return Err(format!("`{name}` is `{text}`; expected one number for all of these moments"));
    }
    for place in places {
        let moment = format!("{}{body}", AXES[place - 1]);
        let own = spread.iter_mut().find(|own| own.name == moment);
        own.ok_or_else(|| format!("`{name}` is a part of a list; expected all of it before"))?.value = value.clone();
    }
    Ok(())
}

/// Places in a list of three, counted from one: `2`, `1:3`, `1:2:3`, `:`, `[1 3]`.
fn indices(text: &str) -> Option<Vec<usize>> {
    let inside = text.trim().strip_prefix('[').and_then(|text| text.strip_suffix(']'));
    let number = |text: &str| text.trim().parse::<usize>().ok().filter(|number| *number > 0);
    let places: Vec<usize> = match (inside, &text.split(':').map(str::trim).collect::<Vec<_>>()[..]) {
        (Some(inside), _) => inside.replace(',', " ").split_whitespace().map(number).collect::<Option<_>>()?,
        (None, ["", ""]) => vec![1, 2, 3],
        (None, [one]) => vec![number(one)?],
        (None, [low, high]) => (number(low)?..=number(high)?).collect(),
        (None, [low, step, high]) => (number(low)?..=number(high)?).step_by(number(step)?).collect(),
        _ => return None,
    };
    (!places.is_empty() && places.iter().all(|place| *place <= AXES.len())).then_some(places)
}

/// The entries of `[a b c]`, or of a product of it with numbers, such as `m*r^2*[1/2 1/2 1]`.
fn moments(text: &str) -> Option<[String; 3]> {
    let (before, rest) = text.split_once('[')?;
    let (inside, behind) = rest.split_once(']')?;
    let inside = inside.replace([',', '\n'], " ");
    let entries: Vec<&str> = inside.split_whitespace().collect();
    let before = before.trim();
    let factor = match before.strip_suffix('*') {
        Some(factor) => Some(factor.trim_end().trim_end_matches('.').trim_end()),
        None if before.is_empty() => None,
        None => return None,
    };
    let behind = behind.trim().trim_end_matches(';').trim();
    let behind = match behind.trim_start_matches('.').chars().next() {
        None => "",
        Some('*' | '/') => behind.trim_start_matches('.'),
        Some(_) => return None,
    };
    let entry = |entry: &&str| match factor {
        Some(factor) => format!("({factor})*({entry}){behind}"),
        None if behind.is_empty() => (*entry).to_owned(),
        None => format!("({entry}){behind}"),
    };
    entries.iter().map(entry).collect::<Vec<_>>().try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::{indices, moments};

    #[test]
    fn lists_are_read_as_matlab_does() {
        let list = |text: &str| moments(text).map(|moments| moments.join("|"));
        assert_eq!(list("[0.1 0.1  0.2]").as_deref(), Some("0.1|0.1|0.2"));
        assert_eq!(list("[1, -2e-3, 3];").as_deref(), Some("1|-2e-3|3"));
        assert_eq!(
            list("0.8*m*D^2/4.*[1/2 1/2 1]").as_deref(),
            Some("(0.8*m*D^2/4)*(1/2)|(0.8*m*D^2/4)*(1/2)|(0.8*m*D^2/4)*(1)")
        );
        assert_eq!(list("[1 2 3]/2").as_deref(), Some("(1)/2|(2)/2|(3)/2"));
        // As MATLAB has them: from, to, and in the middle by which step.
        for (text, places) in
            [("2", &[2][..]), ("1:3", &[1, 2, 3]), ("1:2:3", &[1, 3]), (":", &[1, 2, 3]), ("[1 3]", &[1, 3])]
        {
            assert_eq!(indices(text).as_deref(), Some(places), "{text}");
        }
        for text in ["", "0", "4", "1:4", "3:1", "a", "1:0:3", "end", "1:1:2:3"] {
            assert_eq!(indices(text), None, "{text}");
        }
        for text in ["", "3", "[1 2]", "[1 2 3 4]", "a[1 2 3]", "[1 2 3] + 1", "[1 2 3"] {
            assert_eq!(moments(text), None, "{text}");
        }
    }
}
