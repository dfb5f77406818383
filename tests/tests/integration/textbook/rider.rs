//! The bicycle with a rider who leans.

use carvallo_models::Whipple;
use carvallo_tests::textbook::rider::{self, UpperBody};
use nalgebra::Matrix3;

use super::G;

/// A measured bicycle with the legs of its rider, and his upper body: parameter sets `meijaard2007_browser_jasonlegs`
/// and `mooreriderlean2012_browser_jason` of BicycleParameters 1.5.2, the second in the terms of the first.
fn browser_with_a_leaning_rider() -> (Whipple, UpperBody) {
    let bicycle = Whipple {
        w: 1.121,
        c: 0.0685808540382,
        lam: 0.399680398707,
        g: G,
        rR: 0.340958858855,
        mR: 3.11,
        IRxx: 0.0904106601579,
        IRyy: 0.152467620286,
        xB: 0.374570794542,
        zB: -0.681592725778,
        mB: 33.044,
        IBxx: 2.18917391377,
        IByy: 2.9922715238,
        IBzz: 1.61787114693,
        IBxz: -0.27087131147,
        xH: 0.866949640247,
        zH: -0.748236400835,
        mH: 3.22,
        IHxx: 0.253379594731,
        IHyy: 0.246138810935,
        IHzz: 0.0955770796289,
        IHxz: -0.0720452391817,
        rF: 0.34352982332,
        mF: 2.02,
        IFxx: 0.0883819364527,
        IFyy: 0.149389340425,
    };
    let upper = UpperBody {
        h: 1.011421527346159,
        m: 48.816,
        x: 0.231223496809401,
        z: -1.283035074598082,
        Ixx: 2.038073562525466,
        Izz: 1.100753962972129,
        Ixz: 0.002113501449812,
        stiffness: 128.0,
        damping: 50.0,
    };
    (bicycle, upper)
}

/// What `eval_linear` of BicycleParameters 1.5.2 gives for it at 4 m/s, lean, steer and lean of the rider taken out.
/// At zero stiffness and damping, these are the matrices that are printed in its documentation.
#[test]
fn a_leaning_rider_accelerates_as_in_moores_dissertation() {
    let (bicycle, upper) = browser_with_a_leaning_rider();
    let system = rider::matrices(&bicycle, &upper).at(4.0, G).unwrap();
    let inverse = system.m.try_inverse().unwrap();
    let torques = Matrix3::from_rows(&[
        [0.028838081817475984, -0.11361236505391584, -0.09393173522789343].into(),
        [-0.11361236505391584, 4.590778230323287, 0.2430346197646396].into(),
        [-0.09393173522789344, 0.2430346197646396, 0.48717312842398647].into(),
    ]);
    let angles = Matrix3::from_rows(&[
        [11.109569205745899, -15.234101147338672, 3.556423680004165].into(),
        [10.493976238585603, 5.617380983823259, -14.2742660562633].into(),
        [-14.785107339574909, 20.37557025093179, -11.208606443215405].into(),
    ]);
    let rates = Matrix3::from_rows(&[
        [-0.20463886434819867, -1.3459080280464801, 4.696586761394671].into(),
        [8.268920755957893, -10.198034476227688, -12.15173098823198].into(),
        [0.4377545398542684, 2.5409408617714857, -24.35865642119932].into(),
    ]);
    for (found, expected, what) in
        [(inverse, torques, "torques"), (-inverse * system.k, angles, "angles"), (-inverse * system.c, rates, "rates")]
    {
        let off = (found - expected).amax() / expected.amax();
        assert!(off <= 1e-13, "what {what} do is off by {off:e}: {found} instead of {expected}");
    }
}
