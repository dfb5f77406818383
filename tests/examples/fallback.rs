//! How often the fast path is left.
use carvallo::{Model, Stability};
use carvallo_tests::{bicycles, designs};
use std::hint::black_box;
use std::time::Instant;
fn main() {
    let mut worst: f64 = 0.0;
    let mut worst_err = (f64::MAX, 0.0f64);
    let mut eig: f64 = 0.0;
    let mut compare = |name: &str, c: &carvallo::Coefficients<f64, 2>, g: f64| -> bool {
        let Some(fast) = Stability::fast(c, g) else { return false };
        let careful = Stability::careful(c, g).unwrap();
        let mut bad = fast.critical_speeds.len() != careful.critical_speeds.len()
            || fast.stable_ranges.len() != careful.stable_ranges.len();
        for (f, c) in fast.critical_speeds.iter().zip(&careful.critical_speeds) {
            bad |= f.kind != c.kind || f.change != c.change;
            worst = worst.max((f.speed - c.speed).abs() / c.speed);
            let r = f.error / c.error;
            worst_err = (worst_err.0.min(r), worst_err.1.max(r));
            eig = eig.max((f.eigenvalue - c.eigenvalue).norm() / c.eigenvalue.norm().max(1e-300));
            bad |= (f.speed - c.speed).abs() > c.error;
        }
        let mut ends = vec![0.0];
        ends.extend(careful.critical_speeds.iter().map(|c| c.speed));
        ends.push(ends[ends.len() - 1] * 2.0 + 1.0);
        for w in ends.windows(2) {
            let m = 0.5 * (w[0] + w[1]);
            bad |= fast.verdict(m) != careful.verdict(m);
        }
        for (&e, f) in ends[1..].iter().zip(&fast.critical_speeds) {
            bad |= fast.verdict(f.speed) != careful.verdict(e);
        }
        bad |= fast.verdict(0.0) != careful.verdict(0.0);
        if bad {
            println!("{name}: {fast:#?}\n{careful:#?}");
            std::process::exit(1)
        }
        true
    };
    for (name, b) in bicycles::all() {
        let t = compare(name, &b.coefficients(), b.g);
        let c = b.coefficients();
        let now = Instant::now();
        for _ in 0..20000 {
            let _ = black_box(Stability::new(black_box(&c), b.g));
        }
        println!("{name}: {t} {:.3} us", now.elapsed().as_secs_f64() / 20000.0 * 1e6);
    }
    let n = 20000;
    let all: Vec<_> = (0..n)
        .map(|i| {
            let d = designs::numbered(i);
            (d.coefficients(), d.g)
        })
        .collect();
    let mut fell = 0;
    for (i, (c, g)) in all.iter().enumerate() {
        if !compare(&format!("{i}"), c, *g) {
            fell += 1;
        }
    }
    println!("fallback {fell} of {n}; worst {worst:e}, error ratio {worst_err:?} eigenvalue {eig:e}");
    for _ in 0..3 {
        let now = Instant::now();
        for (c, g) in &all {
            let _ = black_box(Stability::new(black_box(c), *g));
        }
        println!("random {:.3} us", now.elapsed().as_secs_f64() / n as f64 * 1e6);
    }
}
