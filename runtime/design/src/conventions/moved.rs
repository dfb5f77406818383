//! Whether something that is known of a design by a name moves with its parameters.

use carvallo::ModelInfo;

use super::dual::Dual;
use super::name::Values;
use super::naming::prepared;
use super::quantity::Quantity;
use crate::design::Design;
use crate::input::position;

/// Whether it changes where the parameters of the paper do.
pub fn moves(name: &str, paper: &Values, info: &ModelInfo) -> bool {
    let own = |at: usize| paper.get(info.parameters[at].name).unwrap_or_default();
    let quantity = Quantity::called(name, info, None);
    quantity.and_then(|quantity| quantity.value(info, &own)).is_some_and(|value| value.slope != 0.0)
}

/// Whether what was set by a name of a convention changes where a parameter of the model does: at the design, or beside it, where
/// what does not change at the design by chance does.
pub fn changes(set: &str, design: &Design, varied: usize) -> bool {
    let values = design.values();
    let by = |scale: f64, step: f64| {
        let of = |at: usize| Dual {
            value: if at == varied { scale * values[at] + step } else { values[at] },
            slope: f64::from(u8::from(at == varied)),
        };
        told(set, design, &of)
    };
    match [by(1.0, 0.0), by(1.01, 0.01)] {
        [Some(own), Some(beside)] => own.slope != 0.0 || beside.slope != 0.0,
        // The size of both wheels is none where one of them has its own.
        [own, beside] => own.is_some() != beside.is_some(),
    }
}

/// What is set by a name of a convention, with other parameters of the model; nothing by a name of the model.
fn told(set: &str, design: &Design, of: &dyn Fn(usize) -> Dual) -> Option<Dual> {
    let info = design.info();
    if position(set, info).is_some() {
        return None;
    }
    let reading = design.reading.as_ref();
    let own = reading.and_then(|it| Some((it, it.convention.parameter(&prepared(set, it.convention))?)));
    let Some((reading, name)) = own else { return Quantity::called(set, info, None)?.value(info, of) };
    let mut paper = Values::default();
    info.parameters.iter().enumerate().for_each(|(at, parameter)| paper.push(parameter.name, of(at)));
    reading.convention.tell(name.name, &paper, &reading.given)
}
