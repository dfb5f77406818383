//! The text of a generated file: prettyplease's, and what it leaves to the writer of a file. Blank lines stand between
//! items, a line of their own before those that belong together, and short elements beside each other.

use proc_macro2::TokenStream;
use quote::quote;

use super::paths::Imports;
use crate::emit::{Section, allowed};

/// Lines of short elements go up to this column.
const WIDTH: usize = 100;

/// A call that fits into so many columns has one line.
const CALL_WIDTH: usize = 120;

/// Elements of so many characters are short.
const SHORT: usize = 52;

/// Fewer short elements than this stay where they are.
const FEW: usize = 4;

/// The sections as a file.
///
/// # Errors
/// If they are not Rust.
pub fn lay_out(sections: &[Section]) -> syn::Result<String> {
    let all: TokenStream = sections.iter().map(|section| section.items.clone()).collect();
    let mut imports = Imports::new(&syn::parse2(all)?);
    let mut body = String::new();
    for Section { title, items } in sections {
        let rule = "-".repeat(WIDTH.saturating_sub(title.len() + 8));
        body.push_str(&format!("\n// --- {title} {rule}\n"));
        let file: syn::File = syn::parse2(imports.shorten(items.clone()))?;
        for item in file.items {
            body.push('\n');
            let apart = matches!(item, syn::Item::Impl(_));
            let text = join_calls(&unparse(item));
            body.push_str(&fill_lines(&if apart { space_items(&text) } else { text }));
        }
    }
    let (allowed, imports) = (allowed(), imports.declaration());
    let head = prettyplease::unparse(&syn::parse2(quote!(#![allow(#allowed)] #imports))?);
    Ok(format!("{}{body}", head.replacen("\nuse ", "\n\nuse ", 1)))
}

fn unparse(item: syn::Item) -> String {
    prettyplease::unparse(&syn::File { shebang: None, attrs: Vec::new(), items: vec![item] })
}

/// The text of an `impl` with a blank line between its items: they alone end at the first indentation.
fn space_items(text: &str) -> String {
    let mut spaced = String::new();
    let mut ended = false;
    for line in text.lines() {
        if ended && line != "}" {
            spaced.push('\n');
        }
        spaced.push_str(line);
        spaced.push('\n');
        ended = indentation(line) == 4 && line.ends_with(['}', ';']);
    }
    spaced
}

/// The text with the arguments of calls and functions, of which each has a line, in the line of their function.
fn join_calls(text: &str) -> String {
    let mut joined: Vec<String> = Vec::new();
    for line in text.lines() {
        joined.push(line.to_string());
        // Arguments end before what ends their call, so those inside are joined already.
        if line.trim_start().starts_with(')')
            && let Some((start, whole)) = call(&joined)
        {
            joined.truncate(start);
            joined.push(whole);
        }
    }
    joined.push(String::new());
    joined.join("\n")
}

/// Where the call that ends in the last line begins, and all of it in a line, if it has a place there.
fn call(lines: &[String]) -> Option<(usize, String)> {
    let (end, rest) = lines.split_last()?;
    let start = rest.iter().rposition(|line| indentation(line) == indentation(end) && line.ends_with('('))?;
    // A tuple needs the comma at its end.
    let function =
        lines[start].strip_suffix('(')?.ends_with(|sign: char| sign.is_alphanumeric() || "_>".contains(sign));
    let arguments = &rest[start + 1..];
    let whole = arguments.iter().all(|argument| argument.ends_with(',') && is_balanced(argument));
    let arguments: Vec<&str> = arguments.iter().map(|argument| argument.trim()).collect();
    let line = format!("{}{}{}", lines[start], arguments.join(" ").trim_end_matches(','), end.trim_start());
    (function && whole && line.chars().count() <= CALL_WIDTH).then_some((start, line))
}

fn is_balanced(line: &str) -> bool {
    let count = |signs: [char; 3]| line.matches(signs).count();
    count(['(', '[', '{']) == count([')', ']', '}'])
}

/// The text with short elements, of which each has a line, beside each other.
fn fill_lines(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let together = |a: &&str, b: &&str| is_short(a) && is_short(b) && indentation(a) == indentation(b);
    let mut filled = String::new();
    for group in lines.chunk_by(together) {
        let mut column = 0;
        for line in group {
            let element = line.trim_start();
            if group.len() < FEW || column == 0 || column + 1 + element.len() > WIDTH {
                filled.push_str(if filled.is_empty() { "" } else { "\n" });
                filled.push_str(line);
                column = line.len();
            } else {
                filled.push(' ');
                filled.push_str(element);
                column += 1 + element.len();
            }
        }
    }
    filled.push('\n');
    filled
}

/// Whether a line is a whole element of an array or a literal, and a short one.
fn is_short(line: &str) -> bool {
    let element = line.trim();
    // A field that a function computes is something to read by itself, and so is the arm of a `match`.
    let computed = element.contains(": ") && element.contains("::");
    element.ends_with(',')
        && element.chars().count() <= SHORT
        && is_balanced(element)
        && !element.starts_with(['/', '#', ')', ']', '}'])
        && !element.starts_with("pub ")
        && !element.contains("=>")
        && !computed
}

fn indentation(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_elements_fill_lines_and_others_stay() {
        let short = (0..40).map(|index| format!("    t{index},\n")).collect::<String>();
        let text = fill_lines(&format!("[\n{short}]\n"));
        assert_eq!(text.lines().count(), 2 + 2);
        assert!(text.lines().all(|line| line.len() <= WIDTH), "{text}");
        assert_eq!(
            text.split_whitespace().collect::<String>(),
            format!("[{short}]").split_whitespace().collect::<String>()
        );
        for kept in ["f(\n    a,\n    b,\n    c,\n)\n", "[\n    A => b,\n    C => d,\n    E => f,\n    G => h,\n]\n"] {
            assert_eq!(fill_lines(kept), kept);
        }
    }

    #[test]
    fn calls_that_fit_have_one_line_and_tuples_keep_their_commas() {
        assert_eq!(join_calls("x(\n    f(\n        a,\n    ),\n    b,\n)\n"), "x(f(a), b)\n");
        let tuple = "(\n    a,\n)\n";
        assert_eq!(join_calls(tuple), tuple);
        let long = format!("f(\n    {},\n)\n", "a".repeat(CALL_WIDTH));
        assert_eq!(join_calls(&long), long);
    }

    #[test]
    fn what_is_in_an_impl_stands_apart() {
        let text = "impl A {\n    type B = C;\n    fn f() {\n        g();\n    }\n    fn h() {}\n}\n";
        let apart = "impl A {\n    type B = C;\n\n    fn f() {\n        g();\n    }\n\n    fn h() {}\n}\n";
        assert_eq!(space_items(text), apart);
    }
}
