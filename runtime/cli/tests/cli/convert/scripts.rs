//! Scripts of JBike6 as they are found.

use super::{close, converted};
use crate::Directory;

/// A script as JBike6 has them: in Latin-1, with lists of moments and parts of them, expressions and settings. The values are those of
/// a bicycle of the steer-by-wire project at Delft in its initial file of JBike6.
const SCRIPT: &str = "% JBini_City.m\n% Created \u{a9} 2015\napp_name = 'JBike6';\ngravity = 9.80665; % gravity\n\
    weave_speed_color = [0 1 0]; % green\n\t% bike name\n\tname = 'City bike';\n\twheelbase = 1.03; %meters\n\
    \tlambda =  0.2967; %radians\n\thead_angle = pi/2-lambda;\n  offset=0.044;\n\tDrearwheel = 0.6858;\n\
    \tmrearwheel = 8.5;\n\tIrearwheel =  [0.095625 0.095625  0.19125];\n\talphaIrearwheel = 0;\n\
    \tDfrontwheel =  0.6858;\n\tmfrontwheel = 1.84;\n\ttrail = (Dfrontwheel/2*sin(lambda)-offset)/cos(lambda);\n\
    \tIfrontwheel = 0.8*mfrontwheel*Dfrontwheel^2/4.*[1/2 1/2 1];\n\talphaIfrontwheel = 0;\n\tmrider = 80;\n\
    \txcmrider = 0.3;\n\tycmrider = 1.2;\n\tIrider = [10.53112887414928 2.46887112585073 12];\n\
    \talphaIrider = -0.25957305712326;\n\tmframe = 2.5;\n\
    \txcmframe = 0.4;\n\tycmframe = 0.6;\n\tIframe = [0.05857864376269, 0.34142135623731, 0.4];\n\
    \talphaIframe = 0.39269908169872;\n\tmfork = 1.5;\n\
    \tucmfork = 0;\n\tvcmfork = Dfrontwheel;\n\tIfork = mfork*(Dfrontwheel)^2/12.*[1 0.1^2 1];\n  Ifork(1:2:3)=0.096;\n\talphaIfork = lambda;\n\
    \tmbasket = 0;\n\tucmbasket = 0;\n\tvcmbasket = 0;\n\tIbasket = [0.00 0.00 0.00];\n\talphaIbasket = 0;\n\
    \tmrack = 4;\n\txcmrack = 0.4;\n\tycmrack = 0.55;\n\tIrack = [0.02 0.02 0.02];\n\talphaIrack = 0;\n";

#[test]
fn scripts_of_jbike6_are_read_as_they_are() {
    let directory = Directory::new("convert-script");
    let latin: Vec<u8> = SCRIPT.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap()).collect();
    assert!(std::str::from_utf8(&latin).is_err());
    directory.write("JBini_City.m", latin);
    let paper = converted(&directory, "JBini_City.m", "paper");
    let (sin, cos) = 0.2967_f64.sin_cos();
    let expected = [
        ("c", (0.3429 * sin - 0.044) / cos),
        ("lam", 0.2967),
        ("mB", 86.5),
        ("xB", (80.0 * 0.3 + 2.5 * 0.4 + 4.0 * 0.4) / 86.5),
        ("zB", -(80.0 * 1.2 + 2.5 * 0.6 + 4.0 * 0.55) / 86.5),
        ("IFxx", 0.8 * 1.84 * 0.6858 * 0.6858 / 8.0),
        ("zH", -0.6858 * cos),
        ("g", 9.80665),
    ];
    close(&paper, &expected.map(|(name, value)| (name.to_owned(), value)).into(), 4e-15);
    // The formulas of JBike6 for its seven bodies, at 30 digits; there steer to the left is positive.
    let json = directory.run(&["analyze", "JBini_City.m", "--format", "json"]).stdout;
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    for (name, expected) in [
        ("M", [[129.560_969_317_222_2, 1.903_392_641_121_094], [1.903_392_641_121_094, 0.153_300_561_290_598_7]]),
        ("C1", [[0.0, 37.686_356_977_648_516], [-0.540_721_349_837_340_6, 1.003_016_812_829_301_8]]),
        (
            "K0",
            [[-104.229_338_498_849_26, -1.709_965_234_811_657_3], [-1.709_965_234_811_657_3, -0.499_935_683_637_170_8]],
        ),
        ("K2", [[0.0, 97.758_506_542_423_2], [0.0, 1.724_635_288_121_681_3]]),
    ] {
        for (row, expected) in json["matrices"][name].as_array().unwrap().iter().zip(expected) {
            for (found, expected) in row.as_array().unwrap().iter().zip(expected) {
                let found = found.as_f64().unwrap();
                assert!((found - expected).abs() < 2e-14 * expected.abs().max(10.0), "{name}: {found}, not {expected}");
            }
        }
    }
    let text = directory.run(&["show", "JBini_City.m"]);
    assert!(text.stdout.starts_with("name = \"City bike\"\n"), "{}", text.stdout);
    assert!(text.stderr.contains("not used: `app_name`, `weave_speed_color`\n"), "{}", text.stderr);
}

/// A script whose comments stand behind statements, without a name that ends in `.m`.
#[test]
fn scripts_are_read_from_the_standard_input() {
    let directory = Directory::of_this_test();
    let json = ["--to", "paper", "--format", "json"];
    let whole: serde_json::Value =
        serde_json::from_str(&directory.run(&[&["convert", "benchmark"], &json[..]].concat()).ok()).unwrap();
    for convention in ["paper", "moore", "jbike6", "geometry"] {
        for format in ["matlab", "python"] {
            let script = directory.run(&["convert", "benchmark", "--to", convention, "--format", format]).stdout;
            let run = directory.run_with_input(&[&["convert", "-"], &json[..]].concat(), &script);
            assert_eq!(run.code, Some(0), "{convention} {format}: {}", run.stderr);
            let read: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
            for name in ["w", "c", "lam", "mB", "IHxz", "IFyy"] {
                let [found, value] = [&read, &whole].map(|json| json["parameters"][name].as_f64().unwrap());
                assert!(
                    (found - value).abs() <= 1e-13 * value.abs().max(1.0),
                    "{convention} {format}: {name} is {found}"
                );
            }
        }
    }
}
