//! Pairs of factors, and of terms, that several products or sums have in common are computed once.

use std::cmp::Reverse;
use std::collections::{BTreeSet, HashMap};

use super::chains::{Chain, Chains, Node};
use crate::program::Program;

/// Afterwards no two products have two factors in common, and no two sums two terms or their negatives, unless those are
/// one value.
pub fn share(program: Program) -> Program {
    let mut chains = Chains::of(&program);
    let needed = chains.needed();
    let of = |chains: &Chains, links: fn(&Chain) -> Option<Vec<Link>>| -> Vec<(Node, Vec<Link>)> {
        let nodes = chains.nodes.iter().enumerate().filter(|(node, _)| needed.get(*node).is_none_or(|needed| *needed));
        nodes.filter_map(|(node, chain)| Some((node, links(chain)?))).collect()
    };
    let products = of(&chains, |chain| match chain {
        Chain::Product(factors) => Some(factors.iter().map(|factor| (*factor, false)).collect()),
        _ => None,
    });
    for (node, links) in shared(products, chains.nodes.len()) {
        put(&mut chains, node, Chain::Product(links.into_iter().map(|(factor, _)| factor).collect()));
    }
    let sums = of(&chains, |chain| match chain {
        Chain::Sum(terms) => Some(terms.clone()),
        _ => None,
    });
    for (node, links) in shared(sums, chains.nodes.len()) {
        put(&mut chains, node, Chain::Sum(links));
    }
    chains.program()
}

fn put(chains: &mut Chains, node: Node, chain: Chain) {
    if node == chains.nodes.len() {
        chains.nodes.push(chain);
    } else {
        chains.nodes[node] = chain;
    }
}

/// A node, and whether it is subtracted.
type Link = (Node, bool);

/// Two links of one chain: the smaller node is taken as it is, and the other has the sign that it has beside it.
type Pair = (Node, Link);

fn pair(a: Link, b: Link) -> Pair {
    let (first, second) = if a.0 <= b.0 { (a, b) } else { (b, a) };
    (first.0, (second.0, first.1 != second.1))
}

/// Of a longer chain only so many links are looked at, since the pairs grow with the square.
const MAX_LINKS: usize = 48;

/// The chains with what they share in chains of its own, which are numbered from `next` on, in this order behind them.
fn shared(mut chains: Vec<(Node, Vec<Link>)>, next: Node) -> Vec<(Node, Vec<Link>)> {
    let mut pairs = Pairs::default();
    let old = chains.len();
    chains.iter().enumerate().for_each(|(index, (_, links))| pairs.note(index, links));
    while let Some((pair, users)) = pairs.most() {
        let (first, second) = pair;
        let node = next + chains.len() - old;
        for index in users {
            let links = &mut chains[index].1;
            pairs.forget(index, links);
            // All of them, as long as both are there.
            while let Some([a, b]) = positions(links, pair) {
                let minus = links[a].1;
                links.remove(a.max(b));
                links.remove(a.min(b));
                links.push((node, minus));
            }
            pairs.note(index, &chains[index].1);
        }
        chains.push((node, vec![(first, false), second]));
        let last = chains.len() - 1;
        pairs.note(last, &chains[last].1);
    }
    chains
}

/// Where a pair stands among links, if both of it are there.
fn positions(links: &[Link], (first, (second, opposite)): Pair) -> Option<[usize; 2]> {
    links.iter().enumerate().find_map(|(a, link)| {
        let other = (second, link.1 != opposite);
        let b = (link.0 == first).then(|| (0..links.len()).find(|b| *b != a && links[*b] == other))?;
        Some([a, b?])
    })
}

/// The pairs, and where they are.
#[derive(Default)]
struct Pairs {
    /// For each pair the chains that have it, each with how often.
    users: HashMap<Pair, Vec<(usize, usize)>>,
    /// By how often they occur, those that occur more than once.
    often: BTreeSet<(usize, Reverse<Pair>)>,
}

/// How often pairs occur among links, counting no link twice.
fn pairs(links: &[Link]) -> Vec<(Pair, usize)> {
    let mut sorted = links[..links.len().min(MAX_LINKS)].to_vec();
    sorted.sort_unstable();
    let counts: Vec<(Link, usize)> = sorted.chunk_by(|a, b| a == b).map(|equal| (equal[0], equal.len())).collect();
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
    fn change(&mut self, links: &[Link], change: impl Fn(&mut Vec<(usize, usize)>, usize)) {
        for (pair, count) in pairs(links) {
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

    fn note(&mut self, chain: usize, links: &[Link]) {
        self.change(links, |users, count| users.push((chain, count)));
    }

    fn forget(&mut self, chain: usize, links: &[Link]) {
        self.change(links, |users, count| {
            let position = users.iter().position(|user| *user == (chain, count));
            position.map(|position| users.swap_remove(position));
        });
    }

    /// The pair that occurs most often, and its chains; of several the one of the earliest nodes.
    fn most(&self) -> Option<(Pair, Vec<usize>)> {
        let (_, Reverse(pair)) = self.often.last()?;
        let mut users: Vec<usize> = self.users[pair].iter().map(|(chain, _)| *chain).collect();
        users.sort_unstable();
        users.dedup();
        Some((*pair, users))
    }
}
