//! Mechanisms with one wrong attribute: the matrices are those of a derivation that has it, and `carvallo check` names it.

use carvallo::{Coefficients, MatrixName, Model as _, ModelInfo};
use carvallo_check::check_machine;
use carvallo_check::given::{Given, Reading};
use carvallo_check::machine::Machine;
use carvallo_models::{DoublePendulum, RearSteered, RollingDisc, Whipple, WhippleMechanism};
use carvallo_slips::{Formulas, Subject};
use carvallo_tests::multibody::bicycle::{Bicycle, Extras};
use carvallo_tests::multibody::{Mechanism, Root, Wheel};
use carvallo_tests::textbook::pendulum::{Link, standing_at_hinges};

const BICYCLE: &ModelInfo = WhippleMechanism::<f64>::INFO;

fn rows<const N: usize>(own: &Coefficients<f64, N>) -> [[[f64; N]; N]; 8] {
    let matrices = [own.m, own.cm1, own.c0, own.c1, own.kc, own.k0, own.k1, own.k2];
    matrices.map(|matrix| std::array::from_fn(|row| std::array::from_fn(|column| matrix[(row, column)])))
}

/// Whether a check of the matrices of a machine, with nine digits, tells in its first group that this is the cause.
#[track_caller]
fn assert_named<const N: usize>(info: &'static ModelInfo, parameters: &[f64], own: &Coefficients<f64, N>, cause: &str) {
    let reading = |value: f64, largest: f64| {
        // Differences leave rounding where there is nothing.
        Some(if value.abs() <= 1e-10 * largest { Reading::rounded(0.0, 9) } else { Reading::rounded(value, 9) })
    };
    let matrices = MatrixName::ALL.into_iter().zip(rows(own)).filter(|(name, _)| info.matrices.contains(name));
    let matrices = matrices.map(|(name, rows)| {
        let largest = rows.iter().flatten().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
        (name, rows.map(|row| row.map(|entry| reading(entry, largest)).to_vec()).to_vec())
    });
    let given = Given { matrices: matrices.collect(), ..Given::default() };
    let machine = Machine::with(info, parameters).expect("formulas that can be read");
    let report = check_machine(&given, &machine).expect("a check");
    let first = report.explanations.first().unwrap_or_else(|| panic!("nothing explains {cause}:\n{report}"));
    assert!(first.explanations.iter().any(|own| own.causes == [cause]), "{cause} is not first:\n{report}");
}

/// The benchmark bicycle by nonlinear dynamics, with something about its mechanism changed.
fn bicycle(change: impl Fn(&mut Mechanism, usize)) -> Coefficients<f64, 2> {
    let mut bicycle = Bicycle::new(&Whipple::BENCHMARK, &Extras::default());
    change(&mut bicycle.mechanism, bicycle.steer);
    bicycle.mechanism.linearized([bicycle.root.lean, bicycle.steer], Some(bicycle.root.x))
}

/// Rear frame, front frame, rear and front wheel.
const BODIES: [&str; 4] = ["frame and rider B", "front frame H", "rear wheel R", "front wheel F"];

/// Multiplies an attribute of the bicycle, as it is called, by a factor.
pub fn scale(mechanism: &mut Mechanism, steer: usize, what: &str, factor: f64) {
    let axis = ["x of", "y of", "z of"].iter().position(|axis| what.starts_with(axis)).unwrap_or_default();
    if what.ends_with("joint delta") {
        let joint = &mut mechanism.joints[steer];
        if what.contains("axis") {
            joint.axis[axis] *= factor;
            joint.axis.normalize_mut();
        } else {
            joint.point[axis] *= factor;
        }
        return;
    }
    let at = BODIES.iter().position(|name| what.ends_with(name)).expect("a body");
    let body = &mut mechanism.bodies[at];
    let mut scaled = |places: &[(usize, usize)]| places.iter().for_each(|place| body.inertia[*place] *= factor);
    match what.split(" of ").next().unwrap_or_default() {
        "the mass" => body.mass *= factor,
        "the inertia xx" => scaled(&[(0, 0)]),
        "the inertia xz" => scaled(&[(0, 2), (2, 0)]),
        "the inertia yy" => scaled(&[(1, 1)]),
        "the inertia zz" => scaled(&[(2, 2)]),
        "the radius" => mechanism.contacts[at - 2].radius *= factor,
        "the axial inertia" => scaled(&[(1, 1)]),
        "the radial inertia" => scaled(&[(0, 0), (2, 2)]),
        _ => {
            body.centre[axis] *= factor;
            if let Some(contact) = at.checked_sub(2).map(|wheel| &mut mechanism.contacts[wheel]) {
                contact.centre[axis] *= factor;
                mechanism.joints[contact.joint].point[axis] *= factor;
            }
        }
    }
}

/// Lets each wheel roll on a step of its own that it touches.
fn step_up(mechanism: &mut Mechanism) {
    for contact in &mut mechanism.contacts {
        contact.ground = contact.centre.z + contact.radius;
    }
}

/// Every attribute, a tenth larger: the formulas by attributes make what the dynamics of that mechanism make. A wheel that is higher, or
/// larger, without anything else rolls on a step of its own.
#[test]
fn the_matrices_with_any_other_attribute_are_those_of_that_bicycle() {
    let parameters = WhippleMechanism::<f64>::BENCHMARK.to_array();
    let formulas = Formulas::with_attributes(BICYCLE, BICYCLE.attributes).expect("formulas that can be read");
    let right = formulas.values(&parameters);
    let mut attributes = 0;
    for (at, formula) in formulas.formulas.iter().enumerate() {
        let Subject::Attribute(what) = formula.subject else { continue };
        let changed = formulas.parse(at, &format!("1.1*({})", formula.text)).expect("a formula");
        let mut found = right.clone();
        formulas.change(&[at], &changed, &parameters, &mut found);
        let expected = rows(&bicycle(|mechanism, steer| {
            scale(mechanism, steer, what, 1.1);
            step_up(mechanism);
        }));
        let expected: Vec<f64> = expected.into_iter().flatten().flatten().collect();
        for (own, expected) in found.entries.chunks(4).zip(expected.chunks(4)) {
            let largest = expected.iter().fold(1.0, |largest: f64, entry| largest.max(entry.abs()));
            let is_same = own.iter().zip(expected).all(|(a, b)| (a - b).abs() <= 1e-9 * largest);
            assert!(is_same, "{what}: {own:?}, not {expected:?}");
        }
        attributes += 1;
    }
    // Two of them are in the nonlinear equations alone.
    assert_eq!(attributes, 28);
}

#[test]
fn a_wrong_attribute_of_the_bicycle_is_named() {
    let parameters = WhippleMechanism::<f64>::BENCHMARK.to_array();
    let Whipple { w, c, lam, IRxx, xB, .. } = Whipple::BENCHMARK;
    let named = |cause: &str, change: &dyn Fn(&mut Mechanism, usize)| {
        assert_named(BICYCLE, &parameters, &bicycle(change), cause);
    };
    named("\"w + c\" in x of the point of the joint delta is \"w - c\"", &|own, steer| {
        own.joints[steer].point.x = w - c;
    });
    named("x of the point of the joint delta is without \"+ c\"", &|own, steer| own.joints[steer].point.x = w);
    named("\"sin(lam)\" in x of the axis of the joint delta is \"cos(lam)\"", &|own, steer| {
        own.joints[steer].axis = nalgebra::Vector3::new(lam.cos(), 0.0, lam.cos()).normalize();
    });
    named("\"IRyy\" in the axial inertia of the rear wheel R is \"IRxx\"", &|own, _| {
        own.bodies[2].inertia[(1, 1)] = IRxx
    });
    named("\"xH\" in x of the centre of mass of the front frame H is \"xB\"", &|own, _| own.bodies[1].centre.x = xB);
    // The wheel alone, and not the trail: the steer axis stays where it is.
    named("\"w\" in x of the centre of the front wheel F is \"w/2\"", &|own, _| {
        own.contacts[1].centre.x = w / 2.0;
        let joint = own.contacts[1].joint;
        (own.joints[joint].point.x, own.bodies[3].centre.x) = (w / 2.0, w / 2.0);
    });
}

/// A bicycle that is steered at the rear is one whose lengths are counted the other way: to the dynamics it is the same machine with
/// negative ones.
#[test]
fn a_wrong_attribute_of_a_bicycle_steered_at_the_rear_is_named() {
    let Whipple { w, c, lam, xB, IBxz, xH, IHxz, IRxx, .. } = Whipple::BENCHMARK;
    let mirrored =
        Whipple { w: -w, c: -c, lam: -lam, xB: -xB, IBxz: -IBxz, xH: -xH, IHxz: -IHxz, ..Whipple::BENCHMARK };
    let dynamics = |change: &dyn Fn(&mut Mechanism, usize)| {
        let mut bicycle = Bicycle::new(&mirrored, &Extras::default());
        change(&mut bicycle.mechanism, bicycle.steer);
        bicycle.mechanism.linearized([bicycle.root.lean, bicycle.steer], Some(bicycle.root.x))
    };
    let parameters = RearSteered::<f64>::BACKWARDS.to_array();
    let right = RearSteered::<f64>::BACKWARDS.coefficients();
    super::mechanisms::assert_close(&dynamics(&|_, _| {}), &right, 1e-6, "without a mistake");
    let named = |cause: &str, change: &dyn Fn(&mut Mechanism, usize)| {
        assert_named(RearSteered::<f64>::INFO, &parameters, &dynamics(change), cause);
    };
    named("\"-w - c\" in x of the point of the joint delta is \"-w + c\"", &|own, steer| {
        own.joints[steer].point.x = c - w;
    });
    named("\"-sin(lam)\" in x of the axis of the joint delta is \"sin(lam)\"", &|own, steer| {
        own.joints[steer].axis = nalgebra::Vector3::new(lam.sin(), 0.0, lam.cos());
    });
    named("\"IRyy\" in the axial inertia of the front wheel F is \"IRxx\"", &|own, _| {
        own.bodies[2].inertia[(1, 1)] = IRxx
    });
}

/// The radius of the disc alone: it touches the ground below its centre by the radius.
#[test]
fn a_wrong_radius_of_a_disc_is_named() {
    let RollingDisc { r, m, Ia, It, .. } = RollingDisc::<f64>::UNIFORM;
    let mut disc = Mechanism::default();
    let Root { x, yaw, lean, .. } = disc.free_root();
    // Its pitch is the angle of the wheel.
    disc.joints.pop();
    disc.wheel(Wheel { carrier: lean, x: 0.0, y: 0.0, radius: r, tyre: 0.0, mass: m, axial: Ia, transverse: It });
    disc.contacts[0].radius = 2.0 * r;
    let parameters = RollingDisc::<f64>::UNIFORM.to_array();
    let cause = "\"r\" in the radius of the disc D is \"2*r\"";
    assert_named(RollingDisc::<f64>::INFO, &parameters, &disc.linearized([lean, yaw], Some(x)), cause);
}

/// By the equations of textbooks: the upper hinge at the centre of mass of the lower link, and not at its end.
#[test]
fn a_wrong_hinge_of_a_pendulum_is_named() {
    let rods = DoublePendulum::<f64> { a1: 0.4, ..DoublePendulum::RODS };
    let DoublePendulum { l1, a1, m1, I1, a2, m2, I2, .. } = rods;
    let lower = Link { l: a1, a: a1, m: m1, i: I1 };
    let upper = Link { l: 1.0, a: l1 + a2 - a1, m: m2, i: I2 };
    let cause = "\"-l1\" in z of the point of the joint theta2 is \"-a1\"";
    assert_named(DoublePendulum::<f64>::INFO, &rods.to_array(), &standing_at_hinges([lower, upper]), cause);
}

/// By the declaration with the mistake, which is derived as any other.
#[cfg(feature = "compiler")]
mod declared {
    use carvallo::Model;
    use carvallo_compiler::compile;
    use carvallo_models::{CarTrailer, Motorcycle, Skateboard};

    use super::super::mechanisms::{declaration, interpreted};
    use super::assert_named;

    #[track_caller]
    fn assert_named_in<const N: usize, M: Model<N, Scalar = f64>>(
        source: &str,
        [right, wrong]: [&str; 2],
        cause: &str,
    ) {
        assert_eq!(source.matches(right).count(), 1, "{right}");
        let source = source.replace(right, wrong);
        let compiled = compile(declaration(&source).parse().expect("tokens")).expect("a mechanism");
        let parameters = M::INFO.sets[0].values;
        assert_named::<N>(M::INFO, parameters, &interpreted(&compiled, parameters), cause);
    }

    #[test]
    fn a_wrong_trailer_is_named() {
        assert_named_in::<3, CarTrailer>(
            include_str!("../../../generated/models/car_trailer.rs"),
            ["mass mT, at (-h - e, 0, -r)", "mass mT, at (h - e, 0, -r)"],
            "\"-h - e\" in x of the centre of mass of the trailer T is \"h - e\"",
        );
    }

    #[test]
    fn a_wrong_inertia_of_a_motorcycle_is_named() {
        assert_named_in::<6, Motorcycle>(
            include_str!("../../../generated/models/motorcycle.rs"),
            ["[(Ifz - Ifx)*s*c, 0, Ifx*s^2 + Ifz*c^2]", "[(Ifz - Ifx)*s*c, 0, Ifx*s^2 + Ifz*s^2]"],
            "\"Ifx*s^2 + Ifz*c^2\" in the inertia zz of the front part front is \"Ifx*s^2 + Ifz*s^2\"",
        );
    }

    #[test]
    fn a_wrong_truck_of_a_skateboard_is_named() {
        assert_named_in::<1, Skateboard>(
            // With the mistake the yaw of the board is in the equations.
            &include_str!("../../../generated/models/skateboard.rs")
                .replace("Izz: kg*m^2, >= 0, unused;", "Izz: kg*m^2, >= 0;"),
            ["through (L, 0, -r), along (cos(lamF)", "through (L, 0, -2*r), along (cos(lamF)"],
            "\"-r\" in z of the point of the joint deltaF is \"-2*r\"",
        );
    }
}
