//! Frequency responses: gain above phase, against the frequency by decades.

use carvallo_design::number::fixed;

use super::axes::{self, INK, Scale};
use super::curves::Curve;
use super::graph::{Graph, Line, range, roomy};
use super::motion::COLORS;
use super::scene::{Anchor, Color, Paint, Scene, dashed, line};
use crate::analysis::transfer::{Transfer, Transfers};

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 28.0;
const TOP: f32 = 56.0;
const HEIGHT: f32 = 300.0;
const FLAT: f32 = 240.0;
const TEXT_SIZE: f32 = 13.0;
/// The most decibels that are shown below the largest gain.
const DEEPEST: f64 = 160.0;

/// The responses of all transfer functions, in one colour each.
pub fn draw_bode(transfers: &Transfers) -> Scene {
    let x = range(transfers.channels.iter().flat_map(|channel| &channel.response).map(|point| point.frequency.log10()));
    let lines = |value: &dyn Fn(&Transfer) -> Curve, is_named: bool| -> Vec<Line> {
        let channels = transfers.channels.iter().enumerate();
        let line = |(index, channel): (usize, &Transfer)| Line {
            name: is_named.then(|| channel.title()),
            color: color(index, transfers.channels.len()),
            paint: paint(index),
            curve: value(channel),
        };
        channels.map(line).collect()
    };
    let gains = lines(&|channel| curve(channel, &|point| point.decibels()), true);
    let phases = lines(&|channel| curve(channel, &|point| point.phase.to_degrees()), false);
    let extent = |lines: &[Line]| range(lines.iter().flat_map(|line| &line.curve).map(|point| point.1));
    let (low, high) = extent(&gains);
    let gain = Graph {
        title: "gain (dB)".into(),
        height: HEIGHT,
        x,
        y: roomy((low.max(high - DEEPEST), high)),
        scales: [Scale::Decades, Scale::Even],
        lines: gains,
        note: None,
    };
    let phase = Graph {
        title: "phase (°)".into(),
        height: FLAT,
        x,
        y: around(extent(&phases)),
        scales: [Scale::Decades, Scale::Turns],
        lines: phases,
        note: None,
    };
    let title = super::transfer_title("Frequency response", transfers);
    let left = axes::margin(gain.y).max(axes::margin((-1000.0, 1000.0)));
    let mut scene = Scene::new(title.clone(), WIDTH, 0.0);
    scene.heading(((left + RIGHT) / 2.0, 32.0), INK, &title);
    let below = gain.draw(None, [left, RIGHT], TOP, &mut scene);
    let mut below = phase.draw(Some("frequency ω (rad/s)"), [left, RIGHT], below - 18.0, &mut scene);
    if let [channel] = &transfers.channels[..] {
        for note in notes(channel) {
            scene.text((left, below - 2.0), Anchor::Start, TEXT_SIZE, INK, &note);
            below += 20.0;
        }
    }
    scene.height = below;
    scene
}

/// The colour of one of several transfer functions.
pub fn color(index: usize, count: usize) -> Color {
    if count == 1 { COLORS[0] } else { COLORS[index % COLORS.len()] }
}

/// The line of one of several transfer functions: solid, and dashed in other ways where colours begin anew.
pub fn paint(index: usize) -> Paint {
    const DASHES: [[f32; 2]; 5] = [[9.0, 4.0], [3.0, 3.0], [16.0, 4.0], [6.0, 8.0], [2.0, 6.0]];
    match index / COLORS.len() {
        0 => line(2.2),
        round => dashed(2.2, DASHES[(round - 1) % DASHES.len()]),
    }
}

/// The margins of a transfer function, in words.
pub fn notes(channel: &Transfer) -> Vec<String> {
    let gain = channel.margins.nearest_gain().map(|margin| {
        let decibels = 20.0 * margin.factor.log10();
        format!("gain margin {decibels:.2} dB at {} rad/s", fixed(margin.frequency, 3))
    });
    let phase = channel.margins.nearest_phase().map(|margin| {
        format!("phase margin {:.2}° at {} rad/s", margin.angle.to_degrees(), fixed(margin.frequency, 3))
    });
    gain.into_iter().chain(phase).map(|note| note.replace('-', "−")).collect()
}

fn curve(channel: &Transfer, value: &dyn Fn(&carvallo_control::FrequencyResponse) -> f64) -> Curve {
    let points = channel.response.iter().map(|point| (point.frequency.log10(), value(point)));
    points.filter(|point| point.1.is_finite()).collect()
}

/// At least a right angle, with some room.
fn around((low, high): (f64, f64)) -> (f64, f64) {
    let missing = ((90.0 - (high - low)) / 2.0).max(0.0);
    let room = 8.0 + 0.04 * (high - low);
    (low - missing - room, high + missing + room)
}
