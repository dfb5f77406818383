//! What the branches are called, and from which speed to which.

use nalgebra::Complex;

use super::follow::{Meeting, Node};
use crate::stability::critical::{CriticalKind, CriticalSpeed};
use crate::stability::mode::Mode;

/// A name, and the speed from which on a branch has it.
pub(super) type Named = (f64, Option<Mode>);

/// The names of each branch, ascending by speed; the first from the lowest speed on.
///
/// A name holds between meetings. From critical speeds it goes on to stretches that have none, the next one first; of two as
/// near, that from below.
pub(super) fn find_names(
    nodes: &[Node],
    meetings: &[Meeting],
    critical_speeds: &[CriticalSpeed],
    is_bicycle: bool,
) -> Vec<Vec<Named>> {
    let (Some(first), Some(last)) = (nodes.first(), nodes.last()) else { return Vec::new() };
    let mut names: Vec<Vec<Named>> = (0..first.values.len())
        .map(|branch| {
            let met = meetings.iter().filter(|meeting| meeting.branches.contains(&branch));
            [first.speed].into_iter().chain(met.map(|meeting| meeting.speed)).map(|speed| (speed, None)).collect()
        })
        .collect();
    let followed = critical_speeds.iter().filter(|critical| (first.speed..=last.speed).contains(&critical.speed));
    for critical in followed {
        let Some(mode) = critical.mode(is_bicycle) else { continue };
        for branch in find_branches(nodes, critical) {
            let stretch = names[branch].partition_point(|(from, _)| *from <= critical.speed).max(1) - 1;
            // The name of a stretch is that of its first critical speed.
            names[branch][stretch].1.get_or_insert(mode);
        }
    }
    for stretches in &mut names {
        let known: Vec<Option<Mode>> = stretches.iter().map(|(_, name)| *name).collect();
        for (place, (_, name)) in stretches.iter_mut().enumerate() {
            let named = (0..known.len()).filter(|&other| known[other].is_some());
            *name = named.min_by_key(|&other| other.abs_diff(place)).and_then(|other| known[other]);
        }
    }
    names
}

/// The branches that are on the imaginary axis at a critical speed: two of a pair, or one.
pub(super) fn find_branches(nodes: &[Node], critical: &CriticalSpeed) -> Vec<usize> {
    let above = nodes.partition_point(|node| node.speed < critical.speed);
    let near = |place: usize| nodes.get(place).map(|node| (node.speed - critical.speed).abs());
    let node = match (above.checked_sub(1).and_then(near), near(above)) {
        (Some(below), Some(distance)) if below < distance => &nodes[above - 1],
        (_, Some(_)) => &nodes[above],
        _ => &nodes[nodes.len() - 1],
    };
    let nearest = |target: Complex<f64>, is_wanted: &dyn Fn(Complex<f64>) -> bool| {
        let wanted = (0..node.values.len()).filter(|&branch| is_wanted(node.values[branch]));
        wanted.min_by(|&i, &j| (node.values[i] - target).norm().total_cmp(&(node.values[j] - target).norm()))
    };
    let target = Complex::new(0.0, critical.eigenvalue.im);
    match critical.kind {
        CriticalKind::Capsize => nearest(target, &|value| value.im == 0.0).into_iter().collect(),
        _ => {
            let halves = [nearest(target, &|value| value.im > 0.0), nearest(target.conj(), &|value| value.im < 0.0)];
            halves.into_iter().flatten().collect()
        }
    }
}
