//! What a sweep is known by when it goes on.

use std::fmt::Write as _;
use std::hash::Hasher as _;
use std::io::Read as _;

use carvallo_design::feedback::Gain;
use carvallo_design::{Design, Failure};
use twox_hash::XxHash64;

use crate::generate::Distribution;
use crate::source::Source;
use crate::table::{Format, Heading};

/// A number that differs for sweeps with different results: it is made from everything that they depend on, values by
/// their bits, and from the contents of a file of designs.
///
/// # Errors
/// If the file cannot be read.
pub fn fingerprint(design: &Design, source: &Source, headings: &[Heading], format: Format) -> Result<u64, Failure> {
    let mut hasher = XxHash64::with_seed(0);
    let mut text = format!("{} {} {format:?}\n", env!("CARGO_PKG_VERSION"), design.info().name);
    // Writing to a string cannot fail.
    let mut line = |name: &str, values: &[f64]| {
        let bits: Vec<u64> = values.iter().map(|value| value.to_bits()).collect();
        let _ = writeln!(text, "{name} {bits:x?}");
    };
    line("base", &design.values());
    for Gain { matrix, input, column, value } in design.feedback.iter().flat_map(|law| &law.gains) {
        line(&format!("gain {matrix} {input:?} {column}"), &[*value]);
    }
    match source {
        Source::Generated(generator) => {
            for axis in &generator.vary {
                line(&format!("vary {}", axis.parameter.stream(design.info())), &axis.values);
            }
            for random in &generator.random {
                let (name, values) = match random.distribution {
                    Distribution::Uniform { low, high } => ("uniform", [low, high]),
                    Distribution::Normal { mean, deviation } => ("normal", [mean, deviation]),
                };
                line(&format!("{name} {}", random.parameter.stream(design.info())), &values);
            }
            if let Some(together) = &generator.together {
                for ((position, mean), parts) in together.positions.iter().zip(&together.means).zip(&together.parts) {
                    line(&format!("measured {position}"), &[&[*mean], &parts[..]].concat());
                }
            }
            line(&format!("samples {} seed {}", generator.samples, generator.seed), &[]);
        }
        Source::File(file) => {
            let fail = |error| Failure::Run(format!("cannot read {}: {error}", file.path.display()));
            let mut reader = std::fs::File::open(&file.path).map_err(fail)?;
            let mut buffer = vec![0; 1 << 16];
            loop {
                match reader.read(&mut buffer).map_err(fail)? {
                    0 => break,
                    length => hasher.write(&buffer[..length]),
                }
            }
        }
    }
    for heading in headings {
        line(&heading.name, &[]);
    }
    hasher.write(text.as_bytes());
    Ok(hasher.finish())
}
