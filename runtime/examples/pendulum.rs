//! An inverted pendulum on a torsion spring: how stiff must the spring be, and how does the pendulum then move?
//!
//! ```sh
//! cargo run -p carvallo --features derive --example pendulum
//! ```

use carvallo::Model;

carvallo::model! {
    /// A mass on a rod that stands on a torsion spring with a damper.
    pub model Pendulum {
        parameters {
            /// Mass.
            m: kg, > 0;
            /// Length of the rod.
            l: m, > 0;
            /// Stiffness of the spring.
            k: N*m/rad, >= 0;
            /// Damping.
            d: N*m*s/rad, >= 0;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }
        coordinates { theta "lean": rad; }
        M = [[m*l^2]];
        C0 = [[d]];
        Kc = [[k]];
        K0 = [[-m*l]];
        set metronome { m = 50 g; l = 8 cm; k = 0.1; d = 2e-4; g = 9.81; }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("{}", Pendulum::INFO.docs);
    for k in [0.03, 0.05, 0.1, 0.2] {
        let pendulum = Pendulum { k, ..Pendulum::METRONOME };
        pendulum.validate()?;
        // Two eigenvalues in 1/s, the one with the larger real part last.
        let eigenvalues = pendulum.coefficients().at(0.0, pendulum.g)?.eigenvalues()?;
        let last = eigenvalues[1];
        print!("k = {k:4} N m/rad: ");
        if last.re > 0.0 {
            println!("falls over, {:.2} times as far after each second", last.re.exp());
        } else {
            let (frequency, ratio) = (last.im / std::f64::consts::TAU, -last.re / last.norm());
            println!("swings at {frequency:.2} Hz with the damping ratio {ratio:.3}");
        }
    }
    // What cannot be is refused, with its name and value.
    if let Err(error) = (Pendulum { l: -0.08, ..Pendulum::METRONOME }).validate() {
        println!("{error}");
    }
    Ok(())
}
