//! Which model the parameters are of: one that ships, or the matrices themselves.

use crate::model::Shipped;

/// What a model can be.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    Shipped(&'static Shipped),
    /// That of given matrices.
    Matrices,
}

impl Kind {
    pub fn called(name: &str) -> Result<Self, String> {
        if crate::matrices::is_called(name) { Ok(Self::Matrices) } else { Shipped::called(name).map(Self::Shipped) }
    }

    pub fn is_called(self, name: &str) -> bool {
        match self {
            Self::Shipped(model) => model.is_called(name),
            Self::Matrices => crate::matrices::is_called(name),
        }
    }

    pub fn name(self) -> &'static str {
        self.shipped().map_or(crate::matrices::NAME, |model| model.info.name)
    }

    pub fn shipped(self) -> Option<&'static Shipped> {
        match self {
            Self::Shipped(model) => Some(model),
            Self::Matrices => None,
        }
    }
}
