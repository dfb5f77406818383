//! Derivatives of the matrices of many designs, at every level of instructions that the processor has: each must be what it is
//! alone, to the last bit. What they are alone is the matter of `derivatives`.

use carvallo::batch::{Batch, BatchError, Blocks, InLanes};
use carvallo::{Differentiable, MatrixName, Model, Partial, Scalar};
use carvallo_models::{CarTrailer, Motorcycle, Pendulum, Skateboard, ThreePipes, Whipple, WhippleMechanism};
use carvallo_tests::designs;

/// More designs than two blocks of `f32`, and lanes to spare.
const DESIGNS: usize = 37;

/// Designs about the first parameter set of a model.
fn some<const N: usize, M: Model<N>>() -> Vec<M> {
    let set = M::INFO.sets.first().expect("a parameter set").values;
    let design = |number: usize| {
        let value = |(i, x): (usize, &f64)| M::Scalar::from_f64(x * (1.0 + 0.01 * ((number * (i + 1)) % 17) as f64));
        let values: Vec<M::Scalar> = set.iter().enumerate().map(value).collect();
        M::from_slice(&values).expect("as many values as parameters")
    };
    (0..DESIGNS).map(design).collect()
}

/// The bits of a number; those of `f32` are its own as `f64`, too.
fn bits(number: impl Scalar) -> u64 {
    number.to_f64().to_bits()
}

/// Entries and derivatives of designs of any number, in blocks and block after block, at every level.
fn check<const N: usize, M: Differentiable<N, Scalar: InLanes>>(designs: &[M]) {
    let name = M::INFO.name;
    let alone: Vec<_> = designs.iter().map(Differentiable::coefficients_and_derivatives).collect();
    let places: Vec<(MatrixName, usize, usize)> = M::INFO.entries.iter().map(|entry| entry.places[0]).collect();
    let entry = |design: usize, position: usize| {
        let (matrix, row, column) = places[position];
        bits(alone[design].0.matrix(matrix)[(row, column)])
    };
    let derivative = |design: usize, of: &Partial| {
        bits(alone[design].1.as_ref()[of.parameter].matrix(of.matrix)[(of.row, of.column)])
    };
    for batch in Batch::levels() {
        for count in [0, 1, 8, 16, designs.len()] {
            let parameters = Blocks::of_designs(&designs[..count]);
            let mut entries = Blocks::for_entries::<N, M>(count);
            let mut derivatives = Blocks::for_derivatives::<N, M>(count);
            batch.jacobians::<N, M>(&parameters, &mut entries, &mut derivatives).unwrap();
            for design in 0..count {
                for position in 0..places.len() {
                    assert_eq!(bits(entries.get(design, position)), entry(design, position), "{name}, {batch}");
                }
                for partial in M::PARTIALS {
                    let found = bits(derivatives.derivative(design, partial));
                    assert_eq!(found, derivative(design, partial), "{name}, {batch}, {design}: {partial:?}");
                }
            }
            let mut seen = 0;
            let each = batch.each_jacobian::<N, M>(&parameters, |portion| {
                assert_eq!(portion.first(), seen);
                for position in 0..places.len() {
                    let expected: Vec<u64> = (seen..seen + portion.len()).map(|d| entry(d, position)).collect();
                    assert_eq!(portion.entry(position).iter().copied().map(bits).collect::<Vec<_>>(), expected);
                }
                for partial in M::PARTIALS {
                    let expected: Vec<u64> = (seen..seen + portion.len()).map(|d| derivative(d, partial)).collect();
                    assert_eq!(portion.derivative(partial).map(bits).collect::<Vec<_>>(), expected, "{partial:?}");
                }
                seen += portion.len();
            });
            assert_eq!(each, Ok(()));
            assert_eq!(seen, count);
        }
    }
}

/// In `f64`, and in `f32`.
fn check_some<const N: usize, M>()
where
    M: Differentiable<N, Scalar = f64, Over<f32>: Differentiable<N, Scalar = f32>>,
{
    check(&some::<N, M>());
    check(&some::<N, M::Over<f32>>());
}

#[test]
fn derivatives_are_computed_in_lanes_as_alone() {
    check_some::<_, Pendulum>();
    check_some::<2, WhippleMechanism>();
    check_some::<_, Skateboard>();
    check_some::<3, ThreePipes>();
    check_some::<_, CarTrailer>();
    check_some::<_, Motorcycle>();
}

#[test]
fn derivatives_of_random_bicycles_are_computed_in_lanes_as_alone() {
    check(&(0..DESIGNS as u64).map(designs::numbered).collect::<Vec<Whipple>>());
}

#[test]
fn what_does_not_fit_is_an_error_that_says_so() {
    let batch = Batch::new();
    let parameters = Blocks::of_designs(&some::<1, Pendulum>());
    let mut entries = Blocks::for_entries::<1, Pendulum>(DESIGNS);
    let wrong = batch.jacobians::<1, Pendulum>(&parameters, &mut entries, &mut Blocks::zeros(3, DESIGNS));
    let expected = BatchError::Columns { model: "Pendulum", what: "derivatives", expected: 5, found: 3 };
    assert_eq!(wrong, Err(expected));
    assert_eq!(expected.to_string(), "Pendulum: 3 columns of derivatives given; it has 5 derivatives");
    let short = batch.jacobians::<1, Pendulum>(&parameters, &mut entries, &mut Blocks::zeros(5, 2));
    assert_eq!(short, Err(BatchError::Length { what: "derivative", position: 0, expected: DESIGNS, found: 2 }));
    let few =
        batch.each_jacobian::<1, Pendulum>(&Blocks::zeros(2, 5), |_| unreachable!("there are too few parameters"));
    assert_eq!(few, Err(BatchError::Columns { model: "Pendulum", what: "parameters", expected: 4, found: 2 }));
}
