//! LaTeX with the package booktabs. Numbers stand in math mode, so that their signs are minus signs.

use carvallo::Notation;

use super::{Cell, Column, Document, Side, Table, aligned, sentence, widths};

pub fn write(document: &Document) -> String {
    let mut text = format!("% {}. Needs \\usepackage{{booktabs}}.\n", document.title.replace('\n', " "));
    for about in &document.about {
        text.push_str(&format!("% {}\n", about.replace('\n', " ")));
    }
    for table in &document.tables {
        text.push_str(&write_table(table, &document.title));
    }
    text
}

fn write_table(Table { title, columns, rows, notes }: &Table, document: &str) -> String {
    let notes: String = notes.iter().map(|note| format!(" {}.", words(sentence(note).trim_end_matches('.')))).collect();
    let title = if title.is_empty() { words(document) } else { format!("{}: {}", words(document), words(title)) };
    let caption = format!("{title}.{notes}");
    if rows.is_empty() {
        return format!("\n\\paragraph{{}}{caption}\n");
    }
    let line = |cells: &mut dyn Iterator<Item = &Cell>| cells.map(cell).collect::<Vec<String>>();
    let heading = line(&mut columns.iter().map(|column| &column.heading));
    let lines: Vec<Vec<String>> =
        std::iter::once(heading).chain(rows.iter().map(|row| line(&mut row.iter()))).collect();
    let widths = widths(&lines, 0);
    let sides: String = columns.iter().map(|Column { side, .. }| if *side == Side::Left { 'l' } else { 'r' }).collect();
    let mut text = format!(
        "\n\\begin{{table}}\n  \\centering\n  \\caption{{{caption}}}\n  \\begin{{tabular}}{{{sides}}}\n    \\toprule\n"
    );
    let has_heading = lines[0].iter().any(|cell| !cell.is_empty());
    for (index, cells) in lines.iter().enumerate().skip(usize::from(!has_heading)) {
        let line = aligned(cells, &widths, columns).join(" & ");
        text.push_str(&format!("    {} \\\\\n", line.trim_end()));
        if index == 0 {
            text.push_str("    \\midrule\n");
        }
    }
    text.push_str("    \\bottomrule\n  \\end{tabular}\n\\end{table}\n");
    text
}

fn cell(cell: &Cell) -> String {
    match cell {
        Cell::Words(text) => words(text),
        Cell::Number(text) => text.split(", ").map(number).collect::<Vec<String>>().join(", "),
        Cell::Symbol { symbol, .. } => format!("${}$", Notation::Latex.symbol(symbol)),
    }
}

/// Text, with commands for what LaTeX has no letter for.
fn words(text: &str) -> String {
    let word = |c: char| match c {
        '#' | '$' | '%' | '&' | '_' | '{' | '}' => format!("\\{c}"),
        '\\' => "\\textbackslash{}".to_owned(),
        '^' => "\\textasciicircum{}".to_owned(),
        '~' => "\\textasciitilde{}".to_owned(),
        '<' | '>' => format!("${c}$"),
        '±' => "$\\pm$".to_owned(),
        '→' => "$\\to$".to_owned(),
        '−' => "$-$".to_owned(),
        '²' => "$^2$".to_owned(),
        '³' => "$^3$".to_owned(),
        '°' => "$^\\circ$".to_owned(),
        '⁴' => "$^4$".to_owned(),
        '≤' => "$\\le$".to_owned(),
        '≥' => "$\\ge$".to_owned(),
        '×' => "$\\times$".to_owned(),
        '·' => "$\\cdot$".to_owned(),
        '∞' => "$\\infty$".to_owned(),
        '√' => "$\\surd$".to_owned(),
        'α'..='ω' | 'Α'..='Ω' => format!("${}$", Notation::Latex.symbol(&c.to_string())),
        // Quotes of LaTeX are a pair.
        '"' => "''".to_owned(),
        c => c.to_string(),
    };
    text.chars().map(word).collect()
}

/// A number in math mode: `-1.5e-6 ± 2 i`, a polynomial in s, or several with commas between them; what is none stays a text.
fn number(text: &str) -> String {
    if text.contains(", ") {
        return text.split(", ").map(number).collect::<Vec<_>>().join(", ");
    }
    let is_part =
        |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'i' | '±' | ' ' | '*' | 's' | '^');
    if text == "-" {
        return "--".to_owned();
    }
    if text.is_empty() || !text.contains(|c: char| c.is_ascii_digit()) || !text.chars().all(is_part) {
        return words(text);
    }
    let mut math = String::new();
    let mut rest = text.chars().peekable();
    while let Some(found) = rest.next() {
        match found {
            'e' => {
                let mut exponent = String::new();
                while let Some(sign) = rest.next_if(|&c| c.is_ascii_digit() || exponent.is_empty() && c == '-') {
                    exponent.push(sign);
                }
                math.push_str(&format!(" \\cdot 10^{{{exponent}}}"));
            }
            '^' => {
                let mut power = String::new();
                while let Some(digit) = rest.next_if(char::is_ascii_digit) {
                    power.push(digit);
                }
                math.push_str(&format!("^{{{power}}}"));
            }
            's' => {
                // A thin space between a coefficient and its power.
                if math.ends_with(' ') && math.trim_end().ends_with(|c: char| c.is_ascii_digit() || c == '}') {
                    math.truncate(math.trim_end().len());
                    math.push_str("\\,");
                }
                math.push('s');
            }
            '±' => math.push_str("\\pm"),
            'i' => {
                math.truncate(math.trim_end().len());
                math.push_str("\\,\\mathrm{i}");
            }
            other => math.push(other),
        }
    }
    format!("${math}$")
}

#[cfg(test)]
mod tests {
    use super::{number, words};
    use crate::output::typeset::{Cell, Column, Document, Language, Table};

    #[test]
    fn numbers_stand_in_math_mode() {
        assert_eq!(number("-0.775342 ± 4.464868 i"), "$-0.775342 \\pm 4.464868\\,\\mathrm{i}$");
        assert_eq!(number("+1.20000e-5"), "$+1.20000 \\cdot 10^{-5}$");
        assert_eq!(number("s^12 - 15.9e8 s^3 + 2 s - 3"), "$s^{12} - 15.9 \\cdot 10^{8}\\,s^{3} + 2\\,s - 3$");
        assert_eq!(number("-1.5 ± 2 i, 3"), "$-1.5 \\pm 2\\,\\mathrm{i}$, $3$");
        assert_eq!(number("3.1-2.0i"), "$3.1-2.0\\,\\mathrm{i}$");
        assert_eq!([number("-"), number("straight")], ["--", "straight"]);
    }

    #[test]
    fn signs_of_latex_are_text() {
        assert_eq!(words("50 % of A_1 & {B}, kg m²"), "50 \\% of A\\_1 \\& \\{B\\}, kg m$^2$");
        assert_eq!(words("θ of ψ ≤ λ"), "$\\theta$ of $\\psi$ $\\le$ $\\lambda$");
        assert_eq!(words("a\\b ~ 5°"), "a\\textbackslash{}b \\textasciitilde{} 5$^\\circ$");
    }

    #[test]
    fn tables_have_rules_of_booktabs() {
        let document = Document {
            title: "pista".to_owned(),
            about: Vec::new(),
            tables: vec![Table {
                title: "Speeds".to_owned(),
                columns: vec![Column::left("what"), Column::right("v (m/s)")],
                rows: vec![vec![Cell::Symbol { name: "lam".to_owned(), symbol: "λ".to_owned() }, Cell::number("-0.5")]],
                notes: vec!["exact.".to_owned()],
            }],
        };
        let expected = "\
% pista. Needs \\usepackage{booktabs}.

\\begin{table}
  \\centering
  \\caption{pista: Speeds. Exact.}
  \\begin{tabular}{lr}
    \\toprule
    what      & v (m/s) \\\\
    \\midrule
    $\\lambda$ &  $-0.5$ \\\\
    \\bottomrule
  \\end{tabular}
\\end{table}
";
        assert_eq!(document.write(Language::Latex), expected);
    }
}
