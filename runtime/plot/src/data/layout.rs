//! The layout of JSON: members have lines of their own, and what belongs together stands on one.
//!
//! Numbers are written with the fewest digits that read back to the same double, with an exponent only where there would
//! be many zeros.

use std::io::{Result, Write};

use carvallo::Complex;
use serde::ser::{Error as _, Serialize, Serializer};
use serde_json::ser::Formatter;
use serde_json::value::RawValue;

/// Writes a document and ends its last line.
///
/// # Errors
/// If it cannot be written.
pub fn write_document(document: &impl Serialize, output: &mut dyn Write) -> Result<()> {
    serde_json::to_writer_pretty(&mut *output, document)?;
    output.write_all(b"\n")
}

/// A complex number.
#[derive(serde::Serialize)]
pub struct Parts {
    re: f64,
    im: f64,
}

impl From<Complex<f64>> for Parts {
    fn from(Complex { re, im }: Complex<f64>) -> Self {
        Self { re, im }
    }
}

/// An object whose members are known only when the program runs, in their order.
pub struct Members<T, Name = &'static str>(pub Vec<(Name, T)>);

impl<T: Serialize, Name: Serialize> Serialize for Members<T, Name> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// A value on one line.
pub struct Line<T>(pub T);

impl<T: Serialize> Serialize for Line<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let mut text = Vec::new();
        let mut line = serde_json::Serializer::with_formatter(&mut text, OneLine);
        self.0.serialize(&mut line).map_err(S::Error::custom)?;
        let text = String::from_utf8(text).map_err(S::Error::custom)?;
        RawValue::from_string(text).map_err(S::Error::custom)?.serialize(serializer)
    }
}

/// With a space after each comma and colon.
struct OneLine;

impl Formatter for OneLine {
    fn write_f64<W: ?Sized + Write>(&mut self, output: &mut W, value: f64) -> Result<()> {
        write!(output, "{value:?}")
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, output: &mut W, is_first: bool) -> Result<()> {
        separate(output, is_first)
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, output: &mut W, is_first: bool) -> Result<()> {
        separate(output, is_first)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, output: &mut W) -> Result<()> {
        output.write_all(b": ")
    }
}

fn separate<W: ?Sized + Write>(output: &mut W, is_first: bool) -> Result<()> {
    if is_first { Ok(()) } else { output.write_all(b", ") }
}
