//! Markdown with tables, as GitHub and pandoc read it.

use super::{Cell, Column, Document, Side, Table, aligned, sentence, widths};

pub fn write(document: &Document) -> String {
    let mut text = format!("## {}\n", escaped(&document.title));
    for about in &document.about {
        text.push_str(&format!("\n{}\n", escaped(about)));
    }
    for table in &document.tables {
        text.push_str(&write_table(table));
    }
    text
}

fn write_table(Table { title, columns, rows, notes }: &Table) -> String {
    let mut text = if title.is_empty() { String::new() } else { format!("\n### {}\n", escaped(title)) };
    let line = |cells: &mut dyn Iterator<Item = &Cell>| cells.map(cell).collect::<Vec<String>>();
    let heading = line(&mut columns.iter().map(|column| &column.heading));
    let lines: Vec<Vec<String>> =
        std::iter::once(heading).chain(rows.iter().map(|row| line(&mut row.iter()))).collect();
    // A rule has at least three signs.
    let widths = widths(&lines, 3);
    let rule = |(Column { side, .. }, width): (&Column, &usize)| match side {
        Side::Left => "-".repeat(*width),
        Side::Right => format!("{}:", "-".repeat(width - 1)),
    };
    let rule: Vec<String> = columns.iter().zip(&widths).map(rule).collect();
    if !rows.is_empty() {
        text.push('\n');
        for (index, cells) in lines.iter().enumerate() {
            text.push_str(&format!("| {} |\n", aligned(cells, &widths, columns).join(" | ")));
            if index == 0 {
                text.push_str(&format!("| {} |\n", rule.join(" | ")));
            }
        }
    }
    for note in notes {
        text.push_str(&format!("\n{}\n", escaped(&sentence(note))));
    }
    text
}

fn cell(cell: &Cell) -> String {
    match cell {
        Cell::Words(text) | Cell::Number(text) => escaped(text),
        Cell::Symbol { name, .. } => escaped(name),
    }
}

/// With a backslash before each sign that would be read as more than itself.
fn escaped(text: &str) -> String {
    let escape = |(index, c): (usize, char)| {
        let begins_a_list = index == 0 && matches!(c, '+' | '#' | '>') && text.chars().nth(1) == Some(' ');
        if matches!(c, '\\' | '|' | '*' | '_' | '`' | '<' | '[' | ']') || begins_a_list {
            format!("\\{c}")
        } else {
            c.to_string()
        }
    };
    text.chars().enumerate().map(escape).collect()
}

#[cfg(test)]
mod tests {
    use crate::output::typeset::{Cell, Column, Document, Language, Table};

    #[test]
    fn tables_are_aligned_and_escaped() {
        let document = Document {
            title: "a_b".to_owned(),
            about: vec!["From <a> | b*c".to_owned()],
            tables: vec![Table {
                title: "Speeds".to_owned(),
                columns: vec![Column::left("what"), Column::right("v (m/s)")],
                rows: vec![
                    vec![Cell::words("weave"), Cell::number("4.2924")],
                    vec![Cell::Symbol { name: "x_1".to_owned(), symbol: "x".to_owned() }, Cell::number("-0.5")],
                ],
                notes: vec!["# none".to_owned()],
            }],
        };
        let expected = "\
## a\\_b

From \\<a> \\| b\\*c

### Speeds

| what  | v (m/s) |
| ----- | ------: |
| weave |  4.2924 |
| x\\_1  |    -0.5 |

\\# none
";
        assert_eq!(document.write(Language::Markdown), expected);
    }
}
