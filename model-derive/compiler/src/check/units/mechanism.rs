//! Units and mirrors of what a mechanism is given.

use proc_macro2::Ident;

use super::analysis::short;
use super::declared::Dimensions;
use super::dimension::Dimension;
use super::{Analysis, RowFactors, check_feedback, check_matrix};
use crate::check::mechanism::axis_of;
use crate::check::names::Scope;
use crate::mechanics::Motion;
use crate::report::Report;
use crate::syntax::{Axis, Declaration, Direction, Expression, Inertia, JointKind, Mechanism, Slip, Vector};

const MASS: Dimension = Dimension::new([1, 0, 0]);
const LENGTH: Dimension = Dimension::new([0, 1, 0]);
const INERTIA: Dimension = Dimension::new([1, 2, 0]);
const MOMENTUM: Dimension = Dimension::new([1, 2, -1]);
const FORCE: Dimension = Dimension::new([1, 1, -2]);
const AXES: [&str; 3] = ["x", "y", "z"];

/// Reports what is in another unit than its place asks for; `definitions` are the dimensions of those.
pub fn check_mechanism(
    declaration: &Declaration,
    mechanism: &Mechanism,
    dimensions: &Dimensions,
    scope: &Scope,
    definitions: &[Option<Dimension>],
    report: &mut Report,
) {
    let definitions = definitions.to_vec();
    let mut check =
        Check { analysis: Analysis { declaration, scope, dimensions, definitions, motions: Vec::new() }, report };
    for body in &mechanism.bodies {
        let Some((mass, centre, inertia)) = &body.mass else { continue };
        check.formula(mass, MASS, &format!("the mass of `{}`", body.name));
        check.position(centre, &format!("the centre of mass of `{}`", body.name));
        check.inertia(inertia, &body.name.to_string());
    }
    for body in &mechanism.bodies {
        let Some(momentum) = &body.momentum else { continue };
        for (axis, component) in momentum.components.iter().enumerate() {
            let what = format!("the angular momentum in `{}` about {}", body.name, AXES[axis]);
            let expected = MOMENTUM.directed(Some(Direction::About(axis)));
            check.formula_in(component, expected, &what, "N*m*s");
        }
    }
    for link in &mechanism.links {
        let name = &link.name;
        for (body, point) in &link.ends {
            check.position(point, &format!("the end of `{name}` on `{body}`"));
        }
        for (formula, what, seconds, unit) in
            [(&link.spring, "spring", -2, "N/m"), (&link.damper, "damper", -1, "N*s/m")]
        {
            if let Some(formula) = formula {
                check.formula_in(formula, Dimension::new([1, 0, seconds]), &format!("the {what} of `{name}`"), unit);
            }
        }
    }
    for wheel in &mechanism.wheels {
        let name = &wheel.name;
        check.formula(&wheel.mass, MASS, &format!("the mass of `{name}`"));
        check.position(&wheel.centre, &format!("the centre of `{name}`"));
        check.length(&wheel.radius, &format!("the radius of `{name}`"));
        if let Some(tyre) = &wheel.tyre {
            check.length(tyre, &format!("the radius of the tyre of `{name}`"));
        }
        check.formula(&wheel.axial, INERTIA, &format!("the axial moment of inertia of `{name}`"));
        check.formula(&wheel.radial, INERTIA, &format!("the radial moment of inertia of `{name}`"));
        if let Some(Slip { cornering, camber, trail, relaxation }) = &wheel.slip {
            let force = "N, the side force by an angle in rad";
            check.cornering(cornering, &format!("the cornering stiffness of `{name}`"), force);
            if let Some(camber) = camber {
                check.formula_in(camber, FORCE, &format!("the camber stiffness of `{name}`"), force);
            }
            let lengths =
                [(trail.as_ref(), "trail"), (relaxation.as_ref().map(|(length, _)| length), "relaxation length")];
            for (length, what) in lengths {
                if let Some(length) = length {
                    check.length(length, &format!("the {what} of the tyre of `{name}`"));
                }
            }
        }
    }
    for joint in &mechanism.joints {
        let name = &joint.name;
        if let Some(through) = &joint.through {
            check.position(through, &format!("the point of `{name}`"));
        }
        if let Some(along) = joint.axis.along() {
            check.axis(along, &name.to_string());
        }
        // Work over the square of the coordinate, which is an angle or a length.
        let (metres, spring, damper) = match joint.kind {
            JointKind::Revolute => (2, "N*m, as it turns", "N*m*s, as it turns"),
            JointKind::Prismatic => (0, "N/m, as it slides", "N*s/m, as it slides"),
        };
        let held = [(&joint.spring, "spring", -2, spring), (&joint.damper, "damper", -1, damper)];
        for (formula, what, seconds, unit) in held {
            let Some(formula) = formula else { continue };
            check.formula_in(formula, Dimension::new([1, metres, seconds]), &format!("the {what} of `{name}`"), unit);
        }
    }
    let Check { mut analysis, report } = check;
    let coordinates: Vec<_> = declaration
        .coordinates
        .iter()
        .zip(&dimensions.coordinates)
        .map(|(coordinate, dimension)| {
            Some(dimension.as_ref()?.directed(Some(find_direction(&coordinate.name, mechanism, &analysis)?)))
        })
        .collect();
    let mut factors = RowFactors::new(declaration);
    for matrix in &declaration.added {
        check_matrix(&analysis, matrix.name.name(), matrix, &coordinates, dimensions.mirrored, &mut factors, report);
    }
    let motions = mechanism.named().map(|(name, turns)| {
        let direction = find_direction(name, mechanism, &analysis);
        let unit = if turns { Dimension::NUMBER } else { LENGTH };
        (name.to_string(), direction.map(|direction| unit.directed(Some(direction))))
    });
    let wheels = mechanism
        .wheels
        .iter()
        .map(|wheel| (wheel.name.to_string(), Some(Dimension::NUMBER.directed(Some(Direction::About(1))))));
    analysis.motions = motions.chain(wheels).collect();
    check_feedback(&analysis, &mut factors, report);
}

/// How what a name moves mirrors: along or about the axis of its joint, whose components have signs of their own.
fn find_direction(name: &Ident, mechanism: &Mechanism, analysis: &Analysis<'_>) -> Option<Direction> {
    if mechanism.wheels.iter().any(|wheel| wheel.deflection() == Some(name)) {
        return Some(Direction::Along([false, true, false]));
    }
    let mut freedoms = mechanism.free.iter().flat_map(|free| &free.names);
    let (turns, axis, odd) = if let Some((freedom, _)) = freedoms.find(|(_, known)| known == name) {
        let (motion, axis) = axis_of(*freedom);
        (motion == Motion::Turns, axis, [false; 3])
    } else {
        let index = mechanism.joints.iter().position(|joint| joint.name == *name)?;
        let (axis, odd) = match &mechanism.joints[index].axis {
            Axis::Own(axis) => (*axis, [false; 3]),
            Axis::Along(along) => {
                let mut components = along.components.iter().enumerate();
                // Mistakes in it are reported where it is checked, and zero has no sign.
                let dimension = |formula| analysis.dimension(formula, &mut Report::default());
                let (axis, component) = components.find_map(|(axis, formula)| Some((axis, dimension(formula)?)))?;
                (axis, component.odd)
            }
            Axis::Normal => {
                // A rotation about a x b changes its sign where one of the slides along a and b does.
                let slides = [index.checked_sub(2)?, index.checked_sub(1)?];
                let slides = slides.map(|slide| find_direction(&mechanism.joints[slide].name, mechanism, analysis));
                let [Some(Direction::Along(a)), Some(Direction::Along(b))] = slides else { return None };
                return Some(Direction::Along([0, 1, 2].map(|mirrored| a[mirrored] != b[mirrored])));
            }
        };
        (mechanism.joints[index].kind == JointKind::Revolute, axis, odd)
    };
    Some(Direction::Along([0, 1, 2].map(|mirrored| odd[mirrored] != ((mirrored == axis) != turns))))
}

struct Check<'a> {
    analysis: Analysis<'a>,
    report: &'a mut Report,
}

impl Check<'_> {
    fn formula(&mut self, formula: &Expression, expected: Dimension, what: &str) {
        self.formula_in(formula, expected, what, &expected.to_string());
    }

    /// As [`Self::formula`], with the expected unit in the form in which it is mostly written.
    fn formula_in(&mut self, formula: &Expression, expected: Dimension, what: &str, unit: &str) {
        let Some(found) = self.analysis.dimension(formula, self.report) else { return };
        let text = short(formula);
        if !found.same_unit(expected) {
            let message = format!("`{text}`, {what}, is {}: expected {unit}", found.place());
            self.report.error(formula.region, message);
        } else if self.analysis.dimensions.mirrored && found != expected {
            let message = format!("`{text}`, {what}, {}: expected what {}", found.sign(), expected.sign());
            self.report.error(formula.region, message);
        }
    }

    /// A force by an angle of slip, which may be that by the slip of a wheel that rolls forward.
    fn cornering(&mut self, formula: &Expression, what: &str, unit: &str) {
        if self.analysis.dimension(formula, self.report) != Some(FORCE.directed(Some(along(0)))) {
            self.formula_in(formula, FORCE, what, unit);
        }
    }

    /// A length that may be counted along any axis.
    fn length(&mut self, formula: &Expression, what: &str) {
        let Some(found) = self.analysis.dimension(formula, self.report) else { return };
        if !found.same_unit(LENGTH) {
            let message = format!("`{}`, {what}, is {}: expected {LENGTH}", short(formula), found.place());
            self.report.error(formula.region, message);
        }
    }

    fn position(&mut self, vector: &Vector, what: &str) {
        for (axis, component) in vector.components.iter().enumerate() {
            let expected = LENGTH.directed(Some(along(axis)));
            self.formula(component, expected, &format!("the {} of {what}", AXES[axis]));
        }
    }

    fn inertia(&mut self, inertia: &Inertia, body: &str) {
        match inertia {
            Inertia::None => {}
            Inertia::Principal(moments) => {
                for (axis, moment) in moments.iter().enumerate() {
                    self.formula(moment, INERTIA, &format!("the moment of inertia of `{body}` about {}", AXES[axis]));
                }
            }
            Inertia::Full(rows) => {
                // Below the diagonal are the same formulas.
                for (row, entries) in rows.iter().enumerate() {
                    for (column, entry) in entries.iter().enumerate().skip(row) {
                        let expected = match row == column {
                            true => INERTIA,
                            false => INERTIA.directed(Some(product(row, column))),
                        };
                        let what = format!("the entry {}{} of the inertia of `{body}`", AXES[row], AXES[column]);
                        self.formula(entry, expected, &what);
                    }
                }
            }
        }
    }

    /// All components are in one unit, and the ratio of two mirrors with both of their axes.
    fn axis(&mut self, vector: &Vector, joint: &str) {
        let mut first: Option<(usize, Dimension)> = None;
        for (axis, component) in vector.components.iter().enumerate() {
            let Some(found) = self.analysis.dimension(component, self.report) else { continue };
            let Some((other, unit)) = first else {
                first = Some((axis, found));
                continue;
            };
            let what = format!("`{}`, the {} of the direction of `{joint}`,", short(component), AXES[axis]);
            let reference = format!("its {}, `{}`,", AXES[other], short(&vector.components[other]));
            if !found.same_unit(unit) {
                let message =
                    format!("{what} is {}, but {reference} {}: expected one unit", found.place(), unit.place());
                self.report.error(component.region, message);
                continue;
            }
            let expected = Dimension::NUMBER.directed(Some(product(axis, other)));
            let ratio = unit.power(-1).and_then(|inverse| found.times(inverse));
            if let Some(ratio) = ratio.filter(|ratio| self.analysis.dimensions.mirrored && *ratio != expected) {
                let message = format!(
                    "the ratio of {what} to {reference} {}: expected one that {}",
                    ratio.sign(),
                    expected.sign()
                );
                self.report.error(component.region, message);
            }
        }
    }
}

fn along(own: usize) -> Direction {
    Direction::Along([0, 1, 2].map(|axis| own == axis))
}

fn product(row: usize, column: usize) -> Direction {
    Direction::Along([0, 1, 2].map(|axis| (axis == row) != (axis == column)))
}
