//! What each parameter of a bicycle does to the speed from which it balances itself, and how well that speed is known.
//!
//! ```sh
//! cargo run -p carvallo --features derive --example sensitivity
//! ```

use carvallo::{Change, CriticalDerivative, Model, Sensitivity, Stability, standard_deviation, variance_shares};

mod skate;
use skate::Skate;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let skate = Skate::PUBLISHED;
    let stability = Stability::new(&skate.coefficients(), skate.g)?;
    let Some(critical) = stability.critical_speeds.iter().find(|critical| critical.change == Change::Stabilizes) else {
        println!("there is no speed from which it is stable");
        return Ok(());
    };
    println!("{}: from {:.4} m/s on it is {}", critical.kind, critical.speed, stability.verdict(critical.speed + 1.0)?);

    // Exact derivatives, since the declaration says `derivatives;`: nothing is differenced.
    let by_parameter = match Sensitivity::of(&skate)?.critical_speed(critical)? {
        CriticalDerivative::Smooth { speed, .. } => speed,
        CriticalDerivative::None(reason) => {
            println!("it has no derivatives, because {reason}");
            return Ok(());
        }
    };

    // Places measured to 1 mm, masses to 100 g, the angle to a tenth of a degree.
    let parameters = Skate::INFO.parameters;
    let deviation = |unit: &str| match unit {
        "m" => 0.001,
        "kg" => 0.1,
        "rad" => 0.1_f64.to_radians(),
        _ => 0.0,
    };
    let deviations: Vec<f64> = parameters.iter().map(|parameter| deviation(parameter.unit)).collect();
    let shares = variance_shares(&by_parameter, &deviations)?;

    println!("parameter         changes it by          and makes of its variance");
    for (position, parameter) in parameters.iter().enumerate() {
        let (value, by, share) = (skate.to_array()[position], by_parameter[position], 100.0 * shares[position]);
        let unit = parameter.unit;
        println!("{:3} = {value:7.4} {unit:4} {by:+9.4} m/s for each {unit:4} {share:5.1} %", parameter.name);
    }
    let total = standard_deviation(&by_parameter, &deviations)?;
    println!("so that it is known to be {:.2} +- {total:.2} m/s", critical.speed);
    Ok(())
}
