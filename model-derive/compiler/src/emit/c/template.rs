//! Texts of C with places to fill in.

/// The text with `$name` replaced by what it stands for. What stands alone in a line becomes as many lines as it has, or
/// none if it is empty; what becomes too long for a line is broken where a statement may be.
pub fn fill(template: &str, values: &[(&str, &str)]) -> String {
    let mut text = String::new();
    for line in template.lines() {
        let alone = line.trim().strip_prefix('$').and_then(|name| values.iter().find(|(known, _)| *known == name));
        if let Some((_, lines)) = alone {
            text.push_str(lines);
            continue;
        }
        let mut filled = line.to_string();
        for (name, value) in values {
            filled = filled.replace(&format!("${name}$"), value);
        }
        let indent = filled.len() - filled.trim_start().len();
        text.push_str(&wrap(filled.trim_start(), indent));
    }
    text
}

/// A function that gives one of several texts, by the number that its argument is.
pub fn define_texts(signature: &str, argument: &str, texts: impl Iterator<Item = String>, otherwise: &str) -> String {
    let texts: String = texts.map(|text| format!("        {},\n", string(&text))).collect();
    let values =
        [("signature", signature), ("argument", argument), ("texts", &texts), ("otherwise", &string(otherwise))];
    fill(include_str!("templates/texts.c"), &values)
}

/// A text as a literal of C, in one line, with no signs of an old keyboard in it.
fn string(text: &str) -> String {
    let text = text.replace('\\', "\\\\").replace('"', "\\\"").replace('?', "\\?");
    format!("\"{}\"", text.replace('\n', " "))
}

/// Lines go up to this column, where a statement can be broken there.
const WIDTH: usize = 100;

/// A statement in lines, with so many spaces before the first of them, and more before the others: they end behind a comma
/// or an operator.
pub fn wrap(statement: &str, indent: usize) -> String {
    let is_comment = statement.starts_with(['/', '*']);
    let mut lines = String::new();
    let mut line = " ".repeat(indent);
    // What cannot be parted.
    let mut piece = String::new();
    for word in statement.split_inclusive(' ') {
        piece.push_str(word);
        if is_comment || !word.trim_end().ends_with([',', '=', '+', '-', '*', '/', '&', '|', '?', ':']) {
            continue;
        }
        push(&mut lines, &mut line, &piece, indent);
        piece.clear();
    }
    push(&mut lines, &mut line, &piece, indent);
    format!("{lines}{}\n", line.trim_end())
}

/// Appends a piece to a line, or begins another one where it has no place.
fn push(lines: &mut String, line: &mut String, piece: &str, indent: usize) {
    if line.len() + piece.trim_end().len() > WIDTH && !line.trim().is_empty() {
        lines.push_str(line.trim_end());
        lines.push('\n');
        *line = " ".repeat(indent + 4);
    }
    line.push_str(piece);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_filled_and_empty_lines_are_none() {
        let text = fill("a $x$;\n$lines\n    $none\nb;\n", &[("x", "1"), ("lines", "  c;\n  d;\n"), ("none", "")]);
        assert_eq!(text, "a 1;\n  c;\n  d;\nb;\n");
    }

    #[test]
    fn lines_end_behind_operators() {
        let long = "a".repeat(60);
        assert_eq!(wrap(&format!("x = {long} + {long};"), 2), format!("  x = {long} +\n      {long};\n"));
        assert_eq!(wrap(&format!("f(T *{long}, T *{long})"), 0), format!("f(T *{long},\n    T *{long})\n"));
        assert_eq!(wrap(&format!("{long} {long}"), 0), format!("{long} {long}\n"));
    }
}
