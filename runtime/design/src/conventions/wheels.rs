//! Sizes of wheels as they stand on tyres: `28-622` (ISO 5775), `700x28C`, `26x2.1`, `27 x 1 1/4`.

use super::name::Name;
use crate::failure::Problem;
use crate::input::{Entry, Written};

/// Names of an entry that is the size of a tyre.
const SIZES: [(&[&str], &str); 3] = [
    (&["wheel", "wheels", "tyre", "tire", "tyres", "tires", "wheel_size"], "wheel_diameter"),
    (&["rear_wheel", "rear_tyre", "rear_tire"], "rear_wheel_diameter"),
    (&["front_wheel", "front_tyre", "front_tire"], "front_wheel_diameter"),
];

/// Bead seat diameters in mm, by the French sizes and by those in inches with decimals.
const BEADS: [(&str, f64); 21] = [
    ("700c", 622.0),
    ("700b", 635.0),
    ("700a", 642.0),
    ("700d", 587.0),
    ("700", 622.0),
    ("650a", 590.0),
    ("650b", 584.0),
    ("650c", 571.0),
    ("600a", 540.0),
    ("29", 622.0),
    ("27.5", 584.0),
    ("27", 630.0),
    ("26", 559.0),
    ("24", 507.0),
    ("20", 406.0),
    ("18", 355.0),
    ("16", 305.0),
    ("14", 254.0),
    ("12", 203.0),
    ("12.5", 203.0),
    ("36", 787.0),
];

/// Puts the diameter in the place of each size.
pub fn measure(entries: &mut Vec<Entry>, problems: &mut Vec<Problem>) {
    for entry in entries {
        let called = |names: &[&'static str]| names.iter().any(|name| Name::new(name, "m", "").is_called(&entry.name));
        let Some((_, diameter)) = SIZES.iter().find(|(names, _)| called(names)) else { continue };
        let Written::Text(text) = &entry.value else { continue };
        let found = self::diameter(text);
        if found.is_none() {
            let message = format!(
                "`{}` is `{text}`; expected the size on its tyre, such as 28-622, 700x28C or 26x2.1, or `{diameter}`",
                entry.name
            );
            problems.push(Problem { place: entry.place.clone(), message });
        }
        // Any size will do where what is wrong is told.
        entry.value = Written::Text(format!("{} mm", crate::number::shortest(found.unwrap_or(700.0))));
        entry.renamed = Some(std::mem::replace(&mut entry.name, (*diameter).to_owned()));
    }
}

/// The diameter in mm of a wheel with its tyre: that of its seat, and twice the width of the tyre, which is about as high as
/// it is wide.
fn diameter(text: &str) -> Option<f64> {
    let text: String = text.trim().trim_matches(['"', '\'']).to_lowercase().replace(['×', '*'], "x");
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|number| number.is_finite() && *number > 0.0);
    if let Some((width, bead)) = text.split_once('-')
        && let (Some(width), Some(bead)) = (number(width), number(bead))
        && (100.0..1000.0).contains(&bead)
        && (10.0..150.0).contains(&width)
    {
        return Some(bead + 2.0 * width);
    }
    let (size, width) = text.split_once('x')?;
    let (size, width) = (size.trim().trim_end_matches(['"', '″']), width.trim().trim_end_matches(['"', '″']));
    // The letter of French sizes stands behind either part.
    let letter = width.chars().next_back().filter(char::is_ascii_alphabetic);
    let width = width.trim_end_matches(|sign: char| sign.is_ascii_alphabetic()).trim();
    let named = match letter {
        Some(letter) => format!("{size}{letter}"),
        None => size.to_owned(),
    };
    let bead = |name: &str| BEADS.iter().find(|(own, _)| *own == name).map(|(_, bead)| *bead);
    let is_french = number(size.trim_end_matches(|sign: char| sign.is_ascii_alphabetic()))? >= 400.0;
    let width = if is_french { number(width)? } else { 25.4 * inches(width)? };
    // Of widths in inches with a fraction, only one size has always the same seat.
    if !is_french && text.contains('/') && size != "27" {
        return None;
    }
    Some(bead(&named).or_else(|| bead(size))? + 2.0 * width)
}

/// `2.1`, `1 3/8` and `1-3/8` in inches.
fn inches(text: &str) -> Option<f64> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|number| number.is_finite() && *number > 0.0);
    let Some((above, below)) = text.rsplit_once('/') else { return number(text) };
    let (whole, above) = above.rsplit_once([' ', '-']).map_or((None, above), |(whole, above)| (Some(whole), above));
    let fraction = number(above)? / number(below)?;
    Some(match whole {
        Some(whole) => number(whole)? + fraction,
        None => fraction,
    })
}

#[cfg(test)]
mod tests {
    use super::diameter;

    /// By ISO 5775-1, the diameter of the seat and twice the height of the tyre; and within 2 % the circumferences that Cateye
    /// prints for its cycle computers, which are those under load.
    #[test]
    fn sizes_are_those_of_the_standard() {
        for (text, size, printed) in [
            ("20-622", 662.0, 2086.0),
            ("23-622", 668.0, 2096.0),
            ("700 x 23 c", 668.0, 2096.0),
            ("25-622", 672.0, 2105.0),
            ("28-622", 678.0, 2136.0),
            ("700x28C", 678.0, 2136.0),
            ("700C x 28", 678.0, 2136.0),
            ("27 x 1 1/4", 630.0 + 2.5 * 25.4, 2161.0),
            ("27x1-1/8\"", 630.0 + 2.25 * 25.4, 2155.0),
        ] {
            let found = diameter(text).unwrap();
            assert!((found - size).abs() < 1e-9, "{text}: {found}");
            let circumference = std::f64::consts::PI * found;
            assert!((circumference / printed - 1.0).abs() < 0.02, "{text}: {circumference}, printed {printed}");
        }
    }

    /// The seats of ISO 5775-2.
    #[test]
    fn sizes_in_inches_and_french_ones_have_their_seats() {
        for (text, seat, width) in [
            ("26x2.1", 559.0, 2.1 * 25.4),
            ("29 x 2.25", 622.0, 2.25 * 25.4),
            ("27.5\" x 2.25\"", 584.0, 2.25 * 25.4),
            ("20x1.75", 406.0, 1.75 * 25.4),
            ("650x38B", 584.0, 38.0),
            ("650b x 42", 584.0, 42.0),
            ("700x40", 622.0, 40.0),
        ] {
            assert!((diameter(text).unwrap() - seat - 2.0 * width).abs() < 1e-9, "{text}");
        }
    }

    /// Sizes in inches with fractions have had seats of several diameters.
    #[test]
    fn what_is_no_size_or_several_is_none() {
        for text in ["", "28", "622", "26 x 1 3/8", "28x1.5", "x", "700x", "ax28", "28-", "-622", "28-6220", "5-622"] {
            assert_eq!(diameter(text), None, "{text}");
        }
    }
}
