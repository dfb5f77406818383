//! The forces that a motion takes: Kane's equations of the tree, reduced to the freedoms that rolling leaves.

use nalgebra::{DMatrix, DVector, Vector3};

use super::Mechanism;
use super::kinematics::{Kinematics, State, Touch};

/// What is free to choose of the motion of a mechanism, and the circumstances.
#[derive(Clone, Copy, Debug)]
pub struct Drive<const N: usize> {
    /// The places of the independent coordinates.
    pub independent: [usize; N],
    /// The place of the coordinate that runs at constant speed, if the mechanism runs.
    pub forward: Option<usize>,
    /// That speed.
    pub speed: f64,
    /// The strength of gravity, downward.
    pub gravity: f64,
}

/// A motion in which every coordinate is known: positions from the height of the wheels, the rest from rolling.
struct Followed {
    state: State,
    /// The places of the coordinates that follow.
    dependent: Vec<usize>,
    /// Their rates, by rows, for a unit rate of each independent coordinate.
    shares: DMatrix<f64>,
}

impl Mechanism {
    /// The generalized forces on the independent coordinates that a motion of them takes, given with its rates and
    /// accelerations.
    ///
    /// # Panics
    /// If rolling does not determine the other coordinates.
    pub fn forces<const N: usize>(&self, drive: &Drive<N>, motion: [[f64; N]; 3]) -> DVector<f64> {
        let Followed { state, dependent, shares } = self.follow(drive, motion);
        let forces = self.forces_on_the_tree(&state, drive.gravity);
        // In virtual displacements, too, the other coordinates follow; the forces of contact do no work in them.
        forces.select_rows(&drive.independent) + shares.tr_mul(&forces.select_rows(&dependent))
    }

    /// Kinetic energy, and potential energy of gravity and springs, in a motion of the independent coordinates.
    pub fn energy<const N: usize>(&self, drive: &Drive<N>, motion: [[f64; N]; 3]) -> f64 {
        let state = self.follow(drive, motion).state;
        let kinematics = Kinematics::new(self, &state);
        let springs = self.joints.iter().zip(&state.q).map(|(joint, q)| joint.stiffness * q * q / 2.0);
        let bodies = self.bodies.iter().map(|body| {
            let link = kinematics.link(body.joint);
            let centre = link.place(&body.centre);
            let spin = link.rotation().inverse() * link.spin;
            let kinetic = body.mass * link.velocity_at(&centre).norm_squared() + spin.dot(&(body.inertia * spin));
            kinetic / 2.0 - body.mass * drive.gravity * centre.z
        });
        springs.chain(bodies).sum()
    }

    /// All of a motion. Coordinates that follow by their rates alone are taken to be zero: yaw, lateral displacement and
    /// angles of wheels, whose values make no difference on level ground.
    fn follow<const N: usize>(&self, drive: &Drive<N>, [q, qd, qdd]: [[f64; N]; 3]) -> Followed {
        let given = |values: [f64; N]| {
            let mut all = DVector::zeros(self.joints.len());
            drive.independent.iter().zip(values).for_each(|(&place, value)| all[place] = value);
            all
        };
        let mut state = State { q: given(q), qd: given(qd), qdd: given(qdd) };
        if let Some(forward) = drive.forward {
            state.qd[forward] = drive.speed;
        }
        let dependent: Vec<usize> = (0..self.joints.len())
            .filter(|place| !drive.independent.contains(place) && drive.forward != Some(*place))
            .collect();

        self.stand(&mut state, &dependent);
        let rolling = self.rolling(&state);
        let by_dependent = rolling.select_columns(&dependent);
        let inverse = inverse(&by_dependent).expect("coordinates that follow from rolling");
        let against = |slip: DMatrix<f64>| {
            let rates = -&inverse * &slip;
            // Of more conditions than coordinates some follow from others, as for two wheels on one axle.
            let left = (&by_dependent * &rates + &slip).amax();
            assert!(
                left <= 1e-6 * slip.amax().max(1.0),
                "conditions of rolling that can all be met: {left} m/s of slip"
            );
            rates
        };
        let rates = against(self.touches(&state, |touch| touch.slip));
        put(&mut state.qd, &dependent, rates);
        let accelerations = against(self.touches(&state, |touch| touch.slip_rate));
        put(&mut state.qdd, &dependent, accelerations);
        let shares = against(rolling.select_columns(&drive.independent));
        Followed { state, dependent, shares }
    }

    /// Moves the dependent coordinates, and no more than it takes, until every wheel touches the ground.
    fn stand(&self, state: &mut State, dependent: &[usize]) {
        let vertical: Vec<usize> = (0..self.contacts.len()).map(|contact| 3 * contact + 2).collect();
        let heights = |state: &State| self.touches(state, |touch| touch.place).select_rows(&vertical);
        // Newton's method, which is at the last digit after one step from 1e-4 rad, and after two from half a radian.
        for _ in 0..3 {
            // A wheel's lowest point goes up and down as the material point there does.
            let slopes = self.rolling(state).select_columns(dependent).select_rows(&vertical);
            let normal = (&slopes * slopes.transpose()).cholesky().expect("wheels that can all touch the ground");
            let step = slopes.tr_mul(&normal.solve(&heights(state)));
            dependent.iter().zip(&step).for_each(|(&place, step)| state.q[place] -= step);
        }
        assert!(heights(state).iter().all(|height| height.abs() < 1e-12), "wheels that can all touch the ground");
    }

    /// A vector of each contact, one below the other.
    fn touches(&self, state: &State, vector: impl Fn(&Touch) -> Vector3<f64>) -> DMatrix<f64> {
        let kinematics = Kinematics::new(self, state);
        let vectors = self.contacts.iter().map(|contact| vector(&kinematics.touch(contact)));
        let entries: Vec<f64> = vectors.flat_map(|vector| [vector.x, vector.y, vector.z]).collect();
        DMatrix::from_vec(entries.len(), 1, entries)
    }

    /// The slip velocities of all contacts by the rate of each coordinate.
    fn rolling(&self, state: &State) -> DMatrix<f64> {
        let kinematics = Kinematics::new(self, state);
        let mut rolling = DMatrix::zeros(3 * self.contacts.len(), self.joints.len());
        for (row, contact) in self.contacts.iter().enumerate() {
            for partial in kinematics.partials(contact.joint, kinematics.touch(contact).place) {
                rolling.fixed_view_mut::<3, 1>(3 * row, partial.coordinate).copy_from(&partial.velocity);
            }
        }
        rolling
    }

    /// The generalized forces on every coordinate that its motion takes without the forces of contact.
    fn forces_on_the_tree(&self, state: &State, gravity: f64) -> DVector<f64> {
        let kinematics = Kinematics::new(self, state);
        let mut forces = DVector::from_fn(self.joints.len(), |place, _| {
            self.joints[place].stiffness * state.q[place] + self.joints[place].damping * state.qd[place]
        });
        for body in &self.bodies {
            let link = kinematics.link(body.joint);
            let centre = link.place(&body.centre);
            let force = (link.acceleration_at(&centre) - Vector3::z() * gravity) * body.mass;
            let rotation = link.rotation().to_rotation_matrix();
            let inertia = rotation * body.inertia * rotation.transpose();
            let moment = inertia * link.spin_rate + link.spin.cross(&(inertia * link.spin));
            for partial in kinematics.partials(body.joint, centre) {
                forces[partial.coordinate] += partial.velocity.dot(&force) + partial.spin.dot(&moment);
            }
        }
        forces
    }
}

/// What solves equations, of which there may be more than unknowns; none if they leave an unknown open.
fn inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    const SMALL: f64 = 1e-9;
    match matrix.is_square() {
        true => matrix.clone().try_inverse(),
        false if matrix.rank(SMALL) < matrix.ncols() => None,
        false => matrix.clone().pseudo_inverse(SMALL).ok(),
    }
}

fn put(all: &mut DVector<f64>, places: &[usize], values: DMatrix<f64>) {
    places.iter().zip(&values).for_each(|(&place, &value)| all[place] = value);
}
