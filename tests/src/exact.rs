//! The matrices of the Whipple bicycle in exact arithmetic, by moments of the assembled bodies.
//!
//! Appendix A writes the moments of the whole bicycle and of its front assembly out one by one; here both are sums over
//! bodies, shifted by the parallel-axis theorem. In exact arithmetic the two agree; in formula and rounding they do not.

use std::ops::{Add, Div, Mul, Neg, Sub};

use carvallo::Model;
use carvallo_models::Whipple;

use carvallo_compare::Real;

/// The matrices M, C1, K0 and K2 by rows.
pub type Matrices<R> = [[[R; 2]; 2]; 4];

/// What the formulas need of a number.
pub trait Number:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Sine and cosine.
    fn sin_cos(self) -> (Self, Self);
}

impl Number for Real {
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }
}

/// The size of the terms that a value is summed from: the value of its formula with every term made positive.
///
/// It does not change when sums are reordered or products expanded, so that a bound on rounding errors in units of it
/// holds for any arrangement of the formula. Divisors need a sign that is known: here they are lengths and masses.
#[derive(Clone, Copy, Debug)]
pub struct Size(pub f64);

impl From<f64> for Size {
    fn from(value: f64) -> Self {
        Self(value.abs())
    }
}

impl Add for Size {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Size {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Add::add(self, other)
    }
}

impl Mul for Size {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for Size {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl Neg for Size {
    type Output = Self;
    fn neg(self) -> Self {
        self
    }
}

impl Number for Size {
    /// Of the magnitude of the angle; that is enough up to a quarter turn.
    fn sin_cos(self) -> (Self, Self) {
        (Self(self.0.sin()), Self(self.0.cos()))
    }
}

/// Mass, centre of mass, and moments of inertia about it, of a body that is symmetric left to right.
#[derive(Clone, Copy)]
struct Body<R> {
    mass: R,
    x: R,
    z: R,
    xx: R,
    xz: R,
    zz: R,
}

/// Mass and centre of mass of bodies fixed to each other.
fn centre<R: Number>(bodies: &[Body<R>]) -> (R, R, R) {
    let zero = R::from(0.0);
    let (mass, x, z) = bodies.iter().fold((zero, zero, zero), |(mass, x, z), body| {
        (mass + body.mass, x + body.mass * body.x, z + body.mass * body.z)
    });
    (mass, x / mass, z / mass)
}

/// Moments of inertia xx, xz and zz of bodies about a point.
fn moments<R: Number>(bodies: &[Body<R>], x: R, z: R) -> (R, R, R) {
    let zero = R::from(0.0);
    bodies.iter().fold((zero, zero, zero), |(xx, xz, zz), body| {
        let (x, z) = (body.x - x, body.z - z);
        (xx + body.xx + body.mass * z * z, xz + body.xz - body.mass * x * z, zz + body.zz + body.mass * x * x)
    })
}

/// The matrices of a design, whose floating-point parameters are taken as exact.
pub fn matrices<R: Number>(design: &Whipple<impl carvallo::Scalar>) -> Matrices<R> {
    let values = values(design);
    matrices_of(|name| R::from(values[position(name)]))
}

/// The derivatives of the matrices with respect to the parameter at a position, by central differences.
///
/// With the step below, the rest of the series is of the order of 1e-60, and so are rounding errors in 320 bits.
pub fn derivatives(design: &Whipple<impl carvallo::Scalar>, parameter: usize) -> Matrices<Real> {
    let (values, step) = (values(design), Real::parse("1e-30"));
    let at = |shift: Real| {
        matrices_of(|name| {
            let value = Real::from(values[position(name)]);
            if position(name) == parameter { value + shift } else { value }
        })
    };
    let (above, below) = (at(step), at(-step));
    std::array::from_fn(|matrix| {
        std::array::from_fn(|row| {
            std::array::from_fn(|column| (above[matrix][row][column] - below[matrix][row][column]) / (step + step))
        })
    })
}

/// The size of the terms that the derivatives of each matrix with respect to the parameter at a position are summed from, for
/// the entry where it is largest: by how much those that have the parameter in them change while it becomes twice as large, or
/// one if it is zero. Derivatives may cancel to nothing.
pub fn derivative_sizes(design: &Whipple<impl carvallo::Scalar>, parameter: usize) -> [f64; 4] {
    let values = values(design);
    let step = if values[parameter] == 0.0 { 1.0 } else { values[parameter].abs() };
    let at = |shift: f64| {
        matrices_of(|name| {
            let value = values[position(name)].abs();
            Size(if position(name) == parameter { value + shift } else { value })
        })
    };
    let (once, twice) = (at(0.0), at(step));
    std::array::from_fn(|matrix| {
        let entries = once[matrix].into_iter().zip(twice[matrix]).flat_map(|(once, twice)| once.into_iter().zip(twice));
        entries.map(|(once, twice)| (twice.0 - once.0).abs() / step).fold(0.0, f64::max)
    })
}

/// The matrices at parameters that are given by their names.
pub fn matrices_of<R: Number>(value: impl Fn(&str) -> R) -> Matrices<R> {
    let zero = R::from(0.0);
    let [w, c, r_rear, r_front] = ["w", "c", "rR", "rF"].map(&value);
    let (sin, cos) = value("lam").sin_cos();
    let frame = |names: [&str; 6]| {
        let [mass, x, z, xx, xz, zz] = names.map(&value);
        Body { mass, x, z, xx, xz, zz }
    };
    let wheel = |mass, x, radius: R, radial| {
        let radial = value(radial);
        Body { mass: value(mass), x, z: -radius, xx: radial, xz: zero, zz: radial }
    };
    let rear_wheel = wheel("mR", zero, r_rear, "IRxx");
    let rear_frame = frame(["mB", "xB", "zB", "IBxx", "IBxz", "IBzz"]);
    let front_frame = frame(["mH", "xH", "zH", "IHxx", "IHxz", "IHzz"]);
    let front_wheel = wheel("mF", w, r_front, "IFxx");

    let all = [rear_wheel, rear_frame, front_frame, front_wheel];
    let (mass, x, z) = centre(&all);
    let (xx, xz, zz) = moments(&all, zero, zero);
    let front = [front_frame, front_wheel];
    let (front_mass, front_x, front_z) = centre(&front);
    let (front_xx, front_xz, front_zz) = moments(&front, front_x, front_z);

    // Distance u of the front assembly's centre from the steer axis l, and the assembly's moments about that axis.
    let u = (front_x - w - c) * cos - front_z * sin;
    let l_x = front_xx * sin + front_xz * cos;
    let l_z = front_xz * sin + front_zz * cos;
    let l_l = front_mass * u * u + l_x * sin + l_z * cos;
    let (l_x, l_z) = (l_x - front_mass * u * front_z, l_z + front_mass * u * front_x);

    let mu = c * cos / w;
    let (gyro_rear, gyro_front) = (value("IRyy") / r_rear, value("IFyy") / r_front);
    let gyro = gyro_rear + gyro_front;
    let gyro_steer = mu * gyro + gyro_front * cos;
    let static_steer = front_mass * u + mu * mass * x;
    let static_lean = mass * z;
    let m_cross = l_x + mu * xz;
    [
        [[xx, m_cross], [m_cross, l_l + mu * (l_z + l_z + mu * zz)]],
        [
            [zero, gyro_steer + xz * cos / w - mu * static_lean],
            [-gyro_steer, l_z * cos / w + mu * (static_steer + zz * cos / w)],
        ],
        [[static_lean, -static_steer], [-static_steer, -(static_steer * sin)]],
        [[zero, (gyro - static_lean) * cos / w], [zero, (static_steer + gyro_front * sin) * cos / w]],
    ]
}

/// The parameters as `f64`, exactly, in declared order.
pub fn values<T: carvallo::Scalar>(design: &Whipple<T>) -> Vec<f64> {
    let mut values = vec![T::from_f64(0.0); Whipple::<T>::INFO.parameters.len()];
    design.write_to(&mut values).expect("room for every parameter");
    values.into_iter().map(T::to_f64).collect()
}

fn position(name: &str) -> usize {
    Whipple::INFO.position(name).unwrap_or_else(|| panic!("no parameter is called {name}"))
}
