//! What follows from a mechanism beside its matrices.

/// Rates of joints and forces on coordinates, with formulas of type `V`.
#[derive(Debug)]
pub struct Kinematics<V> {
    /// The bodies and wheels, each with what it is.
    pub parts: Vec<String>,
    /// Of joints that are no coordinates.
    pub rates: Vec<Rate<V>>,
    /// The forces that may be applied.
    pub applied: Vec<Applied>,
    /// For each coordinate, by applied force.
    pub forces: Vec<Vec<V>>,
}

/// A force or torque that may be applied.
#[derive(Clone, Debug)]
pub struct Applied {
    pub name: String,
    /// What it is.
    pub label: String,
    pub unit: String,
    /// The position that it acts on.
    pub position: String,
}

/// A rate `v speed + rates · q' + v (coordinates · q + heading psi)`, with the yaw psi where that is no coordinate.
#[derive(Debug)]
pub struct Rate<V> {
    /// The name of its field in generated code.
    pub name: String,
    /// What it is.
    pub docs: String,
    /// The rate in steady motion, divided by v.
    pub speed: V,
    /// For each coordinate.
    pub rates: Vec<V>,
    /// For each coordinate.
    pub coordinates: Vec<V>,
    /// For the yaw.
    pub heading: V,
}

impl<V> Kinematics<V> {
    /// The same with other formulas, taken one by one in a fixed order.
    pub fn map<W>(&self, mut f: impl FnMut(&V) -> W) -> Kinematics<W> {
        let rates = self.rates.iter().map(|rate| Rate {
            name: rate.name.clone(),
            docs: rate.docs.clone(),
            speed: f(&rate.speed),
            rates: rate.rates.iter().map(&mut f).collect(),
            coordinates: rate.coordinates.iter().map(&mut f).collect(),
            heading: f(&rate.heading),
        });
        let rates = rates.collect();
        let forces = self.forces.iter().map(|row| row.iter().map(&mut f).collect()).collect();
        Kinematics { parts: self.parts.clone(), rates, applied: self.applied.clone(), forces }
    }

    /// Whether nothing moves or acts beside the coordinates.
    pub fn is_empty(&self) -> bool {
        self.rates.is_empty() && self.applied.is_empty()
    }

    /// All formulas, in the order of [`Kinematics::map`].
    pub fn formulas(&self) -> impl Iterator<Item = &V> {
        let rates = self.rates.iter().flat_map(|rate| {
            [&rate.speed].into_iter().chain(&rate.rates).chain(&rate.coordinates).chain([&rate.heading])
        });
        rates.chain(self.forces.iter().flatten())
    }
}
