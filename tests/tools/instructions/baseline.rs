//! What was counted before.

use std::fs;
use std::path::PathBuf;

/// Counts may grow by this part: the library of the platform, whose sine and cosine the code by hand calls, differs.
const TOLERANCE: f64 = 0.02;

/// Counts, and what they depend on.
pub struct Baseline {
    pub compiler: String,
    pub valgrind: String,
    pub counts: Vec<Count>,
}

/// Instructions of one call of an evaluator.
pub struct Count {
    pub name: String,
    pub each: f64,
}

fn file() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../data/instructions.tsv")
}

impl Baseline {
    pub fn read() -> Result<Self, String> {
        let file = file();
        let text = fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
        let header = |key: &str| {
            let found = text.lines().find_map(|line| line.strip_prefix("# ")?.strip_prefix(key));
            found.map(|value| value.trim().to_owned()).ok_or_else(|| format!("{}: no line `# {key} …`", file.display()))
        };
        let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
        let count = |line: &str| {
            let (name, each) = line.split_once('\t')?;
            Some(Count { name: name.to_owned(), each: each.parse().ok()? })
        };
        let counts = rows.map(|line| {
            count(line).ok_or_else(|| format!("{}: `{line}`: expected a name and a number", file.display()))
        });
        Ok(Self {
            compiler: header("compiler:")?,
            valgrind: header("valgrind:")?,
            counts: counts.collect::<Result<_, _>>()?,
        })
    }

    pub fn write(&self) -> Result<(), String> {
        let rows: String = self.counts.iter().map(|count| format!("{}\t{:.1}\n", count.name, count.each)).collect();
        let text = format!(
            "# Instructions of one call of each evaluator, counted by callgrind.\n# To count anew: {} -- --write\n\
             # compiler: {}\n# valgrind: {}\nevaluator\tinstructions\n{rows}",
            crate::COMMAND,
            self.compiler,
            self.valgrind,
        );
        let file = file();
        fs::write(&file, text).map_err(|error| format!("{}: {error}", file.display()))?;
        println!("wrote {}", file.display());
        Ok(())
    }

    fn each(&self, name: &str) -> Option<f64> {
        self.counts.iter().find(|count| count.name == name).map(|count| count.each)
    }
}

/// Prints both, and returns what has grown and what only one of them has, if the two can be compared.
pub fn compare(found: &Baseline, written: &Baseline) -> Vec<String> {
    println!("{:<40} {:>12} {:>12} {:>8}", "instructions of one call", "baseline", "now", "change");
    let mut grown = Vec::new();
    for Count { name, each } in &found.counts {
        let Some(before) = written.each(name) else {
            println!("{name:<40} {:>12} {each:>12.1}", "none");
            grown.push(format!("{name}: not in the baseline"));
            continue;
        };
        let change = each / before - 1.0;
        println!("{name:<40} {before:>12.1} {each:>12.1} {:>+7.1}%", 100.0 * change);
        if change > TOLERANCE {
            grown.push(format!("{name}: {each:.1} in the place of {before:.1}"));
        }
    }
    for Count { name, each } in &written.counts {
        if found.each(name).is_none() {
            println!("{name:<40} {each:>12.1} {:>12}", "none");
            grown.push(format!("{name}: not counted"));
        }
    }
    if found.compiler != written.compiler {
        println!(
            "\nThe baseline is of `{}`, these counts are of `{}`: that they differ is no mistake.",
            written.compiler, found.compiler
        );
        return Vec::new();
    }
    if found.valgrind != written.valgrind {
        println!("\nThe baseline is of {}, these counts are of {}.", written.valgrind, found.valgrind);
    }
    grown
}
