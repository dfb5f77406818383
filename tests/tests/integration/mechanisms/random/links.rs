//! Joints with bodies, at random.

use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;

/// A joint with its body.
#[derive(Clone, Debug)]
pub struct Link {
    /// Which of the bodies before it carries it.
    pub on: prop::sample::Index,
    pub slides: bool,
    pub point: Vector3<f64>,
    pub axis: Vector3<f64>,
    pub stiffness: f64,
    pub damping: f64,
    pub mass: f64,
    pub centre: Vector3<f64>,
    pub moments: [f64; 3],
    /// The rotation by which the body's own axes are turned.
    pub turned: Vector3<f64>,
}

impl Link {
    pub fn inertia(&self) -> Matrix3<f64> {
        let rotation = nalgebra::Rotation3::new(self.turned);
        let turned = rotation * Matrix3::from_diagonal(&Vector3::from(self.moments)) * rotation.inverse();
        // Exactly symmetric, so that both sides are one parameter.
        Matrix3::from_fn(|row, column| turned[(row.min(column), row.max(column))])
    }

    /// The same in a mechanism that is its own mirror image: in the plane y = 0 but for slides across it.
    pub fn in_plane(mut self) -> Self {
        let plane = |vector: Vector3<f64>| Vector3::new(vector.x, 0.0, vector.z);
        self.axis = if self.slides { Vector3::y() } else { plane(self.axis) };
        self.point = plane(self.point);
        self.centre = plane(self.centre);
        self.turned = Vector3::new(0.0, self.turned.y, 0.0);
        self
    }
}

pub fn vector(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    [-size..size, -size..size, -size..size].prop_map(Vector3::from)
}

pub fn link() -> impl Strategy<Value = Link> {
    let place = (any::<prop::sample::Index>(), prop::bool::weighted(0.3), vector(1.0), vector(1.0));
    let held = (0.0..50.0, 0.0..5.0, 0.5..20.0, vector(1.0));
    let moments = ([0.1..2.0, 0.1..2.0, 0.1..2.0], vector(1.0));
    (place, held, moments)
        .prop_map(|((on, slides, point, axis), (stiffness, damping, mass, centre), (moments, turned))| Link {
            on,
            slides,
            point,
            axis,
            stiffness,
            damping,
            mass,
            centre,
            moments,
            turned,
        })
        .prop_filter("a direction", |link| link.axis.x.abs() > 0.1 && link.axis.z.abs() > 0.1)
}
