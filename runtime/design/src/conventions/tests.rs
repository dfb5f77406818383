//! There and back over random designs, and what deviations become beside differences.

use carvallo::Covariance;

use super::carried::Carried;
use super::name::Values;
use super::{Convention, Naming, OTHERS, Varied};
use crate::model::WHIPPLE;

/// How far a value may be off, in parts of the largest of its kind.
const TOLERANCE: f64 = 1e-14;

/// Random numbers between two bounds; the generator of Park and Miller.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        low + (high - low) * self.0 as f64 / 2_147_483_647.0
    }
}

/// A bicycle that there can be: with any tilt, trails of either sign, wheels of any size, and inertias of rigid bodies.
fn design(random: &mut Random) -> Values {
    let mut values = Values::default();
    let mut set = |name: &'static str, value: f64| values.push(name, value.into());
    let [w, lam] = [random.between(0.6, 2.5), random.between(-1.2, 1.2)];
    set("w", w);
    set("c", random.between(-0.3, 0.5));
    set("lam", lam);
    set("g", random.between(1.0, 12.0));
    for [radius, mass, radial, axial] in [["rR", "mR", "IRxx", "IRyy"], ["rF", "mF", "IFxx", "IFyy"]] {
        let [r, m] = [random.between(0.05, 0.28), random.between(0.1, 20.0)];
        let i = m * r * r * random.between(0.4, 1.0);
        [(radius, r), (mass, m), (radial, i * random.between(0.5, 0.7)), (axial, i)]
            .into_iter()
            .for_each(|(n, v)| set(n, v));
    }
    for [x, z, mass, xx, yy, zz, xz] in
        [["xB", "zB", "mB", "IBxx", "IByy", "IBzz", "IBxz"], ["xH", "zH", "mH", "IHxx", "IHyy", "IHzz", "IHxz"]]
    {
        let m = random.between(0.2, 150.0);
        let [a, b] = [random.between(0.001, 0.5), random.between(0.001, 0.5)].map(|k| m * k * k);
        let (s, c) = random.between(-1.6, 1.6).sin_cos();
        set(x, random.between(-0.2, 2.0));
        set(z, random.between(-1.5, -0.1));
        set(mass, m);
        set(xx, c * c * a + s * s * b);
        set(yy, random.between((a - b).abs(), a + b));
        set(zz, s * s * a + c * c * b);
        set(xz, (b - a) * s * c);
    }
    values
}

/// The largest of a kind by its unit. A moment about another point is of the size of mass times length squared.
fn size(values: &Values, unit: &str) -> f64 {
    let largest = |unit: &str| {
        let of_kind = WHIPPLE.info.parameters.iter().filter(|parameter| parameter.unit == unit);
        of_kind.filter_map(|parameter| values.get(parameter.name)).fold(0.0, |size: f64, it| size.max(it.value.abs()))
    };
    match unit {
        "rad" => 1.0,
        "kg*m^2" => largest("kg*m^2").max(largest("kg") * largest("m").powi(2)),
        unit => largest(unit),
    }
}

fn check_same(there: &Values, here: &Values, names: &[(&'static str, &'static str)], what: &str) {
    for (name, unit) in names {
        let [a, b] = [there, here].map(|values| values.get(name).unwrap_or_else(|| panic!("{what}: {name}")).value);
        assert!((a - b).abs() <= TOLERANCE * size(there, unit).max(size(here, unit)), "{what}: {name} is {b}, not {a}");
    }
}

/// Each convention of 2,000 designs.
#[test]
fn conversions_lead_back() {
    let mut random = Random(2007);
    let paper: Vec<_> = WHIPPLE.info.parameters.iter().map(|parameter| (parameter.name, parameter.unit)).collect();
    for count in 0..2_000 {
        let design = design(&mut random);
        for convention in OTHERS {
            let what = format!("{} of design {count}", convention.name);
            let there = (convention.from_paper)(&design).unwrap_or_else(|error| panic!("{what}: {error}"));
            let back = (convention.to_paper)(&there).unwrap_or_else(|error| panic!("{what}: {error}"));
            check_same(&design, &back, &paper, &what);
        }
    }
}

/// Every value that is written is one of the convention, and every one that a file must have is written.
#[test]
fn conventions_write_what_they_need() {
    let design = design(&mut Random(26));
    for convention in OTHERS {
        let there = (convention.from_paper)(&design).unwrap();
        let is_known = |name: &str| convention.parameter(name).is_some_and(|own| own.name == name);
        assert!(there.iter().all(|(name, _)| is_known(name)), "{there:?}");
        for group in convention.needed() {
            assert!(group.iter().any(|name| there.get(name).is_some()), "{} lacks {group:?}", convention.name);
        }
    }
}

/// The formulas with one value changed, for differences.
fn changed(values: &Values, position: usize, step: f64, formulas: fn(&Values) -> Result<Values, String>) -> Values {
    let mut result = Values::default();
    for (at, (name, value)) in values.iter().enumerate() {
        result.push(name, (value.value + if at == position { step } else { 0.0 }).into());
    }
    formulas(&result).unwrap()
}

/// Deviations in both directions, against differences of the formulas.
#[test]
fn deviations_are_carried_to_first_order() {
    let mut random = Random(39);
    for convention in OTHERS.into_iter().chain([Convention::called("paper").unwrap()]) {
        for _ in 0..20 {
            let design = design(&mut random);
            let there = (convention.from_paper)(&design).unwrap();
            for (values, formulas) in [(&design, convention.from_paper), (&there, convention.to_paper)] {
                let base = formulas(values).unwrap();
                // The two radial moments of a wheel are equal, and cannot vary by themselves.
                let is_bound =
                    |name: &str| (name.starts_with("I11") || name.starts_with("I22")) && name.ends_with("wheel");
                let deviation = |name: &str, value: f64| if is_bound(name) { 0.0 } else { 1e-3 * value.abs().min(1.0) };
                let deviations: Vec<f64> = values.iter().map(|(name, value)| deviation(name, value.value)).collect();
                let covariance = Covariance::independent(&deviations).unwrap();
                let carried = Carried::new(values, &covariance, formulas);
                for (name, value) in base.iter() {
                    let part = |(position, deviation): (usize, &f64)| {
                        if *deviation == 0.0 {
                            return 0.0;
                        }
                        let step = 1e-4 * deviation;
                        let [up, down] = [step, -step].map(|step| changed(values, position, step, formulas));
                        let slope = (up.get(name).unwrap().value - down.get(name).unwrap().value) / (2.0 * step);
                        slope * deviation
                    };
                    let expected = deviations.iter().enumerate().map(part).fold(0.0, |sum: f64, part| sum.hypot(part));
                    let found = carried.deviation(name);
                    let size = expected.max(1e-6 * value.value.abs().max(1.0));
                    assert!(
                        (found - expected).abs() <= 1e-3 * size,
                        "{convention:?}: {name} +/- {found}, not {expected}"
                    );
                }
            }
        }
    }
}

/// Derivatives of the parameters of the model by those of each convention, against differences of what a sweep puts in.
#[test]
fn what_varies_has_exact_derivatives() {
    let design = crate::input::load(&crate::input::Request::default()).unwrap();
    for (name, value) in [
        ("d1", 0.95),
        ("ic11", 7.0),
        ("fork_offset", 0.04),
        ("head_angle", 1.2),
        ("trail", 0.05),
        ("wheel_diameter", 0.6),
        ("lr", 0.9),
    ] {
        let naming = Naming::new(design.info(), [name, "mB"]);
        let columns = [name, "mB"].map(|name| naming.find(name).unwrap_or_else(|error| panic!("{name}: {error}")));
        let varied = Varied::new(&design, &naming, &columns.each_ref().map(Some)).unwrap();
        let put = |step: f64| {
            let mut values = design.values();
            varied.put(|column| Some([value + step, 85.0][column]), &mut values).unwrap();
            values
        };
        let found = varied.derivatives(2, |column| Some([value, 85.0][column])).unwrap();
        let step = 1e-5;
        for (at, (up, down)) in put(step).into_iter().zip(put(-step)).enumerate() {
            let (expected, found) = ((up - down) / (2.0 * step), found[0][at]);
            let name_of = design.info().parameters[at].name;
            assert!(
                (found - expected).abs() < 1e-7 * expected.abs().max(1.0),
                "{name_of} by {name}: {found}, {expected}"
            );
        }
    }
}
