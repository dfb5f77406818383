//! A MAT-file of level 5 (The MathWorks, MAT-File Format, "Level 5 MAT-File Format").

use super::Value;

/// Types of data.
const INT8: u32 = 1;
const UINT16: u32 = 4;
const INT32: u32 = 5;
const UINT32: u32 = 6;
const DOUBLE: u32 = 9;
const MATRIX: u32 = 14;
/// Classes of arrays.
const CELL: u32 = 1;
const CHAR: u32 = 4;
const DOUBLES: u32 = 6;

const TEXT: &str = "MATLAB 5.0 MAT-file, a state space by Carvallo";
/// The text, and behind it no data of a subsystem.
const HEADER: usize = 124;

pub fn file(variables: &[(&str, Value)]) -> Vec<u8> {
    let mut bytes = format!("{TEXT:<HEADER$}").into_bytes();
    bytes[HEADER - 8..].fill(0);
    // Version 1, and the order of bytes: `MI` to who has the other one.
    bytes.extend(0x0100_u16.to_le_bytes());
    bytes.extend(b"IM");
    variables.iter().for_each(|(name, value)| bytes.extend(variable(name, value)));
    bytes
}

fn variable(name: &str, value: &Value) -> Vec<u8> {
    match value {
        Value::Matrix(matrix) => {
            array(DOUBLES, [matrix.nrows(), matrix.ncols()], name, &element(DOUBLE, &doubles(matrix.as_slice())))
        }
        Value::Number(number) => array(DOUBLES, [1, 1], name, &element(DOUBLE, &doubles(&[*number]))),
        // A column of cells.
        Value::Texts(texts) => {
            let cells: Vec<u8> = texts.iter().flat_map(|text| letters(text)).collect();
            array(CELL, [texts.len(), 1], name, &cells)
        }
    }
}

/// The array of the letters of a text, which has no name.
fn letters(text: &str) -> Vec<u8> {
    let units: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    array(CHAR, [1, units.len() / 2], "", &element(UINT16, &units))
}

fn array(class: u32, size: [usize; 2], name: &str, data: &[u8]) -> Vec<u8> {
    let flags: Vec<u8> = [class, 0].into_iter().flat_map(u32::to_le_bytes).collect();
    let size: Vec<u8> = size.into_iter().flat_map(|length| (length as i32).to_le_bytes()).collect();
    let [flags, size, name] = [element(UINT32, &flags), element(INT32, &size), element(INT8, name.as_bytes())];
    element(MATRIX, &[&flags, &size, &name, data].concat())
}

/// Data behind their type and length, up to a multiple of 8 bytes.
fn element(kind: u32, data: &[u8]) -> Vec<u8> {
    let mut bytes: Vec<u8> = [kind, data.len() as u32].into_iter().flat_map(u32::to_le_bytes).collect();
    bytes.extend(data);
    bytes.resize(bytes.len().next_multiple_of(8), 0);
    bytes
}

fn doubles(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}
