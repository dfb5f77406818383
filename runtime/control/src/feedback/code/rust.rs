//! Scheduled gains in Rust.

use super::{Text, rows, speed};

const HEAD: &str = "\
//!
//! The inputs are `-K x` for the state x; all are small deviations from the steady motion, in SI units. Written by Carvallo; it
//! needs neither the standard library nor memory.

/// The numbers of the controller; `f32` will do as well.
pub type Real = f64;

/// How many inputs there are.
pub const INPUTS: usize = @inputs;

/// How many states there are.
pub const STATES: usize = @states;
";

const ONE: &str = "
/// The gains K: a row for each input, and a column for each state.
pub const GAINS: [[Real; STATES]; INPUTS] = @gains;

/// The inputs for a state.
pub fn inputs(states: &[Real; STATES]) -> [Real; INPUTS] {
    apply(&GAINS, states)
}
";

const SCHEDULED: &str = "
/// How many speeds there are gains for.
pub const COUNT: usize = @count;

/// The speeds that there are gains for, in m/s, ascending.
pub const SPEEDS: [Real; COUNT] = [@speeds];

/// The gains K at each of the speeds: a row for each input, and a column for each state.
pub const GAINS: [[[Real; STATES]; INPUTS]; COUNT] = [
@gains];

/// The gains at a forward speed in m/s: between those of the table linearly, and beyond its ends those there.
pub fn gains(speed: Real) -> [[Real; STATES]; INPUTS] {
    let mut gains = GAINS[0];
    for index in 1..COUNT {
        let (low, high) = (SPEEDS[index - 1], SPEEDS[index]);
        if speed > low {
            gains = GAINS[index];
            if speed < high {
                let part = (speed - low) / (high - low);
                for (row, before) in gains.iter_mut().zip(&GAINS[index - 1]) {
                    for (gain, before) in row.iter_mut().zip(before) {
                        *gain = before + part * (*gain - before);
                    }
                }
            }
        }
    }
    gains
}

/// The inputs at a forward speed in m/s, for a state.
pub fn inputs(speed: Real, states: &[Real; STATES]) -> [Real; INPUTS] {
    apply(&gains(speed), states)
}
";

const TAIL: &str = "
fn apply(gains: &[[Real; STATES]; INPUTS], states: &[Real; STATES]) -> [Real; INPUTS] {
    let mut inputs = [0.0; INPUTS];
    for (input, row) in inputs.iter_mut().zip(gains) {
        for (gain, state) in row.iter().zip(states) {
            *input -= gain * state;
        }
    }
    inputs
}
";

pub fn write(text: &Text) -> String {
    let [inputs, states, count] = text.counts();
    let about: String = text.about.iter().map(|line| format!("//! {line}").trim_end().to_owned() + "\n").collect();
    let head = HEAD.replace("@inputs", &inputs.to_string()).replace("@states", &states.to_string());
    let regulators = &text.schedule.regulators;
    let own = if count == 1 {
        ONE.replace("@gains", &rows(text.first(), ['[', ']']))
    } else {
        let speeds: Vec<String> =
            regulators.iter().filter_map(|own| own.space.speed).map(|speed| format!("{speed:?}")).collect();
        let gains = regulators.iter().map(|own| format!("    {}, // {}\n", rows(own, ['[', ']']), speed(own)));
        SCHEDULED
            .replace("@count", &count.to_string())
            .replace("@speeds", &speeds.join(", "))
            .replace("@gains", &gains.collect::<String>())
    };
    [about.as_str(), &head, &own, TAIL].concat()
}
