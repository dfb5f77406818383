//! Formulas in LaTeX, with the package amsmath.

use super::markup::Markup;

pub struct Latex;

impl Markup for Latex {
    const TIMES: &'static str = " \\cdot ";
    const BETWEEN: &'static str = "\\,";
    const DERIVATIVES: [&'static str; 3] = ["\\ddot{q}", "\\dot{q}", "q"];

    fn fraction(&self, above: &str, below: &str) -> String {
        format!("\\frac{{{above}}}{{{below}}}")
    }

    fn index(&self, base: &str, index: &str) -> String {
        if index.len() == 1 { format!("{base}_{index}") } else { format!("{base}_{{{index}}}") }
    }

    fn power(&self, base: &str, exponent: &str) -> String {
        if exponent.len() == 1 { format!("{base}^{exponent}") } else { format!("{base}^{{{exponent}}}") }
    }

    fn root(&self, inner: &str) -> String {
        format!("\\sqrt{{{inner}}}")
    }

    fn function(&self, name: &str) -> String {
        format!("\\{name}")
    }

    fn enclosed(&self, inner: &str) -> String {
        if inner.contains("\\frac") { format!("\\left({inner}\\right)") } else { format!("({inner})") }
    }

    fn greek(&self, name: &str) -> String {
        format!("\\{name}")
    }

    fn letters(&self, letters: &str) -> String {
        escaped(letters)
    }

    fn word(&self, word: &str) -> String {
        format!("\\mathrm{{{}}}", escaped(word))
    }

    fn number(&self, number: &str) -> String {
        match number.split_once('e') {
            Some((digits, exponent)) => format!("{digits} \\cdot 10^{{{exponent}}}"),
            None => number.into(),
        }
    }

    fn unit(&self, unit: &str) -> String {
        let unit: String = unit.chars().map(|c| if c == '*' { "\\,".into() } else { c.to_string() }).collect();
        format!("\\mathrm{{{}}}", exponents(&unit))
    }

    fn head(&self, model: &str, equation: &str, coordinates: &str) -> String {
        format!(
            "% The equations of motion of {model}. Needs \\usepackage{{amsmath}}.\n\\begin{{gather*}}\n  {equation}, \
             \\quad q = ({coordinates})\n\\end{{gather*}}\n"
        )
    }

    fn row(&self, of: &str, lines: &[String], unit: Option<&str>) -> String {
        let unit = unit.map(|unit| format!(" &\\quad& [{unit}]")).unwrap_or_default();
        format!("  {of} &= {}{unit}", lines.join(" \\\\\n  &\\quad {} "))
    }

    fn block(&self, rows: &[String]) -> String {
        format!("\\begin{{align*}}\n{}\n\\end{{align*}}\n", rows.join(" \\\\\n"))
    }
}

/// With the exponents of a unit in braces.
fn exponents(unit: &str) -> String {
    let mut parts = unit.split('^');
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let end = part.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(part.len());
        let (exponent, rest) = part.split_at(end);
        text.push_str(&format!("^{{{exponent}}}{rest}"));
    }
    text
}

/// With what LaTeX takes for commands as text.
pub fn escaped(text: &str) -> String {
    let escape = |c: char| match c {
        '#' | '$' | '%' | '&' | '_' | '{' | '}' => format!("\\{c}"),
        '\\' | '^' | '~' => format!("\\text{{\\char`\\{c}}}"),
        _ => c.to_string(),
    };
    text.chars().map(escape).collect()
}
