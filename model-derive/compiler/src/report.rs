//! The mistakes found in a declaration, collected so that all of them are reported at once.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};

/// A stretch of source from its first to its last token.
#[derive(Clone, Copy, Debug)]
pub struct Region {
    start: Span,
    end: Span,
}

impl Region {
    /// From the start of one region to the end of another.
    pub fn to(self, end: Region) -> Region {
        Region { start: self.start, end: end.end }
    }
}

impl From<Span> for Region {
    fn from(span: Span) -> Self {
        Region { start: span, end: span }
    }
}

impl From<&Ident> for Region {
    fn from(ident: &Ident) -> Self {
        ident.span().into()
    }
}

/// Collects errors; a stage hands it on, and the driver finishes it.
#[derive(Debug, Default)]
#[must_use]
pub struct Report {
    errors: Vec<syn::Error>,
}

impl Report {
    /// Notes a mistake in `region`: what is there, and what was expected.
    pub fn error(&mut self, region: impl Into<Region>, message: impl std::fmt::Display) {
        self.errors.push(error(region, message));
    }

    /// Notes an error that a parser returned.
    pub fn push(&mut self, error: syn::Error) {
        self.errors.push(error);
    }

    /// Whether nothing was noted.
    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// The end of the line: all errors as one, in the order of the source, whichever stage found them.
    ///
    /// # Errors
    /// If any error was noted.
    pub fn finish(self) -> Result<(), syn::Error> {
        let mut errors = self.errors;
        errors.sort_by_key(|error| {
            let start = error.span().start();
            (start.line, start.column)
        });
        let combined = errors.into_iter().reduce(|mut all, next| {
            all.combine(next);
            all
        });
        combined.map_or(Ok(()), Err)
    }
}

/// A number for a message: with a power of ten where there would be many zeros.
pub fn number(value: f64) -> String {
    if value == 0.0 || (1e-4..1e7).contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}

/// An error that underlines all of `region`.
pub fn error(region: impl Into<Region>, message: impl std::fmt::Display) -> syn::Error {
    let Region { start, end } = region.into();
    // `syn` takes the ends of a range from the first and the last token it is given.
    let ends: TokenStream = [start, end].map(|span| TokenTree::from(Ident::new("_", span))).into_iter().collect();
    syn::Error::new_spanned(ends, message)
}
