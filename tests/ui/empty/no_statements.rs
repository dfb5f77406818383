carvallo::model! {
    model Pendulum {}
}

fn main() {}
