//! The damping and the stiffness behind state matrices.

use carvallo::MatrixName;
use carvallo_design::number::shortest;

use crate::given::{Given, Quantity, Reading, Rows, SystemMatrix};
use crate::machine::Machine;
use crate::predict::Predictor;
use crate::states::states;
use carvallo_slips::index;

/// C and K at the speeds of the state matrices that are given, `C = -M A` of the accelerations by rates and `K = -M A` of those
/// by positions, as near as the digits of A tell them; `None` where there is no such matrix.
///
/// Where the mass matrix is another one all of them differ.
pub fn state_matrices(machine: &Machine, predictor: &Predictor) -> Option<Given> {
    let (count, states) = (machine.formulas.count, states(machine.info));
    let rate = |of: usize| states.iter().position(|state| *state == (true, of));
    // Without the acceleration of a coordinate its equation is another one.
    let accelerations: Vec<usize> = (0..count).map(rate).collect::<Option<_>>()?;
    let world = machine.world();
    let mass = |row: usize, column: usize| world.entries[index(MatrixName::M, row, column, count)];
    let mut given = Given::default();
    for (at, state) in predictor.given().state_matrices.iter().enumerate() {
        let order = predictor.order(at);
        // The number at a row and a column that are those of the library.
        let number = |row: usize, column: usize| {
            let place = |state: usize| order.iter().position(|own| *own == state);
            let wanted = Quantity::State(at, place(row)?, place(column)?);
            predictor.numbers().iter().position(|(quantity, _)| *quantity == wanted)
        };
        let entry = |row: usize, column: usize| -> Option<Reading> {
            let (mut value, mut tolerance) = (0.0, 0.0);
            for (other, &acceleration) in accelerations.iter().enumerate() {
                let own = number(acceleration, column)?;
                value -= mass(row, other) * predictor.numbers()[own].1.value;
                tolerance += (mass(row, other) * predictor.tolerances()[own]).abs();
            }
            Some(Reading::within(value, tolerance))
        };
        for is_stiffness in [false, true] {
            let column = |of: usize| states.iter().position(|state| *state == (!is_stiffness, of));
            let row = |row: usize| (0..count).map(|of| entry(row, column(of)?)).collect();
            let rows: Rows = (0..count).map(row).collect();
            given.system_matrices.push(SystemMatrix { speed: state.speed, is_stiffness, rows });
        }
    }
    (!given.numbers().is_empty()).then_some(given)
}

/// With six digits.
pub fn shown(value: f64) -> String {
    shortest(format!("{value:.5e}").parse().unwrap_or(value))
}
