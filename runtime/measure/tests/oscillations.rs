//! Recorded oscillations, against what SciPy's `curve_fit` makes of them, polished in extended precision: `oscillations.py` wrote
//! `data/oscillations`.

use std::path::{Path, PathBuf};

use carvallo_measure::oscillation::{FitError, Oscillation, fit};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/oscillations")
}

fn numbers(text: &str, separator: char) -> Vec<f64> {
    text.split(separator).map(|cell| cell.parse().unwrap()).collect()
}

/// Times and values; those of a file without times are 20 a second.
fn signal(name: &str) -> (Vec<f64>, Vec<f64>) {
    let text = std::fs::read_to_string(folder().join(format!("{name}.csv"))).unwrap();
    let row = |(at, line): (usize, &str)| match numbers(line, ',')[..] {
        [value] => (at as f64 / 20.0, value),
        [time, value] => (time, value),
        _ => panic!("{line}"),
    };
    text.lines().enumerate().map(row).unzip()
}

#[test]
fn fits_are_those_of_scipy() {
    let fits = std::fs::read_to_string(folder().join("fits.tsv")).unwrap();
    for line in fits.lines() {
        let (name, expected) = line.split_once('\t').unwrap();
        let (times, values) = signal(name);
        let Oscillation { period, deviation, decay, offset, amplitude, .. } = fit(&times, &values).unwrap();
        let found = [period, deviation, decay, offset, amplitude];
        for (found, expected) in found.into_iter().zip(numbers(expected, '\t')) {
            // What is about zero is so in parts of the amplitude.
            let bound = 1e-9 * expected.abs().max(1e-2 * amplitude);
            assert!((found - expected).abs() < bound, "{name}: {found}, expected {expected}");
        }
        let [of_scipy, ..] = numbers(expected, '\t')[..] else { panic!("a period") };
        assert!((period / of_scipy - 1.0).abs() < 1e-12, "{name}: {period}, expected {of_scipy}");
    }
}

/// A zero that drifts is fitted, too, and is nothing where there is none.
#[test]
fn drifts_are_those_of_scipy() {
    let fits = std::fs::read_to_string(folder().join("drifts.tsv")).unwrap();
    for line in fits.lines() {
        let (name, expected) = line.split_once('\t').unwrap();
        let (times, values) = signal(name);
        let Oscillation { period, deviation, decay, offset, amplitude, drift, .. } = fit(&times, &values).unwrap();
        let found = [period, deviation, decay, offset, amplitude, drift];
        for (found, expected) in found.into_iter().zip(numbers(expected, '\t')) {
            // SciPy ends a few 1e-10 from the least sum.
            let bound = 1e-7 * expected.abs().max(1e-2 * amplitude);
            assert!((found - expected).abs() < bound, "{name}: {found}, expected {expected}");
        }
    }
    for name in ["gyro", "torsion", "short", "clean", "slow"] {
        let (times, values) = signal(name);
        assert_eq!(fit(&times, &values).unwrap().drift, 0.0, "{name}");
    }
}

/// Whatever the unit of the signal, its sign, and where time begins.
#[test]
fn periods_do_not_depend_on_units() {
    let (times, values) = signal("torsion");
    let plain = fit(&times, &values).unwrap();
    let later: Vec<f64> = times.iter().map(|time| time + 1e4).collect();
    let larger: Vec<f64> = values.iter().map(|value| -1e6 * value + 3e7).collect();
    let other = fit(&later, &larger).unwrap();
    assert!((other.period / plain.period - 1.0).abs() < 1e-9, "{other:?}, {plain:?}");
    assert!((other.deviation / plain.deviation - 1.0).abs() < 1e-6, "{other:?}, {plain:?}");
}

#[test]
fn what_is_no_oscillation_is_told() {
    let times: Vec<f64> = (0..100).map(f64::from).collect();
    assert_eq!(fit(&times[..5], &[0.0; 5]), Err(FitError::TooFew(5)));
    assert_eq!(fit(&times, &[1.0; 100]), Err(FitError::Constant));
    let mut values: Vec<f64> = times.iter().map(|time| time.sin()).collect();
    let mut broken = times.clone();
    broken[50] = 49.0;
    assert_eq!(fit(&broken, &values), Err(FitError::NotAscending(49.0)));
    values[7] = f64::NAN;
    assert_eq!(fit(&times, &values), Err(FitError::NotFinite(7)));
    let drift: Vec<f64> = times.iter().map(|time| 1e-3 * time * time).collect();
    assert!(fit(&times, &drift).is_err(), "{:?}", fit(&times, &drift));
}

/// Files in the place of periods, beside the file that names them.
#[test]
fn files_stand_in_the_place_of_periods() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("oscillations");
    std::fs::create_dir_all(&folder).unwrap();
    let example = carvallo_measure::EXAMPLE;
    let line = example.lines().find(|line| line.trim_start().starts_with("TtR1")).unwrap();
    let path = folder.join("mine.toml");
    let measured = |value: &str| {
        std::fs::write(&path, example.replace(line, &format!("TtR1 = {value}"))).unwrap();
        carvallo_measure::load(path.to_str().unwrap())
    };
    let data = self::folder();
    let torsion = data.join("torsion.csv").display().to_string();
    let fits = std::fs::read_to_string(data.join("fits.tsv")).unwrap();
    let of_scipy = |name: &str| {
        let line = fits.lines().find(|line| line.starts_with(name)).unwrap();
        numbers(line.split_once('\t').unwrap().1, '\t')
    };
    let radial = |design: &carvallo_design::Design| {
        let given = design.parameters[design.info().position("IRxx").unwrap()].clone();
        (given.value, given.deviation.unwrap().value)
    };
    let [period, deviation, ..] = of_scipy("torsion")[..] else { panic!("a fit") };
    let given = radial(&measured(&format!("\"{period:?}+/-{deviation:?}\"")).unwrap());
    let design = measured(&format!("'{torsion}'")).unwrap();
    let found = radial(&design);
    assert!((found.0 / given.0 - 1.0).abs() < 1e-9 && (found.1 / given.1 - 1.0).abs() < 1e-6, "{found:?}, {given:?}");
    assert!(
        design.notes.iter().any(|note| note.starts_with("`TtR1` is 1.461") && note.contains("300 samples")),
        "{:?}",
        design.notes
    );
    // Beside the file, with a header in other units and more columns; and without times.
    let (times, values) = signal("torsion");
    let rows: String =
        times.iter().zip(&values).map(|(t, y)| format!("{};0,5;{y}\n", 1e3 * t).replace('.', ",")).collect();
    std::fs::write(folder.join("more.csv"), format!("# logged\ntime (ms);other;gyro [V]\n{rows}")).unwrap();
    let beside = radial(&measured("{ file = 'more.csv', column = 'gyro' }").unwrap());
    assert!((beside.0 / given.0 - 1.0).abs() < 1e-9, "{beside:?}, {given:?}");
    for heading in ["time_ms", "t / ms", "time ms", "t [ms]"] {
        std::fs::write(folder.join("more.csv"), format!("{heading};other;gyro [V]\n{rows}")).unwrap();
        assert_eq!(radial(&measured("{ file = 'more.csv', column = 'gyro' }").unwrap()), beside, "{heading}");
    }
    // In UTF-16, as PowerShell writes it, and in Latin-1.
    let text = format!("# Räder\ntime (ms);other;gyro [V]\n{rows}");
    let utf_16: Vec<u8> = std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    let latin: Vec<u8> = text.chars().map(|sign| u8::try_from(sign).unwrap()).collect();
    for (encoding, bytes) in [("UTF-16", utf_16), ("Latin-1", latin)] {
        std::fs::write(folder.join("other.csv"), bytes).unwrap();
        assert_eq!(radial(&measured("{ file = 'other.csv', column = 'gyro' }").unwrap()), beside, "{encoding}");
    }
    std::fs::write(folder.join("long.csv"), format!("time (furlong);other;gyro [V]\n{rows}")).unwrap();
    // By its number; a rate that agrees with the times, or counts beside it, are nothing wrong.
    assert_eq!(radial(&measured("{ file = 'more.csv', column = 3 }").unwrap()), beside);
    assert_eq!(radial(&measured(&format!("{{ file = '{torsion}', column = 2 }}")).unwrap()), found);
    assert_eq!(radial(&measured(&format!("{{ file = '{torsion}', rate = 10 }}")).unwrap()), found);
    let clean = std::fs::read_to_string(data.join("clean.csv")).unwrap();
    let values = clean.lines().map(|line| line.rsplit(',').next().unwrap());
    let counted: String = values.clone().enumerate().map(|(at, y)| format!("{at},{y}\n")).collect();
    std::fs::write(folder.join("counted.csv"), counted).unwrap();
    std::fs::write(folder.join("alone.csv"), values.map(|y| format!("{y}\n")).collect::<String>()).unwrap();
    let [counted, alone] =
        ["counted", "alone"].map(|file| measured(&format!("{{ file = '{file}.csv', rate = 50 }}")).unwrap());
    assert_eq!(radial(&counted), radial(&alone));
    // The generator of Park and Miller.
    let mut state = 1_u64;
    let noise: String = (0..300)
        .map(|at| {
            state = state * 48_271 % 2_147_483_647;
            format!("{},{}\n", f64::from(at) / 20.0, state as f64 / 2_147_483_647.0)
        })
        .collect();
    std::fs::write(folder.join("noise.csv"), noise).unwrap();
    // Without the unit of its times the period is a thousand times as long, and nothing of it can be.
    std::fs::write(folder.join("unit.csv"), format!("other;more;gyro [V]\n{rows}")).unwrap();
    let said = match measured("{ file = 'unit.csv', column = 'gyro' }") {
        Ok(design) => design.warnings.join("\n"),
        Err(failure) => failure.to_string(),
    };
    assert!(said.contains("`TtR1` is 1461 s, and parts of a bicycle swing in 0.05 to 60 s"), "{said}");
    let gyro = data.join("gyro.csv").display().to_string();
    let mean = |value: &str| radial(&measured(value).unwrap()).0;
    let [period, deviation, ..] = of_scipy("gyro")[..] else { panic!("a fit") };
    let expected = mean(&format!("['{period:?}+/-{deviation:?}', '{period:?}+/-{deviation:?}']"));
    let recording = format!("{{ file = '{gyro}', rate = 20 }}");
    assert!((mean(&format!("[{recording}, {recording}]")) / expected - 1.0).abs() < 1e-9);
    for rate in ["'20 Hz'", "'0.02 kHz'", "'20Hz'"] {
        let recording = format!("{{ file = '{gyro}', rate = {rate} }}");
        assert!((mean(&format!("[{recording}, {recording}]")) / expected - 1.0).abs() < 1e-9, "{rate}");
    }
    let drifting = data.join("drift.csv").display().to_string();
    let notes = measured(&format!("'{drifting}'")).unwrap().notes;
    let drifts = std::fs::read_to_string(data.join("drifts.tsv")).unwrap();
    let of_scipy = numbers(drifts.lines().next().unwrap().split_once('\t').unwrap().1, '\t');
    let [period, .., amplitude, drift] = of_scipy[..] else { panic!("a fit") };
    let percent = format!("beside a drift of the zero by {:.2} % of the amplitude", 100.0 * drift * period / amplitude);
    assert!(notes.iter().any(|note| note.contains(&percent)), "{percent}: {notes:?}");
    for (value, message) in [
        ("'none.csv'", "there is no file "),
        ("{ file = 'long.csv', column = 'gyro' }", "`furlong` is no unit of time"),
        ("{ file = 'more.csv' }", "it has 3 columns; give that of the signal as `column`, by its name or its number"),
        ("{ file = 'more.csv', column = 'giro' }", "there is no column `giro`; there are t [ms], other, gyro [V]"),
        // 300 samples in 29.92 s.
        (
            "{ file = 'more.csv', column = 'gyro', rate = 200 }",
            "its first column, `t [ms]`, ascends by 0.100061 a sample",
        ),
        (
            &format!("{{ file = '{torsion}', rate = 100 }}"),
            "its first column ascends by 0.100061 a sample, as times in s do",
        ),
        (
            &format!("{{ file = '{torsion}', column = 3 }}"),
            "there is no column `3`: they have no names; give its number, 1 to 2",
        ),
        ("'noise.csv'", "`TtR1`: no decaying sine is in this signal"),
        (
            "{ file = 'more.csv', column = 'gyro', rate = '20 m' }",
            "`rate` is `20 m`; `m` is no unit for it: it is in 1/s",
        ),
        ("{ file = 'more.csv', column = 'gyro', rate = 0 }", "`rate` is `0`; samples a second must be more than 0"),
        ("{ file = 'more.csv', column = 'gyro', rate = 'fast' }", "`rate` is `fast`; expected a number in 1/s: "),
        (
            "{ file = 'more.csv', column = 'gyro', from = 3, to = 2 }",
            "the recording is from 3 s to 2 s; these must ascend",
        ),
        ("{ file = 'more.csv', colum = 'gyro' }", "`colum` is nothing that a recording has"),
        (&format!("'{gyro}'"), "it has no times; give the samples a second as `rate`"),
        (&format!("{{ file = '{torsion}', to = 4 }}"), "covers less than one and a half periods"),
    ] {
        let failure = measured(value).unwrap_err().to_string();
        assert!(failure.contains(message), "{value}: {failure}");
    }
}
