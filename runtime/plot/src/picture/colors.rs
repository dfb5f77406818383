//! The colours of modes.

use carvallo::Mode;

use super::scene::Color;

/// The colour of a mode, and of the critical speed that it has.
pub fn color(mode: Mode) -> Color {
    match mode {
        Mode::Castering => Color(0x1f, 0x6f, 0xb4),
        Mode::Capsize | Mode::Divergence => Color(0xb4, 0x6a, 0x00),
        Mode::Weave | Mode::Flutter => Color(0xc0, 0x28, 0x3c),
        Mode::Wobble => Color(0x00, 0x7d, 0x7d),
        Mode::Real => Color(0x55, 0x5d, 0x66),
        Mode::Oscillatory => Color(0x7a, 0x3f, 0x9d),
    }
}

/// The colours of what has no name, one after the other.
const OTHERS: [Color; 7] = [
    Color(0x1f, 0x6f, 0xb4),
    Color(0x7a, 0x3f, 0x9d),
    Color(0x5b, 0x7a, 0x1f),
    Color(0x8c, 0x4a, 0x2f),
    Color(0x55, 0x5d, 0x66),
    Color(0x2f, 0x3f, 0x9c),
    Color(0xa0, 0x3c, 0x78),
];

/// The colour of one of several modes without names.
pub fn other(index: usize) -> Color {
    OTHERS[index % OTHERS.len()]
}

/// The colours of several designs, one after the other.
const DESIGNS: [Color; 8] = [
    Color(0x1f, 0x6f, 0xb4),
    Color(0xc0, 0x28, 0x3c),
    Color(0x3f, 0x7f, 0x2a),
    Color(0xb4, 0x6a, 0x00),
    Color(0x7a, 0x3f, 0x9d),
    Color(0x00, 0x7d, 0x7d),
    Color(0x55, 0x5d, 0x66),
    Color(0xa0, 0x3c, 0x78),
];

/// The colour of one of several designs.
pub fn design(index: usize) -> Color {
    DESIGNS[index % DESIGNS.len()]
}
