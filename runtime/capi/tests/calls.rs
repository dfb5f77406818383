//! What C is answered, by numbers that are published and by calls that are wrong.

use std::ffi::{CStr, CString};
use std::ptr::{null, null_mut};

use carvallo_capi::*;

fn message() -> String {
    // SAFETY: it is a text, and valid until the next call.
    unsafe { CStr::from_ptr(carvallo_message()) }.to_str().expect("UTF-8").to_owned()
}

struct Owned(*mut Machine);

impl Owned {
    fn new(model: &CStr, parameters: Option<&CStr>) -> Self {
        let mut machine = null_mut();
        // SAFETY: all of these are valid.
        let status =
            unsafe { carvallo_machine_new(model.as_ptr(), parameters.map_or(null(), CStr::as_ptr), &raw mut machine) };
        assert_eq!(status, CarvalloStatus::Ok, "{}", message());
        Self(machine)
    }

    fn of_matrices(matrices: &Matrices) -> Result<Self, (CarvalloStatus, String)> {
        let mut machine = null_mut();
        // SAFETY: the tests give what is promised.
        match unsafe { carvallo_machine_of_matrices(matrices, &raw mut machine) } {
            CarvalloStatus::Ok => Ok(Self(machine)),
            status => {
                assert!(machine.is_null());
                Err((status, message()))
            }
        }
    }

    fn eigenvalues(&self, speed: f64) -> Vec<Complex> {
        // SAFETY: as many as there are.
        unsafe {
            let count = carvallo_machine_states(self.0);
            let mut values = vec![Complex { re: 0.0, im: 0.0 }; count];
            let status = carvallo_eigenvalues(self.0, speed, values.as_mut_ptr(), count);
            assert_eq!(status, CarvalloStatus::Ok, "{}", message());
            values
        }
    }

    /// Critical speeds without double roots, and stable ranges.
    fn stability(&self) -> (Vec<CriticalSpeed>, Vec<Range>) {
        // SAFETY: lists are as long as they say, and valid until the answer is freed.
        unsafe {
            let mut stability = null_mut();
            assert_eq!(carvallo_stability_new(self.0, &raw mut stability), CarvalloStatus::Ok, "{}", message());
            let mut count = 0;
            let first = carvallo_stability_critical_speeds(stability, &raw mut count);
            let speeds = (0..count).map(|index| *first.add(index));
            let speeds = speeds.filter(|critical| critical.kind != CarvalloKind::DoubleRoot).collect();
            let first = carvallo_stability_stable_ranges(stability, &raw mut count);
            let ranges = (0..count).map(|index| *first.add(index)).collect();
            carvallo_stability_free(stability);
            (speeds, ranges)
        }
    }
}

impl Drop for Owned {
    fn drop(&mut self) {
        // SAFETY: once.
        unsafe { carvallo_machine_free(self.0) }
    }
}

/// Without any matrix but M.
fn matrices(n: usize, m: &[f64]) -> Matrices {
    let [cm1, c0, c1, kc, k0, k1, k2] = [null(); 7];
    Matrices { n, m: m.as_ptr(), cm1, c0, c1, kc, k0, k1, k2, gravity: 0.0, states: null() }
}

/// Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 2 at 5 m/s, and the speeds of section 7.
const AT_5: [[f64; 2]; 4] = [
    [-14.078_389_692_798_22, 0.0],
    [-0.775_341_882_195_85, -4.464_867_713_788_23],
    [-0.775_341_882_195_85, 4.464_867_713_788_23],
    [-0.322_866_429_004_09, 0.0],
];
const WEAVE: f64 = 4.292_382_536_341_11;
const CAPSIZE: f64 = 6.024_262_015_388_37;

fn is_benchmark(machine: &Owned) {
    for (value, [re, im]) in machine.eigenvalues(5.0).iter().zip(AT_5) {
        assert!((value.re - re).abs() < 1e-12 && (value.im - im).abs() < 1e-12, "{value:?}");
    }
    let (speeds, ranges) = machine.stability();
    let [weave, capsize] = speeds[..] else { panic!("{speeds:?}") };
    assert!((weave.speed - WEAVE).abs() < 1e-12 && weave.kind == CarvalloKind::Weave);
    assert!((capsize.speed - CAPSIZE).abs() < 1e-12 && capsize.kind == CarvalloKind::Capsize);
    assert_eq!((weave.change, capsize.change), (CarvalloChange::Stabilizes, CarvalloChange::Destabilizes));
    assert_eq!(ranges, [Range { from: weave.speed, to: capsize.speed }]);
}

#[test]
fn published_numbers_come_out_by_name_and_of_printed_matrices() {
    is_benchmark(&Owned::new(c"whipple", Some(c"benchmark")));
    // Section 7.1 of the same, as printed.
    let m = [80.817_22, 2.319_413_322_087_09, 2.319_413_322_087_09, 0.297_841_881_996_86];
    let c1 = [0.0, 33.866_413_914_924_94, -0.850_356_414_569_78, 1.685_403_973_975_60];
    let k0 = [-80.95, -2.599_516_852_498_72, -2.599_516_852_498_72, -0.803_294_884_586_18];
    let k2 = [0.0, 76.597_345_895_732_22, 0.0, 2.654_315_237_946_04];
    let given = Matrices { c1: c1.as_ptr(), k0: k0.as_ptr(), k2: k2.as_ptr(), gravity: 9.81, ..matrices(2, &m) };
    let machine = Owned::of_matrices(&given).expect("a machine");
    for (value, [re, im]) in machine.eigenvalues(5.0).iter().zip(AT_5) {
        assert!((value.re - re).abs() < 1e-10 && (value.im - im).abs() < 1e-10, "{value:?}");
    }
    let (speeds, _) = machine.stability();
    assert!((speeds[0].speed - WEAVE).abs() < 1e-11 && (speeds[1].speed - CAPSIZE).abs() < 1e-11);
}

/// q' = -2 q, of first order, beside an oscillator: its closed form is at hand.
#[test]
fn states_of_first_order_make_one_eigenvalue_each() {
    let (m, c0, kc) = ([1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0], [9.0, 0.0, 0.0, 2.0]);
    let states = [CarvalloStates::Both as i32, CarvalloStates::Position as i32];
    let given = Matrices { c0: c0.as_ptr(), kc: kc.as_ptr(), states: states.as_ptr(), ..matrices(2, &m) };
    let values = Owned::of_matrices(&given).expect("a machine").eigenvalues(1.0);
    let expected = [(-2.0, 0.0), (0.0, -3.0), (0.0, 3.0)];
    assert_eq!(values.len(), 3);
    for (value, (re, im)) in values.iter().zip(expected) {
        assert!((value.re - re).abs() < 1e-14 && (value.im - im).abs() < 1e-14, "{values:?}");
    }
}

/// A critical speed that moves as its derivative says, by a difference of its own.
#[test]
fn derivatives_of_critical_speeds_are_those_of_differences() {
    let machine = Owned::new(c"Whipple", None);
    // SAFETY: as many as there are.
    let derivative = unsafe {
        let mut stability = null_mut();
        assert_eq!(carvallo_stability_new(machine.0, &raw mut stability), CarvalloStatus::Ok);
        let (mut count, parameters) = (0, carvallo_machine_parameters(machine.0));
        let speeds = carvallo_stability_critical_speeds(stability, &raw mut count);
        let weave = (0..count).find(|index| (*speeds.add(*index)).kind == CarvalloKind::Weave).expect("weave");
        let mut derivatives = vec![0.0; parameters];
        let status = carvallo_critical_speed_derivatives(stability, weave, derivatives.as_mut_ptr(), parameters);
        assert_eq!(status, CarvalloStatus::Ok, "{}", message());
        carvallo_stability_free(stability);
        let name = |index| CStr::from_ptr(carvallo_machine_parameter_name(machine.0, index));
        derivatives[(0..parameters).find(|index| name(*index) == c"w").expect("the wheel base")]
    };
    let mut wheel_base = 0.0;
    let mut weave_at = |step: f64| {
        // SAFETY: these are valid.
        unsafe {
            if step < 0.0 {
                carvallo_machine_get(machine.0, c"w".as_ptr(), &raw mut wheel_base);
            }
            carvallo_machine_set(machine.0, c"w".as_ptr(), wheel_base + step);
        }
        machine.stability().0[0].speed
    };
    let (below, above) = (weave_at(-1e-5), weave_at(1e-5));
    assert!(((above - below) / 2e-5 - derivative).abs() < 1e-7, "{derivative}");
}

/// Divided by hand: the mass matrix is diagonal, and the second coordinate has no rate.
#[test]
fn state_space_is_the_equations_solved_for_the_rates() {
    let (m, c0) = ([2.0, 0.0, 0.0, 0.0], [3.0, 0.0, 0.0, 4.0]);
    let kc = [5.0, 6.0, 7.0, 8.0];
    let states = [CarvalloStates::Both as i32, CarvalloStates::Position as i32];
    let given = Matrices { c0: c0.as_ptr(), kc: kc.as_ptr(), states: states.as_ptr(), ..matrices(2, &m) };
    let machine = Owned::of_matrices(&given).expect("a machine");
    let (mut a, mut b) = ([9.0; 9], [9.0; 6]);
    // SAFETY: as many as there are.
    let status = unsafe { carvallo_state_space(machine.0, 1.0, a.as_mut_ptr(), 9, b.as_mut_ptr(), 6) };
    assert_eq!(status, CarvalloStatus::Ok, "{}", message());
    assert_eq!(a, [0.0, 0.0, 1.0, -1.75, -2.0, 0.0, -2.5, -3.0, -1.5]);
    assert_eq!(b, [0.0, 0.0, 0.0, 0.25, 0.5, 0.0]);
}

/// What is found stays what it is when the machine changes; and names are those of the paper.
#[test]
fn derivatives_are_of_the_machine_that_was_asked() {
    let machine = Owned::new(c"Whipple", None);
    // SAFETY: as many as there are, and texts are valid.
    unsafe {
        let mut stability = null_mut();
        assert_eq!(carvallo_stability_new(machine.0, &raw mut stability), CarvalloStatus::Ok);
        let count = carvallo_machine_parameters(machine.0);
        let [mut before, mut after] = [(); 2].map(|()| vec![0.0; count]);
        let ask = |out: &mut Vec<f64>| carvallo_critical_speed_derivatives(stability, 1, out.as_mut_ptr(), count);
        assert_eq!(ask(&mut before), CarvalloStatus::Ok, "{}", message());
        assert_eq!(carvallo_machine_set(machine.0, c"w".as_ptr(), 1.3), CarvalloStatus::Ok);
        assert_eq!(ask(&mut after), CarvalloStatus::Ok, "{}", message());
        assert!(before == after && before.iter().any(|&derivative| derivative != 0.0));
        carvallo_stability_free(stability);
        let names = [0, 1].map(|index| CStr::from_ptr(carvallo_machine_coordinate_name(machine.0, index)));
        assert_eq!(names, [c"phi", c"delta"]);
        let first = carvallo_parameters_name(c"whipple".as_ptr(), 0);
        assert_eq!(CStr::from_ptr(first), c"benchmark");
    }
}

#[test]
fn eigenvectors_solve_the_equations() {
    let (m, kc) = ([2.0, 1.0, 1.0, 1.0], [2.0, 0.0, 0.0, 1.0]);
    let machine = Owned::of_matrices(&Matrices { kc: kc.as_ptr(), ..matrices(2, &m) }).expect("a machine");
    let values = machine.eigenvalues(0.0);
    let mut right = [Complex { re: 0.0, im: 0.0 }; 8];
    // SAFETY: as many as there are.
    let status =
        unsafe { carvallo_eigenvectors(machine.0, 0.0, values.as_ptr(), 4, right.as_mut_ptr(), null_mut(), 8) };
    assert_eq!(status, CarvalloStatus::Ok, "{}", message());
    // A double pendulum of equal rods and masses: the lower one swings root 2 as far as the upper one, with it or against it.
    for (value, shape) in values.iter().zip(right.chunks(2)) {
        let sign = if value.im.abs() < 1.0 { 1.0 } else { -1.0 };
        assert!((shape[0].re - sign / 2.0_f64.sqrt()).abs() < 1e-14 && shape[1].re == 1.0, "{right:?}");
    }
}

/// Of all models, whatever the number of threads, what each design gives alone.
#[test]
fn batches_are_many_designs() {
    for index in 0.. {
        let name = carvallo_model_name(index);
        if name.is_null() {
            assert!(index > 20);
            break;
        }
        // SAFETY: it is a text.
        let machine = Owned::new(unsafe { CStr::from_ptr(name) }, None);
        batch_of(&machine);
    }
}

fn batch_of(machine: &Owned) {
    const DESIGNS: usize = 150;
    // SAFETY: arrays are as long as they are said to be.
    unsafe {
        let name = CStr::from_ptr(carvallo_machine_parameter_name(machine.0, 0));
        let mut value = 0.0;
        carvallo_machine_get(machine.0, name.as_ptr(), &raw mut value);
        let mut values: Vec<f64> = (0..DESIGNS).map(|design| value * (1.0 + 1e-4 * design as f64)).collect();
        values[7] = f64::NAN;
        let column = Column { name: name.as_ptr(), values: values.as_ptr() };
        let states = carvallo_machine_states(machine.0);
        let [mut first, mut second] = [(); 2].map(|()| vec![Complex { re: 9.0, im: 9.0 }; DESIGNS * states]);
        let mut statuses = vec![CarvalloStatus::Panicked; DESIGNS];
        let empty = Summary {
            status: CarvalloStatus::Panicked,
            critical_speeds: 9,
            stable_ranges: 9,
            undecided: 9,
            stable: Range { from: 9.0, to: 9.0 },
        };
        let [mut one, mut many] = [(); 2].map(|()| vec![empty; DESIGNS]);
        for (threads, values, summaries) in [(1, &mut first, &mut one), (3, &mut second, &mut many)] {
            let all = values.len();
            let (values, statuses) = (values.as_mut_ptr(), statuses.as_mut_ptr());
            let status =
                carvallo_batch_eigenvalues(machine.0, &column, 1, DESIGNS, 3.0, threads, values, all, statuses);
            assert_eq!(status, CarvalloStatus::Ok, "{}", message());
            // Stability of many coordinates takes milliseconds.
            let designs = if states > 4 { 9 } else { DESIGNS };
            let summaries = summaries.as_mut_ptr();
            let status = carvallo_batch_stability(machine.0, &column, 1, designs, threads, summaries, null_mut(), 0);
            assert_eq!(status, CarvalloStatus::Ok, "{}", message());
        }
        assert_eq!((&first, &one), (&second, &many));
        assert_eq!((statuses[7], one[7].status), (CarvalloStatus::Invalid, CarvalloStatus::Invalid));
        assert_eq!(first[7 * states], Complex { re: 0.0, im: 0.0 });
        carvallo_machine_set(machine.0, name.as_ptr(), values[8]);
        assert_eq!(statuses[8], CarvalloStatus::Ok);
        assert_eq!(machine.eigenvalues(3.0), first[8 * states..9 * states]);
        let speeds = [3.0, 4.0];
        let mut along = vec![Complex { re: 9.0, im: 9.0 }; 2 * states];
        let status = carvallo_eigenvalues_along(machine.0, speeds.as_ptr(), 2, along.as_mut_ptr(), 2 * states);
        assert_eq!(status, CarvalloStatus::Ok, "{}", message());
        assert_eq!(along, [machine.eigenvalues(3.0), machine.eigenvalues(4.0)].concat());
        let (_, ranges) = machine.stability();
        assert_eq!(one[8].stable_ranges, ranges.len());
        assert_eq!(one[8].stable, ranges.first().copied().unwrap_or(Range { from: 0.0, to: 0.0 }));
    }
}

#[test]
fn what_is_wrong_is_a_code_and_a_message() {
    use CarvalloStatus::{Invalid, NoAnswer, NullPointer, UnknownName, WrongSize};
    let machine = Owned::new(c"Whipple", None);
    let mut other = null_mut();
    let mut value = 7.0;
    let mut values = [Complex { re: 7.0, im: 7.0 }; 4];
    let check = |status: CarvalloStatus, expected: CarvalloStatus, said: &str| {
        assert!(status == expected && message().contains(said), "{status:?}: {}", message());
    };
    // SAFETY: NULL is answered, and all else is valid.
    unsafe {
        let model = CString::new("Wipple").expect("a text");
        check(carvallo_machine_new(model.as_ptr(), null(), &raw mut other), UnknownName, "did you mean `Whipple`?");
        check(carvallo_machine_new(null(), c"pistaa".as_ptr(), &raw mut other), UnknownName, "pista");
        check(carvallo_machine_new(null(), c"-".as_ptr(), &raw mut other), UnknownName, "standard input");
        check(carvallo_machine_new(null(), c"\xff".as_ptr(), &raw mut other), UnknownName, "UTF-8");
        check(carvallo_machine_new(null(), null(), null_mut()), NullPointer, "`machine` is NULL");
        check(carvallo_machine_get(machine.0, c"wheelbase".as_ptr(), &raw mut value), UnknownName, "wheelbase");
        check(carvallo_machine_get(machine.0, null(), &raw mut value), NullPointer, "`name` is NULL");
        check(carvallo_machine_get(null(), c"w".as_ptr(), &raw mut value), NullPointer, "`machine` is NULL");
        check(carvallo_eigenvalues(machine.0, 5.0, values.as_mut_ptr(), 3), WrongSize, "it must be 4");
        check(carvallo_eigenvalues(machine.0, 5.0, null_mut(), 4), NullPointer, "`values` is NULL");
        check(
            carvallo_eigenvalues(machine.0, f64::NAN, values.as_mut_ptr(), 4),
            NoAnswer,
            "speed is NaN; it must be finite",
        );
        let entries = (&raw mut value).cast::<u8>().wrapping_add(1).cast();
        check(carvallo_machine_matrix(machine.0, c"M".as_ptr(), entries, 4), NullPointer, "aligned");
        check(carvallo_machine_matrix(machine.0, c"K3".as_ptr(), [0.0; 4].as_mut_ptr(), 4), UnknownName, "C-1, C0");
        check(carvallo_machine_set(machine.0, c"w".as_ptr(), -1.0), CarvalloStatus::Ok, "");
        check(carvallo_eigenvalues(machine.0, 5.0, values.as_mut_ptr(), 4), Invalid, "`w` is -1 m; it must be > 0");
        let mut stability = null_mut();
        check(carvallo_stability_new(machine.0, &raw mut stability), Invalid, "`w` is -1 m");
        check(carvallo_stability_new(null(), &raw mut stability), NullPointer, "`machine` is NULL");
        assert!(stability.is_null());
        let mut count = 7;
        assert!(carvallo_stability_critical_speeds(null(), &raw mut count).is_null());
        assert_eq!((count, carvallo_machine_states(null())), (0, 0));
        let columns = [Column { name: c"w".as_ptr(), values: &raw const value }; 2];
        let huge = usize::MAX / 4;
        let status = carvallo_batch_stability(machine.0, columns.as_ptr(), 2, 1, 1, null_mut(), null_mut(), 0);
        check(status, Invalid, "two columns of `w`");
        let status = carvallo_batch_stability(machine.0, columns.as_ptr(), 1, huge, 1, null_mut(), null_mut(), 0);
        check(status, WrongSize, "no array has so many");
        carvallo_machine_free(null_mut());
        carvallo_stability_free(null_mut());
    }
    assert_eq!((value, values), (7.0, [Complex { re: 7.0, im: 7.0 }; 4]));
    assert!(other.is_null());
    let wrong = |given: Matrices, expected: CarvalloStatus, said: &str| match Owned::of_matrices(&given) {
        Err((status, message)) => assert!(status == expected && message.contains(said), "{status:?}: {message}"),
        Ok(_) => panic!("{said}"),
    };
    wrong(matrices(0, &[]), WrongSize, "from 1 to 12");
    wrong(matrices(13, &[]), WrongSize, "from 1 to 12");
    wrong(Matrices { m: null(), ..matrices(1, &[]) }, NullPointer, "`matrices->m` is NULL");
    wrong(matrices(1, &[f64::INFINITY]), Invalid, "M_11");
    wrong(matrices(2, &[1.0, 2.0, 2.0, 4.0]), Invalid, "M");
    wrong(Matrices { states: [3].as_ptr(), ..matrices(1, &[1.0]) }, Invalid, "carvallo_states_t");
}
