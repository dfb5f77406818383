//! Texts that are not in UTF-8: as PowerShell writes what is redirected to a file, and as older programs do.

/// The same text in UTF-8, if it is in UTF-16 with its mark, or in Latin-1, as for the sake of a comment such as `% ©`; all else as it
/// is.
pub fn in_utf8(bytes: Vec<u8>) -> Vec<u8> {
    if std::str::from_utf8(&bytes).is_ok() {
        return bytes;
    }
    of_utf16(&bytes).or_else(|| of_latin(&bytes)).map_or(bytes, String::into_bytes)
}

fn of_utf16(bytes: &[u8]) -> Option<String> {
    let (mark, pairs) = bytes.split_first_chunk::<2>()?;
    let unit = match mark {
        [0xff, 0xfe] => u16::from_le_bytes,
        [0xfe, 0xff] => u16::from_be_bytes,
        _ => return None,
    };
    let (pairs, rest) = pairs.as_chunks::<2>();
    char::decode_utf16(pairs.iter().map(|pair| unit(*pair))).collect::<Result<_, _>>().ok().filter(|_| rest.is_empty())
}

fn of_latin(bytes: &[u8]) -> Option<String> {
    let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
    // What has other signs is of another encoding, or no text.
    let is_foreign = |sign: char| sign.is_control() && !sign.is_whitespace() || "ÿþ".contains(sign);
    (!text.contains(is_foreign)).then_some(text)
}
