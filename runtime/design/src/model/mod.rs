//! The models that ship with Carvallo, without their types: whatever its number of coordinates, any of them can be chosen
//! by its name.

mod derivation;
mod equations;
mod sensitive;
mod shipped;
mod written;

pub(crate) use self::derivation::{Derivation, NOT_BUILT, sensitive};
pub use self::derivation::{MachineVisitor, Visitor};
pub use self::equations::{Equations, Shape};
pub use self::sensitive::Sensitive;
pub use self::shipped::{MODELS, Shipped, WHIPPLE};
