//! Which name each eigenvalue bears in each stretch of speeds.

use super::mode::Mode;
use crate::Complex;

/// What the names in a stretch of speeds follow from. Eigenvalues have places: real ones first, then pairs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    pub(super) pairs: usize,
    /// By place the mode whose critical speed the eigenvalue passes, if it passes one.
    pub(super) crosses: [Option<Mode>; 4],
    /// By place the eigenvalue near the upper end.
    pub(super) at_end: [Complex<f64>; 4],
    /// By place the place in the next stretch of the eigenvalue that continues this one.
    pub(super) onward: [usize; 4],
}

/// Names by place.
pub(super) type Names = [Mode; 4];

impl Course {
    fn is_pair(&self, place: usize) -> bool {
        place >= 4 - 2 * self.pairs
    }

    /// Whether every eigenvalue that passes a critical speed bears the name of its kind.
    fn agrees(&self, names: &Names) -> bool {
        names.iter().zip(self.crosses).all(|(name, crosses)| crosses.is_none_or(|crosses| crosses == *name))
    }

    /// The names in a stretch with one pair, from nothing but this stretch.
    fn alone(&self) -> Names {
        let slower = usize::from(self.at_end[1].norm() < self.at_end[0].norm());
        let passes = [0, 1].map(|place| self.crosses[place] == Some(Mode::Capsize));
        let is_capsize = if passes == [false; 2] { [slower == 0, slower == 1] } else { passes };
        let [first, second] = is_capsize.map(|is| if is { Mode::Capsize } else { Mode::Castering });
        [first, second, Mode::Weave, Mode::Weave]
    }

    /// The name that says no more than what is to be seen.
    fn plain(&self, place: usize) -> Mode {
        if self.is_pair(place) { Mode::Oscillatory } else { Mode::Real }
    }

    /// The names that critical speeds give, and others as far as these leave room for them: both halves of a pair keep
    /// theirs, or neither.
    fn corrected(&self, names: &Names) -> Names {
        let given: Names = core::array::from_fn(|place| self.crosses[place].unwrap_or(names[place]));
        let has_room = |place: usize| {
            let bearers = given.iter().filter(|&&name| name == given[place]).count();
            self.crosses[place].is_some() || bearers <= room(given[place])
        };
        core::array::from_fn(|place| {
            let keeps = has_room(place) && has_room(self.other_half(place));
            if keeps { given[place] } else { self.plain(place) }
        })
    }

    /// The place of the other half of a pair, next to it; of a real eigenvalue its own.
    fn other_half(&self, place: usize) -> usize {
        if self.is_pair(place) { place ^ 1 } else { place }
    }
}

/// How many eigenvalues a mode has.
fn room(mode: Mode) -> usize {
    match mode {
        Mode::Castering | Mode::Capsize => 1,
        Mode::Weave => 2,
        Mode::Wobble | Mode::Divergence | Mode::Flutter => 0,
        Mode::Real | Mode::Oscillatory => 4,
    }
}

/// The names in every stretch, ascending, as [`Modes`](super::Modes) documents them.
pub(super) fn names(courses: &[Course]) -> Vec<Names> {
    let nothing = |course: &Course| course.corrected(&core::array::from_fn(|place| course.plain(place)));
    let mut names: Vec<Names> = courses.iter().map(nothing).collect();
    let Some(highest) = courses.iter().rposition(|course| course.pairs == 1) else { return names };
    names[highest] = courses[highest].alone();
    for above in highest + 1..courses.len() {
        let continued = upward(courses, above - 1, &names[above - 1]);
        names[above] = first_that_agrees(&courses[above], &continued);
    }
    let mut upper = highest;
    while let Some(lower) = courses[..upper].iter().rposition(|course| course.pairs == 1) {
        match passed(courses, lower..upper, &names[upper]) {
            Some(continued) => names[lower..upper].copy_from_slice(&continued),
            None => {
                names[lower] = courses[lower].alone();
                between(courses, lower, upper, &mut names);
            }
        }
        upper = lower;
    }
    match passed(courses, 0..upper, &names[upper]) {
        Some(continued) => names[..upper].copy_from_slice(&continued),
        None => {
            for below in (0..upper).rev() {
                names[below] = first_that_agrees(&courses[below], &downward(courses, below, &names[below + 1]));
            }
        }
    }
    names
}

/// The names in a range of stretches from those above it, if a continuation agrees with every critical speed.
fn passed(courses: &[Course], range: core::ops::Range<usize>, above: &Names) -> Option<Vec<Names>> {
    let Some(last) = range.end.checked_sub(1).filter(|_| !range.is_empty()) else { return Some(Vec::new()) };
    let continued = downward(courses, last, above);
    continued.into_iter().filter(|names| courses[last].agrees(names)).find_map(|names| {
        let mut all = passed(courses, range.start..last, &names)?;
        all.push(names);
        Some(all)
    })
}

/// Names between two stretches that are named each by itself: those that continue both.
fn between(courses: &[Course], lower: usize, upper: usize, names: &mut [Names]) {
    let mut from_above = names[upper];
    for k in (lower + 1..upper).rev() {
        from_above = downward(courses, k, &from_above)[0];
        names[k] = from_above;
    }
    let mut from_below = names[lower];
    for k in lower + 1..upper {
        from_below = upward(courses, k - 1, &from_below)[0];
        let (course, above) = (&courses[k], names[k]);
        let is_same = |place: usize| {
            // The halves of a pair bear its names in either order.
            let other = course.other_half(place);
            let below = [from_below[place], from_below[other]];
            below == [above[place], above[other]] || below == [above[other], above[place]]
        };
        let both = core::array::from_fn(|place| if is_same(place) { above[place] } else { course.plain(place) });
        names[k] = course.corrected(&both);
    }
}

fn first_that_agrees(course: &Course, continued: &[Names]) -> Names {
    let agreeing = continued.iter().find(|names| course.agrees(names));
    agreeing.copied().unwrap_or_else(|| course.corrected(&continued[0]))
}

/// The names in a stretch that continue those in the next one: two ways where a pair becomes two real eigenvalues.
fn downward(courses: &[Course], below: usize, above: &Names) -> Vec<Names> {
    let (course, next) = (&courses[below], &courses[below + 1]);
    let names: Names = core::array::from_fn(|place| above[course.onward[place]]);
    let meets = |&place: &usize| !course.is_pair(place) && next.is_pair(course.onward[place]);
    either_way(names, (0..4).filter(meets).collect())
}

/// The names in the next stretch that continue those in this one.
fn upward(courses: &[Course], below: usize, names: &Names) -> Vec<Names> {
    let (course, next) = (&courses[below], &courses[below + 1]);
    let mut above = *names;
    for place in 0..4 {
        above[course.onward[place]] = names[place];
    }
    let meets = |&place: &usize| course.is_pair(place) && !next.is_pair(course.onward[place]);
    either_way(above, (0..4).filter(meets).map(|place| course.onward[place]).collect())
}

/// Two that meet are equal there, so that either order of their names is continuous.
fn either_way(names: Names, meeting: Vec<usize>) -> Vec<Names> {
    let mut ways = vec![names];
    if let [first, second] = meeting[..]
        && names[first] != names[second]
    {
        let mut exchanged = names;
        exchanged.swap(first, second);
        ways.push(exchanged);
    }
    ways
}
