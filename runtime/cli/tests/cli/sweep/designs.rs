//! Which designs there are: grids, samples and files.

use super::{sweep, table};
use crate::Directory;

#[test]
fn every_combination_is_there_and_the_first_varies_slowest() {
    let table = sweep(&["--vary", "w=1:1.2:0.1", "--vary", "mB=60,80"]);
    assert_eq!(table.column("w"), [1.0, 1.0, 1.1, 1.1, 1.2, 1.2]);
    assert_eq!(table.column("mB"), [60.0, 80.0, 60.0, 80.0, 60.0, 80.0]);
    let table = sweep(&["--vary", "lam=10 deg:20 deg:3 points"]);
    for (found, degrees) in table.column("lam").iter().zip([10.0_f64, 15.0, 20.0]) {
        assert!((found - degrees.to_radians()).abs() < 1e-15);
    }
}

/// A sample depends on the seed, its parameter and its number alone.
#[test]
fn samples_are_the_same_in_every_sweep() {
    let random =
        |samples: &str, more: &[&str]| sweep(&[&["--random", "w=1..1.1", "--samples", samples][..], more].concat());
    let all = random("40", &[]).column("w");
    assert!(all.iter().all(|w| (1.0..1.1).contains(w)));
    assert_eq!(random("7", &[]).column("w"), all[..7]);
    assert_eq!(random("40", &["--random", "mB=85+-5"]).column("w"), all);
    assert_eq!(random("40", &["--seed", "0"]).column("w"), all);
    let others = random("40", &["--seed", "1"]).column("w");
    assert!(all.iter().zip(&others).all(|(a, b)| a != b));
    // Each combination has the same samples.
    let both = random("5", &["--vary", "mB=60,80"]);
    assert_eq!(both.column("mB"), [[60.0; 5], [80.0; 5]].concat());
    assert_eq!(both.column("w"), [&all[..5], &all[..5]].concat());
}

#[test]
fn designs_come_from_rows_of_csv() {
    let directory = Directory::new("sweep-csv");
    let text =
        "\u{feff}# measured\nname, lam ,mB,id\nplain,18 deg,85,7\n\"a, \"\"b\"\"\",pi/10,heavy,8\nshort,0.3\n,0.3,,9\n";
    directory.write("bikes.csv", text.replace("# measured\n", ""));
    let run = directory.run(&["sweep", "--designs", "bikes.csv", "--set", "w=1.02"]);
    assert!(run.stderr.contains("note: 3 of 4 designs have no results"), "{}", run.stderr);
    let table = table(run);
    assert_eq!(table.header[..4], ["name", "lam", "mB", "id"]);
    assert_eq!([0, 1, 3].map(|row| table.text(row, "name")), ["plain", "a, \"b\"", ""]);
    assert_eq!([0, 1, 2].map(|row| table.text(row, "id")), ["7", "8", ""]);
    assert_eq!(table.number(0, "lam"), Some(std::f64::consts::PI / 10.0));
    assert!((table.number(0, "weave_1").unwrap() - 4.292_382_536_341_11).abs() < 1e-13);
    let errors = [1, 2, 3].map(|row| table.text(row, "error"));
    assert!(errors[0].starts_with("`mB` is `heavy`; expected a number"), "{errors:?}");
    assert_eq!(errors[1], "the row has 2 fields; the header has 4");
    assert!(errors[2].starts_with("`mB` is empty; expected a number"), "{errors:?}");
}

/// The same designs as spreadsheets and pandas write them.
#[test]
fn tables_of_spreadsheets_and_of_pandas() {
    let directory = Directory::new("sweep-spreadsheets");
    let results = |text: &str| {
        directory.write("bikes.csv", text);
        let table = table(directory.run(&["sweep", "--designs", "bikes.csv"]));
        (0..2)
            .map(|row| ["w", "lam", "mB", "weave_1", "error"].map(|name| table.text(row, name).to_owned()))
            .collect::<Vec<_>>()
    };
    let expected = results("name,w,lam,mB\n\"A, b\",1.02,pi/10,85\nc,1.1,0.3,80.5\n");
    assert!(expected[0][3].starts_with("4.29238") && expected.iter().all(|row| row[4].is_empty()), "{expected:?}");
    for text in [
        "\u{feff}name;w;lam;mB\r\nA, b;1,02;pi/10;85\r\nc;1,1;0,3;80,5\r\n",
        "name\tw\tlam\tmB\nA, b\t1,02\tpi/10\t85\nc\t1.1\t0.3\t80.5\n",
        ",bike,w,lam,mB\n0,A,1.02,pi/10,85\n1,c,1.1,0.3,80.5\n",
        "name;w;lam;mB\nA;1,02+/-0,01;pi/10;85 kg\nc;1,1;0,3;80,5(2)\n",
    ] {
        assert_eq!(results(text), expected, "{text}");
    }
    directory.write("bikes.csv", "name;w\na;1.234,5\n");
    let table = table(directory.run(&["sweep", "--designs", "bikes.csv"]));
    assert!(table.text(0, "error").starts_with("`w` is `1.234,5`; expected a number"), "{}", table.text(0, "error"));
    directory.write("bikes.csv", "w,,mB\n1,2,3\n");
    directory.run(&["sweep", "--designs", "bikes.csv"]).fails(2, "error: bikes.csv: column 2 has no name\n");
}

/// `1.000` is one where decimals stand behind points, and a thousand where they stand behind commas.
#[test]
fn thousands_beside_decimals_are_refused() {
    let directory = Directory::of_this_test();
    let errors = |text: &str| {
        directory.write("bikes.csv", text);
        let table = table(directory.run(&["sweep", "--designs", "bikes.csv"]));
        (0..table.rows.len()).map(|row| table.text(row, "error").to_owned()).collect::<Vec<_>>()
    };
    let both = "decimals stand behind points and behind commas in this table";
    let refused = |text: &str, number: &str, thousands: &str| {
        format!("`w` is `{text}`; {both}: write `{number}0`, or `{thousands}` if thousands are meant")
    };
    assert_eq!(errors("w;mB\n1.020;85\n1,1;80,5\n"), [refused("1.020", "1.020", "1020"), String::new()]);
    assert_eq!(errors("w;mB\n1,020 m;80.5\n"), [refused("1,020 m", "1,020", "1020")]);
    // One sign alone separates decimals, whatever stands in columns that are copied.
    for text in [
        "w;mB\n1.020;85\n1.1;80.5\n",
        "w;mB\n1,020;85\n",
        "name;w\n1,5;1.020\n",
        "w,mB\n1.020,85\n",
        "w;c\n1.02;0,080\n",
    ] {
        assert!(errors(text).iter().all(String::is_empty), "{text}");
    }
}

/// Only before the header: a name may begin with `#`.
#[test]
fn comments_stand_before_the_header() {
    let directory = Directory::new("sweep-comments");
    directory.write("bikes.csv", "\u{feff}# one, \"two\n\n#three\nname,w\n#1,1\n# 2,1.02\n#\n");
    let table = table(directory.run(&["sweep", "--designs", "bikes.csv"]));
    assert_eq!([0, 1].map(|row| table.text(row, "name")), ["#1", "# 2"]);
    assert_eq!([0, 1].map(|row| table.text(row, "error")), ["", ""]);
    assert_eq!(table.text(2, "error"), "the row has 1 field; the header has 2");
}

#[test]
fn names_that_are_not_text_are_told() {
    let directory = Directory::new("sweep-latin");
    let rows = b"w,name\n1.02,M\xfc\x01ller\n1.02,M\xfcller\n1.02,\"M\xc3\xbcller\"\n";
    std::fs::write(directory.0.join("bikes.csv"), rows).unwrap();
    let table = table(directory.run(&["sweep", "--designs", "bikes.csv"]));
    assert_eq!([0, 1, 2].map(|row| table.text(row, "name")), ["", "Müller", "Müller"]);
    assert_eq!([0, 1, 2].map(|row| table.text(row, "error")), ["`name` is not UTF-8 text", "", ""]);
}

/// As PowerShell writes what is redirected to a file, and what spreadsheets call Unicode text.
#[test]
fn designs_are_read_in_utf_16() {
    let directory = Directory::of_this_test();
    let text = "w\tlam (°)\tname\n1.02\t18\tMüller\n1,1\t17\tb\n";
    let units = || std::iter::once(0xfeff).chain(text.encode_utf16());
    std::fs::write(directory.0.join("little.csv"), units().flat_map(u16::to_le_bytes).collect::<Vec<u8>>()).unwrap();
    std::fs::write(directory.0.join("big.csv"), units().flat_map(u16::to_be_bytes).collect::<Vec<u8>>()).unwrap();
    directory.write("plain.csv", text);
    let sweep = |file: &str| directory.run(&["sweep", "--designs", file]).stdout;
    let plain = sweep("plain.csv");
    assert!(plain.contains("Müller") && plain.lines().skip(1).all(|row| row.ends_with(',')), "{plain}");
    assert_eq!([sweep("little.csv"), sweep("big.csv")], [plain.clone(), plain]);
}

/// Also more rows than one batch has.
#[test]
fn long_files_are_read_to_their_end() {
    let directory = Directory::new("sweep-long");
    let rows: String = (0..10_000).map(|index| format!("{},{index}\n", 1.0 + f64::from(index) / 1e4)).collect();
    directory.write("long.csv", format!("l1,id\n{rows}"));
    let table = table(directory.run(&["sweep", "--model", "DoublePendulum", "--designs", "long.csv"]));
    assert_eq!(table.rows.len(), 10_000);
    for row in [0, 4095, 4096, 9999] {
        assert_eq!(table.text(row, "id"), row.to_string());
        assert_eq!(table.number(row, "l1"), Some(1.0 + row as f64 / 1e4));
    }
}

/// By definition the trail is (r sin λ - offset)/cos λ: 59.9 mm with 17°, a radius of 0.35 m and an offset of 45 mm.
#[test]
fn what_columns_say_twice_is_told() {
    let directory = Directory::of_this_test();
    directory.write("both.csv", "head_angle_deg,trail_mm,rake_mm\n73,58,45\n73,70,45\n");
    let run = directory.run(&["sweep", "--designs", "both.csv"]);
    let note = "note: both.csv: `trail` stands beside `fork_offset`, which counts; they may disagree by up to 5 mm\n";
    assert!(run.code == Some(0) && run.stderr.contains(note), "{}", run.stderr);
    let rows: Vec<&str> = run.stdout.lines().skip(1).collect();
    assert!(rows[0].ends_with(','), "{}", rows[0]);
    assert!(rows[1].contains("`trail` is 70.0 mm, but 59.9 mm with the fork offset"), "{}", rows[1]);
}
