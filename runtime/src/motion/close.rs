//! Positions in which every wheel touches the ground.

use super::error::MotionError;
use super::info::MotionInfo;
use crate::number::Scalar;

/// No step is longer than this, in rad or m: it keeps to the solution that is near.
const LONGEST: f64 = 0.25;
/// With steps of that length it leads around the whole circle; near a solution a handful is enough.
const MOST_STEPS: usize = 60;

/// Makes positions such that every wheel touches the ground, as [`Motion::close`](super::Motion::close) does; `closure` tells for
/// positions how far the wheels behind the first are below the ground, in m, and what to add to those positions that depend on
/// others, by Newton's method.
///
/// # Errors
/// As there.
pub fn close<T: Scalar, P: AsRef<[T]> + AsMut<[T]>, D: AsRef<[T]> + AsMut<[T]>>(
    closure: impl Fn(&P) -> (D, D),
    info: &MotionInfo,
    mut positions: P,
) -> Result<P, MotionError> {
    let scalar = T::from_f64;
    let [zero, one] = [0.0, 1.0].map(scalar);
    let mut shortest = scalar(f64::MAX.min(1e30));
    for _ in 0..MOST_STEPS {
        let (_, mut steps) = closure(&positions);
        let longest =
            steps.as_ref().iter().fold(zero, |longest, step| if step.abs() > longest { step.abs() } else { longest });
        if !steps.as_ref().iter().all(|step| step.is_finite()) {
            break;
        }
        if longest > scalar(LONGEST) {
            let share = scalar(LONGEST) / longest;
            steps.as_mut().iter_mut().for_each(|step| *step *= share);
        }
        for (place, step) in info.dependent.iter().zip(steps.as_ref()) {
            positions.as_mut()[*place] += *step;
        }
        // Near the solution steps shrink to rounding, and then no further.
        let rounding = scalar(4.0) * T::EPSILON;
        let size = info.dependent.iter().fold(one, |size, place| {
            let value = positions.as_ref()[*place].abs();
            if value > size { value } else { size }
        });
        if longest <= rounding * size || longest < scalar(NEAR) && longest >= shortest {
            return Ok(positions);
        }
        shortest = longest;
    }
    let (below, _) = closure(&positions);
    let worst = below.as_ref().iter().enumerate().fold((0, zero), |(worst, most), (wheel, below)| {
        if below.is_finite() && below.abs() > most { (wheel, below.abs()) } else { (worst, most) }
    });
    let (wheel, _) = worst;
    let below = below.as_ref().get(wheel).map_or(0.0, |below| below.to_f64());
    match below.is_finite() {
        true => Err(MotionError::NotClosed { wheel: info.wheels.get(wheel + 1).map_or("", |wheel| wheel.name), below }),
        false => Err(MotionError::Singular { quantity: "the height of a wheel" }),
    }
}

/// Steps that no longer shrink below this are rounding; those of `f32` are larger.
const NEAR: f64 = 1e-5;
