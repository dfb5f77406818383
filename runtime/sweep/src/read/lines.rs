//! The bytes of a CSV file as they may be read: without comments, and judged line by line.

use std::fmt;
use std::io::{Error, ErrorKind, Read, Result};

/// Longer lines are taken for a file of another kind; they would fill the memory.
const MAX_LINE: usize = 1 << 20;

/// What is wrong with a line.
#[derive(Debug)]
pub struct LineProblem {
    pub line: usize,
    pub message: &'static str,
}

impl fmt::Display for LineProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)
    }
}

impl std::error::Error for LineProblem {}

/// Where in a line a byte stands. Quotes count as in the `csv` crate: only at the very beginning of a field.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Line,
    Comment,
    Field,
    Plain,
    Quoted,
    /// After a quote within quotes, which ends them unless another one follows.
    Quote,
}

/// Leaves out the lines before the header that begin with `#`, and refuses fields with a line break: behind a quote that
/// nobody closed the rest of the file would be one of them.
pub struct Lines<R> {
    inner: R,
    separator: u8,
    state: State,
    /// Its number, from 1 on.
    line: usize,
    length: usize,
    /// Whether the header is still to come.
    is_before: bool,
    /// How much of a byte order mark may still come.
    mark: &'static [u8],
}

impl<R: Read> Lines<R> {
    pub fn new(inner: R, separator: u8) -> Self {
        Self { inner, separator, state: State::Line, line: 1, length: 0, is_before: true, mark: b"\xef\xbb\xbf" }
    }

    fn fail<T>(&self, message: &'static str) -> Result<T> {
        Err(Error::new(ErrorKind::InvalidData, LineProblem { line: self.line, message }))
    }

    /// Whether the byte is kept.
    fn accept(&mut self, byte: u8) -> Result<bool> {
        if let Some((first, rest)) = self.mark.split_first() {
            self.mark = if byte == *first { rest } else { &[] };
            if byte == *first {
                return Ok(true);
            }
        }
        let is_break = byte == b'\n' || byte == b'\r';
        let before = self.state;
        if is_break && before == State::Quoted {
            return self.fail("a quote opens here that is not closed in this line; fields have no line breaks");
        }
        self.state = match (before, byte) {
            (_, b'\n' | b'\r') => State::Line,
            (State::Comment, _) => State::Comment,
            (State::Line, b'#') if self.is_before => State::Comment,
            (State::Line | State::Field, b'"') | (State::Quote, b'"') => State::Quoted,
            (State::Quoted, b'"') => State::Quote,
            (State::Quoted, _) => State::Quoted,
            (_, byte) if byte == self.separator => State::Field,
            _ => State::Plain,
        };
        let is_kept = before != State::Comment && self.state != State::Comment;
        if is_break {
            self.is_before &= before == State::Line || before == State::Comment;
            self.length = 0;
            self.line += usize::from(byte == b'\n');
        } else {
            self.length += 1;
            if self.length > MAX_LINE {
                return self.fail("the line is longer than 1 MiB");
            }
        }
        Ok(is_kept)
    }
}

impl<R: Read> Read for Lines<R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        loop {
            let read = self.inner.read(buffer)?;
            let mut kept = 0;
            for index in 0..read {
                let byte = buffer[index];
                if self.accept(byte)? {
                    buffer[kept] = byte;
                    kept += 1;
                }
            }
            if read == 0 && self.state == State::Quoted {
                return self.fail("a quote opens here that is not closed");
            }
            if kept > 0 || read == 0 {
                return Ok(kept);
            }
        }
    }
}
