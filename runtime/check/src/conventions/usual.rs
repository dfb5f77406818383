//! What parameters are taken for by convention: angles, axes, radii, centres of mass, wheels.

use std::f64::consts::{FRAC_PI_2, PI};

use carvallo::ModelInfo;

use super::Convention;

/// Those that the model has parameters for, with these values.
pub fn usual(info: &ModelInfo, values: &[f64]) -> Vec<Convention> {
    let build = Build { info, values };
    let mut found = build.angles();
    found.extend(build.axes());
    found.extend(build.lengths());
    found.extend(build.inertias());
    found.extend(build.wheels());
    found.extend(build.gravity());
    found.retain(|own| {
        let mut changed = values.to_vec();
        own.change_parameters(&mut changed);
        changed != values
    });
    found
}

struct Build<'a> {
    info: &'a ModelInfo,
    values: &'a [f64],
}

impl Build<'_> {
    fn value(&self, name: &str) -> Option<f64> {
        Some(self.values[self.info.position(name)?])
    }

    /// These parameters with other values, if the model has them all.
    fn of<const N: usize>(&self, what: &str, changed: [(&str, Option<f64>); N]) -> Option<Convention> {
        let changed = changed.map(|(name, value)| Some((self.info.position(name)?, value?)));
        let changed = changed.into_iter().collect::<Option<Vec<_>>>()?;
        Some(Convention::of_parameters(what, changed))
    }

    /// The negatives of all parameters whose names are such.
    fn negated(&self, what: &str, is_meant: impl Fn(&str) -> bool) -> Option<Convention> {
        let parameters = self.info.parameters.iter().zip(self.values).enumerate();
        let meant = parameters.filter(|(_, (parameter, value))| is_meant(parameter.name) && **value != 0.0);
        let changed: Vec<_> = meant.map(|(at, (_, value))| (at, -value)).collect();
        (!changed.is_empty()).then(|| Convention::of_parameters(what, changed))
    }

    fn angles(&self) -> Vec<Convention> {
        let mut found = Vec::new();
        for (at, parameter) in self.info.parameters.iter().enumerate().filter(|(_, own)| own.unit == "rad") {
            let (name, value) = (parameter.name, self.values[at]);
            for (what, changed) in [
                ("was taken from the ground, as the head angle, in the place of from the vertical", FRAC_PI_2 - value),
                ("was counted the other way", -value),
                ("is in degrees, but was taken in rad", value * 180.0 / PI),
                ("was converted from degrees twice", value * PI / 180.0),
            ] {
                found.push(Convention::of_parameters(format!("{name} {what}"), vec![(at, changed)]));
            }
        }
        found
    }

    /// Axes of other directions: a product of inertia changes its sign with one of them.
    fn axes(&self) -> Vec<Convention> {
        let is_position = |axis: char| {
            move |name: &str| name.len() == 2 && name.starts_with(axis) && name.ends_with(char::is_uppercase)
        };
        let is_product = |name: &str| name.starts_with('I') && name.ends_with("xz");
        [
            self.negated("z is upward", |name| is_position('z')(name) || is_product(name)),
            self.negated("z is upward, but not in the products of inertia", is_position('z')),
            self.negated("x is backward", |name| is_position('x')(name) || is_product(name)),
            self.negated("x is backward, but not in the products of inertia", is_position('x')),
            self.negated("x is backward and z upward", |name| is_position('x')(name) || is_position('z')(name)),
            self.negated("products of inertia are integrals of x*z, and not of -x*z", is_product),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    fn lengths(&self) -> Vec<Convention> {
        let mut found = Vec::new();
        // The trail, by the names of bicycles and of motorcycles, and the angle of its steer axis.
        for (trail, angle) in [("c", "lam"), ("t", "eps"), ("a", "eps")] {
            let (Some(value), Some(angle)) = (self.value(trail), self.value(angle)) else { continue };
            if value == 0.0 || self.info.position(trail).is_none_or(|at| self.info.parameters[at].unit != "m") {
                continue;
            }
            for (what, changed) in [
                ("is half of the trail", value / 2.0),
                ("was counted the other way", -value),
                ("is perpendicular to the steer axis in the place of along the ground", value * angle.cos()),
                ("is along the ground in the place of perpendicular to the steer axis", value / angle.cos()),
                ("is along the steer axis in the place of perpendicular to it", value * angle.tan()),
            ] {
                found.extend(self.of(&format!("{trail} {what}"), [(trail, Some(changed))]));
            }
        }
        if let Some(w) = self.value("w") {
            for name in ["xB", "xH"] {
                let Some(x) = self.value(name) else { continue };
                let what = format!("{name} is from the front contact forward");
                found.extend(self.of(&what, [(name, Some(x - w))]));
                let what = format!("{name} is from the front contact backward");
                found.extend(self.of(&what, [(name, Some(w - x))]));
                found.extend(self.of(&format!("{name} was taken from the front contact"), [(name, Some(x + w))]));
            }
            if let Some(c) = self.value("c") {
                let what = "w is to where the steer axis meets the ground";
                found.extend(self.of(what, [("w", Some(w + c))]));
            }
        }
        for (wheel, radius) in [("rear", "rR"), ("front", "rF")] {
            let value = self.value(radius);
            let what = format!("{radius} is the diameter of the {wheel} wheel");
            found.extend(self.of(&what, [(radius, value.map(|value| 2.0 * value))]));
        }
        let doubled = |name| self.value(name).map(|value| 2.0 * value);
        found.extend(self.of("radii are diameters", [("rR", doubled("rR")), ("rF", doubled("rF"))]));
        found
    }

    fn inertias(&self) -> Vec<Convention> {
        let mut found = Vec::new();
        for (body, what) in [("B", "rear frame"), ("H", "front frame")] {
            let name = |kind: &str, axes: &str| format!("{kind}{body}{axes}");
            let value = |kind: &str, axes: &str| self.value(&name(kind, axes));
            let all = (value("m", ""), value("x", ""), value("z", ""));
            let (Some(m), Some(x), Some(z)) = all else { continue };
            for (sign, how) in [(1.0, "about the rear contact"), (-1.0, "taken for those about the rear contact")] {
                let moved = |axes: &str, by: f64| value("I", axes).map(|own| own + sign * by);
                let changed = [("xx", m * z * z), ("zz", m * x * x), ("xz", -m * x * z)];
                let names = changed.map(|(axes, _)| name("I", axes));
                let changed = changed.map(|(axes, by)| moved(axes, by));
                let [xx, zz, xz] = [0, 1, 2].map(|at| (names[at].as_str(), changed[at]));
                found.extend(self.of(&format!("the moments of inertia of the {what} are {how}"), [xx, zz, xz]));
            }
            let [xx, zz] = ["xx", "zz"].map(|axes| name("I", axes));
            let (of_x, of_z) = (self.value(&xx), self.value(&zz));
            found.extend(self.of(&format!("{xx} and {zz} are exchanged"), [(&xx, of_z), (&zz, of_x)]));
        }
        found
    }

    fn wheels(&self) -> Vec<Convention> {
        let mut found = Vec::new();
        let exchanged = [("rR", "rF"), ("mR", "mF"), ("IRxx", "IFxx"), ("IRyy", "IFyy")];
        let both = exchanged.map(|(a, b)| [(a, self.value(b)), (b, self.value(a))]);
        let [[a, b], [c, d], [e, f], [g, h]] = both;
        found.extend(self.of("the rear and the front wheel are exchanged", [a, b, c, d, e, f, g, h]));
        let pairs = [("IRxx", "IRyy"), ("IFxx", "IFyy")];
        let own = pairs.map(|(xx, yy)| [(xx, self.value(yy)), (yy, self.value(xx))]);
        let [[a, b], [c, d]] = own;
        let what = "axial and radial moments of inertia of the wheels are exchanged";
        found.extend(self.of(what, [a, b, c, d]));
        let sum = |a, b| Some(self.value(a)? + self.value(b)?);
        let less = |a, b| Some(self.value(a)? - self.value(b)?);
        found.extend(self.of("mH has the mass of the front wheel in it", [("mH", sum("mH", "mF"))]));
        found.extend(self.of("mH was taken for that of the whole front, and mF taken off", [("mH", less("mH", "mF"))]));
        found.extend(self.of("mB has the mass of the rear wheel in it", [("mB", sum("mB", "mR"))]));
        found.extend(self.of(
            "mB has the masses of the front in it",
            [("mB", sum("mB", "mH").and_then(|sum| Some(sum + self.value("mF")?)))],
        ));
        found
    }

    fn gravity(&self) -> Vec<Convention> {
        let Some(position) = self.info.gravity else { return Vec::new() };
        let name = self.info.parameters[position].name;
        let of = |value: f64| Convention::of_parameters(format!("{name} is {value} N/kg"), vec![(position, value)]);
        [9.8, 9.81, 9.82, 9.806, 9.80665, 10.0].map(of).to_vec()
    }
}
