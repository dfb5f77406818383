//! Pairs of factors, and of terms, that several products or sums have in common are computed once.
//!
//! It is the greedy extraction of two-term common subexpressions from n-ary operations (Breuer 1969; Hosangadi, Fallah &
//! Kastner 2006): time and again the pair that occurs most often becomes an operation of its own.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use rustc_hash::FxHashMap;

use super::nary::{NaryProgram, Node, Operation};
use crate::program::Program;

/// Afterwards no two products have two factors in common, and no two sums two terms or their negatives, unless those are
/// one value.
pub fn extract(program: Program) -> Program {
    let mut nary = NaryProgram::flatten(&program);
    let needed = nary.needed();
    let of = |nary: &NaryProgram, operands: fn(&Operation) -> Option<Vec<Operand>>| -> Vec<(Node, Vec<Operand>)> {
        let nodes = nary.nodes.iter().enumerate().filter(|(node, _)| needed.get(*node).is_none_or(|needed| *needed));
        nodes.filter_map(|(node, operation)| Some((node, operands(operation)?))).collect()
    };
    let products = of(&nary, |operation| match operation {
        Operation::Product(factors) => Some(factors.iter().map(|factor| (*factor, false)).collect()),
        _ => None,
    });
    for (node, operands) in extract_pairs(products, nary.nodes.len()) {
        put(&mut nary, node, Operation::Product(operands.into_iter().map(|(factor, _)| factor).collect()));
    }
    let sums = of(&nary, |operation| match operation {
        Operation::Sum(terms) => Some(terms.clone()),
        _ => None,
    });
    for (node, operands) in extract_pairs(sums, nary.nodes.len()) {
        put(&mut nary, node, Operation::Sum(operands));
    }
    nary.into_program()
}

fn put(nary: &mut NaryProgram, node: Node, operation: Operation) {
    if node == nary.nodes.len() {
        nary.nodes.push(operation);
    } else {
        nary.nodes[node] = operation;
    }
}

/// A node, and whether it is subtracted.
type Operand = (Node, bool);

/// Two operands of one operation: the smaller node is taken as it is, and the other has the sign that it has beside it.
type Pair = (Node, Operand);

fn pair(a: Operand, b: Operand) -> Pair {
    let (first, second) = if a.0 <= b.0 { (a, b) } else { (b, a) };
    (first.0, (second.0, first.1 != second.1))
}

/// Of a longer operation only so many operands are looked at, since the pairs grow with the square.
const MAX_OPERANDS: usize = 48;

/// The operations with what they have in common in nodes of its own, which are numbered from `next` on, in this order behind them.
fn extract_pairs(mut nodes: Vec<(Node, Vec<Operand>)>, next: Node) -> Vec<(Node, Vec<Operand>)> {
    let mut pairs = Pairs::default();
    let old = nodes.len();
    nodes.iter().enumerate().for_each(|(index, (_, operands))| pairs.note(index, operands));
    while let Some((pair, users)) = pairs.most() {
        let (first, second) = pair;
        let node = next + nodes.len() - old;
        for index in users {
            let operands = &mut nodes[index].1;
            pairs.forget(index, operands);
            // All of them, as long as both are there.
            while let Some([a, b]) = positions(operands, pair) {
                let minus = operands[a].1;
                operands.remove(a.max(b));
                operands.remove(a.min(b));
                operands.push((node, minus));
            }
            pairs.note(index, &nodes[index].1);
        }
        nodes.push((node, vec![(first, false), second]));
        let last = nodes.len() - 1;
        pairs.note(last, &nodes[last].1);
    }
    nodes
}

/// Where a pair stands among operands, if both of it are there.
fn positions(operands: &[Operand], (first, (second, opposite)): Pair) -> Option<[usize; 2]> {
    operands.iter().enumerate().find_map(|(a, operand)| {
        let other = (second, operand.1 != opposite);
        let b = (operand.0 == first).then(|| (0..operands.len()).find(|b| *b != a && operands[*b] == other))?;
        Some([a, b?])
    })
}

/// The pairs, and where they are.
#[derive(Default)]
struct Pairs {
    /// For each pair the nodes that have it, each with how often.
    users: FxHashMap<Pair, Vec<(usize, usize)>>,
    /// By how often they occur, those that occur more than once.
    often: BTreeSet<(usize, Reverse<Pair>)>,
}

/// How often pairs occur among operands, counting no operand twice.
fn pairs(operands: &[Operand]) -> Vec<(Pair, usize)> {
    let mut sorted = operands[..operands.len().min(MAX_OPERANDS)].to_vec();
    sorted.sort_unstable();
    let counts: Vec<(Operand, usize)> = sorted.chunk_by(|a, b| a == b).map(|equal| (equal[0], equal.len())).collect();
    let mut pairs = Vec::with_capacity(counts.len() * counts.len() / 2);
    for (position, (a, many)) in counts.iter().enumerate() {
        if *many > 1 {
            pairs.push((pair(*a, *a), many / 2));
        }
        let others = counts[position + 1..].iter().filter(|(b, _)| a.0 != b.0);
        pairs.extend(others.map(|(b, more)| (pair(*a, *b), *many.min(more))));
    }
    pairs
}

impl Pairs {
    fn change(&mut self, operands: &[Operand], change: impl Fn(&mut Vec<(usize, usize)>, usize)) {
        for (pair, count) in pairs(operands) {
            let users = self.users.entry(pair).or_default();
            let total = |users: &[(usize, usize)]| users.iter().map(|(_, count)| count).sum::<usize>();
            let before = total(users);
            change(users, count);
            let after = total(users);
            if before > 1 {
                self.often.remove(&(before, Reverse(pair)));
            }
            if after > 1 {
                self.often.insert((after, Reverse(pair)));
            }
        }
    }

    fn note(&mut self, node: usize, operands: &[Operand]) {
        self.change(operands, |users, count| users.push((node, count)));
    }

    fn forget(&mut self, node: usize, operands: &[Operand]) {
        self.change(operands, |users, count| {
            let position = users.iter().position(|user| *user == (node, count));
            position.map(|position| users.swap_remove(position));
        });
    }

    /// The pair that occurs most often, and its nodes; of several the one of the earliest nodes.
    fn most(&self) -> Option<(Pair, Vec<usize>)> {
        let (_, Reverse(pair)) = self.often.last()?;
        let mut users: Vec<usize> = self.users[pair].iter().map(|(node, _)| *node).collect();
        users.sort_unstable();
        users.dedup();
        Some((*pair, users))
    }
}
