//! A sweep along speed of one's own, for a machine with three coordinates: a bicycle whose rider leans on a sprung hip.
//!
//! ```sh
//! cargo run -p carvallo --features derive --example speeds
//! ```

use carvallo::{Complex, Model, SystemError, Verdict};

carvallo::model! {
    /// Two point masses on wheels without mass, and a rider on a hip with a spring and a damper.
    pub model Ridden {
        parameters {
            /// Wheel base.
            w: m, > 0;
            /// Tilt of the steer axis.
            lam: rad, in (-90 deg, 90 deg);
            /// Places and masses of the rear and the front frame.
            xB: m; zB: m; mB: kg, > 0;
            xH: m; zH: m; mH: kg, > 0;
            /// Place and mass of the rider, and the height of the hip, downward like all places.
            xU: m; zU: m; mU: kg, > 0; zP: m;
            /// Stiffness and damping of the hip.
            k: N*m/rad, >= 0;
            d: N*m*s/rad, >= 0;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }
        mechanism {
            body B "rear frame": mass mB, at (xB, 0, zB), inertia 0;
            body H "front frame": mass mH, at (xH, 0, zH), inertia 0;
            body U "rider": mass mU, at (xU, 0, zU), inertia 0;
            wheel R on B: mass 0, at (0, 0, -0.1 [m]), radius 0.1 [m], axial 0, radial 0;
            wheel F on H: mass 0, at (w, 0, -0.1 [m]), radius 0.1 [m], axial 0, radial 0;
            free B: lean phi;
            revolute delta: B to H, through (w, 0, 0), along (sin(lam), 0, cos(lam));
            revolute theta: B to U, through (0, 0, zP), along (1, 0, 0), spring k, damper d;
        }
        coordinates { phi "lean": rad; delta "steer": rad; theta "rider": rad; }
        set light {
            w = 1; lam = 5 deg;
            xB = 1.2; zB = -0.4; mB = 10; xH = 1.02; zH = -0.2; mH = 1;
            xU = 1.2; zU = -0.6; mU = 1; zP = -0.4; k = 20; d = 0.2; g = 9.81;
        }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let ridden = Ridden::LIGHT;
    ridden.validate()?;
    // The matrices do not depend on the speed: compute them once.
    let coefficients = ridden.coefficients();
    // Six eigenvalues in 1/s, sorted by real part.
    let at = |speed: f64| -> Result<Vec<Complex<f64>>, SystemError> { coefficients.at(speed, ridden.g)?.eigenvalues() };
    // `Verdict` takes nearly nothing for zero; what is searched for is the zero itself.
    let decays = |eigenvalues: &[Complex<f64>]| eigenvalues.iter().all(|eigenvalue| eigenvalue.re < 0.0);

    println!("speed    largest real part    its frequency");
    let mut last: Option<(f64, bool)> = None;
    for speed in (0..=20).map(|i| 0.5 * f64::from(i)) {
        let eigenvalues = at(speed)?;
        let stable = decays(&eigenvalues);
        if let Some((below, was)) = last
            && was != stable
        {
            // Halve the range until its ends are neighbouring numbers.
            let (mut low, mut high) = (below, speed);
            while low < low.midpoint(high) && low.midpoint(high) < high {
                let middle = low.midpoint(high);
                if decays(&at(middle)?) == was { low = middle } else { high = middle }
            }
            println!("stable {} {high:.12} m/s", if stable { "from" } else { "up to" });
        }
        let rightmost = eigenvalues[eigenvalues.len() - 1];
        let hertz = rightmost.im.abs() / std::f64::consts::TAU;
        println!("{speed:4.1} m/s {:+14.4} 1/s {hertz:13.4} Hz  {}", rightmost.re, Verdict::of(&eigenvalues));
        last = Some((speed, stable));
    }
    Ok(())
}
