//! Parameter files of one `name: value` or `name = value` a line: text as BicycleParameters writes it, attributes in
//! Python, and assignments of a MATLAB script.
//!
//! The YAML that is read is this flat list, alone or indented under `values:`, with comments, quotes and block texts.

use super::document::{Document, Entry, File};
use super::texts::{Folded, fold_python, fold_yaml, without_prefix};

/// What lines of scripts begin with that parameters do not depend on.
const STATEMENTS: [&str; 8] = ["import", "from", "class", "def", "clear", "clc", "close", "format"];

/// Reads lines `name: value`, as in YAML, or `name = value+/-deviation`, as in text files and scripts.
pub fn read(file: File, separator: char) -> Document {
    let mut document = Document::default();
    let is_matlab = is_matlab(file);
    let folded = match separator {
        ':' => fold_yaml(file.text),
        _ if is_matlab => Folded { text: file.text.to_owned(), open: None },
        _ => fold_python(file.text),
    };
    // An apostrophe may begin a value of YAML that is no text.
    if let Some((line, quotes)) = folded.open.filter(|_| separator == '=') {
        document.problem(file.line(line), format!("a text that begins with `{quotes}` has no end"));
        return document;
    }
    let file = File { text: &folded.text, ..file };
    let without_comment = |line| without_comment(line, is_matlab);
    let is_table = |line| separator == ':' && matches!(without_comment(line).trim_end(), "values:" | "parameters:");
    // With a heading such as `values:`, what is not indented under it describes the file.
    let nested = file.text.lines().any(is_table);
    let mut inside = !nested;
    let mut block_indent = None;
    let mut comments = 0;
    let lines_behind =
        |index: usize| file.text.lines().skip(index + 1).filter(|line| !without_comment(line).trim().is_empty());
    for (index, line) in file.text.lines().enumerate() {
        let place = file.line(index + 1);
        let indent = indent_of(line);
        if block_indent.is_some_and(|block| indent > block || line.trim().is_empty()) {
            continue;
        }
        block_indent = None;
        if is_matlab && is_in_block(line.trim(), &mut comments) {
            continue;
        }
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
            let assigned = content.split_once(separator).filter(|_| !is_text(content));
            let Some((name, value)) = assigned else {
                if separator == ':' || !(is_statement(content) || is_text(content)) {
                    let form = if separator == ':' { "name: value" } else { "name = value" };
                    document.problem(place.clone(), format!("`{content}` is not of the form `{form}`"));
                }
                continue;
            };
            let (name, value) = (unquoted(name.trim()), unquoted(value.trim()));
            if separator == '=' && name.ends_with(['+', '-', '*', '/', '^', '%']) {
                let message = format!("`{content}` computes with an earlier value; expected `name = value`");
                document.problem(place.clone(), message);
                continue;
            }
            let is_group = || lines_behind(index).next().is_some_and(|next| indent_of(next) > indent);
            if value.starts_with(['|', '>']) {
                block_indent = Some(indent);
            } else if name == "parameterization" {
                if value != "benchmark" {
                    let message = format!("the parameterization is `{value}`; only `benchmark` can be read");
                    document.problem(place.clone(), message);
                }
            } else if document.take_heading(name, value) {
            } else if !inside {
                if indent == 0 {
                    document.outside.push(Entry::from_text(name, place.clone(), value));
                }
            } else if separator == ':' && value.is_empty() && is_group() {
                document.problem(place.clone(), format!("`{name}` holds others; only `values:` can"));
                block_indent = Some(indent);
            } else {
                document.entries.push(Entry::from_text(name, place.clone(), value));
            }
        }
    }
    if comments > 0 {
        document.problem(file.line(file.text.lines().count()), "a comment that begins with `%{` has no end `%}`");
    }
    document
}

/// Whether a text is a script of MATLAB, in which `%` begins a comment.
pub fn is_matlab(file: File) -> bool {
    let is_python = file.label.ends_with(".py");
    file.label.ends_with(".m") || !is_python && file.text.lines().any(|line| line.starts_with('%'))
}

fn indent_of(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

/// Whether a line of a script of MATLAB belongs to a comment between `%{` and `%}`, each alone in its line; `depth` says how
/// many are open.
fn is_in_block(line: &str, depth: &mut usize) -> bool {
    match line {
        "%{" => *depth += 1,
        "%}" if *depth > 0 => {
            *depth -= 1;
            return true;
        }
        _ => {}
    }
    *depth > 0
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

/// Whether a line of a script is none of those that give parameters.
pub fn is_statement(content: &str) -> bool {
    content.split_whitespace().next().is_some_and(|word| STATEMENTS.contains(&word))
}

/// A text in quotes that is given to no name, as documentation in Python: `"w = 3"`.
fn is_text(content: &str) -> bool {
    let text = without_prefix(content);
    let inner = unquoted(text);
    inner != text && !inner.contains(['"', '\''])
}

fn unquoted(text: &str) -> &str {
    ['"', '\''].iter().find_map(|&quote| text.strip_prefix(quote)?.strip_suffix(quote)).unwrap_or(text)
}
