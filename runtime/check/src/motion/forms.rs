//! Accelerations in coordinates or at speeds that are others than ours as a whole: in degrees, positive the other way, in another order,
//! in km/h.

use carvallo::ModelInfo;

use crate::conventions::{self, Convention, Effect};
use crate::given::{Accelerations, Given, Reading};

/// For each way in which all states or accelerations of a file may be others: what they would be in ours, and what was done, in words.
pub fn mended(given: &Given, info: &ModelInfo) -> Vec<(Given, String)> {
    let mut found = Vec::new();
    let mut add = |told: String, mend: &dyn Fn(&mut Accelerations)| {
        let mut own = given.clone();
        own.accelerations.iter_mut().for_each(mend);
        if own.accelerations != given.accelerations {
            found.push((own, told));
        }
    };
    let is_angle: Vec<bool> = info.coordinates.iter().map(|own| own.unit == "rad").collect();
    let state_in_degrees = |own: &mut Accelerations| {
        for values in [&mut own.positions, &mut own.rates] {
            let angles = values.iter_mut().zip(&is_angle).filter(|(_, is_angle)| **is_angle);
            angles.for_each(|(value, _)| *value = value.to_radians());
        }
    };
    let values_in_degrees = |own: &mut Accelerations| {
        (0..is_angle.len()).filter(|at| is_angle[*at]).for_each(|at| scale(own, at, 1_f64.to_radians()));
    };
    add("accelerations are in degrees/s^2".to_owned(), &values_in_degrees);
    add("the state is in degrees".to_owned(), &state_in_degrees);
    add("state and accelerations are in degrees".to_owned(), &|own| {
        state_in_degrees(own);
        values_in_degrees(own);
    });
    let names: Vec<&str> = info.coordinates.iter().map(|own| own.name).collect();
    for (at, name) in names.iter().enumerate() {
        add(format!("{name} was counted positive the other way"), &|own| {
            for values in [&mut own.positions, &mut own.rates, &mut own.forces] {
                values[at] = -values[at];
            }
            scale(own, at, -1.0);
        });
        for (other, second) in names.iter().enumerate().skip(at + 1) {
            add(format!("accelerations of {name} and {second} are exchanged"), &|own| own.values.swap(at, other));
            add(format!("{name} and {second} are exchanged"), &|own| {
                for values in [&mut own.positions, &mut own.rates, &mut own.forces] {
                    values.swap(at, other);
                }
                own.values.swap(at, other);
            });
        }
    }
    for convention in conventions::coordinates(info) {
        let Convention { what, effect: Effect::Coordinates(shares), .. } = convention else { continue };
        add(what, &|own| transform(own, &shares));
    }
    add("accelerations have the other sign".to_owned(), &|own| (0..names.len()).for_each(|at| scale(own, at, -1.0)));
    add("rates are left out".to_owned(), &|own| own.rates.fill(0.0));
    for (told, factor) in conventions::units() {
        add(told, &|own| own.speed *= factor);
    }
    found
}

/// Of a state in other coordinates, of which ours are these shares; as it is where forces are given or an acceleration is not.
fn transform(own: &mut Accelerations, shares: &[f64]) {
    let count = own.positions.len();
    let Some(known) = own.values.iter().cloned().collect::<Option<Vec<Reading>>>() else { return };
    if own.forces.iter().any(|force| *force != 0.0) {
        return;
    }
    let sum = |row: usize, of: &dyn Fn(usize, f64) -> f64| -> f64 {
        (0..count).map(|column| of(column, shares[row * count + column])).sum()
    };
    for values in [&mut own.positions, &mut own.rates] {
        *values = (0..count).map(|row| sum(row, &|at, share| share * values[at])).collect();
    }
    let reading = |row: usize| Reading {
        value: sum(row, &|at, share| share * known[at].value),
        tolerance: sum(row, &|at, share| share.abs() * known[at].tolerance),
        ..known[row].clone()
    };
    own.values = (0..count).map(|row| Some(reading(row))).collect();
}

fn scale(own: &mut Accelerations, at: usize, factor: f64) {
    if let Some(reading) = &mut own.values[at] {
        reading.value *= factor;
        reading.tolerance *= factor.abs();
    }
}
