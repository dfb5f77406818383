//! What each parameter of a bicycle does to the speed from which it balances itself.
//!
//! ```sh
//! cargo run -p carvallo --features derive --example sensitivity
//! ```

use carvallo::{CriticalDerivative, Model, Sensitivity, Stability, standard_deviation};

mod skate;
use skate::Skate;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let skate = Skate::PUBLISHED;
    let stability = Stability::new(&skate.coefficients(), skate.g)?;
    for range in &stability.stable_ranges {
        match range.to {
            Some(to) => println!("stable from {:.4} m/s to {to:.4} m/s", range.from),
            None => println!("stable from {:.4} m/s on", range.from),
        }
    }

    // Exact derivatives, since the declaration says `derivatives;`: nothing is differenced.
    let sensitivity = Sensitivity::of(&skate)?;
    for critical in
        stability.critical_speeds.iter().filter(|critical| critical.speed == stability.stable_ranges[0].from)
    {
        println!("{} at {:.4} m/s changes", critical.kind, critical.speed);
        match sensitivity.critical_speed(critical)? {
            CriticalDerivative::Smooth { speed, .. } => {
                for (parameter, (by, value)) in
                    Skate::<f64>::INFO.parameters.iter().zip(speed.iter().zip(skate.to_array()))
                {
                    let unit = parameter.unit;
                    println!("    by {by:+9.4} m/s for each {unit:4} of {:3} = {value:.4} {unit}", parameter.name);
                }
                // Places known to 1 mm, masses to 100 g, the angle to a tenth of a degree.
                let deviations =
                    Skate::<f64>::INFO.parameters.iter().map(|parameter| match (parameter.name, parameter.unit) {
                        ("g", _) => 0.0,
                        (_, "m") => 0.001,
                        (_, "kg") => 0.1,
                        _ => 0.1_f64.to_radians(),
                    });
                let deviation = standard_deviation(&speed, &deviations.collect::<Vec<_>>())?;
                println!("so that it is {:.2} +- {deviation:.2} m/s", critical.speed);
            }
            CriticalDerivative::None(reason) => println!("    without derivatives: {reason}"),
        }
    }
    Ok(())
}
