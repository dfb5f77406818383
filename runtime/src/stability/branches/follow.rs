//! Eigenvalues from speed to speed, in steps as short as it takes.

use nalgebra::Complex;

use super::assign::{cleaned, closest, find_clear, is_clear, keep_pairs, side};
use crate::numeric::sort_by;
use crate::system::SystemError;

/// The eigenvalues at a speed.
pub(super) type Eigenvalues = dyn Fn(f64) -> Result<Vec<Complex<f64>>, SystemError> + Send + Sync;

/// The eigenvalues at one speed, each in the place that it has at all.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    pub(super) speed: f64,
    pub(super) values: Vec<Complex<f64>>,
}

/// A speed at which eigenvalues coincide, as far as steps tell, so that which is which from there on is a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Meeting {
    /// The speed in m/s, to about a millionth of it.
    pub speed: f64,
    /// The places of the branches that meet there, ascending. Two real ones and the pair that they become are the same two
    /// branches.
    pub branches: Vec<usize>,
}

/// No step is shorter, relative to the speed: eigenvalues that coincide come out with half of their digits. At low speeds it
/// is relative to a part of all that is followed.
const LOW: f64 = 1.0 / 64.0;
const SHORTEST: f64 = 1.0 / (1u64 << 20) as f64;

/// Meetings that are no more of the shortest steps apart are one, which took several of them.
const NEAR: f64 = 64.0;

/// The bound on the speeds at which eigenvalues are computed; when it is reached, no step is divided any more.
const MOST: usize = 20_000;

/// The eigenvalues from the first to the last of ascending speeds, and where they meet.
pub(super) fn follow(eigenvalues: &Eigenvalues, speeds: &[f64]) -> Result<(Vec<Node>, Vec<Meeting>), SystemError> {
    let (mut nodes, mut meetings): (Vec<Node>, Vec<Meeting>) = (Vec::new(), Vec::new());
    let [first, rest @ ..] = speeds else { return Ok((nodes, meetings)) };
    nodes.push(Node { speed: *first, values: eigenvalues(*first)? });
    let low = LOW * speeds[speeds.len() - 1];
    let shortest = |speed: f64| SHORTEST * speed.max(low);
    // How many were computed, and up to where no node is in doubt since the last meeting.
    let (mut computed, mut beyond_doubt) = (1, 1);
    for &speed in rest {
        // Speeds that are still to be reached, the next one last.
        let mut ahead = vec![(speed, eigenvalues(speed)?)];
        computed += 1;
        while let Some((next, values)) = ahead.pop() {
            let last = &nodes[nodes.len() - 1];
            let (from, to) = (cleaned(&last.values), cleaned(&values));
            let places = find_clear(&from, &to);
            if places.is_none() && next - last.speed > shortest(next) && computed < MOST {
                let middle = 0.5 * (last.speed + next);
                ahead.push((next, values));
                ahead.push((middle, eigenvalues(middle)?));
                computed += 1;
                continue;
            }
            let is_clear_step = places.is_some();
            let places = places.unwrap_or_else(|| {
                let mut places = go_on(&nodes[..beyond_doubt], last, next, &to);
                keep_pairs(&from, &to, &mut places);
                let unclear = (0..from.len()).filter(|&i| !is_clear(i, &from, &to, &places));
                let branches = unclear.flat_map(|i| [Some(i), nearest(i, &from)]).flatten().collect();
                meetings.push(Meeting { speed: 0.5 * (last.speed + next), branches });
                places
            });
            let values = places.iter().map(|&place| values[place]).collect();
            nodes.push(Node { speed: next, values });
            if is_clear_step {
                beyond_doubt = nodes.len();
            }
        }
    }
    Ok((nodes, joined(meetings, &|speed| NEAR * shortest(speed))))
}

/// Where it cannot be told which goes on as which: as straight on as they came, by the last two nodes that are beyond doubt,
/// unless they leave or reach the real axis.
fn go_on(beyond_doubt: &[Node], last: &Node, next: f64, to: &[Complex<f64>]) -> Vec<usize> {
    let real = |values: &[Complex<f64>]| values.iter().filter(|value| side(**value) == 0).count();
    if let [.., before, base] = beyond_doubt {
        let [from, straight] = [before, base].map(|node| cleaned(&node.values));
        if real(&from) == real(to) && real(&straight) == real(to) {
            let share = (next - base.speed) / (base.speed - before.speed);
            let ahead: Vec<_> = straight.iter().zip(from).map(|(value, from)| value + (value - from) * share).collect();
            return closest(&ahead, to);
        }
    }
    closest(&cleaned(&last.values), to)
}

/// The nearest of the others on the same side of the real axis: one that is beyond doubt itself may be met by another.
fn nearest(i: usize, values: &[Complex<f64>]) -> Option<usize> {
    let others = (0..values.len()).filter(|&k| k != i && side(values[k]) == side(values[i]));
    others.min_by(|&j, &k| (values[i] - values[j]).norm().total_cmp(&(values[i] - values[k]).norm()))
}

/// Meetings at neighbouring steps are one, in their middle.
fn joined(meetings: Vec<Meeting>, near: &dyn Fn(f64) -> f64) -> Vec<Meeting> {
    let is_near = |before: &Meeting, next: &Meeting| next.speed - before.speed <= near(next.speed);
    let one = |meetings: &[Meeting]| {
        let mut branches: Vec<usize> = meetings.iter().flat_map(|meeting| meeting.branches.iter().copied()).collect();
        sort_by(&mut branches, usize::cmp);
        branches.dedup();
        Meeting { speed: 0.5 * (meetings[0].speed + meetings[meetings.len() - 1].speed), branches }
    };
    meetings.chunk_by(is_near).map(one).collect()
}
