//! Declarations, right and wrong: compiling one neither panics nor hangs, no message shows what goes on inside, and
//! what comes out is Rust.
//!
//! Inputs are text; those that hold `model! { … }` stand for what is in its braces, so that the cases of the tests
//! serve as a start. In this folder, with libFuzzer's options at the end:
//!
//! ```sh
//! mkdir -p ../../target/fuzz/corpus/declaration
//! RUSTC_BOOTSTRAP=1 cargo run --bin declaration -- ../../target/fuzz/corpus/declaration ../../generated/models \
//!     ../ui ../tests/pass -timeout=60 -max_len=8192 -max_total_time=3600 -print_final_stats=1
//! ```

#![no_main]

mod inside;
mod tokens;

use carvallo_compiler::{Driver, expand};
use libfuzzer_sys::{fuzz_crossover, fuzz_mutator, fuzz_target};

fuzz_target!(|data: &[u8]| {
    // Spans are kept for the whole thread: without this, so is every input.
    proc_macro2::extra::invalidate_current_thread_spans();
    let Ok(text) = std::str::from_utf8(data) else { return };
    // What does not come apart into tokens never reaches a macro.
    let Ok(tokens) = text.parse() else { return };
    match expand(tokens::declaration(tokens), &Driver::Macro { runtime: "::carvallo".parse().expect("a path") }) {
        Ok(code) => assert!(syn::parse2::<syn::File>(code.clone()).is_ok(), "what came out is not Rust: {code}"),
        Err(errors) => errors.into_iter().for_each(|error| inside::look_for(&error.to_string(), text)),
    }
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match tokens::mutate(&data[..size], seed).filter(|text| text.len() <= max_size) {
        Some(text) => {
            data[..text.len()].copy_from_slice(text.as_bytes());
            text.len()
        }
        None => libfuzzer_sys::fuzzer_mutate(data, size, max_size),
    }
});

fuzz_crossover!(|one: &[u8], other: &[u8], out: &mut [u8], seed: u32| {
    let text = tokens::cross(one, other, seed).filter(|text| text.len() <= out.len());
    text.map_or(0, |text| {
        out[..text.len()].copy_from_slice(text.as_bytes());
        text.len()
    })
});
