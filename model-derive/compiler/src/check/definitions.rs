//! Definitions in an order in which each uses only earlier ones.

use proc_macro2::Ident;

use super::names::Scope;
use super::resolve;
use crate::formula::Formula;
use crate::report::Report;
use crate::syntax::{Declaration, Expression};

/// The definitions, resolved, and their order.
#[derive(Debug)]
pub struct Resolved {
    /// By position in the declaration.
    pub definitions: Vec<Formula>,
    /// Positions in the declaration, each after those that it uses.
    pub order: Vec<usize>,
    /// Whether some definition depends on itself, so that there is no such order.
    pub cyclic: bool,
}

impl Resolved {
    /// The definitions with their names, in their order, and with references to them renumbered to match.
    pub fn in_order(&self, declaration: &Declaration) -> Vec<(Ident, Formula)> {
        let new = self.new_positions();
        let entry = |old: &usize| (declaration.definitions[*old].name.clone(), self.definitions[*old].renumbered(&new));
        self.order.iter().map(entry).collect()
    }

    /// The formulas of the definitions as they are written, in their order.
    pub fn sources<'a>(&self, declaration: &'a Declaration) -> Vec<&'a Expression> {
        self.order.iter().map(|old| &declaration.definitions[*old].value).collect()
    }

    /// For each position in the declaration the one in the order.
    pub fn new_positions(&self) -> Vec<usize> {
        let mut new = vec![0; self.definitions.len()];
        for (position, old) in self.order.iter().enumerate() {
            new[*old] = position;
        }
        new
    }
}

/// The definitions that a formula uses itself.
pub fn uses(expr: &Formula) -> Vec<usize> {
    let mut found = Vec::new();
    expr.walk(&mut |part| {
        if let Formula::Definition(index) = part {
            found.push(*index);
        }
    });
    found
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    New,
    Open,
    Done,
}

pub fn resolve(declaration: &Declaration, scope: &mut Scope, report: &mut Report) -> Resolved {
    let definitions: Vec<Formula> = declaration
        .definitions
        .iter()
        .map(|definition| resolve::expression(&definition.value, scope, report))
        .collect();
    let uses: Vec<Vec<usize>> = definitions.iter().map(uses).collect();
    let mut state = vec![State::New; definitions.len()];
    let mut order = Vec::new();
    let mut cyclic = false;
    for start in 0..definitions.len() {
        // Depth first with a stack of our own: a chain of thousands of definitions must not exhaust the thread's.
        let mut stack = vec![(start, 0)];
        while let Some((node, next)) = stack.pop() {
            if next == 0 {
                if state[node] != State::New {
                    continue;
                }
                state[node] = State::Open;
            }
            let Some(&used) = uses[node].get(next) else {
                state[node] = State::Done;
                order.push(node);
                continue;
            };
            stack.push((node, next + 1));
            match state[used] {
                State::New => stack.push((used, 0)),
                State::Done => {}
                State::Open => {
                    cyclic = true;
                    let path = stack.iter().map(|(node, _)| *node).skip_while(|node| *node != used);
                    let names: Vec<String> =
                        path.chain([used]).map(|node| format!("`{}`", declaration.definitions[node].name)).collect();
                    let message =
                        format!("a definition in a cycle: {}; expected definitions that end", names.join(" uses "));
                    report.error(&declaration.definitions[used].name, message);
                }
            }
        }
    }
    Resolved { definitions, order, cyclic }
}
