//! Parameter files of one `name: value` or `name = value` a line, as BicycleParameters writes them.
//!
//! The YAML that is read is this flat list, alone or indented under `values:`, with comments, quotes and block texts.

use super::document::{Document, Entry, File};

/// Reads lines `name: value`, as in YAML, or `name = value+/-deviation`, as in text files.
pub fn read(file: File, separator: char) -> Document {
    let mut document = Document::default();
    // With a heading such as `values:`, what is not indented under it describes the file.
    let nested = file.text.lines().any(|line| is_table(line, separator));
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
            inside = is_table(line, separator);
            if inside {
                continue;
            }
        }
        let Some((name, value)) = content.split_once(separator) else {
            let form = if separator == ':' { "name: value" } else { "name = value" };
            document.problem(place, format!("`{content}` is not of the form `{form}`"));
            continue;
        };
        let (name, value) = (unquoted(name.trim()), unquoted(value.trim()));
        if value.starts_with(['|', '>']) {
            block_indent = Some(indent);
        } else if name == "parameterization" {
            if value != "benchmark" {
                let message = format!("the parameterization is `{value}`; only `benchmark` can be read");
                document.problem(place, message);
            }
        } else if document.take_heading(name, value) || !inside {
            // What describes the file beyond its name and source is of no use here.
        } else {
            document.entries.push(Entry::from_text(name, place, value));
        }
    }
    document
}

/// The line that the parameters are indented under.
fn is_table(line: &str, separator: char) -> bool {
    let line = without_comment(line);
    separator == ':' && matches!(line.trim_end(), "values:" | "parameters:")
}

/// In YAML and here, `#` begins a comment at the start of a line or after a space.
fn without_comment(line: &str) -> &str {
    let begins = |&(at, _): &(usize, &str)| line[..at].is_empty() || line[..at].ends_with([' ', '\t']);
    let comment = line.match_indices('#').find(begins);
    &line[..comment.map_or(line.len(), |(at, _)| at)]
}

fn unquoted(text: &str) -> &str {
    ['"', '\''].iter().find_map(|&quote| text.strip_prefix(quote)?.strip_suffix(quote)).unwrap_or(text)
}
