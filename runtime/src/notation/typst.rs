//! Formulas in Typst.

use super::markup::Markup;

pub struct Typst;

impl Markup for Typst {
    const TIMES: &'static str = " dot ";
    const BETWEEN: &'static str = " thin ";
    const DERIVATIVES: [&'static str; 3] = ["dot.double(q)", "dot(q)", "q"];

    fn fraction(&self, above: &str, below: &str) -> String {
        format!("frac({above}, {below})")
    }

    fn index(&self, base: &str, index: &str) -> String {
        format!("{base}_{}", attached(index))
    }

    fn power(&self, base: &str, exponent: &str) -> String {
        format!("{base}^{}", attached(exponent))
    }

    fn root(&self, inner: &str) -> String {
        format!("sqrt({inner})")
    }

    fn function(&self, name: &str) -> String {
        name.into()
    }

    fn enclosed(&self, inner: &str) -> String {
        format!("({inner})")
    }

    fn greek(&self, name: &str) -> String {
        name.into()
    }

    fn letters(&self, letters: &str) -> String {
        let letter = |c: char| if c.is_alphanumeric() { c.to_string() } else { format!("\\{c}") };
        letters.chars().map(letter).collect::<Vec<String>>().join(" ")
    }

    fn word(&self, word: &str) -> String {
        quoted(word)
    }

    fn number(&self, number: &str) -> String {
        match number.split_once('e') {
            Some((digits, exponent)) => format!("{digits} dot 10^({exponent})"),
            None => number.into(),
        }
    }

    fn unit(&self, unit: &str) -> String {
        let mut text = String::new();
        let mut rest = unit;
        while let Some(first) = rest.chars().next() {
            let end = rest.find(|c: char| c.is_alphabetic() != first.is_alphabetic()).unwrap_or(rest.len());
            let (part, behind) = rest.split_at(end);
            if first.is_alphabetic() {
                text.push_str(&quoted(part));
            } else {
                text.push_str(&between_units(part));
            }
            rest = behind;
        }
        text
    }

    fn head(&self, model: &str, equation: &str, coordinates: &str) -> String {
        format!(
            "// The equations of motion of {model}.\n#show math.equation: set block(breakable: true)\n$ {equation}, \
             quad q = ({coordinates}) $\n"
        )
    }

    fn row(&self, of: &str, lines: &[String], unit: Option<&str>) -> String {
        let unit = unit.map(|unit| format!(" & quad & [{unit}]")).unwrap_or_default();
        format!("  {of} & = {}{unit}", lines.join(" \\\n  & quad \"\" "))
    }

    fn block(&self, rows: &[String]) -> String {
        format!("$\n{}\n$\n", rows.join(" \\\n"))
    }
}

/// What is attached to a letter, in parentheses unless it is one word or number.
fn attached(text: &str) -> String {
    if text.chars().all(char::is_alphanumeric) { text.into() } else { format!("({text})") }
}

/// What stands between the names of units: `*`, `/`, `^2/`.
fn between_units(signs: &str) -> String {
    let Some(power) = signs.strip_prefix('^') else { return signs.replace('*', " thin ").replace('/', "\"/\"") };
    let end = power.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(power.len());
    let (exponent, rest) = power.split_at(end);
    format!("^{}{}", attached(exponent), between_units(rest))
}

/// As text, upright.
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
