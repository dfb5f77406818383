//! Lists of three moments of inertia, as scripts for JBike6 have them: `Irider = [10.5 2.5 12]`.

use super::jbike6::BODIES;
use crate::failure::Problem;
use crate::input::{Entry, Written};

/// Puts an entry for each moment in the place of each list.
pub fn spread(entries: &mut Vec<Entry>, problems: &mut Vec<Problem>) {
    let mut spread = Vec::with_capacity(entries.len());
    for entry in entries.drain(..) {
        let body = BODIES.iter().find(|body| entry.name.strip_prefix('I') == Some(**body));
        let refuse = |message: String| Problem { place: entry.place.clone(), message };
        match (body, &entry.value) {
            (None, _) if entry.name.contains('(') => {
                problems.push(refuse(format!("`{}` is a part of a list; expected all of it at once", entry.name)));
            }
            (Some(body), Written::Text(text)) => match moments(text) {
                Some(moments) => {
                    let names = ["I11", "I22", "Izz"].map(|axis| format!("{axis}{body}"));
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
    use super::moments;

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
        for text in ["", "3", "[1 2]", "[1 2 3 4]", "a[1 2 3]", "[1 2 3] + 1", "[1 2 3"] {
            assert_eq!(moments(text), None, "{text}");
        }
    }
}
