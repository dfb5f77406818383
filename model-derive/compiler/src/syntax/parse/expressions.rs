//! Formulas: `+ - * /`, unary minus, `^` with whole exponents, parentheses, calls, decimal numbers.

use proc_macro2::{Delimiter, Ident, Literal, Span, TokenStream, TokenTree};
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};

use super::rust_syntax::{describe_expected, reject_rust_syntax, starts_rust_statement};
use super::tokens::{expected, operator_at, parse_signed_integer};
use super::units::parse_unit;
use crate::formula::{Decimal, Function};
use crate::report::{Region, error};
use crate::syntax::tree::{Expression, Factor, Kind, Term};

/// Deeper nesting than this is a mistake, and would exhaust the stack.
const MAX_DEPTH: usize = 128;

/// Parses a formula up to the first token that cannot continue one.
pub fn parse_expression(input: ParseStream<'_>) -> syn::Result<Expression> {
    let value = parse_sum(input, 0)?;
    reject_rust_syntax(input)?;
    Ok(value)
}

/// The formula that a text writes; for constants of the compiler's own.
pub fn constant(text: &str) -> syn::Result<Expression> {
    parse_expression.parse_str(text)
}

fn parse_sum(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    if depth > MAX_DEPTH {
        return Err(input.error(format!("nested too deeply: expected at most {MAX_DEPTH} levels")));
    }
    let mut terms = Vec::new();
    let mut operator = None;
    let mut negative = false;
    loop {
        let value = parse_product(input, depth)?;
        terms.push(Term { negative, operator, value });
        let Some((sign @ ('+' | '-'), span)) = peek_operator(input) else { break };
        input.parse::<TokenTree>()?;
        negative = sign == '-';
        operator = Some(span);
    }
    Ok(if terms.len() == 1 { terms.remove(0).value } else { build_sum(terms) })
}

/// A mark that could be an operator of formulas, unless it is part of another operator such as `+=` or `->`.
fn peek_operator(input: ParseStream<'_>) -> Option<(char, Span)> {
    let (punct, _) = input.cursor().punct()?;
    let (text, _) = operator_at(input.cursor());
    (text.len() == 1).then(|| (punct.as_char(), punct.span()))
}

fn build_sum(terms: Vec<Term>) -> Expression {
    let first = terms[0].operator.map_or(terms[0].value.region, Region::from);
    let region = first.to(terms[terms.len() - 1].value.region);
    Expression { kind: Kind::Sum(terms), region }
}

fn parse_product(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    let mut factors = Vec::new();
    let mut inverse = false;
    loop {
        let value = parse_signed(input, depth)?;
        factors.push(Factor { inverse, value });
        let Some((sign @ ('*' | '/'), span)) = peek_operator(input) else { break };
        input.parse::<TokenTree>()?;
        if let Some((second, _)) = input.cursor().punct().filter(|(second, _)| sign == '*' && second.as_char() == '*') {
            return Err(error(Region::from(span).to(second.span().into()), "found `**`: expected `^` for a power"));
        }
        inverse = sign == '/';
    }
    if factors.len() == 1 {
        return Ok(factors.remove(0).value);
    }
    let region = factors[0].value.region.to(factors[factors.len() - 1].value.region);
    Ok(Expression { kind: Kind::Product(factors), region })
}

/// A power with any number of minus signs before it: `-x^2` is `-(x^2)`.
fn parse_signed(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    let mut first = None;
    let mut negative = false;
    while let Some(minus) = input.parse::<Option<Token![-]>>()? {
        first.get_or_insert(minus.span);
        negative = !negative;
    }
    let value = parse_power(input, depth)?;
    Ok(match first {
        None => value,
        Some(_) if !negative => value,
        Some(span) => build_sum(vec![Term { negative, operator: Some(span), value }]),
    })
}

fn parse_power(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    let base = parse_primary(input, depth)?;
    if input.parse::<Option<Token![^]>>()?.is_none() {
        return Ok(base);
    }
    let (exponent, end) = if input.peek(syn::token::Paren) {
        let content;
        let parentheses = syn::parenthesized!(content in input);
        let (exponent, _) = parse_signed_integer(&content)?;
        if !content.is_empty() {
            return Err(expected(&content, "`)`: an exponent is one whole number, and a root is written `sqrt(x)`"));
        }
        (exponent, Region::from(parentheses.span.close()))
    } else {
        parse_signed_integer(input)?
    };
    if input.peek(Token![^]) {
        return Err(expected(input, "parentheses: a power of a power is ambiguous"));
    }
    let region = base.region.to(end);
    Ok(Expression { kind: Kind::Power(Box::new(base), exponent), region })
}

fn parse_primary(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    // A fragment of an outer `macro_rules!` comes wrapped in a group without delimiters, and stays one value.
    if let Some((inside, span)) = take_invisible_group(input)? {
        let value = (|inner: ParseStream<'_>| parse_to_end(inner, depth + 1)).parse2(inside)?;
        return Ok(Expression { region: span.into(), ..value });
    }
    if input.peek(syn::token::Paren) {
        let content;
        let parentheses = syn::parenthesized!(content in input);
        let value = parse_to_end(&content, depth + 1)?;
        let region = Region::from(parentheses.span.open()).to(parentheses.span.close().into());
        return Ok(Expression { region, ..value });
    }
    match input.cursor().token_tree() {
        Some((TokenTree::Literal(literal), _)) => {
            input.parse::<Literal>()?;
            let number = Decimal::from_literal(&literal).map_err(|message| error(literal.span(), message))?;
            if input.peek(Token![.]) && !input.peek(Token![..]) {
                return Err(expected(input, "digits on both sides of the point of a number, as in `1.0e5`"));
            }
            let region = Region::from(literal.span());
            if !input.peek(syn::token::Bracket) {
                return Ok(Expression { kind: Kind::Number(number), region });
            }
            let content;
            let brackets = syn::bracketed!(content in input);
            let unit = parse_unit(&content)?;
            if !content.is_empty() {
                return Err(expected(&content, "`*`, `/` or `]`"));
            }
            Ok(Expression { kind: Kind::Quantity(number, unit), region: region.to(brackets.span.close().into()) })
        }
        Some((TokenTree::Ident(_), _)) => parse_name_or_call(input, depth),
        _ => Err(expected(input, describe_expected(input))),
    }
}

fn take_invisible_group(input: ParseStream<'_>) -> syn::Result<Option<(TokenStream, Span)>> {
    input.step(|cursor| {
        Ok(match cursor.group(Delimiter::None) {
            Some((inside, span, after)) => (Some((inside.token_stream(), span.join())), after),
            None => (None, *cursor),
        })
    })
}

fn parse_to_end(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    let value = parse_sum(input, depth)?;
    reject_rust_syntax(input)?;
    if input.is_empty() {
        Ok(value)
    } else {
        Err(expected(input, "an operator (`+ - * / ^`) or the end of the formula"))
    }
}

fn parse_name_or_call(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    let ident = input.call(Ident::parse_any)?;
    let text = ident.to_string();
    if starts_rust_statement(&text) {
        return Err(error(&ident, format!("`{text}` is not supported in formulas: expected a formula")));
    }
    if !input.peek(syn::token::Paren) {
        let region = Region::from(&ident);
        return Ok(Expression { kind: Kind::Name(ident), region });
    }
    if ident == "pi" {
        return Err(expected(input, "no parentheses: `pi` is a number"));
    }
    let content;
    let parentheses = syn::parenthesized!(content in input);
    let region = Region::from(&ident).to(parentheses.span.close().into());
    let argument = parse_sum(&content, depth + 1)?;
    reject_rust_syntax(&content)?;
    if !content.is_empty() {
        if Function::from_name(&text).is_none() {
            let known = Function::ALL.map(Function::name).join(", ");
            let message = format!("`{text}` is no function of several arguments: expected one of {known}, each of one");
            return Err(error(&ident, message));
        }
        return Err(expected(&content, &format!("`)`: `{text}` takes one argument")));
    }
    Ok(Expression { kind: Kind::Call(ident, Box::new(argument)), region })
}
