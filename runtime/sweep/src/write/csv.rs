//! Results as comma-separated values (RFC 4180, with line feeds).
//!
//! Not by the crate `csv`, as the other tables are: it puts no quotes around a field for spaces at its ends, which programs
//! that trim fields would lose, and it takes half as long again, since it copies each cell once more.

use crate::table::{Column, Heading};

/// The first line.
pub fn header(headings: &[Heading]) -> Vec<u8> {
    let mut text = Vec::new();
    for (index, heading) in headings.iter().enumerate() {
        separate(index, &mut text);
        push(&heading.name, &mut text);
    }
    text.push(b'\n');
    text
}

/// A line for each row; where there is no value the field is empty.
pub fn rows(columns: &[Column], rows: usize) -> Vec<u8> {
    let mut text = Vec::with_capacity(rows * columns.len() * 8);
    let (mut digits, mut count) = (zmij::Buffer::new(), itoa::Buffer::new());
    for row in 0..rows {
        for (index, column) in columns.iter().enumerate() {
            separate(index, &mut text);
            match column {
                Column::Numbers(values) => {
                    if let Some(value) = values[row] {
                        // The shortest digits that read back to the same double.
                        text.extend_from_slice(digits.format(value).as_bytes());
                    }
                }
                Column::Counts(values) => {
                    if let Some(value) = values[row] {
                        text.extend_from_slice(count.format(value).as_bytes());
                    }
                }
                Column::Texts(values) => {
                    if let Some(value) = &values[row] {
                        push(value, &mut text);
                    }
                }
            }
        }
        text.push(b'\n');
    }
    text
}

fn separate(index: usize, text: &mut Vec<u8>) {
    if index > 0 {
        text.push(b',');
    }
}

/// In quotes where that is needed.
fn push(field: &str, text: &mut Vec<u8>) {
    if field.contains([',', '"', '\n', '\r']) || field.starts_with([' ', '#']) || field.ends_with(' ') {
        text.push(b'"');
        text.extend(field.replace('"', "\"\"").bytes());
        text.push(b'"');
    } else {
        text.extend(field.bytes());
    }
}

#[cfg(test)]
mod tests {
    use super::{header, rows};
    use crate::table::{Column, Heading};

    #[test]
    fn fields_are_quoted_where_they_must_be() {
        let texts = ["plain", "a, b", "say \"so\"", "two\nlines", " space"].map(|text| Some(text.into()));
        let columns = [Column::Texts(texts.to_vec()), Column::Numbers(vec![Some(0.1), None, Some(2.0), None, None])];
        let text = String::from_utf8(rows(&columns, 5)).unwrap_or_default();
        assert_eq!(text, "plain,0.1\n\"a, b\",\n\"say \"\"so\"\"\",2.0\n\"two\nlines\",\n\" space\",\n");
        let header = header(&[Heading::text("error"), Heading::number("w", "m")]);
        assert_eq!(header, b"error,w\n");
    }
}
