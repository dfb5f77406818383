//! The rider as ten bodies: legs and arms are cylinders, the torso is a box, and the head a sphere.

use std::f64::consts::PI;

use carvallo::Uncertain;
use carvallo_design::joined::Inertia;
use carvallo_design::{Failure, Place};

use super::measures::Measures;

/// The shares of the mass, of both sides together, by Dempster (1955) as Moore et al. (2009) have them.
const LOWER_LEGS: f64 = 0.122;
const UPPER_LEGS: f64 = 0.2;
const TORSO: f64 = 0.51;
const HEAD: f64 = 0.068;
const UPPER_ARMS: f64 = 0.056;
const LOWER_ARMS: f64 = 0.044;

/// x and z in m.
type Point<'a> = [Uncertain<'a>; 2];

/// All of the rider as one.
///
/// # Errors
/// If legs or arms do not reach, or there is no such torso.
pub fn body<'a>(measures: &Measures<'a>) -> Result<Inertia<'a>, Failure> {
    let Measures { lean, lengths, places: [pedals, saddle, hands], .. } = *measures;
    let [lower_leg, upper_leg, torso, upper_arm, lower_arm, hips, shoulders, head, chest, ..] = lengths;
    let [.., lower_leg_girth, upper_leg_girth, upper_arm_girth, lower_arm_girth] = lengths;
    let radius = |girth: Uncertain<'a>| girth / (2.0 * PI);
    let along = |length: Uncertain<'a>| [lean.cos() * length, -(lean.sin() * length)];
    let shoulder = add(saddle, along(torso));
    // Knees are in front of the line from the foot to the hip, elbows behind that from the hand to the shoulder.
    let legs = (pedals, "pedals", saddle, "saddle");
    let knee = joint(measures, legs, [lower_leg, upper_leg], ["lower_leg", "upper_leg"], 1.0)?;
    let arms = (hands, "hands", shoulder, "shoulders");
    let elbow = joint(measures, arms, [lower_arm, upper_arm], ["lower_arm", "upper_arm"], -1.0)?;

    let width = shoulders - upper_arm_girth / PI;
    // Of a chest whose section is a stadium.
    let thickness = (chest - width * 2.0) / (PI - 2.0);
    if width.value() <= 0.0 || thickness.value() <= 0.0 {
        let (width, thickness) = (width.value(), thickness.value());
        return Err(say(
            measures,
            format!(
                "`shoulders`, `upper_arm_girth` and `chest_girth` make a torso {width:.3} m wide and {thickness:.3} m thick; \
             both must be > 0"
            ),
        ));
    }
    let limbs = |share: f64, ends: [Point<'a>; 2], girth, apart: Uncertain<'a>| {
        let (one, angle, length) = segment(measures, share / 2.0, ends);
        one.of_cylinder([radius(girth), length], 2).turned(angle).on_both_sides(apart / 2.0)
    };
    let (trunk, angle, length) = segment(measures, TORSO, [saddle, shoulder]);
    let trunk = trunk.of_box([thickness, width, length]).turned(angle);
    let head_radius = radius(head);
    let at = add(shoulder, along(head_radius));
    let head = Inertia::point(measures.sources, measures.mass * HEAD, at).of_sphere(head_radius);
    let parts = [
        limbs(LOWER_LEGS, [pedals, knee], lower_leg_girth, hips),
        limbs(UPPER_LEGS, [saddle, knee], upper_leg_girth, hips),
        limbs(UPPER_ARMS, [shoulder, elbow], upper_arm_girth, shoulders),
        limbs(LOWER_ARMS, [hands, elbow], lower_arm_girth, shoulders),
        head,
    ];
    Ok(parts.into_iter().fold(trunk, Inertia::with))
}

/// A share of the mass, halfway between two points; with the angle about y that turns the vertical into their line, and
/// their distance.
fn segment<'a>(
    measures: &Measures<'a>,
    share: f64,
    [from, to]: [Point<'a>; 2],
) -> (Inertia<'a>, Uncertain<'a>, Uncertain<'a>) {
    let [dx, dz] = [to[0] - from[0], to[1] - from[1]];
    let middle = [from[0] + dx / 2.0, from[1] + dz / 2.0];
    let point = Inertia::point(measures.sources, measures.mass * share, middle);
    (point, dx.atan2(dz), (dx.squared() + dz.squared()).sqrt())
}

/// Where two limbs meet that begin at two points, to the front of their line (1) or behind it (-1).
fn joint<'a>(
    measures: &Measures<'a>,
    (from, from_name, to, to_name): (Point<'a>, &str, Point<'a>, &str),
    [first, second]: [Uncertain<'a>; 2],
    [first_name, second_name]: [&str; 2],
    side: f64,
) -> Result<Point<'a>, Failure> {
    let [dx, dz] = [to[0] - from[0], to[1] - from[1]];
    let square = dx.squared() + dz.squared();
    let distance = square.sqrt();
    let along = (first.squared() - second.squared() + square) / (distance * 2.0);
    let across = first.squared() - along.squared();
    if !(distance.value() > 0.0 && across.value() >= 0.0) {
        let [apart, first, second] = [distance, first, second].map(Uncertain::value);
        return Err(say(
            measures,
            format!(
                "{from_name} and {to_name} are {apart:.3} m apart, where `{first_name}` and `{second_name}`, {first} m and \
             {second} m, do not reach; they must be between {:.3} m and {:.3} m apart",
                (first - second).abs(),
                first + second
            ),
        ));
    }
    let across = across.sqrt() * side;
    // Forward of the way up, which is along -z.
    Ok([from[0] + (along * dx - across * dz) / distance, from[1] + (along * dz + across * dx) / distance])
}

fn add<'a>(a: Point<'a>, b: Point<'a>) -> Point<'a> {
    [a[0] + b[0], a[1] + b[1]]
}

fn say(measures: &Measures, message: String) -> Failure {
    Failure::at(Place::File(measures.label.clone()), message)
}
