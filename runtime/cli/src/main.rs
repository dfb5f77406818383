use carvallo::Model;
fn main(){ println!("{}", carvallo_models::Whipple::BENCHMARK.coefficients().m); }
