//! Sums and products of two operands each, of which no two are equal, and every change of which can be taken back.

use rustc_hash::FxHashMap;

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
    State(Node, State),
    Known(Operation),
    Forgotten(Operation, Node),
}

/// The operations of a program.
#[derive(Default)]
pub struct Network {
    states: Vec<State>,
    known: FxHashMap<Operation, Node>,
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
        self.known.get(&operation).copied()
    }

    /// The value of an operation, computed once.
    pub fn make(&mut self, operation: Operation) -> Signed {
        if let Some(node) = self.find(operation) {
            return Signed { node, minus: self.states[node].minus };
        }
        operation.operands().into_iter().flatten().for_each(|operand| self.add_user(operand));
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
        self.change(node, |state| state.users += 1);
    }

    /// One user less: what nobody uses goes, with what only that used.
    pub fn drop_user(&mut self, node: Node) {
        let mut left = vec![node];
        while let Some(node) = left.pop() {
            self.change(node, |state| state.users -= 1);
            let State { operation, users, .. } = self.states[node];
            if let (0, Some(operands)) = (users, operation.operands()) {
                self.free(node, operation);
                left.extend(operands);
            }
        }
    }

    /// Another operation computes a node, whose value stays what it is.
    pub fn redefine(&mut self, node: Node, operation: Operation, minus: bool) {
        let old = self.states[node].operation;
        operation.operands().into_iter().flatten().for_each(|operand| self.add_user(operand));
        self.change(node, |state| (state.operation, state.minus) = (operation, minus));
        self.know(operation, node);
        self.cost = self.cost + operation.cost() - old.cost();
        old.operands().into_iter().flatten().for_each(|operand| self.drop_user(operand));
        self.sweep();
    }

    /// A node is not found any more by what computes it, since something else will.
    pub fn forget(&mut self, node: Node) {
        let operation = self.states[node].operation;
        if self.known.get(&operation) == Some(&node) {
            self.known.remove(&operation);
            self.changes.push(Change::Forgotten(operation, node));
        }
    }

    /// What was made and has no user goes.
    pub fn sweep(&mut self) {
        let made = self.changes.iter().filter_map(|change| match change {
            Change::Made(node) => Some(*node),
            _ => None,
        });
        for node in made.collect::<Vec<Node>>().into_iter().rev() {
            let State { operation, users, .. } = self.states[node];
            if users == 0 && self.known.get(&operation) == Some(&node) {
                self.free(node, operation);
                operation.operands().into_iter().flatten().for_each(|operand| self.drop_user(operand));
            }
        }
    }

    /// Puts a value in the place of a node that is equal to it, and of what becomes equal by that. Returns what is in the
    /// place of what. It cannot be taken back.
    pub fn merge(&mut self, node: Node, with: Signed) -> Vec<(Node, Signed)> {
        let mut merged: Vec<(Node, Signed)> = Vec::new();
        let mut left = vec![(node, with)];
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
                        left.push((user, Signed { node: equal, minus }));
                    }
                    None => self.know(new, user),
                }
            }
            self.states[with.node].users += users;
            self.states[node].users = 0;
            self.forget(node);
            self.free(node, old);
            old.operands().into_iter().flatten().for_each(|operand| self.drop_user(operand));
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
                Change::State(node, state) => {
                    self.cost = self.cost + state.operation.cost() - self.states[node].operation.cost();
                    self.states[node] = state;
                }
                Change::Known(operation) => drop(self.known.remove(&operation)),
                Change::Forgotten(operation, node) => drop(self.known.insert(operation, node)),
            }
        }
    }

    fn change(&mut self, node: Node, change: impl FnOnce(&mut State)) {
        self.changes.push(Change::State(node, self.states[node]));
        change(&mut self.states[node]);
    }

    fn know(&mut self, operation: Operation, node: Node) {
        self.known.insert(operation, node);
        self.changes.push(Change::Known(operation));
    }

    fn free(&mut self, node: Node, operation: Operation) {
        self.forget(node);
        self.cost -= operation.cost();
        self.changes.push(Change::Freed(node));
    }
}
