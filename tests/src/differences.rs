//! Derivatives of the Whipple bicycle's eigenvalues and critical speeds as differences at 320 bits.
//!
//! A parameter is moved by 1e-30 both ways, and what follows from it is solved anew, to more than 80 digits. Critical
//! speeds come from conditions other than those of the runtime: the determinant of the stiffness, the Hurwitz determinant,
//! and the discriminant.

use carvallo::CriticalKind;
use carvallo_models::Whipple;
use nalgebra::Complex as Complex64;

use crate::exact::{self, Matrices};
use crate::quartic::determinant;
use crate::roots::Complex;
use carvallo_compare::Real;

const STEP: &str = "1e-30";

/// A bicycle whose parameters have 320 bits.
#[derive(Clone, Debug)]
pub struct Exact {
    values: Vec<Real>,
}

/// A critical speed and its eigenvalue.
#[derive(Clone, Copy, Debug)]
pub struct Critical {
    /// In m/s.
    pub speed: Real,
    /// In 1/s.
    pub eigenvalue: Complex,
}

impl Exact {
    /// Of a design whose parameters are taken to be exact.
    pub fn of(design: &Whipple) -> Self {
        Self { values: exact::values(design).into_iter().map(Real::from).collect() }
    }

    /// With a parameter changed.
    fn moved(&self, parameter: usize, by: Real) -> Self {
        let mut moved = self.clone();
        moved.values[parameter] = moved.values[parameter] + by;
        moved
    }

    fn value(&self, name: &str) -> Real {
        let position = <Whipple as carvallo::Model<2>>::INFO.position(name);
        self.values[position.unwrap_or_else(|| panic!("no parameter is called {name}"))]
    }

    fn matrices(&self) -> Matrices<Real> {
        exact::matrices_of(|name| self.value(name))
    }

    /// The characteristic polynomial at a speed, from s^4 down to s^0.
    fn characteristic(matrices: &Matrices<Real>, gravity: Real, speed: Real) -> [Real; 5] {
        let [m, c1, k0, k2] = matrices;
        determinant(|i, j| [m[i][j], speed * c1[i][j], gravity * k0[i][j] + speed * speed * k2[i][j]])
    }

    /// The critical speed of a kind, and its eigenvalue, that is near to a known one.
    pub fn critical(&self, kind: CriticalKind, speed: Real, eigenvalue: Complex64<f64>) -> Critical {
        let (matrices, gravity) = (self.matrices(), self.value("g"));
        let at = |speed| Self::characteristic(&matrices, gravity, speed);
        let speed = secant(|speed| condition(kind, at(speed)), speed);
        let zero = Real::from(0.0);
        let [p4, p3, p2, p1, _] = at(speed);
        let eigenvalue = match kind {
            CriticalKind::Capsize => Complex { re: zero, im: zero },
            CriticalKind::Weave => Complex { re: zero, im: square_root(p1 / p3) },
            // The double root of p is a simple one of its derivative.
            CriticalKind::DoubleRoot => {
                let [three, four, two] = [3.0, 4.0, 2.0].map(Real::from);
                newton(&[four * p4, three * p3, two * p2, p1], eigenvalue)
            }
        };
        Critical { speed, eigenvalue }
    }

    /// The derivatives of a critical speed and of its eigenvalue with respect to a parameter.
    pub fn critical_derivative(&self, kind: CriticalKind, of: &Critical, parameter: usize) -> (f64, Complex64<f64>) {
        let step = Real::parse(STEP);
        let start = of.eigenvalue.to_f64();
        let [above, below] = [step, -step].map(|by| self.moved(parameter, by).critical(kind, of.speed, start));
        let half = |above: Real, below: Real| ((above - below) / (step + step)).to_f64();
        let eigenvalue = above.eigenvalue - below.eigenvalue;
        let zero = Real::from(0.0);
        (half(above.speed, below.speed), Complex64::new(half(eigenvalue.re, zero), half(eigenvalue.im, zero)))
    }

    /// The eigenvalue at a speed that is near to a known one.
    fn eigenvalue(&self, speed: Real, near: Complex64<f64>) -> Complex {
        newton(&Self::characteristic(&self.matrices(), self.value("g"), speed), near)
    }

    /// The derivative of a simple eigenvalue with respect to a parameter; with respect to the speed for none.
    pub fn eigenvalue_derivative(&self, speed: f64, near: Complex64<f64>, parameter: Option<usize>) -> Complex64<f64> {
        let (speed, step) = (Real::from(speed), Real::parse(STEP));
        let [above, below] = [step, -step].map(|by| match parameter {
            Some(parameter) => self.moved(parameter, by).eigenvalue(speed, near),
            None => self.eigenvalue(speed + by, near),
        });
        let (difference, twice) = (above - below, step + step);
        Complex { re: difference.re / twice, im: difference.im / twice }.to_f64()
    }
}

/// What is zero at a critical speed.
fn condition(kind: CriticalKind, [a, b, c, d, e]: [Real; 5]) -> Real {
    let times = |factor: f64, value: Real| Real::from(factor) * value;
    match kind {
        CriticalKind::Capsize => e,
        CriticalKind::Weave => b * c * d - a * d * d - b * b * e,
        CriticalKind::DoubleRoot => {
            let i = times(12.0, a * e) - times(3.0, b * d) + c * c;
            let j = times(72.0, a * c * e) + times(9.0, b * c * d) - times(27.0, a * d * d + b * b * e);
            let j = j - times(2.0, c * c * c);
            times(4.0, i * i * i) - j * j
        }
    }
}

/// The root of a function near to a number.
fn secant(f: impl Fn(Real) -> Real, near: Real) -> Real {
    let (mut x, mut last) = (near, near + near * Real::parse("1e-25"));
    let (mut at, mut at_last) = (f(x), f(last));
    let small = near.abs() * Real::parse("1e-85");
    for _ in 0..60 {
        if at == Real::from(0.0) || at == at_last {
            break;
        }
        let step = at * (x - last) / (at - at_last);
        (last, at_last) = (x, at);
        x = x - step;
        at = f(x);
        if step.abs() <= small {
            break;
        }
    }
    x
}

/// The simple root of a polynomial, its highest coefficient first, near to a number.
fn newton(coefficients: &[Real], near: Complex64<f64>) -> Complex {
    let complex = |re: Real| Complex { re, im: Real::from(0.0) };
    let mut s = Complex { re: Real::from(near.re), im: Real::from(near.im) };
    for _ in 0..12 {
        let (mut value, mut slope) = (complex(Real::from(0.0)), complex(Real::from(0.0)));
        for &coefficient in coefficients {
            slope = slope * s + value;
            value = value * s + complex(coefficient);
        }
        let step = value / slope;
        s = s - step;
        if (step.re.abs() + step.im.abs()) <= Real::parse("1e-85") * (s.re.abs() + s.im.abs()) {
            break;
        }
    }
    s
}

fn square_root(x: Real) -> Real {
    let mut root = Real::from(x.to_f64().sqrt());
    for _ in 0..5 {
        root = (root + x / root) / Real::from(2.0);
    }
    root
}
