//! Whether values are off by the factor of a unit: a wheel base of 1020 m is one of 1020 mm.
//!
//! A warning is for what is near certain: no bicycle or motorcycle is so large, and in the other unit it is an ordinary one.
//! An angle in degrees is beyond the domain of `lam` and refused there.

use carvallo::ModelInfo;
#[cfg(feature = "full")]
use carvallo::ParameterInfo;

#[cfg(feature = "full")]
use crate::conventions::Reading;
use crate::number::shortest;

/// The parameters of one kind, and in which sizes bicycles, recumbents, tandems and motorcycles have them.
struct Kind {
    names: &'static [&'static str],
    /// Ordinary sizes, in the SI unit.
    ordinary: (f64, f64),
    /// What is larger than this has another unit.
    largest: f64,
    /// The units that people have it in instead, and what one of them is in the SI unit.
    units: &'static [(&'static str, f64)],
}

const LENGTHS: &[(&str, f64)] = &[("mm", 1e-3), ("cm", 1e-2)];
const INERTIAS: &[(&str, f64)] = &[("kg*cm^2", 1e-4), ("kg*mm^2", 1e-6)];
const KINDS: [Kind; 6] = [
    Kind { names: &["w"], ordinary: (0.3, 5.0), largest: 10.0, units: LENGTHS },
    Kind { names: &["rR", "rF"], ordinary: (0.03, 1.0), largest: 3.0, units: LENGTHS },
    Kind { names: &["c"], ordinary: (0.01, 0.5), largest: 3.0, units: LENGTHS },
    Kind { names: &["xB", "zB", "xH", "zH"], ordinary: (0.05, 3.0), largest: 10.0, units: LENGTHS },
    Kind { names: &["mR", "mB", "mH", "mF"], ordinary: (0.2, 500.0), largest: 2000.0, units: &[("g", 1e-3)] },
    Kind { names: &["g"], ordinary: (9.7, 9.9), largest: 900.0, units: &[("cm/s^2", 1e-2), ("mm/s^2", 1e-3)] },
];

/// The moments and products of inertia of a body, its mass, and a length that its radius of gyration cannot exceed by far.
const BODIES: [(&[&str], &str, &str); 4] = [
    (&["IRxx", "IRyy"], "mR", "rR"),
    (&["IBxx", "IByy", "IBzz", "IBxz"], "mB", "w"),
    (&["IHxx", "IHyy", "IHzz", "IHxz"], "mH", "w"),
    (&["IFxx", "IFyy"], "mF", "rF"),
];
/// By how much a moment of inertia exceeds mass times length squared that has another unit.
const EXCESS: f64 = 100.0;

/// A value that seems to be in another unit.
struct Slip {
    unit: &'static str,
    name: &'static str,
    size: f64,
}

/// A warning for each unit that values seem to be in; none for models that are no bicycles.
pub fn warnings(info: &ModelInfo, values: &[f64]) -> Vec<String> {
    told(&slips(info, values))
}

fn told(found: &[Slip]) -> Vec<String> {
    let units = LENGTHS.iter().chain(KINDS[4].units).chain(KINDS[5].units).chain(INERTIAS);
    units.filter_map(|(unit, _)| warning(unit, found.iter().filter(|slip| slip.unit == *unit))).collect()
}

/// The parameters that are larger than those of any bicycle, and in another unit would not be.
#[cfg(feature = "full")]
pub fn too_large(info: &ModelInfo, values: &[f64]) -> Vec<&'static str> {
    let mut names: Vec<&'static str> = slips(info, values).into_iter().map(|slip| slip.name).collect();
    names.dedup();
    names
}

/// A warning if a value of something that varies seems to be in another unit, by the parameters of the model that follow from it.
#[cfg(feature = "full")]
pub fn warning_of_varied(varied: &ParameterInfo, value: f64, info: &ModelInfo, values: &[f64]) -> Option<String> {
    let found = slips(info, values);
    let is_own = |slip: &&Slip| info.position(varied.name).is_none() || slip.name == varied.name;
    let slip = found.iter().filter(is_own).find(|slip| slip.is_from(varied, value))?;
    let written = shortest(value);
    let large = match slip.name == varied.name {
        true => format!("{written} is too large for a bicycle"),
        false => slip.with(&written, varied),
    };
    let (own, unit) = (varied.name, slip.unit);
    Some(format!("`{own}`: {large}, and ordinary in {unit}; write that unit with its values, as in `{written} {unit}`"))
}

/// The warnings of a file in a convention, or of what is set in one, by the names that are given.
#[cfg(feature = "full")]
pub fn warnings_by(reading: &Reading, info: &ModelInfo, values: &[f64]) -> Vec<String> {
    let (mut found, mut warnings) = (slips(info, values), Vec::new());
    for (called, own, value) in reading.given() {
        let is_from = |slip: &Slip| slip.is_from(&own, value) && reading.moves(own.name, slip.name);
        let Some(Slip { unit, name, size }) = found.extract_if(.., |slip| is_from(slip)).next() else { continue };
        let written = shortest(value);
        let large = match size == value {
            true => format!("`{called}` is too large for a bicycle"),
            false => format!("`{called}`: {}", Slip { unit, name, size }.with(&written, &own)),
        };
        warnings.push(format!("{large}, and ordinary in {unit}; write that unit behind it, as in `{written} {unit}`"));
    }
    warnings.extend(told(&found));
    warnings
}

/// The warnings of a body that is joined to a frame: of lengths in m, its mass in kg, and moments of inertia in kg m^2.
#[cfg(feature = "full")]
pub fn warnings_of_body(lengths: &[(&'static str, f64)], mass: f64, moments: &[(&'static str, f64)]) -> Vec<String> {
    let [.., centres, masses, _] = &KINDS;
    let of = |kind: &'static Kind, name, size: f64| {
        let unit = likeliest(kind.units, size, kind.ordinary.into()).filter(|_| size.abs() > kind.largest)?;
        Some(Slip { unit, name, size })
    };
    let mut found: Vec<Slip> = lengths.iter().filter_map(|(name, size)| of(centres, name, *size)).collect();
    found.extend(of(masses, "mass", mass));
    // As of a frame whose wheel base is 1 m.
    found.extend(moments.iter().filter_map(|(name, size)| of_moment(name, *size, mass)));
    told(&found)
}

#[cfg(feature = "full")]
impl Slip {
    /// Whether a value in another unit can be the cause, and not what others beside it make large.
    fn is_from(&self, own: &ParameterInfo, value: f64) -> bool {
        value.abs() > 0.1 * self.size.abs() && crate::quantity::scale(own.unit, self.unit).is_some()
    }

    /// What becomes too large with a value of something else.
    fn with(&self, written: &str, own: &ParameterInfo) -> String {
        let size = crate::number::fixed(self.size, 1);
        format!("with {written} `{}` is {size} {}, too large for a bicycle", self.name, crate::number::unit(own.unit))
    }
}

fn slips(info: &ModelInfo, values: &[f64]) -> Vec<Slip> {
    let value = |name: &str| info.position(name).and_then(|position| values.get(position)).copied();
    if ["w", "c", "lam", "rR", "rF"].iter().any(|name| info.position(name).is_none()) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for Kind { names, ordinary: (low, high), largest, units } in KINDS {
        for &name in names {
            let Some(size) = value(name).filter(|size| size.abs() > largest) else { continue };
            found.extend(likeliest(units, size, [low, high]).map(|unit| Slip { unit, name, size }));
        }
    }
    for (names, mass, length) in BODIES {
        let (Some(mass), Some(length)) = (value(mass), value(length)) else { continue };
        let bound = mass * length * length;
        found.extend(names.iter().filter_map(|name| of_moment(name, value(name)?, bound)));
    }
    found
}

/// A moment of inertia that is far larger than the mass times the square of a length, and in another unit is not.
fn of_moment(name: &'static str, size: f64, bound: f64) -> Option<Slip> {
    let fits = |(_, factor): &&(&str, f64)| (1e-3 * bound..=bound).contains(&(size * factor).abs());
    let (unit, _) = INERTIAS.iter().find(fits).filter(|_| bound > 0.0 && size.abs() > EXCESS * bound)?;
    Some(Slip { unit, name, size })
}

/// The unit in which a size is ordinary: of several the one in which it is nearest to the middle, so that 34 of a radius are cm.
fn likeliest(units: &[(&'static str, f64)], size: f64, [low, high]: [f64; 2]) -> Option<&'static str> {
    let middle = (low * high).sqrt();
    let off = |factor: f64| ((size * factor).abs() / middle).ln().abs();
    let fits = |(_, factor): &&(&str, f64)| (low..=high).contains(&(size * factor).abs());
    units.iter().filter(fits).min_by(|a, b| off(a.1).total_cmp(&off(b.1))).map(|(unit, _)| *unit)
}

fn warning<'a>(unit: &str, found: impl Iterator<Item = &'a Slip>) -> Option<String> {
    let found: Vec<&Slip> = found.collect();
    let [Slip { size: first, .. }, ..] = found[..] else { return None };
    let names: Vec<String> = found.iter().map(|slip| format!("`{}`", slip.name)).collect();
    let (are, each) = if names.len() == 1 { ("is", "it") } else { ("are", "each") };
    let example = format!("{} {unit}", shortest(*first));
    Some(format!(
        "{} {are} too large for a bicycle, and ordinary in {unit}; write that unit behind {each}, as in `{example}`",
        names.join(", ")
    ))
}

#[cfg(test)]
mod tests {
    use super::warnings;
    use crate::input::{Request, load};
    use crate::model::{MODELS, WHIPPLE};

    fn values(model: &str, name: &str) -> Vec<f64> {
        let request =
            Request { model: Some(model.to_owned()), parameters: Some(name.to_owned()), ..Request::default() };
        let design = load(&request).expect("what ships is right");
        design.parameters.iter().map(|given| given.value).collect()
    }

    #[test]
    fn nothing_that_ships_is_warned_of() {
        let mut count = 0;
        for model in MODELS {
            for name in crate::input::shipped::names(model) {
                assert_eq!(warnings(model.info, &values(model.info.name, name)), Vec::<String>::new(), "{name}");
                count += 1;
            }
        }
        assert!(count > 20, "{count} sets ship");
    }

    /// Each shipped bicycle in other units, with what is ordinary in none of them left alone.
    #[test]
    fn other_units_are_recognised() {
        for bicycle in crate::input::shipped::names(&WHIPPLE) {
            for (unit, factor, kind) in [("mm", 1e3, "m"), ("g", 1e3, "kg"), ("kg*cm^2", 1e4, "kg*m^2")] {
                let mut values = values("Whipple", bicycle);
                for (value, info) in values.iter_mut().zip(WHIPPLE.info.parameters) {
                    *value *= if info.unit == kind { factor } else { 1.0 };
                }
                let found = warnings(WHIPPLE.info, &values);
                let [found] = &found[..] else { panic!("{bicycle} in {unit}: {found:?}") };
                assert!(found.contains(&format!("ordinary in {unit}; write")), "{bicycle}: {found}");
            }
        }
    }

    #[test]
    fn a_single_value_is_named() {
        let mut values = values("Whipple", "benchmark");
        values[0] = 1020.0;
        let message = "`w` is too large for a bicycle, and ordinary in mm; write that unit behind it, as in `1020 mm`";
        assert_eq!(warnings(WHIPPLE.info, &values), [message]);
        values[0] = 102.0;
        assert_eq!(warnings(WHIPPLE.info, &values), [message.replace("mm", "cm").replace("1020", "102")]);
        // Neither a radius of 34 mm nor a depth of 90 mm is meant.
        values[0] = 1.02;
        let [radius, depth] = ["rR", "zB"].map(|name| WHIPPLE.info.position(name).unwrap());
        (values[radius], values[depth]) = (34.0, -90.0);
        let both =
            "`rR`, `zB` are too large for a bicycle, and ordinary in cm; write that unit behind each, as in `34 cm`";
        assert_eq!(warnings(WHIPPLE.info, &values), [both]);
        (values[radius], values[depth]) = (0.3, -0.9);
        values[0] = 7.0;
        values[3] = 981.0;
        let gravity = "`g` is too large for a bicycle, and ordinary in cm/s^2; write that unit behind it, as in \
                       `981 cm/s^2`";
        assert_eq!(warnings(WHIPPLE.info, &values), [gravity]);
    }
}
