carvallo::model! {
    pub model Pendulum {
        parameters {
            r#type: kg, > 0;
        }
        coordinates {
            theta: rad;
        }
        M = [[r#type]];
    }
}

fn main() {}
