carvallo::model! {}

fn main() {}
