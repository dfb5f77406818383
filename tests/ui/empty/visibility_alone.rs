carvallo::model! {
    pub
}

fn main() {}
