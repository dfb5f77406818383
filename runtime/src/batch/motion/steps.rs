//! Steps of motions in lanes, each of a length of its own: the method of Dormand and Prince of order 5.
//!
//! J. R. Dormand, P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comput. Appl. Math. 6 (1980), with the
//! polynomials of order 4 between steps of E. Hairer, S. P. Nørsett, G. Wanner, "Solving Ordinary Differential Equations I",
//! II.6.

use fearless_simd::Simd;

use super::super::{InLanes, Lanes};
use crate::motion::{Unchecked, Vector};
use crate::number::Number;
use crate::number::real::Real;

/// What each stage adds to the beginning, by the slopes of those before it; the last one is the end of the step.
const STAGES: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0],
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
/// What the end differs by from that of order 4.
const ERROR: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];
/// What the polynomial between both ends has of the highest power.
const BETWEEN: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

/// Positions and speeds, or their derivatives.
#[derive(Clone, Copy)]
pub(super) struct Point<U: Unchecked> {
    pub positions: U::Positions,
    pub speeds: U::Speeds,
}

/// A step of each lane.
pub(super) struct Step<U: Unchecked> {
    pub size: U::Scalar,
    pub begin: Point<U>,
    pub end: Point<U>,
    slopes: [Point<U>; 7],
}

impl<U: Unchecked> Point<U> {
    /// The same number everywhere.
    pub fn splat(number: U::Scalar) -> Self {
        Self { positions: Vector::from_fn(|_| number), speeds: Vector::from_fn(|_| number) }
    }

    #[inline(always)]
    fn parts(&self) -> [&[U::Scalar]; 2] {
        [self.positions.as_ref(), self.speeds.as_ref()]
    }

    #[inline(always)]
    fn parts_mut(&mut self) -> [&mut [U::Scalar]; 2] {
        [self.positions.as_mut(), self.speeds.as_mut()]
    }

    /// All numbers, positions first.
    pub fn numbers(&self) -> impl Iterator<Item = &U::Scalar> {
        self.positions.as_ref().iter().chain(self.speeds.as_ref())
    }
}

impl<S: Simd, T: InLanes, U: Unchecked<Scalar = Lanes<S, T>>> Point<U> {
    /// That of a lane, positions first.
    pub fn lane(&self, lane: usize) -> impl Iterator<Item = T> {
        self.numbers().map(move |number| number.lane(lane))
    }

    /// Replaces that of a lane.
    pub fn set_lane<V: Unchecked<Scalar = T>>(&mut self, lane: usize, point: &Point<V>) {
        for (numbers, point) in self.parts_mut().into_iter().zip(point.parts()) {
            numbers.iter_mut().zip(point).for_each(|(numbers, number)| numbers.set_lane(lane, *number));
        }
    }

    /// This one where a mask is true, the other one elsewhere.
    #[inline(always)]
    pub fn select(mask: <Lanes<S, T> as Real>::Mask, mut yes: Self, no: &Self) -> Self {
        for (yes, no) in yes.parts_mut().into_iter().zip(no.parts()) {
            for (yes, no) in yes.iter_mut().zip(no) {
                *yes = Lanes::select(mask, *yes, *no);
            }
        }
        yes
    }
}

impl<S: Simd, T: InLanes, U: Unchecked<Scalar = Lanes<S, T>>> Step<U> {
    /// From where the slope is known.
    #[inline(always)]
    pub fn new(motion: &U, forces: &U::Forces, begin: Point<U>, slope: Point<U>, size: Lanes<S, T>) -> Self {
        let mut slopes = [slope; 7];
        let mut end = begin;
        for (stage, weights) in STAGES.iter().enumerate() {
            let known = &slopes[..=stage];
            for (place, number) in end.positions.as_mut().iter_mut().enumerate() {
                let slope = |point: &Point<U>| point.positions.as_ref()[place];
                *number = begin.positions.as_ref()[place] + size * weighted(known, weights, slope);
            }
            for (place, number) in end.speeds.as_mut().iter_mut().enumerate() {
                let slope = |point: &Point<U>| point.speeds.as_ref()[place];
                *number = begin.speeds.as_ref()[place] + size * weighted(known, weights, slope);
            }
            let (positions, speeds) = motion.derivatives_unchecked(&end.positions, &end.speeds, forces);
            slopes[stage + 1] = Point { positions, speeds };
        }
        Self { size, begin, end, slopes }
    }

    /// The slope at the end.
    pub fn slope(&self) -> Point<U> {
        self.slopes[6]
    }

    /// The square of the error of the step, in what it may err: in the mean of all numbers, each relative to its size or, where
    /// that is less than 1, absolutely. Where something has no value, it is none either.
    #[inline(always)]
    pub fn error(&self, tolerance: f64) -> Lanes<S, T> {
        let (one, mut sum, mut count) = (Number::like(self.size, 1.0), Number::like(self.size, 0.0), 0.0);
        for (part, (begin, end)) in self.begin.parts().into_iter().zip(self.end.parts()).enumerate() {
            for (place, (begin, end)) in begin.iter().zip(end).enumerate() {
                let error = self.size * weighted(&self.slopes, &ERROR, |point| point.parts()[part][place]);
                let (begin, end) = (begin.abs(), end.abs());
                let size = Lanes::select(begin.less(end), end, begin);
                let error = error / (Number::like(one, tolerance) * Lanes::select(size.less(one), one, size));
                sum = sum + error * error;
                count += 1.0;
            }
        }
        sum / Number::like(one, count)
    }

    /// The polynomial of one of the positions within the step.
    #[inline(always)]
    pub fn path(&self, position: usize) -> Path<Lanes<S, T>> {
        self.path_of(|point| point.positions.as_ref()[position])
    }

    #[inline(always)]
    fn path_of(&self, number: impl Fn(&Point<U>) -> Lanes<S, T>) -> Path<Lanes<S, T>> {
        let (begin, end) = (number(&self.begin), number(&self.end));
        let difference = end - begin;
        let bend = self.size * number(&self.slopes[0]) - difference;
        Path([
            begin,
            difference,
            bend,
            difference - self.size * number(&self.slopes[6]) - bend,
            self.size * weighted(&self.slopes, &BETWEEN, number),
        ])
    }

    /// The positions and speeds of a lane at a part of the step.
    pub fn lane_at(&self, lane: usize, part: f64) -> impl Iterator<Item = f64> {
        let [positions, speeds] = self.begin.parts().map(<[_]>::len);
        let of_positions = (0..positions).map(move |place| self.path(place));
        let of_speeds = (0..speeds).map(move |place| self.path_of(|point| point.speeds.as_ref()[place]));
        of_positions.chain(of_speeds).map(move |path| path.lane(lane).at(part))
    }
}

/// A sum of slopes.
#[inline(always)]
fn weighted<S: Simd, T: InLanes, U: Unchecked<Scalar = Lanes<S, T>>>(
    slopes: &[Point<U>],
    weights: &[f64],
    number: impl Fn(&Point<U>) -> Lanes<S, T>,
) -> Lanes<S, T> {
    let first = number(&slopes[0]);
    let mut sum = first * Number::like(first, weights[0]);
    for (slope, weight) in slopes.iter().zip(weights).skip(1) {
        sum = sum + number(slope) * Number::like(first, *weight);
    }
    sum
}

/// A number within a step: a polynomial of the part of it that has passed.
#[derive(Clone, Copy)]
pub(super) struct Path<R>([R; 5]);

impl<R: Number> Path<R> {
    #[inline(always)]
    pub fn at(&self, part: f64) -> R {
        let Self([begin, difference, bend, third, fourth]) = *self;
        let (part, rest) = (begin.like(part), begin.like(1.0 - part));
        begin + part * (difference + rest * (bend + part * (third + rest * fourth)))
    }
}

impl<S: Simd, T: InLanes> Path<Lanes<S, T>> {
    pub fn lane(&self, lane: usize) -> Path<f64> {
        Path(self.0.map(|number| number.lane(lane).to_f64()))
    }
}
