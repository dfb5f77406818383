//! Definitions in an order in which each uses only earlier ones.

use proc_macro2::Ident;

use super::names::{Meaning, Scope};
use crate::report::Report;
use crate::syntax::Declaration;

/// An order of the definitions.
#[derive(Debug)]
pub struct Order {
    /// Positions in the declaration, each behind those that it uses: first those that do not depend on the speed.
    pub declared: Vec<usize>,
    /// How many these are.
    pub steady: usize,
    /// Whether some definition depends on itself, so that there is no such order.
    pub is_cyclic: bool,
}

impl Order {
    /// For each position in the declaration the one in the order.
    pub fn positions(&self) -> Vec<usize> {
        let mut positions = vec![0; self.declared.len()];
        for (position, declared) in self.declared.iter().enumerate() {
            positions[*declared] = position;
        }
        positions
    }
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    New,
    Open,
    Done,
}

/// Puts the definitions in an order, as long as the scope numbers them as they are declared; cycles are reported.
pub fn order(declaration: &Declaration, scope: &Scope, report: &mut Report) -> Order {
    let uses: Vec<Vec<usize>> = declaration
        .definitions
        .iter()
        .map(|definition| {
            let mut uses = Vec::new();
            definition.value.names(&mut |name| {
                if let Some(Meaning::Definition(index)) = scope.get(name) {
                    uses.push(index);
                }
            });
            uses
        })
        .collect();
    let mut state = vec![State::New; uses.len()];
    let mut declared = Vec::new();
    let mut is_cyclic = false;
    for start in 0..uses.len() {
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
                declared.push(node);
                continue;
            };
            stack.push((node, next + 1));
            match state[used] {
                State::New => stack.push((used, 0)),
                State::Done => {}
                State::Open => {
                    is_cyclic = true;
                    let cycle = stack.iter().map(|(node, _)| *node).skip_while(|node| *node != used).chain([used]);
                    report_cycle(cycle.map(|node| &declaration.definitions[node].name).collect(), report);
                }
            }
        }
    }
    let mut is_steady = vec![true; uses.len()];
    for &index in &declared {
        let mut mentions = false;
        declaration.definitions[index].value.names(&mut |name| {
            mentions |= matches!(scope.get(name), Some(Meaning::Speed(_)));
        });
        is_steady[index] = !mentions && uses[index].iter().all(|used| is_steady[*used]);
    }
    // What uses one that is not steady is not steady itself: the order stays one.
    declared.sort_by_key(|index| !is_steady[*index]);
    let steady = declared.iter().filter(|index| is_steady[**index]).count();
    Order { declared, steady, is_cyclic }
}

/// Reports a cycle of definitions, each using the next, which ends where it begins.
fn report_cycle(cycle: Vec<&Ident>, report: &mut Report) {
    let names: Vec<String> = cycle.iter().map(|name| format!("`{name}`")).collect();
    let message = format!("a definition in a cycle: {}; expected definitions that end", names.join(" uses "));
    report.error(cycle[0], message);
}
