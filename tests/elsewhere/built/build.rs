//! What a user writes.

fn main() -> Result<(), carvallo_build::Error> {
    carvallo_build::compile("models/*.rs")
}
