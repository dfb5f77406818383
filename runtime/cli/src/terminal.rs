//! What the program says: data on the standard output, and everything about it on the standard error.

use std::io::{ErrorKind, Write as _};

use anstyle::{AnsiColor, Style};

use crate::failure::Failure;

pub const ERROR: Style = AnsiColor::Red.on_default().bold();
pub const WARNING: Style = AnsiColor::Yellow.on_default().bold();

/// Prints to the standard output; a reader that has seen enough is no failure.
///
/// # Errors
/// If it cannot be written.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut output = anstream::stdout().lock();
    match output.write_all(text.as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::Run(format!("cannot write the output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Prints a line to the standard error. Where even that is closed, nothing more can be told.
pub fn note(style: Style, what: &str, text: &str) {
    let _ = writeln!(anstream::stderr(), "{style}{what}{style:#}: {text}");
}
