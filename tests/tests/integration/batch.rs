//! Many designs at once, at every level of instructions that the processor has: each must be what it is alone, to the last
//! bit.

use carvallo::batch::{Batch, BatchError, Blocks, InLanes};
use carvallo::{Coefficients, MatrixName, Model, Scalar, States};
use carvallo_models::{Pendulum, Whipple, each_model};
use carvallo_tests::designs;

/// More designs than two stretches of columns, and lanes to spare.
const DESIGNS: usize = 150;

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

/// The entries of a design's matrices, one by one, in the order of the model's description.
fn entries<const N: usize, M: Model<N>>(design: &M) -> Vec<M::Scalar> {
    let coefficients = design.coefficients();
    let value = |&(matrix, row, column): &(MatrixName, usize, usize)| coefficients.matrix(matrix)[(row, column)];
    let entry = |entry: &carvallo::EntryInfo| {
        let values: Vec<M::Scalar> = entry.places.iter().map(value).collect();
        assert!(values.iter().all(|x| same(&[*x], &values[..1])), "{entry}: {values:?}");
        values[0]
    };
    M::INFO.entries.iter().map(entry).collect()
}

/// To the last bit. A number of `f32` has its own bits as `f64`, too.
fn same<T: Scalar>(x: &[T], y: &[T]) -> bool {
    let bits = |x: &T| x.to_f64().to_bits();
    let is_nan = |x: &T| x.to_f64().is_nan();
    x.len() == y.len() && x.iter().zip(y).all(|(x, y)| bits(x) == bits(y) || is_nan(x) && is_nan(y))
}

/// Blocks, columns and structs of designs of any number, at every level.
fn check<const N: usize, M: Model<N, Scalar: InLanes>>(designs: &[M]) {
    let name = M::INFO.name;
    let alone: Vec<Vec<M::Scalar>> = designs.iter().map(entries).collect();
    let columns: Vec<Vec<M::Scalar>> = (0..M::INFO.parameters.len())
        .map(|position| designs.iter().map(|design| design.parameters().as_ref()[position]).collect())
        .collect();
    let none = M::Scalar::from_f64(f64::NAN);
    for batch in Batch::levels() {
        for count in [0, 1, 7, 8, 63, 64, 65, designs.len()] {
            let parameters = Blocks::of_designs(&designs[..count]);
            let mut results = Blocks::for_entries::<N, M>(count);
            batch.matrices::<N, M>(&parameters, &mut results).unwrap();
            let inputs: Vec<&[M::Scalar]> = columns.iter().map(|column| &column[..count]).collect();
            assert_eq!(Blocks::from_columns(&inputs).unwrap().len(), count);
            let mut outputs = vec![vec![none; count]; M::INFO.entries.len()];
            let mut borrowed: Vec<&mut [M::Scalar]> = outputs.iter_mut().map(|column| &mut column[..]).collect();
            batch.matrices_of_columns::<N, M>(&inputs, &mut borrowed).unwrap();
            // Nothing of what was there before is left.
            let unset = Coefficients { states: [States::Rate; N], ..Coefficients::from_rows([[[none; N]; N]; 8]) };
            let mut coefficients = vec![unset; count];
            batch.coefficients(&designs[..count], &mut coefficients).unwrap();
            for (i, expected) in alone[..count].iter().enumerate() {
                let from_blocks: Vec<M::Scalar> = (0..expected.len()).map(|entry| results.get(i, entry)).collect();
                assert!(same(&from_blocks, expected), "{name}, {batch}, {i} of {count}: {from_blocks:?} {expected:?}");
                let from_columns: Vec<M::Scalar> = outputs.iter().map(|column| column[i]).collect();
                assert!(
                    same(&from_columns, expected),
                    "{name}, {batch}, {i} of {count}: {from_columns:?} {expected:?}"
                );
                let alone = designs[i].coefficients();
                assert_eq!(coefficients[i].states, alone.states);
                for matrix in MatrixName::ALL {
                    let [x, y] = [&coefficients[i], &alone].map(|all| all.matrix(matrix).as_slice());
                    assert!(same(x, y), "{name}, {batch}, {i} of {count}: {matrix} {x:?} {y:?}");
                }
            }
        }
    }
}

/// In `f64`, and in `f32`.
fn check_some<const N: usize, M: Model<N, Scalar = f64, Over<f32>: Model<N, Scalar = f32>>>() {
    check(&some::<N, M>());
    check(&some::<N, M::Over<f32>>());
}

#[test]
fn every_model_is_computed_in_lanes_as_alone() {
    assert!(!each_model!(check_some).is_empty());
}

#[test]
fn angles_of_every_kind_are_computed_in_lanes_as_alone() {
    let angles =
        [0.0, -0.0, 0.3, -0.7, 0.785, 0.786, 1.2, -1.57, 3.0, 40.0, -9e4, 1.1e5, 1e22, f64::NAN, f64::INFINITY];
    let design = |number: usize| Whipple {
        // Neighbours of every pair, so that kinds mix in the lanes in every way.
        lam: angles[number * number / 2 % angles.len()],
        ..designs::numbered(number as u64)
    };
    let designs: Vec<Whipple> = (0..DESIGNS).map(design).collect();
    check(&designs);
    check(&designs.iter().map(designs::narrowed).collect::<Vec<Whipple<f32>>>());
}

/// Of every size, and all of those about a quarter of pi, where rounding and comparing could choose differently.
#[test]
fn angles_of_f32_are_computed_in_lanes_as_alone() {
    let quarter = std::f32::consts::FRAC_PI_4;
    let near = (quarter.to_bits() - 300..quarter.to_bits() + 300).map(f32::from_bits);
    let angles = (0..u32::MAX).step_by(1_000_003).map(f32::from_bits).chain(near);
    let mut number = 0;
    let design = |lam: f32| {
        number += 1;
        Whipple { lam, ..designs::narrowed(&designs::numbered(number)) }
    };
    let designs: Vec<Whipple<f32>> = angles.map(design).collect();
    for batch in Batch::levels() {
        let mut coefficients = vec![Coefficients::default(); designs.len()];
        batch.coefficients(&designs, &mut coefficients).unwrap();
        for (design, found) in designs.iter().zip(&coefficients) {
            let expected = design.coefficients();
            for matrix in MatrixName::ALL {
                let [x, y] = [found, &expected].map(|all| all.matrix(matrix).as_slice());
                assert!(same(x, y), "{batch}, {}: {matrix} {x:?} {y:?}", design.lam);
            }
        }
    }
}

/// Columns too long for the cache are read line by line, so that what is before the first whole line and behind the last
/// stretch comes by itself; here they begin at every place of a line.
fn long_columns<T: InLanes>(designs: &[Whipple<T>]) {
    let alone: Vec<Vec<T>> = designs.iter().map(entries).collect();
    let column = |position: usize| -> Vec<T> { designs.iter().map(|design| design.to_array()[position]).collect() };
    let columns: Vec<Vec<T>> = (0..26).map(column).collect();
    for batch in Batch::levels() {
        for skipped in [0, 1, 3, 8, 13] {
            let inputs: Vec<&[T]> = columns.iter().map(|column| &column[skipped..]).collect();
            let none = T::from_f64(f64::NAN);
            let mut outputs = vec![vec![none; designs.len() - skipped]; alone[0].len()];
            let mut borrowed: Vec<&mut [T]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
            batch.matrices_of_columns::<2, Whipple<T>>(&inputs, &mut borrowed).unwrap();
            for (i, expected) in alone[skipped..].iter().enumerate() {
                let found: Vec<T> = outputs.iter().map(|column| column[i]).collect();
                assert!(same(&found, expected), "{batch}, {i} behind {skipped}: {found:?} {expected:?}");
            }
        }
    }
}

#[test]
fn long_columns_are_computed_in_lanes_as_alone() {
    let designs: Vec<Whipple> = (0..4200).map(designs::numbered).collect();
    long_columns(&designs.iter().map(designs::narrowed).collect::<Vec<Whipple<f32>>>());
    long_columns(&designs);
}

#[test]
fn the_widest_lanes_are_the_last_level() {
    let levels: Vec<usize> = Batch::levels().map(|batch| batch.lanes()).collect();
    assert!(levels.is_sorted() && levels.last() == Some(&Batch::new().lanes()), "{levels:?}");
    #[cfg(target_arch = "x86_64")]
    assert_eq!(levels[..2], [2, 2]);
}

#[test]
fn all_cores_give_the_same() {
    let designs: Vec<Whipple> = (0..5000).map(designs::numbered).collect();
    let parameters = Blocks::of_designs(&designs);
    let [mut one, mut all] = [(); 2].map(|()| Blocks::for_entries::<2, Whipple>(designs.len()));
    Batch::new().matrices::<2, Whipple>(&parameters, &mut one).unwrap();
    Batch::new().parallel_matrices::<2, Whipple>(&parameters, &mut all).unwrap();
    assert_eq!(one, all);
    assert_eq!(one.column(0).len(), designs.len());
    assert_eq!(one.column(0).last(), Some(designs[4999].matrices().m[0][0]));
}

#[test]
fn entries_name_their_places() {
    let names: Vec<String> = Whipple::INFO.entries.iter().map(ToString::to_string).collect();
    let expected = ["M_11", "M_12", "M_22", "C1_12", "C1_21", "C1_22", "K0_11", "K0_12", "K0_22", "K2_12", "K2_22"];
    assert_eq!(names, expected);
    assert_eq!(Whipple::INFO.entries[1].places, [(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]);
}

#[test]
fn what_does_not_fit_is_an_error_that_says_so() {
    let batch = Batch::new();
    let column: &[f64] = &[1.0, 2.0];
    let few = batch.matrices_of_columns::<1, Pendulum>(&[column; 2], &mut []);
    let parameters = Pendulum::INFO.parameters.len();
    let expected = BatchError::Columns { model: "Pendulum", what: "parameters", expected: parameters, found: 2 };
    assert_eq!(few, Err(expected));
    assert_eq!(
        expected.to_string(),
        format!("Pendulum: 2 columns of parameters given; it has {parameters} parameters")
    );

    let mut columns = vec![column; parameters];
    columns[1] = &[1.0];
    let mut outputs = vec![vec![0.0; 2]; Pendulum::INFO.entries.len()];
    let mut outputs: Vec<&mut [f64]> = outputs.iter_mut().map(|column| &mut column[..]).collect();
    let uneven = batch.matrices_of_columns::<1, Pendulum>(&columns, &mut outputs);
    let expected = BatchError::Length { what: "parameter", position: 1, expected: 2, found: 1 };
    assert_eq!(uneven, Err(expected));
    let message = "parameter 1 is given for 1 designs: expected 2, as many as there are of the first";
    assert_eq!(expected.to_string(), message);
    assert!(Blocks::from_columns(&columns).is_err());

    let designs = [Pendulum::from_slice(Pendulum::INFO.sets[0].values).unwrap(); 3];
    let mut room = [designs[0].coefficients(); 2];
    let short = batch.coefficients(&designs, &mut room);
    assert_eq!(short, Err(BatchError::Length { what: "result", position: 0, expected: 3, found: 2 }));
    let (blocks, mut wrong) = (Blocks::of_designs(&designs), Blocks::for_entries::<1, Pendulum>(2));
    let short = batch.matrices::<1, Pendulum>(&blocks, &mut wrong);
    assert_eq!(short, Err(BatchError::Length { what: "entry", position: 0, expected: 3, found: 2 }));
}
