//! Sums and products taken apart, and put together in another way.

use super::network::{Network, Node, Operation, Signed};
use crate::random::Random;

/// A term of a sum.
#[derive(Clone, Debug)]
struct Term {
    minus: bool,
    /// At least one, in order.
    factors: Vec<Node>,
}

/// What a node can be instead of what it is.
pub enum Other {
    /// The value of an operation, or its negative.
    Operation(Operation, bool),
    /// A value that is there.
    Value(Signed),
}

/// Sums with more terms, and products with more factors, are not taken apart further.
const MAX_TERMS: usize = 14;

// How often in a hundred times something is done. Half or twice as much of any of these makes no program of the shipped
// models shorter.

/// A sum or product that nothing else uses is taken apart with what uses it.
const OPEN: usize = 90;
/// One that is used elsewhere, too.
const OPEN_SHARED: usize = 20;
/// A factor in front of a sum is multiplied into it.
const DISTRIBUTE: usize = 30;
/// A factor that several terms have is put in front of them.
const FACTOR: usize = 70;
/// A pair that is there already is used.
const REUSE: usize = 95;

/// How often factors are put in front at most.
const MAX_FACTORED: usize = 4;

/// A network, and the random numbers that decide what is tried.
pub struct Rearrangement<'a> {
    pub network: &'a mut Network,
    pub random: &'a mut Random,
    /// Of the first nodes, whether they are numbers: those are not put in front of sums.
    pub is_number: &'a [bool],
}

impl Rearrangement<'_> {
    /// What a sum or product can be as well; nothing if it is neither, or comes out as zero.
    pub fn find_other(&mut self, node: Node) -> Option<Other> {
        match self.network.operation(node).0 {
            Operation::Other(_) => None,
            Operation::Sum(..) => {
                let mut terms = Vec::new();
                for term in self.take_sum_apart(node, false) {
                    match self.random.chance(DISTRIBUTE) {
                        true => self.distribute(term, &mut terms),
                        false => terms.push(term),
                    }
                }
                self.add(terms)
            }
            Operation::Product(..) => {
                let term = self.take_product_apart(Signed { node, minus: false }, true);
                let mut terms = Vec::new();
                match self.random.chance(DISTRIBUTE) {
                    true => self.distribute(term, &mut terms),
                    false => terms.push(term),
                }
                self.add(terms)
            }
        }
    }

    fn opens(&mut self, node: Node) -> bool {
        self.network.users(node) == 1 && self.random.chance(OPEN) || self.random.chance(OPEN_SHARED)
    }

    /// The terms of a sum.
    fn take_sum_apart(&mut self, node: Node, minus: bool) -> Vec<Term> {
        let mut terms = Vec::new();
        let mut left = vec![(Signed { node, minus }, true)];
        while let Some((value, first)) = left.pop() {
            match self.network.operation(value.node) {
                (Operation::Sum(a, b), minus)
                    if first || terms.len() + left.len() < MAX_TERMS && self.opens(value.node) =>
                {
                    left.extend([a, b].map(|term| (term.signed(value.minus != minus), false)));
                }
                _ => terms.push(self.take_product_apart(value, false)),
            }
        }
        terms
    }

    /// The factors of a value.
    fn take_product_apart(&mut self, value: Signed, first: bool) -> Term {
        let mut term = Term { minus: value.minus, factors: Vec::new() };
        let mut left = vec![(value.node, first)];
        while let Some((node, first)) = left.pop() {
            match self.network.operation(node) {
                (Operation::Product(a, b), minus)
                    if first || term.factors.len() + left.len() < MAX_TERMS && self.opens(node) =>
                {
                    term.minus ^= minus;
                    left.extend([(a, false), (b, false)]);
                }
                _ => term.factors.push(node),
            }
        }
        term.factors.sort_unstable();
        term
    }

    /// One of the sums among the factors is multiplied out.
    fn distribute(&mut self, term: Term, terms: &mut Vec<Term>) {
        let is_sum = |factor: &usize| matches!(self.network.operation(term.factors[*factor]).0, Operation::Sum(..));
        let sums: Vec<usize> = (0..term.factors.len()).filter(is_sum).collect();
        if sums.is_empty() || term.factors.len() < 2 || terms.len() > MAX_TERMS {
            return terms.push(term);
        }
        let Term { minus, mut factors } = term;
        let sum = factors.remove(sums[self.random.below(sums.len())]);
        for mut inner in self.take_sum_apart(sum, minus) {
            inner.factors.extend(&factors);
            inner.factors.sort_unstable();
            terms.push(inner);
        }
    }

    /// The sum of terms; nothing if it is zero.
    fn add(&mut self, mut terms: Vec<Term>) -> Option<Other> {
        let mut position = 0;
        while position < terms.len() {
            let Term { minus, factors } = &terms[position];
            let cancels = |other: &Term| other.minus != *minus && other.factors == *factors;
            match terms[position + 1..].iter().position(cancels) {
                Some(behind) => {
                    terms.remove(position + 1 + behind);
                    terms.remove(position);
                }
                None => position += 1,
            }
        }
        for _ in 0..MAX_FACTORED {
            if terms.len() < 2 || !self.random.chance(FACTOR) {
                break;
            }
            let Some(factor) = self.find_common_factor(&terms) else { break };
            terms = self.put_in_front(factor, terms)?;
        }
        if terms.len() == 1 {
            return terms.pop().map(|term| self.multiply(term));
        }
        let mut values: Vec<Signed> = terms.into_iter().map(|term| self.value_of(term)).collect();
        while values.len() > 2 {
            let [a, b] = self.choose(&values, |a, b| Operation::sum(a, b).0);
            let sum = self.network.sum(values[a], values[b]);
            values.remove(b);
            values.remove(a);
            values.push(sum);
        }
        let [a, b] = values[..] else { return None };
        let (operation, minus) = Operation::sum(a, b);
        // What cancels only here is left for another time.
        (a != b.signed(true)).then_some(Other::Operation(operation, minus))
    }

    /// A factor that more than one product has.
    fn find_common_factor(&mut self, terms: &[Term]) -> Option<Node> {
        let mut counts: Vec<(Node, usize)> = Vec::new();
        for term in terms.iter().filter(|term| term.factors.len() > 1) {
            for (position, factor) in term.factors.iter().enumerate() {
                if position > 0 && term.factors[position - 1] == *factor || self.is_number.get(*factor) == Some(&true) {
                    continue;
                }
                match counts.iter_mut().find(|(known, _)| known == factor) {
                    Some((_, count)) => *count += 1,
                    None => counts.push((*factor, 1)),
                }
            }
        }
        counts.retain(|(_, count)| *count > 1);
        (!counts.is_empty()).then(|| counts[self.random.below(counts.len())].0)
    }

    fn put_in_front(&mut self, factor: Node, terms: Vec<Term>) -> Option<Vec<Term>> {
        let (mut inside, mut outside) = (Vec::new(), Vec::new());
        for mut term in terms {
            match term.factors.iter().position(|other| *other == factor) {
                Some(position) if term.factors.len() > 1 => {
                    term.factors.remove(position);
                    inside.push(term);
                }
                _ => outside.push(term),
            }
        }
        let sum = match self.add(inside)? {
            Other::Operation(operation, minus) => self.network.make(operation).signed(minus),
            Other::Value(value) => value,
        };
        let mut factors = vec![factor, sum.node];
        factors.sort_unstable();
        outside.push(Term { minus: sum.minus, factors });
        Some(outside)
    }

    fn multiply(&mut self, mut term: Term) -> Other {
        let minus = self.multiply_down(&mut term.factors, 2) != term.minus;
        match term.factors[..] {
            [a, b] => Other::Operation(Operation::product(a, b), minus),
            _ => Other::Value(Signed { node: term.factors[0], minus }),
        }
    }

    fn value_of(&mut self, mut term: Term) -> Signed {
        let minus = self.multiply_down(&mut term.factors, 1) != term.minus;
        Signed { node: term.factors[0], minus }
    }

    /// Multiplies factors until so few are left, and says whether those have the negative product.
    fn multiply_down(&mut self, factors: &mut Vec<Node>, few: usize) -> bool {
        let mut minus = false;
        while factors.len() > few {
            let [a, b] = self.choose(factors, Operation::product);
            let product = self.network.product(factors[a], factors[b]);
            factors.remove(b);
            factors.remove(a);
            factors.push(product.node);
            minus ^= product.minus;
        }
        minus
    }

    /// The positions, in order, of two operands that are joined next.
    fn choose<T: Copy>(&mut self, operands: &[T], operation: impl Fn(T, T) -> Operation) -> [usize; 2] {
        let count = operands.len();
        if self.random.chance(REUSE) {
            let mut there: Vec<[usize; 2]> = Vec::new();
            for a in 0..count {
                for b in a + 1..count {
                    if self.network.find(operation(operands[a], operands[b])).is_some() {
                        there.push([a, b]);
                    }
                }
            }
            if !there.is_empty() {
                return there[self.random.below(there.len())];
            }
        }
        let (a, b) = (self.random.below(count), self.random.below(count - 1));
        let b = if b >= a { b + 1 } else { b };
        [a.min(b), a.max(b)]
    }
}
