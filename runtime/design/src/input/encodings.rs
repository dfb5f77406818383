//! Texts that are not in UTF-8: as PowerShell writes what is redirected to a file, and as older programs do.

/// What is in a file of text: in UTF-8, with lines that end as elsewhere if they end as on the first Macintosh.
pub fn text(bytes: Vec<u8>) -> Vec<u8> {
    let mut bytes = in_utf8(bytes);
    if !bytes.contains(&b'\n') {
        bytes.iter_mut().filter(|byte| **byte == b'\r').for_each(|byte| *byte = b'\n');
    }
    bytes
}

/// The same text in UTF-8, if it is in UTF-16, or in Latin-1, as for the sake of a comment such as `% ©`; all else as it is.
pub fn in_utf8(bytes: Vec<u8>) -> Vec<u8> {
    let is_plain = std::str::from_utf8(&bytes).is_ok() && !bytes.contains(&0);
    if is_plain {
        return bytes;
    }
    of_utf16(&bytes).or_else(|| of_latin(&bytes)).map_or(bytes, String::into_bytes)
}

/// By its mark, or without one by the halves of the signs: most of all texts of numbers are zero in one of them.
fn of_utf16(bytes: &[u8]) -> Option<String> {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let zeros = |half: usize| pairs.iter().filter(|pair| pair[half] == 0).count();
    let is_mostly = |zeros: usize| 2 * zeros > pairs.len();
    let (unit, pairs): (fn([u8; 2]) -> u16, _) = match pairs.split_first()? {
        ([0xff, 0xfe], pairs) => (u16::from_le_bytes, pairs),
        ([0xfe, 0xff], pairs) => (u16::from_be_bytes, pairs),
        _ if is_mostly(zeros(1)) && zeros(0) == 0 => (u16::from_le_bytes, pairs),
        _ if is_mostly(zeros(0)) && zeros(1) == 0 => (u16::from_be_bytes, pairs),
        _ => return None,
    };
    char::decode_utf16(pairs.iter().map(|pair| unit(*pair))).collect::<Result<_, _>>().ok().filter(|_| rest.is_empty())
}

fn of_latin(bytes: &[u8]) -> Option<String> {
    let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
    // What has other signs is of another encoding, or no text.
    let is_foreign = |sign: char| sign.is_control() && !sign.is_whitespace() || "ÿþ".contains(sign);
    (!text.contains(is_foreign)).then_some(text)
}
