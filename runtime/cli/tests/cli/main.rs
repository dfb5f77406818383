//! The command line from outside: what is printed, and the exit codes.

mod along;
mod analyze;
mod bodies;
mod check;
mod compare;
mod controllability;
mod convert;
mod correlations;
mod documents;
mod equations;
mod extremes;
mod feedback;
mod formats;
mod hints;
mod latex;
mod locus;
mod lqr;
mod matrices;
mod measure;
mod mistakes;
mod mistakes_of_models;
mod models;
mod numbers;
mod optimize;
mod phasors;
mod pictures;
mod process;
mod readings;
mod respond;
mod sensitivity;
mod shapes;
mod show;
mod simulate;
mod statespace;
mod sweep;
mod transfer;
mod turns;
mod units;
mod units_of_pictures;

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The benchmark bicycle as it ships.
const BENCHMARK: &str = include_str!("../../../../generated/bicycles/benchmark.toml");

/// What a run left behind.
struct Run {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

/// A directory of its own for a test, so that paths in messages are short and tests do not meet.
struct Directory(PathBuf);

impl Directory {
    fn new(test: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// For what several tests call: each of them runs in a thread of its own name.
    fn of_this_test() -> Self {
        let thread = std::thread::current();
        Self::new(&thread.name().unwrap_or_default().replace("::", "-"))
    }

    fn write(&self, name: &str, text: impl AsRef<[u8]>) -> &Self {
        std::fs::write(self.0.join(name), text).unwrap();
        self
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_carvallo"));
        command.args(arguments).current_dir(&self.0).stdin(Stdio::null());
        command.env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE");
        command
    }

    fn run(&self, arguments: &[&str]) -> Run {
        finished(self.command(arguments).output().unwrap())
    }

    fn run_with_input(&self, arguments: &[&str], input: &str) -> Run {
        let mut command = self.command(arguments);
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
        finished(child.wait_with_output().unwrap())
    }
}

fn finished(output: std::process::Output) -> Run {
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Run { code: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
}

impl Run {
    /// The output of a run that must succeed.
    #[track_caller]
    fn ok(self) -> String {
        assert_eq!((self.code, self.stderr.as_str()), (Some(0), ""));
        self.stdout
    }

    /// The message of a run that must fail and print nothing else.
    #[track_caller]
    fn fails(self, code: i32, message: &str) {
        assert_eq!((self.code, self.stdout.as_str(), self.stderr.as_str()), (Some(code), "", message));
    }

    #[track_caller]
    fn json(self) -> serde_json::Value {
        serde_json::from_str(&self.ok()).unwrap()
    }
}
