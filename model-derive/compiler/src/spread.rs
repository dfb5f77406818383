//! Numbers that look random and are the same in every run.

/// A number from 0 to below 1 for each index, no two alike.
///
/// They are without a pattern: in steps of one size, three points whose coordinates are declared one after the other would be
/// on one line, and of three parameters one would be the mean of the others.
pub fn fraction(index: usize) -> f64 {
    // Splitmix64, by Steele, Lea & Flood (2014), and of that what a double holds.
    let mixed = (index as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((mixed ^ (mixed >> 31)) >> 12) as f64 / (1_u64 << 52) as f64
}
