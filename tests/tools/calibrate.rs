//! Prints what each kind of operation costs in straight-line code, in additions: the weights of the compiler's cost model.
//!
//! `cargo run --profile bench -p carvallo-tools --no-default-features --bin calibrate`
//!
//! A kernel of sixteen chains of multiplications and additions, much like the matrices of a model, is timed as it is and
//! with more operations of one kind in it. What they add to the time is their cost: it is that of throughput, among other
//! work that can go on meanwhile. Of many rounds in turn the shortest counts, which other work on the machine disturbs
//! least. The kernels return one ordered sum, so that nothing is turned into vectors.

use std::hint::black_box;
use std::time::Instant;

use carvallo::Scalar;

/// Numbers that a kernel reads, and the number of its chains.
const INPUTS: usize = 16;
/// Sets of numbers, few enough to stay in the cache.
const SETS: usize = 256;
const ROUNDS: usize = 400;
/// Operations that are added to each chain, and to how many chains.
const MORE: [usize; 7] = [4 * INPUTS, 4 * INPUTS, 4 * INPUTS, INPUTS, INPUTS, 2, 2];

type Kernel<T> = fn(&[T; INPUTS]) -> T;

fn main() {
    println!("{:<28} {:>10} {:>14}", "", "ns", "in additions");
    measure::<f64>("f64");
    measure::<f32>("f32");
}

fn measure<T: Scalar>(scalar: &str) {
    let kernels: [Kernel<T>; 8] = [
        |inputs| chains(inputs, INPUTS, |x, _| x),
        |inputs| chains(inputs, INPUTS, |x, a| x + a[0] + a[1] + a[2] + a[3]),
        |inputs| chains(inputs, INPUTS, |x, a| x * a[0] * a[1] * a[2] * a[3]),
        // Of one value and then of what it is added to, since two changes of sign are none.
        |inputs| chains(inputs, INPUTS, |x, a| -(-(-(-x - a[0]) - a[1]) - a[2]) - a[3]),
        |inputs| chains(inputs, INPUTS, |x, a| x / a[0]),
        |inputs| chains(inputs, INPUTS, |x, _| x.sqrt()),
        |inputs| chains(inputs, 2, |x, _| x.sin()),
        |inputs| {
            chains(inputs, 2, |x, _| {
                let (sine, cosine) = x.sin_cos();
                sine + cosine
            })
        },
    ];
    let sets: Vec<[T; INPUTS]> = (0..SETS)
        .map(|set| {
            std::array::from_fn(|input| T::from_f64(1.0 + ((set * INPUTS + input) as f64 * 0.618).fract() / 8.0))
        })
        .collect();
    let mut shortest = [f64::INFINITY; 8];
    for _ in 0..ROUNDS {
        for (shortest, kernel) in shortest.iter_mut().zip(kernels) {
            let start = Instant::now();
            for set in &sets {
                black_box(kernel(black_box(set)));
            }
            *shortest = shortest.min(start.elapsed().as_secs_f64() * 1e9 / SETS as f64);
        }
    }
    let each = |kernel: usize| (shortest[kernel] - shortest[0]) / MORE[kernel - 1] as f64;
    let addition = each(1);
    let kinds =
        ["addition", "multiplication", "difference with a sign", "division", "square root", "sine", "sine and cosine"];
    for (kind, kernel) in kinds.iter().zip(1..) {
        println!("{:<28} {:>10.3} {:>14.1}", format!("{kind}, {scalar}"), each(kernel), each(kernel) / addition);
    }
}

/// Chains of multiplications and additions, of which the first have more in them.
#[inline(always)]
fn chains<T: Scalar>(inputs: &[T; INPUTS], longer: usize, more: impl Fn(T, [T; 4]) -> T) -> T {
    let at = |index: usize| inputs[index % INPUTS];
    let mut sum = T::from_f64(0.0);
    for chain in 0..INPUTS {
        let mut x = at(chain);
        for link in 0..3 {
            x = x * at(7 * chain + 3 * link + 1) + at(5 * chain + link + 2);
        }
        if chain < longer {
            x = more(x, std::array::from_fn(|index| at(3 * chain + 5 * index + 4)));
        }
        for link in 3..6 {
            x = x * at(7 * chain + 3 * link + 1) + at(5 * chain + link + 2);
        }
        sum += x;
    }
    sum
}
