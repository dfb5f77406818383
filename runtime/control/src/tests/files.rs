//! Files for NumPy and MATLAB. The bytes in `small.npz` and `small.mat` were read back by `numpy.load` (2.4) and
//! `scipy.io.loadmat` (1.17), with the numbers and names below.

use nalgebra::DMatrix;

use crate::{Signal, StateSpace, files};

fn signal(name: &str, unit: &str) -> Signal {
    Signal { name: name.to_owned(), label: String::new(), unit: unit.to_owned() }
}

fn small() -> StateSpace {
    let matrix = DMatrix::from_row_slice;
    StateSpace {
        a: matrix(2, 2, &[0.0, 1.0, -2.5, 0.1]),
        b: matrix(2, 1, &[0.0, 3e-300]),
        c: matrix(3, 2, &[1.0, 0.0, 0.0, 1.0, -2.5, 0.1]),
        d: matrix(3, 1, &[0.0, 0.0, 3e-300]),
        states: vec![signal("q", "rad"), signal("q_rate", "rad/s")],
        inputs: vec![signal("Tq", "N*m")],
        outputs: vec![signal("q", "rad"), signal("q_rate", "rad/s"), signal("q_acceleration", "rad/s^2")],
        speed: Some(4.5),
        speed_unit: carvallo_design::DisplayUnit::declared("m/s"),
    }
}

#[test]
fn an_archive_of_numpy_has_these_bytes() {
    let mut bytes = Vec::new();
    files::write_npz(&small(), &mut bytes).expect("bytes");
    assert!(
        bytes == include_bytes!("small.npz"),
        "the bytes have changed: read them with numpy.load before they are kept"
    );
}

#[test]
fn a_file_of_matlab_has_these_bytes() {
    let mut bytes = Vec::new();
    files::write_mat(&small(), &mut bytes).expect("bytes");
    assert!(
        bytes == include_bytes!("small.mat"),
        "the bytes have changed: read them with loadmat before they are kept"
    );
}
