use carvallo::Model;
use carvallo_tests::bicycles;
use carvallo_tests::multibody::bicycle::{Bicycle, Extras};

#[test]
fn explore() {
    for (name, design) in bicycles::all() {
        let bicycle = Bicycle::new(&design, &Extras::default());
        let found = bicycle.mechanism.linearized([bicycle.root.lean, bicycle.steer], Some(bicycle.root.x));
        let expected = design.coefficients();
        for (n, a, b) in [("M", found.m, expected.m), ("C1", found.c1, expected.c1), ("K0", found.k0, expected.k0), ("K2", found.k2, expected.k2), ("C0", found.c0, expected.c0), ("Kc", found.kc, expected.kc)] {
            println!("{name} {n} {:e} {:e}", (a - b).amax() , b.amax());
        }
    }
}
