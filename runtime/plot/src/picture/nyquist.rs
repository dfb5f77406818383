//! Frequency responses in the complex plane, to scale.

use carvallo::Complex;

use super::axes::{self, Axes, INK};
use super::bode::{color, notes, paint};
use super::curves::quantile;
use super::graph::{range, write_names};
use super::marks::arc;
use super::scene::{Anchor, Color, Paint, Scene, dashed, line};
use crate::analysis::transfer::{Transfer, Transfers};

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 28.0;
const TOP: f32 = 48.0;
const HEIGHT: f32 = 620.0;
const BELOW: f32 = 66.0;
const TEXT_SIZE: f32 = 13.0;
/// What is larger than so many times what most of the response is, as close to a pole, is beyond the picture.
const LARGE: f64 = 3.0;
/// What is nowhere larger is shown whole, with -1 well apart from zero.
const ALL: f64 = 10.0;
/// What is nowhere larger is shown without -1, beside which it would vanish.
const SMALL: f64 = 0.3;
const GREY: Color = Color(0x88, 0x8e, 0x96);
/// Of negative frequencies.
const MIRRORED: Paint = dashed(1.6, [7.0, 5.0]);

/// The responses of all transfer functions, with those at negative frequencies, the unit circle and -1.
pub fn draw_nyquist(transfers: &Transfers) -> Scene {
    let title = super::transfer_title("Nyquist plot", transfers);
    let mut scene = Scene::new(title.clone(), WIDTH, 0.0);
    let left = axes::margin((-9.99, 9.99));
    scene.heading(((left + RIGHT) / 2.0, 28.0), INK, &title);
    let names: Vec<String> = transfers.channels.iter().map(Transfer::title).collect();
    let count = transfers.channels.len();
    let named = names.iter().enumerate().map(|(index, name)| (paint(index), color(index, count), name.as_str()));
    let named = named.chain([(MIRRORED, GREY, "at negative frequencies")]);
    let top = write_names(named, [left, RIGHT], TOP, &mut scene);
    let area = [left, top, RIGHT, top + HEIGHT];
    let axes = scaled(transfers, area);
    axes.draw_grid(&mut scene);
    let circle: Vec<Complex<f64>> = arc((0.0, 0.0), 1.0, 0.0, std::f32::consts::TAU)
        .into_iter()
        .map(|(x, y)| Complex::new(x.into(), y.into()))
        .collect();
    draw(&circle, &axes, dashed(1.2, [3.0, 4.0]), GREY, &mut scene);
    for (index, channel) in transfers.channels.iter().enumerate() {
        let values = values(channel);
        let mirrored: Vec<Complex<f64>> = values.iter().map(Complex::conj).collect();
        draw(&mirrored, &axes, MIRRORED, color(index, count).lighter(0.35), &mut scene);
        draw(&values, &axes, paint(index), color(index, count), &mut scene);
        draw_head(&values, &axes, color(index, count), &mut scene);
    }
    if is_inside(&Complex::new(-1.0, 0.0), &axes) {
        let (x, y) = axes.place(-1.0, 0.0);
        scene.polyline(&[(x - 5.0, y - 5.0), (x + 5.0, y + 5.0)], line(2.0), INK);
        scene.polyline(&[(x - 5.0, y + 5.0), (x + 5.0, y - 5.0)], line(2.0), INK);
    }
    axes.draw_frame(&mut scene, Some("real part"), "imaginary part");
    scene.height = area[3] + BELOW;
    if let [channel] = &transfers.channels[..] {
        for note in notes(channel) {
            scene.text((area[0], scene.height - 2.0), Anchor::Start, TEXT_SIZE, INK, &note);
            scene.height += 20.0;
        }
    }
    scene
}

/// The response, from frequency zero on where that is hardly another value than the first.
fn values(channel: &Transfer) -> Vec<Complex<f64>> {
    let values: Vec<Complex<f64>> = channel.response.iter().map(|point| point.value()).collect();
    let at_rest = channel.function.static_gain().map(Complex::from);
    let is_near = |rest: &Complex<f64>| values.first().is_some_and(|first| (first - rest).norm() < 0.1 * rest.norm());
    at_rest.filter(is_near).into_iter().chain(values.iter().copied()).collect()
}

/// Axes on which both parts are as long, around what most of the responses are, and -1 unless that is far off.
fn scaled(transfers: &Transfers, area: [f32; 4]) -> Axes {
    let sizes = |channel: &Transfer| {
        let sizes: Vec<f64> = channel.response.iter().map(|point| point.gain).filter(|gain| gain.is_finite()).collect();
        quantile(sizes, 6).unwrap_or(1.0)
    };
    let all = transfers.channels.iter().flat_map(|channel| &channel.response).map(|point| point.gain);
    let largest = all.filter(|gain| gain.is_finite()).fold(0.0, f64::max);
    let is_small = largest < SMALL;
    let usual = LARGE * transfers.channels.iter().map(sizes).fold(if is_small { SMALL } else { 0.4 }, f64::max);
    // Behind an integral a response has no end that could be shown.
    let is_bounded = transfers.channels.iter().all(|channel| channel.function.static_gain().is_some());
    let limit = if is_bounded && largest <= ALL { usual.max(largest) } else { usual };
    let values = transfers.channels.iter().flat_map(|channel| &channel.response);
    let values = values.filter(|point| point.gain <= limit).map(|point| point.value());
    let (real, imaginary): (Vec<f64>, Vec<f64>) = values.map(|value| (value.re, value.im.abs())).unzip();
    let (around, least) = if is_small { ([0.0, 0.0], f64::MIN_POSITIVE) } else { ([-1.2, 0.2], 0.6) };
    let (low, high) = range(real.into_iter().chain(around));
    let (_, most) = range(imaginary.into_iter().chain([least]));
    let [width, height] = [area[2] - area[0], area[3] - area[1]].map(f64::from);
    let per_pixel = (1.1 * (high - low) / width).max(2.2 * most / height);
    let about = |middle: f64, pixels: f64| (middle - per_pixel * pixels / 2.0, middle + per_pixel * pixels / 2.0);
    Axes::even(about((low + high) / 2.0, width), about(0.0, height), area)
}

/// As much of a curve as the axes show.
fn draw(values: &[Complex<f64>], axes: &Axes, paint: Paint, color: Color, scene: &mut Scene) {
    for piece in values.split(|value| !is_inside(value, axes)) {
        let points: Vec<(f32, f32)> = piece.iter().map(|value| axes.place(value.re, value.im)).collect();
        if points.len() > 1 {
            scene.polyline(&points, paint, color);
        }
    }
}

fn is_inside(value: &Complex<f64>, axes: &Axes) -> bool {
    (axes.x.0..=axes.x.1).contains(&value.re) && (axes.y.0..=axes.y.1).contains(&value.im)
}

/// An arrow in the direction of growing frequency, at half of the length that is shown.
fn draw_head(values: &[Complex<f64>], axes: &Axes, color: Color, scene: &mut Scene) {
    let pieces = values.split(|value| !is_inside(value, axes)).flat_map(|piece| piece.windows(2));
    let steps: Vec<[(f32, f32); 2]> =
        pieces.map(|pair| [pair[0], pair[1]].map(|value| axes.place(value.re, value.im))).collect();
    let lengths: Vec<f32> = steps.iter().map(|[from, to]| (to.0 - from.0).hypot(to.1 - from.1)).collect();
    let half = lengths.iter().sum::<f32>() / 2.0;
    let mut passed = 0.0;
    for ([from, to], length) in steps.iter().zip(&lengths) {
        passed += length;
        if passed >= half && *length > 0.0 {
            let (dx, dy) = ((to.0 - from.0) / length, (to.1 - from.1) / length);
            let (x, y) = *to;
            let back = |side: f32| (x - 12.0 * dx - side * 5.0 * dy, y - 12.0 * dy + side * 5.0 * dx);
            scene.polyline(&[(x, y), back(1.0), back(-1.0)], Paint::Fill, color);
            return;
        }
    }
}
