//! Parameter files of the command line, in every format: reading one neither panics nor hangs, and gives either
//! parameters that the model can have or a message.
//!
//! Every input is read as each format. In this folder, with libFuzzer's options at the end:
//!
//! ```sh
//! mkdir -p ../../target/fuzz/corpus/parameters ../../target/fuzz/seeds
//! for file in ../../generated/bicycles/*.toml; do
//!     seed=../../target/fuzz/seeds/$(basename "$file")
//!     cargo run --quiet --manifest-path ../../Cargo.toml -- analyze "$file" --speeds 0:1:1 --format json > "$seed.json"
//!     sed 's/ = /: /; /^\[/d' "$file" > "$seed.yml"
//!     sed '/^\[/d; s/"\(pi.*\)"/\1/' "$file" > "$seed.txt"
//! done
//! RUSTC_BOOTSTRAP=1 cargo run --bin parameters -- ../../target/fuzz/corpus/parameters ../../target/fuzz/seeds \
//!     ../../generated/bicycles -dict=parameters.dict -timeout=10 -max_total_time=3600 -print_final_stats=1
//! ```

#![no_main]

mod inside;

use carvallo_design::Design;
use carvallo_design::input;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    for label in ["a.toml", "a.yml", "a.json", "a.py", "a.m", "a.txt"] {
        match input::read(label, data.to_vec()) {
            Ok(design) => judge(&design),
            Err(failure) => {
                let message = failure.to_string();
                assert!(message.contains(label), "a message that does not say where: {message}");
                inside::look_for(&message, &String::from_utf8_lossy(data));
            }
        }
    }
});

fn judge(design: &Design) {
    let info = design.info();
    assert_eq!(design.parameters.len(), info.parameters.len());
    for (given, info) in design.parameters.iter().zip(info.parameters) {
        let value = given.value;
        assert!(value.is_finite() && info.domain.contains(value), "{} = {value} of {}", info.name, given.written);
    }
    let values = design.values();
    assert!(design.model.equations(&values).is_ok());
    let notes = design.warnings.iter().chain(&design.notes);
    // Between backticks stand names and values as the file has them.
    let mut said = notes.clone().flat_map(|text| text.split('`').step_by(2));
    assert!(said.all(|text| !text.contains("NaN") && !text.contains("inf ")), "{notes:?}");
}
