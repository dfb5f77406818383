//! Derivatives of formulas with respect to the parameters, through the definitions that they use.
//!
//! A formula written out in the parameters can be exponentially longer than its definitions, and so can its derivative.
//! So the engine derives each formula with respect to the names that stand in it, and what follows by the chain rule
//! stays a sum of products of those partial derivatives, which are definitions in their turn.

use std::collections::{BTreeMap, BTreeSet};

use nanoserde::{DeBin, SerBin};

use super::door::ask;
use super::engine::Engine;
use super::failure::{Failure, Place, Undefined};
use super::form::Form;
use super::prove::{Depth, Proof, prove};
use super::sample::Sample;
use super::vertex_elimination::Graph;
use crate::equations::Equations;
use crate::formula::{Factor, Formula, Function};

/// Formulas together with those of their derivatives.
#[derive(Clone, Debug, DeBin, SerBin)]
pub struct Differentiated {
    /// The outputs of the equations, then their derivatives.
    pub equations: Equations,
    /// For each derivative the output and the parameter: all wanted ones that are not zero for all parameters, by parameters.
    pub partials: Vec<(usize, usize)>,
    /// For each definition that is new, by its origin, what it is the derivative of, and with respect to what.
    pub definitions: BTreeMap<usize, [Node; 2]>,
}

/// Which derivatives are wanted.
#[derive(Clone, Debug, SerBin)]
pub struct Wanted {
    /// For each output whether they are.
    pub outputs: Vec<bool>,
    /// For each parameter whether those with respect to it are.
    pub parameters: Vec<bool>,
}

/// What the chain rule leads through.
#[derive(Clone, Copy, Debug, DeBin, PartialEq, Eq, PartialOrd, Ord, SerBin)]
pub enum Node {
    /// The parameter at a position.
    Parameter(usize),
    /// The definition at a position of the equations.
    Definition(usize),
    /// The output at a position.
    Output(usize),
}

/// The derivatives of outputs of equations with respect to parameters. The origins of definitions that are new
/// lie `beyond` those of the model.
///
/// # Errors
/// If the engine cannot be had or fails, or if a formula has no value.
pub fn derive(equations: Vec<Equations>, wanted: Wanted, beyond: usize) -> Result<Vec<Differentiated>, Failure> {
    ask("derivatives", (equations, wanted, beyond), |engine, (equations, wanted, beyond)| {
        let differentiate = |(index, equations)| match Chain::new(engine, equations, wanted, *beyond) {
            Ok(chain) => Ok(chain.differentiate()),
            Err((place, why)) => Err(Failure::Undefined { equations: index, place, why }),
        };
        equations.iter().enumerate().map(differentiate).collect()
    })
}

/// Partial derivatives that are left to be multiplied along the ways from outputs to parameters.
struct Chain<'a> {
    engine: &'a Engine,
    wanted: &'a Wanted,
    equations: Equations,
    /// For each output the first one that is the same formula: the mirror image of an entry.
    first: Vec<usize>,
    /// For each definition and output the derivatives with respect to what stands in it.
    partials: BTreeMap<Node, BTreeMap<Node, Form>>,
    /// The definitions that are new, by their origins.
    definitions: BTreeMap<usize, [Node; 2]>,
    /// The origin of the next one.
    next: usize,
    /// Values of the parameters and of the definitions.
    samples: [Vec<Sample>; 2],
}

impl<'a> Chain<'a> {
    fn new(
        engine: &'a Engine,
        equations: &Equations,
        wanted: &'a Wanted,
        beyond: usize,
    ) -> Result<Self, (Place, Undefined)> {
        let parameters = equations.parameters;
        let values = engine.definitions(parameters, equations.definitions.len());
        let outputs = &equations.outputs;
        let first = |output| outputs.iter().position(|other| other == output).unwrap_or_default();
        let mut chain = Self {
            engine,
            wanted,
            first: outputs.iter().map(first).collect(),
            equations: equations.clone(),
            partials: BTreeMap::new(),
            definitions: BTreeMap::new(),
            next: equations.origins.iter().map(|origin| origin + 1).fold(beyond, usize::max),
            samples: [Sample::spread(0, parameters), Vec::new()],
        };
        for (index, formula) in equations.definitions.iter().enumerate() {
            let form =
                engine.form(formula, &values).map_err(|why| (Place::Definition(equations.origins[index]), why))?;
            chain.samples[1].push(Sample::of(formula, &chain.samples[0], &chain.samples[1]));
            chain.add(Node::Definition(index), formula, &form);
        }
        for (index, formula) in equations.outputs.iter().enumerate() {
            if !chain.is_first_of_wanted(index) {
                continue;
            }
            let form = engine.form(formula, &values).map_err(|why| (Place::Output(index), why))?;
            chain.add(Node::Output(index), formula, &form);
        }
        Ok(chain)
    }

    /// Whether an output, or one that is the same formula, is wanted, and none before it is that.
    fn is_first_of_wanted(&self, output: usize) -> bool {
        let mut same = (0..self.first.len()).filter(|other| self.first[*other] == output);
        same.any(|other| self.wanted.outputs[other])
    }

    /// Notes the partial derivatives of a formula.
    fn add(&mut self, node: Node, formula: &Formula, form: &Form) {
        let mut inside = BTreeSet::new();
        formula.walk(&mut |part| match part {
            Formula::Parameter(index) if self.wanted.parameters[*index] => {
                inside.insert((*index, Node::Parameter(*index)));
            }
            Formula::Definition(index) => {
                inside.insert((self.equations.parameters + index, Node::Definition(*index)));
            }
            _ => {}
        });
        let power = self.find_power(node, formula, form);
        let partial = |(symbol, with)| {
            let partial = form.derivative(symbol);
            (with, power.as_ref().map_or(partial.clone(), |[power, value]| partial.replace(power, value)))
        };
        let partials = inside.into_iter().map(partial).filter(|(_, partial)| !partial.is_nothing()).collect();
        self.partials.insert(node, partials);
    }

    /// The power of a definition that its derivative is a multiple of, and the same in its name: the square of a
    /// reciprocal, or the reciprocal of a root.
    fn find_power(&self, node: Node, formula: &Formula, form: &Form) -> Option<[Form; 2]> {
        let Node::Definition(index) = node else { return None };
        let name = self.engine.definition(self.equations.parameters, index);
        match formula {
            Formula::Product(factors) if is_reciprocal(factors) => Some([form * form, &name * &name]),
            Formula::Call(Function::Sqrt, _) => Some([form, &name].map(|root| Form::number(1).over(root))),
            _ => None,
        }
    }

    /// The formulas with all their derivatives.
    fn differentiate(mut self) -> Differentiated {
        let (graph, nodes) = self.build_graph();
        for node in graph.order(&nodes) {
            self.take_out(Node::Definition(node - self.equations.parameters));
        }
        let mut partials = Vec::new();
        for parameter in 0..self.equations.parameters {
            for output in (0..self.first.len()).filter(|output| self.wanted.outputs[*output]) {
                let of_output = self.partials.get(&Node::Output(self.first[output]));
                let partial = of_output.and_then(|partials| partials.get(&Node::Parameter(parameter)));
                let partial = partial.map(|partial| partial.to_formula(self.equations.parameters));
                if let Some(partial) = partial.filter(|partial| !self.is_zero(partial)) {
                    self.equations.outputs.push(partial);
                    partials.push((output, parameter));
                }
            }
        }
        Differentiated { equations: self.equations, partials, definitions: self.definitions }
    }

    /// Which derivatives there are, and the nodes of the definitions in it.
    fn build_graph(&self) -> (Graph, Vec<usize>) {
        let Equations { parameters, definitions, outputs, .. } = &self.equations;
        let position = |node: &Node| match *node {
            Node::Parameter(index) => index,
            Node::Definition(index) => parameters + index,
            Node::Output(index) => parameters + definitions.len() + index,
        };
        let units = [1, -1].map(Form::number);
        let mut graph = Graph::new(parameters + definitions.len() + outputs.len());
        for (user, partials) in &self.partials {
            partials.iter().for_each(|(with, partial)| {
                graph.insert(position(user), position(with), units.contains(partial));
            });
        }
        (graph, (*parameters..parameters + definitions.len()).collect())
    }

    /// Takes a definition out: what was derived with respect to it is derived with respect to what stands in it.
    fn take_out(&mut self, node: Node) {
        let inner = self.partials.remove(&node).unwrap_or_default();
        let users: Vec<Node> =
            self.partials.iter().filter(|(_, partials)| partials.contains_key(&node)).map(|(user, _)| *user).collect();
        let inner: Vec<(Node, Form)> = inner
            .into_iter()
            .filter_map(|(with, partial)| Some((with, self.name([node, with], partial, users.len())?)))
            .collect();
        for user in users {
            let Some(outer) = self.partials.get_mut(&user).and_then(|partials| partials.remove(&node)) else {
                continue;
            };
            let Some(outer) = self.name([user, node], outer, inner.len()) else { continue };
            for (with, partial) in &inner {
                let product = &outer * partial;
                let partials = self.partials.entry(user).or_default();
                let sum = match partials.remove(with) {
                    Some(partial) => &partial + &product,
                    None => product,
                };
                if !sum.is_nothing() {
                    partials.insert(*with, sum);
                }
            }
        }
    }

    /// A derivative that stands in so many products: as a definition of its own, if it is worth one, and nothing if it
    /// is zero.
    fn name(&mut self, of: [Node; 2], partial: Form, products: usize) -> Option<Form> {
        if partial.is_short() || products < 2 {
            return Some(partial);
        }
        let parameters = self.equations.parameters;
        let formula = partial.to_formula(parameters);
        if self.is_zero(&formula) {
            return None;
        }
        let index = self.equations.definitions.len();
        self.samples[1].push(Sample::of(&formula, &self.samples[0], &self.samples[1]));
        self.equations.definitions.push(formula);
        self.equations.origins.push(self.next);
        self.definitions.insert(self.next, of);
        self.next += 1;
        Some(self.engine.definition(parameters, index))
    }

    /// Whether a formula is proved to be zero for all parameters.
    fn is_zero(&self, formula: &Formula) -> bool {
        let [parameters, definitions] = &self.samples;
        if Sample::of(formula, parameters, definitions).is_not_zero() {
            return false;
        }
        let outputs = vec![formula.clone(), Formula::zero()];
        prove(self.engine, &Equations { outputs, ..self.equations.clone() }, Depth::Formulas) == Ok(Proof::Found)
    }
}

/// Whether a product is one divided by something.
fn is_reciprocal(factors: &[Factor]) -> bool {
    matches!(factors, [Factor { inverse: false, value }, Factor { inverse: true, .. }] if *value == Formula::one())
}
