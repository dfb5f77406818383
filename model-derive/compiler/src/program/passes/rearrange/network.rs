//! Sums and products of two operands each, of which no two are equal, and every change of which can be taken back.

use super::known::Known;

/// The position of a node.
pub type Node = usize;

/// A node or its negative. Signs are free: the pass `signs` moves them to where they cost nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Signed {
    pub node: Node,
    pub minus: bool,
}

impl Signed {
    /// With the other sign, if that is asked for.
    pub fn signed(self, minus: bool) -> Self {
        Self { minus: self.minus != minus, ..self }
    }
}

/// What computes a node. Operands are in order, and the first term is added: see [`Operation::sum`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// What is neither a sum nor a product, at this position of those.
    Other(usize),
    Sum(Signed, Signed),
    Product(Node, Node),
}

impl Operation {
    /// The sum of two nodes, and whether that is the negative of it.
    pub fn sum(a: Signed, b: Signed) -> (Self, bool) {
        let (first, second) = if a <= b { (a, b) } else { (b, a) };
        (Self::Sum(first.signed(first.minus), second.signed(first.minus)), first.minus)
    }

    pub fn product(a: Node, b: Node) -> Self {
        Self::Product(a.min(b), a.max(b))
    }

    pub fn operands(self) -> Option<[Node; 2]> {
        match self {
            Self::Other(_) => None,
            Self::Sum(a, b) => Some([a.node, b.node]),
            Self::Product(a, b) => Some([a, b]),
        }
    }

    fn cost(self) -> usize {
        usize::from(self.operands().is_some())
    }

    /// With another node in the place of one, and whether that is the negative of it.
    fn replace(self, node: Node, by: Signed) -> (Self, bool) {
        match self {
            Self::Other(_) => (self, false),
            Self::Sum(a, b) => {
                let [a, b] = [a, b].map(|term| if term.node == node { by.signed(term.minus) } else { term });
                Self::sum(a, b)
            }
            Self::Product(a, b) => {
                let minus = ((a == node) != (b == node)) && by.minus;
                let [a, b] = [a, b].map(|factor| if factor == node { by.node } else { factor });
                (Self::product(a, b), minus)
            }
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct State {
    operation: Operation,
    /// Whether the value is the negative of what the operation gives.
    minus: bool,
    /// How many operands and outputs it is; nothing computes a node without.
    users: usize,
}

enum Change {
    Made(Node),
    Freed(Node),
    Operation(Node, Operation, bool),
    User(Node),
    UserLess(Node),
    Known(Operation, Node),
    Forgotten(Operation, Node),
}

/// The operations of a program.
#[derive(Default)]
pub struct Network {
    states: Vec<State>,
    known: Known,
    free: Vec<Node>,
    /// What was changed since the last [`Network::commit`].
    changes: Vec<Change>,
    /// How many sums and products there are.
    cost: usize,
}

impl Network {
    /// How many nodes there may be.
    pub fn len(&self) -> usize {
        self.states.len()
    }

    /// How many sums and products there are.
    pub fn cost(&self) -> usize {
        self.cost
    }

    /// What computes a node, and whether its value is the negative of that.
    pub fn operation(&self, node: Node) -> (Operation, bool) {
        let State { operation, minus, .. } = self.states[node];
        (operation, minus)
    }

    pub fn users(&self, node: Node) -> usize {
        self.states[node].users
    }

    /// The node that an operation computes, if there is one.
    pub fn find(&self, operation: Operation) -> Option<Node> {
        self.known.find(operation, |node| self.states[node].operation)
    }

    /// The value of an operation, computed once.
    pub fn make(&mut self, operation: Operation) -> Signed {
        if let Some(node) = self.find(operation) {
            return Signed { node, minus: self.states[node].minus };
        }
        self.add_users(operation);
        let state = State { operation, minus: false, users: 0 };
        let node = match self.free.pop() {
            Some(node) => {
                self.states[node] = state;
                node
            }
            None => {
                self.states.push(state);
                self.states.len() - 1
            }
        };
        self.cost += operation.cost();
        self.know(operation, node);
        self.changes.push(Change::Made(node));
        Signed { node, minus: false }
    }

    pub fn sum(&mut self, a: Signed, b: Signed) -> Signed {
        let (operation, minus) = Operation::sum(a, b);
        self.make(operation).signed(minus)
    }

    pub fn product(&mut self, a: Node, b: Node) -> Signed {
        self.make(Operation::product(a, b))
    }

    pub fn add_user(&mut self, node: Node) {
        self.changes.push(Change::User(node));
        self.states[node].users += 1;
    }

    fn add_users(&mut self, operation: Operation) {
        if let Some([a, b]) = operation.operands() {
            self.add_user(a);
            self.add_user(b);
        }
    }

    /// One user less: what nobody uses goes, with what only that used.
    pub fn drop_user(&mut self, node: Node) {
        // With a stack of our own: long programs must not exhaust the thread's.
        let mut left = Vec::new();
        let mut next = Some(node);
        while let Some(node) = next {
            self.changes.push(Change::UserLess(node));
            self.states[node].users -= 1;
            let State { operation, users, .. } = self.states[node];
            next = match operation.operands() {
                Some([a, b]) if users == 0 => {
                    self.free(node, operation);
                    left.push(a);
                    Some(b)
                }
                _ => left.pop(),
            };
        }
    }

    fn drop_users(&mut self, operation: Operation) {
        if let Some([a, b]) = operation.operands() {
            self.drop_user(a);
            self.drop_user(b);
        }
    }

    /// Another operation computes a node, whose value stays what it is.
    pub fn redefine(&mut self, node: Node, operation: Operation, minus: bool) {
        let State { operation: old, minus: old_minus, .. } = self.states[node];
        self.add_users(operation);
        self.changes.push(Change::Operation(node, old, old_minus));
        self.states[node].operation = operation;
        self.states[node].minus = minus;
        self.know(operation, node);
        self.cost = self.cost + operation.cost() - old.cost();
        self.drop_users(old);
        self.sweep();
    }

    /// A node is not found any more by what computes it, since something else will.
    pub fn forget(&mut self, node: Node) {
        let operation = self.states[node].operation;
        if self.known.remove(operation, node) {
            self.changes.push(Change::Forgotten(operation, node));
        }
    }

    /// What was made and has no user goes.
    pub fn sweep(&mut self) {
        for position in (0..self.changes.len()).rev() {
            let Change::Made(node) = self.changes[position] else { continue };
            let State { operation, users, .. } = self.states[node];
            if users == 0 && self.find(operation) == Some(node) {
                self.free(node, operation);
                self.drop_users(operation);
            }
        }
    }

    /// Puts a value in the place of a node that is equal to it, and of what becomes equal by that. Returns what is in the
    /// place of what. It cannot be taken back.
    pub fn merge(&mut self, node: Node, with: Signed) -> Vec<(Node, Signed)> {
        let mut merged: Vec<(Node, Signed)> = Vec::new();
        let mut left = vec![(node, with)];
        // What is to be put in a place has a user until it is there, or it might go with what goes before.
        self.add_user(with.node);
        while let Some((node, with)) = left.pop() {
            // What it is equal to may be in the place of something else by now.
            let with = merged.iter().fold(
                with,
                |with, (gone, by)| {
                    if with.node == *gone { by.signed(with.minus) } else { with }
                },
            );
            let State { operation: old, users, .. } = self.states[node];
            if users == 0 {
                self.drop_user(with.node);
                continue;
            }
            for user in 0..self.states.len() {
                let State { operation, users, .. } = self.states[user];
                if users == 0 || !operation.operands().is_some_and(|operands| operands.contains(&node)) {
                    continue;
                }
                self.forget(user);
                let (new, minus) = operation.replace(node, with);
                self.states[user].operation = new;
                self.states[user].minus ^= minus;
                match self.find(new) {
                    Some(equal) => {
                        let minus = self.states[user].minus != self.states[equal].minus;
                        self.add_user(equal);
                        left.push((user, Signed { node: equal, minus }));
                    }
                    None => self.know(new, user),
                }
            }
            self.states[with.node].users += users;
            self.states[node].users = 0;
            self.forget(node);
            self.free(node, old);
            self.drop_users(old);
            self.drop_user(with.node);
            self.commit();
            merged.push((node, with));
        }
        merged
    }

    /// What was changed stays.
    pub fn commit(&mut self) {
        let freed = self.changes.drain(..).filter_map(|change| match change {
            Change::Freed(node) => Some(node),
            _ => None,
        });
        self.free.extend(freed);
    }

    /// Takes back what was changed since the last [`Network::commit`].
    pub fn undo(&mut self) {
        while let Some(change) = self.changes.pop() {
            match change {
                Change::Made(node) => {
                    self.cost -= self.states[node].operation.cost();
                    self.free.push(node);
                }
                Change::Freed(node) => self.cost += self.states[node].operation.cost(),
                Change::Operation(node, operation, minus) => {
                    let state = &mut self.states[node];
                    self.cost = self.cost + operation.cost() - state.operation.cost();
                    (state.operation, state.minus) = (operation, minus);
                }
                Change::User(node) => self.states[node].users -= 1,
                Change::UserLess(node) => self.states[node].users += 1,
                Change::Known(operation, node) => drop(self.known.remove(operation, node)),
                Change::Forgotten(operation, node) => self.known.insert(operation, node),
            }
        }
    }

    fn know(&mut self, operation: Operation, node: Node) {
        self.known.insert(operation, node);
        self.changes.push(Change::Known(operation, node));
    }

    fn free(&mut self, node: Node, operation: Operation) {
        self.forget(node);
        self.cost -= operation.cost();
        self.changes.push(Change::Freed(node));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_takes_a_place_does_not_go_with_what_was_there() {
        // With n = (x - c) + c, which is x, n - c is the x - c that only n uses.
        let mut network = Network::default();
        let [x, c] = [0, 1].map(|index| network.make(Operation::Other(index)));
        let difference = network.sum(x, c.signed(true));
        let n = network.sum(difference, c);
        let equal = network.sum(n, c.signed(true));
        let output = network.product(equal.node, x.node);
        [x, c, output].into_iter().for_each(|used| network.add_user(used.node));
        network.commit();
        assert_eq!(network.cost(), 4);
        // It is known as c - n, so that it is the negative of itself.
        let merged = network.merge(n.node, x);
        assert_eq!(merged, [(n.node, x), (equal.node, difference.signed(true))]);
        assert_eq!(network.operation(output.node).0, Operation::product(difference.node, x.node));
        assert_eq!(network.find(network.operation(difference.node).0), Some(difference.node));
        assert_eq!(network.cost(), 2);
        assert_eq!([x, c, difference, output].map(|node| network.users(node.node)), [3, 2, 1, 1]);
    }
}
