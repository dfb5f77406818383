//! What a file says twice, in whatever names: by definition the trail is (rF sin λ - offset)/cos λ, the head angle 90° - λ, and a
//! diameter two radii.

use crate::Directory;

/// Manufacturers' names, of which a trail of 59.7025 mm follows; with all else of the benchmark.
const PRINTED: &str = "wheelbase = 1012 mm\nhead_angle = 72.5 deg\nfork_offset = 45 mm\nrear_wheel = 28-622\n\
                       front_wheel = 28-622\n";

/// The benchmark's parameters but for those that others say, and other lines.
fn file(directory: &Directory, others: &str, without: &[&str]) -> crate::Run {
    let is_left = |line: &&str| !without.iter().any(|name| line.starts_with(&format!("{name} ")));
    let own = crate::BENCHMARK.lines().skip_while(|line| *line != "[parameters]").skip(1).filter(is_left);
    let own: String = own.map(|line| format!("{line}\n")).collect();
    directory.write("g.txt", format!("{others}{own}")).run(&["show", "g.txt"])
}

/// To their digits the same, off by as much as the trails of tyres are, or a mistake: by one rule in all files, and said each time.
#[test]
fn what_is_said_twice_is_judged_alike_everywhere() {
    let directory = Directory::of_this_test();
    let printed = |line: &str| file(&directory, &format!("{PRINTED}{line}\n"), &["w", "c", "lam", "rR", "rF", "g"]);
    let paper = |line: &str| file(&directory, &format!("{line}\n"), &[]);
    let follows = "follows from `head_angle`, `fork_offset`, `front_wheel`";
    let of_offset = "`head_angle`, `fork_offset`, `front_wheel` say";
    for (run, note) in [
        (printed("trail = 59.7 mm"), format!("`trail` says what {of_offset}, too")),
        (printed("c = 0.0597"), format!("`c` says what {of_offset}, too")),
        (printed("lam = 17.5 deg"), "`lam` says what `head_angle` says, too".to_owned()),
        (printed("rR = 339 mm"), "`rR` says what `rear_wheel` says, too".to_owned()),
        (printed("rake = 45 mm"), "`rake` says what `fork_offset` says, too".to_owned()),
        (
            printed("trail = 60.5 mm"),
            format!("`trail` is 0.0605 m, but 0.0597025 m {follows}, 0.8 mm off; `trail` is not used"),
        ),
        (
            printed("trail = 62 mm"),
            format!("`trail` is 0.062 m, but 0.0597025 m {follows}, 2.3 mm off; `trail` is not used"),
        ),
        (printed("c = 0.055"), format!("`c` is 0.055 m, but 0.0597025 m {follows}, 4.7 mm off; `c` is not used")),
        // Another name of what is not used is held against what is: (rF sin 17.5 deg - 45 mm)/cos 17.5 deg.
        (printed("trail = 61 mm\nc = 0.0597"), format!("`c` says what {of_offset}, too")),
        (
            printed("trail = 61 mm\nc = 0.061"),
            format!("`c` is 0.061 m, but 0.0597025 m {follows}, 1.3 mm off; `c` is not used"),
        ),
        (paper("lambda = 18 deg"), "`lambda` says what the parameters of Whipple say, too".to_owned()),
        (
            paper("rear_wheel_circumference = 1.885"),
            "`rear_wheel_circumference` says what the parameters of Whipple".to_owned(),
        ),
        (
            paper("trail = 78 mm"),
            "`trail` is 0.078 m, but 0.08 m follows from `c`, 2.0 mm off; `trail` is not used".to_owned(),
        ),
        (
            paper("rake = 30 mm"),
            "`rake` is 0.03 m, but 0.0320714 m follows from `c`, `lam`, `rF`, 2.1 mm off; `rake` is not used"
                .to_owned(),
        ),
    ] {
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        assert!(run.stderr.contains(&format!("note: g.txt: {note}")), "{note}: {}", run.stderr);
    }
    for (run, line, message) in [
        (printed("trail = 70 mm"), 6, format!("`trail` is 0.07 m, but 0.0597025 m {follows}")),
        (
            printed("lam = 19 deg"),
            6,
            "`lam` is 0.3316125578789226 rad, but 0.305433 rad follows from `head_angle`".to_owned(),
        ),
        (printed("rF = 0.35"), 6, "`rF` is 0.35 m, but 0.339 m follows from `front_wheel`".to_owned()),
        (printed("rake = 55 mm"), 6, "`rake` is 0.055 m, but 0.045 m follows from `fork_offset`".to_owned()),
        (paper("trail = 70 mm"), 1, "`trail` is 0.07 m, but 0.08 m follows from `c`".to_owned()),
        (
            paper("lambda = 19 deg"),
            1,
            "`lambda` is 0.3316125578789226 rad, but 0.314159 rad follows from `lam`".to_owned(),
        ),
        (paper("rear_wheel = 28-622"), 1, "`rear_wheel` is 0.678 m, but 0.6 m follows from `rR`".to_owned()),
        (paper("wheel = 28-622"), 1, "`wheel` is 0.678 m, but 0.6 m follows from `rR`".to_owned()),
    ] {
        run.fails(2, &format!("error: g.txt:{line}: {message}; leave one of them out\n"));
    }
}

/// The bottom bracket's lengths of a triangle with the sides 9, 40 and 41, and of the rest of a wheel base of 1.02 m; the wheels of
/// the benchmark differ by 5 cm in radius.
#[test]
fn several_lengths_say_a_wheel_base_together() {
    let directory = Directory::of_this_test();
    let of =
        |chainstay: &str| format!("chainstay = {chainstay}\nbb_drop = 90 mm\nfront_center = sqrt(0.62^2 + 0.14^2)\n");
    let run = file(&directory, &of("410 mm"), &[]);
    assert!(
        run.stderr.contains("note: g.txt: `chainstay` says what the parameters of Whipple say, too\n"),
        "{}",
        run.stderr
    );
    // sqrt(0.417^2 - 0.09^2) + 0.62 = 1.0271717
    let message = "`w` is 1.02 m, but 1.02717 m follows from `rR`, `rF`, `chainstay`, `bb_drop`, `front_center`";
    file(&directory, &of("417 mm"), &[]).fails(2, &format!("error: g.txt:1: {message}; leave one of them out\n"));
    let printed = format!("{PRINTED}chainstay = 410 mm\n");
    let in_geometry = file(&directory, &printed, &["w", "c", "lam", "rR", "rF", "g"]);
    assert!(in_geometry.stderr.contains("note: g.txt: `chainstay` tells nothing: "), "{}", in_geometry.stderr);
    let run = file(&directory, "chainstay = 410 mm\n", &[]);
    let note = "note: g.txt: `chainstay` tells nothing: `wheelbase` follows only with `front_center`, `bb_drop`\n";
    assert!(run.code == Some(0) && run.stderr.contains(note), "{}", run.stderr);
}

/// Moore's d1 = cos λ (w + c - rR tan λ) is 0.953457 m of the benchmark, and the wheels' centres are, along the steer axis,
/// w sin λ + (rR - rF) cos λ = 0.267645 m apart.
#[test]
fn names_of_others_are_told_beside_those_of_the_paper() {
    let directory = Directory::of_this_test();
    for (line, note) in [
        ("d1 = 0.9535", "`d1` says what the parameters of Whipple say, too"),
        (
            "d1 = 0.9",
            "`d1` is 0.9 m, but 0.953457 m follows from `w`, `c`, `lam`, `rR`; it is a name of moore (the names of Moore (2012)), \
             and not used",
        ),
        (
            "ls = 0.3",
            "`ls` is 0.3 m, but 0.267645 m follows from `w`, `lam`, `rR`, `rF`; it is a name of gyrostats (two gyrostats), and \
             not used",
        ),
        ("d1 = here", "no parameters of Whipple, and not used: `d1`"),
    ] {
        let run = file(&directory, &format!("{line}\n"), &[]);
        assert!(run.code == Some(0) && run.stderr.contains(&format!("note: g.txt: {note}\n")), "{}", run.stderr);
    }
}

/// A fork offset of 45 m would be a trail of (0.35 sin 18° - 45)/cos 18° = -47.2 m.
#[test]
fn what_is_too_large_is_called_as_it_was_given() {
    let directory = Directory::of_this_test();
    let of_offset = |name: &str| {
        format!(
            "`{name}`: with 45 `c` is -47.2 m, too large for a bicycle, and ordinary in mm; write that unit behind it, as in `45 mm`"
        )
    };
    let itself = |name: &str| {
        format!("`{name}` is too large for a bicycle, and ordinary in mm; write that unit behind it, as in `80 mm`")
    };
    for (setting, warning) in [
        ("fork_offset=45", of_offset("fork_offset")),
        ("rake=45", of_offset("rake")),
        ("trail=80", itself("trail")),
        ("c=80", itself("c")),
    ] {
        let run = directory.run(&["show", "--set", setting]);
        let warnings: Vec<&str> = run.stderr.lines().filter(|line| line.starts_with("warning")).collect();
        assert_eq!(warnings, [format!("warning: benchmark: {warning}")], "{setting}");
    }
}

/// Names that say which convention is meant only together, or not even then.
#[test]
fn settings_that_are_of_several_conventions_say_so() {
    let directory = Directory::of_this_test();
    let fails = |settings: &[&str], messages: &[&str]| {
        let set: Vec<&str> = settings.iter().flat_map(|setting| ["--set", setting]).collect();
        let head = if messages.len() > 1 { format!("{} problems\n", messages.len()) } else { String::new() };
        directory.run(&[&["show"], &set[..]].concat()).fails(2, &format!("error: {head}{}\n", messages.join("\n")));
    };
    fails(
        &["d1=0.9", "htangle=1.2"],
        &[
            "--set d1=0.9: `d1` is a name of moore (the names of Moore (2012)), and `htangle` of others; all must be of one convention",
            "--set htangle=1.2: `htangle` is a name of pydy (the names of PyDy's bicycle), and `d1` of others; all must be of one \
             convention",
        ],
    );
    fails(&["d1=0.9", "foo=1"], &["--set foo=1: `foo` is not a parameter of Whipple"]);
    let crown = "`front.r` is always 0: wheels are edged here, and a crown is not part of the model";
    fails(&["front.r=0"], &[&format!("--set front.r=0: {crown}")]);
    fails(&["w=1", "wheelbase=1"], &["--set wheelbase=1: `wheelbase` is given twice; first as `w` at --set w=1"]);
    // Both gyrostats' conventions have it, and mean the same: the wheel base stays, as lr, ls and lf do with it.
    let show = |settings: &[&str]| directory.run(&[&["show"], settings].concat()).stdout;
    let own = show(&["--set", "ls=0.3"]);
    assert!(own.contains("lam = ") && own == show(&["--set", "ls=0.3", "--set", "lr=0.9534570696121847"]), "{own}");
}

/// What manufacturers print, beside the names of others: of the benchmark the trail is 0.08 m, the head angle 72 degrees, the fork offset
/// rF sin λ - c cos λ = 0.0320714 m, and a tyre of 28-622 is 0.678 m high.
#[test]
fn printed_names_are_held_against_those_of_others() {
    let directory = Directory::of_this_test();
    for (convention, radius) in [("moore", "rr"), ("pydy", "WRrad"), ("gyrostats", "rr"), ("principal", "rR")] {
        let written = directory.run(&["convert", "benchmark", "--to", convention, "--format", "text"]).stdout;
        let with = |line: &str| directory.write("a.txt", format!("{written}{line}\n")).run(&["analyze", "a.txt"]);
        for line in [
            "trail = 80 mm",
            "head_angle = 72 deg",
            "fork_offset = 0.0320714",
            "wheelbase = 1.02",
            "rear_wheel_diameter = 0.6",
        ] {
            let (run, name) = (with(line), line.split(' ').next().unwrap());
            assert!(
                run.code == Some(0) && run.stderr.contains(&format!("note: a.txt: `{name}` says what ")),
                "{}",
                run.stderr
            );
            assert!(!run.stderr.contains("not used"), "{}", run.stderr);
        }
        let near = with("fork_offset = 35 mm");
        let note = "`fork_offset` is 0.035 m, but 0.0320714 m follows from ";
        assert!(near.code == Some(0) && near.stderr.contains(note), "{}", near.stderr);
        let line = written.lines().count() + 1;
        let size = format!("`rear_wheel` is 0.678 m, but 0.6 m follows from `{radius}`");
        with("rear_wheel = 28-622").fails(2, &format!("error: a.txt:{line}: {size}; leave one of them out\n"));
        let other = with("trail = 70 mm");
        let message = format!("error: a.txt:{line}: `trail` is 0.07 m, but 0.08 m follows from ");
        assert!(other.code == Some(2) && other.stderr.starts_with(&message), "{}", other.stderr);
    }
}

/// A tyre beside a diameter is told as it stands in the file.
#[test]
fn sizes_of_tyres_are_called_as_they_are_written() {
    let directory = Directory::of_this_test();
    let lines = format!("{PRINTED}rear_wheel_diameter = 700 mm\n");
    let message = "`rear_wheel_diameter` is 0.7 m, but 0.678 m follows from `rear_wheel`; leave one of them out";
    file(&directory, &lines, &["w", "c", "lam", "rR", "rF", "g"]).fails(2, &format!("error: g.txt:6: {message}\n"));
}
