//! Motions in time, and steady ones.

mod bicycle;
mod feedback;
mod linear;
mod nonlinear;
mod pendulums;
mod turns;

/// The numbers of a table whose lines before its heading begin with `#`.
fn table(text: &str) -> Vec<Vec<f64>> {
    let lines = text.lines().skip_while(|line| line.starts_with('#')).skip(1);
    lines.map(|line| line.split('\t').map(|cell| cell.parse().expect("a number")).collect()).collect()
}
