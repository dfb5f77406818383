//! Builds crates that use `model!` all at once, with real cargo processes, an editor's check and rust-analyzer beside
//! them: none may fail, though Symbolica allows a user one thread.
//!
//! ```sh
//! cargo run -p carvallo-tools --no-default-features --bin parallel_builds
//! ```
//!
//! Every round changes a number in every model, and every program must then print what the new model gives. Where there
//! is no rust-analyzer its column says so. Builds in the folder for temporary files, and removes what it built.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Instant;

const CRATES: [usize; 3] = [2, 4, 8];
const ROUNDS: usize = 20;

/// How the crates stand to each other.
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    /// Members of one workspace, built by one cargo process with a job for each.
    Together,
    /// Each with a target folder of its own, built by a cargo process each.
    Apart,
}

fn main() -> io::Result<()> {
    let root = std::env::temp_dir().join(format!("carvallo-parallel-builds-{}", std::process::id()));
    let warm = root.join("warm");
    create(&warm, "warm", true)?;
    write_model(&warm, 1)?;
    for what in ["build", "check"] {
        assert!(start(&mut cargo(what, &warm, &warm.join("target")))?.succeeds("warming up"));
    }
    let analyzer = Command::new("rust-analyzer").arg("--version").output().is_ok_and(|out| out.status.success());

    println!("| crates | mode | rounds | failed builds | failed checks | failed analyses | seconds |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for count in CRATES {
        for mode in [Mode::Together, Mode::Apart] {
            let folder = root.join("now");
            let crates = lay_out(&folder, count, mode, &warm)?;
            let start = Instant::now();
            let mut analyzer = Analyzer { installed: analyzer, running: None, failed: 0, done: 0 };
            let (mut builds, mut checks) = (0, 0);
            for round in 1..=ROUNDS {
                let failed = run(&folder, &crates, mode, &mut analyzer, round)?;
                builds += failed.0;
                checks += failed.1;
            }
            let seconds = start.elapsed().as_secs_f64();
            let analyses = analyzer.finish();
            let mode = if mode == Mode::Together { "one workspace" } else { "a target folder each" };
            println!("| {count} | {mode} | {ROUNDS} | {builds} | {checks} | {analyses} | {seconds:.1} |");
            fs::remove_dir_all(&folder)?;
        }
    }
    fs::remove_dir_all(root)
}

/// Creates the crates, with target folders that hold everything but themselves.
fn lay_out(folder: &Path, count: usize, mode: Mode, warm: &Path) -> io::Result<Vec<PathBuf>> {
    let crates: Vec<PathBuf> = (0..count).map(|index| folder.join(format!("crate{index}"))).collect();
    for (index, path) in crates.iter().enumerate() {
        create(path, &format!("crate{index}"), mode == Mode::Apart)?;
        if mode == Mode::Apart {
            copy(&warm.join("target"), &path.join("target"))?;
        }
    }
    if mode == Mode::Together {
        fs::write(folder.join("Cargo.toml"), "[workspace]\nresolver = \"3\"\nmembers = [\"crate*\"]\n")?;
        fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))?;
        copy(&warm.join("target"), &folder.join("target"))?;
    }
    for beside in ["check", "analyzer"] {
        copy(&warm.join("target"), &folder.join(beside))?;
    }
    Ok(crates)
}

/// One round: how many of the builds failed, and of the checks.
fn run(
    folder: &Path,
    crates: &[PathBuf],
    mode: Mode,
    analyzer: &mut Analyzer,
    round: usize,
) -> io::Result<(usize, usize)> {
    for (index, path) in crates.iter().enumerate() {
        write_model(path, round * 100 + index)?;
    }
    // Beside the builds: all of a workspace, or the first of the crates that stand alone.
    let beside = if mode == Mode::Together { folder } else { &crates[0] };
    let mut builds: Vec<Process> = match mode {
        Mode::Together => {
            vec![start(cargo("build", folder, &folder.join("target")).arg(format!("-j{}", crates.len())))?]
        }
        Mode::Apart => crates
            .iter()
            .map(|path| start(&mut cargo("build", path, &path.join("target"))))
            .collect::<io::Result<_>>()?,
    };
    let check = start(&mut cargo("check", beside, &folder.join("check")))?;
    analyzer.keep_running(beside, &folder.join("analyzer"))?;

    let failed = |process: Process, what: &str| usize::from(!process.succeeds(what));
    let mut failed_builds = builds.drain(..).map(|build| failed(build, "a build")).sum();
    let failed_checks = failed(check, "a check");
    for (index, path) in crates.iter().enumerate() {
        let target = if mode == Mode::Together { folder.join("target") } else { path.join("target") };
        let program = target.join("debug").join(format!("crate{index}"));
        let printed = Command::new(&program).output().map(|out| String::from_utf8_lossy(&out.stdout).trim().to_owned());
        let expected = expected(round * 100 + index);
        if !matches!(&printed, Ok(text) if *text == expected) {
            eprintln!("{} printed {printed:?}: expected {expected}", program.display());
            failed_builds += 1;
        }
    }
    Ok((failed_builds, failed_checks))
}

/// A crate with a model in it.
fn create(path: &Path, name: &str, alone: bool) -> io::Result<()> {
    fs::create_dir_all(path.join("src"))?;
    let runtime = workspace().join("runtime");
    let manifest = format!(
        "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n{}\n[dependencies]\n\
         carvallo = {{ path = {runtime:?}, features = [\"derive\"] }}\n",
        if alone { "\n[workspace]\n" } else { "" }
    );
    if alone {
        fs::copy(workspace().join("Cargo.lock"), path.join("Cargo.lock"))?;
    }
    fs::write(path.join("Cargo.toml"), manifest)
}

/// A model whose mass matrix is `number * 2 * 0.5^2`.
fn write_model(path: &Path, number: usize) -> io::Result<()> {
    let source = format!(
        "carvallo::model! {{
            model Pendulum {{
                parameters {{ m: kg, > 0; l: m, > 0; k: N*m/rad; }}
                coordinates {{ theta: rad; }}
                M = [[{number}*m*l^2]];
                Kc = [[k*cos(l/1 [m])^2 + k*sin(l/1 [m])^2]];
                set soft {{ m = 2; l = 0.5; k = 5; }}
            }}
        }}
        fn main() {{ println!(\"{{:?}}\", Pendulum::SOFT.matrices().m); }}
        "
    );
    fs::write(path.join("src/main.rs"), source)
}

/// What the program with that model prints.
fn expected(number: usize) -> String {
    format!("[[{:?}]]", number as f64 * 0.5)
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("the crate lies in the workspace").to_owned()
}

fn cargo(what: &str, folder: &Path, target: &Path) -> Command {
    let mut command = in_folder(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()), folder, target);
    command.args([what, "--offline"]);
    command
}

/// A program that builds there, all of them with the same settings, so that none builds Symbolica anew.
fn in_folder(program: OsString, folder: &Path, target: &Path) -> Command {
    let mut command = Command::new(program);
    command.current_dir(folder).env("CARGO_TARGET_DIR", target).env("CARGO_PROFILE_DEV_DEBUG", "0");
    command
}

/// One analysis after another; each takes longer than a round.
struct Analyzer {
    installed: bool,
    running: Option<Process>,
    failed: usize,
    done: usize,
}

impl Analyzer {
    fn keep_running(&mut self, folder: &Path, target: &Path) -> io::Result<()> {
        if self.running.as_mut().is_some_and(|process| matches!(process.child.try_wait(), Ok(None))) {
            return Ok(());
        }
        self.end();
        if self.installed {
            self.running = Some(start(in_folder("rust-analyzer".into(), folder, target).args(["diagnostics", "."]))?);
        }
        Ok(())
    }

    fn end(&mut self) {
        if let Some(process) = self.running.take() {
            self.failed += usize::from(!process.succeeds("an analysis"));
            self.done += 1;
        }
    }

    /// Waits for the last; what became of all.
    fn finish(mut self) -> String {
        self.end();
        if self.installed { format!("{} of {}", self.failed, self.done) } else { "not installed".into() }
    }
}

/// A process whose output goes to a file, so that none waits for a reader.
struct Process {
    child: Child,
    output: PathBuf,
}

fn start(command: &mut Command) -> io::Result<Process> {
    static NUMBER: std::sync::atomic::AtomicUsize = std::sync::atomic::AtomicUsize::new(0);
    let number = NUMBER.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
    let output = std::env::temp_dir().join(format!("carvallo-parallel-builds-{}.{number}", std::process::id()));
    let file = File::create(&output)?;
    let child = command.stdin(Stdio::null()).stdout(file.try_clone()?).stderr(file).spawn()?;
    Ok(Process { child, output })
}

impl Process {
    /// Waits for its end; what a failed one said goes to the standard error.
    fn succeeds(mut self, what: &str) -> bool {
        let status = self.child.wait();
        let fine = status.as_ref().is_ok_and(|status| status.success());
        if !fine {
            eprintln!("{what} failed: {status:?}\n{}", fs::read_to_string(&self.output).unwrap_or_default());
        }
        let _ = fs::remove_file(&self.output);
        fine
    }
}

/// A target folder with its time stamps, which tell cargo that nothing in it is out of date. What was compiled is
/// linked instead of copied: cargo replaces such files and never writes into them.
fn copy(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let (source, target) = (entry.path(), to.join(entry.file_name()));
        if entry.file_type()?.is_dir() {
            if entry.file_name() != "incremental" {
                copy(&source, &target)?;
            }
        } else if from.ends_with("deps") {
            fs::hard_link(&source, &target)?;
        } else {
            fs::copy(&source, &target)?;
            File::options().append(true).open(&target)?.set_modified(entry.metadata()?.modified()?)?;
        }
    }
    Ok(())
}
