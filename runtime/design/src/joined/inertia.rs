//! Mass, centre and moments of inertia of what is rigid and symmetric about the plane of a machine.

use carvallo::{Sources, Uncertain};

/// A rigid body that is laterally symmetric, in the axes of Meijaard et al. (2007): x forward, y to the right, z down.
#[derive(Clone, Copy, Debug)]
pub struct Inertia<'a> {
    /// In kg.
    pub mass: Uncertain<'a>,
    /// The centre of mass in m.
    pub x: Uncertain<'a>,
    /// The centre of mass in m, negative above the ground.
    pub z: Uncertain<'a>,
    /// About the centre of mass in kg m^2, in roll.
    pub xx: Uncertain<'a>,
    /// About the centre of mass in kg m^2, in pitch.
    pub yy: Uncertain<'a>,
    /// About the centre of mass in kg m^2, in yaw.
    pub zz: Uncertain<'a>,
    /// The entry of the tensor about the centre of mass in kg m^2, which is minus the integral of x z.
    pub xz: Uncertain<'a>,
}

impl<'a> Inertia<'a> {
    /// All of a mass at one place, in kg and m.
    pub fn point(sources: &'a Sources, mass: Uncertain<'a>, [x, z]: [Uncertain<'a>; 2]) -> Self {
        let zero = sources.exact(0.0);
        Self { mass, x, z, xx: zero, yy: zero, zz: zero, xz: zero }
    }

    /// Both bodies as one, about their common centre of mass. With the reduced mass m1 m2/(m1 + m2) no large terms cancel.
    pub fn with(self, other: Self) -> Self {
        if other.mass.value() == 0.0 && other.mass.deviation() == 0.0 {
            return self;
        }
        let mass = self.mass + other.mass;
        let share = other.mass / mass;
        let reduced = self.mass * share;
        let (dx, dz) = (other.x - self.x, other.z - self.z);
        Self {
            mass,
            x: self.x + share * dx,
            z: self.z + share * dz,
            xx: self.xx + other.xx + reduced * dz.squared(),
            yy: self.yy + other.yy + reduced * (dx.squared() + dz.squared()),
            zz: self.zz + other.zz + reduced * dx.squared(),
            xz: self.xz + other.xz - reduced * dx * dz,
        }
    }

    /// The same turned in pitch about its centre of mass by an angle in radians, with its front end up.
    pub fn turned(self, angle: Uncertain<'a>) -> Self {
        let (s, c) = (angle.sin(), angle.cos());
        Self {
            xx: c.squared() * self.xx + s.squared() * self.zz + s * c * self.xz * 2.0,
            zz: s.squared() * self.xx + c.squared() * self.zz - s * c * self.xz * 2.0,
            xz: s * c * (self.zz - self.xx) + (c.squared() - s.squared()) * self.xz,
            ..self
        }
    }

    /// Two bodies like this, one on each side, with their centres at this distance in m from the plane of symmetry.
    pub fn on_both_sides(self, y: Uncertain<'a>) -> Self {
        let aside = self.mass * y.squared();
        Self {
            mass: self.mass * 2.0,
            xx: (self.xx + aside) * 2.0,
            yy: self.yy * 2.0,
            zz: (self.zz + aside) * 2.0,
            xz: self.xz * 2.0,
            ..self
        }
    }

    /// A box of uniform density with its extents in m along x, y and z, at the same place.
    pub fn of_box(self, [x, y, z]: [Uncertain<'a>; 3]) -> Self {
        let twelfth = self.mass / 12.0;
        let [x, y, z] = [x, y, z].map(Uncertain::squared);
        Self { xx: twelfth * (y + z), yy: twelfth * (x + z), zz: twelfth * (x + y), ..self }
    }

    /// A cylinder of uniform density, by its radius and its length in m along an axis: 0, 1 or 2 for x, y or z.
    pub fn of_cylinder(self, [radius, length]: [Uncertain<'a>; 2], axis: usize) -> Self {
        let axial = self.mass * radius.squared() / 2.0;
        let across = self.mass * (radius.squared() * 3.0 + length.squared()) / 12.0;
        let [xx, yy, zz] = [0, 1, 2].map(|direction| if direction == axis { axial } else { across });
        Self { xx, yy, zz, ..self }
    }

    /// A sphere of uniform density, by its radius in m.
    pub fn of_sphere(self, radius: Uncertain<'a>) -> Self {
        let any = self.mass * radius.squared() * 0.4;
        Self { xx: any, yy: any, zz: any, ..self }
    }
}
