//! An array in the format of NumPy (NEP 1, version 1.0).

use super::Value;

/// The header is as long as keeps the numbers behind it on multiples of this.
const ALIGNMENT: usize = 64;

pub fn array(value: &Value) -> Vec<u8> {
    match value {
        Value::Matrix(matrix) => {
            // Row by row.
            let data = matrix.transpose().iter().flat_map(|entry| entry.to_le_bytes()).collect();
            with_header("<f8", &format!("({}, {})", matrix.nrows(), matrix.ncols()), data)
        }
        Value::Number(number) => with_header("<f8", "()", number.to_le_bytes().to_vec()),
        Value::Texts(texts) => {
            let longest = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
            let padded = |text: &String| -> Vec<u8> {
                let letters = text.chars().map(u32::from).chain(std::iter::repeat(0)).take(longest);
                letters.flat_map(u32::to_le_bytes).collect()
            };
            with_header(
                &format!("<U{longest}"),
                &format!("({},)", texts.len()),
                texts.iter().flat_map(padded).collect(),
            )
        }
    }
}

fn with_header(kind: &str, shape: &str, data: Vec<u8>) -> Vec<u8> {
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    let before = b"\x93NUMPY\x01\x00".len() + 2;
    let length = (before + header.len() + 1).next_multiple_of(ALIGNMENT) - before;
    header = format!("{header:<width$}\n", width = length - 1);
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((length as u16).to_le_bytes());
    bytes.extend(header.into_bytes());
    bytes.extend(data);
    bytes
}
