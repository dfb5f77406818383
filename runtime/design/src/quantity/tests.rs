//! Every spelling of the table, and what is refused.

use super::{Context, Lookup, Measured, Mistake, Part, Reason, measured, no_names, number};

fn read(text: &str, unit: &str) -> Result<(f64, Option<f64>), String> {
    let names: &Lookup = &|name| (name == "IRxx").then_some(Ok(0.06));
    let found = measured(text, Context { unit, names });
    found.map(|Measured { mean, deviation }| (mean.value, deviation.map(|part| part.value))).map_err(
        |Mistake { text, is_deviation, reason }| match reason {
            Reason::Unit(unit) => format!("{text}: unit {unit}"),
            Reason::Other(reason) if is_deviation => format!("deviation {text}: {reason}"),
            Reason::Other(reason) => format!("{text}: {reason}"),
        },
    )
}

#[track_caller]
fn check(text: &str, unit: &str, value: f64, deviation: Option<f64>) {
    let bits = |(value, deviation): (f64, Option<f64>)| (value.to_bits(), deviation.map(f64::to_bits));
    assert_eq!(read(text, unit).map(bits), Ok(bits((value, deviation))), "{text}");
}

#[test]
fn deviations_in_every_spelling() {
    for text in ["0.08+/-0.001", "0.08 +/- 0.001", "0.08±0.001", "0.08+-0.001", "0.08 + - 0.001", "0.08 + / - 1e-3"] {
        check(text, "m", 0.08, Some(0.001));
    }
    check("85+-5", "kg", 85.0, Some(5.0));
    check("-0.9 +/- 0.01", "m", -0.9, Some(0.01));
    check("(8.0+/-0.1)e-02", "m", 0.08, Some(0.001));
    check("(-8.0+/-0.1)e-02", "m", -0.08, Some(0.001));
    check("(85 +/- 5) kg", "kg", 85.0, Some(5.0));
    check("85 kg +/- 500 g", "kg", 85.0, Some(0.5));
    check("85 +/- 5 kg", "kg", 85.0, Some(5.0));
    check("pi/10 +/- 1 deg", "rad", std::f64::consts::PI / 10.0, Some(std::f64::consts::PI / 180.0));
    check("27 deg +/- 0.0", "rad", 27.0 * std::f64::consts::PI / 180.0, Some(0.0));
}

#[test]
fn deviations_of_the_last_digits() {
    check("1.020(3)", "m", 1.02, Some(0.003));
    check("-1.020(13)", "m", -1.02, Some(0.013));
    check("1.020(3)e-2", "m", 0.0102, Some(0.000_03));
    check("1.02(0.05)", "m", 1.02, Some(0.05));
    check("85(5)", "kg", 85.0, Some(5.0));
    check("85(5) kg", "kg", 85.0, Some(5.0));
}

/// The mean of two independent measurements has the deviation sqrt(0.01² + 0.01²)/2 = 0.01/sqrt(2).
#[test]
fn lists_are_averaged() {
    let (mean, deviation) = read("1.02+/-0.01, 1.03+/-0.01", "m").expect("a list");
    assert!((mean - 1.025).abs() < 1e-15 && (deviation.unwrap_or(0.0) - 0.01 / 2_f64.sqrt()).abs() < 1e-16);
    let (mean, deviation) = read("0.1+/-0.01, 0.12+/-0.02, 0.11+/-0.02", "m").expect("a list");
    assert!((mean - 0.11).abs() < 1e-15 && (deviation.unwrap_or(0.0) - 0.01).abs() < 1e-16);
    check("1.5, 2.5", "m", 2.0, None);
}

#[test]
fn units_of_the_same_quantity() {
    for text in ["1.02 m", "1.02 [m]", "1.02[m]", "102 cm", "1020 mm", "0.00102 km"] {
        check(text, "m", 1.02, None);
    }
    for text in ["9.81 N/kg", "9.81 m/s^2", "9.81 m/s/s", "9.81 [m/s²]", "9.81 m s^-2", "981 cm/s**2"] {
        check(text, "N/kg", 9.81, None);
    }
    for text in ["9.2 kg m^2", "9.2 kg*m^2", "9.2 kg m²", "9.2 [kg*m**2]", "9.2 kg·m2", "9.2 kgm^2"] {
        check(text, "kg*m^2", 9.2, None);
    }
    check("20 km/h", "m/s", 20.0 / 3.6, None);
    check("10 mph", "m/s", 4.4704, None);
    check("6 N*m*s", "N*m*s/rad", 6.0, None);
    check("6 Nm/rad", "N*m", 6.0, None);
    for text in ["27 deg", "27°", "27 degrees", "27 [deg]", "radians(27)", "27*pi/180"] {
        check(text, "rad", 27.0 * std::f64::consts::PI / 180.0, None);
    }
    // The definitions of the international yard and pound, and the figures of NIST SP 811 for what follows from them.
    for (text, unit, value) in [
        ("40 in", "m", 1.016),
        ("1 inch", "m", 0.0254),
        ("3.5 ft", "m", 1.0668),
        ("1 mile", "m", 1609.344),
        ("25 lb", "kg", 11.339_809_25),
        ("16 oz", "kg", 0.453_592_37),
        ("1 lbf", "N", 4.448_221_615_260_5),
        ("1 lb", "N", 4.448_221_615_260_5),
        ("1 lbf*in", "N*m", 0.112_984_829_027_616_7),
        ("1 in*lb", "N*m", 0.112_984_829_027_616_7),
        ("16 oz in", "N*m", 0.112_984_829_027_616_7),
        ("1 lb/in", "N/m", 4.448_221_615_260_5 / 0.0254),
        ("1 lb in", "kg*m", 0.011_521_246_198),
        ("180 deg/s", "rad/s", std::f64::consts::PI),
        ("180*deg/s", "rad/s", std::f64::consts::PI),
        ("90°/s", "rad/s", std::f64::consts::FRAC_PI_2),
        ("-2*90 degrees / s", "rad/s", -std::f64::consts::PI),
        ("18 deg/s^2", "rad/s^2", std::f64::consts::PI / 10.0),
        ("5 N m/deg", "N*m/rad", 5.0 / std::f64::consts::PI * 180.0),
        ("1 kgf", "N", 9.806_65),
        ("1 lb in^2", "kg*m^2", 2.926_396_534_292e-4),
        ("32.2 ft/s^2", "N/kg", 9.814_56),
        ("2 N/mm", "N/m", 2000.0),
        ("500 kg*cm^2", "kg*m^2", 0.05),
    ] {
        check(text, unit, value, None);
    }
    let slug = crate::quantity::number("1 slug", super::Context { unit: "kg", names: &super::no_names }).unwrap();
    assert!((slug - 14.593_90).abs() < 5e-6, "{slug}");
    check("0.4 rad", "rad", 0.4, None);
    check("0.3*cos(60 deg) m", "m", 0.3 * (std::f64::consts::PI / 3.0).cos(), None);
}

#[test]
fn units_of_another_quantity_are_refused() {
    for (text, unit, found) in [
        ("85 m", "kg", "m"),
        ("85 [kg m]", "kg", "[kg m]"),
        ("18 deg", "m", "deg"),
        ("1.02 rad", "m", "rad"),
        ("3 m", "rad", "m"),
        ("1 lb", "m", "lb"),
        ("1 lbf", "kg", "lbf"),
        ("1 furlong", "m", "furlong"),
        ("1.02 [m", "m", "[m"),
        ("1.02 m/", "m", "m/"),
        ("5 N m/deg", "N*m", "N m/deg"),
        ("5 deg/s", "1/s", "deg/s"),
        ("1 lbm*in", "N*m", "lbm*in"),
        ("1 lb", "N*m", "lb"),
        ("1 m1", "m", "m1"),
        ("1 rad", "1", "rad"),
        ("1 e-3", "m", "e-3"),
    ] {
        assert_eq!(read(text, unit), Err(format!("{text}: unit {found}")), "{text}");
    }
}

/// A unit at the end belongs to the whole value, degrees as all others: 1 deg is pi/180.
#[test]
fn units_behind_expressions() {
    let degree = std::f64::consts::PI / 180.0;
    for (text, degrees) in [
        ("1/2 deg", 0.5),
        ("1/100°", 0.01),
        ("90-72 deg", 18.0),
        ("90 deg - 72 deg", 18.0),
        ("36 deg/2", 18.0),
        ("2*9 deg", 18.0),
        ("(90 - 72) deg", 18.0),
        ("-18 deg", -18.0),
        ("18 deg - 1/2 deg", 17.5),
    ] {
        let found = read(text, "rad").map(|(value, _)| value).unwrap_or(f64::NAN);
        assert!((found - degrees * degree).abs() < 1e-15, "{text} is {found}");
    }
    let (value, deviation) = read("18 deg +/- 1/2 deg", "rad").expect("a measurement");
    assert!((value - 18.0 * degree).abs() < 1e-15);
    assert!((deviation.unwrap_or(f64::NAN) - degree / 2.0).abs() < 1e-15);
    let (value, _) = read("pi/2 - 72 deg", "rad").expect("a difference of angles");
    assert!((value - 18.0 * degree).abs() < 1e-15);
    check("1/2 m", "m", 0.5, None);
    check("100-2 cm", "m", 0.98, None);
}

#[test]
fn what_has_two_meanings_is_refused() {
    let comma = "decimals are written with a point, and a list has measurements such as `1.02+/-0.01, 1.03+/-0.01`";
    let units = "one part has a unit and the other has none: write it behind both, or `(27 +/- 1) deg`";
    let some = "of a list, each measurement has a standard deviation or none has";
    let signs = "a sign after a sign; a difference has one sign, and a standard deviation `+/-` behind the whole value";
    let mixed = "degrees and numbers without a unit are mixed; write `deg` behind each angle";
    let linear = "degrees are added, and multiplied or divided by pure numbers, but nothing else";
    for (text, expected) in [
        ("1,02", format!("1,02: {comma}")),
        ("1,02+/-0,01", format!("1,02+/-0,01: {comma}")),
        ("1.234,567", format!("1.234,567: {comma}")),
        ("1.02,", format!("1.02,: {comma}")),
        ("1.02+/-0.01, 1.03", format!("1.02+/-0.01, 1.03: {some}")),
        ("1.0+/--0.1, 1.0+/-0.1", "1.0+/--0.1, 1.0+/-0.1: a standard deviation must be >= 0".to_owned()),
        ("27 +/- 1 deg", format!("27 +/- 1 deg: {units}")),
        ("27 deg +/- 1", format!("27 deg +/- 1: {units}")),
        ("0.3-+0.1", format!("0.3-+0.1: {signs}")),
        ("(1.02+/-0.01)*2", "(1.02+/-0.01)*2: unexpected `/`".to_owned()),
        ("(1.02+-0.01)^2", format!("(1.02+-0.01)^2: {signs}")),
        ("(1.02+-0.01)+1", format!("(1.02+-0.01)+1: {signs}")),
        ("1+-2+-3", format!("deviation 2+-3: {signs}")),
        ("1 +/- 2 +/- 3", "deviation 2 +/- 3: unexpected `/`".to_owned()),
        ("0.020(3)+1", "0.020(3)+1: unexpected `(`".to_owned()),
        ("1.020(3)^2", "1.020(3)^2: unexpected `(`".to_owned()),
        ("18(1) deg + 3 deg", "18(1) deg + 3 deg: unexpected `(`".to_owned()),
        ("18.5 deg - 0.5", format!("18.5 deg - 0.5: {mixed}")),
        ("90 - 72 deg - 3 deg", format!("90 - 72 deg - 3 deg: {mixed}")),
        ("0.3 + atan(1) - 5 deg", format!("0.3 + atan(1) - 5 deg: {mixed}")),
        ("90 - (72 deg)", format!("90 - (72 deg): {mixed}")),
        ("1/(2 deg)", format!("1/(2 deg): {linear}")),
        ("(18 deg)^2", format!("(18 deg)^2: {linear}")),
        ("36 deg/2 deg", format!("36 deg/2 deg: {linear}")),
        ("3 deg/s", "3 deg/s: `s` is not known".to_owned()),
        ("5 +/- 10 %", "deviation 10 %: unexpected `%`".to_owned()),
        ("+/-5", ": a value is missing at the end".to_owned()),
        ("5+/-", "deviation : a value is missing at the end".to_owned()),
        ("2*1.020(3)", "2*1.020(3): unexpected `(`".to_owned()),
        ("0.1–0.2", "0.1–0.2: unexpected `–`".to_owned()),
        ("2 pi", "2 pi: unexpected `p`".to_owned()),
        ("1 2", "1 2: unexpected `2`".to_owned()),
        ("1/0", "1/0: the value is not finite".to_owned()),
        ("1e999", "1e999: the value is not finite".to_owned()),
        ("sqrt(-1)", "sqrt(-1): the value is not finite".to_owned()),
        ("1e-330 cm", "1e-330 cm: the value is too small to tell from zero".to_owned()),
    ] {
        assert_eq!(read(text, "rad"), Err(expected), "{text}");
    }
}

#[test]
fn names_and_typeset_signs() {
    check("2*IRxx", "kg*m^2", 0.12, None);
    check("−0.9", "m", -0.9, None);
    check("1e−3 +/− 1", "m", 0.001, Some(1.0));
    assert!(read("2*IRzz", "kg*m^2").is_err());
}

/// What `show` prints is read again.
#[test]
fn texts_read_back() {
    let names: &Lookup = &|_| Some(Ok(0.06));
    let written = |text: &str| {
        let part = |part: Part| part.written;
        measured(text, Context { unit: "m", names }).map(|found| (part(found.mean), found.deviation.map(part)))
    };
    let plain = |mean: &str, deviation: &str| Ok((mean.to_owned(), Some(deviation.to_owned())));
    assert_eq!(written(" 1.020 +/- 0.010 "), plain("1.020", "0.010"));
    assert_eq!(written("1.020(3)"), plain("1.020", "3e-3"));
    // Beside a unit, a number without one would be refused.
    assert_eq!(written("2*IRxx +/- 1 mm"), plain("0.12", "0.001"));
    assert_eq!(written("−0.9"), Ok(("-0.9".to_owned(), None)));
}

#[test]
fn a_deviation_is_refused_where_it_has_no_place() {
    let refused = |text: &str| number(text, Context { unit: "m", names: &no_names }).is_err();
    assert!(["85+-5", "85+/-5", "85±5", "1.02(3)", "(1+/-2)e-3"].into_iter().all(refused));
    assert_eq!(number("17/2", Context { unit: "m", names: &no_names }), Ok(8.5));
}

/// The derivatives of calculus, at x = 0.7.
#[test]
fn expressions_have_their_derivatives() {
    let x = 0.7_f64;
    for (text, unit, expected) in [
        ("sin(x)*cos(x)", "1", (2.0 * x).cos()),
        ("x^3/2 - 4*x", "1", 1.5 * x * x - 4.0),
        ("1/x", "1", -1.0 / (x * x)),
        ("2^x", "1", 2f64.powf(x) * 2f64.ln()),
        ("x**x", "1", x.powf(x) * (x.ln() + 1.0)),
        ("hypot(x, 1)", "1", x / 1f64.hypot(x)),
        ("atan2(x, 2)", "rad", 2.0 / (4.0 + x * x)),
        ("pow(x, 3)", "1", 3.0 * x * x),
        ("exp(-x)", "1", -(-x).exp()),
        ("abs(-x)", "1", 1.0),
        ("degrees(x)", "1", 180.0 / std::f64::consts::PI),
        ("radians(x)", "rad", std::f64::consts::PI / 180.0),
        ("tan(x) + sqrt(x)", "1", 1.0 / x.cos().powi(2) + 0.5 / x.sqrt()),
        ("asin(x)", "1", 1.0 / (1.0 - x * x).sqrt()),
        ("acos(x)", "1", -1.0 / (1.0 - x * x).sqrt()),
        ("atan(x)", "1", 1.0 / (1.0 + x * x)),
        ("x*10 cm", "m", 0.1),
        ("x*10 deg", "rad", std::f64::consts::PI / 18.0),
    ] {
        let names = |name: &str| (name == "x").then_some(Ok(crate::Dual { value: x, slope: 1.0 }));
        let found = super::differentiated(text, unit, &names).unwrap_or_else(|_| panic!("{text}"));
        assert!((found.slope - expected).abs() <= 4e-16 * expected.abs().max(1.0), "{text}: {found:?}, {expected}");
        let plain: &Lookup = &|name| (name == "x").then_some(Ok(x));
        assert_eq!(Ok(found.value), number(text, Context { unit, names: plain }), "{text}");
    }
}
