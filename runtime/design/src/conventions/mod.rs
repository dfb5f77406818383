//! Parameters of bicycles as other programs and papers have them: by other names, in other axes, of other bodies. Each
//! convention is a file here; a file of parameters is recognised by its names, and read into those of the paper.
//!
//! ```
//! use carvallo_design::conventions::{Convention, convert};
//! use carvallo_design::input;
//!
//! let request = input::Request { parameters: Some("benchmark".to_owned()), ..Default::default() };
//! let moore = convert(&input::load(&request)?, Convention::called("moore")?)?;
//! let d1 = &moore.parameters[2];
//! assert_eq!((d1.name.name, (1e4 * d1.given.value).round()), ("d1", 9535.0));
//! # Ok::<(), carvallo_design::Failure>(())
//! ```

mod arrays;
mod beside;
mod carried;
mod contradictions;
mod convert;
mod express;
mod geometry;
mod gyrostats;
mod held;
mod jbike6;
mod libbicycle;
mod moore;
mod moved;
mod name;
mod naming;
mod once;
mod principal;
mod printed;
mod pydy;
mod quantity;
mod read;
mod recognise;
mod source;
mod steered;
mod tensor;
#[cfg(test)]
mod tests;
mod twice;
mod unknown;
mod varied;
mod wheels;
mod write;

pub use self::convert::{Converted, Parameter, convert};
pub use self::name::{Name, Need};
pub use self::naming::{Naming, Varying, folded, spelled, unfold};
pub use self::quantity::Quantity;
pub use self::read::Reading;
pub(crate) use self::read::read;
pub(crate) use self::unknown::{hint, settable};
pub use self::varied::Varied;
pub use self::write::{Form, left_out, write};

use self::dual::Dual;
use self::name::Values;
use crate::dual;
use crate::failure::{Failure, Problem};
use crate::input::Entry;

/// How others call and measure the parameters of a bicycle.
pub struct Convention {
    /// What it is called on the command line, and in a file after `parameterization`.
    pub name: &'static str,
    /// What else it is called.
    others: &'static [&'static str],
    /// What it is, in a few words.
    pub title: &'static str,
    /// Its parameters, and what files carry along with them.
    pub names: &'static [Name],
    /// Beside the required ones: of each, names of which one must be there, or several together.
    alternatives: &'static [Alternatives],
    /// Brings entries into a form in which each is a number.
    prepare: fn(&mut Vec<Entry>, &mut Vec<Problem>),
    /// The parameters of the paper, from values of all that are required.
    to_paper: fn(&Values) -> Result<Values, String>,
    /// From all parameters of the paper; the names are among those that are required or optional.
    from_paper: fn(&Values) -> Result<Values, String>,
    /// What else can be told by its names, from the parameters of the paper and from those of its own that are given: what stands
    /// in the place of others.
    complete: fn(&Values, &Values) -> Values,
}

/// Names that stand in each other's place: each by itself, or with those that it needs beside it.
type Alternatives = &'static [&'static [&'static str]];

/// Of conventions that say everything in one way.
fn nothing(_: &Values, _: &Values) -> Values {
    Values::default()
}

/// The parameters of the paper by Meijaard, Papadopoulos, Ruina and Schwab (2007), which all commands compute with.
pub const PAPER: &Convention = &Convention {
    name: "paper",
    others: &["benchmark", "Meijaard2007"],
    title: "the names of the paper (2007)",
    names: &[],
    alternatives: &[],
    prepare: |_, _| {},
    to_paper: |values| Ok(values.clone()),
    from_paper: |values| Ok(values.clone()),
    complete: nothing,
};

/// All others.
const OTHERS: [&Convention; 7] = [
    &moore::MOORE,
    &pydy::PYDY,
    &principal::PRINCIPAL,
    &gyrostats::GYROSTATS,
    &libbicycle::LIBBICYCLE,
    &jbike6::JBIKE6,
    &geometry::GEOMETRY,
];

/// What a file of two gyrostats need not have, and what four bodies cannot be told from them without.
pub const SPLIT: [&str; 4] = gyrostats::SPLIT;

impl Convention {
    /// The names of all, that of the paper first.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        std::iter::once(PAPER).chain(OTHERS)
    }

    /// The one that is called so.
    ///
    /// # Errors
    /// If there is none: that, and those that there are.
    pub fn called(name: &str) -> Result<&'static Self, Failure> {
        Self::find(name).ok_or_else(|| Failure::usage(Self::unknown(name)))
    }

    fn find(name: &str) -> Option<&'static Self> {
        let is_it = |own: &&str| own.eq_ignore_ascii_case(name);
        Self::all().find(|convention| is_it(&convention.name) || convention.others.iter().any(is_it))
    }

    /// That there is none called so.
    fn unknown(name: &str) -> String {
        let names: Vec<&str> = Self::all().map(|convention| convention.name).collect();
        let hint = crate::nearest::nearest(name, names.iter().copied());
        let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
        format!("there is no parameterization `{name}`; there are {}{hint}", names.join(", "))
    }

    /// Whether it has two gyrostats, which do not tell how much of them the wheels are.
    fn is_of_gyrostats(&self) -> bool {
        SPLIT.iter().all(|name| self.known(name).is_some_and(|known| known.need == Need::Optional))
    }

    /// Whether it is that of the paper.
    pub fn is_paper(&self) -> bool {
        self.name == PAPER.name
    }

    /// What a name of a file means here.
    fn known(&self, name: &str) -> Option<&'static Name> {
        // Those who have such names have others once they are prepared.
        if crate::input::is_of_part(name) {
            return None;
        }
        let own = crate::input::without_owner(name);
        // What is called exactly so comes first.
        let exact = self.names.iter().find(|known| known.name == own);
        exact.or_else(|| self.names.iter().find(|known| known.is_called(own)))
    }

    /// The parameter that a name of a file means here.
    fn parameter(&self, name: &str) -> Option<&'static Name> {
        self.known(name).filter(|known| known.is_parameter())
    }

    /// What stands under a name, from the parameters of the paper and what else is given in its own names; `None` where they do not
    /// tell it.
    fn tell(&self, name: &str, paper: &Values, given: &Values) -> Option<Dual> {
        let mut others = Values::default();
        given.iter().filter(|(own, _)| *own != name).for_each(|(own, value)| others.push(own, value));
        let expressed = (self.from_paper)(paper).ok()?;
        expressed.get(name).or_else(|| (self.complete)(paper, &others).get(name))
    }

    /// Names of which one must be there, each by itself or with those that do in its place.
    fn needed(&self) -> Vec<Vec<&'static str>> {
        let required = self.names.iter().filter(|name| name.need == Need::Required);
        let first = |group: &Alternatives| group.iter().filter_map(|names| names.first().copied()).collect();
        required.map(|name| vec![name.name]).chain(self.alternatives.iter().map(first)).collect()
    }
}

impl PartialEq for Convention {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl std::fmt::Debug for Convention {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}
