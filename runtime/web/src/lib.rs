//! What the web page of Carvallo asks for: a question comes as JSON, and is answered by JSON and by an array of numbers.
//!
//! [`exports`] is all that WebAssembly sees; [`answer`] has every question and what answers it. A page can ask in any
//! order: what is kept from one question to the next only saves time.

pub mod answer;
mod catalogue;
mod eigenvalues;
pub mod exports;
mod files;
mod kept;
mod motion;
mod question;
mod subject;

pub use self::answer::Answer;
