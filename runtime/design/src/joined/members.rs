//! What the names and values of a body say.

use carvallo::{Domain, ParameterInfo};

use super::body::{Body, Frame, Number, Shape};
use super::read::outside;
use crate::design::Given;
use crate::failure::{Place, Problem};
use crate::input::{Named, Node, Value};
use crate::nearest::nearest;

const NAMES: [&str; 17] = [
    "name", "to", "mass", "at", "x", "y", "z", "Ixx", "Iyy", "Izz", "Ixz", "box", "cylinder", "axis", "sphere", "tilt",
    "sides",
];

/// What people call some of them.
const MEANT: [(&str, &str); 6] =
    [("weight", "mass"), ("position", "at"), ("place", "at"), ("location", "at"), ("frame", "to"), ("on", "to")];

const MASS: ParameterInfo = ParameterInfo::new("mass", "kg", Domain::NONNEGATIVE);
const AT: [ParameterInfo; 3] = [length("x"), length("y"), length("z")];
const MOMENTS: [ParameterInfo; 4] = [
    ParameterInfo::new("Ixx", "kg*m^2", Domain::NONNEGATIVE),
    ParameterInfo::new("Iyy", "kg*m^2", Domain::NONNEGATIVE),
    ParameterInfo::new("Izz", "kg*m^2", Domain::NONNEGATIVE),
    ParameterInfo::new("Ixz", "kg*m^2", Domain::FINITE),
];
const SIDES: [ParameterInfo; 3] = [size("length of the box"), size("width of the box"), size("height of the box")];
const ROUND: [ParameterInfo; 2] = [size("radius of the cylinder"), size("length of the cylinder")];
const RADIUS: ParameterInfo = size("sphere");
const TILT: ParameterInfo = ParameterInfo::new("tilt", "rad", Domain::FINITE);

const fn length(name: &'static str) -> ParameterInfo {
    ParameterInfo::new(name, "m", Domain::FINITE)
}

const fn size(name: &'static str) -> ParameterInfo {
    ParameterInfo::new(name, "m", Domain::NONNEGATIVE)
}

/// What is read of a body, and what is wrong with it.
struct Reader {
    place: Place,
    members: Vec<Named>,
    problems: Vec<Problem>,
}

/// Judges the names and values of a body, which is told of at a place.
///
/// # Errors
/// Everything that is wrong.
pub fn of_members(members: Vec<Named>, place: Place) -> Result<Body, Vec<Problem>> {
    let mut reader = Reader { place, members: Vec::new(), problems: Vec::new() };
    let mut frame_of_names = None;
    for mut member in members {
        let (name, letter) = generic(&member.name);
        if matches!(member.name.as_str(), "kind" | "source") {
            continue;
        }
        if !NAMES.contains(&name.as_str()) {
            let meant = MEANT.iter().find(|(other, _)| *other == name).map(|(_, meant)| *meant);
            let hint = meant.or_else(|| nearest(&name, NAMES)).map(|name| format!("; did you mean `{name}`?"));
            let message = format!("a body has no `{}`{}", member.name, hint.unwrap_or_default());
            reader.problem(member.node.place, message);
            continue;
        }
        frame_of_names = frame_of_names.or(letter);
        if let Some(first) = reader.members.iter().find(|other| other.name == name) {
            let message = format!("`{}` is given twice; first at {}", member.name, first.node.place);
            reader.problem(member.node.place, message);
            continue;
        }
        member.name = name;
        reader.members.push(member);
    }
    reader.body(frame_of_names)
}

/// The name without the letter of a body, as files of a rider have it: `mass` of `mB`, `Ixx` of `IBxx`.
fn generic(name: &str) -> (String, Option<char>) {
    let short: String = name.chars().filter(|&c| c != '_').collect();
    let letters: Vec<char> = short.chars().collect();
    match letters[..] {
        ['m'] => ("mass".to_owned(), None),
        ['m', letter] if letter.is_uppercase() => ("mass".to_owned(), Some(letter)),
        [axis @ ('x' | 'y' | 'z'), letter] if letter.is_uppercase() => (axis.to_string(), Some(letter)),
        ['I', letter, a, b] if letter.is_uppercase() => (format!("I{a}{b}"), Some(letter)),
        _ => (name.to_owned(), None),
    }
}

impl Reader {
    fn body(mut self, letter: Option<char>) -> Result<Body, Vec<Problem>> {
        let name = self.text("name");
        let frame = self.frame(letter);
        let mass = self.required(&MASS, "a body needs its `mass`");
        let at = self.at();
        let shape = self.shape();
        let tilt = self.number(&TILT).unwrap_or_default();
        let sides = self.text("sides");
        let on_both_sides = sides.as_deref() == Some("both");
        if let Some(other) = sides.filter(|_| !on_both_sides) {
            self.say(format!("`sides` is `{other}`; expected `both`, for one on each side"));
        }
        match (at[1][0] != 0.0, on_both_sides) {
            (true, false) => self.say(format!(
                "`y` is {} m, beside the plane of symmetry, which the model is without: with `sides = \"both\"` there is \
                 another one on the other side",
                at[1][0]
            )),
            (false, true) => self.say("`sides` is `both`, but `y` is 0; it must say how far aside they are".to_owned()),
            _ => {}
        }
        let Self { place, mut problems, .. } = self;
        if problems.is_empty() {
            return Ok(Body { name, place, frame, mass, at, shape, tilt, on_both_sides });
        }
        problems.sort_by(|a, b| a.place.cmp(&b.place));
        Err(problems)
    }

    fn frame(&mut self, letter: Option<char>) -> Frame {
        let Some(to) = self.text("to") else { return Frame(letter.unwrap_or('B').to_string()) };
        let words = to.to_lowercase();
        Frame(match words.trim_end_matches(" frame") {
            "rear" => "B".to_owned(),
            "front" => "H".to_owned(),
            "rear wheel" => "R".to_owned(),
            "front wheel" => "F".to_owned(),
            _ => to,
        })
    }

    fn at(&mut self) -> [Number; 3] {
        if let Some(numbers) = self.list("at", &AT, "at = (0.3, 0, -0.9)") {
            for name in ["x", "y", "z"] {
                if let Some(Named { node, .. }) = self.take(name) {
                    self.problem(node.place, format!("`{name}` is given twice; also by `at`"));
                }
            }
            return numbers;
        }
        let [x, y, z] = &AT;
        let expected = "a body needs its place, such as `at = (0.3, 0, -0.9)` for x, y and z";
        let at = [self.number(x), self.number(y), self.number(z)];
        if self.problems.is_empty() && (at[0].is_none() || at[2].is_none()) {
            self.say(expected.to_owned());
        }
        at.map(Option::unwrap_or_default)
    }

    fn shape(&mut self) -> Shape {
        let moments = MOMENTS.each_ref().map(|info| self.number(info));
        let of_box = self.list("box", &SIDES, "box = (0.4, 0.2, 0.1)").map(Shape::Box);
        let round = self.list("cylinder", &ROUND, "cylinder = (0.04, 0.3)");
        let axis = self.text("axis");
        let sphere = self.number(&RADIUS).map(Shape::Sphere);
        let found = axis.as_deref().and_then(|axis| ["x", "y", "z"].into_iter().position(|known| known == axis));
        if let (Some(_), None) = (round, found) {
            let given = axis.as_ref().map_or("missing".to_owned(), |axis| format!("`{axis}`"));
            self.say(format!("the `axis` of the cylinder is {given}; it must be `x`, `y` or `z`, before it is tilted"));
        } else if let (None, Some(axis)) = (round, axis) {
            self.say(format!("`axis` is `{axis}`, but there is no `cylinder`"));
        }
        let cylinder = round.map(|size| Shape::Cylinder(size, found.unwrap_or(0)));
        let is_given = moments.iter().any(Option::is_some);
        let given = is_given.then(|| Shape::Given(moments.map(Option::unwrap_or_default)));
        let mut shapes = [given, of_box, cylinder, sphere].into_iter().flatten();
        let shape = shapes.next();
        if shapes.next().is_some() {
            self.say("its moments of inertia are given in two ways; there is one of `Ixx` and so on, `box`, `cylinder` and `sphere`".to_owned());
        }
        if let (true, [Some(xx), Some(yy), Some(zz), _]) = (self.problems.is_empty(), moments) {
            let [xx, yy, zz] = [xx[0], yy[0], zz[0]];
            // Rounded digits may miss it by a little.
            if xx + zz < 0.95 * yy || xx + yy < 0.95 * zz || yy + zz < 0.95 * xx {
                self.say(format!(
                    "`Ixx`, `Iyy` and `Izz` are {xx}, {yy} and {zz} kg m²: of no body is one more than the others together"
                ));
            }
        }
        // Without any, all of its mass is at one place.
        shape.unwrap_or(Shape::Given(Default::default()))
    }

    /// A list of numbers, if there is one of this name.
    fn list<const N: usize>(&mut self, name: &str, infos: &[ParameterInfo; N], example: &str) -> Option<[Number; N]> {
        let Named { node: Node { place, value }, .. } = self.take(name)?;
        let nodes = match value {
            Value::List(nodes) => nodes,
            // `at = "(0.3, 0, -0.9)"`, as formats have it that know no lists.
            Value::Text(text) => {
                let inner = text.trim().trim_start_matches(['(', '[']).trim_end_matches([')', ']']);
                let node = |text: &str| Node { place: place.clone(), value: Value::Text(text.to_owned()) };
                outside(inner).into_iter().map(node).collect()
            }
            _ => Vec::new(),
        };
        if nodes.len() != N {
            self.problem(place, format!("`{name}` has {} numbers; it must have {N}, such as `{example}`", nodes.len()));
            return Some([[0.0; 2]; N]);
        }
        let mut numbers = [[0.0; 2]; N];
        for ((number, node), info) in numbers.iter_mut().zip(nodes).zip(infos) {
            *number = self.judge(Named { name: info.name.to_owned(), node }, info);
        }
        Some(numbers)
    }

    fn required(&mut self, info: &ParameterInfo, message: &str) -> Number {
        self.number(info).unwrap_or_else(|| {
            self.say(message.to_owned());
            Number::default()
        })
    }

    fn number(&mut self, info: &ParameterInfo) -> Option<Number> {
        let member = self.take(info.name)?;
        Some(self.judge(member, info))
    }

    fn judge(&mut self, member: Named, info: &ParameterInfo) -> Number {
        match member.judge(info) {
            Ok(Given { value, deviation, .. }) => [value, deviation.map_or(0.0, |deviation| deviation.value)],
            Err(problems) => {
                self.problems.extend(problems);
                Number::default()
            }
        }
    }

    fn text(&mut self, name: &str) -> Option<String> {
        let Named { node: Node { place, value }, .. } = self.take(name)?;
        match value {
            Value::Text(text) => Some(text.trim().to_owned()),
            _ => {
                self.problem(place, format!("`{name}` is no text"));
                None
            }
        }
    }

    fn take(&mut self, name: &str) -> Option<Named> {
        let at = self.members.iter().position(|member| member.name == name)?;
        Some(self.members.remove(at))
    }

    /// Of the body as a whole.
    fn say(&mut self, message: String) {
        self.problem(self.place.clone(), message);
    }

    fn problem(&mut self, place: Place, message: String) {
        self.problems.push(Problem { place, message });
    }
}
