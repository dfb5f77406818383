//! Which changes of sign count.

/// Which changes of the sign of a function of a motion are told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Crossing {
    /// All of them.
    #[default]
    Any,
    /// Those from below zero to above.
    Rising,
    /// Those from above zero to below.
    Falling,
}

impl Crossing {
    /// Whether there is one between two values, of which the latter may be zero. What begins at zero has changed before.
    #[must_use]
    pub fn is_between(self, before: f64, after: f64) -> bool {
        let (rises, falls) = (before < 0.0 && after >= 0.0, before > 0.0 && after <= 0.0);
        match self {
            Self::Any => rises || falls,
            Self::Rising => rises,
            Self::Falling => falls,
        }
    }
}

/// The time between two at which a function changes its sign, to rounding: the latter of two neighbours.
///
/// # Errors
/// Those of the function.
pub fn change_of_sign<E>(
    (mut from, before): (f64, f64),
    mut to: f64,
    value: impl Fn(f64) -> Result<f64, E>,
) -> Result<f64, E> {
    // As often as a double can be halved.
    for _ in 0..100 {
        let middle = from + 0.5 * (to - from);
        if middle <= from || middle >= to {
            break;
        }
        if value(middle)? * before > 0.0 {
            from = middle;
        } else {
            to = middle;
        }
    }
    Ok(to)
}
