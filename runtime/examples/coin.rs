//! A coin that rolls, declared as what it is: a wheel. How fast must it be to stay up?
//!
//! ```sh
//! cargo run -p carvallo --features derive --example coin
//! ```

use carvallo::{Model, Stability};

carvallo::model! {
    /// A uniform disc on level ground, which rolls without slip.
    pub model Coin {
        parameters {
            /// Radius.
            r: m, > 0;
            /// Mass.
            m: kg, > 0;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }
        mechanism {
            wheel D: mass m, at (0, 0, -r), radius r, axial m*r^2/2, radial m*r^2/4;
            free D: lean phi, yaw psi;
        }
        coordinates { phi "lean": rad; psi "yaw": rad; }
        set euro { r = 11.625 mm; m = 7.5 g; g = 9.81; }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let coin = Coin::EURO;
    let stability = Stability::new(&coin.coefficients(), coin.g)?;
    for critical in &stability.critical_speeds {
        println!("{} at {:.4} m/s: {}", critical.kind, critical.speed, critical.change);
    }
    println!("a textbook says sqrt(g r/3) = {:.4} m/s", (coin.g * coin.r / 3.0).sqrt());
    for speed in [0.1, 0.3] {
        println!("at {speed} m/s it is {}", stability.verdict(speed)?);
        for eigenvalue in coin.coefficients().at(speed, coin.g)?.eigenvalues()? {
            println!("    {eigenvalue:+.3} 1/s");
        }
    }
    // What follows from lean and yaw: the wheel turns about its axle, forward, and moves to where it points.
    let kinematics = coin.kinematics();
    let (lean, yaw) = (0.0, 0.01);
    println!("at 0.3 m/s it turns at {:.1} rad/s,", kinematics.wheel_D.at(0.3, &[lean, yaw], &[0.0; 2], 0.0));
    println!("and with a yaw of {yaw} rad goes {} m/s to the right", {
        kinematics.lateral.at(0.3, &[lean, yaw], &[0.0; 2], 0.0)
    });
    Ok(())
}
