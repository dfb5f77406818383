//! Forces and torques that follow from the motion: sums of coordinates and rates, each times a formula.

use proc_macro2::Ident;

use super::names::{Meaning, Scope};
use super::resolve;
use crate::formula::{self, Factor, Formula, Function};
use crate::nearest::{ask_for, find_nearest};
use crate::report::{Region, Report};
use crate::syntax::{self, Declaration, Expression, Feedback, Freedom, Kind};

/// What stands before a coordinate in parentheses for its rate.
pub const RATE: &str = "rate";

/// A force or torque that follows from the motion.
#[derive(Debug)]
pub struct Law {
    /// The coordinate, joint or wheel that it acts on.
    pub on: Ident,
    /// What it is the sum of.
    pub terms: Vec<Term>,
}

/// A coordinate or a joint, or the rate of one, times a formula.
#[derive(Clone, Debug)]
pub struct Term {
    /// The coordinate or joint.
    pub of: Ident,
    pub is_rate: bool,
    /// What multiplies it. The speed is a parameter behind all others in it.
    pub factor: Formula,
    pub region: Region,
}

/// Reads what is fed back; what is not linear, and what is of no coordinate, is reported.
pub fn read_feedback(declaration: &Declaration, scope: &mut Scope, report: &mut Report) -> Vec<Law> {
    let motions = name_motions(declaration);
    let mut laws = Vec::new();
    for (index, feedback) in declaration.feedback.iter().enumerate() {
        check_names(declaration, index, report);
        check_target(declaration, feedback, &motions, report);
        let mut reader = Reader { declaration, feedback, motions: &motions, scope, report };
        match reader.read() {
            Some(terms) => laws.push(Law { on: feedback.on.clone(), terms }),
            // They are meant, so it is no second mistake that nothing depends on them.
            None => feedback.law.names(&mut |name| {
                scope.excused.insert(name.to_string());
            }),
        }
    }
    laws
}

/// The names of all that may be fed back: of a mechanism also of joints that are no coordinates.
fn name_motions(declaration: &Declaration) -> Vec<&Ident> {
    let joints = declaration.mechanism.iter().flat_map(|mechanism| mechanism.named()).map(|(name, _)| name);
    let mut names: Vec<&Ident> = Vec::new();
    for name in declaration.coordinates.iter().map(|coordinate| &coordinate.name).chain(joints) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

fn check_names(declaration: &Declaration, index: usize, report: &mut Report) {
    let name = &declaration.feedback[index].name;
    let applied = declaration.mechanism.iter().flat_map(|mechanism| &mechanism.forces).map(|force| &force.name);
    let mut others = declaration.feedback[..index].iter().map(|feedback| &feedback.name).chain(applied);
    if others.any(|other| other == name) {
        report.error(name, format!("`{name}` is declared twice: expected one force or feedback of each name"));
    }
}

fn check_target(declaration: &Declaration, feedback: &Feedback, motions: &[&Ident], report: &mut Report) {
    let Feedback { name, on, .. } = feedback;
    let Some(mechanism) = &declaration.mechanism else {
        // Without coordinates that is the mistake.
        if !motions.contains(&on) && !motions.is_empty() {
            let message = format!("`{on}` is no coordinate: expected that on which `{name}` acts{}", hint(on, motions));
            report.error(on, message);
        }
        return;
    };
    let wheels: Vec<&Ident> = mechanism.wheels.iter().map(|wheel| &wheel.name).collect();
    let is_read = mechanism.unread.is_empty();
    if mechanism.wheels.iter().any(|wheel| wheel.deflection() == Some(on)) {
        let message = format!(
            "`{on}` is the deflection of a tyre, on which no force acts but that of the tyre: expected the coordinate of a \
             joint, or a wheel"
        );
        report.error(on, message);
    } else if is_read && !motions.contains(&on) && !wheels.contains(&on) {
        let known: Vec<&Ident> = motions.iter().copied().chain(wheels).collect();
        let message = format!(
            "`{on}` is no joint of the mechanism: expected the coordinate of one, or a wheel{}",
            hint(on, &known)
        );
        report.error(on, message);
    }
}

/// The nearest of some names, or all of them.
fn hint(name: &Ident, known: &[&Ident]) -> String {
    let texts: Vec<String> = known.iter().map(ToString::to_string).collect();
    match find_nearest(&name.to_string(), texts.iter().map(String::as_str)) {
        Some(near) => ask_for(near),
        None => format!(": {}", list(known)),
    }
}

fn list(names: &[&Ident]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// What a formula is as a sum.
#[derive(Default)]
struct Linear {
    /// The terms that no coordinate multiplies.
    constant: Vec<Region>,
    terms: Vec<Term>,
}

struct Reader<'a, 'b> {
    declaration: &'a Declaration,
    feedback: &'a Feedback,
    motions: &'b [&'a Ident],
    scope: &'b mut Scope,
    report: &'b mut Report,
}

impl Reader<'_, '_> {
    fn read(&mut self) -> Option<Vec<Term>> {
        let law = &self.feedback.law;
        if self.report_unknown(law) || self.report_constant_rates(law) {
            return None;
        }
        let Linear { constant, terms } = self.linear(law)?;
        if constant.is_empty() && terms.is_empty() {
            let message =
                format!("`{}` is always 0: expected a force that follows from the motion", self.feedback.name);
            self.report.error(law.region, message);
        }
        for region in &constant {
            let message = format!(
                "a part of `{}` that does not depend on the motion: expected terms that each have a coordinate, or its rate, \
                 such as `{}`; a constant force would keep the machine from its reference motion",
                self.feedback.name,
                self.example(),
            );
            self.report.error(*region, message);
        }
        constant.is_empty().then_some(terms)
    }

    /// A rate of this model, for messages.
    fn example(&self) -> String {
        self.motions.first().map_or_else(|| "rate(q)".into(), |name| format!("{RATE}({name})"))
    }

    /// Whether a name moves: one that is not a parameter or a definition as well.
    fn moves(&self, name: &Ident) -> bool {
        matches!(self.scope.get(name), None | Some(Meaning::Coordinate)) && self.motions.contains(&name)
    }

    /// Whether the motion is in a formula.
    fn depends(&self, formula: &Expression) -> bool {
        let mut depends = false;
        formula.names(&mut |name| depends |= self.moves(name));
        depends
    }

    /// Reports names that stand for nothing; `true` if there are any.
    fn report_unknown(&mut self, formula: &Expression) -> bool {
        let mut unknown: Vec<Ident> = Vec::new();
        formula.names(&mut |name| {
            let is_known = self.scope.get(name).is_some()
                || self.moves(name)
                || name == "pi"
                || Function::from_name(&name.to_string()).is_some();
            if !is_known {
                unknown.push(name.clone());
            }
        });
        for name in &unknown {
            let message = self.describe_unknown(name);
            self.report.error(name, message);
        }
        !unknown.is_empty()
    }

    /// Reports rates of what does not move; `true` if there are any.
    fn report_constant_rates(&mut self, formula: &Expression) -> bool {
        let mut constant = Vec::new();
        formula.calls(&mut |name, argument| {
            if name == RATE && !self.depends(argument) {
                constant.push(argument);
            }
        });
        for argument in &constant {
            let message = format!(
                "`{argument}` does not change with the motion, so it has no rate: expected one of {} in `{RATE}(…)`",
                list(self.motions)
            );
            self.report.error(argument.region, message);
        }
        !constant.is_empty()
    }

    fn describe_unknown(&mut self, name: &Ident) -> String {
        let text = name.to_string();
        if let Some(of) = self.strip(&text, &["_ddot", "ddot", "_acceleration", "_acc"], &["dd", "ddot_"]) {
            return format!("unknown name `{name}`: {}", describe_acceleration(&of));
        }
        let suffixes = ["_dot", "dot", "_rate", "rate", "_prime", "_d", "d", "_t", "_p"];
        if let Some(of) = self.strip(&text, &suffixes, &["d_", "d", "dot_", "rate_", "omega_", "v_"]) {
            return format!("unknown name `{name}`: expected `{RATE}({of})` for the rate of `{of}`");
        }
        if text == "v" {
            return "unknown name `v`: expected `v: m/s, speed;` among the parameters, if it is the forward speed"
                .into();
        }
        let known: Vec<String> = self.motions.iter().map(ToString::to_string).collect();
        let near = find_nearest(&text, known.iter().map(String::as_str)).map(ask_for);
        let near = near.unwrap_or_else(|| self.scope.suggest(name));
        let hint = match Freedom::from_word(&text).filter(|_| self.declaration.mechanism.is_some()) {
            Some(freedom) if near.is_empty() => {
                format!("; a freedom has the name that `free` gives it, as in `free …: {} q`", freedom.word())
            }
            _ => near,
        };
        format!("unknown name `{name}`: expected a parameter, a definition or what moves: {}{hint}", list(self.motions))
    }

    /// What moves, of whose name something else is the beginning or the end.
    fn strip(&self, text: &str, suffixes: &[&str], prefixes: &[&str]) -> Option<String> {
        let ends = suffixes.iter().filter_map(|suffix| text.strip_suffix(suffix));
        let begins = prefixes.iter().filter_map(|prefix| text.strip_prefix(prefix));
        let mut rests = ends.chain(begins);
        rests.find(|rest| self.motions.iter().any(|known| known == rest)).map(str::to_string)
    }

    /// Sorts a formula by what moves in it; nothing where that is reported not to be linear.
    fn linear(&mut self, formula: &Expression) -> Option<Linear> {
        if !self.depends(formula) {
            let value = resolve::resolve_in_speed(formula, self.scope, self.report);
            let constant = if value.is_zero() { Vec::new() } else { vec![formula.region] };
            return Some(Linear { constant, terms: Vec::new() });
        }
        match &formula.kind {
            Kind::Name(name) => {
                let term = Term { of: name.clone(), is_rate: false, factor: Formula::one(), region: formula.region };
                Some(Linear { constant: Vec::new(), terms: vec![term] })
            }
            Kind::Sum(terms) => {
                let mut sum = Linear::default();
                let mut is_linear = true;
                for syntax::Term { negative, value, .. } in terms {
                    let Some(Linear { constant, terms }) = self.linear(value) else {
                        is_linear = false;
                        continue;
                    };
                    sum.constant.extend(constant);
                    let signed = |factor| Formula::Sum(vec![formula::Term { negative: *negative, value: factor }]);
                    sum.terms.extend(terms.into_iter().map(|term| Term { factor: signed(term.factor), ..term }));
                }
                is_linear.then_some(sum)
            }
            Kind::Product(factors) => self.product(formula, factors),
            Kind::Power(base, 1) => self.linear(base),
            Kind::Call(name, argument) if name == RATE => self.rate(formula, argument),
            Kind::Call(name, argument) if Function::from_name(&name.to_string()).is_none() => {
                self.report.error(formula.region, describe_function(name, argument));
                None
            }
            Kind::Call(..) | Kind::Power(..) | Kind::Number(_) | Kind::Quantity(..) => self.refuse(formula),
        }
    }

    fn product(&mut self, formula: &Expression, factors: &[syntax::Factor]) -> Option<Linear> {
        let moving: Vec<usize> = (0..factors.len()).filter(|index| self.depends(&factors[*index].value)).collect();
        let only = match moving[..] {
            [only] if !factors[only].inverse => only,
            _ => return self.refuse(formula),
        };
        let Linear { constant, terms } = self.linear(&factors[only].value)?;
        let others = factors.iter().enumerate().filter(|(index, _)| *index != only);
        let others: Vec<Factor<Formula>> = others
            .map(|(_, syntax::Factor { inverse, value })| Factor {
                inverse: *inverse,
                value: resolve::resolve_in_speed(value, self.scope, self.report),
            })
            .collect();
        let is_single = terms.len() == 1 && constant.is_empty();
        let times = |term: Term| {
            let factors = std::iter::once(Factor::times(term.factor)).chain(others.iter().cloned());
            let region = if is_single { formula.region } else { term.region };
            Term { factor: Formula::Product(factors.collect()), region, ..term }
        };
        Some(Linear { constant, terms: terms.into_iter().map(times).collect() })
    }

    fn rate(&mut self, formula: &Expression, argument: &Expression) -> Option<Linear> {
        // The rate of what is constant is zero.
        let Linear { terms, .. } = self.linear(argument)?;
        if let Some(term) = terms.iter().find(|term| term.is_rate) {
            self.report.error(formula.region, describe_acceleration(&term.of.to_string()));
            return None;
        }
        let rate = |term: Term| Term { is_rate: true, region: formula.region, ..term };
        Some(Linear { constant: Vec::new(), terms: terms.into_iter().map(rate).collect() })
    }

    /// Reports what is not linear.
    fn refuse(&mut self, formula: &Expression) -> Option<Linear> {
        let message = format!(
            "`{formula}` is not linear in the motion: expected a sum of coordinates and rates, each times a formula of \
             parameters and the speed"
        );
        self.report.error(formula.region, message);
        None
    }
}

/// What to say of a function that does not exist.
fn describe_function(name: &Ident, argument: &Expression) -> String {
    const ACCELERATIONS: [&str; 4] = ["acceleration", "accel", "acc", "ddot"];
    if ACCELERATIONS.iter().any(|known| name == known) {
        return describe_acceleration(&argument.to_string());
    }
    format!("unknown function `{name}`: expected `{argument}` itself, or `{RATE}({argument})` for its rate")
}

fn describe_acceleration(of: &str) -> String {
    format!(
        "the acceleration of `{of}` cannot be fed back: expected `{of}` or `{RATE}({of})`; a force by an acceleration is an inertia, \
         which is a part of `M`"
    )
}
