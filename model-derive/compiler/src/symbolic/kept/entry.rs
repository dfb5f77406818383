//! One file: a checksum, the question, and the answer.

use std::fs;
use std::hash::{DefaultHasher, Hasher as _};
use std::io;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use nanoserde::{DeBin, SerBin};

/// Where the checksum ends.
const CHECKED: usize = size_of::<u64>();

/// The name of the file for a question. Questions may share one: what stands in it tells.
pub fn name(question: &[u8]) -> String {
    format!("{:016x}", hash(question))
}

/// What is written of an answer.
pub fn encode(question: &[u8], answer: &impl SerBin) -> Vec<u8> {
    let mut entry = vec![0; CHECKED];
    question.len().ser_bin(&mut entry);
    entry.extend(question);
    answer.ser_bin(&mut entry);
    let sum = hash(&entry[CHECKED..]);
    entry[..CHECKED].copy_from_slice(&sum.to_le_bytes());
    entry
}

/// The answer in a file, if nothing is damaged, and if it is one to this question.
pub fn decode<A: DeBin>(entry: &[u8], question: &[u8]) -> Option<A> {
    let (sum, checked) = entry.split_at_checked(CHECKED)?;
    if sum != hash(checked).to_le_bytes() {
        return None;
    }
    let mut at = 0;
    let length = usize::de_bin(&mut at, checked).ok()?;
    let answer = checked[at..].strip_prefix(question).filter(|_| length == question.len())?;
    at = 0;
    A::de_bin(&mut at, answer).ok().filter(|_| at == answer.len())
}

/// Writes a file of which nobody ever sees a part: it is there when it is whole.
pub fn write(path: &Path, entry: &[u8]) -> io::Result<()> {
    static NUMBER: AtomicUsize = AtomicUsize::new(0);
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    let unfinished = path.with_extension(format!("{}-{number}", std::process::id()));
    let written = fs::write(&unfinished, entry).and_then(|()| fs::rename(&unfinished, path));
    written.inspect_err(|_| drop(fs::remove_file(&unfinished)))
}

/// The same wherever one compiler runs, which is all that is needed: another one has other questions.
fn hash(bytes: &[u8]) -> u64 {
    let mut hasher = DefaultHasher::new();
    hasher.write(bytes);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_comes_back_and_only_to_its_question() {
        let answer = vec![(1, -0.5), (2, f64::MIN_POSITIVE)];
        let entry = encode(b"what", &answer);
        assert_eq!(decode::<Vec<(i32, f64)>>(&entry, b"what"), Some(answer));
        for other in [&b"wha"[..], b"what ", b"What", b""] {
            assert_eq!(decode::<Vec<(i32, f64)>>(&entry, other), None);
        }
    }

    #[test]
    fn a_file_with_any_damage_has_no_answer() {
        let entry = encode(b"what", &vec![7_u32, 8]);
        for length in 0..entry.len() {
            assert_eq!(decode::<Vec<u32>>(&entry[..length], b"what"), None, "cut off at {length}");
        }
        for position in 0..entry.len() {
            let mut damaged = entry.clone();
            damaged[position] ^= 0x10;
            assert_eq!(decode::<Vec<u32>>(&damaged, b"what"), None, "a bit flipped at {position}");
        }
        assert_eq!(decode::<Vec<u32>>(&[&entry[..], &[0]].concat(), b"what"), None, "a byte more");
    }
}
