//! Parameter files of one parameter a line, with its value, standard deviation and unit in columns: `name,value,std,unit`.

use super::document::{Document, Entry, File, Written};
use super::lines::beginning;

/// What the columns are called; the first two are the first, and the others may be missing.
const COLUMNS: [&str; 4] = ["name", "value", "std", "unit"];

/// Whether a line names these columns.
pub fn is_heading(line: &str) -> bool {
    let cells = cells(line, separator(line));
    cells.len() > 1 && cells[..2] == COLUMNS[..2]
}

/// Whether a line names the columns of a table that has a design in each row: four or more, or as many as the next line has numbers.
pub fn is_heading_of_designs(line: &str, next: Option<&str>) -> bool {
    const LEAST: usize = 4;
    let separator = separator(line);
    let is_name =
        |cell: &String| !cell.contains(['=', ':']) && (cell.is_empty() || cell.starts_with(char::is_alphabetic));
    let names = cells(line, separator);
    let has_numbers = |next: &str| {
        let next = cells(next, separator);
        next.len() == names.len() && next.iter().all(|cell| cell.parse::<f64>().is_ok())
    };
    names.iter().all(is_name) && (names.len() >= LEAST || names.len() > 1 && next.is_some_and(has_numbers))
}

/// That a table has a design in each row.
pub fn refuse_designs(file: File) -> Document {
    let mut document = Document::default();
    document.problem(file.line(1), "this is a table with a design in each row, which `carvallo sweep --designs` reads");
    document
}

/// Reads lines of cells, of which the first names the columns.
pub fn read(file: File) -> Document {
    let mut document = Document::default();
    let mut columns = Vec::new();
    let first = file.text.lines().find(|line| !is_empty(line)).unwrap_or_default();
    let separator = separator(first);
    // Beside points, commas may be of thousands.
    let is_number = |cell: &String| cell.starts_with(|sign: char| sign.is_ascii_digit() || "+-.".contains(sign));
    let has_points =
        |line: &str| cells(line, separator).iter().skip(1).any(|cell| is_number(cell) && cell.contains('.'));
    let has_commas = separator == ';' && !file.text.lines().any(has_points);
    for (index, line) in file.text.lines().enumerate().filter(|(_, line)| !is_empty(line)) {
        let place = file.line(index + 1);
        let cells = cells(line, separator);
        if std::ptr::eq(line, first) {
            columns = cells;
            if let Some(unknown) = columns.iter().find(|column| !COLUMNS.contains(&column.as_str())) {
                document.problem(place, format!("a column is called `{unknown}`; expected {}", COLUMNS.join(", ")));
                return document;
            }
            continue;
        }
        let cell = |name: &str| {
            let at = columns.iter().position(|column| column == name)?;
            cells.get(at).map(String::as_str).filter(|cell| !cell.is_empty())
        };
        let (Some(name), Some(value)) = (cell("name"), cell("value")) else {
            document.problem(place, format!("`{}` is not of the form `name,value`", beginning(line)));
            continue;
        };
        if cells.len() > columns.len() {
            document.problem(place, format!("`{line}` has {} cells; expected {}", cells.len(), columns.join(", ")));
            continue;
        }
        if document.take_heading(name, value) {
            continue;
        }
        if name == "parameterization" {
            document.parameterization = Some((place, value.to_owned()));
            continue;
        }
        let text = |text: &str| Written::Text(if has_commas { with_points(text) } else { text.to_owned() });
        let members =
            [("value", value), ("std", cell("std").unwrap_or_default()), ("unit", cell("unit").unwrap_or_default())];
        let members = members.into_iter().filter(|(_, cell)| !cell.is_empty());
        let members = members.map(|(member, cell)| (member.to_owned(), text(cell)));
        let entry: Entry = document.entry_of_members(name.to_owned(), place, members, "a line without a value");
        document.entries.push(entry);
    }
    document
}

fn is_empty(line: &str) -> bool {
    line.trim().is_empty() || line.starts_with('#')
}

/// Programs in languages with decimal commas write semicolons.
fn separator(line: &str) -> char {
    [';', '\t'].into_iter().find(|&sign| line.contains(sign)).unwrap_or(',')
}

/// With points in the place of decimal commas, which have digits on both sides; those of functions are none.
fn with_points(text: &str) -> String {
    if text.contains('(') {
        return text.to_owned();
    }
    let signs: Vec<char> = text.chars().collect();
    let is_digit = |at: Option<usize>| at.and_then(|at| signs.get(at)).is_some_and(char::is_ascii_digit);
    let point = |(at, &sign): (usize, &char)| match sign {
        ',' if is_digit(at.checked_sub(1)) && is_digit(Some(at + 1)) => '.',
        sign => sign,
    };
    signs.iter().enumerate().map(point).collect()
}

fn cells(line: &str, separator: char) -> Vec<String> {
    let unquoted = |cell: &str| super::texts::unquoted(cell.trim()).to_owned();
    line.split(separator).map(unquoted).collect()
}
