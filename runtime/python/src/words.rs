//! Messages in the words of Python.

use carvallo_design::in_words;

/// What the command line calls things, and Python.
const WORDS: [(&str, &str); 16] = [
    ("the speeds come from --speeds", "speeds are arguments of methods"),
    ("--speeds", "`v`"),
    ("--speed", "`v`"),
    ("--eigenvalues takes", "`eigenvalues` takes"),
    ("--gravity says", "`replace` says"),
    ("`--model ", "`carvallo."),
    ("--model ", "the model "),
    ("--initial ", "`initial`, "),
    ("--force ", "`forces`, "),
    ("--set ", "`replace`, "),
    ("--vary ", "`vary`, "),
    ("--keep ", "`keep`, "),
    ("--units ", "the units "),
    ("(--linear)", "(`linear=True`)"),
    ("`carvallo bicycles` lists the bicycles", "`carvallo.Whipple.sets` has the bicycles"),
    ("`carvallo models` lists the parameter sets", "`sets` of a model has its parameter sets"),
];

pub fn in_python(message: &str) -> String {
    in_words(message, &WORDS)
}
