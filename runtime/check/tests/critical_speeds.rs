//! Critical speeds that are far from the right ones, or written wrongly: those of the benchmark bicycle are 4.292 and 6.024 m/s (Meijaard,
//! Papadopoulos, Ruina & Schwab 2007, section 5).

mod benchmark;

use benchmark::{causes, checked};

#[test]
fn one_digit_tells_nothing_of_two_causes() {
    let report = checked("critical_speeds = { weave = 0.01 }");
    assert!(causes(&report).is_empty(), "{report}");
    assert!(report.to_string().contains("too few digits to tell of two together"), "{report}");
}

#[test]
fn a_decimal_point_is_likelier_than_a_value_that_nobody_would_write() {
    let report = checked("critical_speeds = { weave = 42.92, capsize = 6.024 }");
    let expected = "weave speed has its decimal point one place too far to the right";
    assert_eq!(causes(&report).first().map(String::as_str), Some(expected), "{report}");
}

/// Critical speeds of three coordinates take long: what a check leaves is told, and nothing is left where two coordinates are given.
#[test]
fn a_search_that_stops_short_says_so() {
    let report = checked("model = \"CarTrailer\"\ncritical_speeds = { weave = 31.2345678 }");
    assert!(causes(&report).is_empty() && report.stopped_short, "{report}");
    let text = report.to_string();
    assert!(text.contains("The search stopped short") && !text.contains("no two of them together"), "{report}");
    let report = checked("model = \"TwoPipes\"\ncritical_speeds = { weave = 31.2345678 }");
    assert!(!report.stopped_short && !report.to_string().contains("stopped short"), "{report}");
}

/// Without a spring or a damper critical speeds are proportional to the root of g.
#[test]
fn another_g_is_told_of_both_speeds() {
    let root = (9.80665_f64 / 9.81).sqrt();
    let [weave, capsize] = [4.292_382_536_341_103, 6.024_262_015_388_358].map(|speed: f64| root * speed);
    let report = checked(&format!("critical_speeds = {{ weave = {weave:.8}, capsize = {capsize:.8} }}"));
    let first = causes(&report).remove(0);
    assert!(first.starts_with("g is 9.80665 N/kg"), "{report}");
}
