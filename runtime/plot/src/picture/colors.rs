//! The colours of modes.

use carvallo::Mode;

use super::scene::{Color, Paint};

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

/// The colours of several designs, one after the other: four and four that differ for all eyes, and in their dashes.
const DESIGNS: [Color; 8] = [
    Color(0x1f, 0x6f, 0xb4),
    Color(0xb8, 0x50, 0x0a),
    Color(0x0b, 0x4f, 0x30),
    Color(0xa0, 0x3c, 0x78),
    Color(0xc9, 0x30, 0x2c),
    Color(0x14, 0x80, 0x8a),
    Color(0x50, 0x10, 0x2a),
    Color(0x6a, 0x35, 0xc8),
];

/// Their dashes and gaps, in widths of a line, each for four. There are as many as have no divisor with the colours in common.
const DASHES: [Option<[f32; 2]>; 5] = [None, Some([4.0, 2.0]), Some([1.5, 1.5]), Some([9.0, 2.5]), Some([2.5, 5.0])];

/// The colour of one of several designs.
pub fn design(index: usize) -> Color {
    DESIGNS[index % DESIGNS.len()]
}

/// The line of one of several designs, which differs from that of another of the same colour.
pub fn design_line(index: usize, width: f32) -> Paint {
    let dash = DASHES[index / 4 % DASHES.len()].map(|lengths| lengths.map(|length| length * width));
    Paint::Stroke { width, dash }
}

#[cfg(test)]
mod tests {
    use super::{DESIGNS, design, design_line};
    use crate::picture::scene::Color;

    /// What red, green and blue light become for those who lack the sense of one of them, by Machado, Oliveira & Fernandes, "A
    /// Physiologically-based Model for Simulation of Color Vision Deficiency" (2009), severity 1.
    const EYES: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.152_286, 1.052_583, -0.204_868], [0.114_503, 0.786_281, 0.099_216], [-0.003_882, -0.048_116, 1.051_998]],
        [[0.367_322, 0.860_646, -0.227_968], [0.280_085, 0.672_501, 0.047_413], [-0.011_820, 0.042_940, 0.968_881]],
        [[1.255_528, -0.076_749, -0.178_779], [-0.078_411, 0.930_809, 0.147_602], [0.004_733, 0.691_367, 0.303_900]],
    ];

    /// In CIE L*a*b* with the white of sRGB.
    fn seen(Color(red, green, blue): Color, eyes: &[[f64; 3]; 3]) -> [f64; 3] {
        let linear = [red, green, blue].map(|channel| {
            let share = f64::from(channel) / 255.0;
            if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
        });
        let times = |rows: &[[f64; 3]; 3], values: [f64; 3]| {
            rows.map(|row| row.iter().zip(values).map(|(factor, value)| factor * value).sum::<f64>())
        };
        let light = times(eyes, linear).map(|share| share.clamp(0.0, 1.0));
        let to_xyz = [
            [0.412_456_4, 0.357_576_1, 0.180_437_5],
            [0.212_672_9, 0.715_152_2, 0.072_175],
            [0.019_333_9, 0.119_192, 0.950_304_1],
        ];
        let [x, y, z] = times(&to_xyz, light);
        let [x, y, z] = [x / 0.95047, y, z / 1.08883]
            .map(|share: f64| if share > 0.008_856 { share.cbrt() } else { 7.787 * share + 16.0 / 116.0 });
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    #[test]
    fn designs_differ_for_all_eyes() {
        for four in DESIGNS.chunks(4) {
            for (index, one) in four.iter().enumerate() {
                for other in &four[..index] {
                    for eyes in &EYES {
                        let [one, other] = [one, other].map(|color| seen(*color, eyes));
                        let distance = one.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
                        assert!(distance > 20.0, "{one:?} and {other:?} are {distance} apart");
                    }
                }
            }
        }
    }

    #[test]
    fn forty_designs_have_forty_lines() {
        let lines: Vec<_> = (0..40).map(|index| (design(index), design_line(index, 2.0))).collect();
        for (index, line) in lines.iter().enumerate() {
            assert!(!lines[..index].contains(line), "{index}: {line:?}");
        }
    }
}
