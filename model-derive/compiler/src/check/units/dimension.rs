//! Dimensions: what is left of a unit without its size, and how a quantity mirrors.

use std::fmt;

use crate::syntax::Direction;

/// The dimension of a quantity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dimension {
    /// Exponents of kg, m and s, in parts of [`PARTS`].
    exponents: [i32; 3],
    /// For each axis whether the quantity changes its sign when that axis is mirrored.
    pub odd: [bool; 3],
}

/// Square roots halve exponents: so many parts of one are told apart.
const PARTS: i32 = 64;
const NAMES: [&str; 3] = ["kg", "m", "s"];

impl Dimension {
    /// A pure number, or an angle that no mirror changes.
    pub const NUMBER: Self = Self { exponents: [0; 3], odd: [false; 3] };

    /// The dimension of kg^a m^b s^c.
    pub const fn new([kg, m, s]: [i32; 3]) -> Self {
        Self { exponents: [kg * PARTS, m * PARTS, s * PARTS], odd: [false; 3] }
    }

    /// With a direction: polar vectors change with their own axis, angles, which are axial, with the two others.
    pub fn directed(self, direction: Option<Direction>) -> Self {
        let odd = match direction {
            None => [false; 3],
            Some(Direction::Along(odd)) => odd,
            Some(Direction::About(axis)) => [0, 1, 2].map(|mirrored| mirrored != axis),
        };
        Self { odd, ..self }
    }

    /// Of a product; nothing if its exponents are beyond all use.
    pub fn times(self, other: Self) -> Option<Self> {
        let mut exponents = [0; 3];
        for (axis, exponent) in exponents.iter_mut().enumerate() {
            *exponent = self.exponents[axis].checked_add(other.exponents[axis])?;
        }
        Some(Self { exponents, odd: [0, 1, 2].map(|axis| self.odd[axis] != other.odd[axis]) })
    }

    /// Of a power; nothing if its exponents are beyond all use.
    pub fn power(self, exponent: i32) -> Option<Self> {
        let mut exponents = self.exponents;
        for part in &mut exponents {
            *part = part.checked_mul(exponent)?;
        }
        Some(Self { exponents, odd: self.odd.map(|odd| odd && exponent % 2 != 0) })
    }

    /// Of a square root; nothing if its exponents are beyond all use.
    pub fn root(self) -> Option<Self> {
        let whole = self.exponents.iter().all(|exponent| exponent % 2 == 0);
        whole.then(|| Self { exponents: self.exponents.map(|exponent| exponent / 2), odd: self.odd })
    }

    /// Whether both have the same unit.
    pub fn same_unit(self, other: Self) -> bool {
        self.exponents == other.exponents
    }

    /// Whether it is a pure number or an angle.
    pub fn is_number(self) -> bool {
        self.same_unit(Self::NUMBER)
    }

    /// Whether some mirror changes its sign.
    pub fn is_odd(self) -> bool {
        self.odd.contains(&true)
    }

    /// As the end of a sentence "it is …".
    pub fn place(self) -> String {
        if self.is_number() { "a pure number".into() } else { format!("in {self}") }
    }

    /// As the end of a sentence "it …": what mirrors do to its sign.
    pub fn sign(self) -> String {
        if self.is_odd() {
            format!("changes its sign when {} is mirrored", self.axes().join(" or "))
        } else {
            "keeps its sign in every mirror".into()
        }
    }

    /// The axes whose mirrors change its sign.
    pub fn axes(self) -> Vec<&'static str> {
        ["x", "y", "z"].into_iter().zip(self.odd).filter(|(_, odd)| *odd).map(|(axis, _)| axis).collect()
    }
}

/// In kg, m and s: `kg*m^2/s`; `1` for pure numbers.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = || NAMES.into_iter().zip(self.exponents);
        let above: Vec<String> = parts().filter(|(_, n)| *n > 0).map(|(name, n)| power(name, n)).collect();
        let below: Vec<String> = parts().filter(|(_, n)| *n < 0).map(|(name, n)| power(name, -n)).collect();
        f.write_str(if above.is_empty() { "1" } else { "" })?;
        f.write_str(&above.join("*"))?;
        below.iter().try_for_each(|name| write!(f, "/{name}"))
    }
}

fn power(name: &str, exponent: i32) -> String {
    let (mut above, mut below) = (exponent, PARTS);
    while above % 2 == 0 && below > 1 {
        (above, below) = (above / 2, below / 2);
    }
    match (above, below) {
        (1, 1) => name.to_string(),
        (_, 1) => format!("{name}^{above}"),
        _ => format!("{name}^({above}/{below})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dimensions_read_as_units() {
        let cases = [
            ([0, 0, 0], "1"),
            ([1, 2, 0], "kg*m^2"),
            ([1, 1, -2], "kg*m/s^2"),
            ([0, 0, -1], "1/s"),
            ([0, -1, -1], "1/m/s"),
        ];
        for (exponents, text) in cases {
            assert_eq!(Dimension::new(exponents).to_string(), text);
        }
        assert_eq!(Dimension::new([0, 1, 0]).root().map(|root| root.to_string()).as_deref(), Some("m^(1/2)"));
    }

    #[test]
    fn roots_and_powers_end_where_their_exponents_do() {
        let mut dimension = Dimension::new([1, 0, 0]);
        for _ in 0..6 {
            dimension = dimension.root().expect("64 is 2 to the 6th");
        }
        assert_eq!(dimension.root(), None);
        let powers = (0..6).try_fold(Dimension::new([1, 0, 0]), |dimension, _| dimension.power(64));
        assert_eq!(powers, None);
    }

    #[test]
    fn angles_mirror_in_the_axes_they_do_not_turn_about() {
        // The tilt of the steer axis turns about y; its sine is a quotient of lengths along x and z.
        let tilt = Dimension::NUMBER.directed(Some(Direction::About(1)));
        let [x, z] = [[true, false, false], [false, false, true]]
            .map(|odd| Dimension::NUMBER.directed(Some(Direction::Along(odd))));
        assert_eq!(x.times(z.power(-1).expect("small")), Some(tilt));
        assert_eq!(tilt.power(2), Some(Dimension::NUMBER));
    }
}
