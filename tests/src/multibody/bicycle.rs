//! The bicycle as a mechanism: four bodies, of which none knows the formulas.

use carvallo_models::Whipple;
use nalgebra::{Matrix3, Vector3};

use super::{Body, Joint, Mechanism, Root, Wheel};

/// A bicycle as a mechanism, with the places of its coordinates.
#[derive(Clone, Debug)]
pub struct Bicycle {
    /// Its joints, bodies and contacts.
    pub mechanism: Mechanism,
    /// The freedoms of the rear frame; the origin is where the rear wheel touches the ground.
    pub root: Root,
    /// Steer of the front frame relative to the rear frame.
    pub steer: usize,
    /// Angle of the rear wheel relative to the rear frame.
    pub rear_wheel: usize,
    /// Angle of the front wheel relative to the front frame.
    pub front_wheel: usize,
    /// Lean of the rider's upper body relative to the rear frame.
    pub rider: Option<usize>,
}

/// What a bicycle has beyond the Whipple model; by default nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Extras {
    /// Radius of the cross-section of the rear tyre, part of the wheel's radius.
    pub rear_tyre: f64,
    /// The same of the front tyre.
    pub front_tyre: f64,
    /// Stiffness between the frames.
    pub steer_stiffness: f64,
    /// Damping between the frames.
    pub steer_damping: f64,
    /// The upper body of a rider, apart from the rear frame.
    pub rider: Option<Rider>,
}

/// An upper body that leans on the rear frame, about an axis along x.
#[derive(Clone, Copy, Debug)]
pub struct Rider {
    /// Mass.
    pub mass: f64,
    /// Centre of mass, forward and downward.
    pub centre: [f64; 2],
    /// Moments of inertia xx, yy, zz and xz about the centre of mass.
    pub inertia: [f64; 4],
    /// A point on the axis, forward and downward.
    pub joint: [f64; 2],
    /// Stiffness of the joint.
    pub stiffness: f64,
    /// Damping of the joint.
    pub damping: f64,
}

impl Bicycle {
    /// The mechanism that the parameters of the Whipple model describe, and what it has beyond that.
    pub fn new(design: &Whipple, extras: &Extras) -> Self {
        let &Whipple { w, c, lam, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IByy, IBzz, IBxz, .. } = design;
        let &Whipple { xH, zH, mH, IHxx, IHyy, IHzz, IHxz, rF, mF, IFxx, IFyy, .. } = design;
        let mut mechanism = Mechanism::default();
        let root = mechanism.free_root();
        let frame = root.pitch;
        mechanism.body(symmetric(frame, mB, [xB, zB], [IBxx, IByy, IBzz, IBxz]));

        // The steer axis leans back by lam, and meets the ground ahead of the front contact by the trail.
        let axis = Vector3::new(lam.sin(), 0.0, lam.cos());
        let hinge = Joint::revolute(Some(frame), Vector3::new(w + c, 0.0, 0.0), axis);
        let steer = mechanism.joint(hinge.sprung(extras.steer_stiffness, extras.steer_damping));
        mechanism.body(symmetric(steer, mH, [xH, zH], [IHxx, IHyy, IHzz, IHxz]));

        let (x, radius, tyre) = (0.0, rR, extras.rear_tyre);
        let rear = Wheel { carrier: frame, x, y: 0.0, radius, tyre, mass: mR, axial: IRyy, transverse: IRxx };
        let (x, radius, tyre) = (w, rF, extras.front_tyre);
        let front = Wheel { carrier: steer, x, y: 0.0, radius, tyre, mass: mF, axial: IFyy, transverse: IFxx };
        let (rear_wheel, front_wheel) = (mechanism.wheel(rear), mechanism.wheel(front));

        let rider = extras.rider.map(|rider| {
            let [x, z] = rider.joint;
            let hinge = Joint::revolute(Some(frame), Vector3::new(x, 0.0, z), Vector3::x());
            let lean = mechanism.joint(hinge.sprung(rider.stiffness, rider.damping));
            mechanism.body(symmetric(lean, rider.mass, rider.centre, rider.inertia));
            lean
        });
        Self { mechanism, root, steer, rear_wheel, front_wheel, rider }
    }
}

/// A body that is symmetric left to right, by its centre x, z and its moments xx, yy, zz, xz.
fn symmetric(joint: usize, mass: f64, [x, z]: [f64; 2], [xx, yy, zz, xz]: [f64; 4]) -> Body {
    let inertia = Matrix3::new(xx, 0.0, xz, 0.0, yy, 0.0, xz, 0.0, zz);
    Body { joint, mass, centre: Vector3::new(x, 0.0, z), inertia }
}
