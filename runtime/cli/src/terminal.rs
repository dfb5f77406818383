//! What the program says: data on the standard output, and everything about it on the standard error.

use std::fs::File;
use std::io::{BufWriter, ErrorKind, Write};
use std::path::Path;

use anstyle::{AnsiColor, Style};
use carvallo_design::Failure;

pub const ERROR: Style = AnsiColor::Red.on_default().bold();
pub const WARNING: Style = AnsiColor::Yellow.on_default().bold();

/// Prints text for people to the standard output, without its styles where that is no terminal.
///
/// # Errors
/// If it cannot be written.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut output = anstream::stdout().lock();
    written(output.write_all(text.as_bytes()).and_then(|()| output.flush()))
}

/// Writes data to the standard output, as they are.
///
/// # Errors
/// If they cannot be written.
pub fn write(data: impl FnOnce(&mut dyn Write) -> std::io::Result<()>) -> Result<(), Failure> {
    let mut output = BufWriter::new(std::io::stdout().lock());
    written(data(&mut output).and_then(|()| output.flush()))
}

/// Writes data or text to a file, and tells so, or else to the standard output: with its styles only where that is a
/// terminal.
///
/// # Errors
/// If it cannot be written.
pub fn deliver(path: Option<&Path>, data: impl FnOnce(&mut dyn Write) -> std::io::Result<()>) -> Result<(), Failure> {
    let Some(path) = path else {
        let mut output = BufWriter::new(anstream::stdout().lock());
        return written(data(&mut output).and_then(|()| output.flush()));
    };
    let fail = |error: std::io::Error| Failure::Run(format!("cannot write {}: {error}", path.display()));
    let mut file = BufWriter::new(anstream::StripStream::new(File::create(path).map_err(fail)?));
    data(&mut file).and_then(|()| file.flush()).map_err(fail)?;
    wrote(path);
    Ok(())
}

/// Writes bytes to a file, as they are, and tells so.
///
/// # Errors
/// If it cannot be written.
pub fn save(path: &Path, data: impl FnOnce(&mut dyn Write) -> std::io::Result<()>) -> Result<(), Failure> {
    let fail = |error: std::io::Error| Failure::Run(format!("cannot write {}: {error}", path.display()));
    let mut file = BufWriter::new(File::create(path).map_err(fail)?);
    data(&mut file).and_then(|()| file.flush()).map_err(fail)?;
    wrote(path);
    Ok(())
}

/// A reader that has seen enough is no failure.
fn written(result: std::io::Result<()>) -> Result<(), Failure> {
    match result {
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

/// Tells that a file was written.
pub fn wrote(path: &Path) {
    note(Style::new(), "wrote", &path.display().to_string());
}
