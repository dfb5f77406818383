//! Many designs by all cores, in more than two parts: each must be what one core makes of it, which `batch` and the others that
//! begin with it hold against what it is alone.

use carvallo::batch::{Arrival, Batch, Blocks, Ensemble, InLanes, Limit};
use carvallo::{Matrix, Model, Nonlinear, Stability, System, SystemError};
use carvallo_models::{Whipple, WhippleMechanism};
use carvallo_tests::designs;

/// More than two parts of any kind, the last of which is not whole.
const MANY: usize = 1301;

fn bicycles() -> Vec<Whipple> {
    (0..MANY as u64).map(designs::numbered).collect()
}

#[test]
fn derivatives() {
    let parameters = Blocks::of_designs(&bicycles());
    let [mut entries, mut again] = [(); 2].map(|()| Blocks::for_entries::<2, Whipple>(MANY));
    let [mut one, mut all] = [(); 2].map(|()| Blocks::for_derivatives::<2, Whipple>(MANY));
    Batch::new().jacobians::<2, Whipple>(&parameters, &mut entries, &mut one).unwrap();
    Batch::new().parallel_jacobians::<2, Whipple>(&parameters, &mut again, &mut all).unwrap();
    assert_eq!((entries, one), (again, all));
    let mut few = Blocks::for_derivatives::<2, Whipple>(MANY - 1);
    let mut entries = Blocks::for_entries::<2, Whipple>(MANY);
    let error = Batch::new().jacobians::<2, Whipple>(&parameters, &mut entries, &mut few);
    assert_eq!(Batch::new().parallel_jacobians::<2, Whipple>(&parameters, &mut entries, &mut few), error);
    assert!(error.is_err());
}

/// Bicycles with different riders, leaning and rolling.
fn rides<T: InLanes>() -> (Vec<WhippleMechanism<T>>, Blocks<T>) {
    let mut states = Blocks::for_states::<2, WhippleMechanism<T>>(MANY);
    let design = |ride: usize| {
        let share = T::from_f64(ride as f64 / MANY as f64);
        states.set(ride, 3, share * T::from_f64(0.2));
        states.set(ride, 8, T::from_f64(0.5) - share);
        states.set(ride, 10, T::from_f64(-10.0));
        let bicycle = WhippleMechanism::BENCHMARK.cast::<T>();
        WhippleMechanism { mB: bicycle.mB * (T::from_f64(1.0) + share), ..bicycle }
    };
    ((0..MANY).map(design).collect(), states)
}

fn equations<T: InLanes>()
where
    WhippleMechanism<T>: Nonlinear<2, Scalar = T>,
{
    let (designs, states) = rides::<T>();
    for parameters in [Blocks::of_designs(&designs), Blocks::of_designs(&designs[..1])] {
        let [mut one, mut all] = [(); 2].map(|()| Blocks::for_accelerations::<2, WhippleMechanism<T>>(MANY));
        Batch::new().accelerations::<2, WhippleMechanism<T>>(&parameters, &states, &mut one).unwrap();
        Batch::new().parallel_accelerations::<2, WhippleMechanism<T>>(&parameters, &states, &mut all).unwrap();
        assert_eq!(one, all);
        let [mut one, mut all] = [(); 2].map(|()| Blocks::for_motion_derivatives::<2, WhippleMechanism<T>>(MANY));
        Batch::new().motion_derivatives::<2, WhippleMechanism<T>>(&parameters, &states, &mut one).unwrap();
        Batch::new().parallel_motion_derivatives::<2, WhippleMechanism<T>>(&parameters, &states, &mut all).unwrap();
        assert_eq!(one, all);
        assert_ne!(one.get(MANY - 1, 8), one.get(MANY - 2, 8));
    }
}

#[test]
fn equations_of_motion() {
    equations::<f64>();
    equations::<f32>();
}

#[test]
fn motions() {
    let limits = [Limit::symmetric(3, 0.12)];
    let ensemble = Ensemble { duration: 0.1, tolerance: 1e-6, limits: &limits };
    let (designs, states) = rides::<f64>();
    let parameters = Blocks::of_designs(&designs);
    let [mut one, mut all] = [states.clone(), states];
    let [mut outcomes, mut again] = [(); 2].map(|()| vec![Ok(Arrival::Reached); MANY]);
    Batch::new().simulate::<2, WhippleMechanism>(&ensemble, &parameters, &mut one, &mut outcomes).unwrap();
    Batch::new().parallel_simulate::<2, WhippleMechanism>(&ensemble, &parameters, &mut all, &mut again).unwrap();
    assert_eq!((one, &outcomes), (all, &again));
    assert!(outcomes.contains(&Ok(Arrival::Reached)) && outcomes.iter().any(|end| *end != Ok(Arrival::Reached)));
}

#[test]
fn eigenvalues() {
    let at = |(number, bicycle): (usize, Whipple)| {
        let system = bicycle.coefficients().at(0.005 * number as f64, bicycle.g).expect("a system");
        // One in a hundred has none.
        if number % 100 == 99 { System::new(system.m * 0.0, system.c, system.k) } else { system }
    };
    let systems: Vec<System<2>> = bicycles().into_iter().enumerate().map(at).collect();
    let [mut one, mut all] = [(); 2].map(|()| vec![Ok(Default::default()); MANY]);
    Batch::new().eigenvalues(&systems, &mut one).unwrap();
    Batch::new().parallel_eigenvalues(&systems, &mut all).unwrap();
    assert_eq!(format!("{one:?}"), format!("{all:?}"));
    assert!(one[99].is_err() && one[MANY - 1].is_ok());
    let error = Batch::new().parallel_eigenvalues(&systems, &mut all[1..]);
    assert_eq!(error, Batch::new().eigenvalues(&systems, &mut one[1..]));
    assert!(error.is_err());
}

#[test]
fn eigenvalues_of_three_coordinates() {
    let of = |number: usize| {
        let (share, one) = (0.1 + number as f64, Matrix::<f64, 3>::identity());
        let springs = Matrix::<f64, 3>::new(9.0, -1.0, 0.0, -1.0, 5.0, -1.0, 0.0, -1.0, share);
        System::new(one, one * 0.3, springs)
    };
    let systems: Vec<System<3>> = (0..MANY).map(of).collect();
    let [mut one, mut all] = [(); 2].map(|()| vec![Ok(Vec::new()); MANY]);
    Batch::new().eigenvalues_of_any(&systems, &mut one).unwrap();
    Batch::new().parallel_eigenvalues_of_any(&systems, &mut all).unwrap();
    assert_eq!(one, all);
    assert_eq!(all[MANY - 1], systems[MANY - 1].eigenvalues());
}

#[test]
fn critical_speeds() {
    let bicycles = bicycles();
    let coefficients: Vec<_> = bicycles.iter().map(Model::coefficients).collect();
    let gravity: Vec<f64> = bicycles.iter().map(|bicycle| bicycle.g).collect();
    let mut found = vec![Err(SystemError::AtRest); MANY];
    Batch::new().parallel_stability(&coefficients, &gravity, &mut found).unwrap();
    for ((coefficients, gravity), found) in coefficients.iter().zip(&gravity).zip(&found) {
        assert_eq!(*found, Stability::new(coefficients, *gravity));
    }
    assert!(Batch::new().parallel_stability(&coefficients, &gravity[1..], &mut found).is_err());
}
