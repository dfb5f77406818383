//! What is measured of a rider, and of where a bicycle has him.

use carvallo::{Bound, Domain, ParameterInfo, Sources, Uncertain};
use carvallo_design::input::{Named, Node, Raw, Value};
use carvallo_design::number::{shortest, with_unit};
use carvallo_design::{Failure, Given, Place, Problem, nearest};

use crate::table::{in_degrees, in_radians};

/// Lengths of the rider in m, in the order of [`Measures::lengths`].
const LENGTHS: [ParameterInfo; 13] = [
    length("lower_leg"),
    length("upper_leg"),
    length("torso"),
    length("upper_arm"),
    length("lower_arm"),
    length("hips"),
    length("shoulders"),
    length("head_girth"),
    length("chest_girth"),
    length("lower_leg_girth"),
    length("upper_leg_girth"),
    length("upper_arm_girth"),
    length("lower_arm_girth"),
];
/// Places of the bicycle, in the order of [`Measures::places`].
const PLACES: [&str; 3] = ["pedals", "saddle", "hands"];

/// No rider has a length, and no bicycle a place, of more than this in m, and nobody a larger mass in kg.
const FARTHEST: f64 = 3.0;
const HEAVIEST: f64 = 500.0;
/// More slips of one unit are told as one.
const SEPARATE: usize = 2;

const MASS: ParameterInfo = ParameterInfo::new("mass", "kg", Domain::POSITIVE);
const LEAN: ParameterInfo =
    ParameterInfo::new("lean", "rad", Domain::between(Bound::Open(0.0), Bound::Open(std::f64::consts::PI)));
const X: ParameterInfo = ParameterInfo::new("x", "m", Domain::FINITE);
const Z: ParameterInfo = ParameterInfo::new("z", "m", Domain::FINITE);

const fn length(name: &'static str) -> ParameterInfo {
    ParameterInfo::new(name, "m", Domain::POSITIVE)
}

/// All measures.
pub struct Measures<'a> {
    pub sources: &'a Sources,
    pub label: String,
    pub name: String,
    /// In kg.
    pub mass: Uncertain<'a>,
    /// From the ground, forwards, to the line from the saddle to the shoulders, in rad.
    pub lean: Uncertain<'a>,
    /// In m: lower and upper leg, torso, upper and lower arm, between the hips, between the shoulders; around the head, the
    /// chest, the lower and upper leg, and the upper and lower arm.
    pub lengths: [Uncertain<'a>; 13],
    /// Of the pedals, the saddle and the hands: x and z in m, in the axes of the bicycle.
    pub places: [[Uncertain<'a>; 2]; 3],
}

impl<'a> Measures<'a> {
    /// # Errors
    /// Everything that is wrong with names and values, and what is missing.
    pub fn read(Raw { label, members }: Raw, sources: &'a Sources) -> Result<Self, Failure> {
        let mut reader = Reader { sources, members, missing: Vec::new(), problems: Vec::new(), too_long: Vec::new() };
        let name = match reader.take("name").map(|member| member.node.value) {
            Some(Value::Text(text)) => text,
            _ => "rider".to_owned(),
        };
        let mass = reader.number(&MASS);
        let lean = reader.number(&LEAN);
        let lengths = LENGTHS.each_ref().map(|info| reader.number(info));
        let places = PLACES.map(|name| reader.place(name));
        let Reader { members, missing, mut problems, too_long, .. } = reader;
        problems.extend(in_another_unit(too_long));
        let known = || ["mass", "lean"].into_iter().chain(LENGTHS.iter().map(|info| info.name)).chain(PLACES);
        for Named { name, node } in members.into_iter().filter(|member| !matches!(&member.name[..], "kind" | "source"))
        {
            let hint = nearest(&name, known()).map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
            problems.push(Problem { place: node.place, message: format!("`{name}` is no measure of a rider{hint}") });
        }
        if !missing.is_empty() {
            let message = format!("missing: {}", missing.join(", "));
            problems.push(Problem { place: Place::File(label.clone()), message });
        }
        if problems.is_empty() {
            return Ok(Self { sources, label, name, mass, lean, lengths, places });
        }
        problems.sort_by(|a, b| a.place.cmp(&b.place));
        Err(Failure::Input(problems))
    }
}

/// What is left to be read.
struct Reader<'a> {
    sources: &'a Sources,
    members: Vec<Named>,
    missing: Vec<&'static str>,
    problems: Vec<Problem>,
    /// Lengths that nobody has, most likely for being in another unit.
    too_long: Vec<Length>,
}

/// A length that was measured.
struct Length {
    name: String,
    place: Place,
    value: f64,
}

impl<'a> Reader<'a> {
    fn take(&mut self, name: &str) -> Option<Named> {
        let at = self.members.iter().position(|member| member.name == name)?;
        Some(self.members.remove(at))
    }

    /// What is missing or wrong is told at the end; until then one number is as good as any.
    fn number(&mut self, info: &ParameterInfo) -> Uncertain<'a> {
        let Some(member) = self.take(info.name) else {
            self.missing.push(info.name);
            return self.sources.exact(1.0);
        };
        self.judge(member, info)
    }

    fn judge(&mut self, Named { name, node: Node { place, value } }: Named, info: &ParameterInfo) -> Uncertain<'a> {
        if info.unit == "rad"
            && let Some(message) = in_radians(&name, &value)
        {
            self.problems.push(Problem { place: place.clone(), message });
        }
        let value = if info.unit == "rad" { in_degrees(value) } else { value };
        let (called, found_at) = (name.clone(), place.clone());
        match (Named { name, node: Node { place, value } }).judge(info) {
            Ok(Given { value, deviation, .. }) => {
                if info.unit == "m" && value.abs() > FARTHEST {
                    self.too_long.push(Length { name: called, place: found_at, value });
                } else if let Some(message) = doubt(&called, value, info) {
                    self.problems.push(Problem { place: found_at, message });
                }
                self.sources.measured(value, deviation.map_or(0.0, |deviation| deviation.value))
            }
            Err(found) => {
                self.problems.extend(found);
                self.sources.exact(1.0)
            }
        }
    }

    fn place(&mut self, name: &'static str) -> [Uncertain<'a>; 2] {
        let nowhere = [self.sources.exact(1.0); 2];
        let Some(Named { node: Node { place, value }, .. }) = self.take(name) else {
            self.missing.push(name);
            return nowhere;
        };
        let node = |text: &str| Node { place: place.clone(), value: Value::Text(text.trim().to_owned()) };
        let nodes = match value {
            Value::List(nodes) => nodes,
            Value::Text(text) => text.trim_matches(['(', ')', '[', ']']).split(',').map(node).collect(),
            _ => Vec::new(),
        };
        let Ok([x, z]) = <[Node; 2]>::try_from(nodes) else {
            let message = format!("`{name}` is no place; expected x and z in m, such as `{name} = [0.46, -0.3]`");
            self.problems.push(Problem { place, message });
            return nowhere;
        };
        [(x, &X), (z, &Z)]
            .map(|(node, info)| self.judge(Named { name: format!("{} of {name}", info.name), node }, info))
    }
}

/// What is said of lengths that are too long: of each, or of many at once.
fn in_another_unit(lengths: Vec<Length>) -> Vec<Problem> {
    let longest = lengths.iter().map(|length| length.value.abs()).fold(0.0, f64::max);
    let (unit, count) = (if longest > 100.0 * FARTHEST { "mm" } else { "cm" }, lengths.len());
    let told = |Length { name, place, value }: Length| {
        let (shown, number) = (with_unit(value, "m"), shortest(value));
        let one = format!("`{name}` is {shown}; it must be at most {FARTHEST} m");
        let message = match count > SEPARATE {
            true => format!(
                "{one}, and so must {} more numbers: if they are in {unit}, write the unit behind each, as in \"{number} {unit}\"",
                count - 1
            ),
            false => format!("{one}: if it is in {unit}, write \"{number} {unit}\""),
        };
        Problem { place, message }
    };
    lengths.into_iter().map(told).take(if count > SEPARATE { 1 } else { count }).collect()
}

/// What no rider on a bicycle has, most likely for being in another unit or counted the other way.
fn doubt(name: &str, value: f64, info: &ParameterInfo) -> Option<String> {
    let shown = with_unit(value, info.unit);
    match info.unit {
        "kg" if value > HEAVIEST => Some(format!("`{name}` is {shown}; it must be at most {HEAVIEST} kg; is it in g?")),
        "m" if info.name == "z" && value > 0.0 => Some(format!(
            "`{name}` is {shown}, below the ground; z is counted down, so that what is above it is negative"
        )),
        _ => None,
    }
}
