//! The statements of a declaration.

use proc_macro2::TokenStream;
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

use super::declaration::{Declaration, Definition, Doc, Matrix, MatrixName, ParameterSet, Requirement, SetValue};
use super::expression::expression;
use super::parameters::{comparison, coordinate, parameter};
use super::tokens::{docs, expected, name, semicolon, skip_statement, text};
use crate::nearest::nearest;
use crate::report::{Region, Report, error};

/// `/// docs  pub model Name { statements }`
pub fn declaration(input: ParseStream<'_>, report: &mut Report) -> syn::Result<Declaration> {
    let docs = docs(input, report)?;
    let visibility = visibility(input)?;
    if !input.peek(syn::Ident::peek_any) || input.fork().call(syn::Ident::parse_any)? != "model" {
        return Err(expected(input, "`model Name { … }`, with `pub` before it if it is public"));
    }
    input.call(syn::Ident::parse_any)?;
    let name = name(input, "the name of the model")?;
    if !input.peek(syn::token::Brace) {
        return Err(expected(input, "`{` and the statements of the model"));
    }
    let content;
    syn::braced!(content in input);
    let mut declaration = Declaration {
        docs,
        visibility,
        name,
        source: None,
        parameters: Vec::new(),
        definitions: Vec::new(),
        requirements: Vec::new(),
        sets: Vec::new(),
        coordinates: Vec::new(),
        matrices: Vec::new(),
        unread: Vec::new(),
    };
    statements(&content, report, |input, report| statement(input, &mut declaration, report));
    if !input.is_empty() {
        report.push(expected(input, "nothing after the model: one `model!` declares one model"));
        input.parse::<TokenStream>()?;
    }
    Ok(declaration)
}

fn visibility(input: ParseStream<'_>) -> syn::Result<TokenStream> {
    let visibility: syn::Visibility = input.parse()?;
    Ok(quote::quote!(#visibility))
}

/// Reads statements to the end; one that cannot be read is reported and skipped.
fn statements(
    input: ParseStream<'_>,
    report: &mut Report,
    mut read: impl FnMut(ParseStream<'_>, &mut Report) -> syn::Result<()>,
) {
    while !input.is_empty() {
        let before = input.cursor();
        if let Err(error) = read(input, report) {
            report.push(error);
            skip_statement(input, input.cursor() != before);
        }
    }
}

const STATEMENTS: &str = "a statement: `parameters { … }`, `let name = …;`, `require … > 0;`, `set name { … }`, \
                          `coordinates { … }`, `source \"…\";` or a matrix `M`, `C0`, `C1`, `Kc`, `K0`, `K2`";

fn statement(input: ParseStream<'_>, model: &mut Declaration, report: &mut Report) -> syn::Result<()> {
    let docs = docs(input, report)?;
    if input.peek(Token![let]) {
        return definition(input, model);
    }
    if !input.peek(syn::Ident::peek_any) {
        return Err(expected(input, STATEMENTS));
    }
    let keyword = input.call(syn::Ident::parse_any)?;
    let word = keyword.to_string();
    if KEYWORDS.contains(&word.as_str()) {
        return statement_after(&word, &keyword, input, docs, model, report);
    }
    let Some(meant) = nearest(&word, KEYWORDS.into_iter()) else {
        return Err(error(&keyword, format!("found `{word}`: expected {STATEMENTS}")));
    };
    // Read on as what was meant, so that the names inside are known.
    report.error(&keyword, format!("found `{word}`: expected a statement; did you mean `{meant}`?"));
    statement_after(meant, &keyword, input, docs, model, report)
}

/// What may begin a statement, beside `let`.
const KEYWORDS: [&str; 11] =
    ["source", "parameters", "coordinates", "require", "set", "M", "C0", "C1", "Kc", "K0", "K2"];

fn statement_after(
    word: &str,
    keyword: &syn::Ident,
    input: ParseStream<'_>,
    docs: Doc,
    model: &mut Declaration,
    report: &mut Report,
) -> syn::Result<()> {
    match word {
        "source" => {
            let Some(source) = text(input)? else { return Err(expected(input, "a text in quotes")) };
            if model.source.replace(source).is_some() {
                report.error(keyword.span(), "a second `source`: expected one");
            }
            semicolon(input, "`;`", "the source")
        }
        "parameters" => {
            block(input, "the parameters", report, |input, report| parameter(input, &mut model.parameters, report))
        }
        "coordinates" => coordinates(input, keyword, model, report),
        "require" => {
            let value = expression(input)?;
            let Some(bound) = comparison(input)? else {
                return Err(expected(input, "a comparison such as `> 0`"));
            };
            model.requirements.push(Requirement { value, bound });
            semicolon(input, AFTER_FORMULA, "the requirement")
        }
        "set" => set(input, docs, model, report),
        other => match MatrixName::from_name(other) {
            Some(matrix_name) => {
                model.matrices.push(matrix(input, matrix_name, keyword.span())?);
                semicolon(input, "`;`", "the matrix")
            }
            None => unreachable!("a keyword that no statement begins with"),
        },
    }
}

fn block(
    input: ParseStream<'_>,
    what: &str,
    report: &mut Report,
    read: impl FnMut(ParseStream<'_>, &mut Report) -> syn::Result<()>,
) -> syn::Result<()> {
    if !input.peek(syn::token::Brace) {
        return Err(expected(input, &format!("`{{` and {what}")));
    }
    let content;
    syn::braced!(content in input);
    statements(&content, report, read);
    Ok(())
}

fn coordinates(
    input: ParseStream<'_>,
    keyword: &syn::Ident,
    model: &mut Declaration,
    report: &mut Report,
) -> syn::Result<()> {
    let mut second = Vec::new();
    let coordinates = if model.coordinates.is_empty() {
        &mut model.coordinates
    } else {
        report.error(keyword, "a second `coordinates`: expected one, since its order is that of the matrices");
        &mut second
    };
    block(input, "the coordinates", report, |input, report| coordinate(input, coordinates, report))
}

fn definition(input: ParseStream<'_>, model: &mut Declaration) -> syn::Result<()> {
    input.parse::<Token![let]>()?;
    let name = name(input, "the name of a definition")?;
    let value = || {
        if !input.peek(Token![=]) || input.peek(Token![==]) {
            return Err(expected(input, "`=` and a formula"));
        }
        input.parse::<Token![=]>()?;
        let value = expression(input)?;
        semicolon(input, AFTER_FORMULA, "the definition")?;
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

/// What may follow a formula at the end of a statement.
const AFTER_FORMULA: &str = "an operator (`+ - * / ^`) or `;`";

fn set(input: ParseStream<'_>, docs: Doc, model: &mut Declaration, report: &mut Report) -> syn::Result<()> {
    let name = name(input, "the name of a parameter set")?;
    let source = text(input)?;
    let mut values = Vec::new();
    block(input, "the values of the set", report, |input, _| {
        let name = self::name(input, "the name of a parameter")?;
        let value = || {
            if !input.peek(Token![=]) || input.peek(Token![==]) {
                return Err(expected(input, "`=` and a value"));
            }
            input.parse::<Token![=]>()?;
            let value = expression(input)?;
            semicolon(input, AFTER_FORMULA, "the value")?;
            Ok(value)
        };
        let value = value();
        values.push(SetValue { name, value: value.as_ref().ok().cloned() });
        value.map(|_| ())
    })?;
    model.sets.push(ParameterSet { docs, name, source, values });
    Ok(())
}

fn matrix(input: ParseStream<'_>, name: MatrixName, span: proc_macro2::Span) -> syn::Result<Matrix> {
    if input.parse::<Option<Token![=]>>()?.is_none() {
        return Err(expected(input, "`=` and the rows of the matrix"));
    }
    let (region, rows) = list(input, "the rows `[[…], […]]`", |input| list(input, "a row `[…]`", expression))?;
    Ok(Matrix { name, span, rows, region })
}

/// A list in brackets, with where it stands.
fn list<T>(
    input: ParseStream<'_>,
    what: &str,
    item: impl Fn(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<(Region, Vec<T>)> {
    if !input.peek(syn::token::Bracket) {
        return Err(expected(input, what));
    }
    let content;
    let brackets = syn::bracketed!(content in input);
    let mut items = Vec::new();
    while !content.is_empty() {
        items.push(item(&content)?);
        if !content.is_empty() && content.parse::<Option<Token![,]>>()?.is_none() {
            return Err(expected(&content, "`,` or `]`"));
        }
    }
    Ok((Region::from(brackets.span.open()).to(brackets.span.close().into()), items))
}
