//! A ZIP archive of files that are stored as they are (APPNOTE.TXT of PKWARE, 4.3), with the same bytes on every run.

/// The first day that there is in it: 1 January 1980.
const DATE: u16 = 1 << 5 | 1;
const VERSION: u16 = 20;

/// Of files with their names, each below 4 GiB, as those here are by far.
pub fn archive(files: &[(String, Vec<u8>)]) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (name, data) in files {
        let place = bytes.len() as u32;
        let described = description(name, data);
        bytes.extend(b"PK\x03\x04");
        bytes.extend(&described);
        bytes.extend(name.as_bytes());
        bytes.extend(data);
        directory.extend(b"PK\x01\x02");
        directory.extend(VERSION.to_le_bytes());
        directory.extend(&described);
        // Without a comment, on the first disk, without attributes.
        directory.extend([0; 10]);
        directory.extend(place.to_le_bytes());
        directory.extend(name.as_bytes());
    }
    let (place, length, count) = (bytes.len() as u32, directory.len() as u32, files.len() as u16);
    bytes.extend(directory);
    bytes.extend(b"PK\x05\x06\0\0\0\0");
    bytes.extend([count.to_le_bytes(), count.to_le_bytes()].concat());
    bytes.extend([length.to_le_bytes(), place.to_le_bytes()].concat());
    bytes.extend([0; 2]);
    bytes
}

/// What stands before each file and in the directory alike.
fn description(name: &str, data: &[u8]) -> Vec<u8> {
    let size = data.len() as u32;
    let mut bytes = Vec::new();
    // Without flags, compression and a time.
    for number in [VERSION, 0, 0, 0, DATE] {
        bytes.extend(number.to_le_bytes());
    }
    for number in [crc32fast::hash(data), size, size] {
        bytes.extend(number.to_le_bytes());
    }
    for number in [name.len() as u16, 0] {
        bytes.extend(number.to_le_bytes());
    }
    bytes
}
