//! Which derivatives of the matrices are asked for.

use syn::Token;
use syn::parse::ParseStream;

use super::matrices::parse_matrix_name;
use super::names::parse_used;
use super::tokens::{expected, parse_semicolon, parse_word};
use crate::syntax::tree::AskedDerivatives;

/// `derivatives;` or `derivatives of M, K0 with respect to w, c;`, behind its first word.
pub fn parse_derivatives(keyword: &syn::Ident, input: ParseStream<'_>) -> syn::Result<AskedDerivatives> {
    let mut asked = AskedDerivatives { span: keyword.span(), matrices: None, parameters: None };
    let mut after = "`of M, …`, `with respect to m, …` or `;`";
    if starts_with(input, "of") {
        input.parse::<syn::Ident>()?;
        let what = "a matrix after `derivatives of`: `M`, `C-1`, `C0`, `C1`, `Kc`, `K0`, `K1` or `K2`";
        asked.matrices = Some(parse_names(input, |input| parse_matrix_name(input, what))?);
        after = "`,`, `with respect to m, …` or `;`";
    }
    if starts_with(input, "with") {
        input.parse::<syn::Ident>()?;
        parse_word(input, "respect", "`respect to` and parameters after `with`")?;
        parse_word(input, "to", "`to` and parameters after `with respect`")?;
        asked.parameters = Some(parse_names(input, |input| parse_used(input, "a parameter after `with respect to`"))?);
        after = "`,` or `;`";
    }
    if starts_with(input, "of") {
        return Err(expected(input, "the matrices before the parameters: `derivatives of M with respect to m;`"));
    }
    parse_semicolon(input, after, "`derivatives`: by itself it asks for all of them")?;
    Ok(asked)
}

fn starts_with(input: ParseStream<'_>, word: &str) -> bool {
    input.cursor().ident().is_some_and(|(found, _)| found == word)
}

/// At least one name, with commas between them and perhaps behind them.
fn parse_names<T>(input: ParseStream<'_>, name: impl Fn(ParseStream<'_>) -> syn::Result<T>) -> syn::Result<Vec<T>> {
    let mut names = vec![name(input)?];
    while input.parse::<Option<Token![,]>>()?.is_some() && !input.peek(Token![;]) && !starts_with(input, "with") {
        names.push(name(input)?);
    }
    Ok(names)
}
