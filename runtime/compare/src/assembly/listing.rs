//! The instructions of a function.

use std::collections::BTreeMap;

use serde::Serialize;

/// The code of a side in one number type.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Listing {
    /// The name of the side.
    pub name: String,
    /// The number type.
    pub scalar: &'static str,
    /// The instructions in their order, as `objdump` writes them. Each stands once, however often it runs, and what is
    /// called is not among them.
    pub instructions: Vec<String>,
}

impl Listing {
    /// How often each instruction stands in it, without operands.
    #[must_use]
    pub fn mnemonics(&self) -> BTreeMap<&str, usize> {
        let mut counts = BTreeMap::new();
        for instruction in &self.instructions {
            *counts.entry(mnemonic(instruction)).or_default() += 1;
        }
        counts
    }
}

/// The first word of an instruction.
pub fn mnemonic(instruction: &str) -> &str {
    instruction.split_whitespace().next().unwrap_or_default()
}
