//! Critical speeds that are followed along a path, from where they appear to where they vanish.

use std::fmt;

use carvallo::CriticalKind;

use super::path::{Critical, Path, Point, Slopes};

/// So many intervals the path has at least, so that nothing that vanishes and comes back is taken for one.
const INTERVALS: u32 = 8;
/// A critical speed goes on as another one if they and their derivatives agree to this, relative, ...
const AGREEMENT: f64 = 0.02;
/// ... and that many times better than with any other one.
const CLEARLY: f64 = 5.0;
/// Where critical speeds appear or vanish is found to this part of the path.
const NARROW: f64 = 1e-9;
/// What has become so many times as large, or as small, goes out of all bounds, or to zero.
const BEYOND: f64 = 100.0;
/// Critical speeds that vanish where they are as close as this, relative, meet.
const CLOSE: f64 = 0.01;

/// A critical speed along the path.
pub struct Track {
    /// The places where it was computed, ascending.
    pub points: Vec<(f64, Critical)>,
    /// How it begins, unless it is there from the beginning of the path.
    pub begin: Option<Event>,
    /// How it ends, unless it is there until the end of the path.
    pub end: Option<Event>,
}

/// Where a critical speed appears or vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Which part of the way, from 0 to 1.
    pub place: f64,
    /// The speed there in m/s, as near as it was followed.
    pub speed: f64,
    /// What happens.
    pub end: End,
}

/// Why a critical speed is not there beyond a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Two of a kind meet.
    Meets,
    /// It grows beyond all bounds.
    Endless,
    /// It is at zero speed.
    AtRest,
    /// Its oscillation becomes infinitely slow, at a capsize or divergence speed.
    StopsOscillating,
    /// None of these.
    Unclear,
}

/// Reads as a sentence about the critical speed, at the place where it appears or vanishes.
impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Meets => "it meets another of its kind",
            Self::Endless => "it is beyond all bounds",
            Self::AtRest => "it is at rest",
            Self::StopsOscillating => "its frequency is zero",
            Self::Unclear => "it is followed no further",
        })
    }
}

impl Track {
    /// Where it begins.
    pub fn first(&self) -> &Critical {
        &self.points[0].1
    }

    /// Where it ends.
    pub fn last(&self) -> &Critical {
        &self.points[self.points.len() - 1].1
    }

    /// About the speed at a place, from those on both sides and their derivatives.
    pub fn speed_near(&self, place: f64) -> f64 {
        let above = self.points.partition_point(|(known, _)| *known < place).clamp(1, self.points.len() - 1);
        let [(low, a), (high, b)] = [&self.points[above - 1], &self.points[above]];
        let (width, share) = (high - low, (place - low) / (high - low));
        let slope = |critical: &Critical| critical.slopes.as_ref().map(|slopes| slopes.speed * width);
        let (v0, v1) = (a.critical.speed, b.critical.speed);
        let (Some(s0), Some(s1)) = (slope(a), slope(b)) else { return v0 + share * (v1 - v0) };
        // The cubic of Hermite.
        let rest = 1.0 - share;
        rest * rest * ((1.0 + 2.0 * share) * v0 + share * s0) + share * share * ((1.0 + 2.0 * rest) * v1 - rest * s1)
    }
}

/// All critical speeds along a path.
///
/// # Errors
/// If there is no answer somewhere on it.
pub fn follow(path: &Path) -> Result<Vec<Track>, String> {
    let mut before = path.at(0.0)?;
    let mut tracks = Tracks::new(&before);
    for index in 1..=INTERVALS {
        let next = path.at(f64::from(index) / f64::from(INTERVALS))?;
        tracks.advance(path, &before, &next)?;
        before = next;
    }
    Ok(tracks.finished())
}

struct Tracks {
    all: Vec<Track>,
    /// The tracks of the critical speeds of the last point, in their order.
    open: Vec<usize>,
}

impl Tracks {
    fn new(first: &Point) -> Self {
        let track =
            |critical: &Critical| Track { points: vec![(first.place, critical.clone())], begin: None, end: None };
        Self { all: first.critical.iter().map(track).collect(), open: (0..first.critical.len()).collect() }
    }

    /// From one point to the next, in smaller intervals where it is not clear which one goes on as which.
    fn advance(&mut self, path: &Path, before: &Point, next: &Point) -> Result<(), String> {
        let successors = successors(before, next);
        let goes_on = successors.iter().flatten().count();
        let all_go_on = goes_on == before.critical.len() && goes_on == next.critical.len();
        if all_go_on || next.place - before.place < NARROW {
            self.connect(before, next, &successors);
            return Ok(());
        }
        let middle = path.at(0.5 * (before.place + next.place))?;
        self.advance(path, before, &middle)?;
        self.advance(path, &middle, next)
    }

    fn connect(&mut self, before: &Point, next: &Point, successors: &[Option<usize>]) {
        let place = 0.5 * (before.place + next.place);
        let mut open = vec![None; next.critical.len()];
        let lost: Vec<usize> = (0..before.critical.len()).filter(|&index| successors[index].is_none()).collect();
        for (index, successor) in successors.iter().enumerate() {
            let track = self.open[index];
            match successor {
                Some(successor) => {
                    self.all[track].points.push((next.place, next.critical[*successor].clone()));
                    open[*successor] = Some(track);
                }
                None => {
                    let others: Vec<&Critical> = lost.iter().map(|&index| &before.critical[index]).collect();
                    let known = &self.all[track].points[0].1;
                    let event = event(place, &before.critical[index], known, &others);
                    self.all[track].end = Some(event);
                }
            }
        }
        let found: Vec<usize> = (0..open.len()).filter(|&index| open[index].is_none()).collect();
        for &index in &found {
            let others: Vec<&Critical> = found.iter().map(|&index| &next.critical[index]).collect();
            let critical = &next.critical[index];
            // Told anew at the end, when it is known what becomes of it.
            let begin = Some(event(place, critical, critical, &others));
            open[index] = Some(self.all.len());
            self.all.push(Track { points: vec![(next.place, critical.clone())], begin, end: None });
        }
        self.open = open.into_iter().flatten().collect();
    }

    fn finished(mut self) -> Vec<Track> {
        for track in &mut self.all {
            let last = track.last().clone();
            if let Some(begin) = &mut track.begin
                && begin.end == End::Unclear
            {
                begin.end = outgrown(&track.points[0].1, &last);
            }
        }
        self.all
    }
}

/// How a critical speed vanishes, or appears, at a place: with another one there, or out of all bounds of what it was
/// elsewhere.
fn event(place: f64, critical: &Critical, known: &Critical, others: &[&Critical]) -> Event {
    let (kind, speed) = (critical.critical.kind, critical.critical.speed);
    let is_close = |other: &&&Critical| {
        let other = &other.critical;
        other.kind == kind && (other.speed - speed).abs() <= CLOSE * speed
    };
    // It is one of them itself.
    let meets = others.iter().filter(is_close).count() > 1;
    Event { place, speed, end: if meets { End::Meets } else { outgrown(critical, known) } }
}

/// Whether a critical speed is beyond all bounds of what it was elsewhere.
fn outgrown(critical: &Critical, known: &Critical) -> End {
    let (here, there) = (&critical.critical, &known.critical);
    if here.speed > BEYOND * there.speed {
        End::Endless
    } else if BEYOND * here.speed < there.speed {
        End::AtRest
    } else if here.kind == CriticalKind::Weave && BEYOND * here.eigenvalue.im.abs() < there.eigenvalue.im.abs() {
        End::StopsOscillating
    } else {
        End::Unclear
    }
}

/// As which critical speed of the next point each goes on; `None` where that is not clear.
fn successors(before: &Point, next: &Point) -> Vec<Option<usize>> {
    let width = next.place - before.place;
    let distances: Vec<Vec<f64>> =
        before.critical.iter().map(|from| next.critical.iter().map(|to| distance(from, to, width)).collect()).collect();
    let successor = |row: usize| {
        let (column, least) = distances[row].iter().copied().enumerate().min_by(|a, b| a.1.total_cmp(&b.1))?;
        let in_row = distances[row].iter().enumerate().filter(|(other, _)| *other != column).map(|(_, found)| *found);
        let in_column = distances.iter().enumerate().filter(|(other, _)| *other != row).map(|(_, found)| found[column]);
        let next_best = in_row.chain(in_column).fold(f64::INFINITY, f64::min);
        (least <= AGREEMENT && CLEARLY * least <= next_best).then_some(column)
    };
    (0..before.critical.len()).map(successor).collect()
}

/// How far one critical speed is from going on as another one, relative to their sizes: by how much the mean of their
/// derivatives misses the difference between them.
fn distance(from: &Critical, to: &Critical, width: f64) -> f64 {
    let (a, b) = (&from.critical, &to.critical);
    let (Some(s), Some(t)) = (&from.slopes, &to.slopes) else { return f64::INFINITY };
    // What changes there may be another thing: where oscillations end, capsize turns from one direction to the other.
    if a.kind != b.kind {
        return f64::INFINITY;
    }
    let missed = |from: f64, to: f64, slopes: f64| {
        let missed = (to - from - 0.5 * width * slopes).abs();
        if missed == 0.0 { 0.0 } else { missed / from.abs().max(to.abs()) }
    };
    let Slopes { speed, frequency, .. } = s;
    missed(a.speed, b.speed, speed + t.speed)
        + missed(a.eigenvalue.im.abs(), b.eigenvalue.im.abs(), frequency + t.frequency)
}
