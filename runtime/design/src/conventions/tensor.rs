//! Moments of inertia of a body that is symmetric about the plane of the bicycle.

use super::dual::Dual;

/// The inertia tensor of a body about its centre of mass, in axes of which x and z lie in the plane of symmetry.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tensor {
    pub xx: Dual,
    pub yy: Dual,
    pub zz: Dual,
    /// The entry of the tensor, which is minus the integral of x z.
    pub xz: Dual,
}

impl Tensor {
    /// From the moments xx, yy and zz and the product xz.
    pub fn new([xx, yy, zz, xz]: [Dual; 4]) -> Self {
        Self { xx, yy, zz, xz }
    }

    /// xx, yy, zz and xz.
    pub fn entries(self) -> [Dual; 4] {
        [self.xx, self.yy, self.zz, self.xz]
    }

    /// In axes that are turned about y by an angle, from z to x.
    pub fn turned(self, angle: Dual) -> Self {
        let (s, c) = angle.sin_cos();
        let Self { xx, yy, zz, xz } = self;
        let cross = s * c;
        Self {
            xx: c.square() * xx + s.square() * zz - 2.0 * (cross * xz),
            yy,
            zz: s.square() * xx + c.square() * zz + 2.0 * (cross * xz),
            xz: cross * (xx - zz) + (c.square() - s.square()) * xz,
        }
    }

    /// The moments about the principal axes a and b, and the angle from the x-axis to a, from z to x; a is the axis that is
    /// nearer to x.
    pub fn principal(self) -> ([Dual; 2], Dual) {
        let Self { xx, zz, xz, .. } = self;
        let (mean, half) = (0.5 * (xx + zz), 0.5 * (xx - zz));
        let radius = half.hypot(xz);
        let is_nearer = half.value >= 0.0;
        let (radius, side) = if is_nearer { (radius, 1.0) } else { (-radius, -1.0) };
        let angle = if xz.value == 0.0 && half.value == 0.0 {
            Dual::default()
        } else {
            0.5 * (-(side * xz)).atan2(side * half)
        };
        ([mean + radius, mean - radius], angle)
    }

    /// What a mass at a place (x, z) from the centre adds.
    pub fn of_point(mass: Dual, [x, z]: [Dual; 2]) -> Self {
        let [xx, zz] = [mass * z.square(), mass * x.square()];
        Self { xx, zz, yy: xx + zz, xz: -(mass * x * z) }
    }

    /// The sum of two in the same axes.
    pub fn plus(self, other: Self) -> Self {
        let [a, b] = [self.entries(), other.entries()];
        Self::new([0, 1, 2, 3].map(|entry| a[entry] + b[entry]))
    }

    /// The difference of two in the same axes.
    pub fn minus(self, other: Self) -> Self {
        self.plus(Self::new(other.entries().map(|entry| -entry)))
    }
}

/// A body: its mass, where its centre is, and its inertia about that, all in the same axes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Body {
    pub mass: Dual,
    pub centre: [Dual; 2],
    pub inertia: Tensor,
}

impl Body {
    /// Several bodies as one, at the centre of the first if none has mass.
    pub fn joined(bodies: &[Self]) -> Self {
        let sum = |part: &dyn Fn(&Self) -> Dual| bodies.iter().map(part).fold(Dual::default(), |sum, part| sum + part);
        let mass = sum(&|body| body.mass);
        let centre = [0, 1].map(|axis| match mass.value {
            0.0 => bodies.first().map_or(Dual::default(), |body| body.centre[axis]),
            _ => sum(&|body| body.mass * body.centre[axis]) / mass,
        });
        let inertia = bodies.iter().fold(Tensor::default(), |inertia, body| {
            let offset = [0, 1].map(|axis| body.centre[axis] - centre[axis]);
            inertia.plus(body.inertia).plus(Tensor::of_point(body.mass, offset))
        });
        Self { mass, centre, inertia }
    }

    /// What is left of a body without another that is part of it.
    pub fn without(self, part: Self) -> Self {
        let mass = self.mass - part.mass;
        let rest = |axis: usize| (self.mass * self.centre[axis] - part.mass * part.centre[axis]) / mass;
        let centre = if mass.value == 0.0 { self.centre } else { [rest(0), rest(1)] };
        let offset = |body: Self| Tensor::of_point(body.mass, [0, 1].map(|axis| body.centre[axis] - self.centre[axis]));
        let rest = Self { mass, centre, inertia: Tensor::default() };
        let inertia = self.inertia.minus(part.inertia).minus(offset(part)).minus(offset(rest));
        Self { inertia, ..rest }
    }
}

/// A place (x, z) in axes that are turned about y by an angle, from z to x.
pub fn turned([x, z]: [Dual; 2], angle: Dual) -> [Dual; 2] {
    let (s, c) = angle.sin_cos();
    [c * x - s * z, s * x + c * z]
}
