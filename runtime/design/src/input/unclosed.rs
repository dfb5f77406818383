//! Lists and tables of TOML that have no end: all that is behind one is read as a part of it, and wrong.

/// Where the first list or table begins that has no end, and what would end it.
pub fn unclosed(text: &str) -> Option<(usize, char)> {
    let mut open: Vec<(usize, char)> = Vec::new();
    let mut rest = text.char_indices();
    while let Some((at, c)) = rest.next() {
        // What stands in comments and texts, which do not go beyond their line, opens nothing.
        let end = match c {
            '[' => {
                open.push((at, ']'));
                continue;
            }
            '{' => {
                open.push((at, '}'));
                continue;
            }
            ']' | '}' => {
                open.pop_if(|(_, end)| *end == c);
                continue;
            }
            '#' => '\n',
            '"' | '\'' => c,
            _ => continue,
        };
        let mut is_escaped = false;
        for (_, inner) in rest.by_ref() {
            if inner == '\n' || inner == end && !is_escaped {
                break;
            }
            is_escaped = inner == '\\' && end == '"' && !is_escaped;
        }
    }
    open.first().copied()
}

#[cfg(test)]
mod tests {
    use super::unclosed;

    #[test]
    fn what_has_no_end_is_found() {
        for (text, expected) in [
            ("M = [[1, 2], [3, 4]\nC = [[1]]", Some((4, ']'))),
            ("v = { a = 1\nb = [2]", Some((4, '}'))),
            ("M = [1, # ]\n2", Some((4, ']'))),
            ("a = \"[ \\\" [\" # [\nb = '{'\n[c]\nd = [1]", None),
        ] {
            assert_eq!(unclosed(text), expected, "{text}");
        }
    }
}
