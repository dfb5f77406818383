//! Trees on a fixed base, and vehicles whose wheels roll without slip.

use carvallo_tests::designs::config;
use carvallo_tests::multibody::Wheel;
use proptest::prelude::*;

use super::super::assert_close;
use super::DIFFERENCES;
use super::links::{link, vector};
use super::pair::{Carrier, Pair};

proptest! {
    #![proptest_config(config(12))]

    #[test]
    fn trees_of_any_joints_on_a_fixed_base(links in [link(), link(), link()]) {
        let mut pair = Pair::default();
        let mut carriers = vec![Carrier { name: "ground".into(), joint: None }];
        for link in &links {
            let from = link.on.get(&carriers).clone();
            let next = pair.joint(&from, link);
            carriers.push(next);
        }
        let found = pair.compiled::<3>(None)?;
        let mut expected = pair.numeric.linearized([0, 1, 2], None);
        // Nothing has weight without a gravity.
        expected.k0 *= 0.0;
        assert_close(&found, &expected, DIFFERENCES, "tree");
    }

    #[test]
    fn trees_of_balls_and_planar_bodies(
        three in [link(), link(), link()],
        link in link(),
        is_ball in any::<bool>(),
        is_first in any::<bool>(),
        momentum in vector(3.0),
    ) {
        prop_assume!(three[0].axis.cross(&three[1].axis).norm() > 0.1);
        let mut pair = Pair::default();
        let mut carrier = Carrier { name: "ground".into(), joint: None };
        for turn in [is_first, !is_first] {
            carrier = if turn { pair.three(&carrier, &three, is_ball) } else { pair.joint(&carrier, &link) };
        }
        pair.rotor("spin", &carrier, momentum);
        // All of it hangs on springs.
        let found = pair.compiled::<4>(Some(9.81))?;
        let expected = pair.numeric.linearized([0, 1, 2, 3], None);
        assert_close(&found, &expected, DIFFERENCES, "three freedoms at once");
    }

    #[test]
    fn vehicles_on_two_wheels_with_any_joints(
        frame in link(),
        links in [link(), link()],
        front_on in any::<prop::sample::Index>(),
        (rear, front) in ([0.1..0.5, 0.0..0.1, 1.0..5.0, 0.1..0.5, 0.05..0.3], [0.1..0.5, 0.0..0.1, 1.0..5.0, 0.1..0.5, 0.05..0.3]),
        wheel_base in 0.7..2.0,
    ) {
        let mut pair = Pair::default();
        let root = pair.numeric.free_root();
        pair.parts.push_str("free b: lean phi;\n");
        pair.coordinates.push_str("phi: rad;");
        let frame = frame.in_plane();
        pair.body("b", root.pitch, frame.mass, frame.centre, frame.inertia());
        let mut carriers = vec![Carrier { name: "b".into(), joint: Some(root.pitch) }];
        for link in links {
            let link = link.in_plane();
            let from = link.on.get(&carriers).clone();
            let next = pair.joint(&from, &link);
            carriers.push(next);
        }
        let wheel = |[radius, tyre, mass, axial, transverse]: [f64; 5], x, carrier| Wheel {
            carrier, x, y: 0.0, radius, tyre, mass, axial, transverse,
        };
        let (first, last) = (carriers[0].clone(), front_on.get(&carriers).clone());
        pair.wheel("r", &first, wheel(rear, 0.0, root.pitch), None);
        pair.wheel("f", &last, wheel(front, wheel_base, last.joint.expect("a joint")), None);
        let found = pair.compiled::<3>(Some(9.81))?;
        let coordinates = [root.lean, root.pitch + 1, root.pitch + 2];
        assert_close(&found, &pair.numeric.linearized(coordinates, Some(root.x)), DIFFERENCES, "vehicle");
    }
}
