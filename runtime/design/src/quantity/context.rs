//! What a text is read for.

/// What the text of a value may refer to.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// The unit that the value has, as declared, such as `kg*m^2`; `1` for pure numbers.
    pub unit: &'a str,
    /// The values of names; `None` for one that is not known.
    pub names: &'a Lookup<'a>,
}

/// The value of a name, or what is wrong with it; `None` if it is not known.
pub type Lookup<'a, T = f64> = dyn Fn(&str) -> Option<Result<T, String>> + 'a;

/// For values that refer to nothing.
pub fn no_names(_: &str) -> Option<Result<f64, String>> {
    None
}
