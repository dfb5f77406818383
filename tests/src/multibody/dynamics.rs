//! The forces that a motion takes: Kane's equations of the tree, reduced to the freedoms that rolling leaves.

use nalgebra::{DMatrix, DVector, SMatrix, SVector, Vector3};

use super::kinematics::{Kinematics, State};
use super::{Mechanism, Root};

/// What is free to choose of the motion of a mechanism, and the circumstances.
#[derive(Clone, Copy, Debug)]
pub struct Drive<const N: usize> {
    /// The places of the coordinates that are described.
    pub independent: [usize; N],
    /// Those of them that are free in position alone, since the wheels determine their rates.
    pub following: [bool; N],
    /// The place of the coordinate that runs at constant speed, if the mechanism runs; as one of the independent
    /// coordinates it varies about that.
    pub forward: Option<usize>,
    /// The root whose forward and lateral rates are along axes that yaw with it; without one they are along fixed axes.
    pub axes: Option<Root>,
    /// That speed.
    pub speed: f64,
    /// The strength of gravity, downward.
    pub gravity: f64,
}

impl<const N: usize> Drive<N> {
    /// What rests, without gravity, and is described in coordinates that are free and along fixed axes.
    pub fn new(independent: [usize; N], forward: Option<usize>) -> Self {
        Self { independent, following: [false; N], forward, axes: None, speed: 0.0, gravity: 0.0 }
    }

    /// The coordinates that are free in rates and accelerations.
    fn free(&self) -> Vec<usize> {
        let pairs = self.independent.iter().zip(self.following);
        pairs.filter(|(_, follows)| !follows).map(|(place, _)| *place).collect()
    }

    /// The rates of all coordinates by the speeds that describe the motion, and how that changes.
    fn rates_by_speeds(&self, count: usize, heading: f64, turning: f64) -> [DMatrix<f64>; 2] {
        let [mut rates, mut change] = [DMatrix::identity(count, count), DMatrix::zeros(count, count)];
        if let Some(Root { x, y, .. }) = self.axes {
            let (sin, cos) = heading.sin_cos();
            for (row, column, entry, slope) in
                [(x, x, cos, -sin), (x, y, -sin, -cos), (y, x, sin, cos), (y, y, cos, -sin)]
            {
                rates[(row, column)] = entry;
                change[(row, column)] = slope * turning;
            }
        }
        [rates, change]
    }
}

/// A motion in which every coordinate is known: positions from the height of the wheels, the rest from rolling.
struct Followed {
    state: State,
    /// The rates of all coordinates by the speeds that describe the motion.
    rates_by_speeds: DMatrix<f64>,
    /// Those speeds.
    speeds: DVector<f64>,
    /// The places of the coordinates whose speeds follow.
    dependent: Vec<usize>,
    /// Their speeds, by rows, for a unit speed of each free coordinate.
    shares: DMatrix<f64>,
}

/// What the contacts require, a row for each direction in which one does not slip.
struct Rolling {
    /// The slip velocities by the rate of each coordinate.
    by_rates: DMatrix<f64>,
    /// The slip velocities.
    slips: DVector<f64>,
    /// Their time derivatives.
    slip_rates: DVector<f64>,
}

impl Mechanism {
    /// The generalized forces on the independent coordinates that a motion of them takes, given with its rates and
    /// accelerations. Of a coordinate that follows it is by how much its rate is not the one that the wheels give it.
    ///
    /// # Panics
    /// If rolling does not determine the other coordinates.
    pub fn forces<const N: usize>(&self, drive: &Drive<N>, motion: [[f64; N]; 3]) -> DVector<f64> {
        let Followed { state, rates_by_speeds, speeds, dependent, shares } = self.follow(drive, motion);
        let taken = self.forces_on_the_tree(&state, drive.gravity) - self.preloads(drive);
        let forces = rates_by_speeds.tr_mul(&taken);
        // In virtual displacements, too, the other coordinates follow; the forces of contact do no work in them.
        let free = drive.free();
        let reduced = forces.select_rows(&free) + shares.tr_mul(&forces.select_rows(&dependent));
        DVector::from_fn(N, |index, _| {
            let place = drive.independent[index];
            match free.iter().position(|free| *free == place) {
                Some(position) => reduced[position],
                None => motion[1][index] - speeds[place],
            }
        })
    }

    /// The accelerations of the independent coordinates in a state, and under forces on them.
    ///
    /// # Panics
    /// As [`Mechanism::forces`]; or if a coordinate moves nothing.
    pub fn accelerations<const N: usize>(
        &self,
        drive: &Drive<N>,
        [q, qd]: [[f64; N]; 2],
        applied: [f64; N],
    ) -> SVector<f64, N> {
        // Forces are linear in accelerations.
        let taken = |qdd: [f64; N]| SVector::<f64, N>::from_column_slice(self.forces(drive, [q, qd, qdd]).as_slice());
        let still = taken([0.0; N]);
        let mass = SMatrix::<f64, N, N>::from_columns(&std::array::from_fn::<_, N, _>(|place| {
            taken(std::array::from_fn(|other| f64::from(u8::from(other == place)))) - still
        }));
        mass.try_inverse().expect("a mass matrix") * (SVector::from(applied) - still)
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
        let count = self.joints.len();
        let free = drive.free();
        let given = |values: [f64; N], places: &[usize]| {
            let mut all = DVector::zeros(count);
            let pairs = drive.independent.iter().zip(values).filter(|(place, _)| places.contains(place));
            pairs.for_each(|(&place, value)| all[place] = value);
            all
        };
        let mut state =
            State { q: given(q, &drive.independent), qd: DVector::zeros(count), qdd: DVector::zeros(count) };
        let mut speeds = given(qd, &free);
        if let Some(forward) = drive.forward {
            speeds[forward] += drive.speed;
        }
        let dependent: Vec<usize> =
            (0..count).filter(|place| !free.contains(place) && drive.forward != Some(*place)).collect();
        let standing: Vec<usize> =
            dependent.iter().copied().filter(|place| !drive.independent.contains(place)).collect();

        self.stand(&mut state, &standing);
        let heading = drive.axes.map_or(0.0, |root| state.q[root.yaw]);
        let [rates_by_speeds, _] = drive.rates_by_speeds(count, heading, 0.0);
        state.qd = &rates_by_speeds * &speeds;
        let Rolling { by_rates, slips, .. } = self.rolling(&state);
        let by_speeds = by_rates * &rates_by_speeds;
        let by_dependent = by_speeds.select_columns(&dependent);
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
        let column = |slips: DVector<f64>| DMatrix::from_column_slice(slips.len(), 1, slips.as_slice());
        put(&mut speeds, &dependent, against(column(slips)));
        let turning = drive.axes.map_or(0.0, |root| speeds[root.yaw]);
        let [_, change] = drive.rates_by_speeds(count, heading, turning);
        state.qd = &rates_by_speeds * &speeds;
        let mut accelerations = given(qdd, &free);
        state.qdd = &rates_by_speeds * &accelerations + &change * &speeds;
        put(&mut accelerations, &dependent, against(column(self.rolling(&state).slip_rates)));
        state.qdd = &rates_by_speeds * &accelerations + &change * &speeds;
        let shares = against(by_speeds.select_columns(&free));
        Followed { state, rates_by_speeds, speeds, dependent, shares }
    }

    /// What springs at coordinates that follow hold in the reference configuration, where the wheels bear the rest. As the
    /// rates of these coordinates are shared out in another way after a displacement, it matters where that is held.
    fn preloads<const N: usize>(&self, drive: &Drive<N>) -> DVector<f64> {
        let count = self.joints.len();
        let zero = DVector::zeros(count);
        let state = State { q: zero.clone(), qd: zero.clone(), qdd: zero };
        let mut preloads = DVector::zeros(count);
        let following = drive.independent.iter().zip(drive.following).filter(|(_, follows)| *follows);
        let following: Vec<usize> = following.map(|(place, _)| *place).collect();
        if following.is_empty() {
            return preloads;
        }
        let standing: Vec<usize> = (0..count).filter(|place| !drive.independent.contains(place)).collect();
        let slopes = self.slopes(&state);
        let lifted = lift(&slopes.select_columns(&standing), &slopes.select_columns(&following));
        let kinematics = Kinematics::new(self, &state);
        let mut weights = DVector::zeros(count);
        for body in &self.bodies {
            for partial in kinematics.partials(body.joint, body.centre) {
                weights[partial.coordinate] -= partial.velocity.z * body.mass * drive.gravity;
            }
        }
        let held = weights.select_rows(&following) - lifted.tr_mul(&weights.select_rows(&standing));
        following.iter().zip(&held).for_each(|(place, held)| preloads[*place] = *held);
        preloads
    }

    /// The heights of the lowest points of the wheels by the rates of all coordinates: they go up and down as the material
    /// points there do.
    fn slopes(&self, state: &State) -> DMatrix<f64> {
        let kinematics = Kinematics::new(self, state);
        let mut slopes = DMatrix::zeros(self.contacts.len(), self.joints.len());
        for (row, contact) in self.contacts.iter().enumerate() {
            for partial in kinematics.partials(contact.joint, kinematics.touch(contact).place) {
                slopes[(row, partial.coordinate)] = partial.velocity.z;
            }
        }
        slopes
    }

    /// Moves coordinates, and no more than it takes, until every wheel touches the ground.
    fn stand(&self, state: &mut State, standing: &[usize]) {
        let heights = |state: &State| {
            let kinematics = Kinematics::new(self, state);
            let heights = self.contacts.iter().map(|contact| kinematics.touch(contact).place.z - contact.ground);
            DMatrix::from_iterator(self.contacts.len(), 1, heights)
        };
        // Newton's method, which is at the last digit after one step from 1e-4 rad, and after two from half a radian; of wheels that do
        // not stand on the ground in the reference configuration after a few more.
        for _ in 0..6 {
            let step = lift(&self.slopes(state).select_columns(standing), &heights(state));
            standing.iter().zip(&step).for_each(|(&place, step)| state.q[place] -= step);
        }
        assert!(heights(state).iter().all(|height| height.abs() < 1e-12), "wheels that can all touch the ground");
    }

    /// What the contacts require: that a wheel slips nowhere, or, on a tyre that slips, neither along it nor vertically.
    fn rolling(&self, state: &State) -> Rolling {
        let kinematics = Kinematics::new(self, state);
        let (mut rows, mut slips, mut slip_rates) = (Vec::new(), Vec::new(), Vec::new());
        for contact in &self.contacts {
            let touch = kinematics.touch(contact);
            let still = Vector3::zeros();
            let mut directions = vec![(touch.heading, touch.heading_rate), (Vector3::z(), still)];
            if contact.slip.is_none() {
                directions.push((Vector3::z().cross(&touch.heading), Vector3::z().cross(&touch.heading_rate)));
            }
            for (direction, rate) in directions {
                let mut row = DVector::zeros(self.joints.len());
                for partial in kinematics.partials(contact.joint, touch.place) {
                    row[partial.coordinate] = direction.dot(&partial.velocity);
                }
                rows.push(row.transpose());
                slips.push(direction.dot(&touch.slip));
                slip_rates.push(direction.dot(&touch.slip_rate) + rate.dot(&touch.slip));
            }
        }
        let by_rates = if rows.is_empty() { DMatrix::zeros(0, self.joints.len()) } else { DMatrix::from_rows(&rows) };
        Rolling { by_rates, slips: DVector::from_vec(slips), slip_rates: DVector::from_vec(slip_rates) }
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
        self.add_loads(state, &kinematics, &mut forces);
        forces
    }
}

/// The least of what lifts wheels as far as given, by columns.
fn lift(slopes: &DMatrix<f64>, heights: &DMatrix<f64>) -> DMatrix<f64> {
    let normal = (slopes * slopes.transpose()).cholesky().expect("wheels that can all touch the ground");
    slopes.tr_mul(&normal.solve(heights))
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
