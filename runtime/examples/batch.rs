//! Ten thousand bicycles, in the lanes of the processor: where may the front mass of a self-stable one be?
//!
//! ```sh
//! cargo run -p carvallo --features derive --example batch
//! ```

use carvallo::Model;
use carvallo::batch::{Batch, Blocks};

mod skate;
use skate::Skate;

/// Forward speed in m/s.
const SPEED: f64 = 5.0;
/// Columns and rows of designs.
const COLUMNS: u32 = 125;
const ROWS: u32 = 80;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // The front mass from 0.8 m to 1.4 m forward of the rear contact, and from 0.45 m to 0.05 m above the ground.
    let place = |i: u32| Skate {
        xH: 0.8 + 0.6 * f64::from(i % COLUMNS) / f64::from(COLUMNS - 1),
        zH: -0.45 + 0.4 * f64::from(i / COLUMNS) / f64::from(ROWS - 1),
        ..Skate::PUBLISHED
    };
    let designs: Vec<Skate> = (0..COLUMNS * ROWS).map(place).collect();
    designs.iter().try_for_each(Skate::validate)?;

    let batch = Batch::new();
    println!("{} designs with {batch}", designs.len());

    // The matrices of all of them, as columns of entries; `coefficients` has the same, as matrices.
    let mut entries = Blocks::for_entries::<_, Skate>(designs.len());
    batch.matrices::<_, Skate>(&Blocks::of_designs(&designs), &mut entries)?;
    for (position, entry) in Skate::INFO.entries.iter().enumerate() {
        let (low, high) = entries
            .column(position)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        println!("    {entry} from {low:.4} to {high:.4}");
    }

    // Their eigenvalues in 1/s at one speed, sorted by real part.
    let systems: Vec<_> =
        designs.iter().map(|design| design.coefficients().at(SPEED, design.g)).collect::<Result<_, _>>()?;
    let mut eigenvalues = vec![Ok(Default::default()); systems.len()];
    batch.eigenvalues(&systems, &mut eigenvalues)?;
    let largest: Vec<f64> =
        eigenvalues.into_iter().map(|four| four.map(|four| four[3].re)).collect::<Result<_, _>>()?;

    println!("self-stable (#) at {SPEED} m/s, by the place of the front mass:");
    for row in (0..ROWS).step_by(8) {
        let design = |column: u32| (row * COLUMNS + column) as usize;
        let line: String =
            (0..COLUMNS).step_by(2).map(|column| if largest[design(column)] < 0.0 { '#' } else { '.' }).collect();
        println!("    {line} {:.2} m high", -designs[design(0)].zH);
    }
    let (best, growth) =
        (0..designs.len()).map(|i| (i, largest[i])).min_by(|a, b| a.1.total_cmp(&b.1)).expect("designs");
    let Skate { xH, zH, .. } = designs[best];
    println!("the most stable one has it {xH:.3} m forward and {:.3} m high,", -zH);
    println!("and its slowest motion decays to a half in {:.2} s", 2_f64.ln() / -growth);
    Ok(())
}
