//! Texts that go over several lines, as the documentation of Python does: what looks like a value in them is none.

/// A text of a file in which each text in quotes is in one line.
pub struct Folded {
    /// With as many lines as before, so that places keep their numbers.
    pub text: String,
    /// The line of a text that has no end, and what it begins with. Everything behind it is as it was.
    pub open: Option<(usize, &'static str)>,
}

/// What begins a text within a line: where, and the quotes that end it.
type Opening = fn(&str) -> Option<(usize, &'static str)>;

/// Folds texts between three quotes, as scripts of Python have them. Those that belong to no name are left out.
pub fn fold_python(text: &str) -> Folded {
    fold(text, |line| {
        let first = line.char_indices().find(|&(at, found)| match found {
            '#' => line[..at].is_empty() || line[..at].ends_with([' ', '\t', ';']),
            _ => line[at..].starts_with("\"\"\"") || line[at..].starts_with("'''"),
        });
        match first? {
            (at, '"') => Some((at, "\"\"\"")),
            (at, '\'') => Some((at, "'''")),
            _ => None,
        }
    })
}

/// Folds values of YAML that begin with a quote.
pub fn fold_yaml(text: &str) -> Folded {
    fold(text, |line| {
        let (name, value) = line.split_once(':')?;
        let at = line.len() - value.trim_start().len();
        let is_name = !name.contains(['#', '"', '\'']) && at > name.len() + 1;
        let quote = ["\"", "'"].into_iter().find(|quote| line[at..].starts_with(quote))?;
        is_name.then_some((at, quote))
    })
}

fn fold(text: &str, opening: Opening) -> Folded {
    let mut folded = Folded { text: String::with_capacity(text.len()), open: None };
    let mut rest = text;
    // Breaks of lines within texts come behind the line that they end in.
    let mut breaks = 0;
    let mut line = 1;
    while !rest.is_empty() {
        let end = rest.find('\n').map_or(rest.len(), |at| at + 1);
        if let Some((at, quotes)) = opening(&rest[..end]) {
            let (before, behind) = (&rest[..at], &rest[at + quotes.len()..]);
            let Some(length) = length(behind, quotes) else {
                folded.open = Some((line + breaks, quotes));
                break;
            };
            let inside = &behind[..length];
            if !is_alone(before) {
                let quote = &quotes[..1];
                let parts: Vec<&str> = inside.lines().map(str::trim).collect();
                folded.text.extend([before, quote, parts.join(" ").trim(), quote]);
            }
            breaks += inside.matches('\n').count();
            rest = &behind[length + quotes.len()..];
        } else {
            folded.text.push_str(&rest[..end]);
            if rest[..end].ends_with('\n') {
                folded.text.extend(std::iter::repeat_n('\n', breaks));
                line += breaks + 1;
                breaks = 0;
            }
            rest = &rest[end..];
        }
    }
    folded.text.push_str(rest);
    folded
}

/// Whether nothing that a text belongs to stands before it; `r`, `f` and the like belong to the text.
fn is_alone(before: &str) -> bool {
    without_prefix(before.trim()).is_empty()
}

/// A text of Python without the letters that may stand before its quotes.
pub fn without_prefix(text: &str) -> &str {
    text.trim_start_matches(['r', 'R', 'u', 'U', 'b', 'B', 'f', 'F'])
}

/// What stands between quotes, or a text that stands in none.
pub fn unquoted(text: &str) -> &str {
    ['"', '\''].iter().find_map(|&quote| text.strip_prefix(quote)?.strip_suffix(quote)).unwrap_or(text)
}

/// The length of a text up to the quotes that end it.
fn length(text: &str, quotes: &str) -> Option<usize> {
    let mut at = 0;
    loop {
        let rest = &text[at..];
        if let Some(behind) = rest.strip_prefix(quotes) {
            // In YAML, two apostrophes within a text are one.
            if quotes != "'" || !behind.starts_with('\'') {
                return Some(at);
            }
            at += 2;
        } else {
            let first = rest.chars().next()?;
            let escaped = if first == '\\' && quotes != "'" { rest.chars().nth(1) } else { None };
            at += first.len_utf8() + escaped.map_or(0, char::len_utf8);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{fold_python, fold_yaml};

    #[test]
    fn texts_of_python_are_left_out_or_in_one_line() {
        for (text, folded) in [
            ("\"\"\"A bicycle.\n\nw = 3\n\"\"\"\nw = 1\n", "\n\n\n\nw = 1\n"),
            ("class A:\n    r'''w = 3'''\n    w = 1", "class A:\n\n    w = 1"),
            ("source = \"\"\"Mine,\n  w = 3\"\"\"  # [m]\nw = 1", "source = \"Mine, w = 3\"  # [m]\n\nw = 1"),
            ("w = 1  # \"\"\"\nc = 2", "w = 1  # \"\"\"\nc = 2"),
            ("\"\"\"a\\\"\"\"\nw = 3\"\"\"\r\nw = 1\r\n", "\r\n\nw = 1\r\n"),
            ("\"\"\"a\"\"\"; w = 1; '''b\n'''", "; w = 1; 'b'"),
        ] {
            assert_eq!(fold_python(text).text, folded, "{text}");
        }
    }

    #[test]
    fn texts_of_yaml_are_in_one_line() {
        for (text, folded) in [
            ("note: \"a\n  w: 3\"\nw: 1\n", "note: \"a w: 3\"\n\nw: 1\n"),
            ("note: 'it''s\n  w: 3'\nw: 1\n", "note: 'it''s w: 3'\n\nw: 1\n"),
            ("w: 1 # so: 'this\nc: 2 # is: 'all\n", "w: 1 # so: 'this\nc: 2 # is: 'all\n"),
            ("w: \"1\"\n", "w: \"1\"\n"),
        ] {
            assert_eq!(fold_yaml(text).text, folded, "{text}");
        }
    }

    #[test]
    fn texts_without_an_end_are_told() {
        assert_eq!(fold_python("w = 1\n\"\"\"a\nb\"\"\"\n'''w = 3\n").open, Some((4, "'''")));
        assert_eq!(fold_python("w = 1\n").open, None);
    }
}
