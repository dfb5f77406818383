//! Messages in the words of Python.

use carvallo_design::in_words;

/// What the command line calls things, and Python.
const WORDS: &[(&str, &str)] = &[
    ("the speeds come from --speeds", "speeds are arguments of methods"),
    ("`v` is the speed: without --along everything is along it", "`v` is the speed: everything else is along it"),
    ("--speeds", "`v`"),
    ("--speed", "`v`"),
    ("--eigenvalues takes", "`eigenvalues` takes"),
    ("--gravity says", "`replace` says"),
    ("but --model is ", "but the model is "),
    ("`--model ", "`carvallo."),
    ("--model ", "the model "),
    ("--initial ", "`initial`, "),
    ("--force ", "`forces`, "),
    ("--set ", "`replace`, "),
    ("such as --vary w=0.9:1.2", "such as {\"w\": (0.9, 1.2)} for `vary`"),
    ("which `carvallo sweep --vary` goes along", "which arrays in `replace` go along"),
    ("`carvallo show --model ", "`carvallo."),
    ("`carvallo show benchmark", "`carvallo.Whipple"),
    ("` prints a file to start from", "().to_text()` is a file to start from"),
    ("`carvallo measure --example` prints", "`carvallo.example(\"measure\")` is"),
    ("--vary ", "`vary`, "),
    ("--keep ", "`keep`, "),
    ("--along ", "`along`, "),
    ("--weight ", "`weights`, "),
    ("--inputs ", "`inputs`, "),
    ("--outputs ", "`outputs`, "),
    ("--step=", "`size`, "),
    ("--impulse=", "`size`, "),
    ("--units ", "the units "),
    ("(--linear)", "(`linear=True`)"),
    ("`carvallo bicycles` lists the bicycles", "`carvallo.Whipple.sets` has the bicycles"),
    ("`carvallo models` lists the parameter sets", "`sets` of a model has its parameter sets"),
];

pub fn in_python(message: &str) -> String {
    in_words(message, WORDS)
}
