//! The tasks of a comparison.

use std::hint::black_box;

use carvallo::Model;
use carvallo::batch::{Batch, Blocks};

use super::Task;
use crate::side::{Side, design};

/// How many designs a run computes at least, the same ones again and again if there are fewer.
const AT_LEAST: usize = 4096;

/// All sides that have a function in a number type, one design after the other; nothing if none has.
pub fn one_by_one(sides: &[Side], designs: &[Vec<f64>], single: bool) -> Option<Task<'static>> {
    let repetitions = AT_LEAST.div_ceil(designs.len());
    let what = if designs.len() == 1 { "one design".into() } else { format!("a loop over {} designs", designs.len()) };
    let scalar = if single { "f32" } else { "f64" };
    let mut task = Task::new(format!("{scalar}, {what}"), repetitions * designs.len());
    for side in sides {
        let code = if single { side.single.as_ref() } else { Some(&side.double) };
        if let Some(code) = code {
            let mut each = (code.each)(designs);
            task = task.contender(side.name.clone(), move || (0..repetitions).for_each(|_| each()));
        }
    }
    (!task.contenders.is_empty()).then_some(task)
}

/// The same task with the generated program in a batch.
pub fn batch<const N: usize, M: Model<N, Scalar = f64>>(task: Task<'static>, designs: &[Vec<f64>]) -> Task<'static> {
    let batch = Batch::new();
    let models: Vec<M> = designs.iter().map(|parameters| design(parameters)).collect();
    let parameters = Blocks::of_designs(&models);
    let mut entries = Blocks::for_entries::<N, M>(models.len());
    let repetitions = task.repetitions / designs.len() as u64;
    task.contender(format!("generated, batch, {batch}"), move || {
        for _ in 0..repetitions {
            let done = batch.matrices::<N, M>(black_box(&parameters), black_box(&mut entries));
            done.expect("blocks that fit");
        }
    })
}
