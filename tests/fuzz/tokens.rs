//! Changes to declarations, token by token, so that most of what comes out is one that could have been written.

use std::fmt::Write as _;

use proc_macro2::{Delimiter, Group, Spacing, TokenStream, TokenTree};

/// The words of the language, and some that are none.
const DICTIONARY: &[&str] = &[
    "pub",
    "model",
    "source",
    "parameters",
    "let",
    "require",
    "coordinates",
    "mechanism",
    "body",
    "wheel",
    "revolute",
    "prismatic",
    "load",
    "cornering",
    "ball",
    "planar",
    "slides",
    "turns",
    "fix",
    "free",
    "force",
    "ground",
    "to",
    "on",
    "mass",
    "massless",
    "at",
    "inertia",
    "radius",
    "tyre",
    "axial",
    "radial",
    "through",
    "along",
    "spring",
    "damper",
    "lateral",
    "vertical",
    "yaw",
    "lean",
    "pitch",
    "B",
    "R",
    "set",
    "gravity",
    "compare",
    "compare by_hand: f64;",
    "feedback",
    "feedback T on a = -b*rate(a);",
    "rate",
    "add",
    "add C0 = [[a]];",
    "add symmetric Kc = [[a, 0], [0, a]];",
    "unused",
    "in",
    "M",
    "C0",
    "C1",
    "Kc",
    "K0",
    "K2",
    "sin",
    "cos",
    "tan",
    "sqrt",
    "atan",
    "asin",
    "acos",
    "pi",
    "kg",
    "m",
    "rad",
    "N",
    "s",
    "deg",
    "kg*m^2",
    "N/kg",
    "N*m/rad",
    "1/m",
    "m^-1",
    "s^65",
    "a",
    "b",
    "l",
    "theta",
    "phi",
    "_",
    "λ",
    "r#let",
    "self",
    "Self",
    "crate",
    "fn",
    "T",
    "f64",
    "x0",
    "p0",
    "e",
    "I",
    "i",
    "v",
    "Model",
    "INFO",
    "matrices",
    "0",
    "1",
    "2",
    "3",
    "0.5",
    "1.",
    "2e-3",
    "1e300",
    "1e-300",
    "1e400",
    "1e999999999999",
    "0x10",
    "1u8",
    "1_000",
    "64",
    "65",
    "100000000000000000000",
    "9007199254740993",
    "\"text\"",
    "\"λ\"",
    "\"\"",
    "'c'",
    "'life",
    "b\"bytes\"",
    "r\"raw\"",
    "+",
    "-",
    "*",
    "/",
    "^",
    "**",
    "=",
    "==",
    "<",
    ">",
    "<=",
    ">=",
    ";",
    ":",
    "::",
    ",",
    ".",
    "..",
    "&&",
    "|",
    "!",
    "?",
    "#",
    "$",
    "@",
    "->",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "()",
    "[]",
    "{}",
    "-(",
    "sqrt(",
    "tan(",
    "sin(",
    "^2",
    "^-1",
    "^(1/2)",
    "/0",
    "*0",
    "> 0",
    ">= 0",
    "in (-pi/2, pi/2)",
    "in [0, 1]",
    "[[1]]",
    "[[1, 0], [0, 1]]",
    "/// docs\n",
    "#[doc(hidden)]",
    "#![allow()]",
    "invisible(",
    "let a =",
    "require a > 0;",
    "g: N/kg, gravity;",
    "x: m, > 0;",
    "x: m, unused;",
    "set soft {",
    "coordinates { q: rad; }",
    "coordinates { q: m; }",
    "mechanism { }",
    "body B: massless;",
    "body B: mass m, at (0, 0, l), inertia 0;",
    "wheel R on B: mass m, at (0, 0, -l), radius l, axial 0, radial 0;",
    "revolute q: ground to B, through (0, 0, 0), along (1, 0, 0);",
    "prismatic q: ground to B, along (0, 1, 0);",
    "fix B to R;",
    "free B: lean phi, yaw theta;",
    "force T on q;",
    "(0, 0, 0)",
    "(1, 0, 0)",
    "(0, 1, 1)",
    "[a, b, a]",
    "[[a, 0, b], [0, a, 0], [b, 0, a]]",
    "source \"text\";",
];

/// What stands in the braces of `model! { … }`, or everything. Parentheses after the word `invisible` become those
/// that a macro puts around what it passes on.
pub fn declaration(tokens: TokenStream) -> TokenStream {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let called = trees.windows(3).find_map(|three| match three {
        [TokenTree::Ident(name), TokenTree::Punct(bang), TokenTree::Group(group)]
            if name == "model" && bang.as_char() == '!' =>
        {
            Some(group.stream())
        }
        _ => None,
    });
    called.unwrap_or_else(|| with_invisible(trees.into_iter().collect()))
}

fn with_invisible(tokens: TokenStream) -> TokenStream {
    let mut trees: Vec<TokenTree> = Vec::new();
    for tree in tokens {
        let TokenTree::Group(group) = tree else {
            trees.push(tree);
            continue;
        };
        let hidden = trees.pop_if(|last| matches!(last, TokenTree::Ident(word) if word == "invisible")).is_some();
        let delimiter = if hidden { Delimiter::None } else { group.delimiter() };
        let mut changed = Group::new(delimiter, with_invisible(group.stream()));
        changed.set_span(group.span());
        trees.push(changed.into());
    }
    trees.into_iter().collect()
}

/// Some changes to a declaration; nothing if it does not come apart into tokens, or every so often.
pub fn mutate(data: &[u8], seed: u32) -> Option<String> {
    let mut random = Random(u64::from(seed));
    if random.below(16) == 0 {
        return None;
    }
    let words = words(data)?;
    let mut attempt = || {
        let mut words = words.clone();
        for _ in 0..=random.below(4) {
            change(&mut words, &mut random);
        }
        lexed(words)
    };
    (0..8).find_map(|_| attempt())
}

/// One declaration with a stretch of another.
pub fn cross(one: &[u8], other: &[u8], seed: u32) -> Option<String> {
    let mut random = Random(u64::from(seed));
    let (words, others) = (words(one)?, words(other)?);
    (0..8).find_map(|_| {
        let mut words = words.clone();
        let (from, to) = (random.stretch(words.len()), random.stretch(others.len()));
        words.splice(from, others[to].iter().cloned());
        lexed(words)
    })
}

fn change(words: &mut Vec<String>, random: &mut Random) {
    let count = words.len();
    let from = random.stretch(count);
    let here = from.start;
    let word = DICTIONARY[random.below(DICTIONARY.len())].to_owned();
    let names: Vec<usize> = (0..count).filter(|&at| words[at].starts_with(char::is_alphanumeric)).collect();
    match random.below(9) {
        0 => drop(words.drain(from)),
        1 => words.insert(here, word),
        2 if here < count => words[here] = word,
        3 => {
            let copied = words[from].to_vec();
            let at = random.below(count + 1);
            words.splice(at..at, copied);
        }
        4 if here < count => words.swap(here, random.below(count)),
        5 => {
            words.insert(from.end, ")".into());
            words.insert(here, ["(", "sqrt(", "cos(", "-(", "1/(", "invisible("][random.below(6)].into());
        }
        // A name or a number for another one: the likeliest change to leave a declaration whole.
        _ if !names.is_empty() => {
            let [one, other] = [(); 2].map(|()| names[random.below(names.len())]);
            words[one] = if random.below(4) == 0 { word } else { words[other].clone() };
        }
        _ => words.push(word),
    }
}

/// The tokens of a text, brackets among them.
fn words(data: &[u8]) -> Option<Vec<String>> {
    proc_macro2::extra::invalidate_current_thread_spans();
    let mut words = Vec::new();
    flatten(declaration(std::str::from_utf8(data).ok()?.parse().ok()?), &mut words);
    Some(words)
}

fn flatten(tokens: TokenStream, words: &mut Vec<String>) {
    let mut joint = false;
    for tree in tokens {
        let next = match &tree {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::None => ("invisible(", ")"),
                };
                words.push(open.into());
                flatten(group.stream(), words);
                words.push(close.into());
                false
            }
            TokenTree::Punct(punct) => {
                match words.last_mut().filter(|_| joint) {
                    Some(last) => last.push(punct.as_char()),
                    None => words.push(punct.as_char().into()),
                }
                punct.spacing() == Spacing::Joint
            }
            other => {
                // A lifetime is a quotation mark and a name.
                match words.last_mut().filter(|_| joint) {
                    Some(last) => _ = write!(last, "{other}"),
                    None => words.push(other.to_string()),
                }
                false
            }
        };
        joint = next;
    }
}

/// The text of the tokens, if they come apart again.
fn lexed(words: Vec<String>) -> Option<String> {
    let text = words.join(" ");
    text.parse::<TokenStream>().is_ok().then_some(text)
}

/// SplitMix64.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) % end.max(1) as u64) as usize
    }

    /// A stretch of a list, mostly a short one.
    fn stretch(&mut self, count: usize) -> std::ops::Range<usize> {
        let start = self.below(count + 1);
        let longest = [1, 4, 16, count][self.below(4)].min(count - start);
        start..start + self.below(longest + 1)
    }
}
