//! What the web page of Carvallo asks for: a question comes as JSON, and is answered by JSON and by an array of numbers.
//!
//! [`exports`] is all that WebAssembly sees; [`answer`] has every question and what answers it. Nothing is kept from one
//! question to the next, so that a page can ask in any order.

pub mod answer;
mod catalogue;
mod eigenvalues;
pub mod exports;
mod files;
mod motion;
mod question;
mod subject;

pub use self::answer::Answer;
