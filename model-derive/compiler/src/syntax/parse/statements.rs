//! The statements of a declaration.

use syn::Token;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::parse::discouraged::Speculative as _;

use super::compared::parse_compared;
use super::derivatives::parse_derivatives;
use super::docs::{LOST, Supported, parse_rust_attributes, peek_behind_attributes};
use super::domains::parse_comparison;
use super::expressions::parse_expression;
use super::feedback::parse_feedback;
use super::matrices::{
    parse_added, parse_declared_matrix, parse_name_behind, parse_rows, parse_symmetric, starts_minus_one,
};
use super::mechanism::parse_mechanism;
use super::names::parse_declared;
use super::parameters::{parse_coordinates, parse_parameters};
use super::sets::parse_set;
use super::tokens::{expected, parse_equals, parse_semicolon, parse_text};
use crate::nearest::{ask_for, find_nearest};
use crate::report::{Report, error};
use crate::syntax::tree::{Assertion, Declaration, Definition, Matrix, Requirement, RustAttribute};

/// What is said to be expected where no statement starts.
const STATEMENTS: &str = "a statement: `parameters { … }`, `let name = …;`, `require … > 0;`, `assert … == …;`, \
                          `set name { … }`, `coordinates { … }`, `mechanism { … }`, `feedback T on q = …;`, \
                          `derivatives;`, `nonlinear;`, `compare by_hand;`, `source \"…\";` or a matrix `M`, `C-1`, `C0`, `C1`, `Kc`, `K0`, `K1`, `K2`, or \
                          `C` or `K` with the speed in it, with `symmetric` before it if that is to be proved, and `add` if it is added to that of a \
                          mechanism";

/// One statement. A misspelt first word is noted, and what follows read as what was meant.
pub fn parse_statement(input: ParseStream<'_>, model: &mut Declaration, report: &mut Report) -> syn::Result<()> {
    let start = input.span();
    let is_set = peek_behind_attributes(input).is_some_and(|word| word == "set");
    let supported = if is_set { Supported::Default } else { Supported::Nothing };
    let (docs, attributes) = parse_rust_attributes(input, "what it is about", supported, report)?;
    if !docs.is_empty() && !is_set {
        report.error(start, LOST);
    }
    if input.peek(Token![let]) {
        return parse_definition(input, model, report);
    }
    if input.peek(Token![;]) {
        return Err(expected(input, "a statement: one that ends in braces has no `;` behind it"));
    }
    if !input.peek(syn::Ident::peek_any) {
        return Err(expected(input, STATEMENTS));
    }
    let keyword = input.call(syn::Ident::parse_any)?;
    let word = keyword.to_string();
    if KEYWORDS.contains(&word.as_str()) {
        return parse_after_keyword(&word, &keyword, input, (docs, attributes), model, report);
    }
    let Some(meant) = find_nearest(&word, KEYWORDS.into_iter()) else {
        return Err(error(&keyword, format!("found `{word}`: expected {STATEMENTS}")));
    };
    // Read on as what was meant, so that the names inside are known.
    report.error(&keyword, format!("found `{word}`: expected a statement{}", ask_for(meant)));
    parse_after_keyword(meant, &keyword, input, (docs, attributes), model, report)
}

/// Whether a statement starts here.
pub fn starts_statement(input: ParseStream<'_>) -> bool {
    let Some((word, _)) = input.cursor().ident() else { return false };
    let follows = input.peek2(syn::token::Brace) || input.peek2(syn::LitStr) || input.peek2(syn::Ident);
    let assigned = input.peek2(Token![=]) && !input.peek2(Token![==]);
    let behind = input.fork();
    let numbered = behind.parse::<syn::Ident>().is_ok() && starts_minus_one(&behind);
    let follows = follows || (word == "derivatives" || word == "nonlinear") && input.peek2(Token![;]);
    word == "let" || KEYWORDS.iter().any(|keyword| word == keyword) && (follows || assigned || word == "C" && numbered)
}

/// What may begin a statement, beside `let`.
const KEYWORDS: [&str; 22] = [
    "source",
    "parameters",
    "coordinates",
    "mechanism",
    "derivatives",
    "nonlinear",
    "compare",
    "require",
    "assert",
    "set",
    "symmetric",
    "add",
    "feedback",
    "M",
    "C",
    "C0",
    "C1",
    "K",
    "Kc",
    "K0",
    "K1",
    "K2",
];

/// What may follow a formula at the end of a statement.
pub const AFTER_FORMULA: &str = "an operator (`+ - * / ^`) or `;`";

/// A statement that begins with `word`, which is `keyword` or is meant by it, behind that.
fn parse_after_keyword(
    word: &str,
    keyword: &syn::Ident,
    input: ParseStream<'_>,
    (docs, attributes): (String, Vec<RustAttribute>),
    model: &mut Declaration,
    report: &mut Report,
) -> syn::Result<()> {
    match word {
        "source" => {
            let Some(source) = parse_text(input)? else { return Err(expected(input, "a text in quotes")) };
            if model.source.replace(source).is_some() {
                report.error(keyword.span(), "a second `source`: expected one");
            }
            parse_semicolon(input, "`;`", "the source")
        }
        "parameters" => parse_parameters(input, model, report),
        "coordinates" => parse_coordinates(input, keyword, model, report),
        "mechanism" => parse_mechanism(input, keyword, model, report),
        "derivatives" => {
            if model.derivatives.replace(parse_derivatives(keyword, input)?).is_some() {
                report.error(keyword, "a second `derivatives`: expected one, which asks for all that are wanted");
            }
            Ok(())
        }
        "nonlinear" => {
            if model.nonlinear.replace(keyword.span()).is_some() {
                report.error(keyword, "a second `nonlinear`: expected one");
            }
            parse_semicolon(input, "`;`", "`nonlinear`: it asks for the equations of the mechanism")
        }
        "compare" => parse_compared(input, model, report),
        "require" => {
            let value = parse_expression(input)?;
            let Some(bound) = parse_comparison(input)? else {
                return Err(expected(input, "a comparison such as `> 0`"));
            };
            if input.peek(Token![<]) || input.peek(Token![>]) {
                return Err(expected(input, "one comparison: write two requirements for two"));
            }
            model.requirements.push(Requirement { value, bound });
            parse_semicolon(input, AFTER_FORMULA, "the requirement")
        }
        "assert" => parse_assertion(input, model),
        "symmetric" => parse_symmetric(input, model, report),
        "add" => parse_added(input, model),
        "feedback" => {
            model.feedback.push(parse_feedback(input)?);
            Ok(())
        }
        "set" => parse_set(input, (docs, attributes), model, report),
        other => match parse_declared_matrix(other, keyword.span(), false, input, model)? {
            true => Ok(()),
            false => unreachable!("a keyword that no statement begins with"),
        },
    }
}

/// `let mT = mR + mB;`
fn parse_definition(input: ParseStream<'_>, model: &mut Declaration, report: &mut Report) -> syn::Result<()> {
    input.parse::<Token![let]>()?;
    let what = "the name of a definition";
    if input.peek(Token![mut]) {
        report.push(expected(input, &format!("{what}, which never changes")));
        input.parse::<Token![mut]>()?;
    }
    let name = parse_declared(input, what)?;
    let value = || {
        parse_equals(input, "`=` and a formula")?;
        let value = parse_expression(input)?;
        parse_semicolon(input, AFTER_FORMULA, "the definition")?;
        Ok(value)
    };
    match value() {
        Ok(value) => model.definitions.push(Definition { name, value }),
        Err(error) => {
            model.unread.push(name);
            return Err(error);
        }
    }
    Ok(())
}

/// `assert left == right;` or `assert M == [[…], …];`, behind its first word.
fn parse_assertion(input: ParseStream<'_>, model: &mut Declaration) -> syn::Result<()> {
    let ahead = input.fork();
    if let Ok(name) = ahead.parse::<syn::Ident>()
        && let Some(matrix) = parse_name_behind(&name.to_string(), &ahead)?
        && ahead.parse::<Token![==]>().is_ok()
        && ahead.peek(syn::token::Bracket)
    {
        input.advance_to(&ahead);
        let (region, rows) = parse_rows(input, parse_expression)?;
        model.asserted.push(Matrix { name: matrix, symmetric: false, span: name.span(), rows, region });
        return parse_semicolon(input, "`;`", "the assertion");
    }
    let left = parse_expression(input)?;
    if input.parse::<Option<Token![==]>>()?.is_none() {
        let what = "`==` and the formula that it equals; a condition on the parameters is a `require`";
        return Err(expected(input, what));
    }
    let right = parse_expression(input)?;
    parse_semicolon(input, AFTER_FORMULA, "the assertion")?;
    model.assertions.push(Assertion { left, right });
    Ok(())
}
