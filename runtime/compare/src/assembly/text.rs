//! Listings beside each other.

use std::collections::BTreeSet;
use std::fmt;

use super::{Assembly, Listing};

/// The width of a column of instructions.
const WIDTH: usize = 44;
/// The width of a column of counts, and of what is counted.
const COUNTS: usize = 14;

impl fmt::Display for Assembly {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.optimized {
            writeln!(f, "(without optimization: code means something with --release)\n")?;
        }
        for scalar in ["f64", "f32"] {
            let listings: Vec<&Listing> = self.listings.iter().filter(|listing| listing.scalar == scalar).collect();
            if !listings.is_empty() {
                writeln!(f, "{scalar}, instructions in the code, each once")?;
                counts(f, &listings)?;
                writeln!(f)?;
                side_by_side(f, &listings)?;
                writeln!(f)?;
            }
        }
        Ok(())
    }
}

/// How many instructions there are, those first that are most.
fn counts(f: &mut fmt::Formatter<'_>, listings: &[&Listing]) -> fmt::Result {
    let mut row = |name: &str, cells: Vec<String>| {
        write!(f, "  {name:COUNTS$}")?;
        cells.iter().try_for_each(|cell| write!(f, " {cell:>COUNTS$}"))?;
        writeln!(f)
    };
    row("", listings.iter().map(|listing| listing.name.clone()).collect())?;
    row("all", listings.iter().map(|listing| listing.instructions.len().to_string()).collect())?;
    let counts: Vec<_> = listings.iter().map(|listing| listing.mnemonics()).collect();
    let mnemonics: BTreeSet<&str> = counts.iter().flat_map(|counts| counts.keys().copied()).collect();
    let of =
        |mnemonic: &str| counts.iter().map(|counts| counts.get(mnemonic).copied().unwrap_or(0)).collect::<Vec<_>>();
    let mut rows: Vec<(&str, Vec<usize>)> = mnemonics.into_iter().map(|mnemonic| (mnemonic, of(mnemonic))).collect();
    rows.sort_by_key(|(_, counts)| std::cmp::Reverse(counts.iter().copied().max()));
    rows.into_iter().try_for_each(|(name, counts)| row(name, counts.iter().map(usize::to_string).collect()))
}

fn side_by_side(f: &mut fmt::Formatter<'_>, listings: &[&Listing]) -> fmt::Result {
    let longest = listings.iter().map(|listing| listing.instructions.len()).max().unwrap_or(0);
    let mut line = |cells: Vec<&str>| {
        let cells: Vec<String> = cells.iter().map(|cell| format!("{:WIDTH$}", shortened(cell))).collect();
        writeln!(f, "  {}", cells.join(" | ").trim_end())
    };
    line(listings.iter().map(|listing| listing.name.as_str()).collect())?;
    (0..longest).try_for_each(|index| {
        line(listings.iter().map(|listing| listing.instructions.get(index).map_or("", String::as_str)).collect())
    })
}

/// As much as fits into a column.
fn shortened(text: &str) -> String {
    if text.chars().count() <= WIDTH { text.into() } else { text.chars().take(WIDTH - 1).chain(['…']).collect() }
}
