//! Prints what it takes to expand declarations of growing size: processor time, peak memory, and by what power both
//! grow. It is not the time on the clock, since an expansion waits for others of the same user.
//!
//! `cargo run -p carvallo-tools --bin expansion [DEFINITIONS ...]`, without `--release`: macros run as they are built
//! for development. Each size runs in a process of its own, since the system keeps the peak of a process (Linux only).

use std::fmt::Write as _;
use std::process::Command;

use carvallo_compiler::program::Counts;
use carvallo_compiler::{Driver, compile, expand};
use quote::quote;

const SIZES: [usize; 4] = [10, 100, 1_000, 5_000];
const PARAMETERS: usize = 10;
/// The word before a number of definitions that has this process expand them.
const MEASURE: &str = "measure";

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |text: &String| text.parse().expect("a number of definitions");
    match &arguments[..] {
        [] => table(&SIZES),
        [word, definitions] if word == MEASURE => measure(number(definitions)),
        sizes => table(&sizes.iter().map(number).collect::<Vec<usize>>()),
    }
}

fn table(sizes: &[usize]) {
    println!(
        "{:>12} {:>12} {:>10} {:>10} {:>8} {:>8}",
        "definitions", "operations", "time, s", "peak, MB", "time ~", "peak ~"
    );
    let mut before: Option<(f64, [f64; 3])> = None;
    for &definitions in sizes {
        let program = std::env::current_exe().expect("the path of this program");
        let output = Command::new(program).args([MEASURE, &definitions.to_string()]).output().expect("it runs again");
        let text = String::from_utf8_lossy(&output.stdout);
        // The engine prints a notice of its own.
        let line = text.lines().last().unwrap_or_default();
        let measured: Vec<f64> = line.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        let [operations, seconds, peak] = measured[..] else {
            panic!("{definitions} definitions: {text}{}", String::from_utf8_lossy(&output.stderr))
        };
        print!("{definitions:>12} {operations:>12} {seconds:>10.2} {peak:>10.0}");
        if let Some((size, [_, seconds_before, peak_before])) = before {
            let power = |ratio: f64| ratio.ln() / (definitions as f64 / size).ln();
            print!(" {:>8.2} {:>8.2}", power(seconds / seconds_before), power(peak / peak_before));
        }
        println!();
        before = Some((definitions as f64, [operations, seconds, peak]));
    }
    println!("~: the power of the number of definitions by which it grew since the row before");
}

/// Expands one declaration and prints the operations, the seconds of the processor and the peak in MB.
fn measure(definitions: usize) {
    let declaration = source(definitions);
    let parse = || declaration.parse().expect("tokens");
    let start = processor_seconds();
    let expanded = expand(parse(), &Driver::Macro { runtime: quote!(::carvallo) }).expect("it compiles");
    let seconds = processor_seconds() - start;
    let peak = peak();
    assert!(!expanded.is_empty());
    let operations = Counts::of(&compile(parse()).expect("it compiles").programs.matrices).total();
    println!("{operations} {seconds} {peak}");
}

/// What all threads of this process have run so far.
fn processor_seconds() -> f64 {
    let status = std::fs::read_to_string("/proc/self/stat").expect("the state of this process, as Linux shows it");
    // Behind the name, in parentheses: 11 fields, then user and system time in hundredths of a second.
    let (_, fields) = status.rsplit_once(')').expect("the name of this process");
    let ticks = fields.split_whitespace().skip(11).take(2);
    ticks.map(|ticks| ticks.parse::<f64>().expect("a number")).sum::<f64>() / 100.0
}

/// The largest resident size of this process so far, in MB.
fn peak() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").expect("the status of this process, as Linux shows it");
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).expect("the peak of the resident size");
    let kilobytes: f64 = line.trim().trim_end_matches("kB").trim().parse().expect("a number");
    kilobytes / 1024.0
}

/// A declaration in which each definition takes a few operations on parameters and earlier definitions, the one before
/// it among them.
fn source(definitions: usize) -> String {
    let mut text = String::from("model Synthetic { parameters {");
    (0..PARAMETERS).for_each(|index| write!(text, "p{index}: 1, > 0; ").expect("a string takes it"));
    text.push_str("} coordinates { x: 1; y: 1; }\n");
    let mut state = 1;
    for index in 0..definitions {
        let [b, c, d, e] = [(); 4].map(|()| draw(&mut state, index));
        // Every parameter and every definition is used.
        let a = format!("p{}", index % PARAMETERS);
        let f = if index == 0 { a.clone() } else { format!("d{}", index - 1) };
        let formula = match index % 5 {
            0 => format!("{a}*{f} + {b}*{c} - {d}"),
            1 => format!("{f}*sin({a}) + {b}*cos({a})"),
            2 => format!("({a}*{b} + {f}*{c}) / ({d} + {e})"),
            3 => format!("{f} + {a}*{b}^2 + {c}*{d}^2 - 2*{e}"),
            _ => format!("{a}*({b} - {f})*({c} + {d})"),
        };
        writeln!(text, "let d{index} = {formula};").expect("a string takes it");
    }
    let last = |back: usize| format!("d{}*1 [kg*m^2]", definitions - back);
    writeln!(
        text,
        "M = [[{}, {}], [{1}, {}]]; K0 = [[{}/1 [m], 0], [0, {0}/1 [m]]]; }}",
        last(1),
        last(2),
        last(3),
        last(4)
    )
    .expect("a string takes it");
    text
}

/// One of the parameters, or of the last hundred definitions: the same on every run.
fn draw(state: &mut u64, definitions: usize) -> String {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    let random = (*state >> 33) as usize;
    if definitions > 0 && random.is_multiple_of(2) {
        format!("d{}", definitions - 1 - (random / 2) % definitions.min(100))
    } else {
        format!("p{}", (random / 2) % PARAMETERS)
    }
}
