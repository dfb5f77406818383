//! Designs: the models that ship with Carvallo, by name, and their parameters from files in any of the formats that
//! people have, or by the names of what ships.
//!
//! ```
//! use carvallo_design::input;
//!
//! let design = input::read("mine.toml", b"model = \"Pendulum\"\n[parameters]\nl = \"50 cm\"\n".to_vec());
//! println!("{}", design.unwrap_err()); // names everything that is missing
//! let pista = input::load(&input::Request { parameters: Some("pista".to_owned()), ..Default::default() }).unwrap();
//! println!("{}: {:?}", pista.title(), pista.equations.stability(9.81).unwrap().stable_ranges);
//! ```

mod bodies;
mod capacity;
#[cfg(feature = "full")]
pub mod conventions;
mod design;
mod display;
mod dual;
mod failure;
pub mod feedback;
pub mod file;
pub mod input;
#[cfg(feature = "full")]
pub mod joined;
pub mod matrices;
mod model;
mod motion_names;
mod nearest;
pub mod number;
pub mod parameter;
mod path;
pub mod quantity;
pub mod speeds;
#[cfg(feature = "full")]
pub mod units;
mod words;

pub use self::bodies::body;
pub use self::capacity::{Capacity, of_kind};
pub use self::design::{Design, Deviation, Given, WithoutMachine};
pub use self::display::DisplayUnit;
pub use self::dual::Dual;
pub use self::failure::{Failure, Place, Problem};
pub use self::model::{Equations, MODELS, MachineVisitor, Sensitive, Shape, Shipped, Visitor, WHIPPLE};
pub use self::motion_names::{is_called, of_rate};
pub use self::nearest::nearest;
pub use self::path::Path;
pub use self::words::in_words;
