//! That a sweep goes on after a kill, and never replaces what it should not.

use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};

use twox_hash::XxHash64;

use crate::Directory;

/// Twelve times as many designs as samples, a twelfth of them with errors.
const LONG: [&str; 7] = ["sweep", "--model", "DoublePendulum", "--vary", "m1=-1:10:1", "--random", "l1=1+-0.1"];

/// Runs the sweep with one thread.
fn run(directory: &Directory, samples: u32, output: &str) {
    let count = samples.to_string();
    let arguments = [&LONG[..], &["--samples", &count, "--output", output]].concat();
    let output = directory.command(&arguments).env("RAYON_NUM_THREADS", "1").output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{stderr}");
    assert!(stderr.contains(&format!("note: {samples} of {} designs have no results", 12 * samples)), "{stderr}");
}

fn lines(path: &Path) -> usize {
    std::fs::read_to_string(path).map_or(0, |text| text.lines().count())
}

/// Runs the sweep, and kills it again and again as soon as it got on, a little later each time.
fn with_kills(directory: &Directory, samples: u32, output: &str) {
    let samples = samples.to_string();
    let arguments = [&LONG[..], &["--samples", &samples, "--output", output]].concat();
    let (path, journal) = (directory.0.join(output), directory.0.join(format!("{output}.journal")));
    let mut kills = 0;
    while !path.exists() {
        let mut command = directory.command(&arguments);
        command.env("RAYON_NUM_THREADS", "1").stdout(Stdio::null()).stderr(Stdio::null());
        let before = lines(&journal);
        let mut child = command.spawn().unwrap();
        while lines(&journal) <= before.max(1) && child.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(2));
        }
        std::thread::sleep(Duration::from_millis(37 * kills % 101));
        child.kill().unwrap();
        if !child.wait().unwrap().success() {
            kills += 1;
        }
    }
    assert!(kills >= 2, "{output} was killed {kills} times");
    // Killed after the file had its name, but before the journal was gone.
    if journal.exists() {
        assert_eq!(directory.run(&arguments).code, Some(0));
    }
}

#[test]
fn a_sweep_goes_on_after_kills_with_the_same_bytes() {
    let directory = Directory::new("sweep-kills");
    // Long enough for several kills, however fast the machine is and however busy.
    let started = Instant::now();
    run(&directory, 350, "short.csv");
    let samples = (350.0 * 2.0 / started.elapsed().as_secs_f64()).clamp(1100.0, 40_000.0) as u32;
    for format in ["csv", "parquet"] {
        let (whole, killed) = (format!("whole.{format}"), format!("killed.{format}"));
        run(&directory, samples, &whole);
        with_kills(&directory, samples, &killed);
        let bytes = |name: &str| std::fs::read(directory.0.join(name)).unwrap();
        assert!(bytes(&killed) == bytes(&whole), "{killed} differs");
    }
    assert_eq!(std::fs::read_dir(&directory.0).unwrap().count(), 5);
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let directory = Directory::new("sweep-threads");
    for format in ["csv", "parquet"] {
        let files = ["1", "2", "3"].map(|threads| {
            let output = format!("threads-{threads}.{format}");
            let mut command = directory.command(&[&LONG[..], &["--samples", "700", "--output", &output]].concat());
            assert!(command.env("RAYON_NUM_THREADS", threads).output().unwrap().status.success());
            std::fs::read(directory.0.join(output)).unwrap()
        });
        assert!(files[0] == files[1] && files[0] == files[2], "{format}");
    }
}

#[test]
fn a_finished_file_is_replaced_only_when_asked_for() {
    let directory = Directory::new("sweep-finished");
    for (file, precious) in [
        ("table.csv", "precious\n"),
        ("table.csv", "name,error,price\na,,3\n"),
        ("table.parquet", "precious\n"),
        ("table.csv", ""),
    ] {
        directory.write(file, precious);
        let sweep = |vary: &str, more: &[&str]| {
            directory.run(&[&["sweep", "--vary", vary, "--output", file][..], more].concat())
        };
        let is_there = format!("error: --output {file}: the file exists already");
        if !precious.is_empty() {
            sweep("w=1,1.1", &[]).fails(2, &format!("{is_there}\n"));
            let message = format!("error: --output {file}: the file is no result of a sweep, and is not replaced\n");
            sweep("w=1,1.1", &["--restart"]).fails(2, &message);
            assert_eq!(std::fs::read_to_string(directory.0.join(file)).unwrap(), precious);
            assert!(!directory.0.join(format!("{file}.journal")).exists());
            std::fs::remove_file(directory.0.join(file)).unwrap();
        }
        assert_eq!(sweep("w=1,1.1", &[]).code, if precious.is_empty() { Some(2) } else { Some(0) });
        assert_eq!(sweep("w=1,1.1", &["--restart"]).code, Some(0));
        sweep("c=0,0.1", &[]).fails(2, &format!("{is_there}; --restart replaces it\n"));
        assert_eq!(sweep("c=0,0.1", &["--restart"]).code, Some(0));
    }
    let text = std::fs::read_to_string(directory.0.join("table.csv")).unwrap();
    assert!(text.starts_with("c,weave_count,weave_1,"), "{text}");
}

/// What a kill leaves behind, told apart by what it belongs to; and broken in ways that a crash may break it.
#[test]
fn a_journal_is_trusted_only_as_far_as_it_goes() {
    let directory = Directory::new("sweep-journal");
    let sweep = |vary: &str, more: &[&str]| {
        directory.run(&[&["sweep", "--vary", vary, "--output", "table.csv"], more].concat())
    };
    assert_eq!(sweep("w=1:1.4:0.1", &[]).code, Some(0));
    let path = |ending: &str| directory.0.join(format!("table.csv{ending}"));
    let whole = std::fs::read(path("")).unwrap();

    // Begun by another command.
    let journal = "carvallo sweep 0123456789abcdef\n0 10 0\n3 500 1\n";
    std::fs::rename(path(""), path(".partial")).unwrap();
    std::fs::write(path(".journal"), journal).unwrap();
    let message = "error: --output table.csv: table.csv.journal is of another sweep, of which 3 designs are done; \
                   --restart drops it\n";
    sweep("w=1:1.4:0.1", &[]).fails(2, message);
    assert_eq!(std::fs::read_to_string(path(".journal")).unwrap(), journal);
    assert_eq!(sweep("w=1:1.4:0.1", &["--restart"]).code, Some(0));
    assert_eq!(std::fs::read(path("")).unwrap(), whole);
    std::fs::remove_file(path("")).unwrap();

    // Begun by this one, with more in the file than in the journal, with half a line, and with less.
    let definition = definition(&directory);
    let header = whole.iter().position(|&byte| byte == b'\n').unwrap() + 1;
    let (begun, done) = (format!("0 {header} 0"), format!("5 {} 0", whole.len()));
    for (partial, lines, more) in [
        ([&whole[..header], b"1.0,gar"].concat(), vec![begun.as_str()], ""),
        (whole[..header].to_vec(), vec![&begun], "5 3"),
        (whole[..header - 3].to_vec(), vec![&begun], ""),
        (Vec::new(), vec![], ""),
        (whole.clone(), vec![&begun, &done, "finished 1 2"], ""),
    ] {
        std::fs::write(path(".partial"), partial).unwrap();
        std::fs::write(path(".journal"), self::journal(&definition, &lines) + more).unwrap();
        let run = sweep("w=1:1.4:0.1", &[]);
        assert_eq!(run.code, Some(0), "{lines:?}: {}", run.stderr);
        assert_eq!(std::fs::read(path("")).unwrap(), whole, "{lines:?}");
        assert!(!path(".journal").exists() && !path(".partial").exists());
        std::fs::remove_file(path("")).unwrap();
    }
    // Killed when the file had its name already.
    std::fs::write(path(""), &whole).unwrap();
    let modified = std::fs::metadata(path("")).unwrap().modified().unwrap();
    let modified = modified.duration_since(std::time::UNIX_EPOCH).unwrap().as_nanos();
    let finished = format!("finished {} {modified}", whole.len());
    std::fs::write(path(".journal"), self::journal(&definition, &[&begun, &done, &finished])).unwrap();
    assert_eq!(sweep("w=1:1.4:0.1", &[]).code, Some(0));
    assert_eq!(std::fs::read(path("")).unwrap(), whole);
    assert!(!path(".journal").exists());
    // The file is an older one, as long, and what was computed is gone.
    let foreign = format!("finished {} {}", whole.len(), modified - 1);
    for lines in [vec![begun.as_str(), &done, &foreign], vec![&begun, &done], vec![]] {
        std::fs::write(path(".journal"), self::journal(&definition, &lines)).unwrap();
        let message =
            "table.csv.journal tells of another file, and table.csv.partial is missing; --restart begins anew";
        sweep("w=1:1.4:0.1", &[]).fails(2, &format!("error: --output table.csv: {message}\n"));
    }
    assert_eq!(sweep("w=1:1.4:0.1", &["--restart"]).code, Some(0));
    std::fs::remove_file(path("")).unwrap();

    // A digit that changed, a line that is there twice, and one that is no line.
    let good = self::journal(&definition, &[&begun, &done]);
    let last = good.lines().last().unwrap();
    let changed = good.replace(&format!("5 {} 0", whole.len()), &format!("5 {} 0", whole.len() - 10));
    for (journal, line) in [(changed, 3), (format!("{good}{last}\n"), 4), (format!("{good}\n"), 4)] {
        std::fs::write(path(".partial"), &whole).unwrap();
        std::fs::write(path(".journal"), &journal).unwrap();
        let message = format!("table.csv.journal:{line} is not as it was written; --restart begins anew");
        sweep("w=1:1.4:0.1", &[]).fails(2, &format!("error: --output table.csv: {message}\n"));
        assert_eq!(std::fs::read_to_string(path(".journal")).unwrap(), journal);
    }
    assert_eq!(sweep("w=1:1.4:0.1", &["--restart"]).code, Some(0));
    assert_eq!(std::fs::read(path("")).unwrap(), whole);
}

/// A journal with these lines below the first one, each with its checksum.
fn journal(definition: &str, lines: &[&str]) -> String {
    let mut text = format!("{definition}\n");
    let mut checksum = u64::from_str_radix(definition.split(' ').next_back().unwrap(), 16).unwrap();
    for line in lines {
        checksum = XxHash64::oneshot(checksum, line.as_bytes());
        text.push_str(&format!("{line} {checksum:016x}\n"));
    }
    text
}

/// The first line of the journal of `w=1:1.4:0.1`: what a sweep leaves behind that cannot begin its file.
fn definition(directory: &Directory) -> String {
    std::fs::create_dir(directory.0.join("table.csv.partial")).unwrap();
    let run = directory.run(&["sweep", "--vary", "w=1:1.4:0.1", "--output", "table.csv"]);
    assert_eq!(run.code, Some(1), "{}", run.stderr);
    let journal = std::fs::read_to_string(directory.0.join("table.csv.journal")).unwrap();
    std::fs::remove_dir(directory.0.join("table.csv.partial")).unwrap();
    journal.lines().next().unwrap().to_owned()
}
