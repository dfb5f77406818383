//! The code of the sides as the processor has it.

mod listing;
mod objdump;
mod text;

use serde::Serialize;

use crate::side::{Code, Side};

pub use listing::Listing;
pub use objdump::AssemblyError;

use objdump::Program;

/// The code of each side in each number type, disassembled. It reads as text side by side, by
/// [`Display`](std::fmt::Display).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Assembly {
    /// One after the other, those in `f64` first.
    pub listings: Vec<Listing>,
    /// Whether the program was compiled with optimization.
    pub optimized: bool,
}

impl Assembly {
    pub(crate) fn of(sides: &[Side]) -> Result<Self, AssemblyError> {
        let program = Program::of_this_process()?;
        let listing = |side: &Side, scalar, code: &Code| {
            let instructions = program.disassemble(code.address)?;
            Ok(Listing { name: side.name.clone(), scalar, instructions })
        };
        let double = sides.iter().map(|side| listing(side, "f64", &side.double));
        let single = sides.iter().filter_map(|side| Some(listing(side, "f32", side.single.as_ref()?)));
        let listings = double.chain(single).collect::<Result<_, _>>()?;
        Ok(Self { listings, optimized: !cfg!(debug_assertions) })
    }

    /// As JSON, indented.
    #[must_use]
    pub fn to_json(&self) -> String {
        // Strings and lists of them can all be written.
        serde_json::to_string_pretty(self).expect("values that JSON has")
    }
}
