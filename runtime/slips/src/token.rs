//! The tokens of a formula, each with its place in the text.

use std::ops::Range;

/// A token, or what stands between parentheses.
#[derive(Clone, Debug, PartialEq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// The bytes of the text that it takes.
    pub place: Range<usize>,
}

/// What a token is.
#[derive(Clone, Debug, PartialEq)]
pub enum TokenKind {
    /// A parameter, a definition, a function or pi.
    Name(String),
    /// A decimal number.
    Number(f64),
    /// One of `+ - * / ^`.
    Sign(char),
    /// What stands between parentheses.
    Group(Vec<Token>),
}

impl Token {
    /// Whether it is this sign.
    pub fn is(&self, sign: char) -> bool {
        self.kind == TokenKind::Sign(sign)
    }
}

/// The tokens of a formula; `None` if something in it is none.
pub fn tokens(text: &str) -> Option<Vec<Token>> {
    let mut reader = Reader { text, at: 0 };
    let tokens = reader.tokens()?;
    (reader.at == text.len()).then_some(tokens)
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl Reader<'_> {
    /// Up to the end, or to a parenthesis that closes.
    fn tokens(&mut self) -> Option<Vec<Token>> {
        let mut tokens = Vec::new();
        while let Some(first) = self.rest().chars().next() {
            let start = self.at;
            let kind = match first {
                ' ' | '\n' | '\t' | '\r' => {
                    self.at += 1;
                    continue;
                }
                ')' => break,
                '(' => {
                    self.at += 1;
                    let inner = self.tokens()?;
                    self.rest().starts_with(')').then_some(())?;
                    self.at += 1;
                    TokenKind::Group(inner)
                }
                '+' | '-' | '*' | '/' | '^' => {
                    self.at += 1;
                    TokenKind::Sign(first)
                }
                '0'..='9' => TokenKind::Number(self.number()?),
                letter if letter.is_alphabetic() || letter == '_' => {
                    TokenKind::Name(self.take_while(|c| c.is_alphanumeric() || c == '_').to_owned())
                }
                _ => return None,
            };
            tokens.push(Token { kind, place: start..self.at });
        }
        Some(tokens)
    }

    fn number(&mut self) -> Option<f64> {
        let start = self.at;
        self.take_while(|c| c.is_ascii_digit() || c == '.' || c == '_');
        let power = self.rest();
        if let Some(power) = power.strip_prefix(['e', 'E'])
            && power.trim_start_matches(['+', '-']).starts_with(|c: char| c.is_ascii_digit())
        {
            self.at += 1;
            self.take_while(|c| c == '+' || c == '-');
            self.take_while(|c| c.is_ascii_digit());
        }
        self.text[start..self.at].replace('_', "").parse().ok()
    }

    fn rest(&self) -> &str {
        &self.text[self.at..]
    }

    fn take_while(&mut self, belongs: impl Fn(char) -> bool) -> &str {
        let start = self.at;
        self.at += self.rest().find(|c| !belongs(c)).unwrap_or(self.rest().len());
        &self.text[start..self.at]
    }
}
