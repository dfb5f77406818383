//! Formulas: `+ - * /`, unary minus, `^` with whole exponents, parentheses, calls, decimal numbers.

use proc_macro2::{Delimiter, Ident, Literal, Span, TokenStream, TokenTree};
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};

use super::tokens::{expected, operator, signed_integer};
use super::unit::{Unit, unit};
use crate::formula::Decimal;
use crate::report::{Region, error};

/// A formula with the stretch of source that it comes from.
#[derive(Clone, Debug)]
pub struct Expression {
    pub kind: Kind,
    pub region: Region,
}

impl Expression {
    /// Calls `visit` with every name that is used as a value.
    pub fn names(&self, visit: &mut impl FnMut(&Ident)) {
        match &self.kind {
            Kind::Number(_) | Kind::Quantity(..) => {}
            Kind::Name(name) => visit(name),
            Kind::Sum(terms) => terms.iter().for_each(|term| term.value.names(visit)),
            Kind::Product(factors) => factors.iter().for_each(|factor| factor.value.names(visit)),
            Kind::Power(inner, _) | Kind::Call(_, inner) => inner.names(visit),
        }
    }
}

/// What a formula is. Sums and products are flat, so that long ones do not nest deeply.
#[derive(Clone, Debug)]
pub enum Kind {
    Number(Decimal),
    /// `0.3 [m]`.
    Quantity(Decimal, Unit),
    Name(Ident),
    Sum(Vec<Term>),
    Product(Vec<Factor>),
    Power(Box<Expression>, i32),
    Call(Ident, Box<Expression>),
}

/// One term of a sum; `operator` is the sign before it, where one is written.
#[derive(Clone, Debug)]
pub struct Term {
    pub negative: bool,
    pub operator: Option<Span>,
    pub value: Expression,
}

/// One factor of a product.
#[derive(Clone, Debug)]
pub struct Factor {
    pub inverse: bool,
    pub value: Expression,
}

/// Deeper nesting than this is a mistake, and would exhaust the stack.
const MAX_DEPTH: usize = 128;

/// Parses a formula up to the first token that cannot continue one.
pub fn expression(input: ParseStream<'_>) -> syn::Result<Expression> {
    let value = sum(input, 0)?;
    reject_other_syntax(input)?;
    Ok(value)
}

/// The formula that a text writes; for constants of the compiler's own.
pub fn constant(text: &str) -> syn::Result<Expression> {
    expression.parse_str(text)
}

fn sum(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    if depth > MAX_DEPTH {
        return Err(input.error(format!("nested too deeply: expected at most {MAX_DEPTH} levels")));
    }
    let mut terms = Vec::new();
    let mut operator = None;
    let mut negative = false;
    loop {
        let value = product(input, depth)?;
        terms.push(Term { negative, operator, value });
        let Some((sign @ ('+' | '-'), span)) = next_operator(input) else { break };
        input.parse::<TokenTree>()?;
        negative = sign == '-';
        operator = Some(span);
    }
    Ok(if terms.len() == 1 { terms.remove(0).value } else { sum_of(terms) })
}

/// A mark that could be an operator of formulas, unless it is part of another operator such as `+=` or `->`.
fn next_operator(input: ParseStream<'_>) -> Option<(char, Span)> {
    let (punct, _) = input.cursor().punct()?;
    let (text, _) = operator(input.cursor());
    (text.len() == 1).then(|| (punct.as_char(), punct.span()))
}

fn sum_of(terms: Vec<Term>) -> Expression {
    let first = terms[0].operator.map_or(terms[0].value.region, Region::from);
    let region = first.to(terms[terms.len() - 1].value.region);
    Expression { kind: Kind::Sum(terms), region }
}

fn product(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    let mut factors = Vec::new();
    let mut inverse = false;
    loop {
        let value = signed(input, depth)?;
        factors.push(Factor { inverse, value });
        let Some((sign @ ('*' | '/'), span)) = next_operator(input) else { break };
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
fn signed(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    let mut first = None;
    let mut negative = false;
    while let Some(minus) = input.parse::<Option<Token![-]>>()? {
        first.get_or_insert(minus.span);
        negative = !negative;
    }
    let value = power(input, depth)?;
    Ok(match first {
        None => value,
        Some(_) if !negative => value,
        Some(span) => sum_of(vec![Term { negative, operator: Some(span), value }]),
    })
}

fn power(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    let base = primary(input, depth)?;
    if input.parse::<Option<Token![^]>>()?.is_none() {
        return Ok(base);
    }
    let (exponent, end) = if input.peek(syn::token::Paren) {
        let content;
        let parentheses = syn::parenthesized!(content in input);
        let (exponent, _) = signed_integer(&content)?;
        if !content.is_empty() {
            return Err(expected(&content, "`)`: an exponent is one whole number"));
        }
        (exponent, Region::from(parentheses.span.close()))
    } else {
        signed_integer(input)?
    };
    if input.peek(Token![^]) {
        return Err(expected(input, "parentheses: a power of a power is ambiguous"));
    }
    let region = base.region.to(end);
    Ok(Expression { kind: Kind::Power(Box::new(base), exponent), region })
}

fn primary(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    // A fragment of an outer `macro_rules!` comes wrapped in a group without delimiters, and stays one value.
    if let Some((inside, span)) = invisible_group(input)? {
        let value = (|inner: ParseStream<'_>| expression_to_end(inner, depth + 1)).parse2(inside)?;
        return Ok(Expression { region: span.into(), ..value });
    }
    if input.peek(syn::token::Paren) {
        let content;
        let parentheses = syn::parenthesized!(content in input);
        let value = expression_to_end(&content, depth + 1)?;
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
            let unit = unit(&content)?;
            if !content.is_empty() {
                return Err(expected(&content, "`*`, `/` or `]`"));
            }
            Ok(Expression { kind: Kind::Quantity(number, unit), region: region.to(brackets.span.close().into()) })
        }
        Some((TokenTree::Ident(_), _)) => name_or_call(input, depth),
        _ => Err(expected(input, what_instead(input))),
    }
}

/// What to say where a value should be and none is.
fn what_instead(input: ParseStream<'_>) -> &'static str {
    if input.peek(Token![.]) && input.peek2(syn::LitInt) {
        "a digit before the point of a number, as in `0.5`"
    } else if input.peek(Token![&]) {
        "a formula, without references"
    } else if input.peek(Token![|]) {
        "a formula, without closures"
    } else if input.peek(Token![!]) {
        "a formula, without logic"
    } else if input.peek(syn::token::Brace) {
        "a formula, grouped by parentheses"
    } else {
        "a formula"
    }
}

fn invisible_group(input: ParseStream<'_>) -> syn::Result<Option<(TokenStream, Span)>> {
    input.step(|cursor| {
        Ok(match cursor.group(Delimiter::None) {
            Some((inside, span, after)) => (Some((inside.token_stream(), span.join())), after),
            None => (None, *cursor),
        })
    })
}

fn expression_to_end(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    let value = sum(input, depth)?;
    reject_other_syntax(input)?;
    if input.is_empty() {
        Ok(value)
    } else {
        Err(expected(input, "an operator (`+ - * / ^`) or the end of the formula"))
    }
}

fn name_or_call(input: ParseStream<'_>, depth: usize) -> syn::Result<Expression> {
    let ident = input.call(Ident::parse_any)?;
    let text = ident.to_string();
    if starts_statement(&text) {
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
    let argument = sum(&content, depth + 1)?;
    reject_other_syntax(&content)?;
    if !content.is_empty() {
        return Err(expected(&content, &format!("`)`: `{text}` takes one argument")));
    }
    Ok(Expression { kind: Kind::Call(ident, Box::new(argument)), region })
}

/// Words that more than an operator would follow; other words of Rust are names that the check refuses.
fn starts_statement(word: &str) -> bool {
    const WORDS: [&str; 12] =
        ["if", "match", "while", "for", "loop", "unsafe", "async", "move", "return", "break", "continue", "let"];
    WORDS.contains(&word)
}

/// Rust that may follow a value, but has no meaning in a formula.
fn reject_other_syntax(input: ParseStream<'_>) -> syn::Result<()> {
    let what = if input.peek(Token![..]) {
        "ranges are"
    } else if input.peek(Token![.]) {
        "method calls and fields are"
    } else if input.peek(Token![::]) {
        "paths are"
    } else if input.peek(Token![?]) {
        "`?` is"
    } else if input.peek(Token![!]) && !input.peek(Token![!=]) {
        "macros are"
    } else if input.peek(Token![as]) {
        "casts are"
    } else if input.peek(Token![%]) {
        "`%` is"
    } else if input.peek(syn::token::Bracket) {
        "indexing is"
    } else if input.peek(Token![&]) || input.peek(Token![|]) {
        "logic is"
    } else {
        return Ok(());
    };
    let region = match input.cursor().token_tree() {
        Some((TokenTree::Punct(_), _)) => operator(input.cursor()).1,
        Some((token, _)) => token.span().into(),
        None => input.span().into(),
    };
    let instead = if what.starts_with("paths") { "a name alone, such as `pi`" } else { "an operator (`+ - * / ^`)" };
    Err(error(region, format!("{what} not supported in formulas: expected {instead}")))
}
