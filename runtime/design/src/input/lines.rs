//! Parameter files of one `name: value` or `name = value` a line: text as BicycleParameters writes it, attributes in
//! Python, and assignments of a MATLAB script.
//!
//! The YAML that is read is this flat list, alone or indented under `values:`, with comments, quotes and block texts.

use std::borrow::Cow;

use super::document::{Document, Entry, File};
use super::matrices;
use super::names::without_owner;
use super::tables::Words;
use super::texts::{Folded, fold_python, fold_yaml, unquoted, without_prefix};

const WORDS: Words =
    Words { parameters: "`values:`", table: "a table", table_without_value: "a table without `value`" };

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
    let is_table = |line: &str| {
        separator == ':' && matches!(without_comment(line, is_matlab).trim_end(), "values:" | "parameters:")
    };
    // With a heading such as `values:`, what is not indented under it describes the file.
    let nested = file.text.lines().any(is_table);
    let mut inside = !nested;
    let mut block_indent = None;
    let mut comments = 0;
    let lines_behind = |index: usize| {
        file.text.lines().skip(index + 1).filter(|line| !without_comment(line, is_matlab).trim().is_empty())
    };
    for (index, line) in whole_lines(file.text, separator, is_matlab) {
        let line = line.as_ref();
        let place = file.line(index + 1);
        let indent = indent_of(line);
        if block_indent.is_some_and(|block| indent > block || line.trim().is_empty()) {
            continue;
        }
        block_indent = None;
        if is_matlab && is_in_block(line.trim(), &mut comments) {
            continue;
        }
        let content = without_comment(line, is_matlab).trim();
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
                    let content = beginning(content);
                    document.problem(place.clone(), format!("`{content}` is not of the form `{form}`"));
                }
                continue;
            };
            // Behind a text a semicolon ends the statement; elsewhere it is gone already.
            let value = if is_matlab { value.trim().trim_end_matches(';') } else { value };
            let (name, value) = (unquoted(name.trim()), unquoted(value.trim()));
            if separator == '=' && name.ends_with(['+', '-', '*', '/', '^', '%']) {
                let message = format!("`{content}` computes with an earlier value; expected `name = value`");
                document.problem(place.clone(), message);
                continue;
            }
            let is_group = || lines_behind(index).next().is_some_and(|next| indent_of(next) > indent);
            if matrices::is_text(without_owner(name), value) {
                // Statements before it in its line end no line.
                document.take_matrix_text(without_owner(name), value, &|lines| file.line(index + 1 + lines));
            } else if value.starts_with(['|', '>']) {
                block_indent = Some(indent);
            } else if name == "parameterization" {
                document.parameterization = Some((place.clone(), value.to_owned()));
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
    document.finish_matrices(&WORDS);
    document
}

/// The lines with their numbers from zero; those that a list in brackets goes on over are one, without comments.
fn whole_lines(text: &str, separator: char, is_matlab: bool) -> Vec<(usize, Cow<'_, str>)> {
    let is_open = |line: &str| line.split_once(separator).is_some_and(|(_, value)| matrices::is_open(value));
    let mut whole: Vec<(usize, Cow<str>)> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        match whole.last_mut() {
            Some((_, last)) if is_open(last) => {
                let (line, last) = (without_comment(line, is_matlab), last.to_mut());
                // In MATLAB, three dots go on without a new row.
                match last.trim_end().strip_suffix("...").map(str::len) {
                    Some(end) => last.replace_range(end.., " "),
                    None => last.push('\n'),
                }
                last.push_str(line);
            }
            _ if is_open(without_comment(line, is_matlab)) => {
                whole.push((index, without_comment(line, is_matlab).into()))
            }
            _ => whole.push((index, line.into())),
        }
    }
    whole
}

/// Whether a text is a script of MATLAB, in which `%` begins a comment, alone in its line or behind a statement.
pub fn is_matlab(file: File) -> bool {
    let is_python = file.label.ends_with(".py");
    let has_comment = |line: &str| {
        line.starts_with('%') || line.split(';').skip(1).any(|behind| behind.trim_start().starts_with('%'))
    };
    file.label.ends_with(".m") || !is_python && file.text.lines().any(has_comment)
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
    // Within brackets a semicolon ends a row of a matrix.
    let mut depth = 0;
    let ends = |sign: char| {
        depth += match sign {
            '[' => 1,
            ']' => -1,
            _ => 0,
        };
        sign == ';' && depth <= 0
    };
    content.split(ends).map(str::trim).filter(|statement| !statement.is_empty()).collect()
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

/// As much of a line as a message has room for.
#[cfg(feature = "full")]
pub fn beginning(line: &str) -> String {
    const MOST: usize = 80;
    match line.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", &line[..end]),
        None => line.to_owned(),
    }
}

#[cfg(not(feature = "full"))]
fn beginning(line: &str) -> &str {
    line
}
