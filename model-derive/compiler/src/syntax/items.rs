//! The statements of a declaration.

use proc_macro2::{Group, TokenStream, TokenTree};
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::discouraged::Speculative as _;
use syn::parse::{ParseStream, Parser};

use super::declaration::{
    Assertion, Declaration, Definition, Doc, Matrix, MatrixName, ParameterSet, Printed, Published, Requirement,
    SetValue,
};
use super::expression::expression;
use super::mechanism;
use super::parameters::{self, comparison, coordinate, parameter, value};
use super::parts::Mechanism;
use super::tokens::{declared, docs, expected, name, semicolon, skip_statement, text};
use crate::formula::Decimal;
use crate::nearest::nearest;
use crate::report::{Region, Report, error};

/// `/// docs  pub model Name { statements }`
pub fn declaration(input: ParseStream<'_>, report: &mut Report) -> syn::Result<Declaration> {
    let docs = docs(input, MODEL, report)?;
    let visibility = visibility(input)?;
    if !input.peek(syn::Ident::peek_any) || input.fork().call(syn::Ident::parse_any)? != "model" {
        return Err(expected(input, MODEL));
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
        assertions: Vec::new(),
        asserted: Vec::new(),
        sets: Vec::new(),
        coordinates: Vec::new(),
        matrices: Vec::new(),
        mechanism: None,
        kinematics: None,
        derivatives: None,
        unread: Vec::new(),
    };
    statements(&content, report, starts, |input, report| statement(input, &mut declaration, report));
    if !input.is_empty() {
        report.push(expected(input, "nothing after the model: one `model!` declares one model"));
        input.parse::<TokenStream>()?;
    }
    Ok(declaration)
}

const MODEL: &str = "`model Name { … }`, with `pub` before it if it is public";

fn visibility(input: ParseStream<'_>) -> syn::Result<TokenStream> {
    let visibility: syn::Visibility = input.parse()?;
    Ok(quote::quote!(#visibility))
}

/// Reads statements to the end; one that cannot be read is reported and skipped, up to where the next one `starts`.
fn statements(
    input: ParseStream<'_>,
    report: &mut Report,
    starts: fn(ParseStream<'_>) -> bool,
    mut read: impl FnMut(ParseStream<'_>, &mut Report) -> syn::Result<()>,
) {
    while !input.is_empty() {
        let before = input.cursor();
        if let Err(error) = read(input, report) {
            report.push(error);
            skip_statement(input, input.cursor() != before, starts);
        }
    }
}

const STATEMENTS: &str = "a statement: `parameters { … }`, `let name = …;`, `require … > 0;`, `assert … == …;`, \
                          `set name { … }`, `coordinates { … }`, `mechanism { … }`, `derivatives;`, `source \"…\";` or a matrix `M`, `C0`, \
                          `C1`, `Kc`, `K0`, `K2`, with `symmetric` before it if that is to be proved";

fn statement(input: ParseStream<'_>, model: &mut Declaration, report: &mut Report) -> syn::Result<()> {
    let start = input.span();
    let docs = docs(input, "what it is about", report)?;
    let is_set = input.cursor().ident().is_some_and(|(word, _)| word == "set");
    if !docs.is_empty() && !is_set {
        report.error(start, LOST);
    }
    if input.peek(Token![let]) {
        return definition(input, model, report);
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
        return statement_after(&word, &keyword, input, docs, model, report);
    }
    let Some(meant) = nearest(&word, KEYWORDS.into_iter()) else {
        return Err(error(&keyword, format!("found `{word}`: expected {STATEMENTS}")));
    };
    // Read on as what was meant, so that the names inside are known.
    report.error(&keyword, format!("found `{word}`: expected a statement; did you mean `{meant}`?"));
    statement_after(meant, &keyword, input, docs, model, report)
}

const LOST: &str = "documentation that would be lost: expected a comment (`// …`), since only the model, its \
                    parameters, coordinates and sets are documented";

/// Whether a statement starts here.
fn starts(input: ParseStream<'_>) -> bool {
    let Some((word, _)) = input.cursor().ident() else { return false };
    let follows = input.peek2(syn::token::Brace) || input.peek2(syn::LitStr) || input.peek2(syn::Ident);
    let assigned = input.peek2(Token![=]) && !input.peek2(Token![==]);
    let follows = follows || word == "derivatives" && input.peek2(Token![;]);
    word == "let" || KEYWORDS.iter().any(|keyword| word == keyword) && (follows || assigned)
}

/// What may begin a statement, beside `let`.
const KEYWORDS: [&str; 15] = [
    "source",
    "parameters",
    "coordinates",
    "mechanism",
    "derivatives",
    "require",
    "assert",
    "set",
    "symmetric",
    "M",
    "C0",
    "C1",
    "Kc",
    "K0",
    "K2",
];

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
        "parameters" => block(input, "the parameters", report, parameters::starts, |input, report| {
            parameter(input, &mut model.parameters, &mut model.unread, report)
        }),
        "coordinates" => coordinates(input, keyword, model, report),
        "mechanism" => mechanism(input, keyword, model, report),
        "derivatives" => {
            if model.derivatives.replace(keyword.span()).is_some() {
                report.error(keyword, "a second `derivatives`: expected one, since it asks for all derivatives");
            }
            semicolon(input, "`;`", "`derivatives`: it asks for all of them")
        }
        "require" => {
            let value = expression(input)?;
            let Some(bound) = comparison(input)? else {
                return Err(expected(input, "a comparison such as `> 0`"));
            };
            if input.peek(Token![<]) || input.peek(Token![>]) {
                return Err(expected(input, "one comparison: write two requirements for two"));
            }
            model.requirements.push(Requirement { value, bound });
            semicolon(input, AFTER_FORMULA, "the requirement")
        }
        "assert" => assertion(input, model),
        "symmetric" => symmetric(input, model),
        "set" => set(input, docs, model, report),
        other => match MatrixName::from_name(other) {
            Some(matrix_name) => {
                model.matrices.push(matrix(input, matrix_name, keyword.span(), false)?);
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
    starts: fn(ParseStream<'_>) -> bool,
    mut read: impl FnMut(ParseStream<'_>, &mut Report) -> syn::Result<()>,
) -> syn::Result<()> {
    let expectation = format!("`{{` and {what}");
    // `parameters = { … }` and `parameters [ … ]` are read all the same, so that the names inside are known.
    if (input.peek(Token![=]) || input.peek(Token![:])) && input.peek2(syn::token::Brace) {
        report.push(expected(input, &expectation));
        input.parse::<TokenTree>()?;
    }
    if !input.peek(syn::token::Brace) {
        let error = expected(input, &expectation);
        let Ok(group) = input.parse::<Group>() else { return Err(error) };
        report.push(error);
        return (|content: ParseStream<'_>| {
            statements(content, report, starts, &mut read);
            Ok(())
        })
        .parse2(group.stream());
    }
    let content;
    syn::braced!(content in input);
    statements(&content, report, starts, read);
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
    block(input, "the coordinates", report, parameters::starts, |input, report| coordinate(input, coordinates, report))
}

fn mechanism(
    input: ParseStream<'_>,
    keyword: &syn::Ident,
    model: &mut Declaration,
    report: &mut Report,
) -> syn::Result<()> {
    let mut mechanism = Mechanism::new(keyword.span());
    let read = block(input, "the parts of the mechanism", report, mechanism::starts, |input, report| {
        let start = input.span();
        if !docs(input, "what it is about", report)?.is_empty() {
            report.error(start, LOST);
        }
        mechanism::statement(input, &mut mechanism, report)
    });
    if read.is_err() {
        mechanism.unread.push(None);
    }
    if model.mechanism.is_some() {
        report.error(keyword, "a second `mechanism`: expected one");
    }
    model.mechanism.get_or_insert(mechanism);
    read
}

fn definition(input: ParseStream<'_>, model: &mut Declaration, report: &mut Report) -> syn::Result<()> {
    input.parse::<Token![let]>()?;
    let what = "the name of a definition";
    if input.peek(Token![mut]) {
        report.push(expected(input, &format!("{what}, which never changes")));
        input.parse::<Token![mut]>()?;
    }
    let name = declared(input, what)?;
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
        Ok(value) => model.definitions.push(Definition { name, value, derived: false }),
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
    let mut published = Vec::new();
    let starts = |input: ParseStream<'_>| input.peek(syn::Ident) && input.peek2(Token![=]) && !input.peek2(Token![==]);
    block(input, "the values of the set", report, starts, |input, report| {
        let (start, what) = (input.span(), "the name of a parameter");
        if !self::docs(input, what, report)?.is_empty() {
            report.error(start, LOST);
        }
        let name = declared(input, what)?;
        if let Some(matrix) = MatrixName::from_name(&name.to_string())
            && input.peek(Token![=])
            && input.peek2(syn::token::Bracket)
        {
            input.parse::<Token![=]>()?;
            let (region, rows) = rows(input, printed)?;
            published.push(Published { name: matrix, span: name.span(), rows, region });
            return semicolon(input, "`;`", "the matrix");
        }
        let value = || {
            if !input.peek(Token![=]) || input.peek(Token![==]) {
                return Err(expected(input, "`=` and a value"));
            }
            input.parse::<Token![=]>()?;
            let value = value(input)?;
            semicolon(input, "an operator (`+ - * / ^`), a unit or `;`", "the value")?;
            Ok(value)
        };
        let value = value();
        values.push(SetValue { name, value: value.as_ref().ok().cloned() });
        value.map(|_| ())
    })?;
    model.sets.push(ParameterSet { docs, name, source, values, published });
    Ok(())
}

/// A decimal number as it was printed, with its sign.
fn printed(input: ParseStream<'_>) -> syn::Result<Printed> {
    let minus = input.parse::<Option<Token![-]>>()?;
    let Some((TokenTree::Literal(literal), _)) = input.cursor().token_tree() else {
        return Err(expected(input, "a decimal number as it was printed"));
    };
    input.parse::<TokenTree>()?;
    Decimal::from_literal(&literal).map_err(|message| error(literal.span(), message))?;
    let region = Region::from(literal.span());
    let sign = if minus.is_some() { "-" } else { "" };
    let text = format!("{sign}{}", literal.to_string().replace('_', ""));
    Ok(Printed { text, region: minus.map_or(region, |minus| Region::from(minus.span).to(region)) })
}

/// `assert left == right;` or `assert M == [[…], …];`, behind its first word.
fn assertion(input: ParseStream<'_>, model: &mut Declaration) -> syn::Result<()> {
    let ahead = input.fork();
    if let Ok(name) = ahead.parse::<syn::Ident>()
        && let Some(matrix) = MatrixName::from_name(&name.to_string())
        && ahead.parse::<Token![==]>().is_ok()
        && ahead.peek(syn::token::Bracket)
    {
        input.advance_to(&ahead);
        let (region, rows) = rows(input, expression)?;
        model.asserted.push(Matrix { name: matrix, symmetric: false, span: name.span(), rows, region });
        return semicolon(input, "`;`", "the assertion");
    }
    let left = expression(input)?;
    if input.parse::<Option<Token![==]>>()?.is_none() {
        let what = "`==` and the formula that it equals; a condition on the parameters is a `require`";
        return Err(expected(input, what));
    }
    let right = expression(input)?;
    semicolon(input, AFTER_FORMULA, "the assertion")?;
    model.assertions.push(Assertion { left, right, entry: None });
    Ok(())
}

/// `symmetric M = …;`, behind its first word.
fn symmetric(input: ParseStream<'_>, model: &mut Declaration) -> syn::Result<()> {
    let what = "a matrix after `symmetric`: `M`, `C0`, `C1`, `Kc`, `K0` or `K2`";
    if !input.peek(syn::Ident) {
        return Err(expected(input, what));
    }
    let name: syn::Ident = input.parse()?;
    let Some(matrix_name) = MatrixName::from_name(&name.to_string()) else {
        return Err(error(&name, format!("found `{name}`: expected {what}")));
    };
    model.matrices.push(matrix(input, matrix_name, name.span(), true)?);
    semicolon(input, "`;`", "the matrix")
}

fn matrix(input: ParseStream<'_>, name: MatrixName, span: proc_macro2::Span, symmetric: bool) -> syn::Result<Matrix> {
    if input.parse::<Option<Token![=]>>()?.is_none() {
        return Err(expected(input, "`=` and the rows of the matrix"));
    }
    let (region, rows) = rows(input, expression)?;
    Ok(Matrix { name, symmetric, span, rows, region })
}

/// The rows of a matrix, each with its region.
type Rows<T> = Vec<(Region, Vec<T>)>;

fn rows<T>(
    input: ParseStream<'_>,
    entry: impl Fn(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<(Region, Rows<T>)> {
    list(input, "the rows `[[…], […]]`", |input| list(input, "a row `[…]`", &entry))
}

/// A list in brackets, with where it stands.
pub fn list<T>(
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
