//! The wheel assemblies of libbicycle.

use super::{close, converted, side};
use crate::Directory;

/// The benchmark in the newer names of Peterson's libbicycle, as its `derivation/benchmark_parameters.py` has it.
const LIBBICYCLE: [(&str, f64); 22] = [
    ("rear_Ixx", 7.684_799_791_449_106),
    ("rear_Iyy", 11.999_310_344_827_58),
    ("rear_Izz", 5.315_110_553_378_478),
    ("rear_Ixz", 4.262_158_094_617_231),
    ("rear_J", 0.12),
    ("rear_m", 87.0),
    ("rear_R", 0.3),
    ("rear_a", 0.459_905_837_685_617_5),
    ("rear_b", -0.466_941_942_235_536_3),
    ("rear_c", 0.953_457_069_612_184_7),
    ("front_Ixx", 0.433_537_975_531_100_7),
    ("front_Iyy", 0.574_685_714_285_714_2),
    ("front_Izz", 0.148_147_738_754_613_5),
    ("front_Ixz", 0.005_332_503_757_935_522),
    ("front_J", 0.28),
    ("front_m", 7.0),
    ("front_R", 0.35),
    ("front_a", -0.003_411_905_099_535_387),
    ("front_b", -0.211_401_040_016_169_9),
    ("front_c", -0.032_071_426_727_619_3),
    ("ls", 0.267_644_508_447_688_7),
    ("g", 9.81),
];

/// Written so, and read as attributes, in groups, and with the radii of crowns; the masses and radial moments of the wheels are of the
/// benchmark, since two gyrostats do not tell them.
#[test]
fn wheel_assemblies_of_libbicycle_come_out() {
    let directory = Directory::new("convert-libbicycle");
    let expected = LIBBICYCLE.map(|(name, value)| (name.to_owned(), value)).into();
    close(&converted(&directory, "benchmark", "libbicycle"), &expected, 4e-15);
    let of = |assembly: &str, separator: &str| -> String {
        let own = LIBBICYCLE.iter().filter_map(|(name, value)| Some((name.strip_prefix(assembly)?, value)));
        own.map(|(name, value)| format!("{assembly}{separator}{} = {value:?}\n", &name[1..])).collect()
    };
    let crowns = "rear.r = 0\nfront.r = 0\n";
    let [rear, front] = ["rear", "front"].map(|assembly| of(assembly, "."));
    let groups = ["rear", "front"].map(|which| of(which, ".").replace(&format!("{which}."), ""));
    let common = "ls = 0.2676445084476887\ng = 9.81\n";
    let json = LIBBICYCLE.map(|(name, value)| format!("\"{name}\": {value:?}")).join(", ");
    for (file, text) in [
        ("attributes.txt", format!("{rear}{front}{crowns}{common}")),
        ("members.txt", format!("{}{}{common}", rear.replace("rear.", "rear_."), front.replace("front.", "b.front_."))),
        ("underscores.py", format!("{}{}{common}", of("rear", "_"), of("front", "_"))),
        ("groups.toml", format!("{common}[rear]\n{}[front]\n{}", groups[0], groups[1])),
        ("whole.json", format!("{{{json}}}")),
    ] {
        directory.write(file, text);
        close(&converted(&directory, file, "libbicycle"), &expected, 4e-15);
        let older = converted(&directory, file, "gyrostats");
        close(&older, &side("gyrostats benchmark", "gyrostats"), 4e-15);
        let wheels = ["mR=2", "IRxx=0.0603", "mF=3", "IFxx=0.1405"].map(|wheel| ["--set", wheel]).concat();
        let run = directory.run(&[&["convert", file, "--to", "paper", "--format", "json"], &wheels[..]].concat());
        let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{}", run.stderr));
        for (name, value) in side("gyrostats benchmark", "paper") {
            let found = json["parameters"][&name].as_f64().unwrap();
            assert!((found - value).abs() <= 3e-14 * value.abs().max(1.0), "{file}: {name} is {found}, not {value}");
        }
    }
    // The trail of the paper is a `c`, too.
    for set in ["front_c=-0.04", "front.c=-0.04", "front_.c=-0.04"] {
        let run = directory.run(&["convert", "benchmark", "--set", set, "--to", "libbicycle", "--format", "json"]);
        let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{}", run.stderr));
        let [front, rear] = ["front_c", "rear_c"].map(|name| json["parameters"][name].as_f64().unwrap());
        assert!(
            (front + 0.04).abs() < 1e-15 && (rear - 0.953_457_069_612_184_7).abs() < 4e-15,
            "{set}: {front}, {rear}"
        );
    }
    directory.write("crown.txt", format!("{rear}{front}rear.r = 0.02\n{common}"));
    let run = directory.run(&["show", "crown.txt"]);
    assert!(run.stderr.contains("it must be 0: wheels are edged here"), "{}", run.stderr);
}
