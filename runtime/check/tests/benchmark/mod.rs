//! State matrices of the benchmark bicycle with mistakes: the numbers come from the matrices that are printed in Meijaard,
//! Papadopoulos, Ruina & Schwab (2007), section 5, by A = [0, 1; -M^-1 K, -M^-1 C] written out here.

#![allow(dead_code, reason = "each test file uses some of it")]

use carvallo_check::{Report, check, read};
use carvallo_design::input::Request;

pub type Matrix = [[f64; 2]; 2];

pub const SPEED: f64 = 5.0;
pub const M: Matrix = [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]];
pub const C1: Matrix = [[0.0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]];
pub const K0: Matrix = [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]];
pub const K2: Matrix = [[0.0, 76.59734589573222], [0.0, 2.65431523794604]];

pub fn checked(text: &str) -> Report {
    checked_with(text, &[])
}

pub fn checked_with(text: &str, feedback: &[&str]) -> Report {
    let file = read::read("mine.toml", text.into()).expect("a file that can be read");
    let feedback = feedback.iter().map(|law| ("--feedback".to_owned(), (*law).to_owned())).collect();
    let design = file.design(&Request { feedback, ..Request::default() }).expect("a design");
    check(&file.given(&design).expect("numbers"), &design).expect("a report")
}

/// A with ten digits, of M, C and K at the speed with mistakes.
pub fn state_matrix(mistake: impl Fn(&mut Matrix, &mut Matrix, &mut Matrix)) -> String {
    format!("speed = {SPEED}\nA = {}", written(numbers(SPEED, mistake), &|entry| format!("{entry:.9e}")))
}

/// A list of rows.
pub fn written(rows: [[f64; 4]; 4], digits: &dyn Fn(f64) -> String) -> String {
    let row = |row: [f64; 4]| format!("[{}]", row.map(digits).join(", "));
    format!("[{}]", rows.map(row).join(", "))
}

/// A of M, C and K at a speed with mistakes.
pub fn numbers(speed: f64, mistake: impl Fn(&mut Matrix, &mut Matrix, &mut Matrix)) -> [[f64; 4]; 4] {
    let (mut m, mut c) = (M, C1.map(|row| row.map(|entry| speed * entry)));
    let mut k = [0, 1].map(|row| [0, 1].map(|column| 9.81 * K0[row][column] + speed * speed * K2[row][column]));
    mistake(&mut m, &mut c, &mut k);
    let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    let inverse = [[m[1][1] / determinant, -m[0][1] / determinant], [-m[1][0] / determinant, m[0][0] / determinant]];
    let lower = |with: &Matrix, row: usize, column: usize| {
        -(inverse[row][0] * with[0][column] + inverse[row][1] * with[1][column])
    };
    let row = |at: usize| [lower(&k, at, 0), lower(&k, at, 1), lower(&c, at, 0), lower(&c, at, 1)];
    [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], row(0), row(1)]
}

/// The causes of all explanations.
pub fn causes(report: &Report) -> Vec<String> {
    let all = report.explanations.iter().flat_map(|group| &group.explanations);
    all.map(|own| own.causes.join(", and ")).collect()
}
