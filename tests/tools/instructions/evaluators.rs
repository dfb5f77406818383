//! What is counted.

use std::hint::black_box;
use std::process::ExitCode;

use carvallo::batch::Eigenvalues;
use carvallo::{Model, Sensitivity, Stability, System};
use carvallo_models::{Whipple, WhippleLeaning, WhippleMechanism};
use carvallo_tests::chosen::WhippleChosen;
use carvallo_tests::{designs, hand_written};

use crate::batches::{DESIGNS, blocks, columns, critical_speeds, jacobians, of_level, rates, structs};

/// An evaluator.
pub struct Evaluator {
    pub name: &'static str,
    /// What the count is divided by: designs, speeds.
    pub calls: usize,
    /// Runs it so often; not, if the processor has no such instructions.
    run: fn(usize) -> Option<()>,
}

/// A process that valgrind runs ends so if the processor cannot do what is asked for.
pub const NOT_ON_THIS_PROCESSOR: u8 = 3;

/// Matrices and derivatives that are written over others.
macro_rules! in_place {
    ($name:literal, $design:expr) => {
        Evaluator {
            name: $name,
            calls: 1000,
            run: |calls| {
                let design = $design;
                let (mut matrices, mut derivatives) = design.matrices_and_derivatives();
                one(calls, &design, |design| {
                    design.write_matrices_and_derivatives(&mut matrices, &mut derivatives);
                    black_box((&matrices, &derivatives));
                })
            },
        }
    };
}

pub const EVALUATORS: &[Evaluator] = &[
    Evaluator {
        name: "matrices by hand, f64",
        calls: 1000,
        run: |calls| one(calls, &bicycle(), hand_written::matrices),
    },
    Evaluator {
        name: "matrices from formulas, f64",
        calls: 1000,
        run: |calls| one(calls, &bicycle(), Whipple::matrices),
    },
    Evaluator {
        name: "matrices from formulas, f32",
        calls: 1000,
        run: |calls| one(calls, &designs::narrowed(&bicycle()), Whipple::matrices),
    },
    Evaluator {
        name: "matrices from bodies, f64",
        calls: 1000,
        run: |calls| one(calls, &WhippleMechanism::BENCHMARK, WhippleMechanism::matrices),
    },
    Evaluator {
        name: "matrices from bodies, f32",
        calls: 1000,
        run: |calls| {
            let design = designs::narrowed(&bicycle()).to_array();
            one(calls, &WhippleMechanism::from_array(design), WhippleMechanism::matrices)
        },
    },
    Evaluator {
        name: "matrices and Jacobian from bodies, f64",
        calls: 1000,
        run: |calls| one(calls, &WhippleMechanism::BENCHMARK, WhippleMechanism::matrices_and_derivatives),
    },
    Evaluator {
        name: "matrices and Jacobian from formulas, f64",
        calls: 1000,
        run: |calls| one(calls, &bicycle(), Whipple::matrices_and_derivatives),
    },
    Evaluator {
        name: "matrices and Jacobian from bodies, f32",
        calls: 1000,
        run: |calls| {
            let design = designs::narrowed(&bicycle()).to_array();
            one(calls, &WhippleMechanism::from_array(design), WhippleMechanism::matrices_and_derivatives)
        },
    },
    Evaluator {
        name: "matrices and Jacobian from formulas, f32",
        calls: 1000,
        run: |calls| one(calls, &designs::narrowed(&bicycle()), Whipple::matrices_and_derivatives),
    },
    in_place!("matrices and Jacobian in place from bodies, f64", WhippleMechanism::BENCHMARK),
    in_place!("matrices and Jacobian in place from formulas, f64", bicycle()),
    in_place!(
        "matrices and Jacobian in place from bodies, f32",
        WhippleMechanism::from_array(designs::narrowed(&bicycle()).to_array())
    ),
    in_place!("matrices and Jacobian in place from formulas, f32", designs::narrowed(&bicycle())),
    Evaluator {
        name: "matrices and derivatives of M, K0 by w, c from formulas, f64",
        calls: 1000,
        run: |calls| {
            one(calls, &WhippleChosen::from_array(bicycle().to_array()), WhippleChosen::matrices_and_derivatives)
        },
    },
    Evaluator { name: "matrices from bodies, batch, SSE2", calls: 6400, run: |calls| blocks(calls, "SSE2") },
    Evaluator { name: "matrices from bodies, batch, AVX2", calls: 6400, run: |calls| blocks(calls, "AVX2") },
    Evaluator {
        name: "matrices from bodies, batch of structs, SSE2",
        calls: 6400,
        run: |calls| structs(calls, "SSE2", WhippleMechanism::BENCHMARK),
    },
    Evaluator {
        name: "matrices from bodies, batch of structs, AVX2",
        calls: 6400,
        run: |calls| structs(calls, "AVX2", WhippleMechanism::BENCHMARK),
    },
    Evaluator {
        name: "matrices from bodies, batch of structs, f32, AVX2",
        calls: 6400,
        run: |calls| structs(calls, "AVX2", WhippleMechanism::BENCHMARK.to_f32()),
    },
    Evaluator {
        name: "matrices from bodies, batch of columns, AVX2",
        calls: 6400,
        run: |calls| columns(calls, "AVX2"),
    },
    Evaluator {
        name: "matrices and Jacobian from bodies, batch, SSE2",
        calls: 6400,
        run: |calls| jacobians(calls, "SSE2"),
    },
    Evaluator {
        name: "matrices and Jacobian from bodies, batch, AVX2",
        calls: 6400,
        run: |calls| jacobians(calls, "AVX2"),
    },
    Evaluator { name: "rates of positions and speeds, batch, AVX2", calls: 6400, run: |calls| rates(calls, "AVX2") },
    Evaluator { name: "eigenvalues of two coordinates", calls: 2010, run: eigenvalues },
    Evaluator { name: "eigenvalues, batch along the speed, SSE2", calls: 2010, run: |calls| along(calls, "SSE2") },
    Evaluator { name: "eigenvalues, batch along the speed, AVX2", calls: 2010, run: |calls| along(calls, "AVX2") },
    Evaluator {
        name: "eigenvalues of three coordinates",
        calls: 100,
        run: |calls| one(calls, &leaning(), System::eigenvalues),
    },
    Evaluator { name: "eigenvalues of three coordinates, batch, SSE2", calls: 640, run: |calls| three(calls, "SSE2") },
    Evaluator { name: "eigenvalues of three coordinates, batch, AVX2", calls: 640, run: |calls| three(calls, "AVX2") },
    Evaluator {
        name: "derivatives of all critical speeds",
        calls: 20,
        run: |calls| {
            let stability = Stability::new(&bicycle().coefficients(), bicycle().g).expect("critical speeds");
            one(calls, &bicycle(), |bicycle| {
                let sensitivity = Sensitivity::of(bicycle).expect("derivatives");
                let speeds = stability.critical_speeds.iter();
                speeds.for_each(|critical| drop(black_box(sensitivity.critical_speed(critical))));
            })
        },
    },
    Evaluator {
        name: "critical speeds of three coordinates",
        calls: 10,
        run: |calls| {
            let leaning = WhippleLeaning::EXAMPLE;
            one(calls, &leaning.coefficients(), |coefficients| Stability::new(coefficients, leaning.g))
        },
    },
    Evaluator {
        name: "critical speeds and stable ranges",
        calls: 20,
        run: |calls| {
            let coefficients = bicycle().coefficients();
            one(calls, &coefficients, |coefficients| Stability::new(coefficients, bicycle().g))
        },
    },
    Evaluator {
        name: "critical speeds and stable ranges, batch, SSE2",
        calls: 640,
        run: |calls| critical_speeds(calls, "SSE2"),
    },
    Evaluator {
        name: "critical speeds and stable ranges, batch, AVX2",
        calls: 640,
        run: |calls| critical_speeds(calls, "AVX2"),
    },
];

fn bicycle() -> Whipple {
    Whipple::BENCHMARK
}

/// Runs the evaluator of a name.
pub fn run(name: &str, calls: usize) -> ExitCode {
    let evaluator = EVALUATORS.iter().find(|evaluator| evaluator.name == name).expect("the name of an evaluator");
    match (evaluator.run)(calls) {
        Some(()) => ExitCode::SUCCESS,
        None => ExitCode::from(NOT_ON_THIS_PROCESSOR),
    }
}

fn one<D, R>(calls: usize, design: &D, mut compute: impl FnMut(&D) -> R) -> Option<()> {
    for _ in 0..calls {
        black_box(compute(black_box(design)));
    }
    Some(())
}

/// From 0 to 10 m/s.
fn speeds() -> [f64; 201] {
    std::array::from_fn(|step| 0.05 * step as f64)
}

/// At each speed in turn.
fn eigenvalues(calls: usize) -> Option<()> {
    let coefficients = bicycle().coefficients();
    let systems = speeds().map(|speed| coefficients.at(speed, bicycle().g).expect("a system"));
    for system in systems.iter().cycle().take(calls) {
        let _ = black_box(System::quartic_eigenvalues(black_box(system)));
    }
    Some(())
}

/// A bicycle whose rider leans, at a speed.
fn leaning() -> System<3> {
    let leaning = WhippleLeaning::EXAMPLE;
    leaning.coefficients().at(5.0, leaning.g).expect("a system")
}

fn three(calls: usize, level: &str) -> Option<()> {
    let (batch, systems) = (of_level(level)?, vec![leaning(); DESIGNS]);
    let mut found = vec![Ok(Vec::new()); DESIGNS];
    for _ in 0..calls / DESIGNS {
        let done = batch.eigenvalues_of_any(black_box(&systems), black_box(&mut found));
        done.expect("slices of equal length");
    }
    Some(())
}

fn along(calls: usize, level: &str) -> Option<()> {
    let batch = of_level(level)?;
    let (coefficients, speeds) = (bicycle().coefficients(), speeds());
    let mut found: Vec<Eigenvalues> = speeds.map(|_| Ok(Default::default())).into();
    for _ in 0..calls / speeds.len() {
        let (coefficients, speeds) = (black_box(&coefficients), black_box(&speeds));
        let done = batch.eigenvalues_along(coefficients, bicycle().g, speeds, black_box(&mut found));
        done.expect("slices of equal length");
    }
    Some(())
}
