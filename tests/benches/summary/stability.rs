//! All critical speeds and stable ranges of a design.

use std::hint::black_box;

use carvallo::{Coefficients, Model, Stability};
use carvallo_models::Whipple;
use carvallo_tests::{bicycles, designs};

use crate::Summary;
use crate::contest::Task;

pub fn add(summary: &mut Summary) {
    let bicycles: Vec<_> =
        bicycles::all().into_iter().map(|(_, bicycle)| (bicycle.coefficients(), bicycle.g)).collect();
    let critical = |(coefficients, gravity): &(Coefficients<f64, 2>, f64)| Stability::new(coefficients, *gravity);
    summary.run(
        Task::new("Critical speeds and stable ranges, 14 bicycles", bicycles.len())
            .contender("ours, one by one", each(&bicycles, critical)),
    );
    let designs: Vec<Whipple> = (0..summary.designs as u64 / 50).map(designs::numbered).collect();
    summary.run(
        Task::new(format!("Sweep: matrices and critical speeds, {} distinct designs", designs.len()), designs.len())
            .contender("ours, one by one", each(&designs, |design| Stability::new(&design.coefficients(), design.g))),
    );
}

fn each<D, S>(designs: &[D], compute: impl Fn(&D) -> S) -> impl FnMut() {
    move || {
        for design in designs {
            black_box(compute(black_box(design)));
        }
    }
}
