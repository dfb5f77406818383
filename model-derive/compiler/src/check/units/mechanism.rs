//! Units and mirrors of what a mechanism is given.

use super::Analysis;
use super::analysis::short;
use super::declared::Dimensions;
use super::dimension::Dimension;
use crate::check::names::Scope;
use crate::report::Report;
use crate::syntax::{Declaration, Direction, Expression, Inertia, JointKind, Mechanism, Vector};

const MASS: Dimension = Dimension::new([1, 0, 0]);
const LENGTH: Dimension = Dimension::new([0, 1, 0]);
const INERTIA: Dimension = Dimension::new([1, 2, 0]);
const AXES: [&str; 3] = ["x", "y", "z"];

/// Reports what is in another unit than its place asks for; `definitions` are the dimensions of those.
pub fn check_mechanism(
    declaration: &Declaration,
    mechanism: &Mechanism,
    dimensions: &Dimensions,
    scope: &Scope,
    definitions: Vec<Option<Dimension>>,
    report: &mut Report,
) {
    let mut check = Check { analysis: Analysis { declaration, scope, dimensions, definitions }, report };
    for body in &mechanism.bodies {
        let Some((mass, centre, inertia)) = &body.mass else { continue };
        check.formula(mass, MASS, &format!("the mass of `{}`", body.name));
        check.position(centre, &format!("the centre of mass of `{}`", body.name));
        check.inertia(inertia, &body.name.to_string());
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
    }
    for joint in &mechanism.joints {
        let name = &joint.name;
        if let Some(through) = &joint.through {
            check.position(through, &format!("the point of `{name}`"));
        }
        check.axis(&joint.along, &name.to_string());
        // Work over the square of the coordinate, which is an angle or a length.
        let metres = if joint.kind == JointKind::Revolute { 2 } else { 0 };
        if let Some(spring) = &joint.spring {
            check.formula(spring, Dimension::new([1, metres, -2]), &format!("the spring of `{name}`"));
        }
        if let Some(damper) = &joint.damper {
            check.formula(damper, Dimension::new([1, metres, -1]), &format!("the damper of `{name}`"));
        }
    }
}

struct Check<'a> {
    analysis: Analysis<'a>,
    report: &'a mut Report,
}

impl Check<'_> {
    fn formula(&mut self, formula: &Expression, expected: Dimension, what: &str) {
        let Some(found) = self.analysis.dimension(formula, self.report) else { return };
        let text = short(formula);
        if !found.same_unit(expected) {
            let message = format!("{what}, `{text}`, is {}: expected {expected}", found.place());
            self.report.error(formula.region, message);
        } else if self.analysis.dimensions.mirrored && found != expected {
            let message = format!("{what}, `{text}`, {}: expected what {}", found.sign(), expected.sign());
            self.report.error(formula.region, message);
        }
    }

    /// A length that may be counted along any axis.
    fn length(&mut self, formula: &Expression, what: &str) {
        let Some(found) = self.analysis.dimension(formula, self.report) else { return };
        if !found.same_unit(LENGTH) {
            let message = format!("{what}, `{}`, is {}: expected {LENGTH}", short(formula), found.place());
            self.report.error(formula.region, message);
        }
    }

    fn position(&mut self, vector: &Vector, what: &str) {
        for (axis, component) in vector.components.iter().enumerate() {
            let expected = LENGTH.directed(Some(along(axis)));
            self.formula(component, expected, &format!("{}, {what}", AXES[axis]));
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
                for (row, entries) in rows.iter().enumerate() {
                    for (column, entry) in entries.iter().enumerate() {
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

    /// All components are in one unit, and each mirrors as its own axis does, or all of them the other way round.
    fn axis(&mut self, vector: &Vector, joint: &str) {
        let mut first: Option<(Dimension, Dimension)> = None;
        for (axis, component) in vector.components.iter().enumerate() {
            let Some(found) = self.analysis.dimension(component, self.report) else { continue };
            let own = Dimension::NUMBER.directed(Some(along(axis)));
            let Some(turned) = found.times(own) else { continue };
            let Some((unit, mirrors)) = first else {
                first = Some((found, turned));
                continue;
            };
            if !found.same_unit(unit) {
                let message = format!(
                    "the direction of `{joint}` has components that are {} and {}: expected one unit",
                    unit.place(),
                    found.place()
                );
                self.report.error(component.region, message);
            } else if self.analysis.dimensions.mirrored && turned.odd != mirrors.odd {
                let message = format!(
                    "this component of the direction of `{joint}` {}, but not as the others do with their axes: expected \
                     a direction that mirrors like a line",
                    found.sign()
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
