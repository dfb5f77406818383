//! A Monte Carlo study with the nonlinear equations: how likely does a bicycle fall that rides by itself and is pushed?
//!
//! Bicycles are those of the benchmark with riders of different mass, build and place; each starts upright with a random rate
//! of lean, rolls hands free, and has fallen where it leans by 45° or the handlebar has come round by 80°.
//!
//! ```sh
//! cargo run --release -p carvallo-models --example falls 100000
//! ```

use std::error::Error;
use std::time::Instant;

use carvallo::batch::{Arrival, Batch, Blocks, Ensemble, Limit};
use carvallo::{Model, Motion};
use carvallo_models::{WhippleMechanism, WhippleMechanismMotion};

/// Forward speeds at the start, in m/s.
const SPEEDS: [f64; 10] = [2.0, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0, 7.0, 8.0];
/// The standard deviation of the rate of lean at the start, in rad/s.
const PUSH: f64 = 0.3;
/// The standard deviation of mass and place of the rider with the frame, relative to them.
const BUILD: f64 = 0.1;
/// For how long a ride goes on, in s.
const DURATION: f64 = 10.0;

fn main() -> Result<(), Box<dyn Error>> {
    // Few of them, unless so many are asked for.
    let rides = match std::env::args().nth(1) {
        Some(text) => text.parse().map_err(|error| format!("`{text}` is no number of rides: {error}"))?,
        None => 50,
    };
    let each = usize::max(rides / SPEEDS.len(), 1);
    let info = WhippleMechanismMotion::<f64>::INFO;
    let position = |name: &str| info.position(name).ok_or("a position of that name");
    let rate = |name: &str| info.speed_of(position(name)?).ok_or("a speed of that name");
    let (lean, steer) = (position("phi")?, position("delta")?);
    let [lean_rate, wheel_rate] = [rate("phi")?, rate("thetaR")?].map(|speed| info.positions.len() + speed);
    let limits = [Limit::symmetric(lean, 45_f64.to_radians()), Limit::symmetric(steer, 80_f64.to_radians())];
    let ensemble = Ensemble { duration: DURATION, tolerance: 1e-8, limits: &limits };

    let mut random = Random(1);
    let mut designs = Vec::new();
    let mut states = Blocks::for_states::<2, WhippleMechanism>(each * SPEEDS.len());
    for (ride, speed) in SPEEDS.iter().flat_map(|speed| [speed].repeat(each)).enumerate() {
        let benchmark = WhippleMechanism::BENCHMARK;
        let mut about = |value: f64| value * (1.0 + BUILD * random.normal());
        let rider =
            WhippleMechanism { mB: about(benchmark.mB), xB: about(benchmark.xB), zB: about(benchmark.zB), ..benchmark };
        rider.validate()?;
        states.set(ride, lean_rate, PUSH * random.normal());
        states.set(ride, wheel_rate, -speed / rider.rR);
        designs.push(rider);
    }

    let batch = Batch::new();
    let mut outcomes = vec![Ok(Arrival::Reached); designs.len()];
    let begin = Instant::now();
    let parameters = Blocks::of_designs(&designs);
    batch.parallel_simulate::<2, WhippleMechanism>(&ensemble, &parameters, &mut states, &mut outcomes)?;
    let took = begin.elapsed().as_secs_f64();

    println!("{} rides of up to {DURATION} s, pushed to {PUSH} rad/s of lean (standard deviation)", designs.len());
    println!("speed      fallen in {DURATION} s     half of these in  last lean of those that ride on");
    for (number, (speed, outcomes)) in SPEEDS.iter().zip(outcomes.chunks(each)).enumerate() {
        let mut times = Vec::new();
        let mut squares = Vec::new();
        for (ride, outcome) in outcomes.iter().enumerate() {
            match (*outcome)? {
                Arrival::Left { time, .. } | Arrival::Stopped { time } => times.push(time),
                Arrival::Reached => squares.push(states.get(number * each + ride, lean).powi(2)),
            }
        }
        times.sort_by(f64::total_cmp);
        let count = each as f64;
        let share = times.len() as f64 / count;
        // The standard deviation of a share of so many.
        let deviation = (share * (1.0 - share) / count).sqrt();
        let half = times.get(times.len() / 2).map_or("          ".to_owned(), |time| format!("{time:8.3} s"));
        let lean = (squares.iter().sum::<f64>() / usize::max(squares.len(), 1) as f64).sqrt().to_degrees();
        let lean = if squares.is_empty() { String::new() } else { format!("{lean:8.3} °") };
        println!("{speed:4.1} m/s   {:6.2} % ± {:5.2} %   {half}        {lean}", 100.0 * share, 100.0 * deviation);
    }
    eprintln!("it took {took:.2} s with {batch}");
    Ok(())
}

/// Numbers that are the same in every run: SplitMix64.
struct Random(u64);

impl Random {
    /// Between 0 and 1, without these.
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((bits ^ (bits >> 31)) >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
    }

    /// Of mean 0 and standard deviation 1, by the method of Box and Muller.
    fn normal(&mut self) -> f64 {
        let angle = std::f64::consts::TAU * self.uniform();
        (-2.0 * self.uniform().ln()).sqrt() * angle.cos()
    }
}
