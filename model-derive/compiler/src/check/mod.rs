//! The syntax tree to what it means: names, shapes, units and domains are right, and formulas are resolved.

mod constants;
mod definitions;
mod derivatives;
mod domains;
mod feedback;
mod loads;
mod matrices;
mod mechanism;
mod names;
mod powers;
mod references;
mod resolve;
mod rust_attributes;
mod sets;
mod units;

use std::collections::HashSet;

use proc_macro2::Ident;

use self::domains::ExactDomain;
pub use self::feedback::{Law, Term};
use self::loads::Loads;
pub use self::matrices::WrittenMatrices;
pub use self::mechanism::{Assembly, Role, Tree, assemble};
use self::names::Scope;
pub use self::rust_attributes::RustAttributes;
pub use self::sets::CheckedSet;
pub use self::units::Units;
use self::units::declared::Dimensions;
use self::units::dimension::Dimension;
use crate::domain::Domain;
use crate::formula::Formula;
use crate::model::{AskedDerivatives, Origin, References, Requirement};
use crate::report::Report;
use crate::syntax::Declaration;

/// A declaration whose names are resolved. If mistakes are reported some of it may be missing or stand for nothing.
#[derive(Debug)]
pub struct Checked<'a> {
    /// What was checked.
    pub declaration: &'a Declaration,
    /// Whether all its statements could be read.
    pub is_complete: bool,
    /// Attributes of Rust, for what is generated.
    pub rust_attributes: RustAttributes,
    /// Names that are not reported as unused: refused ones, and those suggested for an unknown one, so probably meant.
    pub excused: HashSet<String>,
    /// For each parameter.
    pub domains: Vec<Domain>,
    /// The definitions in an order in which each uses only earlier ones, by their positions in the declaration.
    pub order: Vec<usize>,
    /// The formulas of those that do not depend on the speed, in that order, which is also that of positions in formulas.
    pub definitions: Vec<Formula>,
    /// Those of the others, behind them. The speed is a parameter behind all others in these.
    pub unsteady: Vec<Formula>,
    /// The declared requirements.
    pub requirements: Vec<Requirement>,
    /// Both sides of each assertion of a formula.
    pub assertions: Assertions,
    /// The rows of each matrix whose entries are asserted.
    pub asserted: Asserted,
    /// What is written of the matrices.
    pub written: WrittenMatrices,
    /// What equations of motion are derived from, as [`Declaration::attributes`].
    pub attributes: Vec<Formula>,
    /// What follows from the motion.
    pub feedback: Vec<Law>,
    /// The mechanism, if there is one, and nothing that its derivation depends on is a mistake.
    pub assembly: Option<Assembly>,
    /// The parameter sets.
    pub sets: Vec<CheckedSet>,
    /// The parameter that is the gravitational field strength.
    pub gravity: Option<usize>,
    /// The units of formulas.
    pub units: Units,
    /// Which derivatives of the matrices are asked for.
    pub derivatives: Option<AskedDerivatives>,
    /// The names in the declaration, for editors.
    pub references: References,
}

impl Checked<'_> {
    /// The name of the definition at a position of formulas.
    pub fn definition(&self, index: usize) -> &Ident {
        &self.declaration.definitions[self.order[index]].name
    }
}

/// Checks a declaration. Mistakes are noted in the report.
pub fn check<'a>(declaration: &'a Declaration, report: &mut Report) -> Checked<'a> {
    let is_complete = report.is_empty();
    if declaration.parameters.is_empty() && is_complete {
        report.error(&declaration.name, "no parameters: expected `parameters { … }` with at least one");
    }
    let rust_attributes = rust_attributes::read_rust_attributes(declaration, report);
    // What names mean comes before all formulas, in which they stand.
    let mut scope = Scope::new(declaration, report);
    let dimensions = Dimensions::new(declaration, report);
    // Before mistakes elsewhere, beside which it would not be looked at.
    let tree =
        declaration.mechanism.as_ref().and_then(|mechanism| mechanism::find_tree(declaration, mechanism, report));
    if let Some(span) = declaration.nonlinear {
        mechanism::check_nonlinear(declaration, span, report);
    }

    let order = definitions::order(declaration, &scope, report);
    // From here on positions of definitions are those of the order, in every formula that is resolved.
    scope.number_definitions(&order.positions());
    scope.steady = order.steady;
    let (steady, unsteady) = order.declared.split_at(order.steady);
    let formula = |definition: &usize| &declaration.definitions[*definition].value;
    let definitions = steady.iter().map(formula).map(|f| resolve::resolve(f, &mut scope, report)).collect();
    let unsteady = unsteady.iter().map(formula).map(|f| resolve::resolve_in_speed(f, &mut scope, report)).collect();
    // Of definitions in a cycle the first mistake is the cycle.
    let ordered = if order.is_cyclic { &[] } else { &order.declared[..] };
    powers::check_powers(declaration, report);
    let allowed = declaration.requirements.iter();
    let allowed: Vec<_> =
        allowed.map(|written| domains::read_domain(std::slice::from_ref(&written.bound), None, report)).collect();
    let units::Found { definitions: defined, requirements: required } =
        units::check(declaration, &allowed, &dimensions, &scope, ordered, report);
    // Mistakes so far keep a mechanism from being derived; those behind it do not concern it.
    matrices::check_added(declaration, &mut scope, report);
    let (attributes, assembly) = check_mechanism(declaration, tree, &dimensions, &defined, &mut scope, report);

    let feedback = feedback::read_feedback(declaration, &mut scope, report);
    let requirements = resolve_requirements(declaration, &allowed, &required, &mut scope, report);
    let (assertions, asserted) = resolve_assertions(declaration, &mut scope, report);
    let written = matrices::resolve_matrices(declaration, is_complete, &mut scope, report);

    // Sets give the parameters values inside their domains.
    let own = declaration.parameters.iter().zip(&dimensions.parameters);
    let domains: Vec<_> = own.map(|(parameter, own)| domains::read_domain(&parameter.bounds, *own, report)).collect();
    let parameters = sets::Parameters { domains: &domains, dimensions: &dimensions.parameters };
    let sets = sets::read_sets(declaration, &parameters, report);
    let gravity = find_gravity(declaration, report);
    let derivatives = derivatives::read_derivatives(declaration, &mut scope, report);
    let references = references::find_references(declaration, &scope, &defined);
    Checked {
        declaration,
        is_complete,
        rust_attributes,
        // Every formula has been resolved, and each may have added to them.
        excused: scope.excused,
        domains: domains.iter().map(|domain| domain.to_model()).collect(),
        order: order.declared,
        definitions,
        unsteady,
        requirements,
        assertions,
        asserted,
        written,
        attributes,
        feedback,
        assembly,
        sets,
        gravity,
        derivatives,
        units: Units::new(declaration, dimensions, defined.into_iter().take(order.steady).collect()),
        references,
    }
}

/// What equations of motion are derived from, one by one, and the mechanism if there is no mistake so far. `defined` are
/// the dimensions of the definitions.
fn check_mechanism(
    declaration: &Declaration,
    tree: Option<Tree>,
    dimensions: &Dimensions,
    defined: &[Option<Dimension>],
    scope: &mut Scope,
    report: &mut Report,
) -> (Vec<Formula>, Option<Assembly>) {
    let Some(mechanism) = &declaration.mechanism else { return (Vec::new(), None) };
    units::check_mechanism(declaration, mechanism, dimensions, scope, defined, report);
    let loads = Loads::new(declaration, mechanism);
    // Where nothing is derived yet, a load is some force.
    let attributes = loads.resolve(declaration, scope, |_| Formula::one(), report);
    let derived = loads.resolve(declaration, scope, Formula::Parameter, &mut Report::default());
    let assembly = mechanism::assemble(declaration, mechanism, tree, &derived, loads.first(), report);
    // Without coordinates it is not known what is determined by others.
    let assembly = assembly.filter(|_| report.is_empty() && !declaration.coordinates.is_empty());
    (attributes, assembly)
}

/// `allowed` are the values that the requirements allow, and `dimensions` those of what they bound.
fn resolve_requirements(
    declaration: &Declaration,
    allowed: &[ExactDomain],
    dimensions: &[Option<Dimension>],
    scope: &mut Scope,
    report: &mut Report,
) -> Vec<Requirement> {
    let requirements = declaration.requirements.iter().zip(allowed).zip(dimensions);
    let requirements = requirements.map(|((requirement, allowed), dimension)| Requirement {
        text: requirement.value.to_string(),
        unit: dimension.map(|dimension| dimension.to_string()).unwrap_or_default(),
        region: requirement.value.region,
        value: resolve::resolve(&requirement.value, scope, report),
        domain: allowed.to_model(),
        origin: Origin::Declared,
    });
    requirements.collect()
}

/// Both sides of each assertion of a formula.
type Assertions = Vec<[Formula; 2]>;

/// The rows of each matrix whose entries are asserted.
type Asserted = Vec<Vec<Vec<Formula>>>;

fn resolve_assertions(declaration: &Declaration, scope: &mut Scope, report: &mut Report) -> (Assertions, Asserted) {
    let mut resolve = |formula| resolve::resolve(formula, scope, report);
    let assertions = declaration.assertions.iter();
    let assertions = assertions.map(|assertion| [&assertion.left, &assertion.right].map(&mut resolve)).collect();
    let asserted = declaration.asserted.iter().map(|matrix| {
        let rows = matrix.rows.iter().map(|(_, row)| row.iter().map(&mut resolve).collect());
        rows.collect()
    });
    (assertions, asserted.collect())
}

fn find_gravity(declaration: &Declaration, report: &mut Report) -> Option<usize> {
    let mut found = None;
    for (index, parameter) in declaration.parameters.iter().enumerate() {
        let Some(span) = parameter.gravity else { continue };
        if found.is_some() {
            report.error(span, "a second `gravity`: expected one parameter that is the gravitational field strength");
        }
        found.get_or_insert(index);
    }
    found
}
