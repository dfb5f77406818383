//! Matrices, written row by row.

use proc_macro2::{Literal, Span};
use syn::Token;
use syn::parse::ParseStream;

use super::expressions::parse_expression;
use super::tokens::{expected, parse_list, parse_semicolon};
use crate::matrix_name::{MatrixName, Whole};
use crate::report::{Region, Report, error};
use crate::syntax::tree::{Declaration, Matrix};

/// `symmetric M = …;`, behind its first word.
pub fn parse_symmetric(input: ParseStream<'_>, model: &mut Declaration, report: &mut Report) -> syn::Result<()> {
    if input.cursor().ident().is_some_and(|(word, _)| word == "add") {
        let add: syn::Ident = input.parse()?;
        report.error(&add, "found `symmetric add`: expected `add symmetric`");
        return parse_added(input, model);
    }
    let what = "a matrix after `symmetric`: `M`, `C-1`, `C0`, `C1`, `Kc`, `K0`, `K1` or `K2`, or `C` or `K`";
    if !input.peek(syn::Ident) {
        return Err(expected(input, what));
    }
    let name: syn::Ident = input.parse()?;
    if parse_declared_matrix(&name.to_string(), name.span(), true, input, model)? {
        return Ok(());
    }
    Err(error(&name, format!("found `{name}`: expected {what}")))
}

/// `M = …;` or `C = …;`, behind the word that it begins with; `false` if no matrix does.
pub fn parse_declared_matrix(
    word: &str,
    span: Span,
    symmetric: bool,
    input: ParseStream<'_>,
    model: &mut Declaration,
) -> syn::Result<bool> {
    if let Some(name) = parse_name_behind(word, input)? {
        model.matrices.push(parse_matrix(input, name, span, symmetric)?);
    } else if let Some(whole) = Whole::from_name(word) {
        model.wholes.push((whole, parse_matrix(input, whole.plain(), span, symmetric)?));
    } else {
        return Ok(false);
    }
    parse_semicolon(input, "`;`", "the matrix")?;
    Ok(true)
}

/// `add C0 = …;` or `add symmetric C0 = …;`, behind its first word.
pub fn parse_added(input: ParseStream<'_>, model: &mut Declaration) -> syn::Result<()> {
    let is_symmetric = input.cursor().ident().is_some_and(|(word, _)| word == "symmetric");
    if is_symmetric {
        input.parse::<syn::Ident>()?;
    }
    let what = "a matrix after `add`: `M`, `C-1`, `C0`, `C1`, `Kc`, `K0`, `K1` or `K2`, with `symmetric` before it if that \
                is to be proved";
    let (name, span) = parse_matrix_name(input, what)?;
    model.added.push(parse_matrix(input, name, span, is_symmetric)?);
    parse_semicolon(input, "`;`", "the matrix")
}

/// The name of a matrix; `what` says what is expected.
pub fn parse_matrix_name(input: ParseStream<'_>, what: &str) -> syn::Result<(MatrixName, Span)> {
    if !input.peek(syn::Ident) {
        return Err(expected(input, what));
    }
    let name: syn::Ident = input.parse()?;
    match parse_name_behind(&name.to_string(), input)? {
        Some(matrix) => Ok((matrix, name.span())),
        None => Err(error(&name, format!("found `{name}`: expected {what}"))),
    }
}

/// The matrix whose name begins with a word, behind that: `C` is the beginning of `C-1`.
pub fn parse_name_behind(word: &str, input: ParseStream<'_>) -> syn::Result<Option<MatrixName>> {
    if word != "C" || !starts_minus_one(input) {
        return Ok(MatrixName::from_name(word));
    }
    input.parse::<Token![-]>()?;
    input.parse::<Literal>()?;
    Ok(Some(MatrixName::Cm1))
}

/// Whether `-1` follows.
pub fn starts_minus_one(input: ParseStream<'_>) -> bool {
    let Some((minus, after)) = input.cursor().punct() else { return false };
    minus.as_char() == '-' && after.literal().is_some_and(|(one, _)| one.to_string() == "1")
}

/// `M = …`, behind its name.
pub fn parse_matrix(input: ParseStream<'_>, name: MatrixName, span: Span, symmetric: bool) -> syn::Result<Matrix> {
    if input.peek(Token![+=]) {
        let what = format!(
            "`=` and the rows of the matrix; to that of a mechanism one is added by `add {0} = …`",
            name.name()
        );
        return Err(expected(input, &what));
    }
    if input.parse::<Option<Token![=]>>()?.is_none() {
        return Err(expected(input, "`=` and the rows of the matrix"));
    }
    let (region, rows) = parse_rows(input, parse_expression)?;
    Ok(Matrix { name, symmetric, span, rows, region })
}

/// The rows of a matrix, each with its region.
pub type Rows<T> = Vec<(Region, Vec<T>)>;

/// `[[…], […]]`, with where it stands.
pub fn parse_rows<T>(
    input: ParseStream<'_>,
    entry: impl Fn(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<(Region, Rows<T>)> {
    parse_list(input, "the rows `[[…], […]]`", |input| parse_list(input, "a row `[…]`", &entry))
}
