//! Parameter files of one `name: value` or `name = value` a line: text as BicycleParameters writes it, attributes in
//! Python, and assignments of a MATLAB script.
//!
//! The YAML that is read is this flat list, alone or indented under `values:`, with comments, quotes and block texts.

use super::document::{Document, Entry, File};

/// What lines of scripts begin with that parameters do not depend on.
const STATEMENTS: [&str; 8] = ["import", "from", "class", "def", "clear", "clc", "close", "format"];

/// Reads lines `name: value`, as in YAML, or `name = value+/-deviation`, as in text files and scripts.
pub fn read(file: File, separator: char) -> Document {
    let mut document = Document::default();
    let is_matlab = file.label.ends_with(".m") || file.text.lines().any(|line| line.starts_with('%'));
    let without_comment = |line| without_comment(line, is_matlab);
    let is_table = |line| separator == ':' && matches!(without_comment(line).trim_end(), "values:" | "parameters:");
    // With a heading such as `values:`, what is not indented under it describes the file.
    let nested = file.text.lines().any(is_table);
    let mut inside = !nested;
    let mut block_indent = None;
    for (index, line) in file.text.lines().enumerate() {
        let place = file.line(index + 1);
        let indent = line.len() - line.trim_start().len();
        if block_indent.is_some_and(|block| indent > block || line.trim().is_empty()) {
            continue;
        }
        block_indent = None;
        let content = without_comment(line).trim();
        if content.is_empty() || content == "---" {
            continue;
        }
        if nested && indent == 0 {
            inside = is_table(line);
            if inside {
                continue;
            }
        }
        for content in statements(content, separator) {
            let Some((name, value)) = content.split_once(separator) else {
                if separator == ':' || !is_statement(content) {
                    let form = if separator == ':' { "name: value" } else { "name = value" };
                    document.problem(place.clone(), format!("`{content}` is not of the form `{form}`"));
                }
                continue;
            };
            let (name, value) = (unquoted(name.trim()), unquoted(value.trim()));
            if value.starts_with(['|', '>']) {
                block_indent = Some(indent);
            } else if name == "parameterization" {
                if value != "benchmark" {
                    let message = format!("the parameterization is `{value}`; only `benchmark` can be read");
                    document.problem(place.clone(), message);
                }
            } else if document.take_heading(name, value) || !inside {
                // What describes the file beyond its name and source is of no use here.
            } else {
                document.entries.push(Entry::from_text(name, place.clone(), value));
            }
        }
    }
    document
}

/// In YAML and here, `#` begins a comment at the start of a line or after a space; in scripts of MATLAB, `%` does too.
fn without_comment(line: &str, is_matlab: bool) -> &str {
    let begins = |&(at, sign): &(usize, &str)| {
        (sign == "#" || is_matlab) && (line[..at].is_empty() || line[..at].ends_with([' ', '\t', ';']))
    };
    let comment = line.match_indices(['#', '%']).find(begins);
    &line[..comment.map_or(line.len(), |(at, _)| at)]
}

/// Of a script, what semicolons separate; headings such as `source` have them in their texts.
fn statements(content: &str, separator: char) -> Vec<&str> {
    let is_text = |content: &str| {
        let name = content.split('=').next().unwrap_or_default().trim();
        Document::default().take_heading(name, "") || content.contains(['"', '\''])
    };
    if separator == ':' || is_text(content) {
        return vec![content];
    }
    content.split(';').map(str::trim).filter(|statement| !statement.is_empty()).collect()
}

fn is_statement(content: &str) -> bool {
    content.split_whitespace().next().is_some_and(|word| STATEMENTS.contains(&word))
}

fn unquoted(text: &str) -> &str {
    ['"', '\''].iter().find_map(|&quote| text.strip_prefix(quote)?.strip_suffix(quote)).unwrap_or(text)
}
