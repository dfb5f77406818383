//! Tables for documents: `--format markdown` and `--format latex`.

use crate::Directory;

/// Commands that print tables.
const COMMANDS: [&[&str]; 10] = [
    &["analyze", "benchmark"],
    &["analyze", "benchmark", "--speeds", "5", "--eigenvectors"],
    &["analyze", "--along", "mB=60:120", "--speed", "5"],
    &["analyze", "--model", "Motorcycle"],
    &["analyze", "--model", "Pendulum"],
    &["sensitivity", "pista-rider"],
    &["turns"],
    &["simulate", "--speed", "5", "--initial", "phi=0.1", "--duration", "1"],
    &["bicycles"],
    &["models"],
];

fn document(command: &[&str], language: &str) -> String {
    let run = Directory::of_this_test().run(&[command, &["--format", language]].concat());
    assert_eq!(run.code, Some(0), "{command:?}: {}", run.stderr);
    run.stdout
}

/// The cells of a line of Markdown; a bar after a backslash is none between cells.
fn cells(line: &str) -> usize {
    line.replace("\\|", "").matches('|').count()
}

#[test]
fn tables_of_markdown_have_as_many_cells_in_each_line() {
    for command in COMMANDS {
        let text = document(command, "markdown");
        let mut lines = text.lines().peekable();
        let mut tables = 0;
        while let Some(heading) = lines.find(|line| line.starts_with('|')) {
            let rule = lines.next().unwrap_or_default();
            assert!(rule.chars().all(|c| "|-: ".contains(c)), "{command:?}: {rule}");
            while let Some(line) = lines.next_if(|line| line.starts_with('|')) {
                assert_eq!(cells(line), cells(heading), "{command:?}: {line}");
                assert_eq!(line.chars().count(), heading.chars().count(), "{command:?}: {line}");
            }
            tables += 1;
        }
        assert!(tables > 0, "{command:?} has no table");
    }
}

#[test]
fn symbols_keep_their_letters() {
    for language in ["latex", "markdown"] {
        let text = document(&["analyze", "benchmark"], language);
        assert!(text.contains("g = 9.81 N/kg") && !text.contains("G = "), "{language}: {text}");
    }
}

/// Each environment that begins ends, each line of a table has as many cells as the table has columns, braces are in pairs, and
/// there is no character that LaTeX would not take for text.
#[test]
fn tables_of_latex_are_whole() {
    for command in COMMANDS {
        let text = document(command, "latex");
        let count = |part: &str| text.matches(part).count();
        assert_eq!(count("\\begin{tabular}"), count("\\end{tabular}"), "{command:?}");
        assert_eq!(count("\\begin{table}"), count("\\end{table}"), "{command:?}");
        assert_eq!(count("\\toprule"), count("\\bottomrule"), "{command:?}");
        let mut columns = 0;
        for line in text.lines().filter(|line| !line.starts_with('%')) {
            let bare =
                line.replace("\\&", "").replace("\\{", "").replace("\\}", "").replace("\\%", "").replace("\\_", "");
            assert_eq!(bare.matches('{').count(), bare.matches('}').count(), "{command:?}: {line}");
            assert_eq!(bare.matches('$').count() % 2, 0, "{command:?}: {line}");
            if let Some((_, sides)) = line.split_once("\\begin{tabular}{") {
                columns = sides.len() - 1;
            }
            if line.ends_with("\\\\") {
                assert_eq!(bare.matches('&').count() + 1, columns, "{command:?}: {line}");
            }
            let outside: String = bare.split('$').step_by(2).collect();
            assert!(!outside.contains(['^', '#', '~', '±', '²', 'λ', '°', '→', '_', '%']), "{command:?}: {line}");
        }
        assert!(columns > 0, "{command:?} has no table");
    }
}

/// The numbers are those of Meijaard, Papadopoulos, Ruina & Schwab (2007): 4.2924 and 6.0243 m/s, and -0.775341882195845 +-
/// 4.46486771378823 i at 5 m/s in their table 2.
#[test]
fn documents_have_the_published_numbers() {
    let line = |text: &str, begin: &str| -> Vec<String> {
        let line =
            text.lines().find(|line| line.trim_start().starts_with(begin)).unwrap_or_else(|| panic!("{begin}: {text}"));
        line.split(['|', '&']).map(|cell| cell.trim().trim_end_matches('\\').trim().to_owned()).collect()
    };
    let markdown = document(&["bicycles"], "markdown");
    let expected =
        ["", "benchmark", "4.2924", "6.0243", "4.2924 to 6.0243", "hypothetical bicycle with a rigid rider", ""];
    assert_eq!(line(&markdown, "| benchmark "), expected);
    let latex = document(&["bicycles"], "tex");
    assert_eq!(line(&latex, "benchmark ")[..3], ["benchmark", "$4.2924$", "$6.0243$"]);
    let latex = document(&["analyze"], "latex");
    let eigenvalues = line(&latex, "$5$ ");
    assert_eq!(eigenvalues[3..], ["$-0.775342 \\pm 4.464868\\,\\mathrm{i}$", "stable"]);
    let latex = document(&["sensitivity"], "latex");
    assert_eq!(line(&latex, "$\\lambda$ ")[..2], ["$\\lambda$", "$0.3141592653589793$"]);
}
