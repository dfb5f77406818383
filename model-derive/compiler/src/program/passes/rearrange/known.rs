//! Which node an operation is computed by.

use super::network::{Node, Operation, Signed};

/// So many lists of nodes.
const LISTS: usize = 1 << 12;

/// The nodes of operations, in lists by what the operation and its operands are: compiled without optimization, as the
/// compiler is in most builds, this takes a fraction of the time that maps of the standard library take.
pub struct Known {
    /// The first node of each list.
    first: Vec<Option<Node>>,
    /// Of each node the next one in its list.
    next: Vec<Option<Node>>,
}

impl Default for Known {
    fn default() -> Self {
        Self { first: vec![None; LISTS], next: Vec::new() }
    }
}

impl Known {
    /// The node of an operation, by what computes each node.
    pub fn find(&self, operation: Operation, of: impl Fn(Node) -> Operation) -> Option<Node> {
        let mut found = self.first[list_of(operation)];
        while let Some(node) = found {
            if of(node) == operation {
                break;
            }
            found = self.next[node];
        }
        found
    }

    /// Of an operation that no node is known for.
    pub fn insert(&mut self, operation: Operation, node: Node) {
        if node >= self.next.len() {
            self.next.resize(node + 1, None);
        }
        let first = &mut self.first[list_of(operation)];
        self.next[node] = *first;
        *first = Some(node);
    }

    /// Whether the node was known for its operation.
    pub fn remove(&mut self, operation: Operation, node: Node) -> bool {
        let first = &mut self.first[list_of(operation)];
        if *first == Some(node) {
            *first = self.next[node];
            return true;
        }
        let mut before = *first;
        while let Some(known) = before {
            before = self.next[known];
            if before == Some(node) {
                self.next[known] = self.next[node];
                return true;
            }
        }
        false
    }
}

/// Operations of one kind on near operands are in different lists.
fn list_of(operation: Operation) -> usize {
    let of_sum = |Signed { node, minus }: Signed| 2 * node + usize::from(minus);
    let (kind, a, b) = match operation {
        Operation::Other(index) => (1, index, 0),
        Operation::Sum(a, b) => (2, of_sum(a), of_sum(b)),
        Operation::Product(a, b) => (3, a, b),
    };
    (a.wrapping_mul(61) + b.wrapping_mul(1021) + kind) % LISTS
}
