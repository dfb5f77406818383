//! A small picture of the real parts of the eigenvalues in characters, for terminals.

use anstyle::{AnsiColor, Style};
use carvallo::Mode;
use carvallo_design::Failure;
use carvallo_design::number::shortest;
use carvallo_plot::analysis::{Analysis, ModeRow, Rows};

use super::{FAINT, GOOD};

/// Characters; a braille character has two dots across and four upright.
const COLUMNS: usize = 66;
const LINES: usize = 15;
const DOTS: usize = 4 * LINES;

/// A character of the picture: its dots, and the mode that they belong to.
#[derive(Clone, Copy, Default)]
struct Cell {
    dots: u8,
    mode: Option<Mode>,
}

/// Nothing for a model without names of modes.
///
/// # Errors
/// If the eigenvalues cannot be computed at some speed.
pub fn draw_sketch(analysis: &Analysis, high: f64) -> Result<String, Failure> {
    let speeds: Vec<f64> = (0..2 * COLUMNS).map(|dot| high * dot as f64 / (2 * COLUMNS - 1) as f64).collect();
    let Rows::Modes(rows) = analysis.rows(&speeds)? else { return Ok(String::new()) };
    let extent = carvallo_plot::picture::extent(rows.iter().flat_map(|row| row.values.iter().map(|mode| mode.value)));
    let cells = cells(&rows, extent);

    let mut text = format!("{FAINT}real parts (1/s) against v (m/s):{FAINT:#}");
    for mode in [Mode::Castering, Mode::Capsize, Mode::Weave] {
        let style = style(mode);
        text.push_str(&format!("  {style}⠒ {mode}{style:#}"));
    }
    text.push('\n');
    for (index, line) in cells.iter().enumerate() {
        let label = match index {
            0 => shortest(extent),
            index if index == LINES / 2 => "0".to_owned(),
            index if index == LINES - 1 => format!("-{}", shortest(extent)),
            _ => String::new(),
        };
        text.push_str(&format!("{label:>6} {FAINT}│{FAINT:#}"));
        for cell in line {
            match cell.mode {
                Some(mode) => {
                    let (style, char) = (style(mode), char::from_u32(0x2800 + u32::from(cell.dots)).unwrap_or(' '));
                    text.push_str(&format!("{style}{char}{style:#}"));
                }
                None if index == LINES / 2 => text.push_str(&format!("{FAINT}─{FAINT:#}")),
                None => text.push(' '),
            }
        }
        text.push('\n');
    }
    text.push_str(&format!("       {FAINT}└{FAINT:#}"));
    for speed in speeds.iter().step_by(2) {
        let (style, char) = if analysis.is_stable(*speed) { (GOOD, '━') } else { (FAINT, '─') };
        text.push_str(&format!("{style}{char}{style:#}"));
    }
    text.push_str(&format!("\n        0{:>width$}   {GOOD}━ stable{GOOD:#}\n", high, width = COLUMNS - 1));
    Ok(text)
}

fn style(mode: Mode) -> Style {
    match mode {
        Mode::Castering => AnsiColor::Blue.on_default(),
        Mode::Capsize | Mode::Divergence => AnsiColor::Yellow.on_default(),
        Mode::Weave | Mode::Flutter => AnsiColor::Red.on_default(),
        Mode::Wobble => AnsiColor::Cyan.on_default(),
        Mode::Real | Mode::Oscillatory => FAINT,
    }
}

fn cells(rows: &[ModeRow], extent: f64) -> Vec<Vec<Cell>> {
    let mut cells = vec![vec![Cell::default(); COLUMNS]; LINES];
    // The height in dots from the top.
    let dot = |value: f64| ((extent - value) / (2.0 * extent) * (DOTS - 1) as f64).round();
    for index in 0..4 {
        let mut before = None;
        for (column, row) in rows.iter().enumerate() {
            let height = dot(row.values[index].value.re);
            // Steep lines are filled up from the height of the column before.
            let (from, to) = match before {
                Some(before) if before < height => (before + 1.0, height),
                Some(before) if before > height => (height, before - 1.0),
                _ => (height, height),
            };
            before = Some(height);
            for line in (0..DOTS).filter(|&line| (from..=to).contains(&(line as f64))) {
                let cell = &mut cells[line / 4][column / 2];
                cell.dots |= braille(column % 2, line % 4);
                cell.mode = Some(row.values[index].mode);
            }
        }
    }
    cells
}

/// The bit of a dot within its character.
fn braille(column: usize, line: usize) -> u8 {
    [[0x01, 0x02, 0x04, 0x40], [0x08, 0x10, 0x20, 0x80]][column][line]
}
